"""Sites of a file that coincide to 1e-9 of their spacing: refused by all of their lines, or dropped."""

import json

from support.cli import CliTest, main

PLANE = "# x y\n0.1 0.2\n0.6 0.7\n\n1.1 0.2\n0.3 0.9\n0.6 0.70000000005\n"
SPACE = "".join(line + " 0.5\n" if line[:1].isdigit() else line + "\n" for line in PLANE.split("\n")[:-1])
FOUND = r"2 sites coincide with earlier ones modulo the lattice, to 1e-9 of the spacing: " \
        r"line 5 with line 2, line 7 with line 3; remove them, or give the periods by --period or " \
        r"--lattice, or add --duplicates drop$"


class Duplicates(CliTest):
    def setUp(self):
        super().setUp()
        self.write("plane.txt", PLANE)
        self.write("space.txt", SPACE)

    def mesh(self, name, *options):
        box = ("--period", "1,1,1") if name == "space.txt" else ()
        return ("mesh", "--input", name, *box, "--max-iterations", 0, *options)

    def test_all_of_them_are_named_before_the_run(self):
        for name in ("plane.txt", "space.txt"):
            with self.subTest(name):
                self.refuse(2, f"^{name}:5: {FOUND}", *self.mesh(name))
                self.refuse(2, f"^{name}:5: {FOUND}", *self.mesh(name, "--duplicates", "refuse"))

    def test_the_first_of_them_is_kept_and_the_others_are_stated(self):
        for name in ("plane.txt", "space.txt"):
            with self.subTest(name):
                run = self.succeed(*self.mesh(name, "--duplicates", "drop", "-o", "kept.txt", "--report", "r.json",
                                              "--force"))
                self.assertRegex(run, r"(?m)^duplicates 2 sites dropped, which coincide modulo the lattice: line 5 with line 2, "
                                             r"line 7 with line 3$")
                report = json.loads(self.path("r.json").read_text())
                self.assertEqual(report["sites"], 3)
                self.assertEqual(report["duplicates"],
                                 {"dropped": 2, "sites": [[2, 0], [4, 1]], "lines": [[5, 2], [7, 3]]})
                kept = [line.split()[:2] for line in self.path("kept.txt").read_text().splitlines() if line[0] != "#"]
                self.assertEqual([[round(float(x), 6) for x in site] for site in kept],
                                 [[0.1, 0.2], [0.6, 0.7], [0.3, 0.9]])

    def test_a_forgotten_period_is_called_in_doubt(self):
        for name, rest, period in (("grid.txt", "", "1,1"), ("box.txt", " 3", "1,1,1")):
            self.write(name, "".join(f"{x} {y}{rest}\n" for x in range(4) for y in range(3)))
            run = self.succeed("mesh", "--input", name, "--period", period, "--duplicates", "drop", "--max-iterations", 0)
            self.assertRegex(run, r"(?m)^duplicates 11 sites dropped, .*; --period or --lattice may be wrong$")

    def test_areas_that_give_the_period_belong_to_all_sites(self):
        self.write("areas.txt", "1\n2\n3\n4\n")
        self.write("sites.txt", "0.1 0.2\n1.1 1.2\n0.1 0.2\n0.5 2.5\n")
        run = ("mesh", "--input", "sites.txt", "--areas", "areas.txt", "--period", "auto", "--duplicates", "drop")
        self.refuse(2, "^pcvt: --period auto takes the areas of all sites, but 1 of them coincides with an earlier one; "
                    "remove it from the file of sites, and its area$", *run)

    def test_sites_that_single_precision_makes_one_are_proved(self):
        # The first two lie 1.6e-9 apart.
        self.write("close.txt", "0.13388144384673584 0.92636529238693333\n0.13388144544699582 0.92636529238693333\n"
                                "0.52729644320019597 0.93232113116792048\n0.93547618889414508 0.5759150523208032\n"
                                "0.11430113589330226 0.34323887226787031\n0.0021869326496918307 0.69617076500162578\n")
        for edges in (0.001, 0.05, 0.3):
            with self.subTest(edges):
                self.succeed("mesh", "--input", "close.txt", "--areas", "equal", "--max-iterations", 0, "--period",
                             "0.535351854,1", "--mesh", "grains", "--short-edges", edges, "-o", "t.gltf", "-o", "t.ply", "--force")
                self.succeed("check", "t.gltf", "t.ply")

    def test_without_any_the_summary_says_so(self):
        self.write("one.txt", "0.1 0.2\n")
        run = self.succeed(*self.mesh("one.txt", "--duplicates", "drop", "--report", "r.json"))
        self.assertRegex(run, r"(?m)^duplicates 0 sites dropped$")
        self.assertEqual(json.loads(self.path("r.json").read_text())["duplicates"], {"dropped": 0, "sites": []})

    def test_areas_and_orientations_follow_their_sites(self):
        self.write("areas.txt", "1\n2\n9\n3\n9\n")
        self.write("angles.txt", "".join(f"{k} 0 0\n" for k in range(5)))
        self.succeed(*self.mesh("plane.txt", "--duplicates", "drop", "--areas", "areas.txt", "--orientations",
                                "angles.txt", "--cells", "cells.csv"))
        rows = [line.split(",") for line in self.path("cells.csv").read_text().splitlines() if line[0] != "#"]
        areas = [float(row[rows[0].index("area")]) for row in rows[1:]]
        self.assertEqual([round(6 * area, 6) for area in areas], [1, 2, 3])
        self.assertEqual([float(row[rows[0].index("phi1")]) for row in rows[1:]], [0, 1, 3])

    def test_sites_on_opposite_walls_do_not_coincide(self):
        self.write("walls.txt", "0.5 0\n0.5 1\n0.2 0.5\n0.7 0.5\n")
        self.succeed("mesh", "--input", "walls.txt", "--walls", "y", "--max-iterations", 0)

    def test_fixed_sites(self):
        self.refuse(2, f"^plane.txt:5: {FOUND}", "mesh", "--sites", 9, "--fixed", "plane.txt")
        run = self.succeed("mesh", "--sites", 9, "--fixed", "plane.txt", "--duplicates", "drop")
        self.assertRegex(run, r"(?m)^sites      9$")
        self.assertRegex(run, r"(?m)^duplicates 2 sites dropped")

    def test_without_a_file_the_choice_is_refused(self):
        self.refuse(2, "^pcvt: --duplicates is for sites of a file; add --input FILE, or leave it out$", "mesh",
                    "--sites", 9, "--duplicates", "drop")
        self.refuse(2, "--duplicates keep: unknown; take refuse or drop$", *self.mesh("plane.txt", "--duplicates", "keep"))


if __name__ == "__main__":
    main()
