"""The readable page, in Markdown."""
import datetime
import platform
import shutil
import subprocess

from experiments import LAWS, SHEAR_PERCENT, SIMILAR_MESHES, SPRINGS_ONLY, SWEEPS
from tables import (ERRORS, best_rows, errors_published, figures_published, objects_of,
                    place_in_spread, spread)

PAPER = ("S. Natsupakpong and M. C. Cavusoglu, Determination of elasticity parameters in "
         "lumped element (mass-spring) models of deformable objects, Graphical Models 72 "
         "(2010) 61-73, [doi:10.1016/j.gmod.2010.10.001]"
         "(https://doi.org/10.1016/j.gmod.2010.10.001)")


def markdown_table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def _number(quantity, value):
    if value is None:
        return "-"
    if quantity == "E_out":
        return f"{value:.0f}"
    return f"{value:.3f}" if quantity == "nu_out" and abs(value) < 10 else f"{value:.2f}"


def _joined(quantities, texts):
    """E, nu, e_rms / e_max."""
    texts = dict(zip(quantities, texts))
    parts = [texts[q] for q in quantities if q not in ERRORS]
    if ERRORS[0] in texts:
        parts.append(" / ".join(texts[q] for q in ERRORS))
    return ", ".join(parts)


def _cells_of(line):
    q = line.quantities
    paper = _joined(q, [line.paper.get(x, "-") for x in q]) if line.paper else ""
    ours = _joined(q, [_number(x, line.ours.get(x)) for x in q]) if line.ours else "-"
    ratios = [line.ratio(x) for x in q]
    ratio = (_joined(q, ["-" if r is None else f"{r:.2f}" for r in ratios])
             if any(r is not None for r in ratios) else "")
    return paper, ours, ratio


def counts_of(rows, object_, cells):
    for row in rows:
        e = row["experiment"]
        if (e.role, e.object, e.cells) == ("tables", object_, cells):
            return row["n_nodes"], row["n_cells"]
    return "-", "-"


def figures_table(table, lines, rows, with_kinematics=False):
    """Row by row: paper, ours, ratio, remark."""
    text = []
    for object_, cells, case, n_nodes, n_cells in objects_of(table):
        ours = counts_of(rows, object_, cells)
        text.append(f"**{object_}, {cells}, {case}** (nodes / cells: paper {n_nodes} / "
                    f"{n_cells}, ours {ours[0]} / {ours[1]})\n")
        body = []
        for line in lines:
            if (line.object, line.cells, line.case) != (object_, cells, case):
                continue
            label = f"`{line.label}`"
            model = [f"{line.kinematics} / {line.law}"] if with_kinematics else []
            body.append([label, *model, *_cells_of(line), line.remark])
        header = ["fit"] + (["springs / finite elements"] if with_kinematics else [])
        text.append(markdown_table(header + ["paper", "ours", "ratio", "remark"], body))
    return "\n".join(text)


def summary(rows, remarks):
    body = []
    for table, object_, cells, case, figures, ours, agrees in best_rows(rows):
        theirs = min(figures, key=figures.get)
        mine = min(ours, key=ours.get) if ours else None
        good = mine is not None and ours[mine] <= figures[theirs]
        why = [r["remark"] for r in remarks if r["table"] == "summary"
               and (r["object"], r["cells"]) == (object_, cells)]
        body.append([table, f"{object_}, {cells}", case,
                     f"{figures[theirs]:.2f} ({theirs})",
                     f"{ours[mine]:.2f} ({mine})" if ours else "-",
                     "yes" if good else "no", "yes" if agrees else "no",
                     "; ".join(why)])
    return markdown_table(["table", "object", "load", "paper's best row", "our best, k >= 0",
                   "at least as good", "same mesh", "remark"], body)


def spread_tables(rows):
    """For the meshes of gmsh: how much the mesh alone moves the figures."""
    asked = {}
    for table in ("1", "4", "5", "6"):
        for object_, cells, case, *_ in objects_of(table):
            if (object_, cells) in SIMILAR_MESHES:
                asked.setdefault((object_, cells, case), []).append(table)
    body = []
    for (object_, cells, case), tables in asked.items():
        values, sizes = spread(rows, object_, cells, case)
        if not sizes:
            continue
        figures = {}
        for table in tables:
            for key, found in figures_published(table, object_, cells, case).items():
                figures.setdefault(key, {}).update(found)
        nodes, n_cells = [n for n, _ in sizes], [c for _, c in sizes]
        first = (f"{object_}, {cells}, {case}: {len(sizes)} meshes of {min(nodes)} to "
                 f"{max(nodes)} nodes, {min(n_cells)} to {max(n_cells)} cells")
        for (fit, enrichment, nonnegative), of_fit in values.items():
            if (fit, enrichment) not in figures:
                continue
            if nonnegative and of_fit == values.get((fit, enrichment, False)):
                continue  # no mesh has a negative spring
            for quantity, numbers in of_fit.items():
                paper = figures[(fit, enrichment)].get(quantity)
                if paper is None:
                    continue
                body.append([first, f"`{fit}{', k >= 0' if nonnegative else ''}`",
                             quantity.replace("_percent", ""),
                             *(_number(quantity, x) for x in
                               (numbers[0], numbers[len(numbers) // 2], numbers[-1])),
                             paper, place_in_spread(paper, numbers)])
                first = ""
    return markdown_table(["meshes", "fit", "figure", "lowest", "median", "highest", "paper",
                   "the paper's lies"], body)


def large_matrix(lines):
    """Table 3: e_rms at 30 % for each pair of models."""
    text = []
    for cells in ("tetrahedra", "hexahedra"):
        body = []
        keys = []
        for line in lines:
            if line.cells == cells and line.row and (line.fit, line.nonnegative) not in keys:
                keys.append((line.fit, line.nonnegative))
        for fit, nonnegative in keys:
            row = []
            for law in LAWS:
                for kinematics in ("linear", "nonlinear"):
                    found = [line for line in lines if line.row and
                             (line.cells, line.fit, line.nonnegative, line.law,
                              line.kinematics) == (cells, fit, nonnegative, law, kinematics)]
                    row.append(f"{found[0].ours[ERRORS[0]]:.2f}" if found else "-")
            body.append([f"`{fit}{', k >= 0' if nonnegative else ''}`"] + row)
        text.append(f"**cube, {cells}**, e_rms in %\n")
        text.append(markdown_table(["fit"] + [f"{k} springs, {law}" for law in LAWS
                                      for k in ("linear", "nonlinear")], body))
    return "\n".join(text)


def large_shear(rows):
    """Table 6: springs linear and with their true forces, finite elements linear."""
    ours = {}
    for row in rows:
        e = row["experiment"]
        if e.role == "shear":
            key = (e.object, e.cells, row["fit"], row["kinematics"], e.deformation_percent)
            ours[key] = " / ".join(f"{float(row[q]):.2f}" for q in ERRORS)
    body = []
    for object_, cells, case, *_ in objects_of("6"):
        for fit, paper in errors_published("6", object_, cells, case).items():
            found = [ours.get((object_, cells, fit, "linear", SHEAR_PERCENT[0]))]
            found += [ours.get((object_, cells, fit, "nonlinear", percent))
                      for percent in SHEAR_PERCENT]
            if found[0]:
                body.append([f"{object_}, {cells}", f"`{fit}`", paper,
                             *(text or "-" for text in found)])
    return markdown_table(["object", "fit", "paper", "linear springs",
                   *(f"true forces, {percent} %" for percent in SHEAR_PERCENT)], body)


def other_loads(rows):
    """Loads that the paper did not tabulate, for every 3-d object."""
    body = []
    seen = set()
    for row in rows:
        e = row["experiment"]
        if e.role != "tables" or e.cells not in ("tetrahedra", "hexahedra"):
            continue
        if row["fit"] not in SPRINGS_ONLY:
            continue
        if e.nonnegative and (e.object, e.cells, row["fit"]) not in seen:
            continue
        if not e.nonnegative and row["n_negative"] != "0":
            seen.add((e.object, e.cells, row["fit"]))
        key = (e.object, e.cells, row["fit"], e.nonnegative)
        for entry in body:
            if entry[0] == key:
                break
        else:
            entry = (key, {})
            body.append(entry)
        entry[1][row["case"]] = (f"{float(row['e_rms_percent']):.2f} / "
                                 f"{float(row['e_max_percent']):.2f}")
    cases = ("tension", "compression", "shear", "torsion")
    return markdown_table(["object", "fit", *cases],
                  [[f"{o}, {c}", f"`{f}{', k >= 0' if n else ''}`",
                    *(found.get(case, "-") for case in cases)]
                   for (o, c, f, n), found in body])


def times_table(times):
    """Table 2; 'times' are (cells, fit label, paper s, ours s)."""
    body = [[cells, f"`{label}`", paper, f"{ours:.3g}" if ours else "-",
             f"{ours / float(paper):.1e}" if ours and paper else "", remark]
            for cells, label, paper, ours, remark in times]
    return markdown_table(["cells", "fit", "paper, s", "ours, s", "ratio", "remark"], body)


def sweep_summary(sweeps):
    """(cells, fit, E_out/E_in lowest and highest at nu 0.3, nu_out lowest, highest)."""
    body = []
    for cells in SWEEPS:
        fits = {}
        for row in sweeps.get(cells, []):
            fits.setdefault((row["fit"], row["enrichment"]), []).append(row)
        for (fit, enrichment), found in fits.items():
            label = fit if enrichment == "none" else f"{fit} + {enrichment}"
            nu_in = min({float(r["nu_in"]) for r in found}, key=lambda nu: abs(nu - 0.3))
            ratios = [float(r["E_out"]) / float(r["E_in"]) for r in found
                      if r["E_out"] and abs(float(r["nu_in"]) - nu_in) < 1e-9]
            nus = [round(float(r["nu_out"]), 9) for r in found if r["nu_out"]]
            if ratios and nus:
                body.append([cells, f"`{label}`", f"{min(ratios):.4f} to {max(ratios):.4f}",
                             f"{min(nus) + 0.:.3f} to {max(nus):.3f}"])
    return markdown_table(["cell", "fit", "E_out / E_in (nu_in = 0.3, all E_in)",
                   "nu_out (all nu_in)"], body)


def origin(top, program):
    """The machine, the version, the day."""
    version = subprocess.run([program, "--version"], capture_output=True, text=True)
    with open("/proc/cpuinfo") as file:
        models = [line.split(":")[1].strip() for line in file
                  if line.startswith("model name")]
    return (f"{', '.join(version.stdout.split(chr(10))[:2])}; {len(models)} x {models[0] if models else 'unknown'}, "
            f"{platform.system()}; {datetime.date.today().isoformat()}")


def publish(top, folder, name):
    """Ship the page of a folder of results, and its pictures, in doc/."""
    text = (folder / f"{name}.md").read_text()
    (top / "doc" / f"{name}.md").write_text(text.replace("](pictures/", f"]({name}/"))
    shipped = top / "doc" / name
    shutil.rmtree(shipped, ignore_errors=True)
    shipped.mkdir()
    for picture in (folder / "pictures").glob("*.svg"):
        shutil.copy(picture, shipped / picture.name)


def problems(experiments):
    found = [e for e in experiments if e.problem]
    if not found:
        return ""
    return ("\n## Runs with problems\n\n" +
            markdown_table(["run", "what it said"], [[f"`{e.name}`", e.problem] for e in found]))
