"""Small meshes, the seeds of the mutated files."""
import dataclasses
import itertools
import random

# gmsh's number of the cells and of their sides.
KINDS = {"triangles": (2, 1), "quadrilaterals": (3, 1),
         "tetrahedra": (4, 2), "hexahedra": (5, 3)}
GROUPS = {1: "left", 2: "right", 3: "skin", 4: "core"}


@dataclasses.dataclass
class Element:
    number: int
    type: int     # gmsh's
    group: int    # of GROUPS
    nodes: tuple  # node numbers, in gmsh's order


@dataclasses.dataclass
class Mesh:
    kind: str
    nodes: dict     # number: (x, y, z)
    elements: list  # sides first

    @property
    def dim(self):
        return 2 if self.kind in ("triangles", "quadrilaterals") else 3

    def of_group(self, group):
        return [element for element in self.elements if element.group == group]


def _grid(counts):
    return itertools.product(*[range(n) for n in reversed(counts)])


def _cells_of_box(kind, corner):
    """The cells in one box of the grid; corner(a, b, c) is a node."""
    if kind == "triangles":
        a, b, c, d = corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)
        return [(a, b, c), (a, c, d)]
    if kind == "quadrilaterals":
        return [(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1))]
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    if kind == "hexahedra":
        return [tuple(corner(*xy, z) for z in (0, 1) for xy in ring)]
    # Six tetrahedra about the diagonal; those of odd permutations turned.
    cells = []
    for axes in itertools.permutations(range(3)):
        at, path = [0, 0, 0], [(0, 0, 0)]
        for axis in axes:
            at[axis] = 1
            path.append(tuple(at))
        if axes in ((1, 0, 2), (0, 2, 1), (2, 1, 0)):
            path[1], path[2] = path[2], path[1]
        cells.append(tuple(corner(*point) for point in path))
    return cells


def _faces(kind, cell):
    local = {"triangles": ((0, 1), (1, 2), (2, 0)),
             "quadrilaterals": ((0, 1), (1, 2), (2, 3), (3, 0)),
             "tetrahedra": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
             "hexahedra": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5),
                           (2, 3, 7, 6), (3, 0, 4, 7))}[kind]
    return [tuple(cell[v] for v in face) for face in local]


def make_mesh(kind, gaps):
    """Some 4 to 12 cells; the inner nodes, and those on no named side, are jittered.
    With gaps the node numbers are not consecutive."""
    plane = kind in ("triangles", "quadrilaterals")
    boxes = (3, 2, 0) if plane else (2, 2, 1) if kind == "hexahedra" else (2, 1, 1)
    chance = random.Random(kind)
    numbers, nodes = {}, {}
    for z, y, x in _grid([n + 1 for n in boxes]):
        numbers[x, y, z] = 7 * len(numbers) + 3 if gaps else len(numbers) + 1
        shift = [0.2 * (chance.random() - 0.5) if 0 < x < boxes[0] else 0. for _ in range(2)]
        nodes[numbers[x, y, z]] = (round(x / 2 + shift[0], 6), round(y / 2 + shift[1], 6),
                                   z / 2)
    sides, cells = [], []
    for z, y, x in _grid([max(n, 1) for n in boxes]):
        def corner(i, j, k=0, x=x, y=y, z=z):
            return numbers[x + i, y + j, z + k]
        for cell in _cells_of_box(kind, corner):
            cells.append((3 if x == 0 else 4, cell))
            for face in _faces(kind, cell):
                ends = {nodes[node][0] for node in face}
                if ends in ({0.}, {boxes[0] / 2}):
                    sides.append((1 if ends == {0.} else 2, face))
    cell_type, side_type = KINDS[kind]
    elements = [Element(i, side_type, group, face)
                for i, (group, face) in enumerate(sorted(sides), 1)]
    elements += [Element(i, cell_type, group, cell)
                 for i, (group, cell) in enumerate(sorted(cells), len(elements) + 1)]
    return Mesh(kind, nodes, elements)
