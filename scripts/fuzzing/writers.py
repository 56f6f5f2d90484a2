"""Writes a mesh in every format that springfit reads."""
import struct

from meshes import GROUPS

N_NODES = {1: 2, 2: 3, 3: 4, 4: 4, 5: 8}
DIMENSION = {1: 1, 2: 2, 3: 2, 4: 3, 5: 3}


def _words(*values):
    return " ".join(str(value) for value in values)


def _text(lines):
    return ("\n".join(lines) + "\n").encode()


def _blocks(mesh):
    """Group, type and elements of each group."""
    for group in sorted(GROUPS):
        elements = mesh.of_group(group)
        if elements:
            yield group, elements[0].type, elements


def _names(mesh):
    lines = ["$PhysicalNames", str(sum(1 for _ in _blocks(mesh)))]
    lines += [f'{DIMENSION[kind]} {group} "{GROUPS[group]}"' for group, kind, _ in _blocks(mesh)]
    return lines + ["$EndPhysicalNames"]


def msh1(mesh):
    lines = ["$NOD", str(len(mesh.nodes))]
    lines += [_words(number, *point) for number, point in mesh.nodes.items()]
    lines += ["$ENDNOD", "$ELM", str(len(mesh.elements))]
    lines += [_words(e.number, e.type, e.group, e.group, len(e.nodes), *e.nodes)
              for e in mesh.elements]
    return _text(lines + ["$ENDELM"])


def msh2(mesh):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", *_names(mesh), "$Nodes",
             str(len(mesh.nodes))]
    lines += [_words(number, *point) for number, point in mesh.nodes.items()]
    lines += ["$EndNodes", "$Elements", str(len(mesh.elements))]
    lines += [_words(e.number, e.type, 2, e.group, e.group, *e.nodes) for e in mesh.elements]
    return _text(lines + ["$EndElements"])


def msh2_binary(mesh):
    data = b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n"
    data += _text(_names(mesh)) + b"$Nodes\n%d\n" % len(mesh.nodes)
    for number, point in mesh.nodes.items():
        data += struct.pack("<i3d", number, *point)
    data += b"\n$EndNodes\n$Elements\n%d\n" % len(mesh.elements)
    for group, kind, elements in _blocks(mesh):
        data += struct.pack("<3i", kind, len(elements), 2)
        for e in elements:
            data += struct.pack(f"<{3 + len(e.nodes)}i", e.number, group, group, *e.nodes)
    return data + b"\n$EndElements\n"


def _corners(mesh):
    points = list(mesh.nodes.values())
    return [end(point[d] for point in points) for end in (min, max) for d in range(3)]


def _entity_counts(mesh):
    dims = [DIMENSION[kind] for _, kind, _ in _blocks(mesh)]
    return [dims.count(d) for d in range(4)]


def msh40(mesh):
    lines = ["$MeshFormat", "4 0 8", "$EndMeshFormat", *_names(mesh), "$Entities",
             _words(*_entity_counts(mesh))]
    lines += [_words(group, *_corners(mesh), 1, group, 0) for group, _, _ in _blocks(mesh)]
    lines += ["$EndEntities", "$Nodes", _words(1, len(mesh.nodes)),
              _words(3, mesh.dim, 0, len(mesh.nodes))]
    lines += [_words(number, *point) for number, point in mesh.nodes.items()]
    lines += ["$EndNodes", "$Elements",
              _words(sum(1 for _ in _blocks(mesh)), len(mesh.elements))]
    for group, kind, elements in _blocks(mesh):
        lines.append(_words(group, DIMENSION[kind], kind, len(elements)))
        lines += [_words(e.number, *e.nodes) for e in elements]
    return _text(lines + ["$EndElements"])


def msh41(mesh):
    count = sum(1 for _ in _blocks(mesh))
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", *_names(mesh), "$Entities",
             _words(*_entity_counts(mesh))]
    lines += [_words(group, *_corners(mesh), 1, group, 0) for group, _, _ in _blocks(mesh)]
    lines += ["$EndEntities", "$Nodes",
              _words(1, len(mesh.nodes), min(mesh.nodes), max(mesh.nodes)),
              _words(mesh.dim, 3, 0, len(mesh.nodes))]
    lines += [str(number) for number in mesh.nodes]
    lines += [_words(*point) for point in mesh.nodes.values()]
    lines += ["$EndNodes", "$Elements",
              _words(count, len(mesh.elements), 1, len(mesh.elements))]
    for group, kind, elements in _blocks(mesh):
        lines.append(_words(DIMENSION[kind], group, kind, len(elements)))
        lines += [_words(e.number, *e.nodes) for e in elements]
    return _text(lines + ["$EndElements"])


def msh41_binary(mesh):
    data = b"$MeshFormat\n4.1 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n"
    data += _text(_names(mesh)) + b"$Entities\n" + struct.pack("<4Q", *_entity_counts(mesh))
    for group, _, _ in _blocks(mesh):
        data += struct.pack("<i6dQiQ", group, *_corners(mesh), 1, group, 0)
    data += b"\n$EndEntities\n$Nodes\n"
    data += struct.pack("<4Q", 1, len(mesh.nodes), min(mesh.nodes), max(mesh.nodes))
    data += struct.pack("<3iQ", mesh.dim, 3, 0, len(mesh.nodes))
    data += struct.pack(f"<{len(mesh.nodes)}Q", *mesh.nodes)
    for point in mesh.nodes.values():
        data += struct.pack("<3d", *point)
    data += b"\n$EndNodes\n$Elements\n"
    data += struct.pack("<4Q", sum(1 for _ in _blocks(mesh)), len(mesh.elements), 1,
                        len(mesh.elements))
    for group, kind, elements in _blocks(mesh):
        data += struct.pack("<3iQ", DIMENSION[kind], group, kind, len(elements))
        for e in elements:
            data += struct.pack(f"<{1 + len(e.nodes)}Q", e.number, *e.nodes)
    return data + b"\n$EndElements\n"


VTK_TYPES = {1: 3, 2: 5, 3: 9, 4: 10, 5: 12}


def _vtk_cells(mesh):
    place = {number: i for i, number in enumerate(mesh.nodes)}
    return [[len(e.nodes), *[place[node] for node in e.nodes]] for e in mesh.elements]


def vtk(mesh):
    cells = _vtk_cells(mesh)
    lines = ["# vtk DataFile Version 2.0", "a small mesh", "ASCII",
             "DATASET UNSTRUCTURED_GRID", f"POINTS {len(mesh.nodes)} double"]
    lines += [_words(*point) for point in mesh.nodes.values()]
    lines += ["", f"CELLS {len(cells)} {sum(len(cell) for cell in cells)}"]
    lines += [_words(*cell) for cell in cells]
    lines += ["", f"CELL_TYPES {len(cells)}"]
    lines += [str(VTK_TYPES[e.type]) for e in mesh.elements]
    lines += ["", f"CELL_DATA {len(cells)}", "SCALARS CellEntityIds int 1",
              "LOOKUP_TABLE default"]
    return _text(lines + [str(e.group) for e in mesh.elements])


def vtk_binary(mesh):
    cells = _vtk_cells(mesh)
    numbers = [number for cell in cells for number in cell]
    data = (b"# vtk DataFile Version 2.0\na small mesh\nBINARY\n"
            b"DATASET UNSTRUCTURED_GRID\nPOINTS %d double\n" % len(mesh.nodes))
    for point in mesh.nodes.values():
        data += struct.pack(">3d", *point)
    data += b"\nCELLS %d %d\n" % (len(cells), len(numbers))
    data += struct.pack(f">{len(numbers)}i", *numbers)
    data += b"\nCELL_TYPES %d\n" % len(cells)
    return data + struct.pack(f">{len(cells)}i", *[VTK_TYPES[e.type] for e in mesh.elements]) \
        + b"\n"


def inp(mesh):
    names = {1: "T3D2", 2: "CPS3", 3: "CPS4", 4: "C3D4", 5: "C3D8"}
    if mesh.dim == 3:
        names.update({2: "S3", 3: "S4"})
    lines = ["*Heading", " a small mesh", "*NODE"]
    lines += [", ".join(map(str, (number, *point))) for number, point in mesh.nodes.items()]
    for group, kind, elements in _blocks(mesh):
        lines.append(f"*ELEMENT, type={names[kind]}, ELSET={GROUPS[group]}")
        lines += [", ".join(map(str, (e.number, *e.nodes))) for e in elements]
    return _text(lines)


def unv(mesh):
    types = {1: 21, 2: 91, 3: 94, 4: 111, 5: 115}
    lines = ["    -1", "  2411"]
    for number, point in mesh.nodes.items():
        lines.append("%10d%10d%10d%10d" % (number, 1, 1, 11))
        lines.append("".join("%25.16E" % x for x in point).replace("E", "D"))
    lines += ["    -1", "    -1", "  2412"]
    for e in mesh.elements:
        lines.append("%10d%10d%10d%10d%10d%10d"
                     % (e.number, types[e.type], e.group, 0, 7, len(e.nodes)))
        if e.type == 1:
            lines.append("%10d%10d%10d" % (0, 0, 0))
        lines.append("".join("%10d" % node for node in e.nodes))
    lines += ["    -1", "    -1", "  2477"]
    for group, _, elements in _blocks(mesh):
        lines.append("%10d%10d%10d%10d%10d%10d%10d%10d"
                     % (group, 0, 0, 0, 0, 0, 0, len(elements)))
        lines.append(GROUPS[group])
        pieces = ["%10d%10d%10d%10d" % (8, e.number, 0, 0) for e in elements]
        lines += ["".join(pieces[i:i + 2]) for i in range(0, len(pieces), 2)]
    return _text(lines + ["    -1"])


def medit(mesh):
    titles = {1: "Edges", 2: "Triangles", 3: "Quadrilaterals", 4: "Tetrahedra", 5: "Hexahedra"}
    place = {number: i for i, number in enumerate(mesh.nodes, 1)}
    lines = [" MeshVersionFormatted 2", " Dimension", " 3", " Vertices", f" {len(mesh.nodes)}"]
    lines += [" " + _words(*point, 1) for point in mesh.nodes.values()]
    for kind in sorted({e.type for e in mesh.elements}):
        elements = [e for e in mesh.elements if e.type == kind]
        lines += [" " + titles[kind], f" {len(elements)}"]
        lines += [" " + _words(*[place[node] for node in e.nodes], e.group) for e in elements]
    return _text(lines + [" End"])


BDF_CARDS = {1: "CBAR", 2: "CTRIA3", 3: "CQUAD4", 4: "CTETRA", 5: "CHEXA"}


def _bdf(mesh, card):
    lines = ["$ a small mesh"]
    for number, point in mesh.nodes.items():
        lines += card(["GRID", number, 0, *["%.5f" % x for x in point]])
    for e in mesh.elements:
        fields = [BDF_CARDS[e.type], e.number, e.group, *e.nodes]
        lines += card(fields + ["0.", "0.", "0."] if e.type == 1 else fields)
    return _text(lines + ["ENDDATA"])


def bdf(mesh):
    """Fields of eight columns; the ninth field marks a continuation."""
    def card(fields):
        texts = ["%-8s" % field for field in fields]
        if len(texts) <= 9:
            return ["".join(texts)]
        mark = "%-8s" % f"+E{fields[1]}"
        return ["".join(texts[:9]) + mark, mark + "".join(texts[9:])]
    return _bdf(mesh, card)


def bdf_free(mesh):
    """Fields between commas."""
    def card(fields):
        texts = [str(field) for field in fields]
        if len(texts) <= 9:
            return [",".join(texts)]
        mark = f"+E{fields[1]}"
        return [",".join(texts[:9] + [mark]), ",".join([mark] + texts[9:])]
    return _bdf(mesh, card)


def geo(mesh):
    """Not the mesh but a geometry that gmsh meshes with a few cells."""
    lines = ["// A plate or a block, with names.", "lc = 0.5;"]
    for i, (x, y) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)), 1):
        lines.append(f"Point({i}) = {{{x}, {y}, 0, lc}};")
    lines += [f"Line({i}) = {{{i}, {i % 4 + 1}}};" for i in range(1, 5)]
    lines += ["Curve Loop(1) = {1, 2, 3, 4};", "Plane Surface(1) = {1};"]
    if mesh.dim == 2:
        lines += ['Physical Curve("left", 1) = {4};', 'Physical Curve("right", 2) = {2};',
                  'Physical Surface("skin", 3) = {1};']
    else:
        lines += ["out[] = Extrude {0, 0, 1} { Surface{1}; };",
                  'Physical Surface("left", 1) = {out[5]};',
                  'Physical Surface("right", 2) = {out[3]};',
                  'Physical Volume("skin", 3) = {out[1]};']
    if mesh.kind == "quadrilaterals":
        lines += ["Transfinite Surface {1};", "Recombine Surface {1};"]
    if mesh.kind == "hexahedra":
        lines += ["For i In {0 : 1}", "  Printf(\"%g\", i);", "EndFor"]
    return _text(lines)


# Name of the format: ending, how it is written.
FORMATS = {
    "msh1": (".msh", msh1), "msh2": (".msh", msh2), "msh2-binary": (".msh", msh2_binary),
    "msh4.0": (".msh", msh40), "msh4.1": (".msh", msh41),
    "msh4.1-binary": (".msh", msh41_binary), "vtk": (".vtk", vtk),
    "vtk-binary": (".vtk", vtk_binary), "inp": (".inp", inp), "unv": (".unv", unv),
    "mesh": (".mesh", medit), "bdf": (".bdf", bdf), "bdf-free": (".bdf", bdf_free),
    "geo": (".geo", geo),
}
