"""Second readers: the volume in a mesh file, and what is malformed in it.

They know nothing of gmsh and take a file at its word: whatever a format does not allow is
a problem of the file."""
import dataclasses
import math
import re

from writers import DIMENSION, N_NODES

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\Z")
INTEGER = re.compile(r"[+-]?\d+\Z")


class Malformed(Exception):
    """What follows cannot be read."""


class Unsure(Exception):
    """Beyond this reader, which then says nothing."""


@dataclasses.dataclass
class Content:
    nodes: dict = dataclasses.field(default_factory=dict)
    elements: list = dataclasses.field(default_factory=list)  # type, node numbers
    problems: list = dataclasses.field(default_factory=list)
    numbers: set = dataclasses.field(default_factory=set)

    def add_node(self, number, point):
        if number in self.nodes:
            self.problems.append(f"node {number} twice")
        self.nodes[number] = point

    def add_element(self, number, kind, nodes):
        if number is not None and number in self.numbers:
            self.problems.append(f"element {number} twice")
        self.numbers.add(number)
        self.elements.append((kind, tuple(nodes)))


def real(text, d_exponents=False):
    if d_exponents:
        text = text.replace("D", "E").replace("d", "e")
    if not NUMBER.match(text):
        raise Malformed(f"'{text}' is no number")
    value = float(text)
    if not math.isfinite(value):
        raise Malformed(f"'{text}' is too large")
    return value


def integer(text):
    if not INTEGER.match(text):
        raise Malformed(f"'{text}' is no whole number")
    return int(text)


class Words:
    """The words of a text, one after the other, wherever lines end."""

    def __init__(self, text):
        self.words = text.split()
        self.at = 0

    def next(self):
        if self.at >= len(self.words):
            raise Malformed("the text ends too early")
        self.at += 1
        return self.words[self.at - 1]

    def whole(self):
        return integer(self.next())

    def real(self):
        return real(self.next())

    def reals(self, n, d_exponents=False):
        return tuple(real(self.next(), d_exponents) for _ in range(n))

    def wholes(self, n):
        return [self.whole() for _ in range(n)]

    def expect_end(self):
        if self.at < len(self.words):
            raise Malformed(f"'{self.words[self.at]}' is left over")


def _n_nodes(kind):
    if kind not in N_NODES:
        raise Unsure(f"element type {kind}")
    return N_NODES[kind]


def _sections(text):
    """The sections of a .msh file by name; a word with a dollar ends one."""
    sections, name, lines = {}, None, []
    for line in text.splitlines():
        inside, dollar, word = line.partition("$")
        lines.append(inside)
        if not dollar:
            continue
        if name is not None:
            if name in sections:
                raise Malformed(f"section {name} twice")
            sections[name], name = "\n".join(lines), None
        word = word.split()[0] if word.split() else ""
        if not inside.strip() and not word.upper().startswith("END"):
            name = "NOD" if word == "NOE" else word
        lines = []
    if name is not None:
        raise Malformed(f"section {name} has no end")
    return sections


def _section(sections, name):
    if name not in sections:
        raise Malformed(f"there is no section {name}")
    return Words(sections[name])


def read_msh(text, content):
    sections = _sections(text)
    if "NOD" in sections:
        return _read_msh_lines(_section(sections, "NOD"), _section(sections, "ELM"), 1, content)
    words = _section(sections, "MeshFormat")
    version, binary = words.real(), words.whole()
    if binary:
        raise Unsure("binary")
    nodes, elements = _section(sections, "Nodes"), _section(sections, "Elements")
    if 2. <= version < 3.:
        return _read_msh_lines(nodes, elements, 2, content)
    if version == 4.1:
        return _read_msh41(nodes, elements, content)
    if version == 4.:
        return _read_msh40(nodes, elements, content)
    raise Unsure("version")


def _read_msh_lines(nodes, elements, version, content):
    for _ in range(nodes.whole()):
        content.add_node(nodes.whole(), nodes.reals(3))
    nodes.expect_end()
    for _ in range(elements.whole()):
        number, kind = elements.wholes(2)
        if version == 1:
            elements.wholes(2)
            if elements.whole() != _n_nodes(kind):
                raise Malformed(f"element {number} has another number of nodes than its type")
        else:
            elements.wholes(elements.whole())
        content.add_element(number, kind, elements.wholes(_n_nodes(kind)))
    elements.expect_end()


def _read_elements_of_block(words, dim, kind, n, content):
    if DIMENSION.get(kind, dim) != dim:
        raise Malformed("a block of cells of another dimension")
    for _ in range(n):
        content.add_element(words.whole(), kind, words.wholes(_n_nodes(kind)))


def _check_count(what, announced, found):
    if announced != found:
        raise Malformed(f"{announced} {what} announced, {found} found")


def _read_msh41(nodes, elements, content):
    n_blocks, n_nodes, _, _ = nodes.wholes(4)
    n_read = 0
    for _ in range(n_blocks):
        _, _, parametric, n = nodes.wholes(4)
        if parametric:
            raise Unsure("parametric nodes")
        numbers = nodes.wholes(n)
        for number in numbers:
            content.add_node(number, nodes.reals(3))
        n_read += n
    nodes.expect_end()
    _check_count("nodes", n_nodes, n_read)
    n_blocks, n_elements, _, _ = elements.wholes(4)
    n_read = 0
    for _ in range(n_blocks):
        dim, _, kind, n = elements.wholes(4)
        _read_elements_of_block(elements, dim, kind, n, content)
        n_read += n
    elements.expect_end()
    _check_count("elements", n_elements, n_read)


def _read_msh40(nodes, elements, content):
    n_blocks, n_nodes = nodes.wholes(2)
    n_read = 0
    for _ in range(n_blocks):
        _, _, parametric, n = nodes.wholes(4)
        if parametric:
            raise Unsure("parametric nodes")
        for _ in range(n):
            content.add_node(nodes.whole(), nodes.reals(3))
        n_read += n
    nodes.expect_end()
    _check_count("nodes", n_nodes, n_read)
    n_blocks, n_elements = elements.wholes(2)
    n_read = 0
    for _ in range(n_blocks):
        _, dim, kind, n = elements.wholes(4)
        _read_elements_of_block(elements, dim, kind, n, content)
        n_read += n
    elements.expect_end()
    _check_count("elements", n_elements, n_read)


def read_vtk(text, content):
    lines = text.splitlines()
    if len(lines) < 4:
        raise Malformed("no header")
    if lines[2].strip().upper() == "BINARY":
        raise Unsure("binary")
    if lines[2].strip().upper() != "ASCII":
        raise Malformed("neither ASCII nor BINARY")
    words = Words("\n".join(lines[3:]))
    if words.next().upper() != "DATASET" or words.next().upper() != "UNSTRUCTURED_GRID":
        raise Malformed("no unstructured grid")
    if words.next().upper() != "POINTS":
        raise Malformed("no points")
    n_points = words.whole()
    if words.next().lower() not in ("float", "double"):
        raise Unsure("type of the points")
    for i in range(n_points):
        content.add_node(i, words.reals(3, d_exponents=True))
    if words.next().upper() != "CELLS":
        raise Malformed("no cells after the points")
    n_cells, size = words.wholes(2)
    cells = []
    for _ in range(n_cells):
        cells.append(words.wholes(words.whole()))
    _check_count("numbers of cells", size, sum(len(cell) + 1 for cell in cells))
    if words.next().upper() != "CELL_TYPES":
        raise Malformed("no types after the cells")
    _check_count("types", words.whole(), n_cells)
    kinds = {3: 1, 5: 2, 9: 3, 10: 4, 12: 5}
    for cell in cells:
        kind = kinds.get(words.whole())
        if kind is None:
            raise Unsure("type of a cell")
        if len(cell) != N_NODES[kind]:
            raise Malformed("a cell has another number of nodes than its type")
        content.add_element(None, kind, cell)
    if words.at < len(words.words) and words.next().upper() not in ("CELL_DATA", "POINT_DATA",
                                                                    "METADATA"):
        raise Malformed(f"'{words.words[words.at - 1]}' after the types")


def read_medit(text, content):
    kinds = {"edges": 1, "triangles": 2, "quadrilaterals": 3, "tetrahedra": 4, "hexahedra": 5}
    words, seen, dim = Words(re.sub(r"#.*", "", text)), set(), None
    if words.next().lower() != "meshversionformatted":
        raise Malformed("no version")
    words.whole()
    while True:
        title = words.next().lower()
        if title in seen:
            raise Malformed(f"section {title} twice")
        seen.add(title)
        if title == "end":
            return
        if title == "dimension":
            dim = words.whole()
            if dim not in (2, 3):
                raise Malformed("dimension")
        elif title == "vertices":
            if dim != 3:
                raise Unsure("vertices in the plane")
            for i in range(1, words.whole() + 1):
                content.add_node(i, words.reals(3, d_exponents=True))
                words.whole()
        elif title in kinds:
            for _ in range(words.whole()):
                content.add_element(None, kinds[title], words.wholes(N_NODES[kinds[title]]))
                words.whole()
        else:
            raise Malformed(f"'{title}' is no section")


def _bdf_cards(text):
    """Each card's fields without the marks of continuation."""
    cards, ended = [], False
    for line in text.splitlines():
        line = line.split("$")[0].rstrip()
        if not line:
            continue
        if ended:
            raise Unsure("cards after ENDDATA")
        if "\t" in line:
            raise Unsure("tabs")
        if line.upper().startswith("ENDDATA"):
            ended = True
            continue
        if "," in line:
            fields = [field.strip() for field in line.split(",")]
            mark, data = fields[0], fields[1:9]
        else:
            fields = [line[i:i + 8].strip() for i in range(0, len(line), 8)]
            mark, data = fields[0], fields[1:9]
        if mark.endswith("*") or mark.startswith("*"):
            raise Unsure("fields of sixteen columns")
        if mark == "" or mark.startswith("+"):
            if not cards:
                raise Malformed("a continuation of nothing")
            cards[-1] += [""] * (8 - (len(cards[-1]) - 1) % 8 if (len(cards[-1]) - 1) % 8 else 0)
            cards[-1] += data
        else:
            cards.append([mark] + data)
    return cards


def bdf_real(text):
    """As 1.5, 1.5E3, 1.5D3 or 1.5+3; blank is zero."""
    text = text.upper().replace("D", "E")
    if text == "":
        return 0.
    if re.match(r"[+-]?[\d.]+[+-]\d+\Z", text):
        text = text[0] + re.sub(r"([+-])", r"E\1", text[1:])
    return real(text)


def read_bdf(text, content):
    kinds = {"CTRIA3": 2, "CQUAD4": 3, "CTETRA": 4, "CHEXA": 5}
    for card in _bdf_cards(text):
        name, fields = card[0].upper(), card[1:]
        while fields and fields[-1] == "":
            fields.pop()
        if name == "GRID":
            fields += [""] * (5 - len(fields))
            if fields[1] not in ("", "0"):
                raise Unsure("a system of coordinates")
            content.add_node(integer(fields[0]), tuple(bdf_real(x) for x in fields[2:5]))
        elif name in kinds:
            n = N_NODES[kinds[name]]
            if len(fields) < n + 2:
                raise Malformed(f"{name} has too few fields")
            if len(fields) > n + 2 and kinds[name] in (4, 5):
                raise Unsure(f"{name} has more nodes")
            content.add_element(integer(fields[0]), kinds[name],
                                [integer(node) for node in fields[2:2 + n]])
        elif name.startswith("C") and name != "CBAR":  # bars only name sides
            content.problems.append(f"'{name}' is no element")


def read_inp(text, content):
    word, kind, pending = "", None, []

    def close():
        if pending:
            raise Malformed("an element has too few nodes")
    for line in text.splitlines():
        if line.startswith("**") or not line.strip():
            continue
        if line.startswith("*"):
            close()
            pieces = [piece.strip() for piece in line[1:].split(",")]
            word = pieces[0].upper()
            if word in ("PART", "INSTANCE", "INCLUDE", "NGEN", "ELGEN", "NFILL", "SYSTEM"):
                raise Unsure(word)
            if word == "ELEMENT":
                settings = dict(piece.upper().partition("=")[::2] for piece in pieces[1:])
                settings = {key.strip(): value.strip() for key, value in settings.items()}
                name = settings.get("TYPE", "")
                kind = next((k for shape, k in (("T3D2", 1), ("CPS3", 2), ("CPS4", 3),
                                                ("S3", 2), ("S4", 3), ("C3D4", 4),
                                                ("C3D8", 5)) if name == shape), None)
                if kind is None:
                    raise Unsure("type of the elements")
            continue
        fields = [field.strip() for field in line.split(",")]
        if fields and fields[-1] == "":
            fields.pop()
        if word == "NODE":
            if not 1 <= len(fields) <= 7:
                raise Malformed("number of coordinates")
            point = [0. if x == "" else real(x, d_exponents=True) for x in fields[1:4]]
            content.add_node(integer(fields[0]), tuple(point + [0.] * (3 - len(point))))
        elif word == "ELEMENT":
            pending += [integer(field) for field in fields]
            if len(pending) > N_NODES[kind] + 1:
                raise Malformed("an element has too many nodes")
            if len(pending) == N_NODES[kind] + 1:
                content.add_element(pending[0], kind, pending[1:])
                pending = []
        elif word == "":
            raise Malformed("data before a keyword")
    close()


def read_unv(text, content):
    kinds = {21: 1, 11: 1, 91: 2, 41: 2, 94: 3, 44: 3, 111: 4, 115: 5}
    lines = [line for line in text.splitlines() if line.strip()]
    at = 0

    def take():
        nonlocal at
        if at >= len(lines):
            raise Malformed("the file ends within a dataset")
        at += 1
        return lines[at - 1].split()
    while at < len(lines):
        words = take()
        if words != ["-1"]:
            raise Malformed(f"'{' '.join(words)}' between datasets")
        dataset = take()
        while at < len(lines) and lines[at].split() != ["-1"]:
            if dataset == ["2411"]:
                head, point = take(), take()
                if len(head) != 4 or len(point) != 3:
                    raise Malformed("a node has other fields")
                content.add_node(integer(head[0]),
                                 tuple(real(x, d_exponents=True) for x in point))
            elif dataset == ["2412"]:
                head = take()
                if len(head) != 6:
                    raise Malformed("an element has other fields")
                head = [integer(word) for word in head]
                kind = kinds.get(head[1])
                if kind is None:
                    raise Unsure("type of an element")
                if kind == 1:
                    take()
                if head[5] != N_NODES[kind]:
                    raise Malformed("an element has another number of nodes than its type")
                nodes = take()
                if len(nodes) != head[5]:
                    raise Malformed("an element has too many or too few nodes")
                content.add_element(head[0], kind, [integer(node) for node in nodes])
            else:
                take()
        if take() != ["-1"]:
            raise Malformed("a dataset has no end")


READERS = {"msh1": read_msh, "msh2": read_msh, "msh4.0": read_msh, "msh4.1": read_msh,
           "vtk": read_vtk, "mesh": read_medit, "bdf": read_bdf, "bdf-free": read_bdf,
           "inp": read_inp, "unv": read_unv}


def _minus(a, b):
    return [x - y for x, y in zip(a, b)]


def _determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def _hexahedron(p):
    """With 2 x 2 x 2 points of Gauss, which are exact."""
    corners = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
               (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
    g, volume = 1 / math.sqrt(3), 0.
    for point in corners:
        columns = []
        for d in range(3):
            column = [0., 0., 0.]
            for corner, x in zip(corners, p):
                weight = corner[d] / 8
                for e in range(3):
                    if e != d:
                        weight *= 1 + corner[e] * g * point[e]
                column = [c + weight * y for c, y in zip(column, x)]
            columns.append(column)
        volume += _determinant(*columns)
    return volume


def volume_of_cell(kind, p):
    """Of triangles and quadrilaterals the area in the plane of x and y."""
    if kind in (2, 3):
        ring = list(zip(p, p[1:] + p[:1]))
        return abs(sum((a[0] - p[0][0]) * (b[1] - p[0][1]) - (a[1] - p[0][1]) * (b[0] - p[0][0])
                       for a, b in ring)) / 2
    if kind == 4:
        return abs(_determinant(*[_minus(x, p[0]) for x in p[1:]])) / 6
    return abs(_hexahedron(p))


def read(format_name, data, dim):
    """Volume or None where this reader is unsure, extents' product, problems."""
    content = Content()
    try:
        text = data.decode("ascii")
        if "\0" in text:
            raise Malformed("a byte 0")
        READERS[format_name](text, content)
        for _, nodes in content.elements:
            for node in nodes:
                if node not in content.nodes:
                    raise Malformed(f"node {node} is not there")
    except UnicodeDecodeError:
        return None, 0., []
    except Unsure:
        return None, 0., content.problems
    except Malformed as problem:
        return None, 0., content.problems + [str(problem)]
    if content.problems:
        return None, 0., content.problems
    volume, bound = 0., 0.
    for kind, nodes in content.elements:
        if DIMENSION[kind] == dim:
            points = [content.nodes[node] for node in nodes]
            volume += volume_of_cell(kind, points)
            bound += math.prod(max(abs(p[d]) for p in points) for d in range(dim))
    return volume, bound, []
