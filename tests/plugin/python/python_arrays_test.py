"""The arrays of the Python package, and the seam that they describe."""

import ctypes
import gc
import unittest
from unittest import mock

from support.cli import main
from support.python_package import OBLIQUE, pcvt

import numpy as np
from pcvt import _library, _structs


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


# Names of arrays that differ from those of their fields in pcvt.h.
NAMES = {(_structs.Sites, "points"): "sites", (_structs.Tile, "edge_pairs"): "seam"}


def shown_views():
    """Yields an object of the package with a view of pcvt.h that it shows."""
    library = _library.library
    plane = pcvt.mesh(30, OBLIQUE, areas=np.arange(1, 31), phases="soft:0.5,hard:0.5", orientations="random")
    walled = pcvt.mesh(30, walls="x", inclusions=[("polygon", "a", [[0.2, 0.2], [0.5, 0.2], [0.4, 0.6]])], holes="a")
    dropped = pcvt.mesh(np.array([[0, 0], [0.3, 0.4], [1, 1]]), duplicates="drop")
    solid = pcvt.mesh(20, period=(1, 1, 1), volumes="lognormal:0.3", phases="a:0.5,b:0.5", orientations="random")
    symmetric = pcvt.mesh(16, symmetry="p4")
    for result in (plane, walled, dropped, symmetric):
        handle = result._handle
        yield result, handle.view(library.pcvt_get_sites, _structs.Sites)
        yield result.statistics, handle.view(library.pcvt_get_statistics, _structs.Statistics)
        for kind in (0, 1):
            name = ("voronoi", "delaunay")[kind]
            if result is not walled:
                yield result.mesh(name), handle.view(library.pcvt_get_mesh, _structs.Mesh, kind)
                yield result.tile(name), handle.view(library.pcvt_get_tile, _structs.Tile, kind, 0)
    yield walled.tile(), walled._handle.view(library.pcvt_get_tile, _structs.Tile, 0, 0)
    cells = solid._handle.view(library.pcvt_get_cells, _structs.Cells)
    yield solid, cells
    yield solid.tile(), cells
    yield solid.statistics, solid._handle.view(library.pcvt_get_statistics, _structs.Statistics)


def arrays_of(thing, view):
    """The fields of a view that hold addresses, with the arrays of the object that show them."""
    for field, kind in view._fields_:
        shown = getattr(thing, NAMES.get((type(view), field), field), None)
        if kind is ctypes.c_void_p and getattr(view, field) is not None and isinstance(shown, np.ndarray):
            yield field, getattr(view, field), shown


class Memory(unittest.TestCase):
    def test_arrays_lie_at_the_addresses_of_the_library(self):
        seen = set()
        for thing, view in shown_views():
            for field, address, array in arrays_of(thing, view):
                if array.size > 0:
                    with self.subTest(thing=type(thing).__name__, field=field):
                        self.assertEqual(array.ctypes.data, address)
                        self.assertTrue(array.flags.c_contiguous and not array.flags.writeable)
                seen.add((type(view).__name__, field))
        pointers = {(struct.__name__, field) for struct in (
            _structs.Sites, _structs.Statistics, _structs.Mesh, _structs.Tile, _structs.Cells)
            for field, kind in struct._fields_ if kind is ctypes.c_void_p}
        self.assertEqual(pointers - seen, set())

    def test_polygons_of_inclusions_are_views(self):
        result = pcvt.mesh(60, inclusions=[("circle", "b", 0.8, 0.8, 0.1),
                                           ("polygon", "a", [[0.2, 0.2], [0.5, 0.2], [0.4, 0.6]])])
        view = result._handle.view(_library.library.pcvt_get_inclusions, _structs.Inclusions)
        self.assertEqual(result.inclusions[1][2].ctypes.data, view.numbers + 3 * 8)

    def test_two_tiles_share_their_memory(self):
        result = pcvt.mesh(30)
        self.assertTrue(np.shares_memory(result.tile().points, result.tile().points))
        self.assertFalse(np.shares_memory(result.tile().points, result.tile("delaunay").points))

    def test_each_array_keeps_its_result_alive(self):
        freed = []
        free = _library.library.pcvt_free
        _library.library.pcvt_free = freed.append
        self.addCleanup(setattr, _library.library, "pcvt_free", free)
        kept = [shown for thing, view in shown_views() for _, _, shown in arrays_of(thing, view) if shown.size > 0]
        gc.collect()
        self.assertEqual(freed, [])
        pointers = {owner_of(shown).pointer for shown in kept}
        self.assertEqual(len(pointers), 5)
        while kept:
            kept.pop()
            self.assertEqual({owner_of(shown).pointer for shown in kept} & set(freed), set())
        gc.collect()
        self.assertEqual(sorted(freed), sorted(pointers))
        for pointer in freed:
            free(pointer)


def owner_of(array):
    """The handle of the result whose memory an array shows."""
    while isinstance(array, np.ndarray):
        array = array.base
    return array.owner


class Inputs(unittest.TestCase):
    def given(self, *arguments, **options):
        """The options that the library gets."""
        seen = {}
        generate = _library.library.pcvt_generate

        def note(pointer, result):
            seen.update((name, getattr(pointer._obj, name)) for name, kind in _structs.Options._fields_
                        if kind is ctypes.c_void_p)
            return generate(pointer, result)

        with mock.patch.object(_library.library, "pcvt_generate", note):
            pcvt.mesh(*arguments, **options)
        return seen

    def test_arrays_of_doubles_are_not_copied(self):
        sites = np.random.default_rng(1).random((20, 2))
        sizes, weights, angles = np.arange(1.0, 21), np.zeros(20), np.zeros((20, 3))
        sites.flags.writeable = False
        found = self.given(sites, areas=sizes, orientations=angles)
        self.assertEqual([found[name] for name in ("sites", "areas", "orientations")],
                         [array.ctypes.data for array in (sites, sizes, angles)])
        found = self.given(sites, weights=weights, max_iterations=0)
        self.assertEqual(found["weights"], weights.ctypes.data)
        self.assertEqual(self.given(20, fixed=sites[:5])["fixed_sites"], sites.ctypes.data)
        points = np.random.default_rng(1).random((20, 3))
        self.assertEqual(self.given(points, period=(1, 1, 1))["sites"], points.ctypes.data)

    def test_other_arrays_give_the_same_result(self):
        sites = np.random.default_rng(1).random((20, 2))
        expected = pcvt.mesh(sites).sites
        for name, given in (("list", sites.tolist()), ("order", np.asfortranarray(sites)),
                            ("strides", np.repeat(sites, 2, axis=0)[::2]), ("bytes", sites.astype(">f8"))):
            with self.subTest(name):
                np.testing.assert_array_equal(pcvt.mesh(given).sites, expected)


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
