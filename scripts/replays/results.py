import csv
import math
import pathlib
import subprocess
import sys
import tempfile

# Runs a scene by the library of LAMMPS.
DRIVER = pathlib.Path(__file__).resolve().parents[2] / "examples" / "run_in_lammps.py"


def fail(message):
    sys.exit("Error: " + message)


def run(command, folder):
    """Runs a program in a folder; its output on the screen is returned."""
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        fail(" ".join(map(str, command)) + ":\n" + result.stdout[-3000:] + result.stderr)
    return result.stdout


def springfit(program, scene, folder, entries):
    """Runs a scene with other entries, given as "Section/Entry=value"."""
    command = [pathlib.Path(program).resolve(), pathlib.Path(scene).resolve()]
    for entry in [*entries, "Output directory=results"]:
        command += ["--set", entry]
    run(command, folder)
    return pathlib.Path(folder) / "results"


def scratch_folder():
    return tempfile.TemporaryDirectory(prefix="springfit_replay.")


def read_table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def exported(folder, ending):
    """Pairs of a file and what tables call it: "tension_frobenius"."""
    files = sorted(folder.glob("export_*." + ending))
    if not files:
        fail("nothing was exported")
    return [(path, path.stem[len("export_") :]) for path in files]


def vectors(table, prefix):
    return [[float(row[prefix + axis]) for axis in "xyz"] for row in table]


def distance(ours, theirs):
    """The largest between two displacements, relative to the largest of ours."""
    largest = max(math.hypot(*u) for u in ours)
    if not largest > 0.0:
        fail("nothing moves")
    return max(math.dist(u, v) for u, v in zip(ours, theirs)) / largest


def tell(what, value, limit):
    """Prints how far apart two programs are, and whether that is little."""
    print(f"{what}: {value:.2e} of the largest displacement")
    return value <= limit
