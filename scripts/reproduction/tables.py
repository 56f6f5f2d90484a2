"""Joins the published figures with ours: one row per figure."""
import csv
import dataclasses
import pathlib

from experiments import LAWS, SIMILAR_MESHES, SPRINGS_ONLY
from runs import read_csv

HERE = pathlib.Path(__file__).parent
ERRORS = ("e_rms_percent", "e_max_percent")
CONSTANTS = ("E_out", "nu_out")
COLUMNS = ("table", "object", "cells", "case", "fit", "enrichment", "kinematics",
           "quantity", "paper", "ours", "ratio", "remark")

# What a table of the paper asks of our rows: the role of the experiments, the
# quantities, and which fits of ours stand beside the published ones.
TABLES = {
    "1": ("tables", ERRORS, SPRINGS_ONLY),
    "3": ("large", ERRORS, SPRINGS_ONLY),
    "4": ("tables", CONSTANTS, SPRINGS_ONLY),
    "5": ("tables", CONSTANTS + ERRORS, None),
    "6": ("tables", ERRORS, None),
}


def published():
    return read_csv(HERE / "published.csv")


@dataclasses.dataclass
class Line:
    """One line of the page: a fit on an object, figures by quantity."""
    table: str
    object: str
    cells: str
    case: str
    fit: str
    enrichment: str
    nonnegative: bool
    kinematics: str
    law: str
    quantities: tuple
    paper: dict          # numbers as text, as published
    ours: dict           # numbers
    row: dict            # of comparison.csv
    remark: str = ""

    @property
    def label(self):
        text = self.fit if self.enrichment == "none" else f"{self.fit} + {self.enrichment}"
        return text + (", k >= 0" if self.nonnegative else "")

    def ratio(self, quantity):
        if quantity not in self.paper or quantity not in self.ours:
            return None
        return self.ours[quantity] / float(self.paper[quantity])


def remarks_on(remarks, line):
    """Those kept as data in remarks.csv; an empty field suits all lines."""
    return [row["remark"] for row in remarks
            if all(not row[field] or row[field] == getattr(line, field)
                   for field in ("table", "object", "cells", "fit"))
            and (not row["nonnegative"] or (row["nonnegative"] == "yes") == line.nonnegative)]


def _numbers(row, quantities):
    return {q: float(row[q]) for q in quantities if row[q]}


def figures_published(table, object_, cells, case):
    """Published figures by (fit, enrichment), then by quantity."""
    figures = {}
    for row in published():
        if (row["table"], row["object"], row["cells"], row["case"]) == (
                table, object_, cells, case):
            figures.setdefault((row["fit"], row["enrichment"]), {})[row["quantity"]] = row["value"]
    return figures


def errors_published(table, object_, cells, case):
    """{fit: 'e_rms / e_max' as published}"""
    return {fit: " / ".join(of_fit[q] for q in ERRORS)
            for (fit, _), of_fit in figures_published(table, object_, cells, case).items()}


def objects_of(table):
    """(object, cells, case, nodes, cells) of a table, in the paper's order."""
    found = []
    for row in published():
        key = (row["object"], row["cells"], row["case"], row["n_nodes"], row["n_cells"])
        if row["table"] == table and key not in found:
            found.append(key)
    return found


def _order(figures, fit, enrichment, nonnegative):
    published_fits = list(figures)
    position = published_fits.index((fit, enrichment)) if (fit, enrichment) in figures else 99
    known = SPRINGS_ONLY + ("gelder", "lloyd", "baudet", "delingette", "golec")
    return (position, known.index(fit) if fit in known else 99, enrichment != "none", nonnegative)


def place_in_spread(paper, numbers):
    """Where a published figure lies among sorted ones of similar meshes; it is
    rounded to its last digit."""
    half = 0.5 * 10. ** -len(paper.split(".")[1])
    if float(paper) < numbers[0] - half:
        return "below"
    return "above" if float(paper) > numbers[-1] + half else "inside"


def _spread_remark(line, rows):
    """"paper's e_rms inside, e_max below the spread of similar meshes\""""
    if TABLES[line.table][0] != "tables" or (line.object, line.cells) not in SIMILAR_MESHES:
        return ""
    values, _ = spread(rows, line.object, line.cells, line.case)
    of_fit = values.get((line.fit, line.enrichment, line.nonnegative), {})
    places = [f"{quantity.replace('_percent', '')} {place_in_spread(line.paper[quantity], of_fit[quantity])}"
              for quantity in line.quantities if quantity in line.paper and quantity in of_fit]
    return f"paper's {', '.join(places)} the spread of similar meshes" if places else ""


def lines_of(table, rows, remarks):
    """The lines of a table, ours beside the published ones. A fit that has no
    negative spring has no second line for k >= 0."""
    role, quantities, fits = TABLES[table]
    lines = []
    for object_, cells, case, _, _ in objects_of(table):
        figures = figures_published(table, object_, cells, case)
        group, signed = [], {}
        for row in rows:
            experiment = row["experiment"]
            if (experiment.role, experiment.object, experiment.cells, row["case"]) != (
                    role, object_, cells, case) or row["fit"] == "fem":
                continue
            key = (row["fit"], row["enrichment"])
            if fits and row["fit"] not in fits and key not in figures:
                continue
            if experiment.nonnegative and signed.get(key) == 0:
                continue
            if not experiment.nonnegative:
                signed[key] = int(row["n_negative"])
            group.append(Line(table, object_, cells, case, *key, experiment.nonnegative,
                              row["kinematics"], experiment.law, quantities,
                              figures.get(key, {}), _numbers(row, quantities), row))
        # Published rows without a run of ours stay visible.
        for key in figures:
            if not any((line.fit, line.enrichment) == key for line in group):
                group.append(Line(table, object_, cells, case, *key, False, "linear",
                                  "linear", quantities, figures[key], {}, {},
                                  "no result of ours"))
        group.sort(key=lambda line: (
            _order(figures, line.fit, line.enrichment, line.nonnegative),
            LAWS.index(line.law), line.kinematics))
        lines += group
    for line in lines:
        said = [line.remark] if line.remark else []
        if line.row.get("gap") and line.paper:
            said.append(f"certified to {line.row['gap']:.0e}")
        if int(line.row.get("n_negative") or 0):
            said.append(f"{line.row['n_negative']} of {line.row['n_springs']} springs negative")
        if line.paper:
            said += remarks_on(remarks, line)
            said += filter(None, [_spread_remark(line, rows)])
        line.remark = "; ".join(said)
    return lines


def best_rows(rows):
    """For each object and load of Tables 1 and 6 (and Table 5 for the
    specimen): the paper's best row, our best k >= 0 springs."""
    best = []
    for table in ("1", "5", "6"):
        for object_, cells, case, n_nodes, n_cells in objects_of(table):
            if table == "5" and object_ == "cube":
                continue  # in Table 1
            figures = {fit: float(q["e_rms_percent"])
                       for (fit, _), q in figures_published(table, object_, cells, case).items()}
            ours = {}
            for row in rows:
                e = row["experiment"]
                if (e.role == "tables" and e.object == object_ and e.cells == cells
                        and row["case"] == case and row["fit"] in SPRINGS_ONLY
                        and (e.nonnegative or row["n_negative"] == "0")):
                    ours[row["fit"]] = float(row["e_rms_percent"])
                    counts = (row["n_nodes"], row["n_cells"])
            if not ours:
                best.append((table, object_, cells, case, figures, {}, False))
                continue
            agrees = counts == (n_nodes, n_cells) and object_ in ("cube", "square")
            best.append((table, object_, cells, case, figures, ours, agrees))
    return best


def spread(rows, object_, cells, case):
    """{(fit, enrichment, nonnegative): {quantity: sorted values}} over similar
    meshes and the scene's own, and the numbers of their nodes and cells."""
    values, sizes = {}, set()
    for row in rows:
        e = row["experiment"]
        if (e.object, e.cells, row["case"]) != (object_, cells, case) or row["fit"] == "fem":
            continue
        if e.role not in ("spread", "tables"):
            continue
        sizes.add((e.options[0] if e.role == "spread" else "", int(row["n_nodes"]),
                   int(row["n_cells"])))
        of_fit = values.setdefault((row["fit"], row["enrichment"], e.nonnegative), {})
        for quantity, value in _numbers(row, CONSTANTS + ERRORS).items():
            of_fit.setdefault(quantity, []).append(value)
    for of_fit in values.values():
        for numbers in of_fit.values():
            numbers.sort()
    return values, sorted((n, c) for _, n, c in sizes)


def write_reproduction(path, lines, extra):
    """reproduction.csv; 'extra' are rows of the other tables, as dicts."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for line in lines:
            for quantity in line.quantities:
                if quantity not in line.paper and quantity not in line.ours:
                    continue
                ratio = line.ratio(quantity)
                writer.writerow({
                    "table": line.table, "object": line.object, "cells": line.cells,
                    "case": line.case, "enrichment": line.enrichment,
                    "fit": line.fit + (" nonnegative" if line.nonnegative else ""),
                    "kinematics": line.kinematics + (
                        "" if line.law == "linear" else f" against {line.law}"),
                    "quantity": quantity, "paper": line.paper.get(quantity, ""),
                    "ours": f"{line.ours[quantity]:.6g}" if quantity in line.ours else "",
                    "ratio": f"{ratio:.4g}" if ratio is not None else "",
                    "remark": line.remark})
        writer.writerows(extra)
