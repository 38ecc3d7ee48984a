"""Prescribed areas and elongated cells in Python."""

import math
import unittest

from support.cli import main
from support.python_package import OBLIQUE, pcvt

import numpy as np


def to_round(ratio, degrees):
    """The matrix of the metric, from its definition."""
    angle = math.radians(degrees)
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    return turn @ np.diag([ratio ** -0.5, ratio ** 0.5]) @ turn.T


class Areas(unittest.TestCase):
    def test_cells_have_the_given_areas(self):
        targets = np.arange(1, 41)
        result = pcvt.mesh(40, OBLIQUE, areas=targets, max_iterations=2)
        cells = result.cells
        np.testing.assert_allclose(cells["area"] / 0.81, targets / targets.sum(), rtol=1e-8)
        self.assertLess(result.statistics.area_error, 1e-10)
        self.assertGreater(result.statistics.newton_steps, 0)
        self.assertEqual(result.statistics.iterations, 2)
        self.assertEqual(result.weights.shape, (40,))
        self.assertAlmostEqual(result.weights.sum(), 0, 12)

    def test_weights_and_phases_of_given_sites_give_the_same_cells_again(self):
        one = pcvt.mesh(40, OBLIQUE, areas="lognormal:0.4", max_iterations=3, phases={"a": 0.3, "b": 0.7})
        names = [one.phase_names[k] for k in one.phases]
        again = pcvt.mesh(one.sites, OBLIQUE, weights=one.weights, max_iterations=0, phases=names)
        np.testing.assert_array_equal(again.weights, one.weights)
        np.testing.assert_allclose(again.cells["area"], one.cells["area"], rtol=1e-12)
        np.testing.assert_array_equal(again.sites, one.sites)
        self.assertEqual([again.phase_names[k] for k in again.phases], names)
        with self.assertRaisesRegex(pcvt.ArgumentError, "^weights keeps sites where they are"):
            pcvt.mesh(one.sites, OBLIQUE, weights=one.weights)
        with self.assertRaisesRegex(pcvt.GeometryError, "^the cell of site 1 is empty"):
            pcvt.mesh([[0.2, 0.2], [0.3, 0.2], [0.7, 0.7]], weights=[0.1, 0, 0], max_iterations=0)
        with self.assertRaisesRegex(pcvt.ArgumentError, "^areas is not for three dimensions"):
            pcvt.mesh([[0, 0, 0]], period=(1, 1, 1), areas=[1], max_iterations=0)

    def test_a_law_is_drawn_from_the_seed(self):
        one, same, other = (pcvt.mesh(200, areas="lognormal:0.42", max_iterations=0, seed=seed) for seed in (1, 1, 2))
        np.testing.assert_array_equal(one.weights, same.weights)
        self.assertFalse(np.array_equal(one.weights, other.weights))
        diameters = one.cells["diameter"]
        self.assertAlmostEqual(diameters.std() / diameters.mean(), 0.42, delta=0.1)

    def test_a_mixture_has_its_shares_and_means(self):
        areas = pcvt.mesh(20, areas="0.75*equal@1+0.25*equal@3", max_iterations=0).cells["area"] * (15 + 5 * 9)
        np.testing.assert_allclose(np.sort(areas), [1] * 15 + [9] * 5, rtol=1e-9)

    def test_cells_are_those_of_brute_force_in_the_metric(self):
        for ratio, degrees in ((1, 0), (3, 25), (0.4, 100)):
            result = pcvt.mesh(30, OBLIQUE, areas="gamma:0.3", max_iterations=1, aspect=(ratio, degrees))
            metric = to_round(ratio, degrees)
            moves = np.array([(i, j) for i in range(-4, 5) for j in range(-4, 5)]) @ result.lattice
            mesh = result.mesh()
            corners = mesh.vertices[mesh.corner_vertex] + mesh.corner_offset @ mesh.lattice
            for face, site in enumerate(mesh.site):
                centre = corners[mesh.face_begin[face]:mesh.face_begin[face + 1]].mean(axis=0)
                steps = (centre - result.sites[:, None] - moves) @ metric.T
                distances = (steps ** 2).sum(axis=2).min(axis=1) - result.weights
                self.assertEqual(distances.argmin(), site)

    def test_without_areas_there_are_no_weights(self):
        result = pcvt.mesh(20, aspect=2)
        self.assertIsNone(result.weights)
        self.assertTrue(math.isnan(result.statistics.area_error))
        np.testing.assert_array_equal(pcvt.mesh(20, aspect=(1, 40)).sites, pcvt.mesh(20).sites)

    def test_tiles_of_every_kind_have_the_areas(self):
        targets = np.arange(1, 21)
        result = pcvt.mesh(20, areas=targets, aspect=(2, 30), repeat=(2, 1))
        for kind in ("voronoi", "grains"):
            for outline in ("whole", "box"):
                tile = result.tile(kind, outline)
                areas = np.zeros(20)
                for site, polygon in zip(tile.face_site, tile.polygons()):
                    x, y = (polygon - polygon[0]).T
                    areas[site] += (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
                np.testing.assert_allclose(areas / 2, targets / targets.sum(), rtol=1e-2)

    def test_impossible_targets_are_refused(self):
        for areas, words in (([1, 2], "n_areas"), ([1, -1, 1], "area of site 1"), ([1, math.nan, 1], "site 1"),
                             ([1, 0, 1], "site 1"), ("gamma", "gamma:S"), ("0.5*equal@1", "shares"), ("dirac:1", "law"), ("", "law"), (3, "n_areas")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                pcvt.mesh(3, areas=areas)
        with self.assertRaisesRegex(pcvt.ArgumentError, "areas does not work with density"):
            pcvt.mesh(3, areas="equal", density="1 + u")
        for aspect in (0, 200, (2, math.inf)):
            with self.assertRaisesRegex(pcvt.ArgumentError, "aspect"):
                pcvt.mesh(3, aspect=aspect)


if __name__ == "__main__":
    main()
