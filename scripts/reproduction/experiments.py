"""What scripts/reproduce runs: scenes of parameters/paper and their variants."""
import dataclasses


@dataclasses.dataclass
class Experiment:
    """One run of springfit, and what its rows are rows of."""
    name: str                       # of its folder
    scene: str                      # relative to the top folder
    object: str = ""
    cells: str = ""
    role: str = "tables"            # tables, large, shear, spread, sweep
    nonnegative: bool = False
    deformation_percent: int = 10
    law: str = "linear"             # of the finite elements
    options: tuple = ()             # for --set
    # Filled in by the run:
    problem: str = ""               # why there are no results
    seconds: float = 0.


OBJECTS = (
    ("tissue", "triangles"),
    ("tissue", "quadrilaterals"),
    ("cylinder", "tetrahedra"),
    ("cylinder", "hexahedra"),
    ("hollow cylinder", "tetrahedra"),
    ("cube", "tetrahedra"),
    ("cube", "hexahedra"),
    ("specimen", "triangles"),
    ("specimen", "quadrilaterals"),
    ("specimen", "tetrahedra"),
    ("specimen", "hexahedra"),
    ("square", "triangles"),
    ("square", "quadrilaterals"),
)

# Cell sizes (m) of meshes like the scene's own, where the published one is not
# known: about as many cells, but other ones.
SIMILAR_MESHES = {
    ("tissue", "triangles"):
        (0.00265, 0.0027, 0.00274, 0.0028, 0.00282, 0.00286, 0.0029, 0.00295),
    ("tissue", "quadrilaterals"):
        (0.00185, 0.00187, 0.0019, 0.00193, 0.00195, 0.00197, 0.00203, 0.00206),
    ("cylinder", "tetrahedra"):
        (0.0048, 0.00485, 0.0049, 0.00492, 0.00496, 0.005, 0.0051, 0.0052),
    ("hollow cylinder", "tetrahedra"):
        (0.0028, 0.00283, 0.00285, 0.00287, 0.0029, 0.00292, 0.00295, 0.003),
    ("cube", "tetrahedra"):
        (0.005, 0.00505, 0.0051, 0.00515, 0.0052, 0.00525, 0.00535, 0.0054),
    ("specimen", "triangles"):
        (0.0067, 0.0068, 0.0069, 0.007, 0.0071, 0.0072, 0.0073, 0.0074),
    # Structured: the other ones are cells of other proportions.
    ("specimen", "quadrilaterals"):
        ("0.0024, 0.003", "0.0028, 0.0025", "0.0031, 0.0025", "0.0034, 0.00214"),
    ("specimen", "hexahedra"):
        ("0.0024, 0.003, 0.0033", "0.0027, 0.0025, 0.0033", "0.0029, 0.0025, 0.0033",
         "0.0033, 0.00214, 0.0033"),
    ("specimen", "tetrahedra"):
        (0.0055, 0.0056, 0.0057, 0.0058, 0.0059, 0.006, 0.0061, 0.0063),
    ("square", "triangles"):
        (0.0023, 0.00235, 0.0024, 0.00245, 0.00255, 0.0026, 0.00265, 0.0027),
}

SPRINGS_ONLY = ("block", "frobenius", "spectral")
NONNEGATIVE = ("Fit/Nonnegative=true", "Fit/Methods=" + ", ".join(SPRINGS_ONLY),
               "Fit/Enrichment=none")
LAWS = ("linear", "st venant-kirchhoff", "neo-hookean")
# Table 6 with the springs' true forces. The cube of Baudet's springs, which have no
# diagonals in the faces, buckles before it is sheared so far.
SHEAR_PERCENT = (10, 20)
SHEAR_METHODS = {
    ("square", "triangles"): "gelder, lloyd, spectral",
    ("square", "quadrilaterals"): "baudet, lloyd, spectral",
    ("cube", "tetrahedra"): "lloyd, frobenius",
    ("cube", "hexahedra"): "spectral",
}
SWEEPS = {  # the scene and the methods of one cell
    "quadrilaterals": ("sweep_quadrilateral", "lloyd, baudet", "none, coupling"),
    "triangles": ("sweep_quadrilateral", "gelder, lloyd, delingette", "none, coupling"),
    "hexahedra": ("sweep_hexahedron", "baudet", "none, coupling"),
    "tetrahedra": ("sweep_hexahedron", "gelder, lloyd, golec", "none, volume"),
}


def is_of_paper(row):
    """Whether a row of a table is of springs as the paper has them: its fits with
    enrichments are those of scripts/enrichments."""
    return row["fit"] not in SPRINGS_ONLY or row["enrichment"] == "none"


def scene_of(object_, cells):
    return f"parameters/paper/{object_.replace(' ', '_')}_{cells}.prm"


def _variants(name, **common):
    """With free signs, and with k >= 0."""
    options = common.pop("options", ())
    yield Experiment(name, options=options, **common)
    yield Experiment(name + "_nonnegative", nonnegative=True,
                     options=options + NONNEGATIVE, **common)


def _large_deformation(cells):
    for law in LAWS:
        options = ("Loads/Deformation=0.3", "Loads/Cases=tension",
                   "Response/Kinematics=linear, nonlinear",
                   f"Response/Material law={law}",
                   "Fit/Methods=" + ", ".join(SPRINGS_ONLY), "Fit/Enrichment=none")
        yield from _variants(f"cube_{cells}_30_{law.replace(' ', '_')}",
                             scene=scene_of("cube", cells), object="cube",
                             cells=cells, role="large", law=law,
                             deformation_percent=30, options=options)


def _large_shear():
    for (object_, cells), methods in SHEAR_METHODS.items():
        for percent in SHEAR_PERCENT:
            options = (f"Loads/Deformation={percent / 100}", "Loads/Cases=shear",
                       "Response/Kinematics=linear, nonlinear", "Fit/Nonnegative=true",
                       "Fit/Methods=" + methods, "Fit/Enrichment=none")
            yield Experiment(f"{object_}_{cells}_shear_{percent}", scene_of(object_, cells),
                             object_, cells, role="shear", nonnegative=True,
                             deformation_percent=percent, options=options)


def all_experiments():
    experiments = []
    for object_, cells in OBJECTS:
        scene = scene_of(object_, cells)
        name = scene.split("/")[-1][:-4]
        common = {"scene": scene, "object": object_, "cells": cells}
        experiments += _variants(name, **common)
        for number, size in enumerate(SIMILAR_MESHES.get((object_, cells), ()), 1):
            experiments += _variants(f"{name}_mesh_{number}", role="spread",
                                     options=(f"Geometry/Cell size={size}",
                                              "Loads/Cases=tension, shear"), **common)
    for cells in ("tetrahedra", "hexahedra"):
        experiments += _large_deformation(cells)
    experiments += _large_shear()
    for cells, (scene, methods, enrichment) in SWEEPS.items():
        options = (f"Geometry/Cells={cells}", f"Fit/Enrichment={enrichment}",
                   "Fit/Methods=" + ", ".join(SPRINGS_ONLY) + ", " + methods)
        experiments.append(Experiment(f"sweep_{cells}", f"parameters/{scene}.prm",
                                      "one cell", cells, role="sweep", options=options))
    return experiments
