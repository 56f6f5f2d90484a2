"""The table of errors at 30 % deformation, of fits at rest and over several states."""
import page
from runs import comparison_rows
from scenes import OBJECTS, command

ENRICHMENTS = ("none", "volume", "coupling")


def _errors(rows, enrichment):
    found = [float(row["e_rms_percent"]) for row in rows if row["enrichment"] == enrichment]
    if not found:
        return "-"
    return "exact" if max(found) < 1e-6 else " / ".join(f"{value:.2f}" for value in found)


def table(runs, folder):
    """'runs' are all of them, 'folder' is where they are."""
    body = []
    for object_, cells in OBJECTS:
        name = f"{object_}, {cells}"
        for run in runs:
            if (run.role, run.object, run.cells) != ("large", object_, cells):
                continue
            rows = [row for row in comparison_rows([run], folder) if row["fit"] != "fem"]
            body.append([name, run.law, run.title,
                         *(_errors(rows, enrichment) for enrichment in ENRICHMENTS)])
            name = ""
    return page.markdown_table(
        ["object", "material", "springs, fitted", "springs alone", "+ volume", "+ coupling"], body)


def example(runs):
    """What a reader types for one of the rows."""
    return command(next(run for run in runs if run.role == "large" and run.cells == "tetrahedra"
                        and run.title == "quadratic, stretched too"))
