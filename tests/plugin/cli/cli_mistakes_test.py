"""Fifty typical mistakes: each gives one line with the remedy, and nothing is written."""

import re
import shlex

from support.cli import CliTest, main

# The command line, words that the line must contain, and the exit code.
MISTAKES = [
    # Misspelled words.
    ("mehs --sites 30 -o t.obj", ["unknown command mehs", "did you mean mesh?"], 2),
    ("studdy table1", ["unknown command studdy", "did you mean study?"], 2),
    ("frobnicate", ["unknown command frobnicate", "pcvt --help"], 2),
    ("help densty", ["densty", "did you mean density?"], 2),
    ("help cooking", ["cooking", "take a command, density or formats"], 2),
    ("mesh --sites 30 --tolerence 1e-8", ["option --tolerence", "did you mean --tolerance?"], 2),
    ("mesh --site 30", ["unknown option --site", "did you mean --sites?"], 2),
    ("mesh --sites 30 --tol 1e-8", ["unknown option --tol", "did you mean --tolerance?"], 2),
    ("mesh -sites 30", ["unknown option -sites", "did you mean --sites?"], 2),
    ("mesh --sites 30 --max_iterations 5", ["did you mean --max-iterations?"], 2),
    ("mesh --sites 30 --outlin=box", ["unknown option --outlin", "did you mean --outline?"], 2),
    ("mesh --sites 30 --frobnicate", ["unknown option --frobnicate", "pcvt mesh --help"], 2),
    ("--sites 30", ["--sites", "write pcvt mesh --sites"], 2),
    ("check --cvtt t.obj", ["unknown option --cvtt", "did you mean --cvt?"], 2),
    ("mesh --sites 30 --solver lbgfs", ["--solver lbgfs", "did you mean lbfgs?"], 2),
    ("mesh --sites 30 --solver magic", ["--solver magic", "lbfgs, lloyd or newton"], 2),
    ("mesh --sites 30 --mesh voronio", ["--mesh voronio", "did you mean voronoi?"], 2),
    ("mesh --sites 30 --mesh triangles", ["--mesh triangles", "voronoi, delaunay or grains"], 2),
    ("mesh --sites 30 --outline whol", ["--outline whol", "did you mean whole?"], 2),
    ("mesh --sites 30 --start rnadom", ["--start rnadom", "did you mean random?"], 2),
    ("study tabel1", ["tabel1", "did you mean table1?"], 2),
    ("study fig12", ["fig12", "table1 fig7"], 2),
    ("mesh --sites 30 -o t.ojb", ["unknown extension .ojb", "did you mean .obj?"], 2),
    ("mesh --sites 30 -o t.xyz", ["unknown extension .xyz", ".obj", ".vtu"], 2),
    # Values.
    ("mesh --sites 30 -o a.obj b.obj", ["b.obj", "give each file its own -o"], 2),
    ("mesh --sites 30 --mesh voronoi delaunay", ["give each kind its own --mesh"], 2),
    ("mesh --sites 30 --period 2 1", ["--period", "without blanks, as W,H"], 2),
    ("mesh --sites 30 --lattice 1 0 0 1", ["--lattice", "without blanks, as AX,AY,BX,BY"], 2),
    ("mesh --sites 30 --density 1 + u", ["put the formula of --density in quotes"], 2),
    ("mesh --sites 30 --density photo.jpg", ["only PNG", "convert photo.jpg photo.png"], 2),
    ("mesh --sites 30 --density 1+x**2", ["--density '1+x**2'", "write ^ for a power"], 2),
    ("mesh --sites 30 --density 1+z", ["character 3", "x, y, u and v"], 2),
    ("mesh --sites 30 --density none.png", ["none.png"], 2),
    ("mesh --sites 30 --density -1", ["density", "positive"], 2),
    ("mesh --sites 1e3", ["--sites 1e3", "whole number"], 2),
    ("mesh --sites 0", ["--sites 0", "too small"], 2),
    ("mesh --sites", ["--sites", "pcvt mesh --help"], 2),
    ("mesh --sites 30 --tolerance 1e-6x", ["--tolerance 1e-6x"], 2),
    ("mesh --sites 30 --period 2", ["--period 2", "two numbers W,H, or three in space", "1 was given"], 2),
    ("mesh --sites 30 --period 1,1,1,1", ["--period 1,1,1,1", "or three in space W,H,D", "4 were given"], 2),
    ("mesh --sites 30 --lattice 1,0,0", ["--lattice 1,0,0", "four", "or the nine of three", "3 were given"], 2),
    ("mesh --sites 30 --period 1,0", ["--period 1,0", "give two positive lengths"], 2),
    ("mesh --sites 30 --repeat 2", ["--repeat 2", "such as 2x3"], 2),
    ("mesh --sites 999999999", ["--sites 999999999", "too large"], 4),
    # Options that do not fit together, and missing ones.
    ("mesh -o t.obj", ["give --sites N or --input FILE"], 2),
    ("mesh --sites 30 --input sites.txt", ["--sites and --input exclude each other"], 2),
    ("mesh --sites 30 --size 0.1", ["add --mesh grains"], 2),
    ("mesh --sites 30 --walls x --symmetry p2 --areas equal --stability",
     ["(1) --stability does not work with --areas", "(2) --symmetry does not work with --areas",
      "(3) --walls does not work with --symmetry", "(4) --stability does not work with --walls"], 2),
    ("mesh --sites 30 --outline box --mesh delaunay",
     ["pcvt: --outline box cannot cut Delaunay triangles; take --mesh grains, or --outline whole"], 2),
    # In space.
    ("mesh --sites 9 --period 1,1,1 --walls x", ["--walls is not for three dimensions; leave it out"], 2),
    ("mesh --sites 9 --period 1,1,1 --walls x --areas equal --aspect 2",
     ["--areas and --walls are not for three dimensions; leave them out"], 2),
    ("mesh --sites 9 --surface boundary", ["--surface is for three dimensions; leave it out, or give W,H,D"], 2),
    ("mesh --sites 9 --period 1,1,1 -o t.ojb", ["unknown extension .ojb", "did you mean .obj?"], 2),
    ("mesh --sites 9 --period 1,1,1 -o t.xyz", ["unknown extension .xyz; take one of .obj, .ply"], 2),
    ("mesh --sites 9 --period 1,1,1 -o t.html", [".html does not support three dimensions; take .obj, .ply"], 2),
    ("mesh --sites 30 -o t.msh", ["no polygons", "take the mesh delaunay or grains"], 2),
    ("mesh --sites 30 -o t.obj -o t.obj", ["t.obj", "choose another name"], 2),
    ("mesh --input none.txt", ["none.txt"], 2),
    ("check", ["no file to check"], 2),
    ("check none.obj", ["none.obj"], 2),
    ("study table1 -o results", ["neither .csv, .svg nor .html nor a folder, which ends in /"], 2),
    # Outputs.
    ("mesh --sites 3000000 -o kept.obj", ["kept.obj", "--force"], 3),
    ("mesh --sites 3000000 -o kept.obj/t.obj", ["kept.obj", "Not a directory"], 3),
]


class Mistakes(CliTest):
    def test_each_mistake_gives_one_line_with_the_remedy(self):
        self.assertGreaterEqual(len(MISTAKES), 50)
        self.write("kept.obj", "precious")
        for line, words, code in MISTAKES:
            with self.subTest(line):
                pattern = "^" + "".join(f"(?=.*{re.escape(word)})" for word in words)
                self.refuse(code, pattern, *shlex.split(line), timeout=20)
                self.assertEqual([p.name for p in self.folder.iterdir()], ["kept.obj"])


class Help(CliTest):
    def test_no_argument_prints_the_help(self):
        self.assertEqual(self.succeed(), self.succeed("--help"))
        self.assertEqual(self.succeed("help"), self.succeed("--help"))

    def test_help_of_a_command_is_its_help(self):
        for command in ("mesh", "pattern", "study", "check"):
            self.assertEqual(self.succeed("help", command), self.succeed(command, "--help"))

    def test_every_function_and_constant_that_the_help_lists_is_known(self):
        said = self.succeed("help", "density")
        functions = said.split("Functions:\n")[1].split("  (ln")[0].split()
        constants = said.split("Constants:\n")[1].split("  (")[0].split()
        self.assertIn("tanh", functions)
        self.assertIn("pi", constants)
        terms = [f"{f}(0.5, 0.5)" if f == "atan2" else f"{f}(1.5)" if f == "acosh" else f"{f}(0.5)"
                 for f in functions] + constants
        formula = "9 + abs(" + ") + abs(".join(terms) + ")"
        self.succeed("mesh", "--sites", 3, "--max-iterations", 0, "--density", formula)
        mesh = self.succeed("mesh", "--help")
        for word in functions + constants + ["g_i: centroid"]:
            self.assertIn(word, mesh)

    def test_formats_lists_every_extension(self):
        said = self.succeed("help", "formats")
        for extension in ("obj", "ply", "glb", "gltf", "om", "msh", "inp", "vtu", "svg", "png", "dxf", "html",
                          "foam", "nc", "csv", "txt"):
            self.assertRegex(said, rf"(?m)^  \.{extension} +\S")


if __name__ == "__main__":
    main()
