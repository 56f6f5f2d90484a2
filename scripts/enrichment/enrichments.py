"""Runs springs with and without enrichment and writes output/enrichments/; started
by scripts/enrichments, which says how."""
import argparse
import dataclasses
import json
import pathlib
import re
import shutil
import string
import subprocess
import sys
import time

import curves
import large_deformation
import page
import paper_objects
from runs import comparison_rows, read_csv, run_all
from scenes import (ENRICHMENTS, EXACT, FITS, JITTER, OBJECTS, POISSON, SCOPES, SETTINGS,
                    SWEPT_ENRICHMENTS, all_runs, cases_of, command)

TOP = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).parent
PROGRAM = TOP / "build" / "springfit"
BENCHMARK = TOP / "build" / "network_benchmark"
IN_SHORT = (0.3, 0.45, 0.49)
# Of a cell: its vertices, the angles of its faces (cell_topology.h), and the points of the
# finite element's quadrature.
POINTS = {"triangles": 1, "quadrilaterals": 4, "tetrahedra": 1, "hexahedra": 8}
VERTICES = {"triangles": 3, "quadrilaterals": 4, "tetrahedra": 4, "hexahedra": 8}
ANGLES = {"triangles": 3, "quadrilaterals": 4, "tetrahedra": 12, "hexahedra": 24}
STORED = ("springs", "couplings", "angles", "volumes", "point_volumes")
WORK = {"forces": "forces", "product": "tangent times a vector", "tangent": "tangent"}


@dataclasses.dataclass
class Line:
    """A fit on a mesh, over Poisson's ratio."""
    role: str
    object: str
    cells: str
    mesh: str
    scope: str
    fit: str
    enrichment: str
    coefficients: float = 0.    # per cell
    seconds: float = 0.         # of the calibration, at nu = 0.3
    errors: dict = dataclasses.field(default_factory=dict)  # nu: {case: e_rms in %}

    @property
    def label(self):
        words = [word.replace("stable_neo_hookean", "stable neo-hookean").replace("_", " ")
                 for word in (self.fit, self.enrichment)]
        return words[0] if self.enrichment == "none" else " + ".join(words)


def coefficients_per_cell(folder, row):
    name = row["fit"] + ("" if row["enrichment"] == "none" else "_" + row["enrichment"])
    files = [folder / f"{kind}_{name}.csv" for kind in STORED]
    n = 0
    for file in files:
        if file.exists():
            rows = read_csv(file)
            n += len(rows) * sum(re.fullmatch(r"k\d*|stiffness", name) is not None
                                 for name in rows[0])
    return n / int(row["n_cells"])


def lines_of(runs, folder):
    """The rows of all comparison.csv by what they are errors of."""
    lines = {}
    for row in comparison_rows(runs, folder):
        run = row["experiment"]
        if row["fit"] == "fem":
            continue
        key = (run.role, run.object, run.cells, run.mesh, run.scope, row["fit"],
               row["enrichment"])
        line = lines.setdefault(key, Line(*key))
        if run.nu == 0.3:
            line.seconds = float(row["calibrate_s"])
            if not line.coefficients:
                line.coefficients = coefficients_per_cell(folder / run.name, row)
        line.errors.setdefault(run.nu, {})[row["case"]] = float(row["e_rms_percent"])
    return list(lines.values())


def times(kept, reuse):
    """{(what, cells, model, law): the shortest CPU time per cell, ns}"""
    if not (reuse and kept.exists()):
        result = subprocess.run(
            [BENCHMARK, "--benchmark_format=json", "--benchmark_repetitions=3",
             "--benchmark_min_time=0.05", "--benchmark_filter=.*/quadratic"],
            capture_output=True, text=True, check=True)
        kept.write_text(result.stdout)
    shortest = {}
    for entry in json.loads(kept.read_text())["benchmarks"]:
        if entry["run_type"] == "iteration":
            key = tuple(entry["run_name"].split("/")[:4])
            shortest[key] = min(entry["cpu_time"], shortest.get(key, float("inf")))
    return shortest


def model(enrichment):
    return "springs alone" if enrichment == "none" else f"+ {enrichment}"


def significant(value):
    """Two digits; whole numbers have theirs."""
    return f"{value:.0f}" if value >= 10. else f"{value:.2g}"


def number(value):
    """Two digits behind the point; zero is rounding."""
    return "exact" if value < 1e-6 else f"{value:.2f}"


def errors_of(line, nu):
    found = line.errors.get(nu)
    if not found:
        return "-"
    values = [found[case] for case in cases_of(line.cells)]
    if max(values) < 1e-6:
        return "exact"
    return " / ".join(number(value) for value in values)


def error_table(lines):
    """Couplings are exact whatever the fit, and have one line."""
    body = []
    for mesh in JITTER:
        for line in lines:
            if line.mesh != mesh or (line.enrichment == "coupling" and line.fit != FITS[0]):
                continue
            label = "any fit + coupling" if line.enrichment == "coupling" else f"`{line.label}`"
            body.append([mesh, label, f"{line.coefficients:.1f}",
                         *(errors_of(line, nu) for nu in POISSON)])
    return page.markdown_table(["mesh", "fit", "coefficients per cell",
                                *(f"nu = {nu:g}" for nu in POISSON)], body)


def errors(lines, runs, folder):
    text = []
    for object_, cells in OBJECTS:
        chosen = [line for line in lines if line.role == "enrichments"
                  and (line.object, line.cells) == (object_, cells)]
        example = next(run for run in runs if run.role == "enrichments"
                       and (run.object, run.cells, run.nu) == (object_, cells, 0.3))
        curves.error_and_cost(chosen, folder / f"{cells}.svg")
        text += [f"### {cells.capitalize()}, {object_}\n", error_table(chosen),
                 "Jitter 0 or 0.2, Poisson's ratio as in the head:\n",
                 command(example, nu="<nu>", jitter="<jitter>"),
                 f"![largest error over coefficients per cell, {cells}](pictures/{cells}.svg)\n",
                 f"*{cells.capitalize()}: the largest error of the load cases over the "
                 "enrichments and their coefficients per cell, filled points and full lines `consistent`, open ones "
                 f"`frobenius`; points at {curves.LOWEST} % are exact or nearly so. "
                 "`scripts/enrichments`.*\n"]
    return "\n".join(text)


def summary(lines):
    body = []
    for object_, cells in OBJECTS:
        for mesh in JITTER:
            row = [cells, mesh]
            columns = [("consistent", enrichment) for enrichment in ENRICHMENTS]
            columns += [(EXACT[0], enrichment) for enrichment in EXACT[1]
                        if POINTS[cells] > 1 or enrichment == "volume"]
            for fit, enrichment in columns:
                found = [line for line in lines if
                         (line.role, line.cells, line.mesh, line.fit, line.enrichment) ==
                         ("enrichments", cells, mesh, fit.replace(" ", "_").replace("-", "_"),
                          enrichment.replace(" ", "_"))]
                worst = [number(max(found[0].errors[nu].values()))
                         if found and nu in found[0].errors else "-" for nu in IN_SHORT]
                row.append("exact" if set(worst) == {"exact"} else " / ".join(worst))
            if POINTS[cells] == 1:
                row.append("the same")
            body.append(row)
    at = " / ".join(f"{nu:g}" for nu in IN_SHORT)
    return page.markdown_table(
        ["cells", "mesh", *(f"{model(e)}, nu = {at}" for e in ENRICHMENTS),
         *(f"stable neo-hookean + {e}, nu = {at}" for e in EXACT[1])], body)


def coefficients_of_cell(cells, name):
    springs = VERTICES[cells] * (VERTICES[cells] - 1) // 2
    if name.endswith("point volumes"):
        return springs + POINTS[cells]
    return springs + {"none": 0, "angles": ANGLES[cells],
                      "coupling": springs * (springs - 1) // 2}.get(name, 1)


def cost_table(shortest):
    models = {"none": "springs alone", "volume": "+ volume", "angles": "+ angles",
              "coupling": "+ coupling",
              "stable neo-hookean, volume": "stable neo-hookean + volume",
              "stable neo-hookean, point volumes": "stable neo-hookean + point volumes",
              "stable neo-hookean, logarithmic volume": "the same, logarithmic, + volume",
              "stable neo-hookean, logarithmic point volumes":
                  "the same, logarithmic, + point volumes"}
    body = []
    for _, cells in OBJECTS:
        for name, label in models.items():
            if ("forces", cells, name, "quadratic") not in shortest:
                continue
            row = [cells, label, str(coefficients_of_cell(cells, name))]
            for what in WORK:
                alone = shortest[what, cells, "none", "quadratic"]
                time_ = shortest[what, cells, name, "quadratic"]
                row.append(f"{time_ / alone:.1f} ({significant(time_)})")
            body.append(row)
    return page.markdown_table(["cells", "model", "coefficients of a cell", *WORK.values()], body)


def printed_by(script):
    return subprocess.run([TOP / "scripts" / script], capture_output=True, text=True,
                          check=True).stdout


def scope_tables(lines, runs):
    text = []
    for object_, cells in OBJECTS:
        body = []
        for mesh in JITTER:
            for scope in SCOPES:
                for line in lines:
                    if (line.role, line.cells, line.mesh, line.scope) == (
                            "scopes", cells, mesh, scope):
                        body.append([mesh, scope, f"`{line.label}`", f"{line.seconds:.2g}",
                                     *(errors_of(line, nu) for nu in POISSON)])
        example = next(run for run in runs if (run.role, run.scope, run.cells, run.nu) ==
                       ("scopes", "object", cells, 0.3))
        text += [f"**{cells}, {object_}**\n",
                 page.markdown_table(["mesh", "scope", "fit", "s",
                                      *(f"nu = {nu:g}" for nu in POISSON)], body),
                 command(example, nu="<nu>", jitter="<jitter>")]
    return "\n".join(text)


def sweeps(runs, folder, pictures):
    """The table of Figure 9, and its pictures."""
    body, shown = [], []
    for picture in SETTINGS:
        panels = []
        for run in runs:
            if run.role != "sweep" or not run.name.startswith(f"sweep_{picture}_"):
                continue
            file = folder / run.name / "sweep.csv"
            if run.problem or not file.exists():
                continue
            rows = read_csv(file)
            panels.append((run.title, rows))
            for enrichment in SWEPT_ENRICHMENTS:
                of_fit = [row for row in rows
                          if (row["fit"], row["enrichment"]) == ("consistent", enrichment)]
                row = [run.title, model(enrichment)]
                for suffix in ("out", "homogenised"):
                    E = max(abs(float(r[f"E_{suffix}"]) / float(r["E_in"]) - 1.) for r in of_fit)
                    nu = max(abs(float(r[f"nu_{suffix}"]) - float(r["nu_in"])) for r in of_fit)
                    row += ["exact" if E < 1e-8 else significant(100. * E),
                            "exact" if nu < 1e-8 else significant(nu)]
                body.append(row)
        curves.figure_9(panels, pictures / f"figure_9_{picture}.svg")
        commands = "\n".join(command(run) for run in runs
                             if run.name.startswith(f"sweep_{picture}_"))
        shown += [f"![E_out and nu_out over nu_in, {picture}](pictures/figure_9_{picture}.svg)\n",
                  commands]
    table = page.markdown_table(
        ["cell", "model", "E_out, % of E_in", "nu_out - nu_in", "E_homogenised, % of E_in",
         "nu_homogenised - nu_in"], body)
    return table, "\n".join(shown)


def main():
    parser = argparse.ArgumentParser(prog="scripts/enrichments")
    parser.add_argument("--reuse", action="store_true",
                        help="keep the results that are there")
    parser.add_argument("--publish", action="store_true",
                        help="renew doc/enrichments.md and its pictures")
    arguments = parser.parse_args()

    begin = time.time()
    folder = TOP / "output" / "enrichments"
    runs, pictures = folder / "runs", folder / "pictures"
    runs.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir()
    shortest = times(folder / "benchmark.json", arguments.reuse)
    experiments = all_runs()
    run_all(experiments, PROGRAM, TOP, runs, arguments.reuse)

    lines = lines_of(experiments, runs)
    sweep_table, sweep_pictures = sweeps(experiments, runs, pictures)
    fill = {"origin": page.origin(TOP, PROGRAM), "summary": summary(lines),
            "bending": printed_by("bending"), "tension": printed_by("tension"),
            "cost": cost_table(shortest), "errors": errors(lines, experiments, pictures),
            "scopes": scope_tables(lines, experiments),
            "paper": paper_objects.table(experiments, runs),
            "paper_commands": paper_objects.commands(experiments),
            "large": large_deformation.table(experiments, runs),
            "large_example": large_deformation.example(experiments), "sweep": sweep_table,
            "curves": sweep_pictures, "problems": page.problems(experiments)}
    text = string.Template((HERE / "enrichments.md").read_text()).substitute(fill)
    (folder / "enrichments.md").write_text(re.sub(r"\n{3,}", "\n\n", text))
    if arguments.publish:
        page.publish(TOP, folder, "enrichments")

    failed = [run for run in experiments if run.problem]
    for run in failed:
        print(f"Error: {run.name}: {run.problem}", file=sys.stderr)
    print(f"{time.time() - begin:.0f} s. Results are in {folder.relative_to(TOP)}: open "
          "enrichments.md.")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
