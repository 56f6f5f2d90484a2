"""What scripts/reproduce runs: scenes of parameters/paper and their variants."""
import dataclasses

PLANE = ("triangles", "quadrilaterals")


@dataclasses.dataclass
class Experiment:
    """One run of springfit, and what its rows are rows of."""
    name: str                       # of its folder
    scene: str                      # relative to the top folder
    object: str = ""
    cells: str = ""
    role: str = "tables"            # tables, large, spread, sweep
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

# Cell sizes (m) of meshes like the scene's own, where gmsh makes them: about
# as many cells, but other ones.
SIMILAR_MESHES = {
    ("cylinder", "tetrahedra"):
        (0.0048, 0.00485, 0.0049, 0.00492, 0.00496, 0.005, 0.0051, 0.0052),
    ("cube", "tetrahedra"):
        (0.005, 0.00505, 0.0051, 0.00515, 0.0052, 0.00525, 0.00535, 0.0054),
}

SPRINGS_ONLY = ("block", "frobenius", "spectral")
NONNEGATIVE = ("Fit/Nonnegative=true", "Fit/Methods=" + ", ".join(SPRINGS_ONLY),
               "Fit/Enrichment=none")
LAWS = ("linear", "st venant-kirchhoff", "neo-hookean")
SWEEPS = PLANE + ("tetrahedra", "hexahedra")


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
    experiments += [Experiment(f"sweep_{cells}", f"parameters/paper/sweep_{cells}.prm",
                               "one cell", cells, role="sweep") for cells in SWEEPS]
    return experiments
