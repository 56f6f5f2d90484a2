"""The deflection of a clamped bar's end over that of Timoshenko's beam, as a table."""

import csv
import pathlib
import subprocess
import sys
import tempfile

LENGTH, THICKNESS, YOUNGS_MODULUS = 0.1, 0.01, 1e4  # m, m, Pa: those of bar.prm
MODELS = {"fem": "finite elements (Q1)",
          "consistent_volume": "springs + volume (`consistent`, k >= 0)",
          "stable_neo_hookean_volume": "`stable neo-hookean`, `volume`",
          "stable_neo_hookean_point_volumes": "`stable neo-hookean`, `point volumes`"}
CELLS_ACROSS = (1, 2, 4)
POISSON = (0.3, 0.49)


def timoshenko(force, nu):
    """F L^3 / (3 E I) + F L / (kappa G A) of a square section, m; kappa after Cowper
    (1966), 10 (1 + nu) / (12 + 11 nu)."""
    area, inertia = THICKNESS**2, THICKNESS**4 / 12
    shear_modulus = YOUNGS_MODULUS / (2 * (1 + nu))
    kappa = 10 * (1 + nu) / (12 + 11 * nu)
    return (force * LENGTH**3 / (3 * YOUNGS_MODULUS * inertia)
            + force * LENGTH / (kappa * shear_modulus * area))


def ratio(folder, model, nu):
    """Work of the end's forces over that of the beam: the mean deflection."""
    with open(folder / f"shear_{model}.csv", newline="") as file:
        rows = [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]
    force = [sum(row[f"force_{d}"] for row in rows) for d in "xyz"]
    size = sum(f * f for f in force)**0.5
    work = sum(row[f"force_{d}"] * row[f"u_{d}"] for row in rows for d in "xyz")
    return work / size / timoshenko(size, nu)


def main(program, scene):
    columns = [(nu, across) for nu in POISSON for across in CELLS_ACROSS]
    found = {}
    for nu, across in columns:
        with tempfile.TemporaryDirectory() as folder:
            for methods, enrichments in (("consistent", "volume"),
                                         ("stable neo-hookean", "volume, point volumes")):
                subprocess.run(
                    [program, scene, "--set", f"Output directory={folder}",
                     "--set", f"Geometry/Cell size={THICKNESS / across:g}",
                     "--set", f"Material/Poisson's ratio={nu}",
                     "--set", f"Fit/Methods={methods}", "--set", f"Fit/Enrichment={enrichments}",
                     "--set", "Fit/Nonnegative=true"], check=True, stdout=subprocess.DEVNULL)
                for model in MODELS:
                    if (pathlib.Path(folder) / f"shear_{model}.csv").exists():
                        found[model, nu, across] = ratio(pathlib.Path(folder), model, nu)
    print("| deflection in % of Timoshenko's |"
          + "|".join(f" nu = {nu}, {across} across " for nu, across in columns) + "|")
    print("|---" * (len(columns) + 1) + "|")
    for model, name in MODELS.items():
        print(f"| {name} |" + "|".join(f" {100 * found[model, *column]:.1f} "
                                       for column in columns) + "|")


if __name__ == "__main__":
    main(*sys.argv[1:])
