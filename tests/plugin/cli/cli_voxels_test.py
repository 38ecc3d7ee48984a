"""pcvt mesh -o tile.vti: voxels for solvers that use Fourier transforms. DAMASK's conditions are tested on
the bytes (support/vti.py)."""

import base64
import csv
import math
import re
import struct

from support.cli import CliTest, main
from support.vti import read_vti


class Voxels(CliTest):
    def image(self, name="t.vti"):
        return read_vti(self.path(name).read_text())

    def sites(self, name="s.txt"):
        return [tuple(map(float, line.split())) for line in self.path(name).read_text().splitlines()
                if not line.startswith("#")]

    def test_every_voxel_is_that_of_its_nearest_site(self):
        for n, period, origin in ((1, (1, 1), (0, 0)), (2, (3, 1), (0, 0)), (40, (2, 1), (0.3, -5))):
            self.succeed("mesh", "--sites", n, "--period", "%g,%g" % period, "--origin=%g,%g" % origin,
                         "--max-iterations", 3, "--voxels", "30,20", "-o", "t.vti", "-o", "s.txt", "--force")
            counts, size, corner, materials = self.image()
            self.assertEqual(counts, [30, 20, 1])
            self.assertEqual(corner[:2], list(origin))
            for found, wanted in zip(size, period):
                self.assertAlmostEqual(found, wanted, 14)
            sites = self.sites()
            self.assertEqual(len(sites), n)

            def distance(p, s):
                return sum(min(abs(a - b) % w, w - abs(a - b) % w) ** 2 for a, b, w in zip(p, s, period))

            for index, material in enumerate(materials):
                p = [corner[k] + ((index % 30, index // 30)[k] + 0.5) * size[k] / counts[k] for k in (0, 1)]
                least = min(distance(p, s) for s in sites)
                self.assertLess(distance(p, sites[material]) - least, 1e-14)

    def test_the_default_has_sixteen_voxels_along_a_cell(self):
        self.succeed("mesh", "--sites", 50, "--period", "2,1", "--max-iterations", 2, "-o", "t.vti")
        self.assertEqual(self.image()[0], [160, 80, 1])
        line = self.succeed("check", "t.vti")
        self.assertRegex(line, r"^t\.vti: a voxel image: 160 x 80 voxels of 50 cells, period 2 x 1, each voxel "
                               r"in the cell of its site within \S+ h, one material a cell, every cell has voxels$")

    def test_a_repeated_tile_repeats_the_image(self):
        run = ("mesh", "--sites", 20, "--max-iterations", 3)
        self.succeed(*run, "--voxels", "16,16", "-o", "one.vti")
        self.succeed(*run, "--voxels", "32,48", "--repeat", "2x3", "-o", "six.vti")
        one, six = self.image("one.vti")[3], self.image("six.vti")[3]
        self.assertEqual(six, tuple(one[16 * (l % 16) + k % 16] for l in range(48) for k in range(32)))
        self.succeed("check", "one.vti", "six.vti")

    def test_layers_along_z_repeat_the_image(self):
        run = ("mesh", "--sites", 20, "--max-iterations", 3, "--quiet")
        self.succeed(*run, "--voxels", "16,24", "-o", "one.vti")
        self.succeed(*run, "--voxels", "16,24,1", "-o", "same.vti")
        self.succeed(*run, "--voxels", "16,24,1000", "-o", "many.vti")
        one, many = self.image("one.vti"), self.image("many.vti")
        self.assertEqual(self.path("one.vti").read_bytes(), self.path("same.vti").read_bytes())
        self.assertEqual(many[0], [16, 24, 1000])
        self.assertEqual(many[3], 1000 * one[3])
        self.assertEqual(many[1][2], 1000 * one[1][2])
        self.assertRegex(self.succeed("check", "many.vti"),
                         r"16 x 24 x 1000 equal layers of voxels of 20 cells, .* each voxel in the cell of its site")

    def test_layers_that_differ_are_refused(self):
        self.succeed("mesh", "--sites", 20, "--voxels", "8,8,3", "-o", "t.vti", "--quiet")
        counts, _, _, materials = self.image()
        data = list(materials)
        data[2 * 64 + 5] = 19 - data[2 * 64 + 5]
        content = struct.pack(f"<{len(data)}i", *data)
        coded = base64.b64encode(struct.pack("<Q", len(content)) + content).decode()
        text = self.path("t.vti").read_text().replace(' compressor="vtkZLibDataCompressor"', "")
        self.write("t.vti", re.sub(r'(Name="material" format="binary">\n).*', lambda found: found[1] + coded, text))
        self.refuse(2, r"t\.vti:\d+: layer 2 along z is not equal to layer 0", "check", "t.vti")
        for wrong in ("8,8,0", "8,8,-1", "8,8,1.5", "8,8,3,4", "8", "8,8,1e9"):
            self.refuse(2, f"--voxels {wrong}: ", "mesh", "--sites", 20, "--voxels", wrong, "-o", "u.vti")
        self.refuse(4, "voxels are too many", "mesh", "--sites", 20, "--voxels", "1024,1024,257", "-o", "u.vti")

    def test_materials_lie_beside_the_image(self):
        self.succeed("mesh", "--sites", 12, "--voxels", "8,8", "-o", "t.vti", "-o", "t.obj")
        self.assertIn("t.material.yaml", self.contents())
        lines = self.path("t.material.yaml").read_text().splitlines()
        self.assertEqual([line for line in lines if re.match(r"\w", line)],
                         ["homogenization:", "phase:", "material:"])
        self.assertEqual(lines.count("      - phase: default"), 12)
        self.assertEqual(lines.count("        v: 1.0"), 12)
        self.assertEqual(lines.count("        O: [1.0, 0.0, 0.0, 0.0]"), 12)
        self.refuse(3, "t.vti: cannot write: it exists", "mesh", "--sites", 12, "-o", "t.vti")
        self.path("t.vti").unlink()
        self.refuse(3, "t.material.yaml", "mesh", "--sites", 12, "-o", "t.vti")

    def cells(self, name="c.csv"):
        lines = self.path(name).read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def test_power_distance_and_metric_decide(self):
        for aspect in ((), ("--aspect", "4,30")):
            self.succeed("mesh", "--sites", 40, "--areas", "lognormal:0.42", "--max-iterations", 3, *aspect,
                         "--voxels", "40,40", "-o", "t.vti", "--cells", "c.csv", "--force")
            ratio, angle = (4, math.radians(30)) if aspect else (1, 0)
            cells = [[float(cell[name]) for name in ("x", "y", "weight")] for cell in self.cells()]
            materials = self.image()[3]

            def distance(p, cell):
                """The least over 5 x 5 images."""
                least = math.inf
                for i in range(-2, 3):
                    for j in range(-2, 3):
                        x, y = cell[0] + i - p[0], cell[1] + j - p[1]
                        along = math.cos(angle) * x + math.sin(angle) * y
                        across = math.cos(angle) * y - math.sin(angle) * x
                        least = min(least, along ** 2 / ratio + across ** 2 * ratio - cell[2])
                return least

            for index in range(0, 1600, 7):
                p = [(index % 40 + 0.5) / 40, (index // 40 + 0.5) / 40]
                distances = [distance(p, cell) for cell in cells]
                self.assertLess(distances[materials[index]] - min(distances), 1e-12)
            self.assertIn("each voxel in the cell of its site", self.succeed("check", "t.vti"))
        text = self.path("t.vti").read_text()
        for name in ("Metric", "SiteWeights"):
            self.write("u.vti", text.replace(f'Name="{name}"', 'Name="Other"'))
            self.refuse(2, "its centre lies in", "check", "u.vti")

    def test_phases_and_orientations_are_those_of_the_cells(self):
        self.succeed("mesh", "--sites", 30, "--phases", "ferrite:0.3,martensite:0.7", "--orientations",
                     "random", "--voxels", "8,8", "-o", "t.vti", "--cells", "c.csv")
        text = self.path("t.material.yaml").read_text()
        phases = re.findall(r"- phase: (\S+)", text)
        quaternions = [[float(word) for word in found.split(",")] for found in re.findall(r"O: \[(.*)\]", text)]
        cells = self.cells()
        self.assertEqual(phases, [cell["phase"] for cell in cells])
        self.assertEqual(set(phases), {"ferrite", "martensite"})
        self.assertEqual(len(quaternions), 30)
        for cell, (w, x, y, z) in zip(cells, quaternions):
            phi1, phi, phi2 = (math.radians(float(cell[name])) for name in ("phi1", "Phi", "phi2"))
            # The crystal's third axis in the sample, by the quaternion and by Bunge's matrix.
            self.assertAlmostEqual(2 * (x * z + w * y), math.sin(phi1) * math.sin(phi), 12)
            self.assertAlmostEqual(2 * (y * z - w * x), -math.cos(phi1) * math.sin(phi), 12)
            self.assertAlmostEqual(1 - 2 * (x * x + y * y), math.cos(phi), 12)
            # And the sample's third axis in the crystal.
            self.assertAlmostEqual(2 * (x * z - w * y), math.sin(phi2) * math.sin(phi), 12)
            self.assertAlmostEqual(2 * (y * z + w * x), math.cos(phi2) * math.sin(phi), 12)
            self.assertAlmostEqual(w * w + x * x + y * y + z * z, 1, 14)
        self.succeed("check", "t.vti")

    def test_every_number_of_threads_gives_the_same_bytes(self):
        for threads in (1, 4):
            self.succeed("mesh", "--sites", 300, "--threads", threads, "-o", f"t{threads}.vti", "--quiet")
        files = self.contents()
        self.assertEqual(files["t1.vti"], files["t4.vti"])
        self.assertEqual(files["t1.material.yaml"], files["t4.material.yaml"])

    def test_check_names_cells_smaller_than_a_voxel(self):
        self.succeed("mesh", "--sites", 100, "--max-iterations", 0, "--voxels", "4,4", "-o", "t.vti")
        self.assertRegex(self.succeed("check", "t.vti"), r"8\d cells contain the centre of no voxel \(\d.* \.\.\.\)$")

    def test_check_refutes_and_refuses(self):
        self.succeed("mesh", "--sites", 12, "--voxels", "8,8", "-o", "t.vti")
        text = self.path("t.vti").read_text()
        self.write("moved.vti", text.replace('Origin="0 0', 'Origin="0.3 0'))
        self.refuse(2, r"^moved\.vti: not a voxel image: voxel \d+,\d+ names cell \d+, but its centre lies in",
                    "check", "moved.vti")
        self.refuse(2, "not the one that was given", "check", "t.vti", "--period", "2,1")
        self.refuse(2, "--cvt is not for voxels", "check", "t.vti", "--cvt")
        self.succeed("check", "t.vti", "--period", "1,1")

    def test_mistakes_are_refused_before_the_run(self):
        run = ("mesh", "--sites", 12, "-o", "t.vti")
        self.refuse(2, "-o t.vti: voxels need periods along x and y; use a rectangular", *run, "--lattice",
                    "1,0,0.5,0.9")
        for voxels, words in (("8", "NX,NY"), ("8,1", "whole numbers from 2"), ("8.5,8", "whole numbers"),
                              ("a,b", "number"), ("1048577,8", "2 to 1048576")):
            self.refuse(2, f"--voxels {voxels}: .*{words}", *run, "--voxels", voxels)
        self.refuse(4, "at most 2\\^28", *run, "--voxels", "100000,100000")
        self.refuse(2, r"no output takes a number of voxels; add one of \.vti", "mesh", "--sites", 12, "-o",
                    "t.obj", "--voxels", "8,8")
        self.assertEqual(self.contents(), {})


if __name__ == "__main__":
    main()
