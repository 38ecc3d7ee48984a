"""Inclusions and fixed sites in Python: areas by tag, the two forms of shapes, positions, and refusals."""

import math
import unittest

from support.cli import main
from support.python_package import pcvt

import numpy as np

CORNERS = np.array([(0.2, 0.3), (0.4, 0.3), (0.3, 0.6)])
SHAPES = (("circle", "glass", 0.95, 0.9, 0.15), ("ellipse", "steel", 0.7, 0.4, 0.2, 0.1, 30.0),
          ("polygon", "glass", CORNERS))
AREAS = {"glass": math.pi * 0.15**2 + 0.03, "steel": math.pi * 0.02}
TEXT = ("circle glass 0.95 0.9 0.15\nellipse steel 0.7 0.4 0.2 0.1 30\n"
        "polygon glass 0.2 0.3 0.4 0.3 0.3 0.6\n")


def mesh(sites=600, **arguments):
    return pcvt.mesh(sites, tolerance=1e-3, **arguments)


class Inclusions(unittest.TestCase):
    def test_tags_are_phases_with_the_areas_of_their_shapes(self):
        result = mesh(inclusions=SHAPES)
        self.assertEqual(result.phase_names, ("matrix", "glass", "steel"))
        for tag, area in AREAS.items():
            cells = result.cells["area"][result.phases == result.phase_names.index(tag)]
            self.assertAlmostEqual(cells.sum(), area, delta=1e-12)

    def test_text_gives_the_same_sites(self):
        np.testing.assert_array_equal(mesh(inclusions=SHAPES).sites, mesh(inclusions=TEXT).sites)

    def test_listed_images_are_left_out(self):
        result = mesh(inclusions=[*SHAPES, ("circle", "glass", -0.05, -0.1, 0.15), ("polygon", "glass", CORNERS + (1, 2))])
        np.testing.assert_array_equal(result.sites, mesh(inclusions=SHAPES).sites)
        self.assertEqual(len(result.inclusions), 3)
        with self.assertRaisesRegex(pcvt.ArgumentError, "inclusions:4: the shape is an image of that of line 1 with another tag"):
            mesh(inclusions=[*SHAPES, ("circle", "steel", 1.95, 0.9, 0.15)])

    def test_a_coating_lies_around_its_fibre(self):
        result = mesh(1500, inclusions="circle core 0.5 0.5 0.2\ncircle coating 0.5 0.5 0.25")
        self.assertEqual(result.phase_names, ("matrix", "core", "coating"))
        areas = [result.cells["area"][result.phases == k].sum() for k in (1, 2)]
        np.testing.assert_allclose(areas, [0.04 * np.pi, 0.0225 * np.pi], rtol=0, atol=1e-12)

    def test_fibres_have_their_area(self):
        result = mesh(1500, fibres=(0.4, 12), seed=3)
        self.assertEqual(result.phase_names, ("matrix", "fibre"))
        self.assertAlmostEqual(result.cells["area"][result.phases == 1].sum(), 0.4, delta=1e-12)

    def test_refusals_name_the_line(self):
        for shapes, words in ((TEXT + "circle b 0.95 0.8 0.1", "inclusions:4: the shape overlaps that of line 1"),
                              ("circle b 0 0", "inclusions:1: a circle does not take 2 numbers"),
                              ("circle b 0 0 0.7", "inclusions:1: the shape is larger than the domain")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                mesh(inclusions=shapes)
        with self.assertRaisesRegex(pcvt.ArgumentError, "inclusions:1: the shape touches or crosses wall_top"):
            mesh(inclusions=TEXT, walls="y")

    def test_the_shapes_of_a_result_are_those_that_were_given(self):
        result = mesh(inclusions=SHAPES)
        self.assertEqual(len(result.inclusions), 3)
        self.assertEqual(result.inclusions[:2], SHAPES[:2])
        word, tag, corners = result.inclusions[2]
        self.assertEqual((word, tag), SHAPES[2][:2])
        np.testing.assert_array_equal(corners, CORNERS)
        np.testing.assert_array_equal(mesh(inclusions=result.inclusions).sites, result.sites)
        self.assertEqual(mesh(20).inclusions, ())

    def test_the_fibres_of_a_result_make_it_again(self):
        result = mesh(1500, fibres=(0.4, 12), seed=3)
        self.assertEqual({shape[:2] for shape in result.inclusions}, {("circle", "fibre")})
        self.assertAlmostEqual(sum(math.pi * r**2 for *_, r in result.inclusions), 0.4, delta=1e-12)
        again = mesh(1500, inclusions=result.inclusions, seed=3)
        np.testing.assert_array_equal(again.sites, result.sites)

    def test_channels_hold_their_inclusions(self):
        result = mesh(900, inclusions=[("circle", "a", 0.5, 0.5, 0.3)], walls="xy")
        tile = result.tile()
        inside = np.array([np.hypot(*(points.mean(axis=0) - 0.5)) < 0.3 for points in tile.polygons()])
        np.testing.assert_array_equal(inside, result.phases[tile.face_site] == 1)
        self.assertAlmostEqual(result.cells["area"][result.phases == 1].sum(), math.pi * 0.09, delta=1e-12)


class Holes(unittest.TestCase):
    def test_their_cells_are_left_out_and_their_edges_have_names(self):
        result = mesh(inclusions=SHAPES, holes=["steel", "glass"])
        self.assertEqual(result.phase_names, ("matrix",))
        self.assertAlmostEqual(result.cells["area"].sum(), 1 - sum(AREAS.values()), delta=1e-12)
        tile = result.tile()
        self.assertEqual(tile.holes, ["steel", "glass"])
        self.assertEqual([shape[1] for shape in result.inclusions], [shape[1] for shape in SHAPES])
        self.assertEqual(sorted(tile.face_site), list(range(len(result.sites))))
        self.assertEqual(set(tile.wall_edges["wall"]), {4, 5})

    def test_one_tag_may_be_a_text(self):
        self.assertEqual(mesh(inclusions=SHAPES, holes="steel").phase_names, ("matrix", "glass"))

    def test_unknown_tags_are_refused(self):
        with self.assertRaisesRegex(pcvt.ArgumentError, "did you mean steel"):
            mesh(inclusions=SHAPES, holes=["stel"])


class FixedSites(unittest.TestCase):
    def test_they_come_first_and_stay(self):
        points = np.array([(0.125, 0.25), (0.5, 0.75), (-0.25, 1.5)])
        result = mesh(40, fixed=points)
        np.testing.assert_array_equal(result.sites[:3], points % 1)
        self.assertEqual(result.statistics.stop, "converged")
        self.assertEqual(len(result.sites), 40)

    def test_all_sites_may_be_fixed(self):
        points = np.random.default_rng(1).random((7, 2)).round(2)
        np.testing.assert_allclose(mesh(7, fixed=points).sites, points, atol=1e-15)

    def test_more_fixed_sites_than_sites_are_refused(self):
        with self.assertRaisesRegex(pcvt.ArgumentError, "more fixed sites .3. than sites"):
            mesh(2, fixed=np.eye(3)[:, :2])


if __name__ == "__main__":
    main()
