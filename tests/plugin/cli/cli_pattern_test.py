"""pcvt pattern and --start lattice: exact lattices as tiles, in all formats and on all lattices."""

import json
import re
import resource
import unittest

from support.cli import CliTest, main

SQUARE_MINIMA = {3: 0.0596707818930041, 30: 0.00534814814814815, 56: 0.00286393256282105}
LATTICES = (
    ("--period", "1,1"),
    ("--period", "30,1"),
    ("--period", "1e-5,2e-5"),
    ("--lattice", "1,0,0.37,0.81"),
    ("--lattice", "1,0,7,1"),
    ("--lattice", "0,1,1,0.2"),
    ("--lattice", "1,0,0.5,0.8660254037844386"),
)


class Pattern(CliTest):
    def report(self, *arguments):
        self.succeed(*arguments, "--report", "run.json", "--force", "--quiet")
        return json.loads(self.path("run.json").read_text())

    def test_the_summary_shows_basis_energy_ratio_and_stability(self):
        text = self.succeed("pattern", "--sites", 10)
        self.assertRegex(text, r"pattern +\(0\.3, 0\.1\) \(-0\.1, 0\.3\), energy 0\.0166667, 1\.03923 of")
        self.assertRegex(text, r"stability +the pattern is a saddle; smallest eigenvalue -0\.155")

    def test_the_report_holds_the_known_energies(self):
        for n, energy in SQUARE_MINIMA.items():
            report = self.report("pattern", "--sites", n)
            self.assertAlmostEqual(report["energy"] / energy, 1, delta=1e-12)
            self.assertAlmostEqual(report["pattern"]["energy"] / energy, 1, delta=1e-12)
            self.assertEqual((report["start"], report["stop"]), ("lattice", "converged"))
            self.assertLess(report["residual"], 1e-12)

    def test_all_sites_are_combinations_of_the_basis_also_of_elongated_cells(self):
        for options in ((), ("--aspect", "2"), ("--aspect", "0.4,30", "--lattice", "1,0,0.37,0.81")):
            report = self.report("pattern", "--sites", 12, *options, "-o", "t.txt")
            (ax, ay), (bx, by) = report["pattern"]["basis"]
            area = ax * by - ay * bx
            lines = [line for line in self.path("t.txt").read_text().splitlines() if not line.startswith("#")]
            sites = [tuple(map(float, line.split())) for line in lines]
            self.assertEqual(len(sites), 12)
            for x, y in sites:
                x, y = x - sites[0][0], y - sites[0][1]
                for number in ((x * by - y * bx) / area, (ax * y - ay * x) / area):
                    self.assertAlmostEqual(number, round(number), delta=1e-9)

    def test_every_lattice_is_a_proved_tile_of_cells_and_of_triangles(self):
        for lattice in LATTICES:
            for n in (1, 2, 9, 10, 36, 97):
                with self.subTest(lattice=lattice, n=n):
                    self.report("pattern", "--sites", n, *lattice, "--mesh", "voronoi", "--mesh",
                                "delaunay", "-o", "t.obj", "-o", "t.ply")
                    names = [f"t-{kind}.{e}" for kind in ("voronoi", "delaunay")
                             for e in ("obj", "ply")]
                    self.assertEqual(len(self.succeed("check", *names, "--cvt").splitlines()), 4)

    def test_it_accepts_the_outputs_of_mesh(self):
        formats = ("obj", "ply", "glb", "gltf", "om", "svg", "txt")
        self.succeed("pattern", "--sites", 12, "--repeat", "2x1", "--origin", "0.3,0.2",
                     *(word for e in formats for word in ("-o", f"t.{e}")))
        self.assertLessEqual({f"t.{e}" for e in formats}, set(self.contents()))
        self.assertRegex(self.succeed("check", "t.ply"), "24 faces")
        self.assertRegex(self.succeed("check", "t.obj", "--period", "2,1"), "24 faces")

    def test_three_thousand_cells_take_less_than_two_seconds(self):
        # The time of the processors, since other tests may run beside this one.
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.succeed("pattern", "--sites", 3000, "-o", "t.obj", "-o", "t.glb", "-o", "t.svg")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 2)

    def test_options_of_the_optimiser_are_refused(self):
        for option in ("--seed", "--input", "--solver", "--tolerance", "--max-iterations",
                       "--start", "--density", "--areas", "--symmetry", "--walls", "--wall-cells", "--fixed",
                       "--inclusions", "--fibres", "--hole", "--duplicates", "--weights"):
            self.refuse(2, option + " is not for pattern.*; leave it out", "pattern", "--sites", 3,
                        option, 1)
        self.refuse(2, "--period auto is not for pattern", "pattern", "--sites", 3, "--period", "auto")
        self.refuse(2, "no sites; give --sites N$", "pattern")
        self.refuse(2, "see pcvt pattern --help", "pattern", "--size", 1, "--bogus")

    def test_the_help_lists_no_option_that_is_always_refused(self):
        job = ("--mesh", "grains", "-o", "t.inp", "--job", "elastic")
        values = {"--sites": (4,), "--period": ("2,1",), "--lattice": ("1,0,0.4,1",), "--origin": ("0.1,0",), "--aspect": (2,),
                  "--threads": (1,), "--phases": ("a:1", "-o", "t.csv"), "--orientations": ("random", "-o", "t.csv"),
                  "--material": ("GRAINS:1,0.3", *job), "--mesh": ("delaunay",), "--outline": ("box",),
                  "--size": (0.1, "--mesh", "grains"), "--per-edge": (2, "--mesh", "grains"),
                  "--order": (2, "--mesh", "grains", "-o", "t.msh"), "--short-edges": (0.1,), "--repeat": ("2x1",), "-o": ("t.obj",),
                  "--colour": ("size", "-o", "t.svg"), "--background": ("none", "-o", "t.svg"), "--glb-nodes": ("one", "-o", "t.glb"),
                  "--float32": ("-o", "t.ply"), "--pixels": (16, "-o", "t.png"), "--voxels": ("8,8", "-o", "t.vti"),
                  "--cut": (10, "-o", "t.dxf"), "--coriolis": ("1e-4", "-o", "t.nc", "--repeat", "4x4"), "--element": ("CPS", "--mesh", "grains", "-o", "t.inp"),
                  "--job": ("elastic", "--mesh", "grains", "-o", "t.inp"), "--thickness": (0.1, "-o", "t.foam"),
                  "--surface": ("cells", "--period", "1,1,1", "-o", "t.obj"), "--cells": ("t.csv",), "--report": ("r.json",),
                  "--force": (), "--quiet": (), "--help": ()}
        listed = re.findall(r"^ +(?:-h,)?(--?[a-z0-9-]+)", self.succeed("pattern", "--help").split("Examples", 1)[0], re.M)
        self.assertEqual(set(listed), set(values))
        for option in listed:
            words = () if option == "--sites" else ("--sites", 4)
            self.succeed("pattern", *words, option, *values[option], *(() if option == "--force" else ("--force",)))

    def test_mesh_may_start_from_the_lattice_and_then_stays_there(self):
        report = self.report("mesh", "--sites", 56, "--start", "lattice")
        self.assertEqual((report["iterations"], report["hexagons"]), (0, 56))
        self.assertAlmostEqual(report["energy"] / SQUARE_MINIMA[56], 1, delta=1e-12)


class SpacePattern(CliTest):
    """The same with three period vectors."""

    def report(self, *arguments):
        self.succeed("pattern", *arguments, "--report", "run.json", "--force", "--quiet")
        return json.loads(self.path("run.json").read_text())

    def test_the_summary_shows_basis_energy_ratio_and_stability(self):
        text = self.succeed("pattern", "--sites", 4, "--period", "1,1,1")
        self.assertRegex(text, r"pattern +\(.*\) \(.*\) \(.*\), energy 0\.09375, 1\.00257 of truncated")
        self.assertRegex(text, r"stability +the pattern is a minimum; smallest eigenvalue 0\.\d+ of")
        self.assertRegex(text, r"faces +12 a cell; cells with 12:4")
        text = self.succeed("pattern", "--sites", 1, "--period", "1,1,1")
        self.assertRegex(text, "the pattern is a minimum; one site has only the translations")

    def test_the_report_holds_the_closed_energies(self):
        # The energies per cell of volume 1 of SC and of BCC lattices.
        for n, moment in ((1, 1 / 12), (2, 19 / (192 * 2 ** (1 / 3))), (54, 19 / (192 * 2 ** (1 / 3)))):
            report = self.report("--sites", n, "--period", "1,1,1")
            energy = 3 * moment / n ** (2 / 3)
            self.assertAlmostEqual(report["energy"] / energy, 1, delta=1e-12)
            self.assertAlmostEqual(report["pattern"]["energy"] / energy, 1, delta=1e-12)
            self.assertEqual((report["start"], report["stop"]), ("lattice", "converged"))
            self.assertEqual(report["pattern"]["minimum"], "yes")
            a, d, f, b, c, e = report["pattern"]["hermite"]
            self.assertEqual(a * d * f, n)

    def test_files_are_proved(self):
        for lattice in ("1,0,0,0.37,0.81,0,0.2,0.4,0.9", "1,0,0,7,1,0,-3,5,1"):
            for n in (1, 2, 7, 30):
                self.report("--sites", n, "--lattice", lattice, "-o", "t.vtu", "-o", "t.obj")
                self.assertEqual(len(self.succeed("check", "t.vtu", "t.obj", "--cvt").splitlines()), 2)

    def test_options_are_refused(self):
        self.refuse(2, "--seed is not for pattern.*; leave it out", "pattern", "--sites", 3,
                    "--period", "1,1,1", "--seed", 1)
        self.refuse(2, "--symmetry is not for pattern", "pattern", "--sites", 3,
                    "--period", "1,1,1", "--symmetry", "p4m")
        self.refuse(2, "no sites; give --sites N$", "pattern", "--period", "1,1,1")
        self.refuse(4, "the lattices of 1000000 cells are more than", "pattern", "--sites", 1000000,
                    "--period", "1,1,1")

    def test_mesh_may_start_from_the_lattice_and_then_stays_there(self):
        text = self.succeed("mesh", "--sites", 16, "--period", "1,1,1", "--start", "lattice")
        self.assertRegex(text, "the pattern is a minimum")
        self.assertRegex(text, "converged after 0 iterations")


if __name__ == "__main__":
    main()
