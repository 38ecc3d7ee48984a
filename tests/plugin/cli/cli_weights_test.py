"""pcvt mesh: power cells of given weights, phases of given sites, and tables of cells as an input."""

import csv
import json
import math
import random
import re

from support.cli import CliTest, main
from support.vti import read_vti

MADE = ("mesh", "--sites", 40, "--areas", "lognormal:0.42", "--max-iterations", 3, "--phases", "a:0.3,b:0.7",
        "--orientations", "random")
AGAIN = ("mesh", "--input", "c.csv", "--max-iterations", 0)
CIRCLES = "x,y,R (um)\n0.2,0.3,0.20\n0.7,0.2,0.28\n0.5,0.7,0.25\n0.95,0.8,0.15\n"
# The second site lies in the circle of the first, the fourth in that of the third.
HIDDEN = "x,y,weight\n0.2,0.5,0.05\n0.21,0.5,0\n\n0.7,0.5,0.05\n0.71,0.5,0\n"


class TableTest(CliTest):
    def table(self, name):
        lines = self.path(name).read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def assert_same_cells(self, before, after):
        """Requires the same sites, weights, phases and angles, and areas that differ by rounding."""
        for row, again in zip(self.table(before), self.table(after), strict=True):
            for name in ("x", "y", "weight"):
                self.assertAlmostEqual(float(again[name]), float(row[name]), delta=1e-14)
            for name in ("site", "sides", "phase", "phi1", "Phi", "phi2"):
                self.assertEqual(again[name], row[name])
            self.assertEqual(sorted(again["neighbours"].split()), sorted(row["neighbours"].split()))
            self.assertAlmostEqual(float(again["area"]), float(row["area"]), delta=1e-14)


class Again(TableTest):
    def test_a_table_of_cells_gives_its_cells_again(self):
        for options in ((), ("--aspect", "1.5,30"), ("--walls", "y"), ("--walls", "xy"), ("--lattice", "1,0,0.4,0.9"),
                        ("--aspect", "0.5,70", "--period", "2,1")):
            self.succeed(*MADE, *options, "--cells", "c.csv", "--force")
            self.succeed(*AGAIN, *options, "--cells", "again.csv", "--force")
            self.assert_same_cells("c.csv", "again.csv")

    def test_voxels_and_materials_are_the_same(self):
        self.succeed(*MADE, "--cells", "c.csv", "-o", "v.vti", "--voxels", "64,64")
        self.succeed(*AGAIN, "-o", "w.vti", "--voxels", "64,64")
        before, after = (read_vti(self.path(name).read_text()) for name in ("v.vti", "w.vti"))
        self.assertEqual(before, after)
        entries = [re.findall(r"- phase: (\w+)", self.path(name).read_text())
                   for name in ("v.material.yaml", "w.material.yaml")]
        self.assertEqual(*entries)
        self.assertEqual(len(entries[0]), 40)

    def test_the_files_are_proved(self):
        self.succeed(*MADE, "--cells", "c.csv")
        self.write("a.txt", "".join(f"{row['area']}\n" for row in self.table("c.csv")))
        files = [f"t-{kind}.{extension}" for kind in ("voronoi", "grains") for extension in ("obj", "vtu")]
        self.succeed(*AGAIN, "--mesh", "voronoi", "--mesh", "grains", "-o", "t.obj", "-o", "t.vtu")
        self.succeed(*AGAIN, "--mesh", "grains", "-o", "t.inp", "-o", "t.msh")
        self.succeed(*AGAIN, "-o", "t.vti")
        for name in (*files, "t.inp", "t.msh", "t.vti"):
            self.assertIn("areas of 40 cells within", self.succeed("check", name, "--areas", "a.txt"))

    def test_coincident_sites_are_dropped_with_their_weights_phases_and_angles(self):
        self.succeed(*MADE, "--cells", "c.csv")
        lines = self.path("c.csv").read_text().splitlines(keepends=True)
        first = next(k for k, line in enumerate(lines) if line.startswith("0,"))
        self.write("twice.csv", "".join([*lines[:first + 3], lines[first], *lines[first + 3:], lines[first + 1]]))
        self.refuse(2, r"^twice\.csv:\d+: 2 sites coincide", "mesh", "--input", "twice.csv", "--max-iterations", 0)
        self.succeed("mesh", "--input", "twice.csv", "--max-iterations", 0, "--duplicates", "drop", "--cells", "d.csv")
        self.assert_same_cells("c.csv", "d.csv")

    def test_outputs_need_not_hold_the_phases_and_angles_of_a_table(self):
        self.succeed(*MADE, "--cells", "c.csv")
        for extension in ("om", "obj", "txt", "svg", "dxf"):
            self.succeed(*AGAIN, "-o", f"t.{extension}")
        self.succeed(*AGAIN, "--mesh", "delaunay", "-o", "d.msh", "-o", "d.obj")
        self.succeed("check", "d.msh", "d.obj", "t.obj")
        self.succeed(*AGAIN, "--mesh", "grains", "-o", "g.msh")
        self.assertIn('"phase_a"', self.path("g.msh").read_text())
        self.succeed(*AGAIN, "--colour", "phase", "-o", "p.svg")

    def test_options_win_over_columns(self):
        self.succeed(*MADE, "--cells", "c.csv")
        self.write("w.txt", "0\n" * 40)
        self.write("p.txt", "one\ntwo\n" * 20)
        self.write("o.txt", "1 2 300\n" * 40)
        self.succeed(*AGAIN, "--weights", "w.txt", "--phases", "p.txt", "--orientations", "o.txt", "--cells", "new.csv")
        for k, row in enumerate(self.table("new.csv")):
            self.assertEqual((float(row["weight"]), row["phase"], row["phi2"]), (0, ("one", "two")[k % 2], "300"))
        self.succeed("mesh", "--input", "c.csv", "--areas", "equal", "--max-iterations", 2, "--cells", "equal.csv")
        for row in self.table("equal.csv"):
            self.assertAlmostEqual(float(row["area"]), 1 / 40, delta=1e-10)
        self.succeed("mesh", "--input", "c.csv:x,y", "--cells", "free.csv")
        self.assertEqual({(row["weight"], row["phase"], row["phi1"]) for row in self.table("free.csv")}, {("", "", "")})
        # A column that does not count may hold anything.
        self.write("c.csv", "x,y,weight,phase\n0.1,0.2,light,Iron bcc\n0.6,0.7,,\n")
        self.write("two.txt", "0\n0\n")
        self.succeed(*AGAIN, "--weights", "two.txt", "--phases", "a:1")
        self.refuse(2, r"^c\.csv:2: column 'weight': 'light' is not a number; .*, or take only the positions, "
                       r"--input c\.csv:x,y$", *AGAIN)

    def test_standard_input_has_the_same_columns(self):
        self.succeed(*MADE, "--cells", "c.csv")
        data = self.path("c.csv").read_bytes()
        self.succeed("mesh", "--input", "-", "--max-iterations", 0, "--cells", "s.csv", input=data)
        self.assert_same_cells("c.csv", "s.csv")
        self.refuse(2, r"^standard input: the sites have weights, .*, or take only the positions, --input -:x,y$",
                    "mesh", "--input", "-", input=data)
        self.succeed("mesh", "--input", "-:x,y", input=data)

    def test_weights_of_a_table_need_fixed_sites(self):
        self.succeed(*MADE, "--cells", "c.csv")
        self.refuse(2, r"^c\.csv: the sites have weights, whose cells keep them where they are; add --max-iterations 0, "
                       r"or take only the positions, --input c\.csv:x,y$", "mesh", "--input", "c.csv")
        for option in (("--density", "1 + u"), ("--stability",)):
            self.refuse(2, r"^c\.csv: the sites have weights, which do not work with --density or --stability; leave "
                           r"these out, or take only the positions, --input c\.csv:x,y$", *AGAIN, *option)
        self.write("z.csv", "x,y,z,weight\n0.1,0.2,0.3,1\n")
        self.refuse(2, r"^z\.csv: the sites have weights, .* add --max-iterations 0, or take only the positions, "
                       r"--input z\.csv:x,y,z$", "mesh", "--input", "z.csv", "--period", "1,1,1")


class Space(TableTest):
    def setUp(self):
        super().setUp()
        draw = random.Random(5)
        self.write("b.csv", "x,y,z,radius\n" + "".join(
            f"{draw.random()},{draw.random()},{draw.random()},{draw.uniform(0.1, 0.13)}\n" for _ in range(60)))
        self.made = ("mesh", "--input", "b.csv", "--period", "1,1,1", "--weights", "b.csv:radius", "--max-iterations", 0)

    def test_balls_have_power_cells(self):
        summary = self.succeed(*self.made, "-o", "t.vtu", "--cells", "c.csv", "-o", "t.svg", "-o", "t.txt")
        self.assertIn("weights    squared radii of column radius of b.csv", summary)
        self.assertIn(", power cells of 60 sites within ", self.succeed("check", "t.vtu"))
        rows = [line.split(",") for line in self.path("c.csv").read_text().splitlines() if not line.startswith("#")]
        self.assertAlmostEqual(sum(float(row[5]) for row in rows[1:]), 1, delta=1e-12)

    def test_a_table_of_cells_gives_the_same_cells(self):
        self.succeed(*self.made, "-o", "t.vtu", "--cells", "c.csv", "--orientations", "random", "--phases", "a:0.4,b:0.6")
        self.succeed("mesh", "--input", "c.csv", "--period", "1,1,1", "--max-iterations", 0, "-o", "s.vtu")
        self.assertEqual(self.path("t.vtu").read_bytes(), self.path("s.vtu").read_bytes())

    def test_equal_weights_give_voronoi_cells(self):
        self.write("w.txt", "0.5\n" * 60)
        given = ("mesh", "--input", "b.csv:x,y,z", "--period", "1,1,1", "--max-iterations", 0)
        self.succeed(*given, "--weights", "w.txt", "--cells", "c.csv")
        self.succeed(*given, "--cells", "v.csv")
        tables = [[line.split(",") for line in self.path(name).read_text().splitlines() if not line.startswith("#")]
                  for name in ("c.csv", "v.csv")]
        for weighted, plain in zip(*tables, strict=True):
            self.assertEqual(weighted[:4] + weighted[-1:], plain[:4] + plain[-1:])
        for weighted, plain in zip(tables[0][1:], tables[1][1:]):
            self.assertAlmostEqual(float(weighted[5]), float(plain[5]), delta=1e-13)

    def test_what_power_cells_lack_is_refused(self):
        for path in ("t.msh", "t.om"):
            self.refuse(2, "cannot state the weights of power cells; take .obj, .ply, .glb, .stl, .vtu", *self.made, "-o", path)
        self.refuse(2, "--short-edges does not work with --weights in space", *self.made, "--short-edges", 0.01, "-o",
                    "t.vtu")
        x, y, z, _ = map(float, self.path("b.csv").read_text().splitlines()[1].split(","))
        self.write("b.csv", self.path("b.csv").read_text() + f"{x + 0.005},{y},{z},0.001\n")
        self.refuse(2, r"^b\.csv:62: the cell of this site is empty", *self.made, "-o", "t.vtu")


class Weights(TableTest):
    def setUp(self):
        super().setUp()
        self.write("s.csv", CIRCLES)
        self.run_fixed = ("mesh", "--input", "s.csv", "--max-iterations", 0)

    def test_radii_are_squared(self):
        self.write("d.txt", "".join(f"{2 * r}\n" for r in (0.20, 0.28, 0.25, 0.15)))
        self.write("w.txt", "".join(f"{r * r!r}\n" for r in (0.20, 0.28, 0.25, 0.15)))
        self.write("m.csv", CIRCLES.replace("R (um)", "size"))
        for k, name in enumerate(("s.csv", "s.csv:R", "diameter:d.txt", "w.txt", "weight:w.txt", "radius:m.csv:size")):
            self.succeed(*self.run_fixed, "--weights", name, "--cells", f"c{k}.csv")
            self.assertIn("# The power cells (Laguerre cells) of one period", self.path(f"c{k}.csv").read_text())
            for row, radius in zip(self.table(f"c{k}.csv"), (0.20, 0.28, 0.25, 0.15), strict=True):
                self.assertAlmostEqual(float(row["weight"]), radius ** 2, delta=1e-16)
        self.assertEqual(self.path("c0.csv").read_bytes(), self.path("c1.csv").read_bytes())

    def test_the_cells_are_those_of_the_power_distance(self):
        self.succeed(*self.run_fixed, "--weights", "s.csv", "-o", "t.vti", "--voxels", "50,50")
        counts, _, _, cells = read_vti(self.path("t.vti").read_text())
        sites = [tuple(map(float, line.split(","))) for line in CIRCLES.splitlines()[1:]]

        def power(site, x, y):
            dx, dy = (abs(a - b) for a, b in zip(site, (x, y)))
            return min(dx, 1 - dx) ** 2 + min(dy, 1 - dy) ** 2 - site[2] ** 2

        for k, cell in enumerate(cells):
            x, y = (k % counts[0] + 0.5) / counts[0], (k // counts[0] + 0.5) / counts[1]
            least = min(power(site, x, y) for site in sites)
            self.assertLessEqual(power(sites[cell], x, y), least + 1e-12)

    def test_summary_and_report_state_the_source(self):
        out = self.succeed(*self.run_fixed, "--weights", "s.csv", "--report", "r.json")
        self.assertIn("\nweights    squared radii of column R (um) of s.csv\n", out)
        weights = json.loads(self.path("r.json").read_text())["weights"]
        self.assertEqual(weights["source"], "squared radii of column R (um) of s.csv")
        self.assertTrue(math.isclose(weights["least"], 0.0225) and math.isclose(weights["greatest"], 0.0784))
        self.succeed("mesh", "--sites", 9, "--report", "q.json")
        self.assertNotIn("weights", json.loads(self.path("q.json").read_text()))

    def test_contradictions_are_one_message(self):
        sites = ("mesh", "--input", "s.csv", "--weights", "s.csv")
        keeps = "--weights keeps sites where they are; add --max-iterations 0, or leave the weights out"
        self.refuse(2, f"^pcvt: {keeps}$", *sites, "-o", "t.obj")
        for option in (("--areas", "equal"), ("--density", "1 + u"), ("--stability",)):
            self.refuse(2, "^pcvt: --weights does not work with --areas, --density or --stability; leave one of them "
                           "out$", *sites, "--max-iterations", 0, *option)
        self.refuse(2, rf"^pcvt: \(1\) .*; \(\d\) {keeps}; \(\d\) --weights does not work with .*$", *sites, "--areas",
                    "equal", "--density", "1 + u")
        self.refuse(2, "^pcvt: --weights is for the sites of --input; add it$", "mesh", "--sites", 4, "--weights", "s.csv")
        self.refuse(2, "^pcvt: --wall-cells half moves sites", *sites, "--max-iterations", 0, "--walls", "y",
                    "--wall-cells", "half")

    def test_formats_of_voronoi_cells_are_refused_and_no_file_changes(self):
        self.write("t.nc", "mine")
        self.write("t.obj", "mine")
        self.refuse(2, r"^pcvt: -o t\.nc: the grid needs Voronoi cells; leave areas, weights and aspect out, or take ",
                    *self.run_fixed, "--weights", "s.csv", "-o", "t.nc", "-o", "t.obj", "--force")
        self.refuse(3, r"t\.obj.*--force", *self.run_fixed, "--weights", "s.csv", "-o", "t.obj")
        self.write("h.csv", HIDDEN)
        self.refuse(2, r"^h\.csv:3: ", "mesh", "--input", "h.csv", "--max-iterations", 0, "-o", "t.obj", "--force")
        self.refuse(2, r"s\.csv", *self.run_fixed, "--weights", "s.csv", "--cells", "s.csv", "--force")

    def test_empty_cells_are_named_by_their_lines(self):
        self.write("h.csv", HIDDEN)
        run = ("mesh", "--input", "h.csv", "--max-iterations", 0)
        for walls in ((), ("--walls", "x"), ("--walls", "xy")):
            self.refuse(2, r"^h\.csv:3: the cells of these sites are empty, because the weights of others reach over "
                           r"them: lines 3, 6; remove the lines, or give larger weights$", *run, *walls)
        one = "".join(HIDDEN.splitlines(keepends=True)[:5])
        self.write("h.csv", one)
        self.refuse(2, r"^h\.csv:3: the cell of this site is empty, because the weights of others reach over it; remove "
                       r"the line, or give larger weights$", *run)
        self.write("h.csv", one.replace("\n0.21", "\n0.2,0.5,0.05\n0.21"))
        self.refuse(2, r"^h\.csv:4: the cell of this site is empty", *run, "--duplicates", "drop")

    def near_empty_radius(self, *options, halvings=60):
        """Returns the smallest radius of the second site of which there are files, and the lines of those below it."""
        low, high, lines = 0.1, 0.2, set()
        for _ in range(halvings):
            radius = (low + high) / 2
            self.write("n.csv", f"x,y,r\n0.5,0.5,0.1\n\n0.3,0.2,{radius!r}\n0.2,0.2,0.3\n0.8,0.2,0.1\n0.3,0.8,0.1\n")
            done = self.run_pcvt("mesh", "--input", "n.csv:x,y", "--weights", "n.csv", "--max-iterations", 0, "-o", "n.obj",
                                 "--force", "--quiet", *options)
            if done.returncode == 0:
                high = radius
            else:
                low = radius
                lines.add((done.returncode, done.stderr.decode()))
        return high, lines

    def test_cells_that_are_nearly_empty_are_named_by_their_lines(self):
        tiny = ("n.csv:4: the cell of this site is nearly empty, smaller than 1e-9 of the spacing, because the weights of others reach "
                "over it; remove the line, or give a larger weight\n")
        for walls in ((), ("--walls", "y")):
            _, lines = self.near_empty_radius(*walls)
            self.assertIn((2, tiny), lines)
        # Grains end at cells that are some 1e-4 wide, and take long there.
        _, lines = self.near_empty_radius("--mesh", "grains", halvings=15)
        thin = r"^pcvt: n\.csv:\d: the cell of this site is too thin to be meshed by grains; change its weight or .* --mesh voronoi\n$"
        self.assertTrue([line for code, line in lines if code == 4 and re.match(thin, line)], lines)

    def test_wrong_weights_are_one_line(self):
        for text, words in (("1\n2\n", r"w\.txt:2: the last of 2 weights, but there are 4 sites; give one weight"),
                            ("1\n" * 5, r"w\.txt:5: weight 5, but there are 4 sites; give one weight"),
                            ("radius\n-1\n", r"w\.txt:2: '-1' is negative; give a length from 0 on"),
                            ("1\nnan\n", r"w\.txt:2: 'nan' is not a finite number"),
                            ("1\n1e150\n", r"w\.txt:2: '1e150' is too large; give a number below 1e150"),
                            ("size\n1\n", r"w\.txt:1: column 'size' could hold weights, radii or diameters; say which"),
                            ("# none\n", r"w\.txt: holds no weight; give one a line")):
            self.write("w.txt", text)
            self.refuse(2, "^" + words, *self.run_fixed, "--weights", "w.txt", "-o", "t.obj")
        self.refuse(2, r"^none\.txt: cannot read", *self.run_fixed, "--weights", "none.txt")

    def test_every_file_has_the_same_bytes_for_any_number_of_threads(self):
        found = []
        for threads in (1, 3):
            self.succeed(*self.run_fixed, "--weights", "s.csv", "--threads", threads, "--force", "-o", "t.obj", "-o",
                         "t.vtu", "--cells", "t.csv")
            found.append(self.contents())
        self.assertEqual(*found)


class Phases(TableTest):
    def test_the_phases_of_a_file_belong_to_its_rows(self):
        self.write("s.txt", "0.1 0.2\n0.7 0.8\n0.3 0.6\n")
        self.write("p.txt", "soft\nhard\nsoft\n")
        out = self.succeed("mesh", "--input", "s.txt", "--phases", "p.txt", "--cells", "c.csv", "--report", "r.json")
        self.assertEqual([row["phase"] for row in self.table("c.csv")], ["soft", "hard", "soft"])
        self.assertRegex(out, r"\nphase      soft \S+ of the area in 2 cells\nphase      hard \S+ of the area in 1 cells\n")
        for phase in json.loads(self.path("r.json").read_text())["phases"]:
            self.assertEqual(phase["wanted"], phase["reached"])

    def test_drawn_sites_have_the_phases_of_their_numbers(self):
        names = [("a", "b", "c")[k * k % 3] for k in range(30)]
        self.write("p.csv", "id;Phase\n" + "".join(f"{k};{name}\n" for k, name in enumerate(names)))
        for options in ((), ("--seed", 3, "--walls", "y"), ("--areas", "gamma:0.3", "--max-iterations", 2)):
            self.succeed("mesh", "--sites", 30, *options, "--phases", "p.csv", "--cells", "c.csv", "--force")
            self.assertEqual([row["phase"] for row in self.table("c.csv")], names)
        self.succeed("mesh", "--sites", 30, "--phases", "p.csv:Phase", "--mesh", "grains", "-o", "t.inp")
        self.succeed("check", "t.inp")
        phases = dict(re.findall(r"ELSET=CELL_(\d+),MATERIAL=(\w)", self.path("t.inp").read_text()))
        self.assertEqual([phases[str(k)] for k in range(30)], names)

    def test_a_file_that_exists_wins_over_fractions_and_a_folder_does_not(self):
        self.path("soft").mkdir()
        out = self.succeed("mesh", "--sites", 3, "--phases", "soft:1")
        self.assertRegex(out, r"phase +soft 1 of the area in 3 cells; wanted 1\n")
        self.write("hard", "name other\nx 1\ny 2\nx 3\n")
        self.succeed("mesh", "--sites", 3, "--phases", "hard:1", "--cells", "c.csv")
        self.assertEqual([row["phase"] for row in self.table("c.csv")], ["x", "y", "x"])
        long = ",".join(f"{letter * 60}:0.2" for letter in "abcde")
        self.succeed("mesh", "--sites", 5, "--phases", long)

    def test_wrong_files_are_one_line(self):
        run = ("mesh", "--sites", 3, "-o", "t.obj", "--phases")
        self.refuse(2, "^pcvt: --phases 'none.csv': 'none.csv' is not a phase; write NAME:FRACTION, such as ferrite:0.3; "
                       "there is no file of that name$", *run, "none.csv")
        for text, words in (("a\nb\n", "^pcvt: there are 2 phases for 3 sites; give one for each site$"),
                            ("a\nIron bcc\nb\n", r"^p\.csv:2: this line has 2 words; write one phase a line$"),
                            ("b\nA\na\n", r"^p\.csv:3: the phase a is given twice"),
                            ("id,phase\n1,a\n2,\n3,b\n", r"^p\.csv:3: column 'phase': the field is empty; fill it$"),
                            ("1 a\n2 b\n3 c\n", r"^p\.csv:1: the table has several columns; name that of the phases, such"),
                            ("# none\n", r"^p\.csv: holds no phase; give one a line, one for each site$")):
            self.write("p.csv", text)
            self.refuse(2, words, *run, "p.csv")
        self.write("t.obj", "a\nb\nc\n")
        self.refuse(2, r"t\.obj", *run, "t.obj", "--force")


if __name__ == "__main__":
    main()
