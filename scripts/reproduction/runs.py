"""Runs the experiments and reads what they wrote."""
import concurrent.futures
import csv
import pathlib
import shutil
import subprocess
import sys
import time

MACHINE_MAY_RUN = 2  # runs at a time


def read_csv(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def _finished(experiment, folder):
    table = "sweep.csv" if experiment.role == "sweep" else "comparison.csv"
    return (folder / table).exists() and (folder / "complete").exists()


def _run(experiment, program, top, folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    command = [str(program), experiment.scene, "--set", f"Output directory={folder}"]
    for option in experiment.options:
        command += ["--set", option]
    begin = time.time()
    result = subprocess.run(command, cwd=top, capture_output=True, text=True)
    experiment.seconds = time.time() - begin
    if result.returncode == 0:
        (folder / "complete").touch()
        return
    # A run that failed may have written what it had.
    said = [line.strip() for line in (result.stdout + result.stderr).splitlines()
            if "Error" in line]
    experiment.problem = said[0] if said else f"exit status {result.returncode}"


def run_all(experiments, program, top, runs, reuse):
    """Two at a time; an experiment without results gets a 'problem'."""
    def one(experiment):
        folder = runs / experiment.name
        if not (reuse and _finished(experiment, folder)):
            _run(experiment, program, top, folder)
        return experiment

    with concurrent.futures.ThreadPoolExecutor(MACHINE_MAY_RUN) as pool:
        for number, done in enumerate(pool.map(one, experiments), 1):
            outcome = done.problem or (f"{done.seconds:.1f} s" if done.seconds else "kept")
            print(f"[{number}/{len(experiments)}] {done.name}: {outcome}",
                  file=sys.stderr, flush=True)


def _worst_gaps(folder):
    worst = {}
    for row in read_csv(folder / "fit.csv"):
        if row["duality_gap"]:
            worst[row["fit"]] = max(worst.get(row["fit"], 0.), float(row["duality_gap"]))
    return worst


def comparison_rows(experiments, runs):
    """The rows of all comparison.csv, each with what its experiment was."""
    rows = []
    for experiment in experiments:
        folder = pathlib.Path(runs) / experiment.name
        if not (folder / "comparison.csv").exists():
            continue
        gaps = _worst_gaps(folder)
        for row in read_csv(folder / "comparison.csv"):
            row["experiment"] = experiment
            row["gap"] = gaps.get(row["fit"])
            rows.append(row)
    return rows
