"""Holes on the command line: files, proofs, tables, refusals, threads."""

import csv
import math
import re

from support.cli import CliTest, main, outputs

SHAPES = ("circle pipe 0.95 0.9 0.15\n"
          "ellipse core 0.7 0.4 0.2 0.1 30\n"
          "polygon pipe 0.2 0.3 0.4 0.3 0.3 0.6\n")
PIPES = math.pi * 0.15**2 + 0.03
CORE = math.pi * 0.02
TILES = ("obj", "ply", "glb", "gltf", "om", "vtu", "foam")
SOLVERS = ("msh", "inp", "vtu", "foam", "obj")


class Holes(CliTest):
    def mesh(self, *arguments, sites=600):
        self.path("shapes.txt").write_text(SHAPES)
        return self.succeed("mesh", "--sites", sites, "--tolerance", "1e-3", "--inclusions", "shapes.txt", "--force",
                            "--hole", "pipe", *arguments)

    def rows(self, name="t.csv"):
        lines = [line for line in self.path(name).read_text().splitlines() if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def points(self, name="t.txt"):
        return [line.split() for line in self.path(name).read_text().splitlines() if not line.startswith("#")]

    def test_check_proves_every_format_of_every_mesh(self):
        for mesh, extensions, options in (("voronoi", TILES, ()), ("voronoi", TILES[:-1], ("--outline", "box")),
                                          ("voronoi", TILES, ("--repeat", "2x1", "--short-edges", "0.1")),
                                          ("grains", SOLVERS, ("--hole", "core")),
                                          ("grains", SOLVERS, ("--outline", "box", "--order", "1")),
                                          ("grains", ("msh", "inp", "vtu"), ("--order", "2")),
                                          ("delaunay", ("obj", "glb", "msh", "inp", "vtu", "foam"), ())):
            if mesh == "delaunay":
                extensions = ("obj", "glb", "om", "ply")
            self.mesh("--quiet", "--mesh", mesh, *options, *outputs(*extensions, "svg", "png", "html", "csv", "txt", "dxf"))
            text = self.succeed("check", *(f"t.{extension}" for extension in extensions))
            n = len(self.points())
            self.assertEqual(text.count(f"{n} sites agree"), len(extensions), text)
            self.assertEqual(text.count("on holes, genus 1 after gluing and filling"), len(extensions), text)

    def test_holes_lie_between_walls(self):
        for walls, topology in (("xy", "a disc after filling"), ("x", "an annulus after gluing and filling")):
            self.succeed("mesh", "--sites", 900, "--tolerance", "1e-3", "--walls", walls, "--fibres", "0.2,6", "--hole",
                         "fibre", "--force", "--quiet", *outputs(*TILES))
            lines = self.succeed("check", *(f"t.{extension}" for extension in TILES)).splitlines()
            self.assertEqual(len(lines), len(TILES))
            for line in lines:
                self.assertRegex(line, rf", [1-9]\d* on walls, [1-9]\d* on holes, {topology}, area 0\.8 ")

    def test_sites_outside_of_holes_are_numbered_in_their_order(self):
        self.mesh(*outputs("csv", "txt"))
        self.mesh("--cells", "two.csv", "--hole", "core", "-o", "two.txt")
        rows, both = self.rows(), self.rows("two.csv")
        self.assertEqual([int(row["site"]) for row in rows], list(range(len(rows))))
        self.assertEqual({row["tag"] for row in rows}, {"matrix", "core"})
        self.assertEqual({row["tag"] for row in both}, {"matrix"})
        self.assertAlmostEqual(math.fsum(float(row["area"]) for row in rows), 1 - PIPES, delta=1e-12)
        self.assertAlmostEqual(math.fsum(float(row["area"]) for row in both), 1 - PIPES - CORE, delta=1e-12)
        # Neighbours are numbered alike, and mutual.
        neighbours = [set(map(int, row["neighbours"].split())) for row in rows]
        for site, others in enumerate(neighbours):
            self.assertTrue(all(site in neighbours[other] for other in others))
        self.assertEqual(self.points(), [[row["x"], row["y"]] for row in rows])
        matrix = [row["x"] for row in rows if row["tag"] == "matrix"]
        self.assertEqual(matrix, [row["x"] for row in both])

    def test_solvers_get_walls_with_the_names_of_the_tags(self):
        self.mesh("--quiet", "--mesh", "grains", "--hole", "core", *outputs("msh", "inp", "foam", "glb", "vtu", "obj"))
        for name, words in (("t.msh", '"pipe"'), ("t.msh", '"core"'), ("t.inp", "*NSET,NSET=PIPE"),
                            ("t.inp", "*SURFACE,NAME=CORE_SIDES,TYPE=ELEMENT"), ("t.foam/0/U", "pipe { type noSlip; }"),
                            ("t.foam/constant/transportProperties", "would cross the holes"),
                            ("t.vtu", "HoleEdges"), ("t.obj", "# pcvt hole pipe ")):
            self.assertIn(words, self.path(name).read_text(), name)
        boundary = self.path("t.foam/constant/polyMesh/boundary").read_text()
        self.assertTrue(re.search(r"pipe\s*{\s*type\s+wall;", boundary))

    def test_check_refuses_files_without_the_edge_of_a_hole(self):
        self.mesh("--quiet", "-o", "t.obj", "-o", "t.ply")
        for name in ("t.obj", "t.ply"):
            text = self.path(name).read_text()
            line = re.search(r"^.*pcvt hole pipe \d+ \d+", text, re.M)[0]
            self.path("bad" + name[1:]).write_text(text.replace(line, line.rsplit(" ", 2)[0], 1))
            self.refuse(2, "has no reversed partner", "check", "bad" + name[1:])
            self.path("bad" + name[1:]).write_text(re.sub(r"(?m)^.*pcvt hole .*\n", "", text))
            self.refuse(2, "has no reversed partner", "check", "bad" + name[1:])

    def test_threads_do_not_change_a_byte(self):
        self.mesh("--quiet", "--threads", 1, *outputs("obj", "txt", "vtu"))
        one = self.contents()
        self.mesh("--quiet", "--threads", 4, *outputs("obj", "txt", "vtu"))
        self.assertEqual(self.contents(), one)

    def test_refusals_are_one_line(self):
        self.path("shapes.txt").write_text(SHAPES)
        for pattern, arguments in (
                ("no inclusion has the tag 'pip' of a hole; did you mean pipe", ("--hole", "pip")),
                ("the cells of the matrix are not a hole", ("--hole", "matrix")),
                ("the hole pipe is given twice", ("--hole", "pipe", "--hole", "pipe")),
                ("leave the holes out", ("--hole", "pipe", "-o", "t.nc")),
                ("leave the holes out", ("--hole", "pipe", "-o", "t.vti"))):
            self.refuse(2, pattern, "mesh", "--sites", 600, "--inclusions", "shapes.txt", *arguments)
        self.refuse(2, "add --inclusions or --fibres", "mesh", "--sites", 60, "--hole", "pipe")
        self.path("shapes.txt").write_text("circle seam_1_0 0.5 0.5 0.2\n")
        self.refuse(2, "the name of a set in files .*; rename it", "mesh", "--sites", 600, "--inclusions", "shapes.txt", "--hole", "seam_1_0")


if __name__ == "__main__":
    main()
