"""Inclusions and fixed sites on the command line: files, tables, reports, refusals, threads."""

import csv
import json
import math
import re
from random import Random

from support.cli import CliTest, main, outputs

SHAPES = ("# head\n"
          "circle glass 0.95 0.9 0.15\n"
          "ellipse steel 0.7 0.4 0.2 0.1 30\n"
          "polygon glass 0.2 0.3 0.4 0.3 0.3 0.6\n")
AREAS = {"glass": math.pi * 0.15**2 + 0.03, "steel": math.pi * 0.02}
TILES = ("obj", "ply", "glb", "gltf", "om", "vtu", "foam")
SOLVERS = ("msh", "inp", "vtu", "foam", "obj")


class Inclusions(CliTest):
    def mesh(self, *arguments, sites=600):
        self.path("shapes.txt").write_text(SHAPES)
        return self.succeed("mesh", "--sites", sites, "--tolerance", "1e-3", "--inclusions", "shapes.txt", "--force",
                            *arguments)

    def refuse_shapes(self, code, pattern, shapes, *arguments, sites=600):
        self.path("shapes.txt").write_text(shapes)
        self.refuse(code, pattern, "mesh", "--sites", sites, "--inclusions", "shapes.txt", "-o", "new.obj", *arguments)

    def test_check_proves_every_format_of_every_mesh(self):
        for mesh, extensions, options in (("voronoi", TILES, ()), ("voronoi", TILES[:-1], ("--outline", "box")),
                                          ("grains", SOLVERS, ()), ("grains", SOLVERS, ("--outline", "box")),
                                          ("delaunay", ("obj", "glb"), ())):
            self.mesh("--quiet", "--mesh", mesh, *options, *outputs(*extensions, "svg", "png", "html", "csv", "txt"))
            text = self.succeed("check", *(f"t.{extension}" for extension in extensions))
            self.assertEqual(text.count("600 sites agree"), len(extensions))

    def test_the_table_of_cells_has_tags_with_the_areas_of_their_shapes(self):
        self.mesh("--cells", "t.csv")
        lines = [line for line in self.path("t.csv").read_text().splitlines() if not line.startswith("#")]
        rows = list(csv.DictReader(lines))
        self.assertEqual({row["tag"] for row in rows}, {"matrix", "glass", "steel"})
        for tag, area in AREAS.items():
            self.assertAlmostEqual(math.fsum(float(row["area"]) for row in rows if row["tag"] == tag), area,
                                   delta=1e-12)
        self.assertTrue(all(row["phase"] == row["tag"] for row in rows))

    def test_report_and_summary_state_the_inclusions(self):
        text = self.mesh("--report", "r.json")
        report = json.loads(self.path("r.json").read_text())
        stated = report["inclusions"]
        self.assertEqual((stated["source"], stated["shapes"]), ("shapes.txt", 3))
        self.assertRegex(text, rf"(?m)^inclusions 3 shapes, {stated['chords']} chords, {stated['fixed_sites']} sites in ")
        for phase in report["phases"]:
            self.assertAlmostEqual(phase["reached"], phase["wanted"], delta=1e-12)

    def test_solver_files_name_the_tags(self):
        self.mesh("--quiet", "--mesh", "grains", "--job", "elastic", "--material", "same", *outputs("msh", "inp", "foam", "obj"))
        for name, words in (("t.msh", '"phase_glass"'), ("t.inp", "*ELSET,ELSET=PHASE_glass"),
                            ("t.inp", "*MATERIAL,NAME=steel"), ("t.foam/constant/polyMesh/cellZones", "phase_steel"),
                            ("t.obj", "usemtl phase_matrix")):
            self.assertIn(words, self.path(name).read_text(), name)

    def test_threads_do_not_change_a_byte(self):
        for options in ((), ("--density", "1 + u")):
            self.mesh("--quiet", *options, "--threads", 1, *outputs("obj", "txt"))
            one = self.contents()
            for threads in (2, 4):
                self.mesh("--quiet", *options, "--threads", threads, *outputs("obj", "txt"))
                self.assertEqual(self.contents(), one)

    def test_fibres_have_their_number_and_their_area(self):
        for seed in (1, 2):
            self.succeed("mesh", "--sites", 1500, "--fibres", "0.4,12", "--seed", seed, "--lattice", "1,0,0.3,0.9",
                         "--tolerance", "1e-2", "--report", "r.json", "-o", f"f{seed}.obj", "--force")
            report = json.loads(self.path("r.json").read_text())
            self.assertEqual((report["inclusions"]["source"], report["inclusions"]["shapes"]), ("fibres", 12))
            self.assertAlmostEqual(report["phases"][1]["reached"], 0.4, delta=1e-12)
        self.succeed("check", "f1.obj", "f2.obj")
        self.assertNotEqual(self.path("f1.obj").read_text(), self.path("f2.obj").read_text())

    def test_a_coating_is_a_phase_of_its_own(self):
        self.write("coated.txt", "circle core 0.05 0.9 0.2\ncircle coating 0.05 0.9 0.25\npolygon bit 0 .85 .1 .85 .05 .95\n")
        for outline in ("whole", "box"):
            summary = self.succeed("mesh", "--sites", 1500, "--inclusions", "coated.txt", "--tolerance", "1e-2", "--mesh", "grains",
                                   "--outline", outline, "--report", "r.json", "-o", "c.vtu", "-o", "c.obj", "--force")
            self.assertIn("3 shapes, 2 inside of others", summary)
            report = json.loads(self.path("r.json").read_text())
            self.assertEqual(report["inclusions"]["nested"], 2)
            reached = {phase["name"]: phase["reached"] for phase in report["phases"]}
            self.assertAlmostEqual(reached["coating"], 0.0225 * math.pi, delta=1e-12)
            self.assertAlmostEqual(reached["core"], 0.04 * math.pi - 0.005, delta=1e-12)
            self.assertIn("3 inclusions of coated.txt", self.succeed("check", "--inclusions", "coated.txt", "c.vtu", "c.obj"))
        # The outline of the coating is that of another file.
        self.write("other.txt", "circle core 0.05 0.9 0.2\ncircle coating 0.05 0.9 0.26\npolygon bit 0 .85 .1 .85 .05 .95\n")
        self.assertNotEqual(self.run_pcvt("check", "--inclusions", "other.txt", "c.vtu").returncode, 0)

    def test_holes_hold_no_shapes(self):
        shapes = "circle core 0.5 0.5 0.2\ncircle coating 0.5 0.5 0.25\n"
        self.refuse_shapes(2, r"shapes\.txt:1: the shape lies in the hole coating of line 2; leave the shape or the hole out", shapes,
                           "--hole", "coating")
        self.write("coated.txt", shapes)
        self.succeed("mesh", "--sites", 900, "--inclusions", "coated.txt", "--hole", "core", "--tolerance", "1e-2", "-o", "h.vtu")
        self.assertIn("2 inclusions of coated.txt, 1 of them holes", self.succeed("check", "--inclusions", "coated.txt", "h.vtu"))

    def test_bad_fibres_are_refused(self):
        for text, words in (("0.5", r"write FRACTION,N"), ("0.5,x", "not a"), ("1.5,3", "fraction must be between"),
                            ("0.5,0", "number of circles"), ("0.8,30,0.1", "no place was found"),
                            ("0.3,3,-1", "must be positive")):
            self.refuse(2, words, "mesh", "--sites", 900, "--fibres", text)
        self.path("shapes.txt").write_text(SHAPES)
        self.refuse(2, "--fibres does not work with --inclusions", "mesh", "--sites", 900, "--fibres", "0.3,3", "--inclusions", "shapes.txt")

    def test_bad_shapes_are_refused_with_file_and_line(self):
        for pattern, shapes in ((r"shapes\.txt:2: 'square' is not a shape", "# a\nsquare a 1 2 3\n"),
                                (r"shapes\.txt:2: the shape overlaps that of line 1", "circle a 0 0 .2\ncircle b .9 .9 .1\n"),
                                (r"shapes\.txt:1: the shape is larger", "circle a 0 0 0.6\n"),
                                (r"shapes\.txt:1: ", "circle a 0 0 -0.1\n"),
                                (r"shapes\.txt:1: ", "polygon a 0 0 .2 .2 .2 0 0 .2\n")):
            self.refuse_shapes(2, pattern, shapes)
        self.refuse_shapes(2, r"too few for the inclusions; take \d+$", SHAPES, sites=30)
        self.refuse(2, "nothing.txt: cannot read", "mesh", "--sites", 99, "--inclusions", "nothing.txt")

    def test_choices_that_inclusions_exclude_are_refused(self):
        for options, words in ((("--areas", "equal"), "areas"), (("--aspect", 2), "aspect"),
                               (("--symmetry", "p2"), "symmetry"), (("--start", "coarse"), "start"),
                               (("--phases", "a:1"), "tags"), (("--stability",), "stability"),
                               (("--fixed", "fixed.txt"), "fixed sites of their own")):
            self.path("fixed.txt").write_text("0.1 0.1\n")
            self.refuse_shapes(2, words, SHAPES, *options)
        self.refuse_shapes(2, "Delaunay", SHAPES, "--mesh", "delaunay", "-o", "t.msh")


CORNERS = "".join(f"circle fibre {x} {y} 0.2\n" for x, y in ((0, 0), (1, 0), (0, 1), (1, 1), (0.5, 0.5)))


class ListedImages(CliTest):
    """Shapes that a file lists together with their images."""

    def mesh(self, shapes, *arguments, lattice="1,0,0,1"):
        self.path("shapes.txt").write_text(shapes)
        return self.succeed("mesh", "--lattice", lattice, "--sites", 300, "--tolerance", "1e-2", "--inclusions", "shapes.txt",
                            "--force", *arguments, *outputs("obj", "txt", "vtu"))

    def files(self):
        return [self.path(f"t.{extension}").read_bytes() for extension in ("obj", "txt", "vtu")]

    def image(self, line, lattice, random):
        """A random image of a shape, whose ellipse or polygon is written in another way."""
        word, tag, *numbers = line.split()
        numbers = [float(number) for number in numbers]
        i, j = random.randint(-2, 2), random.randint(-2, 2)
        pairs = len(numbers) if word == "polygon" else 2
        for k in range(pairs):
            numbers[k] += i * lattice[k % 2] + j * lattice[2 + k % 2]
        if word == "ellipse":
            numbers[4] += random.choice((-180, 0, 180))
        if word == "polygon":
            first = 2 * random.randrange(pairs // 2)
            numbers = numbers[first:] + numbers[:first]
        return " ".join([word, tag, *map(repr, numbers)])

    def test_they_do_not_change_a_byte(self):
        random = Random(1)
        for lattice in ("1,0,0,1", "1,0,0.37,1.21", "1.3,0.2,0.1,0.9"):
            periods = [float(number) for number in lattice.split(",")]
            lines = [line for line in SHAPES.splitlines() if not line.startswith("#")]
            self.mesh("\n".join(lines), lattice=lattice)
            once = self.files()
            images = [self.image(line, periods, random) for line in lines for _ in range(random.randint(0, 8))]
            random.shuffle(images)
            text = self.mesh("\n".join(lines + images), "--report", "r.json", lattice=lattice)
            self.assertTrue(self.files() == once, lattice)
            self.assertIn(f"inclusions 3 shapes ({len(images)} listed images left out), ", text)
            stated = json.loads(self.path("r.json").read_text())["inclusions"]
            self.assertEqual((stated["shapes"], stated["images_left_out"]), (3, len(images)))
            text = self.succeed("check", "t.obj", "--inclusions", "shapes.txt")
            self.assertIn(f"3 inclusions of shapes.txt ({len(images)} listed images left out) with ", text)

    def test_a_circle_at_each_corner_is_one(self):
        self.assertIn("inclusions 2 shapes (3 listed images left out), ", self.mesh(CORNERS))
        self.succeed("mesh", "--sites", 300, "--tolerance", "1e-2", "--inclusions", "shapes.txt", "--repeat", "2x3", "-o", "many.obj")
        self.assertIn("2 inclusions of shapes.txt (3 listed images left out) with ",
                      self.succeed("check", "many.obj", "--inclusions", "shapes.txt"))

    def test_without_them_nothing_is_said(self):
        text = self.mesh(SHAPES, "--report", "r.json")
        self.assertNotIn("image", text + self.path("r.json").read_text())
        self.assertNotIn("image", self.succeed("check", "t.obj", "--inclusions", "shapes.txt"))

    def test_along_walls_only(self):
        shapes = "circle a 0 0.5 0.2\ncircle a 1 0.5 0.2\n"
        self.assertIn("1 shape (1 listed image left out), ", self.mesh(shapes, "--walls", "y"))
        self.succeed("check", "t.obj", "--inclusions", "shapes.txt")
        for y in (1.5, 2.5):
            self.path("shapes.txt").write_text(f"circle a 0.5 0.5 0.2\ncircle a 0.5 {y} 0.2\n")
            self.refuse(2, r"shapes\.txt:2: the shape touches or crosses wall_top", "mesh", "--sites", 300, "--walls", "y",
                        "--inclusions", "shapes.txt", "-o", "new.obj")

    def test_with_another_tag_or_size_they_are_refused(self):
        for line, words in (("circle other 1 1 0.2", "the shape is an image of that of line 1 with another tag; give both"),
                            ("circle fibre 1 0 0.1", "the shape lies on an image of that of line 1 but differs")):
            self.path("shapes.txt").write_text(f"circle fibre 0 0 0.2\n{line}\n")
            self.refuse(2, r"shapes\.txt:2: " + words, "mesh", "--sites", 300, "--inclusions", "shapes.txt", "-o", "new.obj")


INSIDE = ("circle glass 0.95 0.75 0.15\n"
          "ellipse steel 0.7 0.4 0.2 0.1 30\n"
          "polygon glass 0.2 0.3 0.4 0.3 0.3 0.6\n")


class Walls(CliTest):
    """Inclusions in channels and boxes."""

    def mesh(self, walls, *arguments, shapes=INSIDE):
        self.path("shapes.txt").write_text(shapes)
        return self.succeed("mesh", "--period", "1.3,1", "--sites", 700, "--tolerance", "1e-3", "--inclusions",
                            "shapes.txt", "--walls", walls, "--force", "--quiet", *arguments)

    def test_every_format_of_every_mesh_is_proved_with_its_inclusions(self):
        for walls, glued in (("x", "an annulus"), ("y", "an annulus"), ("xy", "a disc")):
            for mesh, extensions, options in (("voronoi", TILES, ()), ("voronoi", TILES[:-1], ("--outline", "box")),
                                              ("grains", SOLVERS, ()), ("grains", SOLVERS, ("--outline", "box")),
                                              ("voronoi", ("obj", "vtu"), ("--short-edges", 0.2)),
                                              ("voronoi", ("obj", "vtu"), ("--wall-cells", "half")),
                                              ("grains", ("obj", "msh"), ("--wall-cells", "half"))):
                self.mesh(walls, "--mesh", mesh, *options, *outputs(*extensions))
                text = self.succeed("check", *(f"t.{extension}" for extension in extensions),
                                    "--inclusions", "shapes.txt")
                self.assertEqual(text.count("3 inclusions of shapes.txt with "), len(extensions), text)
                self.assertEqual(text.count(glued), len(extensions), text)

    def test_delaunay_triangles_need_half_cells(self):
        self.mesh("xy", "--mesh", "delaunay", "--wall-cells", "half", *outputs("obj", "glb"))
        self.succeed("check", "t.obj", "t.glb")

    def test_fibres_lie_between_walls(self):
        for walls in ("x", "y", "xy"):
            self.succeed("mesh", "--sites", 1500, "--fibres", "0.4,12,0.02", "--walls", walls, "--tolerance", "1e-2",
                         "--report", "r.json", *outputs("obj"), "--force")
            report = json.loads(self.path("r.json").read_text())
            self.assertAlmostEqual(report["phases"][1]["reached"], 0.4, delta=1e-12)
            fibres = report["inclusions"]["fibres"]
            for axis, word in enumerate("xy"):
                for fibre in fibres if word in walls else ():
                    self.assertGreaterEqual(min(fibre[axis], 1 - fibre[axis]), fibre[2] + 0.02 - 1e-9)
            self.path("fibres.txt").write_text("".join(f"circle fibre {x!r} {y!r} {r!r}\n" for x, y, r in fibres))
            self.assertIn("12 inclusions", self.succeed("check", "t.obj", "--inclusions", "fibres.txt"))

    def test_shapes_at_walls_are_refused_with_file_and_line(self):
        self.path("shapes.txt").write_text(SHAPES)
        for walls, wall in (("x", "wall_right"), ("y", "wall_top"), ("xy", "wall_right")):
            self.refuse(2, rf"shapes\.txt:2: the shape touches or crosses {wall}; move it", "mesh", "--sites", 600,
                        "--inclusions", "shapes.txt", "--walls", walls)
        near = "circle a 0.5 0.21 0.2\n"
        self.path("shapes.txt").write_text(near)
        self.refuse(2, "too near to a wall for half cells", "mesh", "--sites", 400, "--inclusions", "shapes.txt",
                    "--walls", "y", "--wall-cells", "half")

    def test_threads_do_not_change_a_byte(self):
        self.mesh("xy", "--density", "1 + u", "--threads", 1, *outputs("obj", "txt"))
        one = self.contents()
        self.mesh("xy", "--density", "1 + u", "--threads", 3, *outputs("obj", "txt"))
        self.assertEqual(self.contents(), one)


class Check(CliTest):
    """pcvt check FILE --inclusions SHAPES."""

    def mesh(self, *arguments):
        self.path("shapes.txt").write_text(SHAPES)
        self.succeed("mesh", "--sites", 600, "--tolerance", "1e-3", "--inclusions", "shapes.txt", "--force", "--quiet",
                     *arguments)

    def refute(self, pattern, file="t.obj", shapes="shapes.txt"):
        self.refuse(2, pattern, "check", file, "--inclusions", shapes)

    def test_every_format_is_proved(self):
        for mesh, extensions, options in (("voronoi", TILES, ()), ("voronoi", TILES[:-1], ("--outline", "box")),
                                          ("voronoi", ("obj", "ply", "vtu"), ("--repeat", "2x3")),
                                          ("voronoi", ("obj",), ("--short-edges", 0.3)),
                                          ("grains", SOLVERS, ("--outline", "box", "--repeat", "2x1")),
                                          ("grains", ("obj", "vtu", "msh", "inp"), ("--order", 2))):
            self.mesh("--mesh", mesh, *options, *outputs(*extensions))
            text = self.succeed("check", *(f"t.{extension}" for extension in extensions), "--inclusions", "shapes.txt")
            self.assertEqual(text.count("3 inclusions of shapes.txt with "), len(extensions), text)

    def test_tags_are_proved_where_a_file_holds_them(self):
        exchanged = SHAPES.replace("glass", "other").replace("steel", "glass").replace("other", "steel")
        for mesh, options, silent in (("voronoi", (), ("ply", "om", "glb", "gltf")),
                                      ("voronoi", ("--glb-nodes", "one"), ("ply", "om")),
                                      ("voronoi", ("--colour", "sides"), ("obj", "ply", "om", "glb", "gltf")),
                                      ("voronoi", ("--glb-nodes", "one", "--repeat", "2x1"), ("ply", "om")),
                                      ("grains", (), ("ply", "om"))):
            self.mesh("--mesh", mesh, *options, *outputs(*TILES))
            self.path("exchanged.txt").write_text(exchanged)
            for extension in TILES:
                line = self.succeed("check", f"t.{extension}", "--inclusions", "shapes.txt")
                self.assertIn("no tags stored" if extension in silent else "tags agree", line, (mesh, options))
                if extension not in silent:
                    self.refute("has the tag glass, but its site lies in steel|has the tag steel, but its site lies in "
                                "glass", f"t.{extension}", "exchanged.txt")

    def test_holes_are_proved_by_their_edges(self):
        for mesh, extensions, options in (("voronoi", TILES, ()), ("voronoi", TILES[:-1], ("--outline", "box")),
                                          ("voronoi", ("obj", "vtu"), ("--repeat", "2x2")),
                                          ("grains", SOLVERS, ("--outline", "box")), ("grains", SOLVERS, ("--order", 2))):
            for holes, words in ((["steel"], "1 of them holes"), (["glass"], "2 of them holes"),
                                 (["glass", "steel"], "3 of them holes")):
                left_out = [word for tag in holes for word in ("--hole", tag)]
                self.mesh("--mesh", mesh, *left_out, *options, *outputs(*extensions))
                text = self.succeed("check", *(f"t.{e}" for e in extensions), "--inclusions", "shapes.txt")
                self.assertEqual(text.count(f"3 inclusions of shapes.txt, {words}, with "), len(extensions), text)
        lines = SHAPES.splitlines()[1:]
        self.mesh("--hole", "steel", *outputs("obj", "vtu"))
        for other, words in ((lines[1].replace("0.2 0.1", "0.2 0.1000001"), r"other\.txt:2: the hole has the area"),
                             (lines[1].replace("0.7 0.4", "0.7 0.4000001"), r"other\.txt:2: "),
                             (lines[1].replace("steel", "iron"), "tag steel are left out, which no shape of"),
                             (lines[1].replace("steel", "glass"), "tag steel are left out, which no shape of")):
            self.path("other.txt").write_text("\n".join([lines[0], other, lines[2]]))
            for name in ("t.obj", "t.vtu"):
                self.refute(words, name, "other.txt")
        self.path("fewer.txt").write_text("\n".join([lines[0].replace("glass", "steel"), *lines[1:]]))
        self.refute("lies inside, but the cells with the tag steel are left out", shapes="fewer.txt")

    def test_other_shapes_are_refuted(self):
        self.mesh(*outputs("obj", "vtu"))
        lines = SHAPES.splitlines()[1:]
        for other, words in ((lines[0].replace("0.15", "0.1500001"), r"other\.txt:1: the cells inside have the area"),
                             (lines[0].replace("glass", "steel"), "has the tag glass, but its site lies in steel"),
                             (lines[0].replace("0.95", "0.9500001"), r"other\.txt:1: "),
                             (lines[1].replace("30", "30.00001"), r"other\.txt:1: "),
                             (lines[1].replace("0.2 0.1", "0.1 0.2").replace("30", "120.1"), r"other\.txt:1: "),
                             (lines[2].replace("0.3 0.6", "0.31 0.6"), r"(other\.txt:1: |its site lies in matrix)")):
            rest = [line for line in lines if line.split()[0] != other.split()[0]]
            self.path("other.txt").write_text("\n".join([other, *rest]))
            # Only files for solvers state the tags.
            for file in ("t.vtu",) if "tag" in words else ("t.obj", "t.vtu"):
                self.refute("law of the inclusions: .*" + words, file, "other.txt")
        self.path("other.txt").write_text("\n".join(lines[:2]))
        self.refute("but its site lies in matrix", "t.vtu", "other.txt")

    def test_a_cell_across_an_outline_is_refuted(self):
        # The same sites without the shapes: a Voronoi diagram without them.
        self.mesh(*outputs("txt"))
        self.succeed("mesh", "--input", "t.txt", "--max-iterations", 0, "-o", "same.ply")
        self.succeed("check", "same.ply", "--inclusions", "shapes.txt")
        self.succeed("mesh", "--sites", 600, "--tolerance", "1e-3", "-o", "other.ply")
        self.refute(r"law of the inclusions: shapes\.txt:\d: the cells inside have the area", "other.ply")

    def test_what_cannot_be_checked_is_refused(self):
        self.mesh("--mesh", "delaunay", *outputs("obj"))
        self.refute("Delaunay triangles cross the outlines")
        self.path("bad.txt").write_text("circle a 0 0 0.7\n")
        self.mesh(*outputs("obj"))
        self.refute(r"bad\.txt:1: the shape is larger", "t.obj", "bad.txt")
        self.succeed("mesh", "--sites", 64, "--tolerance", "1e-2", "-o", "t.vti")
        self.refute("--inclusions is not for voxels", "t.vti")


class Boxes(CliTest):
    """Sides of a box that run through the centres of shapes."""

    def test_grains_have_good_angles(self):
        lattice = "1.5330612955270297,0,0,0.6522896396365052"
        shapes = ("circle t 0 0.523 0.081\ncircle t 0 0.361 0.0386\ncircle t 0.302 0 0.0612\ncircle t 0.924 0 0.0856\n"
                  "ellipse t 0.6922 0 0.0628 0.0378 331.98\npolygon t -0.03 0.1 0.05 0.11 0.02 0.2\n"
                  "circle t 1.26 0.09 0.0529\ncircle t 0.44 0.3 0.1\n")
        self.path("shapes.txt").write_text(shapes)
        for seed in range(3):
            text = self.succeed("mesh", "--lattice", lattice, "--sites", 1586, "--seed", seed, "--mesh", "grains",
                                "--tolerance", "1e-2", "--outline", "box", "--inclusions", "shapes.txt", "-o", "t.msh",
                                "--force", timeout=60)
            self.assertLess(int(re.search(r"(\d+) triangles", text)[1]), 60000)
            self.assertIn("8 inclusions", self.succeed("check", "t.msh", "--inclusions", "shapes.txt"))

    def test_a_piece_that_is_too_thin_is_refused_at_once(self):
        # A side of the polygon lies 1e-8 beside the box.
        self.path("shapes.txt").write_text("polygon t 0.00000001 0.2 0.3 0.2 0.3 0.6 0.00000001 0.6\n")
        self.refuse(4, "too thin to be meshed by grains; give another origin, or use the whole outline", "mesh",
                    "--sites", 900, "--mesh", "grains", "--outline", "box", "--inclusions", "shapes.txt", "-o", "t.msh",
                    "--tolerance", "1e-2", timeout=60)


class FixedSites(CliTest):
    def sites(self, *arguments):
        self.path("fixed.txt").write_text("0.125 0.25 # stays\n\n0.5 0.75\n-0.25 1.5\n")
        self.succeed("mesh", "--sites", 200, "--fixed", "fixed.txt", "-o", "s.txt", "-o", "s.obj", "--force", *arguments)
        self.succeed("check", "s.obj")
        lines = self.path("s.txt").read_text().splitlines()
        return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]

    def test_they_come_first_and_stay(self):
        for options in ((), ("--solver", "lloyd", "--tolerance", "1e-2"), ("--density", "1 + u"),
                        ("--max-iterations", 0), ("--threads", 3)):
            self.assertEqual(self.sites(*options)[:3], [(0.125, 0.25), (0.5, 0.75), (0.75, 0.5)], options)

    def test_too_many_and_wrong_choices_are_refused(self):
        self.path("fixed.txt").write_text("0.1 0.1\n0.2 0.2\n")
        self.refuse(2, "more fixed sites .2. than sites .1.; take more sites", "mesh", "--sites", 1, "--fixed", "fixed.txt")
        self.refuse(2, "give a number of sites", "mesh", "--input", "fixed.txt", "--fixed", "fixed.txt")
        self.refuse(2, "site 0 and site 1|sites 0 and 1|coincide", "mesh", "--sites", 5, "--fixed", self.doubled())

    def doubled(self):
        self.path("twice.txt").write_text("0.1 0.1\n0.1 0.1\n")
        return "twice.txt"


if __name__ == "__main__":
    main()
