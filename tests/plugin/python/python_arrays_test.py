"""The arrays of the Python package, and the seam that they describe."""

import gc
import unittest

from support.cli import main
from support.python_package import OBLIQUE, pcvt

import numpy as np
from pcvt import _library


def edges_of(tile):
    """Returns rows v0, v1 for each side of each face, counter-clockwise."""
    faces = np.split(tile.corners, tile.face_begin[1:-1])
    return np.concatenate([np.column_stack([face, np.roll(face, -1)]) for face in faces])


def area(polygon):
    x, y = (polygon - polygon[0]).T
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def columns(seam, *names):
    return np.column_stack([seam[name] for name in names])

class Arrays(unittest.TestCase):
    def test_tiles_have_the_shapes_of_their_docstring(self):
        result = pcvt.mesh(50, OBLIQUE, repeat=(2, 1))
        for kind, n_faces in (("voronoi", 100), ("delaunay", 200)):
            tile = result.tile(kind)
            self.assertEqual((tile.kind, tile.outline), (kind, "whole"))
            np.testing.assert_array_equal(tile.lattice, OBLIQUE * [[2], [1]])
            self.assertEqual(tile.face_begin.shape, (n_faces + 1,))
            self.assertEqual(tile.corners.shape, (tile.face_begin[-1],))
            self.assertEqual(tile.vertex_orbit.shape, (len(tile.points),))
            self.assertEqual(tile.vertex_offset.shape, tile.points.shape)
            self.assertEqual(tile.face_site is None, kind == "delaunay")
            self.assertEqual(tile.vertex_site is None, kind == "voronoi")
            areas = [area(polygon) for polygon in tile.polygons()]
            self.assertGreater(min(areas), 0)
            self.assertAlmostEqual(sum(areas), 2 * 0.81, 12)

    def test_sites_of_cells_lie_in_them(self):
        result = pcvt.mesh(40)
        tile = result.tile()
        np.testing.assert_array_equal(np.sort(tile.face_site), np.arange(40))
        moved = tile.site_points - result.sites[tile.face_site]
        np.testing.assert_allclose(moved, np.round(moved), atol=1e-14)
        for site, polygon in zip(tile.site_points, tile.polygons()):
            self.assertLess(np.abs(polygon - site).max(), 1)
            self.assertGreater(min(area(np.array([site, p, q])) for p, q in
                                   zip(polygon, np.roll(polygon, -1, axis=0))), 0)

    def test_meshes_on_the_torus_are_closed(self):
        result = pcvt.mesh(50)
        for kind in ("voronoi", "delaunay"):
            mesh = result.mesh(kind)
            n_corners = mesh.face_begin[-1]
            self.assertEqual(len(mesh.vertices) - n_corners // 2 + len(mesh.face_begin) - 1, 0)
            self.assertEqual(mesh.corner_offset.shape, (n_corners, 2))
            np.testing.assert_array_equal(mesh.opposite[mesh.opposite], np.arange(n_corners))
            np.testing.assert_array_equal(np.sort(mesh.site), np.arange(50))
            self.assertEqual(mesh.site_points is None, kind == "delaunay")

    def test_arrays_are_views_that_keep_the_result_alive(self):
        points = pcvt.mesh(2000, tolerance=0.1).tile().points
        self.assertFalse(points.flags.owndata or points.flags.writeable)
        before = points.copy()
        gc.collect()
        others = [pcvt.mesh(2000, seed=seed, tolerance=0.1).tile() for seed in (1, 2, 3)]
        np.testing.assert_array_equal(points, before)
        self.assertNotEqual(others[0].points.ctypes.data, points.ctypes.data)

    def test_results_are_freed(self):
        freed = []
        free = _library.library.pcvt_free
        _library.library.pcvt_free = freed.append
        self.addCleanup(setattr, _library.library, "pcvt_free", free)
        seam = pcvt.mesh(10).tile().seam
        gc.collect()
        self.assertEqual(freed, [])
        del seam
        gc.collect()
        self.assertEqual(len(freed), 1)
        free(freed[0])

    def test_a_period_is_the_lattice_of_a_rectangle(self):
        given = pcvt.mesh(20, ((2, 0), (0, 0.5)))
        result = pcvt.mesh(20, period=(2, 0.5))
        np.testing.assert_array_equal(result.lattice, [[2, 0], [0, 0.5]])
        np.testing.assert_array_equal(result.sites, given.sites)

    def test_a_result_is_known_to_be_a_minimum_or_a_saddle(self):
        self.assertIs(pcvt.mesh(100).minimum, True)
        self.assertIs(pcvt.mesh(10, start="lattice", max_iterations=0).minimum, False)
        self.assertIsNone(pcvt.mesh(100, max_iterations=3).minimum)
        self.assertIsNone(pcvt.mesh(100, density="1 + u").minimum)

    def test_statistics_describe_the_run(self):
        figures = pcvt.mesh(100, max_iterations=3).statistics
        self.assertEqual((figures.stop, figures.n_sites, figures.iterations),
                         ("iteration-limit", 100, 3))
        self.assertEqual((figures.valences.sum(), figures.valences[6]), (100, figures.n_hexagons))
        single = pcvt.mesh(100, threads=1).statistics
        self.assertEqual((single.stop, single.n_threads), ("converged", 1))


class Seam(unittest.TestCase):
    def setUp(self):
        result = pcvt.mesh(100, OBLIQUE, origin=(0.2, -3))
        self.tiles = [result.tile("voronoi"), result.tile("delaunay")]

    def test_partners_are_translations(self):
        for tile in self.tiles:
            move = columns(tile.seam, "i", "j") @ tile.lattice
            self.assertGreater(np.abs(move).sum(axis=1).min(), 0)
            for v, w in (("v0", "w0"), ("v1", "w1")):
                np.testing.assert_allclose(tile.points[tile.seam[w]],
                                           tile.points[tile.seam[v]] + move, rtol=0, atol=4e-15)

    def test_vertices_are_translations_of_their_orbit(self):
        for tile in self.tiles:
            self.assertTrue((tile.vertex_orbit <= np.arange(len(tile.points))).all())
            moved = tile.points[tile.vertex_orbit] + tile.vertex_offset @ tile.lattice
            np.testing.assert_allclose(tile.points, moved, rtol=0, atol=4e-15)

    def test_each_boundary_edge_is_in_one_pair(self):
        for tile in self.tiles:
            edges = set(map(tuple, edges_of(tile).tolist()))
            boundary = sorted(edge for edge in edges if edge[::-1] not in edges)
            seam = np.concatenate([columns(tile.seam, "v0", "v1"), columns(tile.seam, "w1", "w0")])
            self.assertEqual(sorted(map(tuple, seam.tolist())), boundary)


if __name__ == "__main__":
    main()
