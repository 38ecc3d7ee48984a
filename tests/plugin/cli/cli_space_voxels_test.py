"""pcvt mesh --period X,Y,Z -o grains.vti: voxels of cells in space. DAMASK's conditions are tested on the bytes
(support/vti.py)."""

import base64
import csv
import re
import struct

from support.cli import CliTest, main
from support.vti import read_vti

CUBE = ("--period", "1,1,1")


class SpaceVoxels(CliTest):
    def image(self, name="t.vti"):
        return read_vti(self.path(name).read_text())

    def sites(self, name="s.txt"):
        return [tuple(map(float, line.split())) for line in self.path(name).read_text().splitlines()
                if not line.startswith("#")]

    def test_every_voxel_is_that_of_its_nearest_site(self):
        for n, lattice, box, origin in (
                (1, ("--period", "1,1,1"), (1, 1, 1), (0, 0, 0)),
                (2, ("--period", "3,1,0.5"), (3, 1, 0.5), (0, 0, 0)),
                (30, ("--period", "1,2,1.5"), (1, 2, 1.5), (0.3, -5, 1e3)),
                (20, ("--lattice", "0,0,2,0,-1,0,3,0,0"), (3, 1, 2), (0, 1, 0))):
            self.succeed("mesh", "--sites", n, *lattice, "--origin=%g,%g,%g" % origin, "--max-iterations", 3,
                         "--voxels", "12,10,8", "-o", "t.vti", "-o", "s.txt", "--force")
            counts, size, corner, materials = self.image()
            self.assertEqual(counts, [12, 10, 8])
            for found, wanted in zip(size, box):
                self.assertAlmostEqual(found, wanted, 14)
            sites = self.sites()
            self.assertEqual(len(sites), n)

            def distance(p, s):
                return sum(min(abs(a - b) % w, w - abs(a - b) % w) ** 2 for a, b, w in zip(p, s, box))

            for index, material in enumerate(materials):
                at = (index % 12, index // 12 % 10, index // 120)
                p = [corner[k] + (at[k] + 0.5) * size[k] / counts[k] for k in range(3)]
                self.assertLess(distance(p, sites[material]) - min(distance(p, s) for s in sites), 1e-12)
            self.assertIn("each voxel in the cell of its site within", self.succeed("check", "t.vti"))

    def test_the_corner_is_the_origin(self):
        self.succeed("mesh", "--sites", 9, "--period", "1,2,3", "--origin=-4,5,0.5", "--voxels", "4,4,4", "-o", "t.vti")
        self.assertEqual(self.image()[2], [-4, 5, 0.5])

    def test_the_default_has_sixteen_voxels_along_a_cell(self):
        self.succeed("mesh", "--sites", 16, "--period", "2,1,1", "--max-iterations", 2, "-o", "t.vti")
        self.assertEqual(self.image()[0], [64, 32, 32])
        self.assertRegex(self.succeed("check", "t.vti"),
                         r"^t\.vti: a voxel image: 64 x 32 x 32 voxels of 16 cells, period 2 x 1 x 1, each voxel in "
                         r"the cell of its site within \S+ h, one material a cell, every cell has voxels$")

    def test_counts_are_the_volumes(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "--max-iterations", 3, "--voxels", "40,44,48", "-o", "t.vti",
                     "--cells", "c.csv")
        materials = self.image()[3]
        self.assertEqual(len(materials), 40 * 44 * 48)
        lines = self.path("c.csv").read_text().splitlines()
        cells = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        for cell in cells:
            share = materials.count(int(cell["site"])) / len(materials)
            self.assertAlmostEqual(share, float(cell["volume"]), delta=0.03 * float(cell["volume"]))

    def test_materials_lie_beside_the_image(self):
        self.succeed("mesh", "--sites", 12, *CUBE, "--phases", "a:0.5,b:0.5", "--orientations", "random", "--voxels",
                     "8,8,8", "--material", "a:200,0.25", "--material", "b:3,2,1", "-o", "t.vti", "--cells", "c.csv")
        text = self.path("t.material.yaml").read_text()
        lines = self.path("c.csv").read_text().splitlines()
        cells = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        self.assertEqual(re.findall(r"- phase: (\S+)", text), [cell["phase"] for cell in cells])
        self.assertIn("C_11: 240.0, C_12: 80.0, C_44: 80.0", text)
        self.assertIn("C_11: 3.0, C_12: 2.0, C_44: 1.0", text)
        self.assertEqual(len(re.findall(r"O: \[", text)), 12)
        self.refuse(3, "t.vti: cannot write: it exists", "mesh", "--sites", 12, *CUBE, "-o", "t.vti")

    def test_every_number_of_threads_gives_the_same_bytes(self):
        for threads in (1, 4):
            self.succeed("mesh", "--sites", 200, *CUBE, "--threads", threads, "--max-iterations", 3, "-o",
                         f"t{threads}.vti", "--quiet")
        files = self.contents()
        self.assertEqual(files["t1.vti"], files["t4.vti"])
        self.assertEqual(files["t1.material.yaml"], files["t4.material.yaml"])

    def with_labels(self, materials, width):
        """The image again, uncompressed, with these labels of `width` bytes."""
        content = struct.pack(f"<{len(materials)}{'i' if width == 4 else 'q'}", *materials)
        coded = base64.b64encode(struct.pack("<Q", len(content)) + content).decode()
        text = self.path("t.vti").read_text().replace(' compressor="vtkZLibDataCompressor"', "")
        text = text.replace('"Int32"', '"Int64"') if width == 8 else text
        return re.sub(r'(Name="material" format="binary">\n).*', lambda found: found[1] + coded, text)

    def test_check_refutes_and_refuses(self):
        self.succeed("mesh", "--sites", 12, *CUBE, "--voxels", "8,6,4", "-o", "t.vti", "--quiet")
        materials = list(self.image()[3])
        self.write("same.vti", self.with_labels(materials, 8))
        self.assertIn("12 cells", self.succeed("check", "same.vti"))
        for at in (0, 77, 191):
            changed = list(materials)
            changed[at] = (changed[at] + 5) % 12
            self.write("bad.vti", self.with_labels(changed, 4))
            place = f"{at % 8},{at // 8 % 6},{at // 48}"
            self.refuse(2, rf"^bad\.vti: not a voxel image: voxel {place} names cell {changed[at]}, but its centre lies "
                           rf"in cell {materials[at]}$", "check", "bad.vti")
        changed[0] = 12
        self.write("bad.vti", self.with_labels(changed, 4))
        self.refuse(2, "voxel 0,0,0 names cell 12, but the cells are 0 to 11", "check", "bad.vti")
        self.refuse(2, "holds voxels in space, which state their lattice", "check", "t.vti", "--period", "1,1")
        self.refuse(2, "--cvt is not for voxels", "check", "t.vti", "--cvt")
        self.refuse(2, "--tolerance is not for voxels", "check", "t.vti", "--tolerance", "1e-3")

    def test_images_without_sites_are_read(self):
        self.succeed("mesh", "--sites", 12, *CUBE, "--voxels", "8,6,4", "-o", "t.vti", "--quiet")
        text = re.sub(r"<FieldData>.*</FieldData>\n", "", self.path("t.vti").read_text(), flags=re.DOTALL)
        self.write("u.vti", text)
        self.assertRegex(self.succeed("check", "u.vti"), r"8 x 6 x 4 voxels of 12 cells, period 1 x 1 x 1, no sites "
                                                         r"stored, no materials beside it")

    def test_check_names_cells_smaller_than_a_voxel(self):
        self.succeed("mesh", "--sites", 100, *CUBE, "--max-iterations", 0, "--voxels", "3,3,3", "-o", "t.vti")
        self.assertRegex(self.succeed("check", "t.vti"), r"7\d cells contain the centre of no voxel \(\d.* \.\.\.\)$")

    def test_mistakes_are_refused_before_the_run(self):
        run = ("mesh", "--sites", 12, "-o", "t.vti")
        for lattice in ("1,0,0,0.2,1,0,0,0,1", "1,1,0,1,-1,0,0,0,1"):
            self.refuse(2, "-o t.vti: voxels need periods along x, y and z; use a lattice that is a box", *run,
                        "--lattice", lattice)
        for voxels in ("8,8", "8,8,1"):
            self.refuse(2, "-o t.vti: voxels in space need three counts, NX,NY,NZ, each of them 2 or more; give them",
                        *run, *CUBE, "--voxels", voxels)
        self.refuse(2, "--voxels 1,8,8: ", *run, *CUBE, "--voxels", "1,8,8")
        self.refuse(4, "1024 x 1024 x 257 voxels are too many", *run, *CUBE, "--voxels", "1024,1024,257")
        self.refuse(2, r"no output takes a number of voxels; add one of \.vti", "mesh", "--sites", 12, *CUBE, "-o",
                    "t.vtu", "--voxels", "8,8,8")
        self.refuse(2, r"no output takes elastic constants; add one of \.inp or \.vti", "mesh", "--sites", 12, *CUBE, "-o",
                    "t.vtu", "--material", "a:1,0.3")
        self.assertEqual(self.contents(), {})


if __name__ == "__main__":
    main()
