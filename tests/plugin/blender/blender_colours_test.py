"""The materials that the Blender add-on assigns to cells, tested without Blender."""

import sys
import unittest

from support.cli import main
from support.python_package import OBLIQUE, ROOT, pcvt

import numpy as np

sys.path.insert(0, str(ROOT / "plugin" / "blender" / "pcvt_tile"))
import colours

HEXAGONAL = np.array([[1, 0], [0.5, np.sqrt(0.75)]])


class Colours(unittest.TestCase):
    def colours_of(self, *arguments, **more):
        """Returns the colours of a run; fails if neighbours on the torus have equal colours."""
        cells = pcvt.mesh(*arguments, tolerance=1e-3, **more).mesh()
        found = colours.colours_of_sites(cells)
        cell = np.repeat(cells.site, np.diff(cells.face_begin))
        other = cell[cells.opposite]
        self.assertTrue(((found[cell] != found[other]) | (cell == other)).all())
        self.assertTrue(set(found) <= set(range(7)))
        return found

    def test_neighbours_differ_across_the_seam(self):
        for n_sites in (*range(1, 9), 30, 1000):
            self.colours_of(n_sites, OBLIQUE, seed=n_sites)
        self.colours_of(500, [[20, 0], [0, 1]])

    def test_seven_cells_that_all_touch_need_seven(self):
        found = self.colours_of(7, HEXAGONAL, start="lattice")
        self.assertEqual(set(found), set(range(7)))

    def test_all_seven_are_used_equally(self):
        used = np.bincount(self.colours_of(1000), minlength=7)
        self.assertGreater(used.min(), 100)

    def test_sides_agree_with_the_statistics(self):
        for n_sites in (1, 2, 5, 1000):
            result = pcvt.mesh(n_sites, seed=3, max_iterations=0)
            sides = np.bincount(colours.sides_of_sites(result.mesh()))
            np.testing.assert_array_equal(sides, result.statistics.valences)

    def test_an_edge_too_short_to_see_is_not_a_side(self):
        square = [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]]
        nearly = pcvt.mesh(np.array(square) + [[1e-7, 0], [0, 0], [0, 0], [0, 0]], max_iterations=0)
        self.assertGreater(np.diff(nearly.mesh().face_begin).max(), 4)
        np.testing.assert_array_equal(colours.sides_of_sites(nearly.mesh()), 4)


if __name__ == "__main__":
    main()
