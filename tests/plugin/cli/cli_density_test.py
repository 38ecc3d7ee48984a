"""Densities on the command line: formulas and pictures, refusals and reports."""

import json
import math
import os
import re
import resource
import struct
import time
import zlib

from support.cli import CliTest, limit, main

RIDGE = "1 + 99 * exp(-((v - 0.5) / 0.1)^2)"


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def png(width, height, rows, colour=0, before=b""):
    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    pixels = b"".join(b"\0" + bytes(row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + before +
            chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b""))


def blob(size):
    """Returns a dark picture with a bright spot in the middle."""
    def value(c, r):
        d = math.hypot(c - (size - 1) / 2, r - (size - 1) / 2) / size
        return round(255 * math.exp(-((d / 0.2) ** 2)))
    return png(size, size, [[value(c, r) for c in range(size)] for r in range(size)])


class GradedMesh(CliTest):
    def report(self, *arguments, **options):
        self.succeed("mesh", "--quiet", "--force", "--report", "r.json", *arguments, **options)
        return json.loads(self.path("r.json").read_text())

    def sites(self, name):
        lines = self.path(name).read_text().splitlines()
        return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]

    def test_a_picture_gives_an_automatic_period_its_aspect(self):
        self.write("wide.png", png(40, 30, [[k % 200 for k in range(40)]] * 30))
        report = self.report("--sites", 60, "--density", "wide.png", "--period", "auto", "--max-iterations", 0)
        self.assertEqual(report["lattice"], [[1, 0], [0, 0.75]])

    def test_a_formula_grades_the_mesh_and_is_reported(self):
        report = self.report("--sites", 300, "--density", RIDGE, "-o", "t.obj", "-o", "t.svg")
        self.assertEqual(report["stop"], "converged")
        self.assertIsNone(report["energy_bound"])
        self.assertEqual(report["density"], RIDGE)
        self.assertAlmostEqual(report["density_greatest"], 100, delta=0.5)
        self.assertGreater(report["density_evaluations"], 20)
        self.assertLess(abs(report["mass_deviation"]), 1e-7)
        self.assertLess(report["spacing_deviation"], 0.05)
        self.assertAlmostEqual(report["energy"] / report["expected_energy"], 1, delta=0.05)
        self.assertEqual(report["rough_cells"], 0)
        self.assertRegex(self.path("t.svg").read_text(), r"by size")

    def test_a_page_holds_the_density_at_each_site(self):
        self.succeed("mesh", "--sites", 40, "--density", "1 + u", "--max-iterations", 0, "-o", "t.html", "-o", "s.txt")
        data = re.search(r'id="data">([^<]*)<', self.path("t.html").read_text())[1]
        densities = json.loads(data)["densities"]
        self.assertEqual(len(densities), 40)
        for (x, _), density in zip(self.sites("s.txt"), densities):
            self.assertAlmostEqual(density, 1 + x, delta=1e-12)

    def test_without_a_density_its_keys_are_left_out(self):
        report = self.report("--sites", 30)
        self.assertFalse([key for key in report if "density" in key or "mass" in key])
        self.assertIsNotNone(report["energy_bound"])

    def test_check_proves_the_cells_of_the_density_and_of_no_other(self):
        self.report("--sites", 200, "--density", RIDGE, "-o", "t.obj", "-o", "d.obj")
        check = ("check", "t.obj", "--cvt", "1e-5")
        self.assertIn("centroidal Voronoi", self.succeed(*check, "--density", RIDGE))
        self.refuse(2, "off the bisector", *check)
        self.refuse(2, "off the bisector", *check, "--density", "1 + u")
        self.refuse(2, "--cvt", "check", "t.obj", "--density", RIDGE)

    def test_the_same_bytes_for_any_number_of_threads_and_locale(self):
        arguments = ("--sites", 400, "--density", "1.5 + sin(2*pi*u) + 0.25*v", "--tolerance", 1e-3)
        self.report(*arguments, "-o", "one.txt", "--threads", 1)
        self.report(*arguments, "-o", "three.txt", "--threads", 3,
                    env={**os.environ, "LC_ALL": "de_DE.UTF-8"})
        self.assertEqual(self.path("one.txt").read_bytes(), self.path("three.txt").read_bytes())

    def test_a_picture_grades_the_mesh(self):
        self.write("blob.PNG", blob(24))
        report = self.report("--sites", 150, "--density", "blob.PNG", "-o", "t.txt")
        self.assertEqual((report["stop"], report["rough_cells"]), ("converged", 0))
        self.assertAlmostEqual(report["density_least"], 0.01, delta=1e-3)
        self.assertLess(abs(report["mass_deviation"]), 1e-12)
        near = sum(math.hypot(x - 0.5, y - 0.5) < 0.25 for x, y in self.sites("t.txt"))
        self.assertGreater(near, 60)
        turned = self.report("--sites", 150, "--density", "blob.PNG", "--density-range", "1,0.01")
        self.assertLess(turned["mass"], 1)
        self.assertGreater(turned["mass"], report["mass"])

    def test_the_largest_picture_takes_little_memory_and_time(self):
        small = limit(resource.RLIMIT_AS, 1 << 30)
        if self.run_pcvt("--version", preexec_fn=small).returncode != 0:
            self.skipTest("this build does not start in so little memory")
        for width, height in ((4096, 4096), (16384, 1024), (1024, 16384)):
            row = bytes(64 + 191 * x // width for x in range(width))
            self.write("large.png", png(width, height, [row] * height))
            began = time.monotonic()
            report = self.report("--sites", 60, "--density", "large.png", "--max-iterations", 0,
                                 "--threads", 1, preexec_fn=small)
            # Quadrature on each pixel takes 24 s, sums over columns of pixels 2 s.
            self.assertLess(time.monotonic() - began, 12)
            self.assertLess(abs(report["mass_deviation"]), 1e-12)
        self.write("wide.png", png(16385, 2, [[0] * 16385] * 2))
        self.refuse(4, "more than 16384 along a side; scale", "mesh", "--sites", 60, "--density", "wide.png")

    def test_rows_of_a_picture_run_downwards(self):
        self.write("top.png", png(1, 8, [[255]] * 3 + [[0]] * 5))
        self.report("--sites", 60, "--density", "top.png", "-o", "t.txt")
        self.assertGreater(sum(y > 0.55 for _, y in self.sites("t.txt")), 36)

    def test_a_checkerboard_converges(self):
        board = "(u < 0.5) == (v < 0.5) ? 100 : 1"
        report = self.report("--sites", 200, "--density", board)
        self.assertEqual((report["stop"], report["rough_cells"]), ("converged", 0))

    def test_a_jump_along_a_curve_ends_and_is_explained(self):
        disc = "(u-0.5)^2 + (v-0.5)^2 < 0.09 ? 100 : 1"
        text = self.succeed("mesh", "--sites", 100, "--density", disc)
        self.assertRegex(text, r"stop +stalled")
        self.assertRegex(text, r"rough +\d+ cells where the density is not smooth")


class BadDensity(CliTest):
    def refuse_density(self, code, pattern, density, *arguments):
        with self.subTest(density):
            self.refuse(code, pattern, "mesh", "--sites", 20, "-o", "t.obj", "--density", density,
                        *arguments)

    def test_a_density_that_is_not_positive_and_finite_names_the_place(self):
        for density, value in (("u", "0"), ("sin(2*pi*u)", "0"), ("1/v", "inf"), ("-1", "-1"),
                               ("sqrt(u - 0.5)", "not a number"), ("x < 0.7 ? 1 : 0/0", "not a number"),
                               ("1e308 * 10", "inf")):
            self.refuse_density(2, rf"the density is {value} at x = .*, y = .*\(u = .*, v = .*; make",
                                density)
        self.refuse_density(2, "contrast above 1e12", "exp(60 * u)")
        self.refuse_density(2, "contrast above 1e12", "u < 0.5 ? 1e13 : 1")
        self.refuse_density(2, "between 1e-60 and 1e60", "1e70")

    def test_a_fault_of_the_formula_names_its_character(self):
        for density, place in (("1 +", 4), ("1 + foo", 5), ("sin(u", 6), ("1 + 2,5", 6),
                               ("u = 2", 3), ("", 1), ("1 + u)", 6)):
            self.refuse_density(2, rf"--density .*: character {place}: .*; ", density)

    def test_a_bad_picture_is_refused(self):
        whole = blob(8)
        self.write("cut.png", whole[:-20])
        self.write("text.png", "no picture")
        self.write("empty.png", "")
        self.write("damaged.png", whole[:60] + b"x" + whole[61:])
        self.write("bare.png", png(2, 1, [[0, 1]], colour=3))
        self.path("folder.png").mkdir()
        for name, what in (("cut", "truncated"), ("text", "not a PNG"), ("empty", "not a PNG"),
                           ("damaged", "damaged"), ("bare", "without its palette"),
                           ("folder", "cannot read"), ("missing", "cannot read")):
            self.refuse_density(2, rf"^{name}\.png: .*{what}.*; ", name + ".png")

    def test_pictures_are_refused_before_memory_is_allocated(self):
        little = limit(resource.RLIMIT_AS, 400 << 20)
        if self.run_pcvt("--version", preexec_fn=little).returncode != 0:
            self.skipTest("this build does not start in so little memory")
        self.write("huge.png", png(100000, 100000, [[0]]))
        self.write("bare.png", png(4096, 4096, [[0]], colour=3))
        with self.path("long.png").open("wb") as file:
            file.truncate(1 << 30)
        mesh = ("mesh", "--sites", 20, "--density")
        self.refuse(4, r"long\.png: more than 256 MiB", *mesh, "long.png", preexec_fn=little)
        self.path("long.png").unlink()
        self.refuse(4, r"huge\.png: 100000 x 100000 pixels", *mesh, "huge.png",
                    preexec_fn=little)
        self.refuse(2, "without its palette", *mesh, "bare.png", preexec_fn=little)

    def test_a_range_is_two_positive_densities_of_a_picture(self):
        self.write("p.png", blob(4))
        for text in ("0,1", "-1,1", "1", "1,2,3", "1,nan", "a,b", "1,1e70"):
            self.refuse_density(2, r"--density-range ", "p.png", "--density-range", text)
        self.refuse_density(2, r"--density-range is for .*png", "1+u", "--density-range", "1,2")
        self.refuse(2, "--density-range is for", "mesh", "--sites", 3, "--density-range", "1,2")

    def test_the_picture_must_not_be_an_output(self):
        self.write("p.png", blob(4))
        os.symlink(self.path("p.png"), self.path("link.svg"))
        self.refuse(2, "an input", "mesh", "--sites", 9, "--density", "p.png", "-o", "link.svg",
                    "--force")


if __name__ == "__main__":
    main()
