"""Runs a case and finds what is wrong with what springfit did."""
import csv
import math
import pathlib
import re
import struct
import tempfile
import zlib
import dataclasses

import readers
import vtu
from scenes import DENSITY, THICKNESS

SECONDS, LINES = 60, 8
KINDS = ("crash", "hang", "status", "trace", "long message", "no message", "not finite",
         "results", "mass", "silent loss", "refused")
TRACES = re.compile(r"terminate called|[Ss]tack ?trace|\bstod\b|\bstoul?\b|bad_alloc|Assert|"
                    r"std::|dealii|Segmentation|basic_string|vector::|map::at")
# Warnings that good files get too.
USUAL = re.compile(r"belong to no |has no physical groups|numbered clockwise|"
                   r"numbered left-handedly|All ids are 0|belong to several|serve as ids")


@dataclasses.dataclass
class Verdict:
    status: int
    seconds: float
    output: str
    faults: list  # kind, what


def _run(server, case, folder):
    """Status, None after a hang; standard output, standard error, seconds."""
    for name, data in case.files.items():
        (folder / name).write_bytes(data)
    status, seconds = server.run(folder, ["x.prm", *case.options], SECONDS)
    texts = [(folder / name).read_bytes().decode(errors="replace")
             for name in ("stdout.txt", "stderr.txt")]
    return status, *texts, seconds


def _numbers_of_vtu(path):
    grid = vtu.read_vtu(path)
    for values in (grid.points, *grid.point_data.values(), *grid.cell_data.values()):
        for value in values:
            yield from value if isinstance(value, tuple) else (value,)


def _check_results(folder):
    faults = []
    for path in sorted(folder.glob("*.csv")):
        with open(path, newline="", errors="replace") as file:
            for row in csv.reader(file):
                for field in row:
                    try:
                        finite = math.isfinite(float(field))
                    except ValueError:
                        finite = True
                    if not finite:
                        return [("not finite", f"{path.name} has '{field}'")]
    for path in sorted(folder.glob("*.vtu")):
        try:
            finite = all(map(math.isfinite, _numbers_of_vtu(path)))
        except (ValueError, SyntaxError, struct.error, zlib.error) as error:
            faults.append(("results", f"{path.name} cannot be read: {error}"))
            continue
        if not finite:
            faults.append(("not finite", f"{path.name} has a number that is not"))
    return faults


def _mass(folder):
    with open(folder / "nodes.csv", newline="") as file:
        return math.fsum(float(row["mass"]) for row in csv.DictReader(file))


def _check_mesh(case, folder, said):
    """Against the second reader."""
    if case.format not in readers.READERS:
        return []
    volume, bound, problems = readers.read(case.format, case.files[case.mesh], case.dim)
    warned = [line for line in said.splitlines()
              if line.startswith("Warning: Mesh file") and not USUAL.search(line)]
    if problems:
        return [] if warned else [("silent loss", "; ".join(problems[:3]))]
    if volume is None:
        return []
    factor = DENSITY * (THICKNESS if case.dim == 2 else 1.)
    found, expected = _mass(folder), factor * volume
    if abs(found - expected) <= 1e-6 * expected + 1e-12 * factor * bound:
        return []
    return [("mass", f"{found:.9g} kg instead of {expected:.9g}")]


def judge(server, case, folder):
    status, said, complained, seconds = _run(server, case, folder)
    faults = []
    if status is None:
        faults.append(("hang", f"more than {SECONDS} s"))
    elif status < 0 or status > 128:
        faults.append(("crash", f"status {status}"))
    elif status not in (0, 1, 2):
        faults.append(("status", f"status {status}"))
    trace = TRACES.search(said + complained)
    if trace:
        faults.append(("trace", f"'{trace.group()}' in the output"))
    if sum(1 for line in complained.splitlines() if line.strip()) > LINES:
        faults.append(("long message", f"{len(complained.splitlines())} lines"))
    if status in (1, 2) and not any(line.startswith("Error: ")
                                    for line in complained.splitlines()):
        faults.append(("no message", f"status {status}"))
    results = folder / "results"
    if results.is_dir():
        faults += _check_results(results)
    if status == 0 and case.dim:
        if (results / "nodes.csv").exists():
            faults += _check_mesh(case, results, said)
        else:
            faults.append(("results", "no nodes.csv"))
    if status in (1, 2) and not case.mutations:
        faults.append(("refused", "an unchanged file"))
    return Verdict(status, seconds, complained + said, faults)


def judge_in_new_folder(server, case):
    with tempfile.TemporaryDirectory(prefix="springfit_fuzz.") as folder:
        return judge(server, case, pathlib.Path(folder))
