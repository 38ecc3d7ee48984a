"""Walls in Python: edges on walls, half cells, and refusals."""

import unittest

from support.cli import main
from support.python_package import pcvt

import numpy as np

HEIGHT, WIDTH = 0.7, 2.0


def mesh(sites=60, **arguments):
    return pcvt.mesh(sites, period=(WIDTH, HEIGHT), tolerance=1e-4, **arguments)


class Walls(unittest.TestCase):
    def test_edges_on_walls_cover_them(self):
        for walls, numbers in (("x", {0, 1}), ("y", {2, 3}), ("xy", {0, 1, 2, 3})):
            tile = mesh(walls=walls).tile()
            self.assertEqual(set(tile.wall_edges["wall"].tolist()), numbers)
            for number in numbers:
                edges = tile.wall_edges[tile.wall_edges["wall"] == number]
                from_, to = tile.points[edges["v0"]], tile.points[edges["v1"]]
                axis = number // 2
                line = (0, (WIDTH, HEIGHT)[axis])[number % 2]
                np.testing.assert_array_equal(from_[:, axis], line)
                np.testing.assert_array_equal(to[:, axis], line)
                self.assertAlmostEqual(np.abs(to - from_).sum(), (HEIGHT, WIDTH)[axis], 12)
                # The tile is on the left: edges at the bottom run to the right, at the right wall upwards.
                forwards = 1 if number in (1, 2) else -1
                self.assertTrue((forwards * (to - from_)[:, 1 - axis] > 0).all())
            self.assertEqual(len(tile.seam) == 0, walls == "xy")

    def test_sites_lie_between_walls_and_halves_on_them(self):
        for cells in ("whole", "half"):
            y = mesh(walls="y", wall_cells=cells).sites[:, 1]
            self.assertTrue(((y >= 0) & (y <= HEIGHT)).all())
            self.assertEqual(((y == 0) | (y == HEIGHT)).any(), cells == "half")

    def test_cells_fill_the_box(self):
        result = mesh(walls="xy")
        self.assertAlmostEqual(result.cells["area"].sum(), WIDTH * HEIGHT, 12)
        self.assertEqual(len(result.cells), 60)
        self.assertEqual(result.mesh().opposite.min(), -1)

    def test_cells_between_walls_have_prescribed_areas(self):
        areas = np.arange(1, 61)
        targets = areas / areas.sum() * (WIDTH * HEIGHT)
        for walls, cells in (("x", "whole"), ("y", "half"), ("xy", "whole")):
            result = mesh(walls=walls, wall_cells=cells, areas=areas, max_iterations=5)
            np.testing.assert_allclose(result.cells["area"], targets, rtol=1e-8)
            self.assertEqual(result.weights.shape, (60,))
            self.assertLess(result.statistics.area_error, 1e-10)
            tile = result.tile("grains")
            x, y = np.moveaxis(tile.points[tile.corners.reshape(-1, 3)], 2, 0)
            triangles = ((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
            np.testing.assert_allclose(np.bincount(tile.face_site, triangles), targets, rtol=1e-8)

    def test_without_walls_no_edge_lies_on_one(self):
        self.assertEqual(len(mesh().tile().wall_edges), 0)

    def test_refusals_name_the_remedy(self):
        for arguments, text in (({"walls": "z"}, "none, x, y, xy"),
                                ({"wall_cells": "half"}, "wall_cells half needs walls"),
                                ({"walls": "y", "aspect": 2}, "^aspect does not work with walls; leave one of them out$"),
                                ({"walls": "y", "repeat": (1, 2)}, "repeat it along them"),
                                ({"walls": "y", "origin": (0, 0.1)}, "give an origin along the walls, or none")):
            with self.assertRaisesRegex(pcvt.ArgumentError, text):
                mesh(**arguments)
        with self.assertRaisesRegex(pcvt.ArgumentError, "add wall_cells half"):
            mesh(walls="y").tile("delaunay")


if __name__ == "__main__":
    main()
