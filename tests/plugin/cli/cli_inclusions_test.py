"""Inclusions and fixed sites on the command line: files, tables, reports, refusals, threads."""

import csv
import json
import math

from support.cli import CliTest, main

SHAPES = ("# head\n"
          "circle glass 0.95 0.9 0.15\n"
          "ellipse steel 0.7 0.4 0.2 0.1 30\n"
          "polygon glass 0.2 0.3 0.4 0.3 0.3 0.6\n")
AREAS = {"glass": math.pi * 0.15**2 + 0.03, "steel": math.pi * 0.02}
TILES = ("obj", "ply", "glb", "gltf", "om", "vtu", "foam")
SOLVERS = ("msh", "inp", "vtu", "foam", "obj")


def outputs(*extensions):
    return [word for extension in extensions for word in ("-o", f"t.{extension}")]


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
        self.mesh("--quiet", "--mesh", "grains", "--job", "elastic", *outputs("msh", "inp", "foam", "obj"))
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

    def test_bad_fibres_are_refused(self):
        for text, words in (("0.5", r"write FRACTION,N"), ("0.5,x", "not a"), ("1.5,3", "fraction must be between"),
                            ("0.5,0", "number of circles"), ("0.8,30,0.1", "no place was found"),
                            ("0.3,3,-1", "must be positive")):
            self.refuse(2, words, "mesh", "--sites", 900, "--fibres", text)
        self.path("shapes.txt").write_text(SHAPES)
        self.refuse(2, "leave one of the two", "mesh", "--sites", 900, "--fibres", "0.3,3", "--inclusions", "shapes.txt")

    def test_bad_shapes_are_refused_with_file_and_line(self):
        for pattern, shapes in ((r"shapes\.txt:2: 'square' is no shape", "# a\nsquare a 1 2 3\n"),
                                (r"shapes\.txt: line 1 and line 2 overlap", "circle a 0 0 .2\ncircle b .9 .9 .1\n"),
                                (r"shapes\.txt: line 1: the shape is larger", "circle a 0 0 0.6\n"),
                                (r"shapes\.txt: line 1: ", "circle a 0 0 -0.1\n"),
                                (r"shapes\.txt: line 1: ", "polygon a 0 0 .2 .2 .2 0 0 .2\n")):
            self.refuse_shapes(2, pattern, shapes)
        self.refuse_shapes(2, r"too few for the inclusions; take \d+$", SHAPES, sites=30)
        self.refuse(2, "nothing.txt: cannot read", "mesh", "--sites", 99, "--inclusions", "nothing.txt")

    def test_choices_that_inclusions_exclude_are_refused(self):
        for options, words in ((("--walls", "y"), "walls"), (("--areas", "equal"), "areas"), (("--aspect", 2), "aspect"),
                               (("--symmetry", "p2"), "symmetry"), (("--start", "coarse"), "start"),
                               (("--phases", "a:1"), "tags"), (("--stability",), "stability"),
                               (("--fixed", "fixed.txt"), "fixed sites of their own")):
            self.path("fixed.txt").write_text("0.1 0.1\n")
            self.refuse_shapes(2, words, SHAPES, *options)
        self.refuse_shapes(2, "Delaunay", SHAPES, "--mesh", "delaunay", "-o", "t.msh")


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
        self.refuse(2, "2 fixed sites, more than all", "mesh", "--sites", 1, "--fixed", "fixed.txt")
        self.refuse(2, "give a number of sites", "mesh", "--input", "fixed.txt", "--fixed", "fixed.txt")
        self.refuse(2, "site 0 and site 1|sites 0 and 1|coincide", "mesh", "--sites", 5, "--fixed", self.doubled())

    def doubled(self):
        self.path("twice.txt").write_text("0.1 0.1\n0.1 0.1\n")
        return "twice.txt"


if __name__ == "__main__":
    main()
