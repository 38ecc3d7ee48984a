"""The types of the Python package: its stub against the package, and programs that mypy checks."""

import ast
import importlib.util
import os
import re
import subprocess
import sys
import unittest

from support.cli import CliTest, main
from support.python_package import PACKAGE, pcvt

HAS_MYPY = importlib.util.find_spec("mypy") is not None
STUB = PACKAGE / "pcvt" / "__init__.pyi"
OLDEST_PYTHON = (3, 8)

PROGRAM = """import pathlib
import numpy as np
import pcvt

result = pcvt.mesh(sites=300, lattice=((1, 0), (0.37, 0.81)), seed=7)
reveal_type(result)
reveal_type(result.tile().points)
print(result.tile().seam["v0"], result.statistics.energy)
result.write(pathlib.Path("tile.glb"), float32=False)
result.plot().figure.savefig("tile.png")
reveal_type(pcvt.mesh(sites=100, period=(1, 1, 1)))
reveal_type(pcvt.mesh(100, ((1, 0, 0), (0.37, 0.81, 0), (0.2, 0.4, 0.9))).tile())
reveal_type(pcvt.space(100, np.eye(3)).tile().volumes)
reveal_type(pcvt.pattern(54, period=(1, 1, 1)))
reveal_type(pcvt.pattern(56))
verdict = pcvt.check([pathlib.Path("tile.glb"), "tile.obj"], cvt=1e-5, period=(1, 1))
reveal_type(verdict.refuted)
study = pcvt.study("fig11", sites=[8, 9], runs=100, path="results/", progress=print)
reveal_type(study.pictures)
print(bool(verdict), study.table["percent"], study.runs["energy"].min())
pcvt.mesh(9, density=lambda x, y: 2 + np.sin(x * y), progress=lambda progress: progress.residual < 1e-3)
pcvt.mesh(np.zeros((3, 2)), areas=[1, 2, 3], phases=["a", "b", "a"], walls="x")
try:
    pcvt.mesh(9, inclusions=[("circle", "a", 0.5, 0.5, 0.2), ("polygon", "b", np.zeros((3, 2)))])
except pcvt.ArgumentError as error:
    print(error)
"""
REVEALED = ["pcvt.Result", "numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]", "pcvt.SpaceResult",
            "pcvt.SpaceTile", "numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]",
            "pcvt.SpaceResult", "pcvt.Result", "builtins.tuple[builtins.str, ...]",
            "builtins.dict[builtins.str, builtins.str]"]

WRONG = """import pcvt
pcvt.mesh(300, seed="seven")
pcvt.mesh(300).tile().volumes
pcvt.mesh(300).write()
pcvt.space(100, walls="x")
pcvt.check("tile.obj", cvt="1e-5")
pcvt.study("fig11", sites="8,9")
"""


class Stub(CliTest):
    def mypy(self, *arguments):
        """Runs a module of mypy in the empty folder of the test; returns its output."""
        done = subprocess.run([sys.executable, "-B", "-m", *map(str, arguments)], capture_output=True, check=False,
                              text=True, cwd=self.folder,
                              env={**os.environ, "PYTHONPATH": str(PACKAGE), "MYPYPATH": str(PACKAGE)})
        self.assertEqual(done.stderr, "")
        return done.stdout

    @unittest.skipUnless(HAS_MYPY, "mypy is missing; tests/packages test installs it")
    def test_the_stub_is_that_of_the_package(self):
        self.write("mypy.ini", "[mypy]\nignore_missing_imports = True\n")
        found = self.mypy("mypy.stubtest", "pcvt", "--concise", "--mypy-config-file", "mypy.ini")
        # Private modules have no stubs.
        differing = [line for line in found.splitlines() if not re.match(r"pcvt\._[a-z]+\.", line)]
        self.assertEqual(differing, [])

    @unittest.skipUnless(HAS_MYPY, "mypy is missing; tests/packages test installs it")
    def test_programs_are_clean_and_have_the_types_that_the_guide_says(self):
        self.write("program.py", PROGRAM)
        found = self.mypy("mypy", "--strict", "program.py")
        self.assertNotIn("error", found)
        self.assertEqual(re.findall('Revealed type is "(.*)"', found), REVEALED)

    @unittest.skipUnless(HAS_MYPY, "mypy is missing; tests/packages test installs it")
    def test_wrong_calls_are_found(self):
        self.write("program.py", WRONG)
        found = self.mypy("mypy", "--strict", "program.py")
        lines = set(map(int, re.findall(r"^program.py:(\d+): error", found, re.MULTILINE)))
        self.assertEqual(lines, {2, 3, 4, 5, 6, 7}, found)

    def test_the_attributes_of_the_stub_exist(self):
        result, solid = pcvt.mesh(9), pcvt.space(5)
        result.write(self.path("tile.obj"))
        objects = [result, result.mesh(), result.tile(), result.statistics, solid, solid.tile(),
                   pcvt.check(self.path("tile.obj")), pcvt.study("fig11", 4, runs=1)]
        tree = ast.parse(STUB.read_text(encoding="utf-8"))
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        for thing in objects:
            stated = {entry.target.id for entry in classes[type(thing).__name__].body
                      if isinstance(entry, ast.AnnAssign)}
            own = {name for name in vars(thing) if name[0] != "_"} if hasattr(thing, "__dict__") else set(thing._fields)
            self.assertEqual(stated, own, type(thing).__name__)

    def test_the_package_is_marked_as_typed_and_runs_on_the_oldest_python(self):
        self.assertTrue((PACKAGE / "pcvt" / "py.typed").is_file())
        for file in sorted((PACKAGE / "pcvt").glob("*.py*")):
            if file.suffix in (".py", ".pyi"):
                ast.parse(file.read_text(encoding="utf-8"), str(file), feature_version=OLDEST_PYTHON)


if __name__ == "__main__":
    main()
