"""How well the times of a trade-off study repeat: each scene is run twice.

Two ways to look at the ratios of the two times of each model: as they are, and relative to
the middle one of them all. Models take turns, so that a slow phase of the machine hits all:
it moves the middle ratio, and leaves what a table says about its models. Set-up happens once in
a run, the others are medians.
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


def percent_within(ratios, middle):
    return 100 * sum(1 / 1.1 <= ratio / middle <= 1.1 for ratio in ratios) / len(ratios)


print("| scene | models | study, s | time | within 10 % | middle ratio | within 10 % of it |\n"
      "|---|---|---|---|---|---|---|")
for scene in sys.argv[1:]:
    seconds, rows = study(scene, f"output/tradeoff_{scene}")
    _, again = study(scene, f"output/repeat_{scene}")
    for kind in kinds:
        ratios = [float(two[kind]) / float(one[kind])
                  for one, two in zip(rows, again) if one[kind] and two[kind]]
        middle = statistics.median(ratios)
        print(f"| {scene} | {len(rows)} | {seconds:.0f} | {kind} | "
              f"{percent_within(ratios, 1):.0f} % | {middle:.3f} | "
              f"{percent_within(ratios, middle):.0f} % |", flush=True)
