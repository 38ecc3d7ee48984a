"""pcvt mesh: phases and orientations of cells, and jobs of solvers."""

import json
import math
import re

from support.cli import CliTest, main

GRAINS = ("mesh", "--sites", 60, "--mesh", "grains", "--tolerance", "1e-3")


class Phases(CliTest):
    def test_the_summary_and_the_report_give_the_fractions(self):
        out = self.succeed("mesh", "--sites", 500, "--phases", "ferrite:0.3,martensite:0.7",
                           "--tolerance", "1e-3", "--report", "r.json")
        lines = re.findall(r"^phase +(\w+) (\S+) of the area in (\d+) cells; wanted (\S+)$", out, re.M)
        self.assertEqual([line[0] for line in lines], ["ferrite", "martensite"])
        phases = json.loads(self.path("r.json").read_text())["phases"]
        self.assertEqual([p["name"] for p in phases], ["ferrite", "martensite"])
        self.assertEqual(sum(p["cells"] for p in phases), 500)
        self.assertAlmostEqual(sum(p["reached"] for p in phases), 1, 14)
        for phase, wanted, line in zip(phases, (0.3, 0.7), lines):
            self.assertEqual(phase["wanted"], wanted)
            # Half of a cell of the mean area.
            self.assertLess(abs(phase["reached"] - wanted), 0.5 / 500)
            self.assertEqual(phase["cells"], int(line[2]))

    def test_the_seed_alone_decides(self):
        def files(seed, threads):
            self.succeed(*GRAINS, "--seed", seed, "--threads", threads, "--phases", "a:0.5,b:0.5",
                         "--orientations", "random", "-o", "t.inp", "-o", "t.msh", "--force")
            return self.contents()

        self.assertEqual(files(1, 1), files(1, 3))
        self.assertNotEqual(files(1, 1), files(2, 1))

    def test_files_state_the_phases_and_are_proved(self):
        self.succeed(*GRAINS, "--phases", "a:0.5,b:0.5", "-o", "t.inp", "-o", "t.msh")
        self.succeed("check", "t.inp", "t.msh")
        text = self.path("t.inp").read_text()
        phase = dict(re.findall(r"ELSET=(CELL_\d+),MATERIAL=(\w)", text))
        self.assertEqual(len(phase), 60)
        self.assertEqual(sorted(phase.values()).count("a"), 30)
        groups = re.findall(r'^2 \d+ "phase_(\w)"$', self.path("t.msh").read_text(), re.M)
        self.assertEqual(groups, ["a", "b"])

    def test_files_that_show_phases_do_not_state_them(self):
        self.succeed("mesh", "--sites", 9, "--mesh", "voronoi", "--mesh", "delaunay", "--phases", "a:1",
                     "-o", "t.obj", "-o", "t.glb", "-o", "t.vtu", "-o", "t.svg")
        self.succeed("check", "t-voronoi.obj", "t-delaunay.obj", "t-voronoi.glb")

    def test_wrong_phases_are_one_line(self):
        for text, words in (("a", "'a' is not a phase; write NAME:FRACTION"),
                            ("a:0.4,b:0.5", "sum to 0.9; make the sum 1"),
                            ("a:0.5,A:0.5", "given twice"), ("", "write NAME:FRACTION"),
                            ("a b:1", "letters, digits, _ or -"), ("a\nb:1", "letters")):
            self.refuse(2, "^pcvt: --phases .*" + re.escape(words), *GRAINS, "--phases", text)

    def test_formats_without_phases_are_refused(self):
        self.refuse(2, r"no output takes phases; add one of .*\.msh or \.inp", "mesh", "--sites", 9,
                    "--phases", "a:1", "-o", "t.om")
        self.refuse(2, r"no output takes orientations; add one of .*\.inp", *GRAINS,
                    "--orientations", "random", "-o", "t.msh")
        self.refuse(2, "Delaunay triangles are not cells, .*; take the mesh grains", "mesh", "--sites",
                    9, "--mesh", "delaunay", "--phases", "a:1", "-o", "t.inp")


class Orientations(CliTest):
    def test_a_file_gives_one_orientation_a_site(self):
        self.write("sites.txt", "0.1 0.2\n0.7 0.8\n0.3 0.6\n")
        self.write("angles.txt", "# phi1 Phi phi2\n45 0 0\n\n0 90 0 # second\r\n10.5 20.25 -30\n")
        self.succeed("mesh", "--input", "sites.txt", "--max-iterations", 0, "--mesh", "grains",
                     "--orientations", "angles.txt", "-o", "t.inp")
        text = self.path("t.inp").read_text()
        self.assertEqual(re.findall(r"pcvt angles (.*)", text),
                         ["45 0 0", "0 90 0", "10.5 20.25 -30"])
        row = re.search(r"NAME=ORI_1\n(.*)", text)[1]
        self.assertEqual(row, "1,0,0,0,0,1")
        self.succeed("check", "t.inp")

    def test_colours_show_orientations(self):
        run = ("mesh", "--sites", 30, "--seed", 3, "--orientations", "random", "--force")
        self.succeed(*run, "--colour", "orientation", "-o", "t.obj", "-o", "t.ply", "-o", "t.glb", "-o", "t.html")
        for name in ("t.obj", "t.ply", "t.glb"):
            self.succeed("check", name)
        used = re.findall(r"^usemtl (.*)$", self.path("t.obj").read_text(), re.M)
        self.assertGreater(len(set(used)), 20)
        self.assertTrue(all(name.startswith("ipf_") for name in used))
        page = self.path("t.html").read_text()
        self.assertIn('"colouring": "orientation"', page)
        colours = re.search(r'"pole_colours": \[(.*?)\]', page)[1].replace('"', "").split(", ")
        self.assertEqual(len(colours), 30)
        self.assertEqual({f"ipf_{colour[1:]}" for colour in colours}, set(used))
        # Pictures show orientations where the user leaves the choice.
        self.succeed(*run, "-o", "a.svg")
        self.succeed(*run, "-o", "b.svg", "--colour", "orientation")
        self.assertEqual(self.path("a.svg").read_text().replace("a.svg", ""),
                         self.path("b.svg").read_text().replace("b.svg", "").replace(" --colour orientation", ""))
        self.refuse(2, "--colour orientation needs --orientations", "mesh", "--sites", 9, "--colour", "orientation", "-o", "t.svg")

    def test_wrong_files_are_named_with_their_lines(self):
        for text, words in ((b"1 2 3\n4 5\n", r"a\.txt:2: an orientation has 3 angles, .* has 2; "),
                            (b"1 2 x\n", r"a\.txt:1: 'x' is not a number; "),
                            (b"1 2 400\n", r"a\.txt:1: an angle of an orientation is not from -360 to 360 degrees; "),
                            (b"# none\n", r"a\.txt: holds no orientation; "),
                            (b"\0", r"a\.txt:1: holds a NUL byte"),
                            (b"1 2 3\n", "there are 1 orientations for 60 sites; give one for each")):
            self.write("a.txt", text)
            self.refuse(2, words, *GRAINS, "--orientations", "a.txt", "-o", "t.inp")
        self.refuse(2, r"none\.txt: cannot read", *GRAINS, "--orientations", "none.txt")

    def test_angles_that_look_like_radians_are_refused(self):
        run = ("mesh", "--sites", 12, "--max-iterations", 0, "--mesh", "grains", "--force", "-o", "t.inp", "--orientations")
        rows = [(0.5 * k, 0.2 * k, 6.2832 - 0.5 * k) for k in range(12)]

        def write(rows):
            self.write("a.txt", "".join("%.4f %.4f %.4f\n" % row for row in rows))

        def angles():
            lines = re.findall(r"pcvt angles (.*)", self.path("t.inp").read_text())
            return [tuple(map(float, line.split())) for line in lines]

        write(rows)
        self.refuse(2, r"a\.txt: .*look like radians; take --orientations rad:FILE, or deg:FILE", *run, "a.txt")
        out = self.succeed(*run, "deg:a.txt", "--report", "r.json")
        self.assertEqual(angles()[3], (1.5, 0.6, 4.7832))
        self.assertIn("angles     phi1 0 to 5.5, Phi 0 to 2.2, phi2 0.7832 to 6.2832 degrees\n", out)
        self.assertEqual(json.loads(self.path("r.json").read_text())["orientations"],
                         {"phi1": [0, 5.5], "Phi": [0, 2.2], "phi2": [0.7832, 6.2832]})
        self.succeed(*run, "rad:a.txt")
        for found, row in zip(angles(), rows):
            for degrees, radians in zip(found, row):
                self.assertAlmostEqual(degrees, min(math.degrees(radians), 360), 3)
        # Degrees: fewer than ten rows, an angle beyond a full turn in radians, a Phi beyond half a turn, or
        # all angles below 0.2.
        for other in ([(6.3, 0, 0), *rows[1:]], [(0, -3.15, 0), *rows[1:]], [(0.2, -0.1, 0.01)] * 12):
            write(other)
            self.succeed(*run, "a.txt")
        write(rows[:9])
        self.succeed("mesh", "--sites", 9, *run[3:], "a.txt")
        self.write("a.txt", "0 6.29 0\n" * 12)
        self.refuse(2, r"a\.txt:1: an angle of an orientation is not from -2 pi to 2 pi", *run, "rad:a.txt")
        self.refuse(2, r"r\.txt: cannot read", *run, "rad:r.txt")

    def test_the_file_is_no_output(self):
        self.write("t.txt", "1 2 3\n" * 60)
        self.refuse(2, r"t\.txt", *GRAINS, "--orientations", "deg:t.txt", "-o", "t.txt", "--force")


class Names(CliTest):
    def sets(self, stem):
        """The names of all sets, groups, patches and zones in the files of a run."""
        text = self.path(f"{stem}.inp").read_text() if self.path(f"{stem}.inp").exists() else ""
        found = re.findall(r"^\*(?:NODE|ELEMENT|NSET|ELSET|SURFACE|ORIENTATION)\b.*?(?:NSET|ELSET|NAME)=([\w-]+)", text, re.M)
        text = self.path(f"{stem}.msh").read_text()
        found += re.findall(r'^\d+ \d+ "(.+)"$', text.split("$PhysicalNames", 1)[1].split("$End", 1)[0], re.M)
        for part in ("boundary", "cellZones"):
            file = self.path(f"{stem}.foam/constant/polyMesh/{part}")
            if file.exists():
                found += re.findall(r"^ *([\w-]+)\n *\{", file.read_text().split("\n(", 1)[1], re.M)
        return set(found)

    def test_no_phase_and_no_tag_has_the_name_of_a_set(self):
        phases = ("--phases", "soft:0.6,hard:0.4")
        found = set()
        for stem, options in (("walls", ("--walls", "y", "--mesh", "grains", *phases)),
                              ("seam", ("--lattice", "1,0,0.3,0.9", "--mesh", "grains", *phases, "--orientations", "random")),
                              ("orbits", ("--symmetry", "p2", "--mesh", "grains")),
                              ("holes", ("--sites", 200, "--fibres", "0.2,1", "--hole", "fibre", "--mesh", "grains")),
                              ("space", ("--period", "1,1,1"))):
            sites = () if "--sites" in options else ("--sites", 12)
            extensions = ("msh", "foam") if stem == "space" else ("inp", "msh", "foam")
            self.succeed("mesh", *sites, "--tolerance", "1e-2", "--quiet", *options,
                         *(word for extension in extensions for word in ("-o", f"{stem}.{extension}")))
            found |= self.sets(stem)
        # One name of each kind.
        kinds = {re.sub(r"\d+", "0", name).upper(): name for name in sorted(found) if name.upper() != "FIBRE"}
        self.assertLessEqual({"CELL_0", "CONTROL_0", "ORI_0", "ORBIT_0", "PHASE_SOFT", "SEAM_0_0", "SEAM_0_0_0", "NALL", "EALL",
                              "FIXED", "GRAIN_BOUNDARY", "TRIPLE_POINTS", "WALL_TOP", "WALL_TOP_SIDES", "FIBRE_SIDES", "FRONT",
                              "BACK", "DOMAIN"}, set(kinds))
        for name in kinds.values():
            words = rf"{name} has the name of a set in files \({name.lower()}, .*\); rename it"
            self.refuse(2, "the phase " + words, "mesh", "--sites", 12, "--phases", f"{name}:0.1,soft:0.3,hard:0.2,fibre:0.2,matrix:0.2")
            self.write("shapes.txt", f"circle fibre 0.2 0.2 0.1\ncircle soft 0.2 0.7 0.1\ncircle hard 0.7 0.7 0.1\n"
                                     f"circle {name} 0.7 0.2 0.1\n")
            self.refuse(2, r"shapes\.txt:4: the tag " + words, "mesh", "--sites", 900, "--inclusions", "shapes.txt")
        for name in ("cell_wall", "phase_1", "wall_paper", "GRAINS"):
            self.succeed("mesh", "--sites", 12, "--max-iterations", 0, "--phases", f"{name}:0.5,soft:0.5")


class Jobs(CliTest):
    def test_a_job_holds_materials_and_steps(self):
        self.succeed(*GRAINS, "--job", "elastic", "--phases", "a:0.5,b:0.5", "--material", "same", "-o", "t.inp")
        text = self.path("t.inp").read_text()
        self.assertEqual(re.findall(r"\*MATERIAL,NAME=(\w+)", text), ["a", "b"])
        self.assertEqual(text.count("*STEP"), 3)
        self.succeed("check", "t.inp")

    def test_each_phase_has_the_constants_of_its_material(self):
        phases = (*GRAINS, "--phases", "soft:0.5,hard:0.5", "--report", "r.json", "--force")
        constants = ("--material", "hard:2100000,0.3", "--material", "soft:162.4,92,69,180.7,46.7")
        out = self.succeed(*phases, "--job", "elastic", *constants, "-o", "t.inp")
        text = self.path("t.inp").read_text()
        self.assertIn("*MATERIAL,NAME=soft\n*ELASTIC,TYPE=ORTHO\n162.4,92.,162.4,69.,69.,180.7,35.2,46.7\n46.7\n"
                      "*MATERIAL,NAME=hard\n*ELASTIC\n2100000.,0.3\n", text)
        self.assertIn("material   soft: C11 162.4, C12 92, C13 69, C33 180.7, C44 46.7\n"
                      "material   hard: E 2100000, nu 0.3\n", out)
        self.assertEqual(json.loads(self.path("r.json").read_text())["materials"],
                         [{"name": "soft", "C11": 162.4, "C12": 92, "C13": 69, "C33": 180.7, "C44": 46.7},
                          {"name": "hard", "E": 2100000, "nu": 0.3}])
        self.succeed("check", "t.inp")
        out = self.succeed(*phases, *constants, "-o", "t.vti")
        self.assertIn("material   hard: E 2100000, nu 0.3\n", out)
        self.assertIn("C_11: 162.4, C_12: 92.0, C_13: 69.0, C_33: 180.7, C_44: 46.7}",
                      self.path("t.material.yaml").read_text())
        self.succeed("check", "t.vti")

    def test_the_summary_states_the_constants_of_pcvt(self):
        out = self.succeed(*GRAINS, "--job", "elastic", "-o", "t.inp")
        self.assertIn("material   GRAINS: E 210000, nu 0.3 (steel in MPa)\n", out)
        out = self.succeed(*GRAINS, "--job", "elastic", "--orientations", "random", "-o", "o.inp")
        self.assertIn("material   GRAINS: C11 231400, C12 134700, C44 116400 (iron in MPa)\n", out)
        out = self.succeed(*GRAINS, "--job", "elastic", "--material", "GRAINS:70000,0.33", "-o", "g.inp")
        self.assertIn("material   GRAINS: E 70000, nu 0.33\n", out)
        self.assertNotIn("material ", self.succeed(*GRAINS, "-o", "m.inp"))

    def test_a_job_states_the_area_of_its_period(self):
        job = ("--mesh", "grains", "--tolerance", "1e-2", "--job", "elastic", "--force", "-o", "t.inp")
        fibres = ("--sites", 200, "--fibres", "0.3,2", "--hole", "fibre")
        for options, area in ((("--sites", 30), 1), (("--sites", 30, "--lattice", "3,0,1,0.5"), 1.5),
                              ((*fibres, "--period", "2,1.5"), 3), ((*fibres, "--repeat", "2x1"), 2),
                              (("--sites", 30, "--outline", "box", "--repeat", "2x3"), 6)):
            self.succeed("mesh", *options, *job)
            stated = re.search(r"^\*\* The area of the period is (\S+),", self.path("t.inp").read_text(), re.M)[1]
            self.assertAlmostEqual(float(stated), area, 12)
        self.succeed("mesh", "--sites", 30, *job[:4], "--force", "-o", "t.inp")
        self.assertNotIn("area of the period", self.path("t.inp").read_text())

    def test_several_phases_need_constants(self):
        job = (*GRAINS, "--job", "elastic", "-o", "t.inp")
        phases = (*job, "--phases", "soft:0.5,hard:0.5")
        self.refuse(2, "would give the phases soft, hard the same elastic constants; add --material", *phases)
        self.refuse(2, "would give the phases soft, hard", *phases, "--orientations", "random")
        fibres = ("mesh", "--sites", 300, "--mesh", "grains", "--tolerance", "1e-2", "--fibres", "0.3,3", "--job", "elastic",
                  "-o", "t.inp")
        self.refuse(2, "would give the phases matrix, fibre the same", *fibres)
        # One phase is left.
        self.succeed(*fibres, "--hole", "fibre")
        self.refuse(2, "--material fibre: no material of the files has this name; take one of matrix", *fibres, "--force",
                    "--hole", "fibre", "--material", "fibre:1,0.3")
        for materials, words in ((("soft:1,0.3",), "the phase hard has no elastic constants; add --material hard:E,NU"),
                                 (("soft:1,0.3", "hrad:1,0.3"), "--material hrad: no material of the files"),
                                 (("soft:1,0.3", "hard:1,0.5"), "--material 'hard:1,0.5': no material is stable"),
                                 (("same", "hard:1,0.3"), "--material same and NAME:... exclude each other")):
            self.refuse(2, "^pcvt: .*" + re.escape(words), *phases, "--force",
                        *(word for material in materials for word in ("--material", material)))

    def test_constants_need_a_file_that_states_them(self):
        self.refuse(2, "--material gives the elastic constants of --job elastic; add it", *GRAINS, "--material", "same",
                    "-o", "t.inp")
        self.refuse(2, r"no output takes elastic constants; add one of \.inp or \.vti", *GRAINS, "--material", "same",
                    "-o", "t.msh")

    def test_cells_of_inclusions_are_no_crystals(self):
        self.refuse(2, "--orientations gives each cell a crystal of its own, but inclusions", "mesh", "--sites", 300,
                    "--fibres", "0.3,3", "--orientations", "random", "-o", "t.csv")

    def test_a_job_needs_an_input_of_a_solver(self):
        self.refuse(2, r"no output takes a job of a solver; add one of \.inp", *GRAINS, "--job",
                    "elastic", "-o", "t.msh")
        self.refuse(2, "--job plastic: unknown; did you mean elastic", *GRAINS, "--job", "plastic", "-o", "t.inp")


if __name__ == "__main__":
    main()
