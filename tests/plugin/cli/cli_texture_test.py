"""Textures: lists of orientations, and the misorientations of neighbours."""

import csv
import json
import random

from support.cli import CliTest, main

PLANE = ("--max-iterations", 3)
SPACE = ("--period", "1,1,1", "--max-iterations", 3)
CLASS = 2.5
# Mackenzie's distribution: the mean and, below 45 degrees, 2 / 15 (1 - cos x) for each degree x.
MEAN = 40.74


class Lists(CliTest):
    def angles(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            return [tuple(float(row[name]) for name in ("phi1", "Phi", "phi2")) for row in rows]

    def list_of(self, n):
        numbers = random.Random(5)
        return [tuple(round(numbers.uniform(0, top), 2) for top in (360, 180, 360)) for _ in range(n)]

    def test_orientations_are_drawn_from_longer_lists(self):
        listed = self.list_of(500)
        self.write("odf.txt", "".join("{} {} {}\n".format(*row) for row in listed))
        for dimension in (PLANE, SPACE):
            run = ("mesh", "--sites", 60, *dimension, "--orientations", "odf.txt", "--cells", "t.csv", "--force")
            summary = self.succeed(*run, "--report", "r.json")
            self.assertIn("texture    drawn from the 500 orientations of odf.txt\n", summary)
            drawn = self.angles("t.csv")
            self.assertEqual(len(set(drawn)), 60)
            self.assertTrue(set(drawn) <= set(listed))
            orientations = json.loads(self.path("r.json").read_text())["orientations"]
            self.assertEqual((orientations["drawn_from"], orientations["listed"]), ("odf.txt", 500))
            self.succeed(*run, "--threads", 2)
            self.assertEqual(self.angles("t.csv"), drawn)
            self.succeed(*run, "--seed", 1)
            self.assertNotEqual(self.angles("t.csv"), drawn)

    def test_weights_are_shares_of_the_cells(self):
        self.write("odf.csv", "Phi,phi2,phi1,Weight\n35,45,90,3\n45,90,35,1\n0,0,0,0\n")
        for dimension in (PLANE, SPACE):
            summary = self.succeed("mesh", "--sites", 80, *dimension, "--orientations", "odf.csv", "--cells", "t.csv", "--force")
            self.assertIn("texture    drawn from the 3 orientations of odf.csv by column 'Weight'\n", summary)
            drawn = self.angles("t.csv")
            self.assertEqual(drawn.count((90, 35, 45)), 60)
            self.assertEqual(drawn.count((35, 45, 90)), 20)

    def test_lists_of_other_programs_are_read_as_they_are(self):
        self.write("mtex.tex", "texture exported by MTEX\n\n\nB 2\n  10.00   20.00   30.00   0.7500000\n"
                               "  40.00   50.00   60.00   0.2500000\n")
        self.write("dream3d.txt", "# Euler angles are expressed in degrees\n# Euler0 Euler1 Euler2 Weight Sigma\n"
                                  "Angle Count:2\n10 20 30 0.75 1\n40 50 60 0.25 1\n")
        for name in ("mtex.tex", "dream3d.txt"):
            summary = self.succeed("mesh", "--sites", 40, *PLANE, "--orientations", name, "--cells", "t.csv", "--force")
            self.assertIn(f"drawn from the 2 orientations of {name} by column 4", summary)
            self.assertEqual(self.angles("t.csv").count((10, 20, 30)), 30)

    def test_one_row_a_site_is_no_list(self):
        self.write("o.txt", "10 20 30\n40 50 60\n70 80 90\n")
        summary = self.succeed("mesh", "--sites", 3, *PLANE, "--orientations", "o.txt", "--cells", "t.csv")
        self.assertNotIn("texture  ", summary)
        self.assertEqual(self.angles("t.csv"), [(10, 20, 30), (40, 50, 60), (70, 80, 90)])
        # The table of the cells has the weights of power cells, not those of orientations.
        self.succeed("mesh", "--sites", 9, *SPACE, "--volumes", "gamma:0.3", "--orientations", "random", "--cells", "p.csv")
        self.succeed("mesh", "--sites", 9, *SPACE, "--orientations", "p.csv", "--cells", "q.csv")
        self.assertEqual(self.angles("p.csv"), self.angles("q.csv"))
        summary = self.succeed("mesh", "--sites", 8, *SPACE, "--orientations", "p.csv", "--cells", "q.csv", "--force")
        self.assertIn("texture    drawn from the 9 orientations of p.csv\n", summary)

    def test_wrong_lists_are_refused(self):
        self.write("o.csv", "phi1,Phi,phi2,weight\n10,20,30,1\n40,50,60,-1\n")
        run = ("mesh", "--sites", 5, *PLANE, "-o", "t.csv", "--orientations")
        self.refuse(2, "o.csv:3: column 'weight': '-1' is not a weight", *run, "o.csv")
        self.refuse(2, "2 orientations for 5 sites; give one for each site, or a list to draw from, which is longer or has "
                       "weights", *run, "o.csv:phi1,Phi,phi2")
        self.write("cut.txt", "Angle Count:3\n10 20 300 0.75 1\n40 50 60 0.25 1\n")
        self.refuse(2, "cut.txt: its head states 3 orientations, but it has 2", *run, "cut.txt")


class Misorientations(CliTest):
    def test_without_a_texture_they_have_mackenzies_distribution(self):
        for dimension, n in ((PLANE, 3000), (SPACE, 1200)):
            summary = self.succeed("mesh", "--sites", n, *dimension, "--orientations", "random", "--report", "r.json", "--force")
            self.assertRegex(summary, r"neighbours as cubic crystals misoriented by 4[01]\.\d+ degrees on average, "
                                      r"at most 6[12]\.\d+; without a texture 40\.7 and 62\.8\n")
            report = json.loads(self.path("r.json").read_text())
            found = report["misorientations"]
            faces = sum(int(sides) * count for sides, count in report["valences"].items())
            self.assertEqual(2 * found["boundaries"], faces)
            self.assertEqual(sum(found["counts"]), found["boundaries"])
            self.assertEqual((found["class"], len(found["counts"])), (CLASS, 26))
            # Angles of boundaries with a common crystal depend on each other: the spread is that of n values.
            self.assertAlmostEqual(found["mean"], MEAN, delta=4 * 11.3 / n ** 0.5)
            below_15 = sum(found["counts"][:6]) / found["boundaries"]
            self.assertAlmostEqual(below_15, 0.0227, delta=4 * (0.0227 / n) ** 0.5)

    def test_one_orientation_has_none(self):
        self.write("o.csv", "phi1,Phi,phi2,weight\n10,20,30,1\n")
        for dimension in (PLANE, SPACE):
            self.succeed("mesh", "--sites", 20, *dimension, "--orientations", "o.csv", "--report", "r.json", "--force")
            found = json.loads(self.path("r.json").read_text())["misorientations"]
            self.assertEqual(found["counts"][0], found["boundaries"])
            self.assertLess(found["largest"], 1e-5)

    def test_they_need_neighbours_of_one_phase(self):
        self.succeed("mesh", "--sites", 1, *PLANE, "--orientations", "random", "--report", "r.json")
        self.assertNotIn("misorientations", json.loads(self.path("r.json").read_text()))


if __name__ == "__main__":
    main()
