"""Plane groups on the command line: symmetric sites in the files, reports and refusals."""

import csv
import json
import re

from support.cli import CliTest, main

GROUPS = ("p1", "p2", "pm", "pg", "cm", "pmm", "pmg", "pgg", "cmm", "p4", "p4m", "p4g", "p3", "p3m1", "p31m",
          "p6", "p6m")


class Symmetry(CliTest):
    def report(self, *arguments):
        self.succeed("mesh", "--quiet", "--force", "--report", "r.json", *arguments)
        return json.loads(self.path("r.json").read_text())

    def sites(self, name):
        lines = self.path(name).read_text().splitlines()
        return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]

    def test_every_group_chooses_a_lattice_and_reports_its_orbits(self):
        for group in GROUPS:
            report = self.report("--sites", 48, "--symmetry", group, "-o", "t.obj")
            self.assertEqual(report["symmetry"]["group"], group)
            self.assertEqual(report["stop"], "converged")
            self.assertEqual(report["start"], "random")
            self.assertGreater(report["energy"], report["energy_bound"] * (1 - 1e-12))
            self.assertTrue(1 <= report["symmetry"]["orbits"] <= 48)
        self.assertNotIn("symmetry", self.report("--sites", 5))

    def test_written_sites_mirror_in_the_walls_of_a_channel(self):
        self.report("--sites", 40, "--symmetry", "pm", "--period", "3,2", "-o", "s.txt")
        sites = {(round(x, 12), round(y, 12)) for x, y in self.sites("s.txt")}
        self.assertEqual(len(sites), 40)
        for x, y in sites:
            self.assertIn((x, round((2 - y) % 2, 12)), sites)

    def test_centres_of_the_highest_order_are_occupied_first(self):
        without = self.report("--sites", 240, "--symmetry", "p4m", "--seed", 1)
        occupied = self.report("--sites", 242, "--symmetry", "p4m", "--seed", 1, "-o", "s.txt")
        self.assertEqual(without["symmetry"]["orbits"], 30)
        self.assertEqual(occupied["symmetry"]["orbits"], 32)
        sites = self.sites("s.txt")
        self.assertIn((0, 0), sites)
        self.assertIn((0.5, 0.5), sites)

    def test_files_of_cells_state_the_orbits(self):
        for mesh in ("voronoi", "delaunay", "grains"):
            report = self.report("--sites", 58, "--symmetry", "p4m", "--mesh", mesh, "--repeat", "1x2", "-o", "t.vtu",
                                 "--cells", "c.csv")
            with open(self.path("c.csv")) as file:
                rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
            orbits = [int(row["orbit"]) for row in rows]
            n_orbits = report["symmetry"]["orbits"]
            self.assertEqual(sorted(set(orbits), key=orbits.index), list(range(n_orbits)))
            # Orbits on mirrors and centres are smaller; sites of an orbit have cells of one area.
            for orbit in range(n_orbits):
                cells = [row for row in rows if int(row["orbit"]) == orbit]
                self.assertIn(len(cells), (1, 2, 4, 8))
                areas = [float(cell["area"]) for cell in cells]
                self.assertLess(max(areas) - min(areas), 1e-12)
            text = self.path("t.vtu").read_text().split("<CellData>")[1]
            cell, orbit = (re.search(rf'Name="{name}" format="ascii">\n([^<]*)<', text)[1].split()
                           for name in ("CellId", "Orbit"))
            self.assertEqual([orbits[int(c)] for c in cell], [int(o) for o in orbit])
            self.succeed("check", "t.vtu")
        self.report("--sites", 20, "-o", "t.vtu", "--cells", "c.csv")
        self.assertNotIn("Orbit", self.path("t.vtu").read_text())
        self.assertIn(",,,,,,", self.path("c.csv").read_text())

    def test_files_of_solvers_state_the_orbits(self):
        report = self.report("--sites", 50, "--symmetry", "p4m", "--mesh", "grains", "-o", "t.inp", "-o", "t.msh",
                             "-o", "t.obj", "--cells", "c.csv")
        with open(self.path("c.csv")) as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        text = self.path("t.inp").read_text()
        for orbit in range(report["symmetry"]["orbits"]):
            cells = [f"CELL_{row['site']}" for row in rows if int(row["orbit"]) == orbit]
            members = re.search(rf"^\*ELSET,ELSET=ORBIT_{orbit}\n([^*]*)", text, re.M)[1]
            self.assertEqual(re.split(r"[,\n]", members.strip()), cells)
        text = self.path("t.msh").read_text()
        views = [dict(line.split() for line in view.split("$End")[0].splitlines()[8:])
                 for view in text.split("$ElementData\n")[1:]]
        for element, site in views[0].items():
            self.assertEqual(views[1][element], "-1" if site == "-1" else rows[int(site)]["orbit"])
        self.assertEqual(len(views), 2)
        said = self.succeed("check", "t.inp", "t.msh", "t.obj")
        self.assertEqual(said.count(f"{report['symmetry']['orbits']} orbits agree"), 3)

    def test_check_refuses_orbits_that_are_none(self):
        self.report("--sites", 24, "--symmetry", "p4", "-o", "t.vtu")
        text = self.path("t.vtu").read_text()
        begin = text.index('Name="Orbit"')
        for old, new, words in (("\n0\n", "\n", "CellData/Orbit has not the size"),
                                ("\n0\n", "\n0.5\n", "0.5"),
                                ("\n0\n", "\n77\n", "not counted in the order")):
            self.write("u.vtu", text[:begin] + text[begin:].replace(old, new, 1))
            self.refuse(2, words, "check", "u.vtu")

    def test_pictures_show_the_orbits(self):
        run = ("mesh", "--sites", 34, "--symmetry", "p4m", "--quiet", "--force", "--colour", "orbit")
        self.succeed(*run, "--glb-nodes", "one", "-o", "t.svg", "-o", "t.obj", "-o", "t.gltf", "-o", "t.ply",
                     "-o", "t.png", "-o", "t.html", "--cells", "c.csv")
        with open(self.path("c.csv")) as file:
            orbits = [row["orbit"] for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        for orbit in set(orbits):
            self.assertIn(f">orbit {orbit}: {orbits.count(orbit)}<", self.path("t.svg").read_text())
        self.assertEqual(set(re.findall(r"newmtl orbit_(\S+)", self.path("t.mtl").read_text())), set(orbits))
        names = [material["name"] for material in json.loads(self.path("t.gltf").read_text())["materials"]]
        self.assertLessEqual({f"orbit_{orbit}" for orbit in orbits}, set(names))
        self.assertIn(f'"orbits": [{",".join(orbits)}]', self.path("t.html").read_text())
        self.succeed("check", "t.obj", "t.gltf", "t.ply")
        # Triangles too, by the orbits of their sites.
        self.succeed(*run, "--mesh", "delaunay", "-o", "t.svg", "-o", "t.ply", "-o", "t.png", "-o", "t.html")
        self.refuse(2, "--colour orbit needs --symmetry", "mesh", "--sites", 9, "--colour", "orbit", "-o", "v.svg")

    def test_coarse_starts_keep_the_symmetry_and_are_the_default_of_many_orbits(self):
        for group in GROUPS:
            report = self.report("--sites", 240, "--symmetry", group, "--start", "coarse", "-o", "t.obj")
            self.assertEqual(report["start"], "coarse")
            self.assertIn("orbits agree", self.succeed("check", "t.obj"))
        for n_sites, start in ((1998, "random"), (2000, "coarse")):
            report = self.report("--sites", n_sites, "--symmetry", "pm", "--tolerance", "1e-3")
            self.assertEqual(report["start"], start)

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        for threads in (1, 3):
            self.succeed("mesh", "--sites", 600, "--symmetry", "p6m", "--threads", threads, "-o", f"{threads}.obj",
                         "--density", "2 + cos(2 * pi * u)", "--tolerance", "1e-3")
        files = self.contents()
        self.assertEqual(files["1.obj"].replace(b"1.mtl", b""), files["3.obj"].replace(b"3.mtl", b""))

    def test_what_does_not_fit_is_refused_in_one_line(self):
        self.write("s.txt", "0.1 0.2\n")
        for arguments, words in (
                (("--sites", 8, "--symmetry", "p5"), "p4g, p3"),
                (("--sites", 8, "--symmetry", "p4m", "--period", "1,2"), "it fits squares"),
                (("--sites", 8, "--symmetry", "p3", "--period", "1,1"), "it fits hexagonal lattices"),
                (("--sites", 8, "--symmetry", "pm", "--lattice", "1,0,0.37,0.81"), "it fits rectangles"),
                (("--sites", 7, "--symmetry", "pg"), "take 6 or 8"),
                (("--input", "s.txt", "--symmetry", "p2"), "--input gives them"),
                (("--sites", 8, "--symmetry", "p2", "--start", "best"), "take coarse or random"),
                (("--sites", 8, "--symmetry", "p2", "--areas", "equal"), "--symmetry does not work with --areas"),
                (("--sites", 8, "--symmetry", "p4", "--aspect", "2"), "elongated by the aspect")):
            self.refuse(2, words, "mesh", *arguments, "-o", "t.obj")


if __name__ == "__main__":
    main()
