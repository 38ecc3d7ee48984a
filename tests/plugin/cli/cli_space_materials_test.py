"""Phases, orientations, tables and origins of cells in space."""

import csv
import json
import math

from support.cli import CliTest, main

CUBE = ("--period", "1,1,1")
OBLIQUE = ("--lattice", "1,0,0,0.37,0.81,0,0.2,0.4,0.9")


class Materials(CliTest):
    def rows(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_phases_have_their_shares_of_the_volume(self):
        summary = self.succeed("mesh", "--sites", 500, *CUBE, "--phases", "a:0.3,b:0.7", "--max-iterations", 5,
                               "--cells", "t.csv", "-o", "t.vtu", "--report", "r.json")
        self.assertIn("of the volume in", summary)
        rows = self.rows("t.csv")
        volumes = {phase: sum(float(row["volume"]) for row in rows if row["phase"] == phase) for phase in "ab"}
        smallest = min(float(row["volume"]) for row in rows)
        self.assertAlmostEqual(volumes["a"], 0.3, delta=smallest / 2)
        self.assertAlmostEqual(volumes["a"] + volumes["b"], 1, delta=1e-12)
        report = json.loads(self.path("r.json").read_text(encoding="utf-8"))
        self.assertEqual([phase["name"] for phase in report["phases"]], ["a", "b"])
        self.assertAlmostEqual(report["phases"][0]["reached"], volumes["a"], delta=1e-12)
        self.succeed("check", "t.vtu")

    def test_the_table_has_the_measures_of_the_cells(self):
        self.succeed("mesh", "--sites", 40, *OBLIQUE, "--orientations", "random", "--cells", "t.csv")
        rows = self.rows("t.csv")
        self.assertEqual(len(rows), 40)
        self.assertAlmostEqual(sum(float(row["volume"]) for row in rows), 0.729, delta=1e-12)
        for s, row in enumerate(rows):
            self.assertEqual(int(row["site"]), s)
            self.assertAlmostEqual(float(row["diameter"]), (6 * float(row["volume"]) / math.pi) ** (1 / 3), delta=1e-14)
            self.assertLess(float(row["sphericity"]), 0.95)
            neighbours = row["neighbours"].split()
            self.assertEqual(len(neighbours), int(row["faces"]))
            for other in neighbours:
                self.assertIn(str(s), rows[int(other)]["neighbours"].split())
            self.assertTrue(0 < float(row["Phi"]) < 180)

    def test_orientations_and_phases_of_files_are_kept(self):
        self.write("o.csv", "phi1,Phi,phi2\n" + "".join(f"{10 * k},{5 * k},{k}\n" for k in range(6)))
        self.write("p.txt", "a\nb\nb\na\nc\na\n")
        self.succeed("mesh", "--sites", 6, *CUBE, "--orientations", "o.csv", "--phases", "p.txt", "--cells", "t.csv")
        rows = self.rows("t.csv")
        self.assertEqual([row["phase"] for row in rows], list("abbaca"))
        self.assertEqual([float(row["Phi"]) for row in rows], [0, 5, 10, 15, 20, 25])

    def test_one_entry_is_needed_a_site(self):
        self.write("o.csv", "phi1,Phi,phi2\n1,2,3\n")
        self.refuse(2, "there are 1 orientations for 6 sites", "mesh", "--sites", 6, *CUBE, "--orientations", "o.csv",
                       "-o", "t.vtu")

    def test_formats_without_materials_are_named(self):
        self.refuse(2, "no output takes phases; add one of .obj or .ply or .glb or .msh or .inp or .vtu", "mesh", "--sites", 6, *CUBE, "--phases",
                       "a:0.5,b:0.5", "-o", "t.om")


class Origin(CliTest):
    def sites(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            return [tuple(map(float, line.split())) for line in file if not line.startswith("#")]

    def test_sites_and_tiles_lie_at_the_origin(self):
        corner = (-17.1, 3.25, -2)
        origin = ("--origin", ",".join(map(str, corner)))
        self.succeed("mesh", "--sites", 30, *CUBE, *origin, "-o", "t.txt", "-o", "t.vtu", "-o", "t.msh")
        self.succeed("mesh", "--sites", 30, *CUBE, "-o", "zero.txt")
        for moved, at_zero in zip(self.sites("t.txt"), self.sites("zero.txt")):
            for x, y, o in zip(moved, at_zero, corner):
                self.assertTrue(o <= x < o + 1, (x, o))
                self.assertAlmostEqual(math.remainder(x - y, 1), 0, delta=1e-12)
        self.assertIn("a periodic tile of polyhedra", self.succeed("check", "t.vtu"))
        self.assertIn("tetrahedra", self.succeed("check", "t.msh"))

    def test_a_whole_period_moves_the_tile_by_it(self):
        self.succeed("mesh", "--sites", 12, *OBLIQUE, "-o", "zero.obj")
        self.succeed("mesh", "--sites", 12, *OBLIQUE, "--origin", "0.37,0.81,0", "-o", "moved.obj")
        points = [[list(map(float, line.split()[1:4])) for line in self.path(name).read_text(encoding="utf-8").splitlines()
                   if line.startswith("v ")] for name in ("zero.obj", "moved.obj")]
        self.assertEqual(len(points[0]), len(points[1]))
        for p, q in zip(*points):
            for x, y, period in zip(p, q, (0.37, 0.81, 0)):
                self.assertAlmostEqual(x + period, y, delta=1e-12)

    def test_an_origin_has_three_numbers(self):
        self.refuse(2, "2 of 3 numbers; give X,Y,Z", "mesh", "--sites", 5, *CUBE, "--origin", "1,2", "-o", "t.vtu")
        self.refuse(2, "so far away", "mesh", "--sites", 5, *CUBE, "--origin", "1e9,0,0", "-o", "t.vtu")
        self.refuse(2, "--origin auto is for --outline box", "mesh", "--sites", 5, *CUBE, "--origin", "auto", "-o",
                       "t.vtu")


if __name__ == "__main__":
    main()
