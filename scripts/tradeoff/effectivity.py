"""How good the estimates of Study = adapt are: cube and specimen, the mean pull of the loaded side,
on a mesh and its refinements. Linear, so that what the estimate leaves out is nothing but rounding;
and at 10 % deformation of stable neo-Hookean material."""
import csv
import subprocess

scenes = {
    "cube": ["Geometry/Cell size=0.005", "Material/Poisson's ratio=0.45"],
    "specimen": ["Geometry/Cell size=0.005"],
}
laws = {"linear": "0.05", "stable neo-hookean": "0.1"}

print("| object | law | refinements | cycle | estimate, % | true, % | effectivity | cells of the "
      "exact model |\n|---|---|---|---|---|---|---|---|")
for scene, entries in scenes.items():
    for law, deformation in laws.items():
        for refinements in range(3):
            # The nonlinear specimen of 50,000 cells takes long.
            if law != "linear" and refinements == 2:
                continue
            folder = f"output/effectivity_{scene}"
            command = ["build/springfit", f"parameters/{scene}.prm"]
            for entry in entries + [
                    "Study=adapt", f"Output directory={folder}",
                    f"Geometry/Refinements={refinements}",
                    "Fit/Methods=frobenius, consistent, stable neo-hookean",
                    "Fit/Enrichment=none, point volumes, volume", "Fit/Nonnegative=true",
                    f"Response/Material law={law}", "Loads/Cases=tension",
                    f"Loads/Deformation={deformation}",
                    "Adapt/Quantity=displacement of x max: x", "Adapt/Accuracy=1",
                    "Adapt/True error=true", "Adapt/Finite elements=true"]:
                command += ["--set", entry]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            with open(f"{folder}/adapt.csv") as file:
                for row in csv.DictReader(file):
                    print(f"| {scene} | {law} | {refinements} | {row['cycle']} | "
                          f"{float(row['estimated_percent']):.3g} | "
                          f"{float(row['true_percent']):.3g} | {float(row['effectivity']):.3g} | "
                          f"{row['cells_fem']} |", flush=True)
