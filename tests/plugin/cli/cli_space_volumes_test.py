"""Cells of prescribed volumes in space: --volumes."""

import csv
import json

from support.cli import CliTest, main

CUBE = ("--period", "1,1,1")
THIN = ("--lattice", "1,0,0,0.2,0.05,0,0.1,0.3,0.9")


class Volumes(CliTest):
    def rows(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_volumes_of_a_table_are_exact(self):
        for n in (1, 2, 3, 5, 8, 40):
            self.write("v.txt", "".join(f"{1 + k % 7}\n" for k in range(n)))
            total = sum(1 + k % 7 for k in range(n))
            for lattice, volume in ((CUBE, 1), (THIN, 0.045)):
                for steps in (0, 2):
                    with self.subTest((n, lattice, steps)):
                        self.succeed("mesh", "--sites", n, *lattice, "--volumes", "v.txt", "--max-iterations", steps,
                                     "--cells", "t.csv", "-o", "t.vtu", "--force")
                        for k, row in enumerate(self.rows("t.csv")):
                            wanted = (1 + k % 7) / total * volume
                            self.assertAlmostEqual(float(row["volume"]) / wanted, 1, delta=1e-8)
                        self.assertIn(f", power cells of {n} site", self.succeed("check", "t.vtu"))

    def test_the_report_and_the_summary_say_how_near_the_volumes_are(self):
        summary = self.succeed("mesh", "--sites", 300, *CUBE, "--volumes", "lognormal:0.35", "--report", "r.json")
        self.assertRegex(summary, r"volumes    lognormal:0\.35, diameters with std / mean 0\.3\d+, converged: off by at most ")
        self.assertRegex(summary, r"shapes     sphericity 0\.8[4-7]\d* \+- 0\.0\d+, of a truncated octahedron 0\.910")
        found = json.loads(self.path("r.json").read_text())["volumes"]
        self.assertLess(found["largest_relative_error"], 1e-9)
        self.assertTrue(0.84 < found["sphericity_mean"] < 0.88)
        self.assertEqual(json.loads(self.path("r.json").read_text())["iterations"], 5)

    def test_five_steps_give_the_sphericity_of_grown_grains(self):
        means = []
        for seed in (1, 2, 3):
            self.succeed("mesh", "--sites", 1500, *CUBE, "--volumes", "lognormal:0.35", "--seed", seed, "--cells", "t.csv",
                         "--force")
            rows = self.rows("t.csv")
            means.append(1 - sum(float(row["sphericity"]) for row in rows) / len(rows))
        self.assertAlmostEqual(sum(means) / 3, 0.144, delta=0.004)

    def test_diameters_and_radii_are_those_of_balls(self):
        self.write("d.csv", "ECD (um);n\n1,0;1\n2,0;2\n3,0;3\n")
        self.write("r.csv", "radius\n0.5\n1\n1.5\n")
        for table in ("d.csv", "r.csv", "diameter:d.csv:ECD"):
            self.succeed("mesh", "--sites", 3, *CUBE, "--volumes", table, "--cells", "t.csv", "--force")
            volumes = [float(row["volume"]) for row in self.rows("t.csv")]
            for volume, wanted in zip(volumes, (1 / 36, 8 / 36, 27 / 36), strict=True):
                self.assertAlmostEqual(volume / wanted, 1, delta=1e-9)

    def test_a_mixture_has_its_shares_and_means(self):
        self.succeed("mesh", "--sites", 80, *CUBE, "--volumes", "0.75*equal@1+0.25*equal@2", "--cells", "c.csv")
        small = 1 / (60 + 20 * 8)
        volumes = sorted(float(row["volume"]) / small for row in self.rows("c.csv"))
        for volume, wanted in zip(volumes, [1] * 60 + [8] * 20, strict=True):
            self.assertAlmostEqual(volume, wanted, delta=1e-8)

    def test_threads_and_tables_of_cells_keep_the_bytes(self):
        made = ("mesh", "--sites", 200, *CUBE, "--volumes", "gamma:0.4", "--orientations", "random")
        self.succeed(*made, "-o", "t.vtu", "--cells", "t.csv", "-o", "t.vti")
        self.succeed(*made, "-o", "two.vtu", "--threads", 2)
        self.assertEqual(self.path("two.vtu").read_bytes(), self.path("t.vtu").read_bytes())
        # Other flips lead to the same cells, whose corners have other numbers.
        self.succeed("mesh", "--input", "t.csv", *CUBE, "--max-iterations", 0, "--cells", "s.csv")
        for made, again in zip(self.rows("t.csv"), self.rows("s.csv"), strict=True):
            for name in ("x", "y", "z", "weight", "faces", "phi1", "Phi", "phi2", "neighbours"):
                self.assertEqual(made[name], again[name], name)
            self.assertAlmostEqual(float(made["volume"]) / float(again["volume"]), 1, delta=1e-10)
        self.assertIn("a voxel image", self.succeed("check", "t.vti"))

    def test_voxels_take_their_share_of_the_volume(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "--volumes", "lognormal:0.5", "--cells", "t.csv", "-o", "t.vti",
                     "--voxels", "48,48,48")
        self.assertRegex(self.succeed("check", "t.vti"), "each voxel in the cell of its site")

    def test_files_of_cells_have_their_volumes(self):
        self.write("v.txt", "".join(f"{1 + 7 * k % 12}\n" for k in range(60)))
        self.succeed("mesh", "--sites", 60, *CUBE, "--volumes", "v.txt", "-o", "t.vtu", "-o", "t.vti", "--cells", "t.csv")
        for name in ("t.vtu", "t.vti"):
            for table in ("v.txt", "t.csv:volume", "t.csv:diameter"):
                line = self.succeed("check", name, "--volumes", table)
                self.assertRegex(line, rf"volumes of 60 cells within \S+e-1\d of the mean of .* \(tolerance [1-9]\S*e-09\)")
        volumes = self.path("v.txt").read_text().split()
        self.write("w.txt", "\n".join((volumes[1], volumes[0], *volumes[2:])))
        self.write("one.txt", "1\n" * 60)
        self.succeed("mesh", "--sites", 60, *CUBE, "-o", "u.vtu", "-o", "u.foam", "-o", "u.obj", "-o", "u.glb", "--cells",
                     "u.csv")
        for name in ("t.vtu", "t.vti"):
            self.refuse(2, rf"{name}: not a .*: law of the volumes: cell [01] has the volume", "check", name, "--volumes",
                        "w.txt")
        for name in ("u.vtu", "u.foam", "u.obj"):
            self.assertIn("volumes of 60 cells within", self.succeed("check", name, "--volumes", "u.csv:volume"))
            self.refuse(2, f"{name}: not a .*: law of the volumes", "check", name, "--volumes", "one.txt")

    def test_questions_without_an_answer_are_refused(self):
        self.write("one.txt", "1\n" * 9)
        self.succeed("mesh", "--sites", 9, *CUBE, "-o", "u.glb", "-o", "u.vtu")
        self.succeed("mesh", "--sites", 9, *CUBE, "--mesh", "delaunay", "-o", "u.msh")
        self.succeed("mesh", "--sites", 9, "-o", "p.obj", "-o", "p.vti")
        self.refuse(2, "u.glb: --volumes needs cells, and the file holds triangles", "check", "u.glb", "--volumes", "one.txt")
        self.refuse(2, "u.msh: --volumes needs cells, and the file holds tetra", "check", "u.msh", "--volumes", "one.txt")
        self.refuse(2, "--volumes of check takes a file", "check", "u.vtu", "--volumes", "0.5*equal@1+0.5*equal@2")
        self.refuse(2, "u.vtu: .*--volumes", "check", "u.vtu", "--areas", "one.txt")
        for name in ("p.obj", "p.vti"):
            self.refuse(2, f"{name}: --volumes is for cells in space, .*--areas", "check", name, "--volumes", "one.txt")
        self.write("two.txt", "1\n2\n")
        self.refuse(2, "two.txt:2: the last of 2 volumes, but there are 9 sites", "check", "u.vtu", "--volumes", "two.txt")

    def test_wrong_volumes_are_refused(self):
        mesh = ("mesh", "--sites", 3, *CUBE, "--volumes")
        self.write("a.csv", "area\n1\n2\n3\n")
        self.write("two.txt", "1\n2\n")
        self.write("bad.txt", "1\n-2\n3\n")
        self.refuse(2, r"^a\.csv:1: cells in space have areas|^a\.csv:1: .* cells in space have volumes", *mesh, "a.csv")
        self.refuse(2, r"two\.txt.*volume", *mesh, "two.txt")
        self.refuse(2, r"^bad\.txt:2: '-2' is not the size of a cell", *mesh, "bad.txt")
        self.refuse(2, "neither a law nor a file", *mesh, "none.txt")
        self.refuse(2, "--volumes has a solver of its own", *mesh, "equal", "--solver", "lloyd")
        self.refuse(2, "--start lattice does not work with --volumes", *mesh, "equal", "--start", "lattice")
        self.refuse(2, "--stability does not work with --volumes", *mesh, "equal", "--stability")
        self.refuse(2, "--short-edges does not work with --volumes", *mesh, "equal", "--short-edges", 0.01)
        self.refuse(2, "cannot state the weights of power cells; take .obj", *mesh, "equal", "-o", "t.om")
        self.refuse(2, "--volumes is for three dimensions", "mesh", "--sites", 3, "--volumes", "equal")


if __name__ == "__main__":
    main()
