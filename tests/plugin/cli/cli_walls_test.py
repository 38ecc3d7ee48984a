"""Walls on the command line: sites, files, reports, proofs and refusals of channels and boxes."""

import collections
import json
import re

from support.cli import CliTest, main, outputs

CHANNEL = ("--sites", 40, "--period", "2,1", "--tolerance", "1e-4")
TILES = ("obj", "ply", "glb", "gltf", "om", "vtu")
SOLVERS = ("msh", "inp")
PICTURES = ("svg", "png", "html", "dxf")


class Walls(CliTest):
    def mesh(self, *arguments):
        return self.succeed("mesh", *CHANNEL, "--force", *arguments)

    def sites(self, name):
        lines = self.path(name).read_text().splitlines()
        return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]

    def test_check_proves_every_format_of_every_mesh(self):
        for walls, content, words in (
                ("x", "a channel: periodic along y, walls wall_left and wall_right, ", "an annulus after gluing"),
                ("y", "a channel: periodic along x, walls wall_bottom and wall_top, ", "an annulus after gluing"),
                ("xy", "a box with four walls: ", "a disc")):
            for mesh, cells, options in (("voronoi", "whole", ()), ("voronoi", "half", ()),
                                         ("voronoi", "whole", ("--outline", "box")),
                                         ("delaunay", "half", ()), ("grains", "whole", ()),
                                         ("grains", "half", ()), ("grains", "whole", ("--outline", "box"))):
                extensions = TILES + (() if mesh == "voronoi" else SOLVERS)
                self.mesh("--quiet", "--walls", walls, "--wall-cells", cells, "--mesh", mesh, *options,
                          *outputs(*extensions, *PICTURES))
                text = self.succeed("check", *(f"t.{extension}" for extension in extensions))
                self.assertEqual(text.count("t."), len(extensions))
                for line in text.splitlines():
                    self.assertRegex(line, rf"^t\.\w+: {content}\d+ vertices, .*\d+ on walls, {words}, area 2 .*"
                                     "40 sites agree")
                    self.assertEqual("in 0 pairs" in line, walls == "xy", line)

    def test_check_names_what_a_refuted_file_is_not(self):
        for walls, name in (("x", "a channel"), ("y", "a channel"), ("xy", "a box with four walls")):
            self.mesh("--quiet", "--walls", walls, "-o", "t.ply")
            text = self.path("t.ply").read_text()
            # The first vertex exchanges its coordinates, which no wall or partner allows.
            self.write("u.ply", re.sub(r"(end_header\n)(\S+) (\S+)", r"\1\3 \2", text))
            self.refuse(2, rf"^u\.ply: not {name}: ", "check", "u.ply")

    def test_grains_of_second_order_are_proved(self):
        for walls in ("x", "y", "xy"):
            self.mesh("--quiet", "--walls", walls, "--mesh", "grains", "--order", 2, *outputs("msh", "inp", "vtu"))
            self.succeed("check", "t.msh", "t.inp", "t.vtu")

    def test_whole_cells_are_a_centroidal_tessellation(self):
        for walls in ("x", "y", "xy"):
            self.succeed("mesh", "--sites", 40, "--period", "2,1", "--force", "--quiet", "--walls", walls,
                         *outputs("obj", "glb"))
            self.succeed("check", "--cvt", "t.obj")

    def test_half_cells_are_a_centroidal_tessellation(self):
        half = ("--sites", 40, "--period", "2,1", "--wall-cells", "half", "--force", "--quiet")
        for walls in ("x", "y", "xy"):
            self.succeed("mesh", *half, "--walls", walls, *outputs("obj", "glb", "vtu"))
            said = self.succeed("check", "--cvt", "t.obj", "t.glb", "t.vtu")
            self.assertEqual(said.count("centroidal Voronoi within"), 3)
            self.succeed("mesh", *half, "--walls", walls, "--density", "1 + 4 * v", *outputs("obj"))
            self.succeed("check", "--cvt", "--density", "1 + 4 * v", "t.obj")
            self.refuse(2, "law of Voronoi: a corner of the edge", "check", "--cvt", "t.obj")

    def test_tables_pictures_and_summaries_count_the_same_sides(self):
        for cells in ("whole", "half"):
            for walls in ("x", "y", "xy"):
                text = self.mesh("--walls", walls, "--wall-cells", cells, "--cells", "t.csv", "-o", "t.svg")
                rows = [line.split(",") for line in self.path("t.csv").read_text().splitlines()
                        if not line.startswith("#")]
                column = rows[0].index("sides")
                counts = collections.Counter(row[column] for row in rows[1:])
                words = " ".join(f"{n}:{counts[n]}" for n in sorted(counts))
                self.assertIn(f"sides {words}", text)
                legend = re.findall(r"(\d+) sides: (\d+)", self.path("t.svg").read_text())
                self.assertEqual({n: int(count) for n, count in legend}, dict(counts))

    def test_report_and_summary_state_the_walls(self):
        text = self.mesh("--walls", "y", "--report", "r.json")
        self.assertRegex(text, r"(?m)^walls +y, whole cells$")
        walls = json.loads(self.path("r.json").read_text())["walls"]
        self.assertEqual(walls, {"sides": "y", "cells": "whole", "sites": 0})
        text = self.mesh("--walls", "xy", "--wall-cells", "half", "--report", "r.json", "-o", "s.txt")
        walls = json.loads(self.path("r.json").read_text())["walls"]
        self.assertEqual((walls["sides"], walls["cells"]), ("xy", "half"))
        on_walls = sum(x in (0, 2) or y in (0, 1) for x, y in self.sites("s.txt"))
        self.assertEqual(walls["sites"], on_walls)
        self.assertRegex(text, rf"(?m)^walls +xy, half cells, {on_walls} sites on walls$")
        self.mesh("--quiet", "--report", "r.json")
        self.assertNotIn("walls", json.loads(self.path("r.json").read_text()))

    def test_large_runs_start_coarse_as_without_walls(self):
        for options, start in ((("--sites", 40), "random"), (("--sites", 1000), "coarse"),
                               (("--sites", 1000, "--max-iterations", 0), "random"),
                               (("--sites", 1000, "--areas", "equal", "--max-iterations", 1), "random"),
                               (("--sites", 200, "--start", "coarse", "--density", "1 + v"), "coarse"),
                               (("--sites", 200, "--start", "coarse", "--areas", "gamma:0.3", "--max-iterations", 1), "coarse"),
                               (("--sites", 1000, "--start", "random"), "random")):
            self.succeed("mesh", "--walls", "xy", "--tolerance", "1e-3", "--quiet", "--force", *options, "--report",
                         "r.json", "-o", "t.obj")
            self.assertEqual(json.loads(self.path("r.json").read_text())["start"], start, options)
            self.succeed("check", "t.obj")

    def test_written_sites_are_read_again(self):
        for cells in ("whole", "half"):
            self.mesh("--quiet", "--walls", "y", "--wall-cells", cells, "-o", "s.txt", "-o", "c.csv", "-o", "a.vtu")
            sites = self.sites("s.txt")
            self.assertEqual(len(sites), 40)
            self.assertTrue(all(0 <= y <= 1 for _, y in sites))
            self.assertEqual(any(y in (0, 1) for _, y in sites), cells == "half")
            self.assertIn("site", self.path("c.csv").read_text())
            self.succeed("mesh", "--input", "s.txt", "--period", "2,1", "--walls", "y", "--wall-cells", cells,
                         "--tolerance", "1e-4", "--force", "--quiet", "-o", "u.txt", "-o", "u.vtu")
            for (x, y), (u, v) in zip(sites, self.sites("u.txt")):
                self.assertAlmostEqual(y, v, 3)
                self.assertLess(abs((x - u + 1) % 2 - 1), 1e-3)
            self.succeed("check", "u.vtu")

    def test_check_refuses_walls_that_are_none(self):
        for extension, note in (("obj", "walls 0 1\n"), ("msh", "walls 0 1\n"), ("inp", "walls 0 1\n")):
            self.mesh("--quiet", "--walls", "y", "--mesh", "grains", *outputs(extension))
            text = self.path(f"t.{extension}").read_text()
            self.assertEqual(text.count(note), 1)
            for other in ("walls 1 0\n", "walls 1 1\n", "walls 0 0\n", "walls 2 0\n", "walls\n"):
                self.write(f"u.{extension}", text.replace(note, other))
                done = self.run_pcvt("check", f"u.{extension}")
                fault = (done.stdout + done.stderr).decode()
                self.assertIn(done.returncode, (1, 2), fault)
                self.assertEqual(fault.count("\n"), 1, fault)

    def test_names_of_walls_in_solver_files(self):
        self.mesh("--quiet", "--walls", "y", "--wall-cells", "half", "--mesh", "delaunay", *outputs("msh", "inp"))
        groups = re.findall(r'^1 \d+ "(.*)"$', self.path("t.msh").read_text(), re.M)
        self.assertEqual(groups, ["seam_-1_0", "seam_1_0", "wall_bottom", "wall_top", "grain_boundary"])
        cards = re.findall(r"^\*(?:NSET,NSET|SURFACE,NAME)=((?:WALL|seam)_[^,\n]*)", self.path("t.inp").read_text(),
                           re.M)
        self.assertEqual(cards, ["seam_-1_0", "seam_1_0", "WALL_BOTTOM", "WALL_TOP", "WALL_BOTTOM_SIDES",
                                 "WALL_TOP_SIDES"])
        self.mesh("--quiet", "--walls", "xy", "--mesh", "grains", *outputs("msh", "inp"))
        self.assertNotIn("$Periodic", self.path("t.msh").read_text())
        self.assertNotIn("*EQUATION", self.path("t.inp").read_text())

    def test_the_legend_names_the_walls(self):
        for walls, names in (("x", "left, right"), ("y", "bottom, top"), ("xy", "left, right, bottom, top")):
            self.mesh("--quiet", "--walls", walls, "--wall-cells", "half", "-o", "t.svg")
            text = self.path("t.svg").read_text()
            self.assertIn(f">walls: {names}<", text)
            self.assertIn(">Voronoi tile between walls, 40 cells<", text)

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        for threads in (1, 2, 4):
            self.succeed("mesh", "--sites", 600, "--period", "2,1", "--walls", "y", "--wall-cells", "half", "--threads",
                         threads, "--tolerance", "1e-3", "--mesh", "grains", *outputs("msh", "vtu", name=threads))
        files = self.contents()
        for extension in ("msh", "vtu"):
            self.assertEqual(len({files[f"{threads}.{extension}"] for threads in (1, 2, 4)}), 1)

    def test_what_does_not_fit_is_refused_in_one_line(self):
        self.write("s.txt", "0.1 0.2\n0.7 1.5\n")
        channel = ("--sites", 8, "--walls", "y")
        half = (*channel, "--wall-cells", "half")
        for arguments, words in (
                (("--sites", 8, "--walls", "z"), "--walls"),
                (("--sites", 8, "--wall-cells", "half"), "--wall-cells half needs walls; add --walls"),
                (("--sites", 8, "--walls", "y", "--wall-cells", "third"), "--wall-cells"),
                ((*channel, "--lattice", "1,0,0.5,1"), "give the two sides as its period"),
                ((*channel, "--symmetry", "p2"), "--walls does not work with --symmetry"),
                ((*channel, "--aspect", "2"), "--aspect does not work with --walls"),
                ((*channel, "--start", "best"), "--start lattice and best do not work with --walls"),
                ((*channel, "--stability"), "--stability does not work with --walls"),
                ((*channel, "--repeat", "1x2"), "repeat it along them"),
                ((*channel, "--origin", "0,0.2"), "give an origin along the walls, or none"),
                ((*channel, "--outline", "box", "--origin", "auto"), "give an origin along the walls, or none"),
                ((*half, "--max-iterations", 0), "leave --max-iterations 0 out, or take --wall-cells whole"),
                ((*channel, "--mesh", "delaunay"), "add --wall-cells half, or take --mesh grains"),
                (("--input", "s.txt", "--walls", "y"), "wall")):
            self.refuse(2, words, "mesh", *arguments, "-o", "t.vtu")
        for output, options, words in (
                ("t.nc", (), "MPAS meshes are periodic along both directions; leave the walls out"),
                ("t.vti", (), "voxels are periodic along both directions; leave the walls out"),
                ("t.inp", ("--mesh", "grains", "--job", "elastic"), "leave the job or the walls out")):
            self.refuse(2, words, "mesh", *channel, *options, "-o", output)
        self.assertEqual(list(self.contents()), ["s.txt"])


if __name__ == "__main__":
    main()
