"""The table of what fits of a whole object cost and gain on the objects of the paper."""
import dataclasses

import page
from runs import comparison_rows, read_csv
from scenes import PAPER_OBJECTS, command
from tables import published

CASES = ("tension", "shear", "torsion")
TERMS = ("springs", "couplings", "angles", "volumes")


def _unknowns(folder, scope):
    """Of a whole object at once; of single cells the fits times the unknowns of each."""
    if scope == "object":
        return str(sum(len(read_csv(table)) for kind in TERMS
                       for table in folder.glob(f"{kind}_*.csv")))
    vertices = len(read_csv(folder / "cells.csv")[0])
    springs_and_volume = vertices * (vertices - 1) // 2 + 1
    return f"{len(read_csv(folder / 'fit.csv'))} x {springs_and_volume}"


def _best_published(object_, cells, case):
    """'e_rms (fit, table)' of the published row with the smallest e_rms."""
    rows = [row for row in published()
            if (row["object"], row["cells"], row["case"]) == (object_, cells, case)
            and (row["quantity"], row["deformation_percent"]) == ("e_rms_percent", "10")]
    if not rows:
        return "-"
    best = min(rows, key=lambda row: float(row["value"]))
    return f"{best['value']} ({best['fit']}, Table {best['table']})"


def _figures(run, folder):
    """Unknowns, time and errors of a run."""
    rows = {row["case"]: row for row in comparison_rows([run], folder) if row["fit"] != "fem"}
    if run.problem or not rows:
        return ["-", "-", *("no network" for _ in CASES)]
    seconds = float(next(iter(rows.values()))["calibrate_s"])
    return [_unknowns(folder / run.name, run.scope), f"{seconds:.2g}",
            *(f"{float(rows[case]['e_rms_percent']):.2f}" if case in rows else "-"
              for case in CASES)]


def table(runs, folder):
    """'runs' are all of them, 'folder' is where they are."""
    body = []
    for object_, cells, mesh in PAPER_OBJECTS:
        name = f"{object_}, {cells}" + (", distorted" if mesh == "distorted" else "")
        for run in runs:
            if (run.role, run.object, run.cells, run.mesh) == ("paper", object_, cells, mesh):
                body.append([name, run.scope, f"`{run.title}`", *_figures(run, folder)])
                name = ""
        body.append(["", "", "best published", "", "",
                     *(_best_published(object_, cells, case) for case in CASES)])
    return page.markdown_table(["object", "scope", "fit", "unknowns", "s", *CASES], body)


def commands(runs):
    """What a reader types for a row of each scope."""
    shown = {run.scope: run for run in runs if run.role == "paper" and "frobenius" in run.title}
    return "\n".join(command(dataclasses.replace(
        run, scene="parameters/paper/<object>_<cells>.prm",
        options=("Fit/Methods=<fit>", *run.options[1:])), jitter="<jitter>")
        for run in shown.values())
