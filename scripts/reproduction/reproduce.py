"""Runs the paper's experiments and writes output/reproduction/; started by
scripts/reproduce, which says how."""
import argparse
import pathlib
import re
import shutil
import string
import subprocess
import sys
import time

import page
import pictures
import tables
from experiments import OBJECTS, SWEEPS, all_experiments, is_of_paper
from runs import comparison_rows, read_csv, run_all

TOP = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).parent
PROGRAM = TOP / "build" / "springfit"
KINDS = {"triangle": "triangles", "quadrilateral": "quadrilaterals",
         "tetrahedron": "tetrahedra", "hexahedron": "hexahedra"}
# Rows of scripts/benchmark that stand beside the paper's.
TIMED = {"frobenius": "frobenius", "spectral ipopt": "spectral", "spectral barrier": "spectral"}


def benchmark(folder, reuse):
    """{(row, cells): seconds} as scripts/benchmark prints them."""
    kept = folder / "benchmark.md"
    if not (reuse and kept.exists()):
        result = subprocess.run([TOP / "scripts" / "benchmark"], capture_output=True, text=True)
        if result.returncode:
            print("Error: scripts/benchmark failed:\n" + result.stderr, file=sys.stderr)
            return {}
        kept.write_text(result.stdout)
    lines = [[field.strip() for field in line.strip("|\n ").split("|")]
             for line in kept.read_text().splitlines() if line.startswith("|")]
    cells = [KINDS[word] for word in lines[0][1:]]
    return {(fields[0], kind): 1e-6 * float(value.replace(",", ""))
            for fields in lines[2:] if not fields[0].startswith("published")
            for kind, value in zip(cells, fields[1:])}


def times(seconds, remarks):
    """Lines of Table 2."""
    theirs = {(row["cells"], row["fit"]): row["value"] for row in tables.published()
              if row["table"] == "2"}
    lines = []
    for cells in KINDS.values():
        for label in dict.fromkeys(label for label, kind in seconds if kind == cells):
            if label.startswith("R ("):
                continue
            fit = TIMED.get(label)
            paper = theirs.get((cells, fit), "")
            remark = "; ".join(row["remark"] for row in remarks
                               if row["table"] == "2" and row["fit"] in ("", label)
                               and row["cells"] in ("", cells)) if paper else ""
            lines.append((cells, label, paper, seconds[label, cells], remark))
    for (cells, fit), paper in theirs.items():
        if not any(line[0] == cells and TIMED.get(line[1]) == fit for line in lines):
            lines.append((cells, fit, paper, None, "no result of ours"))
    return lines


def sweep_rows(sweeps):
    """Rows of reproduction.csv for Figure 9."""
    return [{"table": "figure 9", "object": "one cell", "cells": cells, "case": "tension",
             "fit": row["fit"], "enrichment": row["enrichment"], "kinematics": "linear",
             "quantity": f"{quantity} at E_in {row['E_in']} nu_in {row['nu_in']}",
             "ours": row[quantity]}
            for cells, rows in sweeps.items() for row in rows
            for quantity in ("E_out", "nu_out") if row[quantity]]


def time_rows(lines):
    return [{"table": "2", "object": "one cell", "cells": cells, "fit": label,
             "enrichment": "none", "quantity": "seconds", "paper": paper,
             "ours": f"{ours:.4g}" if ours else "",
             "ratio": f"{ours / float(paper):.4g}" if ours and paper else "", "remark": remark}
            for cells, label, paper, ours, remark in lines]


def draw(experiments, runs, folder):
    """The pictures; returns the Markdown that shows them."""
    folder.mkdir(parents=True, exist_ok=True)
    text = []
    done = {e.name for e in experiments}
    for object_, cells in OBJECTS:
        name = f"{object_.replace(' ', '_')}_{cells}"
        for case in (("shear",) if object_ == "square" else
                     ("tension", "shear") if object_ == "cube" else ("tension",)):
            if name not in done or not (runs / name / f"{case}_spectral.vtu").exists():
                continue
            file = f"{name}_{case}.svg"
            fits = ("frobenius", "spectral")
            pictures.deformed(runs / name, case, fits, fits, folder / file)
            text.append(f"![{object_}, {cells}, {case}]({folder.name}/{file})\n\n"
                        f"*{object_}, {cells}, {case}: finite elements (dashed) over springs, "
                        "true scale.*\n")
    return "\n".join(text)


def unfinished(lines, time_lines, sweeps):
    """Published figures that have no finite figure of ours."""
    missing = [f"Table {line.table}, {line.object}, {line.cells}, {line.label}, {quantity}"
               for line in lines for quantity in line.paper if quantity not in line.ours]
    missing += [f"Figure 9, {cells}" for cells in SWEEPS if not sweeps.get(cells)]
    return missing + [f"Table 2, {cells}, {label}" for cells, label, paper, ours, _ in
                      time_lines if paper and not ours]


def main():
    parser = argparse.ArgumentParser(prog="scripts/reproduce")
    parser.add_argument("--reuse", action="store_true",
                        help="keep the results that are there")
    parser.add_argument("--publish", action="store_true",
                        help="renew doc/reproduction.md and its pictures")
    arguments = parser.parse_args()

    begin = time.time()
    folder = TOP / "output" / "reproduction"
    runs = folder / "runs"
    runs.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(folder / "pictures", ignore_errors=True)
    experiments = all_experiments()
    run_all(experiments, PROGRAM, TOP, runs, arguments.reuse)
    seconds = benchmark(folder, arguments.reuse)

    remarks = read_csv(HERE / "remarks.csv")
    rows = list(filter(is_of_paper, comparison_rows(experiments, runs)))
    of_table = {table: tables.lines_of(table, rows, remarks) for table in tables.TABLES}
    lines = [line for table in of_table for line in of_table[table]]
    time_lines = times(seconds, remarks)
    sweeps = {cells: list(filter(is_of_paper, read_csv(runs / f"sweep_{cells}" / "sweep.csv")))
              for cells in SWEEPS if (runs / f"sweep_{cells}" / "sweep.csv").exists()}
    tables.write_reproduction(folder / "reproduction.csv", lines,
                              time_rows(time_lines) + sweep_rows(sweeps))

    shown = draw(experiments, runs, folder / "pictures")
    curves = []
    for cells, found in sweeps.items():
        pictures.sweep(cells, found, folder / "pictures" / f"figure_9_{cells}.svg")
        curves.append(f"![E_out and nu_out of one cell, {cells}](pictures/figure_9_{cells}.svg)\n")
    fill = {"origin": page.origin(TOP, PROGRAM), "paper": page.PAPER,
            "summary": page.summary(rows, remarks), "spread": page.spread_tables(rows),
            "times": page.times_table(time_lines), "sweep": page.sweep_summary(sweeps),
            "large": page.large_matrix(of_table["3"]), "loads": page.other_loads(rows),
            "large_shear": page.large_shear(rows),
            "pictures": shown, "curves": "\n".join(curves), "problems": page.problems(experiments)}
    for table in of_table:
        # Table 3 has all pairs of models in a table of its own.
        chosen = [line for line in of_table[table]
                  if table != "3" or line.law == "linear" and line.kinematics == "linear"
                  or line.law == "neo-hookean" and line.kinematics == "nonlinear"
                  or not line.row]
        fill[f"table_{table}"] = page.figures_table(table, chosen, rows, table == "3")
    text = string.Template((HERE / "page.md").read_text()).substitute(fill)
    (folder / "reproduction.md").write_text(re.sub(r"\n{3,}", "\n\n", text))
    if arguments.publish:
        page.publish(TOP, folder, "reproduction")

    missing = unfinished(lines, time_lines, sweeps)
    for row in missing:
        print(f"Error: no figure of ours for {row}", file=sys.stderr)
    print(f"{time.time() - begin:.0f} s. Results are in {folder.relative_to(TOP)}: open "
          "reproduction.md; reproduction.csv has every figure.")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
