"""Files that the Python package writes, and how it finds the library."""

import concurrent.futures
import csv
import importlib.util
import math
import os
import shutil
import subprocess
import sys
import unittest

from support.cli import CliTest, main
from support.python_package import LIBRARY, OBLIQUE, PACKAGE, ROOT, pcvt

import numpy as np


def python(*arguments, **environment):
    """Runs another interpreter in which the package can be imported."""
    return subprocess.run([sys.executable, "-B", *map(str, arguments)], capture_output=True,
                          check=False, text=True,
                          env={**os.environ, "PYTHONPATH": str(PACKAGE), **environment})


class Files(CliTest):
    def test_the_command_writes_the_same_bytes(self):
        for extension in ("txt", "ply", "glb"):
            self.succeed("mesh", "--sites", 200, "--seed", 3, "--lattice", "1,0,0.37,0.81",
                         "--origin", "0.2,-3", "--repeat", "2x1", "-o", f"command.{extension}")
            result = pcvt.mesh(200, OBLIQUE, seed=3, origin=(0.2, -3), repeat=(2, 1))
            result.write(self.path(f"python.{extension}"))
            files = self.contents()
            self.assertEqual(files[f"python.{extension}"], files[f"command.{extension}"])

    def test_boxes_at_zero_and_where_the_cut_is_best_have_the_same_bytes(self):
        for origin, given in (("0,0", {}), ("auto", {"origin": "auto"})):
            self.succeed("mesh", "--sites", 40, "--outline", "box", "--origin", origin, "--force",
                         "--quiet", "-o", "command.ply")
            pcvt.mesh(40, **given).write(self.path("python.ply"), outline="box", replace=True)
            files = self.contents()
            self.assertEqual(files["python.ply"], files["command.ply"])

    def test_the_forms_of_files_are_those_of_the_command(self):
        result = pcvt.mesh(60, OBLIQUE)
        for extension, option, arguments in (("glb", ("--glb-nodes", "one"), {"gltf_nodes": "one"}),
                                             ("ply", ("--float32",), {"float32": True}),
                                             ("png", ("--pixels", 90), {"pixels": 90}),
                                             ("svg", ("--cut", 90), {"cut_width": 90}),
                                             ("dxf", ("--cut", 90), {"cut_width": 90})):
            self.succeed("mesh", "--sites", 60, "--lattice", "1,0,0.37,0.81", *option, "-o",
                         f"command.{extension}")
            result.write(self.path(f"python.{extension}"), **arguments)
            files = self.contents()
            self.assertEqual(files[f"python.{extension}"], files[f"command.{extension}"])
            with self.assertRaisesRegex(pcvt.ArgumentError, "no output takes"):
                result.write(self.path("python.obj"), **arguments)
        for arguments, words in (({"gltf_nodes": "two"}, "cells"), ({"pixels": -1}, "negative"),
                                 ({"pixels": 1 << 40}, "range"), ({"cut_width": -2}, "negative"),
                                 ({"pixels": 30000}, "at most")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                result.write(self.path("python.png"), **arguments)

    def test_the_thickness_of_a_layer_is_that_of_the_command(self):
        self.succeed("mesh", "--sites", 60, "--thickness", 0.3, "-o", "command.foam")
        pcvt.mesh(60).write(self.path("python.foam"), thickness=0.3)
        points = "constant/polyMesh/points"
        self.assertEqual(self.path(f"python.foam/{points}").read_bytes(),
                         self.path(f"command.foam/{points}").read_bytes())
        for arguments, words in (({"thickness": -1}, "negative"), ({"thickness": 1e9}, "thickness")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                pcvt.mesh(60).write(self.path("no.foam"), **arguments)

    def test_colours_and_backgrounds_are_those_of_the_command(self):
        result = pcvt.mesh(60)
        for option, arguments in ((("--colour", "cells"), {"colour": "cells"}),
                                  (("--colour", "size", "--background", "#0d1117"),
                                   {"colour": "size", "background": "#0d1117"})):
            self.succeed("mesh", "--sites", 60, *option, "--force", "-o", "command.svg")
            result.write(self.path("python.svg"), replace=True, **arguments)
            files = self.contents()
            self.assertEqual(files["python.svg"], files["command.svg"])
        for arguments, words in (({"colour": "red"}, "sides, size"), ({"colour": "density"}, "colour density needs density"),
                                 ({"background": "blue"}, "#rrggbb")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                result.write(self.path("no.svg"), **arguments)

    def test_threads_that_replace_the_same_files_leave_the_files_of_one(self):
        results = [pcvt.mesh(30, seed=k, threads=1) for k in range(6)]
        path = self.path("new/a.obj")
        with concurrent.futures.ThreadPoolExecutor(len(results)) as pool:
            for _ in range(10):
                list(pool.map(lambda result: result.write(path, replace=True), results))
        found = self.contents()
        matching = []
        for result in results:
            result.write(path, replace=True)
            matching.append(self.contents() == found)
        self.assertEqual(sum(matching), 1)

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

    def test_elements_are_those_of_the_command(self):
        for element in ("CPE", "CPS"):
            self.succeed("mesh", "--sites", 12, "--mesh", "grains", "--element", element, "-o",
                         f"command{element}.inp")
            pcvt.mesh(12).write(self.path(f"python{element}.inp"), "grains", element=element)
            files = self.contents()
            self.assertEqual(files[f"python{element}.inp"], files[f"command{element}.inp"])
        self.assertNotEqual(files["pythonCPE.inp"], files["pythonCPS.inp"])
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", "--element", "C3D15", "--thickness", 0.2, "-o", "command15.inp")
        pcvt.mesh(12, grain_order=2).write(self.path("python15.inp"), "grains", element="C3D15", thickness=0.2)
        self.assertEqual(self.path("python15.inp").read_bytes(), self.path("command15.inp").read_bytes())
        with self.assertRaisesRegex(pcvt.ArgumentError, "the elements C3D15 have nodes in the middle of edges; take order 2"):
            pcvt.mesh(12).write(self.path("no.inp"), "grains", element="C3D15")
        with self.assertRaisesRegex(pcvt.ArgumentError, "element 'C3D' is unknown; take one of CPE"):
            pcvt.mesh(12).write(self.path("no.inp"), "grains", element="C3D")

    def test_materials_of_a_file_are_those_of_the_command(self):
        self.path("metals.yaml").write_text("phase: {Copper: {mechanical: {elastic: {C_11: 168.3, C_12: 122.1, C_44: 75.7}}}}")
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", "--job", "elastic", "--material", "metals.yaml", "-o", "command.inp")
        for name, materials in (("text", str(self.path("metals.yaml"))), ("path", self.path("metals.yaml"))):
            pcvt.mesh(12).write(self.path(f"{name}.inp"), "grains", job="elastic", materials=materials)
            self.assertEqual(self.path(f"{name}.inp").read_bytes(), self.path("command.inp").read_bytes())
        with self.assertRaisesRegex(pcvt.Error, "no.yaml: cannot read: "):
            pcvt.mesh(12).write(self.path("no.inp"), "grains", job="elastic", materials="no.yaml")

    def test_cells_are_those_of_the_table(self):
        grains = {"areas": "lognormal:0.3", "max_iterations": 2, "phases": "a:0.4,b:0.6", "orientations": "random"}
        for k, options in enumerate(({}, grains)):
            result = pcvt.mesh(70, OBLIQUE, **options)
            result.write(self.path(f"{k}.csv"))
            with open(self.path(f"{k}.csv"), encoding="ascii") as file:
                rows = list(csv.DictReader(line for line in file if line[0] != "#"))
            cells = result.cells
            self.assertEqual([name for name in rows[0] if name != "tag"], list(cells.dtype.names))
            self.assertEqual(cells["sides"].sum(), 6 * 70)
            for name in ("site", "x", "y", "weight", "area", "diameter", "sides", "circularity", "phi1", "Phi", "phi2"):
                column = [float(row[name]) if row[name] else math.nan for row in rows]
                np.testing.assert_allclose(cells[name], column, rtol=1e-12)
                self.assertEqual(np.isnan(column).any(), name in ("weight", "phi1", "Phi", "phi2") and not options)
            names = [result.phase_names[phase] if phase >= 0 else "" for phase in cells["phase"]]
            self.assertEqual(names, [row["phase"] for row in rows])
            for neighbours, row in zip(cells["neighbours"], rows):
                self.assertEqual(list(neighbours), list(map(int, row["neighbours"].split())))

    def test_files_are_replaced_on_request_only(self):
        result = pcvt.mesh(10)
        result.write(self.path("tile.ply"), report=self.path("tile.json"))
        before = self.contents()
        self.assertEqual(sorted(before), ["tile.json", "tile.ply"])
        with self.assertRaisesRegex(pcvt.OutputError, "tile.ply.*replace"):
            result.write(self.path("tile.ply"), "delaunay")
        self.assertEqual(self.contents(), before)
        result.write(self.path("tile.ply"), "delaunay", replace=True)
        self.assertNotEqual(self.contents()["tile.ply"], before["tile.ply"])


class Loading(CliTest):
    IMPORT = "import pcvt, sys; print(pcvt.version(), 'matplotlib' in sys.modules)"

    def test_a_missing_library_is_named(self):
        done = python("-c", self.IMPORT, PCVT_LIBRARY="/nowhere/libpcvt.so")
        self.assertRegex(done.stderr, "ImportError: cannot load /nowhere/.*set PCVT_LIBRARY")

    def test_a_library_beside_the_package_is_found(self):
        shutil.copytree(PACKAGE / "pcvt", self.path("pcvt"))
        self.path("libpcvt.so.0.3").symlink_to(LIBRARY)
        done = python("-c", self.IMPORT, PCVT_LIBRARY="", PYTHONPATH=str(self.folder))
        self.assertEqual(done.stdout, f"{pcvt.version()} False\n", done.stderr)

    def test_a_missing_package_is_named_with_the_remedy(self):
        for name, use in (("numpy", "import pcvt"), ("matplotlib", "import pcvt; pcvt.mesh(9).plot()")):
            done = python("-c", f"import sys; sys.modules['{name}'] = None; {use}")
            self.assertRegex(done.stderr, rf"ModuleNotFoundError: .* need\w* {name}; .*pip install {name}")

    @unittest.skipIf(importlib.util.find_spec("matplotlib") is None, "matplotlib is missing")
    def test_the_sample_draws_its_figure(self):
        figure = self.path("figure.png")
        done = python(ROOT / "samples" / "python_tour.py", figure, MPLCONFIGDIR=str(self.folder))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, "pairs on the seam")
        self.assertEqual(figure.read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    main()
