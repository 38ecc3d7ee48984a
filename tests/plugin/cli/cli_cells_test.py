"""pcvt mesh --cells: the table of the cells."""

import csv
import json
import math

from support.cli import CliTest, main

HEADER = "site,x,y,weight,area,diameter,sides,circularity,phase,tag,phi1,Phi,phi2,orbit,neighbours"


class Cells(CliTest):
    def table(self, name="cells.csv"):
        lines = self.path(name).read_text().splitlines()
        rows = [line for line in lines if not line.startswith("#")]
        self.assertEqual(rows[0], HEADER)
        self.assertTrue(lines[0].startswith("#"))
        return list(csv.DictReader(rows))

    def test_cells_tile_the_domain_and_have_six_sides_on_average(self):
        for n, lattice in ((1, "2,0,0.3,1.7"), (2, "1,0,0.37,0.81"), (90, "2,0,0.3,1.7"), (400, "1,0,0,1")):
            self.succeed("mesh", "--sites", n, "--lattice", lattice, "--cells", "cells.csv", "-o",
                         "sites.txt", "--report", "run.json", "--force")
            rows = self.table()
            ax, ay, bx, by = map(float, lattice.split(","))
            self.assertAlmostEqual(sum(float(row["area"]) for row in rows), ax * by - ay * bx, 12)
            self.assertEqual(sum(int(row["sides"]) for row in rows), 6 * n)
            self.assertEqual([int(row["site"]) for row in rows], list(range(n)))
            sites = [line.split() for line in self.path("sites.txt").read_text().splitlines()[1:]]
            self.assertEqual([[row["x"], row["y"]] for row in rows], sites)
            report = json.loads(self.path("run.json").read_text())
            self.assertIn("cells.csv", report["files"])
            counts = {}
            for row in rows:
                counts[row["sides"]] = counts.get(row["sides"], 0) + 1
            self.assertEqual(counts, report["valences"])

    def test_neighbours_are_mutual_and_one_a_side(self):
        self.succeed("mesh", "--sites", 60, "--cells", "cells.csv")
        neighbours = {int(row["site"]): list(map(int, row["neighbours"].split()))
                      for row in self.table()}
        for row in self.table():
            self.assertEqual(len(neighbours[int(row["site"])]), int(row["sides"]))
        for site, others in neighbours.items():
            for other in others:
                self.assertEqual(others.count(other), neighbours[other].count(site))

    def test_diameter_and_circularity_are_those_of_hexagons(self):
        self.succeed("pattern", "--sites", 2, "--period", f"1,{math.sqrt(3)}", "--cells", "cells.csv")
        for row in self.table():
            area = math.sqrt(3) / 2
            self.assertAlmostEqual(float(row["area"]), area, 12)
            self.assertAlmostEqual(float(row["diameter"]), 2 * math.sqrt(area / math.pi), 12)
            perimeter = 6 / math.sqrt(3)
            self.assertAlmostEqual(float(row["circularity"]),
                                   2 * math.sqrt(math.pi * area) / perimeter, 12)
            self.assertEqual([row[name] for name in ("weight", "phase", "tag", "phi1", "Phi", "phi2")],
                             [""] * 6)

    def test_weights_phases_and_orientations_fill_their_fields(self):
        run = ("mesh", "--sites", 80, "--cells", "cells.csv", "--force")
        for areas in ((), ("--areas", "lognormal:0.42", "--max-iterations", 2)):
            self.succeed(*run, *areas, "--phases", "a:0.4,b:0.6", "--orientations", "random", "--report",
                         "run.json")
            rows = self.table()
            self.assertEqual({row["tag"] for row in rows}, {""})
            self.assertEqual({row["weight"] == "" for row in rows}, {not areas})
            for phase in json.loads(self.path("run.json").read_text())["phases"]:
                own = [row for row in rows if row["phase"] == phase["name"]]
                self.assertEqual(len(own), phase["cells"])
                self.assertAlmostEqual(sum(float(row["area"]) for row in own), phase["reached"], 12)
            for row in rows:
                self.assertLess(float(row["phi1"]), 360)
                self.assertLess(float(row["Phi"]), 180)
                self.assertLess(float(row["phi2"]), 360)
        self.succeed(*run, "--orientations", "random")
        self.assertEqual({row["phase"] for row in self.table()}, {""})

    def test_a_table_is_refused_before_the_run(self):
        self.refuse(2, r"--cells t\.txt: not a \.csv file; name it FILE\.csv", "mesh", "--sites", 9,
                    "--cells", "t.txt")
        self.write("t.csv", "mine")
        self.refuse(3, r"t\.csv.*--force", "mesh", "--sites", 10 ** 6, "--cells", "t.csv")
        self.succeed("mesh", "--sites", 9, "--cells", "t.csv", "--force")
        self.assertEqual(len(self.table("t.csv")), 9)
        self.refuse(2, r"a\.csv is another output as well", "mesh", "--sites", 9, "--cells", "a.csv", "-o",
                    "a.csv")


if __name__ == "__main__":
    main()
