"""pcvt mesh --repeat IxJxK: several periods in files of cells in space."""

import json
import re

from support.cli import CliTest, main
from support.vti import read_vti

OBLIQUE = ("--lattice", "1,0,0,0.37,0.81,0,0.2,0.4,0.9")
RUN = ("mesh", "--sites", 12, "--max-iterations", 5, "--force")


class Repeat(CliTest):
    def column(self, path, name):
        text = self.path(path).read_text()
        return re.search(rf'Name="{name}"[^>]*>(.*?)</DataArray>', text, re.S)[1].split()

    def test_tiles_have_the_cells_of_all_periods(self):
        names = ("t.vtu", "t.obj", "t.ply", "t.glb", "t.om", "t.msh", "t.foam", "t.svg", "t.png")
        outputs = [word for name in names for word in ("-o", name)]
        for domain in (OBLIQUE, ("--period", "1,2,1")):
            summary = self.succeed(*RUN, *domain, "--repeat", "2x1x3", *outputs, "--report", "r.json")
            self.assertIn("sites      12\n", summary)
            for name in names[:7]:
                self.assertRegex(self.succeed("check", name), "periodic|boundary|surfaces")
            self.assertIn("72 cells", self.succeed("check", "t.vtu"))
            volumes = [float(v) for v in self.column("t.vtu", "Volume")]
            for s, volume in enumerate(volumes):
                self.assertAlmostEqual(volume, volumes[s % 12], delta=1e-14)
            # Figures are those of one period.
            report = json.loads(self.path("r.json").read_text())
            self.assertEqual(sum(report["valences"].values()), 12)
            self.assertEqual(report["sites"], 12)
            lattice = [float(x) for x in self.column("t.vtu", "PeriodicLattice")]
            periods = [x for period, copies in zip(report["lattice"], (2, 1, 3)) for x in (copies * y for y in period)]
            self.assertEqual([round(x, 12) for x in lattice], [round(x, 12) for x in periods])

    def test_copies_have_the_materials_and_weights_of_their_sites(self):
        self.succeed(*RUN, *OBLIQUE, "--volumes", "lognormal:0.3", "--phases", "a:0.5,b:0.5", "--orientations", "random",
                     "--repeat", "2x2x2", "-o", "t.vtu", "-o", "t.obj", "--cells", "t.csv", "-o", "t.txt")
        self.assertIn("power cells of 96 sites", self.succeed("check", "t.vtu"))
        self.assertIn("power cells of 96 sites", self.succeed("check", "t.obj"))
        for name, width in (("Phase", 1), ("Orientation", 3), ("Weight", 1)):
            words = self.column("t.vtu", name)
            self.assertEqual(len(words), 96 * width, name)
            self.assertEqual(words, words[:12 * width] * 8, name)
        # Tables and sites are those of one period.
        rows = [line for line in self.path("t.csv").read_text().splitlines() if not line.startswith("#")]
        self.assertEqual(len(rows), 13)
        self.assertEqual(len([line for line in self.path("t.txt").read_text().splitlines() if not line.startswith("#")]), 12)

    def test_elongated_cells_repeat(self):
        self.succeed(*RUN, *OBLIQUE, "--aspect", "3,1,0,1", "--volumes", "lognormal:0.3", "--repeat", "2x1x2", "-o", "t.vtu")
        self.assertIn("power cells of 48 sites", self.succeed("check", "t.vtu"))
        volumes = [float(v) for v in self.column("t.vtu", "Volume")]
        for s, volume in enumerate(volumes):
            self.assertAlmostEqual(volume, volumes[s % 12], delta=1e-13)
        self.succeed(*RUN, *OBLIQUE, "--aspect", "3,1,0,1", "--repeat", "2x1x2", "--mesh", "delaunay", "-o", "t.msh")
        self.assertIn("of 48 sites", self.succeed("check", "t.msh"))

    def test_tetrahedra_inside_of_cells_repeat(self):
        self.succeed("mesh", "--sites", 4, "--period", "1,1,1", "--repeat", "1x2x1", "--aspect", 2, "--mesh", "grains", "-o", "g.vtu")
        checked = self.succeed("check", "g.vtu")
        self.assertRegex(checked, r"in 8 cells .* volume 2$")

    def test_voxels_repeat(self):
        voxels = {}
        for copies, counts in (("1x1x1", "6,5,4"), ("2x1x3", "12,5,12")):
            self.succeed(*RUN, "--period", "1,1,1", "--repeat", copies, "--voxels", counts, "-o", "t.vti")
            self.succeed("check", "t.vti")
            voxels[copies] = read_vti(self.path("t.vti").read_text())
        self.assertEqual(voxels["2x1x3"][0], [12, 5, 12])
        self.assertEqual([round(x, 12) for x in voxels["2x1x3"][1]], [2, 1, 3])
        one, all_periods = voxels["1x1x1"][3], voxels["2x1x3"][3]
        self.assertEqual(len(all_periods), 720)
        for k, label in enumerate(all_periods):
            x, y, z = k % 12, k // 12 % 5, k // 60
            self.assertEqual(label, one[x % 6 + 6 * (y + 5 * (z % 4))])

    def test_one_period_is_the_default(self):
        self.succeed(*RUN, *OBLIQUE, "-o", "a.vtu", "-o", "a.glb")
        self.succeed(*RUN, *OBLIQUE, "-o", "b.vtu", "-o", "b.glb", "--repeat", "1x1x1")
        files = self.contents()
        self.assertEqual(files["a.vtu"], files["b.vtu"])
        self.assertEqual(files["a.glb"], files["b.glb"])

    def test_the_sum_of_the_volumes_is_that_of_all_periods(self):
        self.succeed("mesh", "--sites", 1, *OBLIQUE, "--repeat", "3x2x1", "-o", "t.vtu")
        self.assertAlmostEqual(sum(map(float, self.column("t.vtu", "Volume"))), 6 * 0.729, delta=1e-12)

    def test_wrong_repetitions_are_refused(self):
        for text in ("2x2", "2", "2x2x0", "axbxc", "2x2x2x2", "-1x1x1"):
            self.refuse(2, "--repeat .*not of the form IxJxK; give three whole numbers from 1 on", *RUN, *OBLIQUE,
                        "--repeat=" + text, "-o", "t.vtu")
        self.refuse(2, "not of the form IxJ; give two", *RUN, "--repeat", "2x2x2", "-o", "p.vtu")
        self.refuse(4, "more than 10000 periods in a row", *RUN, *OBLIQUE, "--repeat", "1x1x10001", "-o", "t.vtu")
        self.refuse(4, "more than 67108864 cells in one tile", *RUN, *OBLIQUE, "--repeat", "1000x1000x10", "-o", "t.vtu")


if __name__ == "__main__":
    main()
