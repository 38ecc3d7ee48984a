"""pcvt mesh --period X,Y,Z --aspect R,X,Y,Z: elongated cells in space, brute force in their metric."""

import csv
import itertools
import json
import math

from support.cli import CliTest, main
from support.vti import read_vti

CUBE = ("--period", "1,1,1")


def metric(ratio, axis):
    """The map to the round space."""
    length = math.hypot(*axis)
    unit = [x / length for x in axis]

    def to_round(p):
        along = sum(a * b for a, b in zip(unit, p))
        return [ratio ** (1 / 3) * (x + (1 / ratio - 1) * along * a) for x, a in zip(p, unit)]
    return to_round


class Aspect(CliTest):
    def rows(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_voxels_and_tables_are_those_of_power_cells_in_the_metric(self):
        for ratio, axis in ((4, (1, 0, 0)), (0.3, (1, 2, 2))):
            self.succeed("mesh", "--sites", 12, "--period", "1,2,1", "--volumes", "lognormal:0.35", "--phases", "a:0.4,b:0.6",
                         "--orientations", "random", f"--aspect={ratio},{axis[0]},{axis[1]},{axis[2]}", "--voxels", "10,12,8",
                         "-o", "t.vti", "-o", "t.vtu", "--cells", "t.csv", "--report", "r.json", "--force")
            self.assertIn("power cells of 12 sites", self.succeed("check", "t.vtu"))
            self.assertIn("each voxel in the cell of its site", self.succeed("check", "t.vti"))
            report = json.loads(self.path("r.json").read_text(encoding="utf-8"))
            self.assertEqual(report["aspect"], {"ratio": ratio, "axis": list(axis)})
            rows, to_round = self.rows("t.csv"), metric(ratio, axis)
            sites = [([float(row[c]) for c in "xyz"], float(row["weight"])) for row in rows]
            counts, size, corner, materials = read_vti(self.path("t.vti").read_text())
            images = [to_round([i, 2 * j, k]) for i, j, k in itertools.product(range(-3, 4), range(-2, 3), range(-3, 4))]

            def power(p, site):
                d = to_round([a - b for a, b in zip(p, site[0])])
                return min(sum((x + y) ** 2 for x, y in zip(d, image)) for image in images) - site[1]

            for index in range(0, len(materials), 7):
                at = (index % 10, index // 10 % 12, index // 120)
                p = [corner[k] + (at[k] + 0.5) * size[k] / counts[k] for k in range(3)]
                self.assertLess(power(p, sites[materials[index]]) - min(power(p, s) for s in sites), 1e-12)

    def test_a_table_gives_the_same_cells_again(self):
        aspect = ("--aspect", "3,0,1,1")
        self.succeed("mesh", "--sites", 30, *CUBE, *aspect, "--volumes", "gamma:0.3", "--cells", "t.csv")
        self.succeed("mesh", "--input", "t.csv", *CUBE, *aspect, "--max-iterations", 0, "--cells", "u.csv")
        for row, again in zip(self.rows("t.csv"), self.rows("u.csv")):
            self.assertEqual(row["neighbours"], again["neighbours"])
            self.assertAlmostEqual(float(row["volume"]), float(again["volume"]), delta=1e-12)
        volumes = [float(row["volume"]) for row in self.rows("t.csv")]
        self.write("v.txt", "".join(f"{volume!r}\n" for volume in volumes))
        self.succeed("mesh", "--sites", 30, *CUBE, *aspect, "--volumes", "v.txt", "--cells", "w.csv", "-o", "w.vtu")
        for volume, row in zip(volumes, self.rows("w.csv")):
            self.assertAlmostEqual(float(row["volume"]), volume, delta=1e-10 / 30)

    def test_starts_and_tetrahedra_are_mapped_back(self):
        for options in (("--start", "lattice"), ("--start", "coarse"), ("--max-iterations", 0)):
            self.succeed("mesh", "--sites", 50, "--lattice", "1,0,0,0.37,0.81,0,0.2,0.4,0.9", *options, "--aspect", "5,1,1,0",
                         "-o", "t.vtu", "-o", "t.svg", "-o", "t.txt", "--force")
            self.assertIn("Voronoi cells of 50 sites", self.succeed("check", "t.vtu"))
        self.succeed("mesh", "--sites", 50, *CUBE, "--aspect", "5,1,1,0", "-o", "t.msh")
        self.assertIn("volume 1", self.succeed("check", "t.msh"))

    def test_a_ratio_of_one_changes_no_bit(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "-o", "a.txt")
        self.succeed("mesh", "--sites", 20, *CUBE, "--aspect", "1,1,2,3", "-o", "b.txt")
        self.assertEqual(self.path("a.txt").read_bytes(), self.path("b.txt").read_bytes())

    def test_refusals(self):
        for aspect, words in (("0", "between 0.01 and 100"), ("2,0,0,0", "needs a direction"), ("101,1,0,0", "between"),
                              ("x", "number"), ("2,30", "three"), ("2,1,0,0,0", "three")):
            self.refuse(2, "^pcvt: --aspect.*" + words, "mesh", "--sites", 5, *CUBE, "--aspect", aspect)
        for path in ("t.obj", "t.foam"):
            self.refuse(2, rf"^pcvt: -o {path}: such files cannot state the aspect of elongated cells; take .*\.vtu",
                        "mesh", "--sites", 5, *CUBE, "--aspect", 2, "-o", path)
        self.refuse(2, "^pcvt: --short-edges does not work with --aspect in space; leave one of them out$",
                    "mesh", "--sites", 5, *CUBE, "--aspect", 2, "--short-edges", 0.01, "-o", "t.vtu")
        self.refuse(2, "elongated by the aspect: ", "mesh", "--sites", 5, "--lattice", "1,0,0,0,1e-5,0,0,0,1",
                    "--aspect", "0.01,1,0,0")


if __name__ == "__main__":
    main()
