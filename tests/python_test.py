"""The Python module: arrays, seam, files, functions that are called back, and refusals.

    python_test.py COMMAND LIBRARY
"""

import gc
import importlib.util
import os
import shutil
import signal
import subprocess
import sys
import threading
import unittest
from ctypes import byref, sizeof
from pathlib import Path

from support.cli import CliTest, main

SKIPPED = 77
if importlib.util.find_spec("numpy") is None:
    print("skipped: numpy is missing; tests/packages test installs python3-numpy")
    sys.exit(SKIPPED)

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "plugin" / "python"
LIBRARY = os.path.abspath(sys.argv.pop(2))
os.environ["PCVT_LIBRARY"] = LIBRARY
sys.path.insert(0, str(PACKAGE))
import pcvt
from pcvt import _library

OBLIQUE = np.array([[1, 0], [0.37, 0.81]])


def python(*arguments, **environment):
    """Runs another interpreter, which finds the package."""
    return subprocess.run([sys.executable, "-B", *map(str, arguments)], capture_output=True,
                          check=False, text=True,
                          env={**os.environ, "PYTHONPATH": str(PACKAGE), **environment})


def edges_of(tile):
    """Rows v0, v1: each side of each face, counter-clockwise."""
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

    def test_statistics_tell_the_run(self):
        figures = pcvt.mesh(100, max_iterations=3).statistics
        self.assertEqual((figures.stop, figures.n_sites, figures.iterations),
                         ("iteration-limit", 100, 3))
        self.assertEqual((figures.valences.sum(), figures.valences[6]), (100, figures.n_hexagons))
        alone = pcvt.mesh(100, threads=1).statistics
        self.assertEqual((alone.stop, alone.n_threads), ("converged", 1))


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


class Files(CliTest):
    def test_the_command_writes_the_same_bytes(self):
        for extension in ("txt", "ply", "glb"):
            self.succeed("mesh", "--sites", 200, "--seed", 3, "--lattice", "1,0,0.37,0.81",
                         "--origin", "0.2,-3", "--repeat", "2x1", "-o", f"command.{extension}")
            result = pcvt.mesh(200, OBLIQUE, seed=3, origin=(0.2, -3), repeat=(2, 1))
            result.write(self.path(f"python.{extension}"))
            files = self.contents()
            self.assertEqual(files[f"python.{extension}"], files[f"command.{extension}"])

    def test_given_sites_lead_to_the_same_bytes(self):
        given = np.random.default_rng(5).random((80, 2))
        np.savetxt(self.path("given"), given, fmt="%.17g")
        self.succeed("mesh", "--input", "given", "--mesh", "delaunay", "-o", "command.txt", "-o",
                     "command.ply")
        result = pcvt.mesh(given)
        result.write(self.path("python.txt"))
        result.write(str(self.path("python.ply")), "delaunay")
        files = self.contents()
        self.assertEqual(files["python.txt"], files["command.txt"])
        self.assertEqual(files["python.ply"], files["command.ply"])
        np.testing.assert_array_equal(np.loadtxt(self.path("command.txt")), result.sites)

    def test_files_are_replaced_only_where_asked_for(self):
        result = pcvt.mesh(10)
        result.write(self.path("tile.ply"), report=self.path("tile.json"))
        before = self.contents()
        self.assertEqual(sorted(before), ["tile.json", "tile.ply"])
        with self.assertRaisesRegex(pcvt.OutputError, "tile.ply.*replace"):
            result.write(self.path("tile.ply"), "delaunay")
        self.assertEqual(self.contents(), before)
        result.write(self.path("tile.ply"), "delaunay", replace=True)
        self.assertNotEqual(self.contents()["tile.ply"], before["tile.ply"])


class Density(unittest.TestCase):
    def test_a_function_is_what_its_expression_is(self):
        seen = set()

        def density(x, y):
            seen.add((x.shape, y.shape, x.dtype.char))
            return 1.5 + np.sin(2 * np.pi * x)

        by_function = pcvt.mesh(3, density=density, max_iterations=1)
        by_text = pcvt.mesh(3, density="1.5 + sin(2*_pi*x)", max_iterations=1)
        np.testing.assert_allclose(by_function.sites, by_text.sites, atol=1e-9)
        self.assertTrue(np.isnan(by_function.statistics.energy_bound))
        for x, y, kind in seen:
            self.assertEqual((x, kind), (y, "d"))

    def test_its_exceptions_come_through(self):
        with self.assertRaises(ZeroDivisionError):
            pcvt.mesh(10, density=lambda x, y: 1 / 0)
        with self.assertRaisesRegex(ValueError, "broadcast"):
            pcvt.mesh(10, density=lambda x, y: np.ones(len(x) + 2))

    def test_bad_values_are_refused(self):
        for value in (float("nan"), 0, -1):
            with self.assertRaisesRegex(pcvt.DensityError, "positive"):
                pcvt.mesh(10, density=lambda x, y, value=value: value)


class Stopping(unittest.TestCase):
    def tearDown(self):
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_a_true_answer_cancels(self):
        seen = []

        def progress(state):
            seen.append(state)
            return state.iteration == 7

        with self.assertRaisesRegex(pcvt.Cancelled, "cancelled"):
            pcvt.mesh(1000, progress=progress)
        self.assertEqual([state.iteration for state in seen], list(range(8)))
        self.assertLess(seen[-1].energy, seen[0].energy)
        self.assertGreater(seen[-1].energy, seen[-1].energy_bound)

    def test_exceptions_of_progress_come_through(self):
        for error in (KeyboardInterrupt, SystemExit, LookupError):
            def progress(_, error=error):
                raise error("mine")

            with self.assertRaisesRegex(error, "mine"):
                pcvt.mesh(100, progress=progress)

    def test_an_interrupt_inside_of_a_function_comes_through(self):
        went_on = []

        def interrupted(*_):
            signal.raise_signal(signal.SIGINT)
            went_on.append(True)
            return 1

        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(100, progress=interrupted)
        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(100, density=interrupted)
        self.assertEqual(went_on, [])

    def test_an_interrupt_while_the_library_computes_comes_through(self):
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        self.addCleanup(timer.join)
        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(30000, tolerance=1e-12)

    def test_any_thread_may_generate(self):
        found = []
        thread = threading.Thread(target=lambda: found.append(pcvt.mesh(100, seed=4)))
        thread.start()
        thread.join()
        np.testing.assert_array_equal(found[0].sites, pcvt.mesh(100, seed=4).sites)


class Refusals(unittest.TestCase):
    def refuse(self, error, pattern, sites=10, **arguments):
        with self.assertRaisesRegex(error, pattern) as refusal:
            pcvt.mesh(sites, **arguments)
        self.assertNotIn("\n", str(refusal.exception))

    def test_what_the_library_refuses(self):
        self.refuse(pcvt.ArgumentError, "n_sites is not between", 0)
        self.refuse(ValueError, "parallel", lattice=((1, 0), (2, 0)))
        self.refuse(pcvt.ArgumentError, "lattice is not finite", lattice=((1, 0), (0, np.inf)))
        self.refuse(pcvt.ArgumentError, "site 1 is not finite", [[0, 0], [np.nan, 1]])
        self.refuse(pcvt.GeometryError, "sites 0 and 1 coincide", [[0, 0], [1, 1]])
        self.refuse(pcvt.ArgumentError, "tolerance", tolerance=0)
        self.refuse(pcvt.ArgumentError, "character 4", density="x +")

    def test_what_does_not_fit_into_the_struct(self):
        self.refuse(pcvt.ArgumentError, "n_sites 8589934602 is out of range", 2**33 + 10)
        self.refuse(pcvt.ArgumentError, "seed -1 is out of range", seed=-1)
        self.refuse(TypeError, "integer", max_iterations=1.5)
        self.refuse(pcvt.ArgumentError, r"lattice has the shape \(2,\)", lattice=(1, 1))
        self.refuse(pcvt.ArgumentError, r"sites has the shape \(1, 3\)", [[0, 0, 0]])
        self.refuse(pcvt.ArgumentError, "solver 'magic' is unknown; .*lbfgs", solver="magic")
        self.refuse(pcvt.ArgumentError, "zero byte", density="x\0")

    def test_unwritable_files_name_the_path(self):
        with self.assertRaisesRegex(OSError, "/nowhere/tile.ply"):
            pcvt.mesh(10).write("/nowhere/tile.ply")


class Layout(unittest.TestCase):
    STRUCTS = {"pcvt_progress": _library.Progress, "pcvt_options": _library.Options,
               "pcvt_sites": _library.Sites, "pcvt_mesh": _library.Mesh,
               "pcvt_tile": _library.Tile, "pcvt_statistics": _library.Statistics,
               "pcvt_write_options": _library.WriteOptions}

    def test_structs_lie_as_recorded(self):
        found = [f"number PCVT_ABI_VERSION {_library.ABI_VERSION}"]
        for name, struct in self.STRUCTS.items():
            found.append(f"struct {name} {sizeof(struct)}")
            for field, *_ in struct._fields_:
                place = getattr(struct, field)
                found.append(f"field {name}.{field} {place.offset} {place.size}")
        recorded = (ROOT / "tests" / "pcvt_abi.txt").read_text().splitlines()
        recorded = [line for line in recorded if line.startswith(("struct", "field pcvt_")) and
                    "pcvt_edge_pair" not in line]
        self.assertEqual(found[1:], recorded)
        self.assertEqual(pcvt.mesh(1).tile().seam.dtype.itemsize, 24)

    def test_the_library_refuses_a_byte_less(self):
        library, own = _library.library, pcvt.mesh(10)
        result = own._handle.pointer
        for get, struct, choices in ((library.pcvt_get_sites, _library.Sites, ()),
                                     (library.pcvt_get_statistics, _library.Statistics, ()),
                                     (library.pcvt_get_mesh, _library.Mesh, (0,)),
                                     (library.pcvt_get_tile, _library.Tile, (0, 0))):
            view, size = struct(), sizeof(struct)
            self.assertEqual(get(result, *choices, byref(view), size), 0)
            self.assertEqual(get(result, *choices, byref(view), size - 1), -2)
        options, size = _library.Options(), sizeof(_library.Options)
        for version, less, status in ((0, 0, -2), (1, 1, -2), (1, 0, 0)):
            self.assertEqual(library.pcvt_options_init(byref(options), size - less, version),
                             status)
        what = _library.WriteOptions(struct_size=sizeof(_library.WriteOptions) - 1)
        self.assertEqual(library.pcvt_write(result, b"/nowhere/a.txt", byref(what)), -2)


class Loading(CliTest):
    IMPORT = "import pcvt, sys; print(pcvt.version(), 'matplotlib' in sys.modules)"

    def test_a_missing_library_is_named(self):
        done = python("-c", self.IMPORT, PCVT_LIBRARY="/nowhere/libpcvt.so")
        self.assertRegex(done.stderr, "ImportError: cannot load /nowhere/.*set PCVT_LIBRARY")

    def test_a_library_beside_the_package_is_found(self):
        shutil.copytree(PACKAGE / "pcvt", self.path("pcvt"))
        self.path("libpcvt.so.0.1").symlink_to(LIBRARY)
        done = python("-c", self.IMPORT, PCVT_LIBRARY="", PYTHONPATH=str(self.folder))
        self.assertEqual(done.stdout, f"{pcvt.version()} False\n", done.stderr)

    @unittest.skipIf(importlib.util.find_spec("matplotlib") is None, "matplotlib is missing")
    def test_the_sample_draws_its_figure(self):
        figure = self.path("figure.png")
        done = python(ROOT / "samples" / "python_tour.py", figure, MPLCONFIGDIR=str(self.folder))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, "pairs on the seam")
        self.assertEqual(figure.read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    main()
