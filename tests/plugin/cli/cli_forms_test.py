"""The options that choose the form of a file: --glb-nodes, --float32, --pixels, --cut."""

import json
import re
import struct
import zlib
from collections import Counter

from support.cli import CliTest, main

OBLIQUE = ("--lattice", "1,0,0.37,0.81")
RUN = ("mesh", "--sites", 40, "--tolerance", "1e-3", "--quiet", "--force")


def glb_json(data):
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


def pixels(data):
    """Returns the rows of an RGB image as bytes, decoded without the code under test."""
    chunks, at = {}, 8
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        chunks[kind] = chunks.get(kind, b"") + data[at + 8:at + 8 + size]
        at += size + 12
    width, height = struct.unpack_from(">II", chunks[b"IHDR"])
    packed, rows, before = zlib.decompress(chunks[b"IDAT"]), [], bytes(3 * width)
    for y in range(height):
        kind, *line = packed[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        row = bytearray()
        for k, value in enumerate(line):
            left, above = row[k - 3] if k > 2 else 0, before[k]
            corner = before[k - 3] if k > 2 else 0
            guess = left + above - corner
            paeth = min((left, above, corner), key=lambda p: abs(guess - p))
            row.append(value + (0, left, above, (left + above) // 2, paeth)[kind] & 0xff)
        before = bytes(row)
        rows.append(before)
    return rows


class Forms(CliTest):
    def test_glb_has_a_node_for_each_cell_or_one_for_all(self):
        for mesh, options, expected in (("voronoi", (), 42), ("grains", (), 3),
                                        ("voronoi", ("--glb-nodes", "one"), 3),
                                        ("grains", ("--glb-nodes", "cells"), 42)):
            self.succeed(*RUN, *OBLIQUE, "--mesh", mesh, *options, "-o", "t.glb", "-o", "t.gltf")
            root = glb_json(self.contents()["t.glb"])
            self.assertEqual(len(root["nodes"]), expected)
            for line in self.succeed("check", "t.glb", "t.gltf").splitlines():
                self.assertRegex(line, r" 0 merged, stored vertex pairs agree, [0-9]+ sites agree$")
            if mesh == "voronoi":
                self.assertIn("centroidal Voronoi within", self.succeed("check", "t.glb", "--cvt", "0.01"))
        self.succeed("mesh", "--sites", 2001, "--max-iterations", 3, "-o", "large.glb")
        self.assertEqual(len(glb_json(self.contents()["large.glb"])["nodes"]), 3)

    def test_float32_writes_triangles_that_check_accepts(self):
        self.succeed(*RUN, *OBLIQUE, "--mesh", "voronoi", "--mesh", "grains", "--float32", "-o", "t.ply",
                     "-o", "t.obj")
        for name in ("t-voronoi.ply", "t-grains.ply"):
            text = self.path(name).read_text()
            self.assertIn("property float x\n", text)
            n_vertices, n_faces = (int(re.search(name + r" (\d+)", text)[1]) for name in ("vertex", "face"))
            faces = text.split("end_header\n")[1].splitlines()[n_vertices:n_vertices + n_faces]
            self.assertEqual({line.split()[0] for line in faces}, {"3"})
        line = self.succeed("check", "t-voronoi.ply", "--cvt", "0.01")
        self.assertRegex(line, r"tolerance 4\.7.*e-07\), 0 merged, stored vertex pairs agree, .*centroidal")

    def test_an_image_of_a_period_repeats_and_ignores_the_place_of_the_tile(self):
        run = (*RUN, "--period", "2,1", "--pixels", 128)
        self.succeed(*run, "-o", "t.png")
        rows = pixels(self.contents()["t.png"])
        self.assertEqual((len(rows), len(rows[0])), (64, 3 * 128))

        def step(x, y):
            return sum(abs(row[3 * x + k] - row[3 * y + k]) for row in rows for k in range(3))

        self.assertLessEqual(step(127, 0), max(step(x, x + 1) for x in range(127)))
        for options in (("--origin", "0.3,7.9"), ("--outline", "box")):
            self.succeed(*run, *options, "-o", "other.png")
            other = pixels(self.contents()["other.png"])
            differ = sum(a != b for row, moved in zip(rows, other) for a, b in zip(row, moved))
            self.assertLessEqual(differ, 30)
        self.succeed(*RUN, "-o", "t.png")
        self.assertEqual(len(pixels(self.contents()["t.png"])), 1024)

    def test_files_for_cutters_have_each_edge_once(self):
        self.succeed(*RUN, "--outline", "box", "--cut", 300, "-o", "t.svg", "-o", "t.dxf", "-o", "t.obj")
        faces = [[word.split("/")[0] for word in line.split()[1:]]
                 for line in self.path("t.obj").read_text().splitlines() if line.startswith("f ")]
        uses = Counter(frozenset(edge) for face in faces for edge in zip(face, face[1:] + face[:1]))
        svg, dxf = self.path("t.svg").read_text(), self.path("t.dxf").read_text()
        self.assertRegex(svg, r'<svg [^>]*width="300mm" height="300mm" viewBox="0 0 300 300"')
        self.assertEqual(svg.count("<path "), len(uses))
        self.assertEqual(len(set(re.findall(r"<path .*", svg))), len(uses))
        self.assertEqual(dxf.count("\nLINE\n"), len(uses))
        self.assertEqual(dxf.count("\n8\nSEAM\n"), sum(n == 1 for n in uses.values()))

    def test_options_that_no_output_takes_are_refused(self):
        for options, remedy in ((("--glb-nodes", "one"), r"glTF nodes.*\.glb or \.gltf"),
                                (("--float32",), r"32-bit.*\.ply"),
                                (("--pixels", 9), r"pixels.*\.png"),
                                (("--cut", 9), r"width to cut.*\.svg or \.dxf")):
            self.refuse(2, remedy, "mesh", "--sites", 3, *options, "-o", "t.obj")
        for options, remedy in ((("--pixels", 0), "from 1"), (("--cut", "-1"), "positive"),
                                (("--glb-nodes", "cell"), "did you mean cells"),
                                (("--pixels", 30000), "take at most 8192 pixels"),
                                (("--mesh", "delaunay", "--glb-nodes", "cells"), "voronoi or grains")):
            self.refuse(2, remedy, "mesh", "--sites", 3, *options,
                        "-o", "t.png", "-o", "t.svg", "-o", "t.glb")
        for options, fault in ((("--colour", "cells"), "takes a colouring"),
                               (("--background", "#fff000"), "takes a background")):
            self.refuse(2, fault, "mesh", "--sites", 3, "--cut", 300, *options, "-o", "t.svg")
        for width in ("1e305", "1e-9"):
            self.refuse(2, "not between 0.001 and 1e6 mm", "mesh", "--sites", 3, "--cut", width, "-o", "t.dxf")
        self.assertEqual(self.contents(), {})

    def test_an_image_may_be_longer_than_a_million_pixels(self):
        self.succeed("mesh", "--sites", 3, "--period", "1,400000", "--pixels", 3, "--max-iterations", 0,
                     "--quiet", "-o", "t.png")
        self.assertEqual(struct.unpack(">II", self.path("t.png").read_bytes()[16:24]), (3, 1200000))


if __name__ == "__main__":
    main()
