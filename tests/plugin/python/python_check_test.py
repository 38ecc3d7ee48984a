"""Proofs of files by the Python package, beside those of the command."""

import pathlib
import unittest

from support.cli import CliTest, main
from support.python_package import pcvt

import numpy as np


class Checks(CliTest):
    def setUp(self):
        super().setUp()
        self.tile, self.foam = str(self.path("tile.obj")), str(self.path("cells.foam"))
        pcvt.mesh(60, seed=2).write(self.tile)

    def write_areas(self):
        np.savetxt(self.path("sixty.txt"), np.ones(60))
        return self.path("sixty.txt")

    def refuted(self, *arguments):
        done = self.run_pcvt("check", *arguments)
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        return done.stderr.decode()

    def test_a_proof_is_true_and_has_the_line_of_the_command(self):
        pcvt.space(20).write(self.foam)
        result = pcvt.check([self.tile, pathlib.Path(self.foam)])
        self.assertIs(bool(result), True)
        self.assertEqual(str(result) + "\n", self.succeed("check", self.tile, self.foam))
        self.assertEqual((len(result.lines), result.refuted), (2, ()))
        self.assertEqual(str(pcvt.check(self.tile, cvt=1e-4)) + "\n", self.succeed("check", "--cvt", "1e-4", self.tile))

    def test_a_refutation_is_false_and_says_why(self):
        text = self.path("tile.obj").read_text(encoding="utf-8")
        for name, damaged in (("tile.obj", text), ("moved.obj", text.replace("\nv 0.", "\nv 0.0", 1)),
                              ("word.obj", text.replace("\nv ", "\nv x", 1)), ("cut.obj", text[:900]),
                              ("other.obj", "\n".join(line for line in text.splitlines() if line[:1] != "#"))):
            self.write(name, damaged)
            result = pcvt.check(self.path(name), period=(2, 1))
            self.assertIs(bool(result), False)
            self.assertEqual(str(result) + "\n", self.refuted("--period", "2,1", self.path(name)))
            self.assertEqual(result.refuted, (str(self.path(name)),))

    def test_one_refuted_file_of_several_makes_the_result_false(self):
        pcvt.mesh(60, period=(2, 1)).write(self.path("other.obj"))
        result = pcvt.check([self.tile, self.path("other.obj")], period=(2, 1))
        self.assertFalse(result)
        self.assertEqual(result.refuted, (self.tile,))
        self.assertIn("other.obj: a periodic tile", result.lines[1])

    def test_properties_are_those_of_the_command(self):
        np.savetxt(self.path("areas.txt"), np.arange(1, 41))
        self.write("shapes.txt", "circle fibre 0.5 0.5 0.2\n")
        pcvt.mesh(40, areas=np.arange(1, 41)).write(self.path("power.obj"))
        pcvt.mesh(90, inclusions=[("circle", "fibre", 0.5, 0.5, 0.2)]).write(self.path("fibre.obj"))
        pcvt.mesh(90, density="1 + u").write(self.path("graded.obj"))
        for name, arguments, options in (
                ("power.obj", {"areas": self.path("areas.txt")}, ("--areas", self.path("areas.txt"))),
                ("fibre.obj", {"inclusions": self.path("shapes.txt")}, ("--inclusions", self.path("shapes.txt"))),
                ("graded.obj", {"cvt": 1e-4, "density": "1 + u"}, ("--density", "1 + u", "--cvt", "1e-4"))):
            result = pcvt.check(self.path(name), **arguments)
            self.assertTrue(result, result)
            self.assertEqual(str(result) + "\n", self.succeed("check", self.path(name), *options))
            self.assertFalse(pcvt.check(self.path(name), lattice=((1, 0), (0, 2)), **arguments))
        with self.assertRaisesRegex(pcvt.ArgumentError, "sixty.txt"):
            pcvt.check(self.path("power.obj"), areas=self.write_areas())
        self.assertFalse(pcvt.check(self.path("graded.obj"), cvt=1e-4))

    def test_a_tolerance_accepts_a_rounded_tile(self):
        self.write("rounded.obj", "v 0 0 0\nv 1 0 0\nv 1 1.000001 0\nv 0 1 0\nf 1 2 3 4\n")
        result = pcvt.check(self.path("rounded.obj"), period=(1, 1))
        self.assertRegex(str(result), "so tolerance 1.01e-06 accepts it$")
        self.assertTrue(pcvt.check(self.path("rounded.obj"), period=(1, 1), tolerance=1.01e-6))

    def test_what_cannot_be_examined_raises(self):
        self.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        self.assertTrue(pcvt.check(self.path("square.obj"), period=(1, 1)))
        pcvt.mesh(9).write(self.path("voxels.vti"))
        for words, path, arguments in (
                ("none.obj: cannot read", "none.obj", {}), ("names no lattice; pass lattice", self.path("square.obj"), {}),
                ("cvt is not for voxels", self.path("voxels.vti"), {"cvt": 1}), ("states no weights", self.tile, {"areas": self.write_areas()}),
                ("not a format", "tile.xyz", {}), ("no file", [], {}), ("cvt -1 is not above 0", self.tile, {"cvt": -1}),
                ("tolerance 0 is not", self.tile, {"tolerance": 0}), ("density is for cvt", self.tile, {"density": "1"}),
                ("wrong.png: ", self.tile, {"cvt": 1, "density": self.folder / self.write("wrong.png", "x")}),
                ("two period vectors", self.tile, {"period": (1, 1, 1)}), ("exclude each other", self.tile,
                                                                         {"period": (1, 1), "lattice": (1, 0, 0, 1)}),
                ("areas is a law", self.tile, {"areas": "equal"}), ("path is empty", "", {}),
                ("zero byte", "tile\0.obj", {})):
            with self.subTest(words), self.assertRaisesRegex(pcvt.ArgumentError, words):
                pcvt.check(path, **arguments)

    def test_progress_shows_the_proof_and_cancels(self):
        seen = []
        pcvt.check(self.tile, progress=seen.append)
        self.assertEqual({progress.phase for progress in seen}, {"prove"})
        self.assertRegex(repr(seen[-1]), "^<pcvt.Progress: proving .*tile.obj")
        with self.assertRaises(pcvt.Cancelled):
            pcvt.check(self.tile, progress=lambda progress: True)
        with self.assertRaises(ZeroDivisionError):
            pcvt.check(self.tile, progress=lambda progress: 1 / 0)

    def test_each_result_is_one_line_with_its_figures(self):
        result = pcvt.check(self.tile)
        self.assertRegex(repr(pcvt.check(self.tile, period=(1, 1))), "^<pcvt.CheckResult: proved, .*tile.obj: .*>$")
        self.assertLess(len(repr(result)), 130)
        self.assertRegex(repr(pcvt.check(self.tile, period=(2, 1))), "^<pcvt.CheckResult: refuted, .*>$")
        self.assertEqual(repr(pcvt.check([self.tile, self.tile])), "<pcvt.CheckResult: 2 of 2 files proved>")


if __name__ == "__main__":
    main()
