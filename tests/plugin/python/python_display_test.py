"""What consoles and notebooks show: names, the version, one line a result, pictures."""

import unittest
from unittest import mock

from support.cli import CliTest, main
from support.python_package import pcvt

import numpy as np
from pcvt import _shown

LINES = {
    "result": r"<pcvt\.Result: 300 sites, converged, residual \d\.\de-07>",
    "tile": r"<pcvt\.Tile: voronoi, outline whole, 300 faces, \d+ points, \d+ pairs on the seam>",
    "box": r"<pcvt\.Tile: grains, outline box, \d+ faces, \d+ points, \d+ pairs on the seam>",
    "mesh": r"<pcvt\.TorusMesh: delaunay, 600 faces, 300 vertices>",
    "statistics": r"<pcvt\.Statistics: 300 sites, converged, residual \d\.\de-07, \d+ iterations, energy 0\.0\d+>",
    "first": r"<pcvt\.Progress: optimising, iteration 0, residual 0\.\d+>",
    "last": r"<pcvt\.Progress: writing t\.svg, 1 of 1, 100%>",
    "one": r"<pcvt\.Result: 1 site, converged, residual \S+>",
    "stopped": r"<pcvt\.Result: 9 sites, iteration limit, residual 0\.\d+>",
    "solid": r"<pcvt\.SpaceResult: 9 sites, converged, residual \d\.\d?e-07>",
    "polyhedra": r"<pcvt\.SpaceTile: 9 cells, \d+ faces, \d+ points, \d+ faces on the seam>",
    "unknown": r"<pcvt\.SpaceResult: 9 sites, not converged>",
    "as given": r"<pcvt\.SpaceResult: 9 sites>",
    "dropped": r"<pcvt\.SpaceResult>",
}


class Names(unittest.TestCase):
    def test_dir_shows_the_public_names_only(self):
        self.assertEqual(dir(pcvt), sorted([*pcvt.__all__, "__version__"]))

    def test_the_version_is_that_of_the_library(self):
        self.assertEqual(pcvt.__version__, pcvt.version())


class Lines(CliTest):
    def test_each_object_is_one_line_with_its_figures(self):
        seen = []
        result, solid = pcvt.mesh(300, progress=seen.append), pcvt.space(9)
        self.assertEqual(repr(solid), "<pcvt.SpaceResult: 9 sites, converged>")
        result.write(self.path("t.svg"), progress=seen.append)
        coincident = [[0, 0, 0], [0.5, 0.5, 0.5], [1, 1, 1]]
        objects = {"result": result, "tile": result.tile(), "box": result.tile("grains", "box"),
                   "mesh": result.mesh("delaunay"), "statistics": result.statistics, "first": seen[0],
                   "last": seen[-1], "one": pcvt.mesh(1), "stopped": pcvt.mesh(9, max_iterations=0),
                   "polyhedra": solid.tile(), "unknown": pcvt.space(9, max_iterations=2),
                   "as given": pcvt.space(9, max_iterations=0),
                   "dropped": pcvt.space(coincident, duplicates="drop", max_iterations=0)}
        self.assertEqual(solid.statistics.n_sites, 9)
        for name, line in LINES.items():
            with self.subTest(name):
                self.assertRegex(repr({**objects, "solid": solid}[name]), f"^{line}$")

    def test_a_damaged_object_has_a_line_too(self):
        for kind in (pcvt.Result, pcvt.SpaceResult, pcvt.Tile, pcvt.TorusMesh, pcvt.SpaceTile, pcvt.CheckResult,
                     pcvt.StudyResult):
            self.assertEqual(repr(kind.__new__(kind)), f"<pcvt.{kind.__name__}>")
        for kind in (pcvt.Statistics, pcvt.Progress):
            self.assertEqual(repr(kind(*[None] * len(kind._fields))), f"<pcvt.{kind.__name__}>")


class Pictures(CliTest):
    def test_notebooks_show_what_svg_files_hold(self):
        result = pcvt.mesh(60, repeat=(2, 1))
        for picture, choices in ((result, ()), (result.tile(), ()), (result.tile("grains", "box"), ("grains", "box")),
                                 (result.tile("delaunay"), ("delaunay",))):
            result.write(self.path("t.svg"), *choices, replace=True)
            self.assertEqual(picture._repr_svg_(), self.path("t.svg").read_text(encoding="utf-8"))

    def test_large_pictures_are_not_shown(self):
        sites = np.random.default_rng(1).random((_shown.MOST_SHOWN + 1, 2))
        large = pcvt.mesh(sites, max_iterations=0)
        self.assertIsNone(large.tile()._repr_svg_())
        with mock.patch.object(pcvt.Result, "tile", side_effect=AssertionError("the tile is built")):
            self.assertIsNone(large._repr_svg_())
            self.assertIsNone(pcvt.mesh(9, repeat=(50, 50))._repr_svg_())
        self.assertIsNotNone(pcvt.mesh(9, repeat=(2, 2))._repr_svg_())
        self.assertEqual(_shown.MOST_SHOWN, 20000)  # The docstrings state it.

    def test_a_picture_that_cannot_be_written_is_not_shown(self):
        tile = pcvt.mesh(9).tile()
        tile.kind, tile.outline = "delaunay", "box"
        self.assertIsNone(tile._repr_svg_())


class Patterns(CliTest):
    def test_patterns_are_those_of_the_command(self):
        for dimension, period in ((2, (1, 1)), (3, (1, 1, 1))):
            names = ["txt", "ply"]
            self.succeed("pattern", "--sites", 16, "--period", ",".join(map(str, period)), "--force",
                         *[word for name in names for word in ("-o", f"command{dimension}.{name}")])
            pattern = pcvt.pattern(16, period=period)
            for name in names:
                pattern.write(self.path(f"python{dimension}.{name}"))
                files = self.contents()
                self.assertEqual(files[f"python{dimension}.{name}"], files[f"command{dimension}.{name}"])

    def test_a_pattern_chooses_its_sites(self):
        with self.assertRaisesRegex(TypeError, "start"):
            pcvt.pattern(9, start="random")
        with self.assertRaises(pcvt.ArgumentError):
            pcvt.pattern([[0.5, 0.5]])


if __name__ == "__main__":
    main()
