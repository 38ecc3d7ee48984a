"""Prescribed areas and elongated cells on the command line: laws and files, refusals and reports."""

import csv
import json
import math
import os
import statistics

from support.cli import CliTest, main

OBLIQUE = ("--lattice", "1,0,0.37,0.81")


class AreaTest(CliTest):
    def report(self, *arguments, **options):
        self.succeed("mesh", "--quiet", "--force", "--report", "r.json", *arguments, **options)
        return json.loads(self.path("r.json").read_text())

    def table(self, name):
        lines = self.path(name).read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def areas(self, name):
        return [float(row["area"]) for row in self.table(name)]

    def assert_proportional(self, areas, targets, tolerance):
        for area, target in zip(areas, targets, strict=True):
            self.assertAlmostEqual(area / sum(areas) * sum(targets) / target, 1, delta=tolerance)


class PrescribedAreas(AreaTest):
    def test_a_law_is_reported_as_the_table_of_cells_shows_it(self):
        report = self.report("--sites", 400, "--areas", "lognormal:0.42", "--max-iterations", 2, "-o", "t.csv")
        self.assertEqual((report["stop"], report["iterations"]), ("iteration-limit", 2))
        areas = report["areas"]
        self.assertEqual(list(areas), ["law", "std_over_mean", "largest_relative_error",
                                       "largest_relative_mesh_error", "newton_steps", "circularity_mean", "circularity_std"])
        self.assertEqual(areas["law"], "lognormal:0.42")
        self.assertLessEqual(areas["largest_relative_error"], 1e-10)
        table = self.table("t.csv")
        diameters = [float(row["diameter"]) for row in table]
        spread = statistics.pstdev(diameters) / statistics.fmean(diameters)
        self.assertAlmostEqual(areas["std_over_mean"], spread, delta=1e-12)
        self.assertAlmostEqual(spread, 0.42, delta=0.06)
        circularities = [float(row["circularity"]) for row in table]
        self.assertAlmostEqual(areas["circularity_mean"], statistics.fmean(circularities), delta=1e-12)
        self.assertAlmostEqual(areas["circularity_std"], statistics.pstdev(circularities), delta=1e-12)

    def test_five_steps_give_the_circularity_of_grains(self):
        areas = self.report("--sites", 1000, "--areas", "lognormal:0.42", "--max-iterations", 5)["areas"]
        self.assertTrue(0.095 < 1 - areas["circularity_mean"] < 0.105, areas)

    def test_steps_that_end_away_from_the_centroids_are_a_limit(self):
        run = ("mesh", "--sites", 40, "--areas", "equal", "--max-iterations")
        for steps in (0, 3):
            out = self.succeed(*run, steps)
            self.assertRegex(out, rf"(?m)^stop +iteration-limit after {steps} iterations, ")
            self.assertRegex(out, r"(?m)^areas +equal, .*, converged: off by at most \S+ after \d+ Newton steps$")
            self.refuse(5, "not converged", *run, steps, "--strict", "--quiet")
        self.succeed(*run, 3, "--strict", "--tolerance", 0.5)

    def test_a_run_without_a_limit_is_centroidal(self):
        report = self.report("--sites", 100, "--areas", "gamma:0.3", "--tolerance", "1e-5", "-o", "t.csv")
        self.assertEqual(report["stop"], "converged")
        self.assertLessEqual(report["residual"], 1e-5)
        self.assertLessEqual(report["areas"]["largest_relative_error"], 1e-10)

    def test_a_file_gives_each_site_its_area_or_its_diameter(self):
        targets = [1 + (7 * k) % 12 for k in range(12)]
        self.write("a.txt", "# areas\r\n\r\n" + "".join(f"\t{a}  # one\r\n" for a in targets))
        self.write("d.txt", "diameter\n" + "\n".join(str(math.sqrt(a)) for a in targets))
        for name in ("a.txt", "d.txt"):
            report = self.report("--sites", 12, *OBLIQUE, "--areas", name, "--max-iterations", 1, "-o", "t.csv")
            self.assertEqual(report["areas"]["law"], name)
            areas = self.areas("t.csv")
            self.assert_proportional(areas, targets, 1e-9)
            self.assertAlmostEqual(sum(areas), 0.81, delta=1e-12)

    def test_summary_and_report_state_the_factor_of_given_areas(self):
        targets = [13.78, 20, 31.5, 34.72]
        self.write("a.txt", "\n".join(map(str, targets)))
        self.write("d.txt", "diameter\n" + "\n".join(str(math.sqrt(4 * a / math.pi)) for a in targets))
        run = ("mesh", "--sites", 4, "--max-iterations", 0, "--report", "r.json", "--force", "-o", "t.csv")
        for name in ("a.txt", "d.txt"):
            out = self.succeed(*run, "--period", "7,7", "--areas", name)
            self.assertRegex(out, rf"(?m)^areas +{name} \(each area times 0\.49\), ")
            self.assertAlmostEqual(json.loads(self.path("r.json").read_text())["areas"]["scale"], 0.49, 12)
        out = self.succeed(*run, "--areas", "gamma:0.3")
        self.assertNotIn("times", out)
        self.assertNotIn("scale", json.loads(self.path("r.json").read_text())["areas"])

    def test_an_automatic_period_has_the_sum_of_the_areas(self):
        targets = [13.78, 20, 31.5, 34.72]
        self.write("a.txt", "\n".join(map(str, targets)))
        self.write("d.txt", "diameter\n2\n4\n6\n8")
        run = ("mesh", "--sites", 4, "--max-iterations", 0, "--report", "r.json", "--force", "-o", "t.csv", "--period", "auto")
        out = self.succeed(*run, "--areas", "a.txt")
        self.assertIn("lattice    (10, 0) (0, 10)\n", out)
        self.assertIn("a.txt (each area times 1)", out)
        for area, target in zip(self.areas("t.csv"), targets, strict=True):
            self.assertAlmostEqual(area, target, 8)
        self.succeed(*run, "--areas", "d.txt")
        self.assertAlmostEqual(math.fsum(self.areas("t.csv")), 30 * math.pi, 10)
        for options in ((), ("--areas", "equal"), ("--density", "1 + u")):
            self.refuse(2, "--period auto takes the area of the domain from --areas FILE, or its aspect from", *run, *options)
        self.refuse(2, r"none\.txt: cannot read", *run, "--areas", "none.txt")

    def test_sites_of_a_file_keep_their_places_and_get_their_areas(self):
        sites = [(0.1, 0.2), (0.8, 0.3), (0.4, 0.7)]
        self.write("s.txt", "".join(f"{x} {y}\n" for x, y in sites))
        self.write("a.txt", "3\n2\n1\n")
        self.report("--input", "s.txt", "--areas", "a.txt", "--max-iterations", 0, "-o", "t.csv")
        table = self.table("t.csv")
        for row, (x, y) in zip(table, sites, strict=True):
            self.assertAlmostEqual(float(row["x"]), x, delta=1e-14)
            self.assertAlmostEqual(float(row["y"]), y, delta=1e-14)
        self.assert_proportional(self.areas("t.csv"), [3, 2, 1], 1e-9)

    def test_the_seed_draws_the_areas_also_for_sites_of_a_file(self):
        self.write("s.txt", "".join(f"{(k * 0.618) % 1} {(k * 0.415) % 1}\n" for k in range(20)))
        arguments = ("--input", "s.txt", "--areas", "gamma:0.3", "--max-iterations", 0)
        for seed, name in ((1, "a.csv"), (1, "b.csv"), (2, "c.csv")):
            self.report(*arguments, "--seed", seed, "-o", name)
        self.assertEqual(self.areas("a.csv"), self.areas("b.csv"))
        self.assertNotEqual(self.areas("a.csv"), self.areas("c.csv"))
        self.refuse(2, "--seed", "mesh", "--input", "s.txt", "--areas", "equal", "--seed", 1)

    def test_every_format_has_the_same_bytes_for_any_number_of_threads(self):
        cells = ("obj", "ply", "glb", "gltf", "om", "vtu", "svg", "png", "dxf", "html", "foam", "vti", "csv", "txt")
        triangles = ("obj", "ply", "glb", "gltf", "om", "vtu", "svg", "png", "dxf", "html", "foam", "msh", "inp")
        materials = ("--phases", "a:0.3,b:0.7", "--orientations", "random")
        jobs = {"cells": (cells, "--mesh", "voronoi", *materials),
                "cut": (cells[:10], "--mesh", "voronoi", "--outline", "box", "--aspect", "2,30"),
                "triangles": (triangles, "--mesh", "delaunay"),
                "grains": (triangles, "--mesh", "grains", *materials, "--job", "elastic", "--material", "same"),
                "boxed": (triangles, "--mesh", "grains", "--outline", "box", "--repeat", "2x1")}
        found = {}
        for threads in (1, 2, 4):
            for name, (formats, *options) in jobs.items():
                outputs = [word for extension in formats for word in ("-o", f"{name}.{extension}")]
                self.succeed("mesh", "--sites", 120, "--areas", "lognormal:0.42", "--max-iterations", 2, "--quiet",
                             "--force", "--threads", threads, *options, *outputs, "--cells", f"{name}-table.csv")
            found[threads] = self.contents()
        self.assertGreater(len(found[1]), 60)
        for threads in (2, 4):
            self.assertEqual(list(found[threads]), list(found[1]))
            for name, data in found[1].items():
                self.assertTrue(found[threads][name] == data, (threads, name))

    def test_large_runs_have_the_same_bytes_for_any_number_of_threads(self):
        for threads in (1, 3):
            self.report("--sites", 2000, "--areas", "gamma:0.3", "--aspect", "2,30", "--max-iterations", 1, "--threads",
                        threads, "-o", f"{threads}.csv", "-o", f"{threads}.svg", "-o", f"{threads}.txt")
        for extension in ("csv", "svg", "txt"):
            one, three = (self.path(f"{threads}.{extension}").read_bytes() for threads in (1, 3))
            self.assertEqual(one, three)

    def test_what_does_not_combine_is_refused_with_what_to_do(self):
        areas = ("mesh", "--sites", 50, "--areas", "gamma:0.3")
        self.refuse(2, "leave one of them out", *areas, "--density", "1 + u")
        self.refuse(2, "take coarse or random", *areas, "--start", "best")
        self.refuse(2, "take coarse or random", *areas, "--start", "lattice")
        self.refuse(2, "leave --solver out", *areas, "--solver", "newton")
        self.refuse(2, "leave one of them out", *areas, "--stability")
        self.refuse(2, "t.nc.*leave areas, weights and aspect out", *areas, "-o", "t.nc")
        self.refuse(2, "t.nc.*leave areas, weights and aspect out", "mesh", "--sites", 50, "--aspect", 2, "-o", "t.nc")
        self.refuse(2, "--retry", *areas, "--retry", 3)

    def test_impossible_laws_are_refused(self):
        for law, words in (("lognormal", "lognormal:S"), ("lognormal:0", "above 0"), ("gamma:3", "at most 2"),
                           ("gamma:nan", "gamma:S"), ("equal:1", "write 'equal'"), ("lognromal:0.4", "neither a law"),
                           ("", "neither a law"), ("missing.txt", "a file with one area a line"),
                           ("0.5*equal@1+0.4*gamma:0.2@2", "shares .* sum to 0.9; make it 1"),
                           ("0.5*equal+0.5*gamma:0.2", "SHARE.LAW@MEAN")):
            self.refuse(2, "--areas.*" + words, "mesh", "--sites", 5, "--areas", law)
        self.refuse(2, "smaller spread", "mesh", "--sites", 500, "--areas", "gamma:2")

    def test_a_mixture_has_its_shares_and_means(self):
        mixture = "0.75*equal@1 + 0.25*equal@3"
        report = self.report("--sites", 80, "--areas", mixture, "--max-iterations", 1, "--cells", "c.csv")
        self.assertEqual(report["areas"]["law"], mixture)
        rows = [line for line in self.path("c.csv").read_text().splitlines() if not line.startswith("#")]
        column = rows[0].split(",").index("area")
        areas = [float(row.split(",")[column]) for row in rows[1:]]
        small = 1 / (60 + 20 * 9)
        self.assertEqual(sorted(round(area / small, 7) for area in areas), [1] * 60 + [9] * 20)

    def test_impossible_files_are_refused_with_the_line(self):
        for text, words in (("1\n2\n", "a.txt:2: the last of 2 areas, but there are 3 sites; give one"),
                            ("1\n2\n3\n\n4\n", "a.txt:5: area 4, but there are 3 sites; give one"),
                            ("1\n-2\n3\n", "a.txt:2: '-2' is not the size"), ("1\n0\n3\n", "a.txt:2: '0' is not the size"),
                            ("1\nnan\n3\n", "a.txt:2: 'nan' is not a finite number"), ("1\n1e400\n3\n", "a.txt:2: '1e400'"),
                            ("1\n2 3\n4\n", "a.txt:2: .*one area a line"), ("1\ndiameter\n3\n", "a.txt:2: 'diameter'"),
                            ("1\n1e-9\n1\n", "a.txt:2: the area is below 1e-6 of the mean"),
                            ("# none\n", "a.txt: holds no area"), ("1\n\0\n", "a.txt:2: holds a NUL")):
            self.write("a.txt", text)
            self.refuse(2, words, "mesh", "--sites", 3, "--areas", "a.txt", "-o", "t.obj")
        os.mkfifo(self.path("pipe"))
        done = self.run_pcvt("mesh", "--sites", 3, "--areas", "pipe", timeout=20)
        self.assertEqual(done.returncode, 2)
        self.path("pipe").unlink()
        self.write("a.csv", "1\n2\n3\n")
        self.refuse(2, "a.csv", "mesh", "--sites", 3, "--areas", "a.csv", "--force", "-o", "a.csv")


class CheckedAreas(AreaTest):
    """`pcvt check --areas`, and the areas that grains keep."""

    def setUp(self):
        super().setUp()
        self.targets = [1 + (7 * k) % 12 for k in range(60)]
        self.write("a.txt", "".join(f"{a}\n" for a in self.targets))

    def mesh(self, *arguments):
        self.succeed("mesh", "--sites", 60, "--areas", "a.txt", "--max-iterations", 3, "--force", *arguments)

    def test_every_format_with_weights_is_checked(self):
        extensions = ("obj", "ply", "glb", "gltf", "om", "vtu")
        files = [f"t-{kind}.{e}" for kind in ("voronoi", "delaunay", "grains") for e in extensions]
        files += [f"t-{kind}.{e}" for kind in ("delaunay", "grains") for e in ("msh", "inp")]
        outputs = [w for e in (*extensions, "msh", "inp") for w in ("-o", f"t.{e}")]
        kinds = ("--mesh", "voronoi", "--mesh", "delaunay", "--mesh", "grains")
        self.mesh("--aspect", "2,30", *kinds, *outputs[:12])
        self.mesh("--aspect", "2,30", *kinds[2:], *outputs[12:])
        self.mesh("--aspect", "2,30", "-o", "t.vti")
        for name in (*files, "t.vti"):
            self.assertIn(", areas of 60 cells within", self.succeed("check", name, "--areas", "a.txt"), name)
        self.write("b.txt", "".join(f"{a}\n" for a in [self.targets[1], self.targets[0], *self.targets[2:]]))
        for name in (*files, "t.vti"):
            self.refuse(2, f"{name}: not a .*: law of the areas: the cell of site [01] has the area", "check", name,
                        "--areas", "b.txt")

    def test_diameters_and_repeated_boxes_are_checked(self):
        self.write("d.txt", "diameter\n" + "".join(f"{math.sqrt(a)}\n" for a in self.targets))
        self.mesh("--outline", "box", "--repeat", "2x1", "-o", "t.obj")
        self.assertIn("areas of 60 cells within", self.succeed("check", "t.obj", "--areas", "d.txt"))

    def test_questions_without_an_answer_are_refused(self):
        self.mesh("-o", "t.obj")
        self.succeed("mesh", "--sites", 60, "-o", "u.obj", "-o", "u.vti", "-o", "u.nc")
        for name in ("u.obj", "u.vti"):
            self.refuse(2, f"{name}: states no weights", "check", name, "--areas", "a.txt")
        self.refuse(2, "u.nc: --areas is not for MPAS", "check", "u.nc", "--areas", "a.txt")
        self.refuse(2, "--areas of check takes a file", "check", "t.obj", "--areas", "lognormal:0.42")
        self.refuse(2, "missing.txt", "check", "t.obj", "--areas", "missing.txt")
        for text, words in (("1\n2\n", "b.txt:2: the last of 2 areas, but there are 60 sites"),
                            ("1\n" * 61, "b.txt:61: area 61, but"), ("1\n-1\n", "b.txt:2: '-1' is not the size"),
                            ("", "b.txt: holds no area")):
            self.write("b.txt", text)
            self.refuse(2, words, "check", "t.obj", "--areas", "b.txt")

    def test_grains_have_the_areas_of_their_cells(self):
        for seed in range(6):
            report = self.report("--sites", 200, "--seed", seed, "--areas", "lognormal:0.42", "--max-iterations", 5,
                                 "--mesh", "grains", "--outline", ("whole", "box")[seed % 2], "-o", "t.inp", "--cells",
                                 "t.csv")
            self.assertLessEqual(report["areas"]["largest_relative_mesh_error"], 1e-10)
            meshed = self.areas_of_elements("t.inp")
            for row in self.table("t.csv"):
                self.assertAlmostEqual(meshed[int(row["site"])] / float(row["area"]), 1, delta=1e-9)

    def areas_of_elements(self, name):
        """The sum of the areas of the triangles in each set CELL_s of an Abaqus input."""
        nodes, elements, areas, card = {}, {}, {}, ""
        for line in self.path(name).read_text().splitlines():
            if line.startswith("*"):
                card = line
                continue
            words = [w.strip() for w in line.split(",") if w.strip()]
            if card.startswith("*NODE"):
                nodes[words[0]] = complex(float(words[1]), float(words[2]))
            elif card.startswith("*ELEMENT"):
                a, b, c = (nodes[w] for w in words[1:4])
                elements[words[0]] = ((b - a).conjugate() * (c - a)).imag / 2
            elif card.startswith("*ELSET") and "=CELL_" in card:
                site = int(card.split("=CELL_")[1])
                areas[site] = areas.get(site, 0) + sum(elements[w] for w in words)
        return areas

    def test_boxes_are_checked(self):
        for seed in range(8):
            report = self.report("--sites", 60, "--seed", seed, "--areas", "a.txt", "--max-iterations", 3, "--mesh",
                                 "grains", "--outline", "box", "-o", "t.obj")
            self.assertLess(report["areas"]["largest_relative_mesh_error"], 1e-10)
            self.succeed("check", "t.obj", "--areas", "a.txt")

    def test_the_summary_states_the_error_of_the_mesh(self):
        output = self.succeed("mesh", "--sites", 200, "--areas", "lognormal:0.42", "--max-iterations", 5, "--mesh",
                              "grains")
        self.assertRegex(output, r"meshed +grains, areas off by at most \S+e-1\d\n")
        # Whole cells have their areas exactly as they were fitted.
        output = self.succeed("mesh", "--sites", 200, "--areas", "lognormal:0.42", "--max-iterations", 5)
        self.assertNotIn("meshed", output)


class ElongatedCells(AreaTest):
    def test_areas_and_domain_are_those_of_the_user(self):
        report = self.report("--sites", 200, "--period", "2,1", "--origin", "0.5,-1", "--aspect", "3,30", "-o", "t.csv",
                             "-o", "t.txt", "-o", "t.svg")
        self.assertEqual(report["aspect"], {"ratio": 3, "degrees": 30})
        self.assertEqual((report["lattice"], report["stop"]), ([[2, 0], [0, 1]], "converged"))
        self.assertAlmostEqual(sum(self.areas("t.csv")), 2, delta=1e-12)
        for row in self.table("t.csv"):
            self.assertTrue(0.5 <= float(row["x"]) < 2.5 and -1 <= float(row["y"]) < 0)

    def test_sites_that_are_read_back_give_the_same_cells(self):
        options = (*OBLIQUE, "--aspect", "4,70")
        self.report("--sites", 60, *options, "-o", "t.csv", "-o", "t.txt")
        self.report("--input", "t.txt", *options, "--max-iterations", 0, "-o", "again.csv")
        for before, after in zip(self.table("t.csv"), self.table("again.csv"), strict=True):
            self.assertEqual(before["neighbours"].split().sort(), after["neighbours"].split().sort())
            self.assertAlmostEqual(float(before["area"]), float(after["area"]), delta=1e-12)
        self.report("--input", "t.txt", *OBLIQUE, "--max-iterations", 0, "-o", "round.csv")
        self.assertNotAlmostEqual(self.areas("t.csv")[0], self.areas("round.csv")[0], delta=1e-5)

    def test_ratio_1_changes_no_byte(self):
        self.succeed("mesh", "--sites", 100, "--aspect", "1,30", "-o", "a.obj", "-o", "a.txt")
        self.succeed("mesh", "--sites", 100, "-o", "b.obj", "-o", "b.txt")
        self.assertEqual(self.path("a.txt").read_text(), self.path("b.txt").read_text())
        self.assertEqual(self.path("a.obj").read_text().replace("a.mtl", "b.mtl"), self.path("b.obj").read_text())

    def test_a_pattern_of_the_metric_is_reported_in_the_plane(self):
        basis = self.report("--sites", 12, "--aspect", "3,0", "--start", "lattice")["pattern"]["basis"]
        (ax, ay), (bx, by) = basis
        self.assertAlmostEqual(ax * by - ay * bx, 1 / 12, delta=1e-12)
        # Its vectors lead from a site to sites: 12 times each is a vector of integers.
        for v in (ax, ay, bx, by):
            self.assertAlmostEqual(12 * v, round(12 * v), delta=1e-9)

    def test_a_density_is_evaluated_in_the_plane(self):
        report = self.report("--sites", 300, "--aspect", "2,45", "--density", "1 + 9 * exp(-((x - 0.5) / 0.1)^2)",
                             "--tolerance", "1e-4", "-o", "t.csv")
        self.assertLess(abs(report["mass_deviation"]), 1e-7)
        table = self.table("t.csv")
        inside = [float(r["area"]) for r in table if abs(float(r["x"]) - 0.5) < 0.05]
        outside = [float(r["area"]) for r in table if abs(float(r["x"]) - 0.5) > 0.3]
        self.assertLess(2 * statistics.fmean(inside), statistics.fmean(outside))
        self.refuse(2, "at x = 0.9", "mesh", "--sites", 30, "--aspect", "2,45", "--density", "0.9 - (x > 0.9)")

    def test_bad_ratios_are_refused(self):
        for aspect, words in (("0", "between 0.01 and 100"), ("-2", "between"), ("101", "between"), ("x", "number"),
                              ("2,inf", "number"), ("2,3,4", "numbers"), ("", "number")):
            self.refuse(2, "--aspect.*" + words, "mesh", "--sites", 5, "--aspect", aspect)


if __name__ == "__main__":
    main()
