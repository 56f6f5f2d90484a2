"""What the forces of a network cost, from build/network_benchmark, as tables: members and
bytes per second of each family beside the memory's own speed, and models relative to springs
alone on the same mesh. scripts/benchmark says how to run it."""

import json
import subprocess
import sys

KINDS = ("triangles", "quadrilaterals", "tetrahedra", "hexahedra")
WORK = ("forces", "product")


def measured(program):
    """All runs by name, of each the fastest."""
    result = subprocess.run(
        [program, "--benchmark_format=json", "--benchmark_repetitions=3",
         "--benchmark_min_time=0.1", "--benchmark_filter=triad|families|(forces|product)/.*/quadratic"],
        capture_output=True, text=True, check=True)
    fastest = {}
    for entry in json.loads(result.stdout)["benchmarks"]:
        if entry["run_type"] == "iteration":
            name = entry["run_name"].removesuffix("/min_time:0.500")
            if name not in fastest or entry["cpu_time"] < fastest[name]["cpu_time"]:
                fastest[name] = entry
    return fastest


def families(runs):
    print("| cells | family | with | 10^6 per s | ns each | GB/s |")
    print("|---|---|---|---|---|---|")
    for name, run in runs.items():
        if name.startswith("families/"):
            _, cells, model, _ = name.split("/")
            per_second = run["items_per_second"]
            print(f"| {cells} | {run['label'].replace('_', ' ')} | {model} | "
                  f"{per_second / 1e6:.0f} | {1e9 / per_second:.1f} | "
                  f"{run['bytes_per_second'] / 1e9:.1f} |")
    print(f"| - | STREAM triad | - | - | - | {runs['triad']['bytes_per_second'] / 1e9:.1f} |")


def models(runs):
    print("| cells | model | ns per cell | forces / springs alone | "
          "tangent times vector / forces |")
    print("|---|---|---|---|---|")
    for cells in KINDS:
        alone = runs[f"forces/{cells}/none/quadratic"]["cpu_time"]
        for name, run in runs.items():
            what, *rest = name.split("/")
            if what == "forces" and rest[0] == cells:
                forces = run["cpu_time"]
                product = runs["/".join(["product", *rest])]["cpu_time"]
                model = "springs alone" if rest[1] == "none" else rest[1]
                print(f"| {cells} | {model} | {forces:.1f} | {forces / alone:.2f} | "
                      f"{product / forces:.2f} |")


def main(program):
    runs = measured(program)
    print("Forces of each family on a mesh of at least 10^5 cells, one core:\n")
    families(runs)
    print("\nModels on the same meshes, relative to springs alone:\n")
    models(runs)


if __name__ == "__main__":
    main(*sys.argv[1:])
