"""How well the times of a trade-off study repeat: each scene is run twice.

For each kind of time the share of the models whose two times are within 10 % of each other, and
the largest and the middle ratio. Exit status 1 where fewer than nine in ten are.
"""
import csv
import statistics
import subprocess
import sys
import time

kinds = ("setup_s", "solve_s", "implicit_step_s", "explicit_step_s")


def study(scene, folder):
    began = time.monotonic()
    subprocess.run(["build/springfit", f"parameters/tradeoff/{scene}.prm", "--set",
                    f"Output directory={folder}"], check=True, stdout=subprocess.DEVNULL)
    with open(f"{folder}/tradeoff.csv") as file:
        return time.monotonic() - began, list(csv.DictReader(file))


print("| scene | models | study, s | time | within 10 % | middle | largest |\n"
      "|---|---|---|---|---|---|---|")
bad = 0
for scene in sys.argv[1:]:
    seconds, rows = study(scene, f"output/tradeoff_{scene}")
    _, again = study(scene, f"output/repeat_{scene}")
    for kind in kinds:
        ratios = [max(float(one[kind]), float(two[kind])) / min(float(one[kind]), float(two[kind]))
                  for one, two in zip(rows, again) if one[kind] and two[kind]]
        within = sum(ratio <= 1.1 for ratio in ratios) / len(ratios)
        bad += within < 0.9
        print(f"| {scene} | {len(rows)} | {seconds:.0f} | {kind} | {100 * within:.0f} % | "
              f"{statistics.median(ratios):.3f} | {max(ratios):.2f} |", flush=True)
sys.exit(bad > 0)
