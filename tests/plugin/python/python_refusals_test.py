"""Arguments that the Python package refuses, and the layout of its structs."""

import unittest
from ctypes import byref, sizeof

from support.cli import main
from support.python_package import ROOT, pcvt

import numpy as np
from pcvt import _library, _structs, _views, _words


class Refusals(unittest.TestCase):
    def refuse(self, error, pattern, sites=10, **arguments):
        with self.assertRaisesRegex(error, pattern) as refusal:
            pcvt.mesh(sites, **arguments)
        self.assertNotIn("\n", str(refusal.exception))

    def test_arguments_that_the_library_refuses(self):
        self.refuse(pcvt.ArgumentError, "n_sites is not between", 0)
        self.refuse(ValueError, "parallel", lattice=((1, 0), (2, 0)))
        self.refuse(pcvt.ArgumentError, "lattice is not finite", lattice=((1, 0), (0, np.inf)))
        self.refuse(pcvt.ArgumentError, "site 1 is not finite", [[0, 0], [np.nan, 1]])
        self.refuse(pcvt.GeometryError, "sites 0 and 1 coincide", [[0, 0], [1, 1]])
        self.refuse(pcvt.GeometryError, "2 sites coincide .*site 1 with site 0, site 2 with site 0",
                    [[0, 0], [1, 1], [1e-11, 2]])
        self.refuse(pcvt.ArgumentError, "duplicates is for given sites", duplicates="drop")
        self.refuse(pcvt.ArgumentError, "tolerance", tolerance=0)
        self.refuse(pcvt.ArgumentError, "character 4", density="x +")
        self.refuse(pcvt.ArgumentError, "character 2: a control character", density="1\a + x")
        self.refuse(pcvt.ArgumentError, "grain_size does not work with grain_per_edge", grain_size=0.1, grain_per_edge=2)

    def test_coincident_sites_are_dropped(self):
        result = pcvt.mesh([[0, 0], [0.5, 0.5], [1, 1]], max_iterations=0, orientations=np.arange(9).reshape(3, 3),
                           duplicates="drop")
        self.assertEqual(result.statistics.dropped.tolist(), [[2, 0]])
        self.assertEqual(result.orientations.tolist(), [[0, 1, 2], [3, 4, 5]])

    def test_an_origin_is_a_point_or_auto(self):
        with self.assertRaises((TypeError, ValueError, pcvt.ArgumentError)):
            pcvt.mesh(10, origin="best")

    def test_values_that_do_not_fit_into_the_struct(self):
        self.refuse(pcvt.ArgumentError, "n_sites 8589934602 is out of range", 2**33 + 10)
        self.refuse(pcvt.ArgumentError, "seed -1 is out of range", seed=-1)
        self.refuse(TypeError, "integer", max_iterations=1.5)
        self.refuse(pcvt.ArgumentError, r"lattice has the shape \(2,\)", lattice=(1, 1))
        self.refuse(pcvt.ArgumentError, r"sites has the shape \(1, 3\)", [[0, 0, 0]])
        self.refuse(pcvt.ArgumentError, "solver 'magic' is unknown; .*lbfgs", solver="magic")
        self.refuse(pcvt.ArgumentError, "zero byte", density="x\0")

    def test_periods_that_are_no_rectangle(self):
        self.refuse(pcvt.ArgumentError, "exclude each other", lattice=((1, 0), (0, 1)), period=(1, 1))
        self.refuse(pcvt.ArgumentError, r"period \(2, 0\): a side is not above 0", period=(2, 0))
        self.refuse(pcvt.ArgumentError, "period has the shape", period=2)

    def test_numbers_reach_the_library_by_their_fields_and_no_other_name_does(self):
        for name in ("typo", "dimension", "struct_size", "reserved", "pixels"):
            with self.assertRaisesRegex(TypeError, f"mesh.. got an unexpected keyword argument '{name}'"):
                pcvt.mesh(10, **{name: 1})
        with self.assertRaisesRegex(TypeError, "space.. got an unexpected keyword argument 'areas'"):
            pcvt.space(10, areas=[1] * 10)
        with self.assertRaisesRegex(pcvt.ArgumentError, "^grain_per_edge is not for three dimensions"):
            pcvt.space(10, grain_per_edge=2)
        with self.assertRaisesRegex(TypeError, "write.. got an unexpected keyword argument 'seed'"):
            pcvt.mesh(10).write("a.svg", seed=1)
        with self.assertRaisesRegex(pcvt.ArgumentError, "^pixels is not for files in three dimensions"):
            pcvt.space(10).write("a.png", pixels=3)
        with self.assertRaises(TypeError):
            pcvt.space(10).write("a.png", pixels=2.5)

    def test_refused_files_are_named_without_an_option(self):
        solid = pcvt.space(38, start="lattice")
        for error, result, path, fault in (
                (pcvt.ArgumentError, pcvt.mesh(10), "t.xyz", "unknown extension"),
                (pcvt.ArgumentError, pcvt.mesh(10), "t.msh", "the format has no polygons"),
                (pcvt.GeometryError, pcvt.mesh(10, max_iterations=0), "t.nc", ".* degrees"),
                (pcvt.ArgumentError, solid, "t.nc", ".nc does not support"),
                (pcvt.GeometryError, solid, "t.msh", r"\d+ tetrahedra of these sites are flat")):
            with self.subTest(path, kind=type(result)), self.assertRaisesRegex(error, f"^{path}: {fault}"):
                result.write(path)

    def test_unwritable_files_name_the_path(self):
        with self.assertRaisesRegex(OSError, "/dev/null/tile.ply"):
            pcvt.mesh(10).write("/dev/null/tile.ply")


class Layout(unittest.TestCase):
    STRUCTS = {"pcvt_progress": _structs.Progress, "pcvt_options": _structs.Options,
               "pcvt_sites": _structs.Sites, "pcvt_inclusions": _structs.Inclusions, "pcvt_mesh": _structs.Mesh,
               "pcvt_tile": _structs.Tile, "pcvt_cells": _structs.Cells, "pcvt_statistics": _structs.Statistics,
               "pcvt_write_options": _structs.WriteOptions, "pcvt_check_options": _structs.CheckOptions,
               "pcvt_study_options": _structs.StudyOptions, "pcvt_study_contents": _structs.StudyContents,
               "pcvt_table": _structs.Table, "pcvt_picture": _structs.Picture}

    def test_structs_have_the_recorded_layout(self):
        found = [f"number PCVT_ABI_VERSION {_library.ABI_VERSION}"]
        for name, struct in self.STRUCTS.items():
            found.append(f"struct {name} {sizeof(struct)}")
            for field, *_ in struct._fields_:
                place = getattr(struct, field)
                found.append(f"field {name}.{field} {place.offset} {place.size}")
        recorded = (ROOT / "tests" / "plugin" / "abi" / "pcvt_abi.txt").read_text().splitlines()
        recorded = [line for line in recorded if line.startswith(("struct", "field pcvt_")) and
                    "pcvt_edge_pair" not in line]
        self.assertEqual(found[1:], recorded)
        self.assertEqual(pcvt.mesh(1).tile().seam.dtype.itemsize, 24)

    def test_the_library_refuses_a_struct_one_byte_too_short(self):
        library, own = _library.library, pcvt.mesh(10)
        result = own._handle.pointer
        for get, struct, choices in ((library.pcvt_get_sites, _structs.Sites, ()),
                                     (library.pcvt_get_statistics, _structs.Statistics, ()),
                                     (library.pcvt_get_mesh, _structs.Mesh, (0,)),
                                     (library.pcvt_get_tile, _structs.Tile, (0, 0))):
            view, size = struct(), sizeof(struct)
            self.assertEqual(get(result, *choices, byref(view), size), 0)
            self.assertEqual(get(result, *choices, byref(view), size - 1), -2)
        options, size = _structs.Options(), sizeof(_structs.Options)
        own_version = _library.ABI_VERSION
        for version, less, status in ((0, 0, -2), (own_version, 1, -2), (own_version, 0, 0)):
            self.assertEqual(library.pcvt_options_init(byref(options), size - less, version),
                             status)
        what = _structs.WriteOptions(struct_size=sizeof(_structs.WriteOptions) - 1)
        self.assertEqual(library.pcvt_write(result, b"/nowhere/a.txt", byref(what)), -2)

class Choices(unittest.TestCase):
    def test_each_word_has_its_own_number(self):
        for dimension, choices in _words.CHOICES.items():
            for option, words in choices.items():
                with self.subTest(option, dimension=dimension):
                    numbers = list(words.values())
                    self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(_views.KINDS, ("voronoi", "delaunay", "grains"))
        for kind in _views.KINDS:
            self.assertEqual(pcvt.mesh(5).tile(kind).kind, kind)
        for outline in _views.OUTLINES:
            self.assertEqual(pcvt.mesh(5).tile(outline=outline).outline, outline)

    def test_words_reach_the_library(self):
        for start in _words.CHOICES[2]["start"]:
            self.assertEqual(pcvt.mesh(5, start=start, budget=100 if start == "best" else 0).statistics.n_sites, 5)
        for group in _words.CHOICES[2]["symmetry"]:
            self.assertIsNotNone(pcvt.mesh(48, symmetry=group, period=None, max_iterations=0).orbits)


if __name__ == "__main__":
    main()
