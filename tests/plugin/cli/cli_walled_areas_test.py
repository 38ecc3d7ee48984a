"""Prescribed areas between walls on the command line: laws, files, proofs, reports and refusals."""

import csv
import json
import re

from support.cli import CliTest, main, outputs

BOX = ("--sites", 40, "--period", "2,1")
TILES = ("obj", "ply", "glb", "gltf", "om", "vtu", "foam")
SOLVERS = ("msh", "inp", "foam")
PICTURES = ("svg", "png", "html", "dxf")
LAWS = ("equal", "lognormal:0.42", "gamma:0.3")


class WalledAreas(CliTest):
    def mesh(self, *arguments):
        return self.succeed("mesh", *BOX, "--force", "--quiet", *arguments)

    def table(self, name):
        lines = self.path(name).read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def target_areas(self, n=40):
        areas = [1 + (7 * k) % 11 / 5 for k in range(n)]
        self.write("areas.txt", "".join(f"{a}\n" for a in areas))
        return areas

    def assert_areas(self, name, targets, tolerance):
        areas = [float(row["area"]) for row in self.table(name)]
        for area, target in zip(areas, targets, strict=True):
            self.assertAlmostEqual(area / sum(areas) * sum(targets) / target, 1, delta=tolerance)
        self.assertAlmostEqual(sum(areas), 2, delta=1e-12)

    def test_laws_and_steps_are_reported(self):
        for walls in ("x", "y", "xy"):
            for law in LAWS:
                for steps in ((), ("--max-iterations", 0), ("--max-iterations", 5)):
                    self.mesh("--walls", walls, "--areas", law, "--tolerance", "1e-4", *steps, "--report", "r.json",
                              "-o", "t.csv")
                    report = json.loads(self.path("r.json").read_text())
                    stop = "converged" if report["residual"] <= 1e-4 else "iteration-limit"
                    self.assertEqual((report["stop"], report["start"], report["walls"]["sides"], report["areas"]["law"]),
                                     (stop, "random", walls, law))
                    if steps:
                        self.assertEqual(report["iterations"], steps[1])
                    self.assertLessEqual(report["areas"]["largest_relative_error"], 1e-10)
                    self.assertEqual(report["sites"], 40)
                    if law == "equal":
                        self.assert_areas("t.csv", [1] * 40, 1e-9)

    def test_check_proves_the_areas_in_every_format_of_every_mesh(self):
        targets = self.target_areas()
        for walls, words in (("x", "an annulus after gluing"), ("y", "an annulus after gluing"), ("xy", "a disc")):
            for mesh, cells, options in (("voronoi", "whole", ()), ("voronoi", "half", ()),
                                         ("voronoi", "whole", ("--short-edges", "0.1")),
                                         ("voronoi", "half", ("--short-edges", "0.1")),
                                         ("voronoi", "whole", ("--outline", "box")), ("delaunay", "half", ()),
                                         ("grains", "whole", ()), ("grains", "half", ()),
                                         ("grains", "whole", ("--outline", "box"))):
                cut = "box" in options and mesh == "voronoi"
                extensions = [e for e in (TILES if mesh == "voronoi" else TILES + SOLVERS[:2]) if e != "foam" or not cut]
                self.mesh("--walls", walls, "--wall-cells", cells, "--mesh", mesh, *options, "--areas", "areas.txt",
                          "--max-iterations", 5, *outputs(*extensions, *PICTURES), "-o", "t.csv")
                self.assert_areas("t.csv", targets, 1e-8)
                # The box outline moves corners of grains in steps, so that their areas are near, not exact.
                proof = () if mesh == "grains" and "box" in options else ("--areas", "areas.txt")
                text = self.succeed("check", *(f"t.{extension}" for extension in extensions), *proof)
                for line in text.splitlines():
                    self.assertRegex(line, rf"\d+ on walls, {words}, area 2 .*40 sites agree, power cells")
                    if proof:
                        self.assertRegex(line, "areas of 40 cells within")

    def test_check_refuses_other_areas_and_weights(self):
        self.target_areas()
        self.write("other.txt", "".join(f"{1 + k % 3}\n" for k in range(40)))
        self.mesh("--walls", "xy", "--areas", "areas.txt", "--max-iterations", 3, *outputs("obj"))
        self.refuse(2, "law of the areas: the cell of site", "check", "t.obj", "--areas", "other.txt")
        text = self.path("t.obj").read_text()
        sites = re.findall(r"(?m)^# pcvt site \S+ \S+ \S+$", text)
        self.assertEqual(len(sites), 40)
        *start, weight = sites[7].split(" ")
        self.write("u.obj", text.replace(sites[7], " ".join([*start, str(float(weight) + 0.01)])))
        self.refuse(2, "^u.obj", "check", "u.obj")

    def test_centroidal_cells_are_proved(self):
        for walls in ("x", "y", "xy"):
            self.mesh("--walls", walls, "--areas", "gamma:0.3", *outputs("obj"))
            self.assertIn("centroidal power cells within", self.succeed("check", "--cvt", "t.obj"))

    def test_sites_of_a_file_keep_their_places(self):
        sites = [(0.1, 0.2), (1.8, 0.3), (0.4, 1e-6), (1.2, 0.9), (0.7, 0.0)]
        self.write("s.txt", "".join(f"{x} {y}\n" for x, y in sites))
        self.write("a.txt", "3\n2\n1\n4\n2\n")
        self.succeed("mesh", "--input", "s.txt", "--period", "2,1", "--walls", "xy", "--areas", "a.txt", "--max-iterations",
                     0, "-o", "t.csv", "-o", "t.vtu")
        for row, (x, y) in zip(self.table("t.csv"), sites, strict=True):
            self.assertAlmostEqual(float(row["x"]), x, delta=1e-14)
            self.assertAlmostEqual(float(row["y"]), y, delta=1e-14)
        self.assert_areas("t.csv", [3, 2, 1, 4, 2], 1e-8)
        self.succeed("check", "t.vtu", "--areas", "a.txt")

    def test_phases_and_orientations_go_with_them(self):
        self.mesh("--walls", "y", "--areas", "lognormal:0.42", "--max-iterations", 5, "--mesh", "grains", "--phases",
                  "soft:0.7,hard:0.3", "--orientations", "random", "--report", "r.json", *outputs("msh", "inp", "vtu", "csv"))
        self.succeed("check", "t.msh", "t.inp", "t.vtu")
        table = self.table("t.csv")
        soft = sum(float(row["area"]) for row in table if row["phase"] == "soft")
        smallest = min(float(row["area"]) for row in table)
        self.assertLessEqual(abs(soft - 0.7 * 2), smallest / 2)

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        for threads in (1, 2, 4):
            self.succeed("mesh", "--sites", 1500, "--period", "2,1", "--walls", "xy", "--areas", "gamma:0.3", "--threads",
                         threads, "--max-iterations", 2, *outputs("vtu", "csv", "svg", name=threads))
        files = self.contents()
        for extension in ("vtu", "csv", "svg"):
            self.assertEqual(len({files[f"{threads}.{extension}"] for threads in (1, 2, 4)}), 1)

    def test_what_does_not_fit_is_refused_in_one_line(self):
        areas = ("mesh", *BOX, "--walls", "y", "--areas", "gamma:0.3")
        for arguments, words in ((("--aspect", 2), "--aspect does not work with --walls; leave one of them out"),
                                 (("--density", "1 + u"), "leave one of them out"),
                                 (("--wall-cells", "half", "--max-iterations", 0), "leave --max-iterations 0 out, or take --wall-cells whole"),
                                 (("-o", "t.nc"), "leave"), (("-o", "t.vti"), "leave the walls out"),
                                 (("--mesh", "delaunay"), "add --wall-cells half, or take --mesh grains"),
                                 (("--mesh", "grains", "--job", "elastic", "-o", "t.inp"), "leave the job or the walls out")):
            self.refuse(2, words, *areas, *arguments)
        self.assertEqual(list(self.contents()), [])


if __name__ == "__main__":
    main()
