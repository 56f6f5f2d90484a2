"""Reads the VTU files that springfit writes (inline binary, zlib)."""
import base64
import re
import struct
import zlib

FORMATS = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt8": "B",
           "Int64": "q", "UInt64": "Q"}


def _numbers(kind, text):
    """The numbers of one DataArray: a header, then compressed blocks."""
    text = text.strip()
    n_blocks, = struct.unpack("<I", base64.b64decode(text[:8])[:4])
    n_header = 4 * (3 + n_blocks)
    n_text = 4 * ((n_header + 2) // 3)
    header = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(text[:n_text])[:n_header])
    packed = base64.b64decode(text[n_text:])
    data, begin = b"", 0
    for size in header[3:]:
        data += zlib.decompress(packed[begin:begin + size])
        begin += size
    letter = FORMATS[kind]
    return struct.unpack(f"<{len(data) // struct.calcsize(letter)}{letter}", data)


def read_vtu(path):
    """Arrays by name; vectors are lists of triples. The points are 'points'."""
    arrays = {}
    with open(path) as file:
        text = file.read()
    for attributes, body in re.findall(r"<DataArray([^>]*)>([^<]*)</DataArray>", text):
        attribute = dict(re.findall(r'(\w+)="([^"]*)"', attributes))
        values = _numbers(attribute["type"], body)
        if attribute.get("NumberOfComponents") == "3":
            values = [values[i:i + 3] for i in range(0, len(values), 3)]
        arrays[attribute.get("Name", "points")] = values
    return arrays
