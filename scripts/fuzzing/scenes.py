"""What a case runs: a parameter file and, for most, a mesh."""
import dataclasses
import pathlib
import random
import re

import mutations
from meshes import KINDS, make_mesh
from writers import FORMATS

PARAMETERS = pathlib.Path(__file__).resolve().parents[2] / "parameters"
THICKNESS, DENSITY = 0.01, 1000.
# Of every ten cases three change a parameter file.
ALL_FORMATS = tuple(FORMATS) + ("prm",)
WEIGHTS = (1,) * len(FORMATS) + (6,)

# The shipped scenes with so few cells that a run takes a moment.
SHIPPED = {
    "bar": "0.01", "bracket": "0.02", "cube": "0.01", "cylinder_hexahedra": "0.01",
    "cylinder_tetrahedra": "0.01", "defaults_2d": "0.01", "defaults_3d": "0.01",
    "hollow_cylinder": "0.006", "specimen": "0.008", "square": "0.01",
    "sweep_hexahedron": None, "sweep_quadrilateral": None, "tissue": "0.005",
}
QUICK = {r"(set Methods +=).*": r"\1 frobenius", r"(set Study +=) compare": r"\1 calibrate",
         r"(in) (10|11|5)\b": r"\1 2"}


@dataclasses.dataclass
class Case:
    number: int
    format: str
    files: dict        # name: bytes
    options: list      # of the command line
    mutations: list    # their names
    dim: int = 0       # 0: of no mesh
    mesh: str = ""     # the name of the mesh file


def _mesh_scene(mesh, name):
    plane = f"  set Thickness = {THICKNESS}\n" if mesh.dim == 2 else ""
    geometry = ""
    if name.endswith(".geo"):
        kind = "tetrahedra" if mesh.kind == "hexahedra" else mesh.kind
        geometry = f"  set Cells = {kind}\n  set Cell size = 0.5\n"
    return (f"set Dimension = {mesh.dim}\nset Study = calibrate\n"
            f"set Output directory = results\nsubsection Geometry\n  set Object = file\n"
            f"  set File = {name}\n{geometry}end\nsubsection Material\n"
            f"  set Density = {DENSITY}\n{plane}end\n"
            "subsection Fit\n  set Methods = frobenius\nend\n").encode()


def _shipped_scene(name):
    text = (PARAMETERS / f"{name}.prm").read_text()
    text = "\n".join(line for line in text.splitlines()
                     if line.strip() and not line.strip().startswith("#")) + "\n"
    if SHIPPED[name]:
        text = re.sub(r"(set Cell size +=).*", rf"\1 {SHIPPED[name]}", text)
    for pattern, new in QUICK.items():
        text = re.sub(pattern, new, text)
    return text.encode()


def _is_slow(text):
    """Asks for so many cells that it takes long, but not for so many that it is refused."""
    def numbers(entry, default):
        found = re.search(rb"set[ \t]+%s[ \t]*=([^\n#]*)" % entry, text)
        try:
            return [float(word) for word in found.group(1).split(b",")] if found else default
        except ValueError:
            return default
    sizes, steps = numbers(b"Size", [0.02] * 3), numbers(b"Cell size", [0.0025])
    count = 8.5
    for d, size in enumerate(sizes):
        step = steps[d] if d < len(steps) else steps[0]
        count *= max(1., abs(size / step) if step else 1.)
    refinements = numbers(b"Refinements", [0.])[:1]
    if refinements and 0. < refinements[0] < 6.:
        count *= 8. ** refinements[0]
    return 3e4 < count < 1e9


def _changed_scene(chance):
    """Of a shipped scene, one that springfit refuses or runs in a moment."""
    while True:
        text, names = mutations.mutate(_shipped_scene(chance.choice(sorted(SHIPPED))),
                                       mutations.PRM, chance)
        if not _is_slow(text):
            return text, names


def make_case(seed, number):
    """The same for the same seed and number, whatever else runs."""
    chance = random.Random(f"springfit {seed} {number}")
    form = chance.choices(ALL_FORMATS, WEIGHTS)[0]
    if form == "prm":
        text, names = _changed_scene(chance)
        # Its results stay in the case's folder whatever the file says.
        return Case(number, form, {"x.prm": text,
                                   "bracket.geo": (PARAMETERS / "bracket.geo").read_bytes()},
                    ["--set", "Output directory=results"], names)
    mesh = make_mesh(chance.choice(sorted(KINDS)), chance.random() < 0.3)
    ending, write = FORMATS[form]
    binary = form.endswith("binary")
    data, names = mutations.mutate(write(mesh),
                                   mutations.BINARY if binary else mutations.TEXT, chance)
    name = "mesh" + ending
    return Case(number, form, {"x.prm": _mesh_scene(mesh, name), name: data}, [], names,
                mesh.dim, name)
