"""Reads voxels line by line as DAMASK 3 does (src/grid/VTI.f90), and asserts the conditions of that reader."""

import base64
import math
import re
import struct
import zlib


def attribute(line, key):
    found = re.findall(rf' {key}="([^"]*)"', line)
    return found[-1] if found else ""


def read_vti(text):
    """Returns counts, size, origin and the list of materials, as DAMASK 3 reads them."""
    lines = iter(text.split("\n"))
    head = next(line for line in lines if "<VTKFile" in line)
    assert attribute(head, "type") == "ImageData" and attribute(head, "byte_order") == "LittleEndian"
    assert attribute(head, "compressor") in ("", "vtkZLibDataCompressor")
    integer = "Q" if attribute(head, "header_type") == "UInt64" else "I"
    width = struct.calcsize(integer)
    image = next(line for line in lines if "<ImageData" in line)
    assert attribute(image, "Direction") == "1 0 0 0 1 0 0 0 1"
    extent = [int(word) for word in attribute(image, "WholeExtent").split()]
    assert extent[::2] == [0, 0, 0]
    counts = extent[1::2]
    assert counts[0] > 1
    spacing = [float(word) for word in attribute(image, "Spacing").split()]
    origin = [float(word) for word in attribute(image, "Origin").split()]
    next(line for line in lines if "<CellData>" in line)
    array = next(line for line in lines if "<DataArray" in line and attribute(line, "Name") == "material")
    assert attribute(array, "format") == "binary" and attribute(array, "type") == "Int32"
    data = next(lines).strip()

    def digits(n_bytes):
        return 4 * math.ceil(n_bytes / 3)

    def header(n):
        return struct.unpack(f"<{n}{integer}", base64.b64decode(data[:digits(n * width)])[:n * width])

    n_blocks = header(1)[0]
    _, size, last, *packed_sizes = header(3 + n_blocks)
    packed = base64.b64decode(data[digits((3 + n_blocks) * width):])
    blocks = []
    for packed_size in packed_sizes:
        blocks.append(zlib.decompress(packed[:packed_size]))
        packed = packed[packed_size:]
    assert not packed and all(len(block) == size for block in blocks[:-1])
    assert len(blocks[-1]) == (last or size)
    content = b"".join(blocks)
    materials = struct.unpack(f"<{len(content) // 4}i", content)
    assert len(materials) == math.prod(counts)
    return counts, [s * n for s, n in zip(spacing, counts)], origin, materials
