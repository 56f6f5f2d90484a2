"""Reads the VTU files that springfit writes (inline binary, zlib)."""
import base64
import dataclasses
import struct
import xml.etree.ElementTree
import zlib

FORMATS = {"Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}


@dataclasses.dataclass
class Grid:
    """Data are by names: a number, or a tuple of them, for each point or cell."""
    points: list
    cells: list  # tuples of points, in VTK's order
    types: list
    point_data: dict
    cell_data: dict


def _values(array):
    """Those of a DataArray: a header, then blocks, compressed one by one."""
    text = array.text.strip()
    n_blocks, = struct.unpack("<I", base64.b64decode(text[:8])[:4])
    n_text = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    _, size, last, *lengths = struct.unpack(f"<{3 + n_blocks}I",
                                            base64.b64decode(text[:n_text], validate=True))
    packed = base64.b64decode(text[n_text:], validate=True)
    blocks, begin = [], 0
    for length in lengths:
        blocks.append(zlib.decompress(packed[begin:begin + length]))
        begin += length
    if begin != len(packed) or [len(block) for block in blocks] != (
            [size] * (n_blocks - (last > 0)) + [last] * (last > 0)):
        raise ValueError("the header does not fit to its blocks")
    data, letter = b"".join(blocks), FORMATS[array.get("type")]
    values = list(struct.unpack(f"<{len(data) // struct.calcsize(letter)}{letter}", data))
    n = int(array.get("NumberOfComponents", 1))
    return values if n == 1 else list(zip(*(values[d::n] for d in range(n))))


def read_vtu(path):
    file = xml.etree.ElementTree.parse(path).getroot()
    if (file.get("type"), file.get("byte_order"), file.get("header_type"),
            file.get("compressor")) != ("UnstructuredGrid", "LittleEndian", "UInt32",
                                        "vtkZLibDataCompressor"):
        raise ValueError("not a file of springfit")
    piece = file.find("UnstructuredGrid/Piece")

    def arrays(section):
        return {array.get("Name"): _values(array) for array in piece.find(section)}

    points, = arrays("Points").values()
    cells = arrays("Cells")
    ends, nodes = cells["offsets"], cells["connectivity"]
    grid = Grid(points, [tuple(nodes[begin:end]) for begin, end in zip([0] + ends, ends)],
                cells["types"], arrays("PointData"), arrays("CellData"))
    sizes = [len(grid.points), len(grid.types)]
    if sizes != [int(piece.get(f"NumberOf{what}")) for what in ("Points", "Cells")] or any(
            len(values) != size for size, data in zip(sizes, (grid.point_data, grid.cell_data))
            for values in data.values()):
        raise ValueError("not a value for each point or cell")
    return grid
