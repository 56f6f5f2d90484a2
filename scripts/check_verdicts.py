"""Whether the verdicts of a study of stability hold in long motions.

Draws rows of output/stability/stability.csv at random and runs the study again with motions of
10,000 steps, at their values alone. The verdicts must be the same, and the step that is seen to be
stable within 2 % of the one that was predicted.
"""
import csv
import random
import subprocess
import sys

number = int(sys.argv[1])
entries = {"poissons_ratio": "Poisson's ratios", "youngs_modulus_Pa": "Young's moduli",
           "size_m": "Sizes", "aspect_ratio": "Aspect ratios", "angle_degrees": "Angles",
           "contrast": "Contrasts", "stretch": "Stretches", "inversion": "Inversions",
           "time_step_s": "Time steps"}
keys = ("fit", "enrichment", "kinematics", "integrator")


def rows_of(folder):
    with open(f"{folder}/stability.csv") as file:
        return list(csv.DictReader(file))


def key(row, axis):
    return (axis, row[axis]) + tuple(row[name] for name in keys)


def axis_of(row):
    given = [axis for axis in entries if row.get(axis)]
    return given[0] if given else None


rows = [row for row in rows_of("output/stability") if axis_of(row)]
chosen = random.Random(1).sample(rows, min(number, len(rows)))
values = {}
for row in chosen:
    values.setdefault(axis_of(row), set()).add(row[axis_of(row)])
command = ["build/springfit", "parameters/stability.prm", "--set",
           "Output directory=output/verdicts", "--set", "Stability/Steps=10000", "--set",
           "Stability/Width=0"]
for axis, entry in entries.items():
    command += ["--set", f"Stability/{entry}=" + ", ".join(sorted(values.get(axis, ())))]
subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
again = {key(row, axis_of(row)): row for row in rows_of("output/verdicts") if axis_of(row)}

bad = 0
worst = 0.
for row in chosen:
    name = key(row, axis_of(row))
    other = again[name]
    if other["verdict"] != row["verdict"]:
        bad += 1
        print("differs:", *name, "-", row["verdict"], "/", other["verdict"], other["reason"])
    if other["observed_step_s"]:
        ratio = float(other["predicted_step_s"]) / float(other["observed_step_s"])
        worst = max(worst, abs(ratio - 1.))
        if abs(ratio - 1.) > 0.02:
            bad += 1
            print("steps differ:", *name, "-", other["predicted_step_s"], "predicted,",
                  other["observed_step_s"], "observed")
print(f"{len(chosen)} verdicts, {bad} wrong; predicted and observed steps are within "
      f"{100 * worst:.2g} %")
sys.exit(bad > 0)
