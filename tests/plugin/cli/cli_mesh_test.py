"""pcvt mesh: its files, its messages, the input that it accepts, and cancelling."""

import json
import os
import re
import shutil
import signal
import subprocess
import time
import unittest

from support.cli import TIMEOUT, CliTest, main, outputs

EVERY_FORMAT = ("obj", "ply", "glb", "gltf", "om", "svg", "png", "dxf", "html")
REPORT_KEYS = ["version", "dimension", "sites", "lattice", "seed", "solver", "start", "stop", "iterations",
               "evaluations", "hessians", "cg_products", "energy", "energy_bound", "residual",
               "rms_residual", "minimum", "hexagons", "valences", "mirrors", "threads", "seconds", "files"]


class Files(CliTest):
    def test_every_output_of_one_run_is_written(self):
        self.succeed("mesh", "--sites", 30, *outputs(*EVERY_FORMAT, "txt"), "--report", "run.json")
        companions = {"t.mtl", "t.seam.json", "t.txt", "run.json"}
        self.assertEqual(set(self.contents()), {f"t.{e}" for e in EVERY_FORMAT} | companions)

    def test_several_meshes_are_distinguished_by_their_names(self):
        self.succeed("mesh", "--sites", 30, "--mesh", "voronoi", "--mesh", "delaunay", "-o",
                     "a.b.ply", "-o", "s.txt")
        self.assertEqual(set(self.contents()), {"a.b-voronoi.ply", "a.b-delaunay.ply", "s.txt"})

    def test_the_written_sites_are_read_back_to_the_same_mesh(self):
        self.succeed("mesh", "--sites", 30, "-o", "t.ply", "-o", "s.txt")
        self.succeed("mesh", "--input", "s.txt", "--max-iterations", 0, "-o", "again.txt")
        pairs = [[list(map(float, line.split())) for line in self.path(name).read_text().splitlines()
                  if not line.startswith("#")] for name in ("s.txt", "again.txt")]
        self.assertEqual(len(pairs[0]), 30)
        for before, after in zip(*pairs):
            for x, y in zip(before, after):
                self.assertAlmostEqual(x, y, delta=1e-15)

    def test_same_input_gives_same_bytes(self):
        self.path("elsewhere").mkdir()
        run = ("mesh", "--sites", 60, "--seed", 5, "--lattice", "1,0,0.37,0.81", "--mesh", "voronoi",
               "--mesh", "delaunay", *outputs(*EVERY_FORMAT, "txt"), "--report", "run.json", "--force")
        self.succeed(*run)
        first = self.contents()
        self.succeed(*run, cwd=self.path("elsewhere"))
        second = self.contents(self.path("elsewhere"))
        reports = [json.loads(files.pop("run.json")) for files in (first, second)]
        for report in reports:
            del report["seconds"], report["threads"]
        self.assertEqual(reports[0], reports[1])
        self.assertEqual(first.keys(), second.keys())
        self.assertEqual([name for name in first if first[name] != second[name]], [])

    def test_the_number_of_threads_changes_no_byte(self):
        run = ("mesh", "--sites", 60000, "--max-iterations", 6, *outputs("ply", "txt"),
               "--report", "run.json", "--force")
        seen = []
        for threads in (1, 2, 5):
            self.succeed(*run, "--threads", threads)
            files = self.contents()
            report = json.loads(files.pop("run.json"))
            self.assertEqual(report.pop("threads"), threads)
            del report["seconds"]
            seen.append((files, report))
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(seen[0], seen[2])

    def test_several_threads_write_the_files_of_one_and_report_the_first_fault(self):
        run = ("mesh", "--sites", 40, "--period", "1,1.1547005383792515", "--start", "lattice", "--force", "--quiet",
               *outputs("obj", "ply", "glb", "gltf", "om", "svg", "png", "dxf", "html", "vtu", "foam", "nc", "txt"),
               "-o", "u.om", "-o", "u.nc")
        self.succeed(*run, "--threads", 1)
        first = self.contents()
        self.assertGreater(len(first), 20)
        self.succeed(*run, "--threads", 7)
        self.assertEqual(first, self.contents())
        obtuse = ("mesh", "--sites", 40, "--max-iterations", 0, "--threads", 7, "-o", "a.nc", "-o", "b.nc", "-o", "c.ply")
        self.refuse(2, "-o a.nc: .*degrees", *obtuse)
        self.assertEqual(first, self.contents())

    def german(self):
        """Returns an environment in which numbers have a decimal comma."""
        self.path("locales").mkdir()
        made = self.path("locales/de_DE.UTF-8")
        if subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", made], capture_output=True,
                          check=False).returncode != 0:
            self.skipTest("localedef makes no German locale here")
        environment = dict(os.environ, LOCPATH=str(made.parent), LC_ALL="de_DE.UTF-8")
        comma = subprocess.run(["locale", "decimal_point"], env=environment, capture_output=True,
                               check=True)
        self.assertEqual(comma.stdout, b",\n")
        return environment

    @unittest.skipUnless(shutil.which("localedef"), "there is no localedef")
    def test_a_decimal_comma_of_the_locale_changes_no_byte(self):
        environment = self.german()
        written = []
        for folder, options in (("plain", {}), ("german", {"env": environment})):
            self.path(folder).mkdir()
            self.succeed("mesh", "--sites", 60, "--lattice", "1,0,0.37,0.81", *outputs(*EVERY_FORMAT, "txt"),
                         cwd=self.path(folder), **options)
            written.append(self.contents(self.path(folder)))
        self.assertEqual(written[0].keys(), written[1].keys())
        self.assertEqual([name for name in written[0] if written[0][name] != written[1][name]], [])

    def test_force_replaces_existing_files(self):
        self.write("t.obj", "old")
        self.succeed("mesh", "--sites", 3, "-o", "t.obj", "--force")
        self.assertIn(b"\nv ", self.path("t.obj").read_bytes())

    def test_newton_reaches_machine_precision(self):
        for solver in ("lbfgs", "newton"):
            self.succeed("mesh", "--sites", 40, "--solver", solver, "--tolerance", "1e-11",
                         "--strict", "--stability", "--report", "run.json", "--force")
            report = json.loads(self.path("run.json").read_text())
            self.assertEqual((report["solver"], report["minimum"]), (solver, "yes"))
            self.assertLessEqual(report["residual"], 1e-11)
            self.assertGreaterEqual(report["cg_products"], report["hessians"])
            self.assertGreater(report["hessians"], 0)

    def test_a_saddle_is_reported_but_not_for_an_unconverged_run(self):
        grid = [((i + 0.5) / 4, (j + 0.5) / 4) for i in range(4) for j in range(4)]
        self.write("grid.txt", "".join(f"{x} {y}\n" for x, y in grid))
        for options, minimum in (((), "no"), (("--max-iterations", 0, "--tolerance", 1e-30), None)):
            summary = self.succeed("mesh", "--input", "grid.txt", *options, "--stability",
                                   "--report", "run.json", "--force")
            self.assertRegex(summary, f"minimum +{minimum or 'not known'}")
            self.assertEqual(json.loads(self.path("run.json").read_text())["minimum"], minimum)

    def test_the_stability_is_answered_on_request_alone(self):
        summary = self.succeed("mesh", "--sites", 30, "--report", "run.json")
        self.assertNotIn("minimum", summary)
        self.assertIsNone(json.loads(self.path("run.json").read_text())["minimum"])
        self.refuse(2, "at most 10000 sites; leave it out", "mesh", "--sites", 10001, "--stability")
        self.refuse(2, "--stability does not work with --density", "mesh", "--sites", 9, "--stability",
                    "--density", "1 + u")

    def test_a_repeated_tile_is_a_tile_of_the_multiple_periods(self):
        self.succeed("mesh", "--sites", 7, "--repeat", "2x3", "-o", "t.obj", "-o", "s.txt",
                     "--report", "run.json")
        proof = self.succeed("check", "t.obj", "--period", "2,3", "--cvt")
        self.assertRegex(proof, "42 faces.* area 6 ")
        lines = self.path("s.txt").read_text().splitlines()
        self.assertEqual(len([line for line in lines if not line.startswith("#")]), 7)
        report = json.loads(self.path("run.json").read_text())
        self.assertEqual((report["sites"], sum(report["valences"].values())), (7, 7))

    def test_the_tile_and_the_sites_lie_where_the_domain_is(self):
        summary = self.succeed("mesh", "--sites", 400, "--period", "2,1", "-o", "t.ply", "-o", "t.txt")
        self.assertIn("domain     (0, 0) to (2, 1)\n", summary)
        rows = [line for line in self.path("t.txt").read_text().splitlines() if line[0] != "#"]
        for x, y in (map(float, row.split()) for row in rows):
            self.assertTrue(0 <= x < 2 and 0 <= y < 1, (x, y))
        # Whole cells cross the sides of the domain by less than two spacings.
        for x, y in self.ply_vertices("t.ply"):
            self.assertTrue(-0.15 < x < 2.15 and -0.15 < y < 1.15, (x, y))

    def test_the_origin_moves_the_tile(self):
        self.succeed("mesh", "--sites", 50, "-o", "here.ply")
        self.succeed("mesh", "--sites", 50, "--origin", "10,-20", "-o", "there.ply")
        self.succeed("check", "here.ply", "there.ply", "--cvt")
        vertices = self.ply_vertices("there.ply")
        self.assertGreater(len(vertices), 50)
        for x, y in vertices:
            self.assertTrue(9 < x < 12 and -21 < y < -18, (x, y))

    def ply_vertices(self, name):
        head, _, body = self.path(name).read_bytes().partition(b"end_header\n")
        self.assertIn(b"format ascii 1.0\n", head)
        count = int(re.search(rb"element vertex (\d+)", head).group(1))
        return [tuple(map(float, line.split()[:2])) for line in body.splitlines()[:count]]


class Words(CliTest):
    def test_the_summary_describes_the_result(self):
        text = self.succeed("mesh", "--sites", 30, "-o", "t.obj")
        for word in ("sites", "lattice", "converged", "evaluations", "energy", "bound", "residual",
                     "hexagons", "boundary edges in", "t.obj", "t.mtl", "t.seam.json", "seconds"):
            self.assertIn(word, text)

    def test_the_summary_counts_the_sites_outside_of_the_domain(self):
        self.path("s.txt").write_text("0 0\n1 0.5\n1.4 0.7\n-0.3 0.8\n")
        text = self.succeed("mesh", "--input", "s.txt", "--max-iterations", 0)
        self.assertRegex(text, "sites +4; 2 of the file lie outside of the domain and .* lattice\n")
        self.path("far.txt").write_text("0 0\n11 0.5\n14 0.7\n-3.3 8.2\n")
        text = self.succeed("mesh", "--input", "far.txt", "--max-iterations", 0)
        self.assertRegex(text, "sites +4; 3 of .* lattice: --period or --lattice may be wrong; the positions extend over 17.3 x 8.2, "
                               "which takes --period 17.3,8.2 or larger, in the same unit\n")
        # A period may be right, and the positions far away.
        self.path("moved.txt").write_text("5.1 5.2\n5.5 5.5\n5.8 5.1\n")
        text = self.succeed("mesh", "--input", "moved.txt", "--max-iterations", 0)
        self.assertRegex(text, "sites +3; 3 of .* lattice: --period or --lattice may be wrong\n")
        text = self.succeed("mesh", "--input", "s.txt", "--max-iterations", 0, "--period", "2,1",
                            "--origin", "-0.5,0")
        self.assertRegex(text, "sites +4\n")

    def test_the_domain_holds_the_sites_of_files_of_pcvt(self):
        for lattice in ("1,0,5.37,0.81", "1,0,-0.37,0.81", "0.2,3,5,0.1", "1,0,0,0.37,0.81,0,0.2,0.4,0.9",
                        "1,0,0,5.2,1,0,3.1,-2.3,1"):
            basis = ("--lattice", lattice, "--max-iterations", 0)
            self.succeed("mesh", "--sites", 20, *basis, "-o", "own.txt", "--force")
            text = self.succeed("mesh", "--input", "own.txt", *basis)
            self.assertRegex(text, "sites +20\n")

    def test_the_summary_asks_about_coordinates_that_look_like_fractions(self):
        for sites, period in (("0 0\n1 0.5\n0.4 0.7\n0.3 0.8\n", "8.1,8.1"),
                              ("0 0 0\n1 0.5 0.2\n0.4 0.7 0.9\n0.3 0.8 0.1\n", "8.1,8.1,8.1")):
            self.path("s.txt").write_text(sites)
            run = ("mesh", "--input", "s.txt", "--max-iterations", 0, "--period")
            self.assertRegex(self.succeed(*run, period), "sites +4; all coordinates are from 0 to 1, a small part of the domain: ")
            self.assertRegex(self.succeed(*run, period.replace("8.1", "1")), "sites +4\n")
            self.path("s.txt").write_text(sites.replace("0.8", "3"))
            self.assertRegex(self.succeed(*run, period), "sites +4\n")

    def test_quiet_says_nothing(self):
        self.assertEqual(self.succeed("mesh", "--sites", 30, "--quiet", "-o", "t.obj"), "")

    def test_the_report_has_its_keys_in_order(self):
        self.succeed("mesh", "--sites", 30, "--seed", 3, "--period", "2,1", "-o", "t.obj", "--threads", 3,
                     "--report", "run.json")
        report = json.loads(self.path("run.json").read_text())
        self.assertEqual(list(report), REPORT_KEYS)
        self.assertEqual(list(report["seconds"]), ["build", "optimize", "write", "total"])
        self.assertEqual((report["sites"], report["seed"], report["solver"], report["start"]),
                         (30, 3, "lbfgs", "random"))
        self.assertEqual((report["stop"], report["threads"]), ("converged", 3))
        self.assertEqual(report["lattice"], [[2, 0], [0, 1]])
        self.assertEqual(report["files"], ["t.obj", "t.mtl", "t.seam.json"])
        self.assertEqual(sum(report["valences"].values()), 30)
        self.assertEqual(report["valences"].get("6", 0), report["hexagons"])
        self.assertAlmostEqual(report["energy_bound"], 5 * 4 / (18 * 3**0.5 * 30), delta=1e-15)
        self.assertGreaterEqual(report["energy"], report["energy_bound"])
        self.assertLessEqual(report["residual"], 1e-6)

    def test_a_file_may_be_the_start(self):
        self.write("s.txt", "0.1 0.2\n0.6 0.6\n")
        self.succeed("mesh", "--input", "s.txt", "--max-iterations", 0, "--report", "run.json")
        report = json.loads(self.path("run.json").read_text())
        self.assertEqual((report["start"], report["stop"]), ("file", "iteration-limit"))
        self.assertEqual((report["iterations"], report["files"]), (0, []))

    def test_help_shows_examples(self):
        self.assertIn("pcvt mesh --sites", self.succeed("--help"))
        self.assertIn("pcvt mesh --input", self.succeed("mesh", "--help"))
        self.assertIn("pcvt check tile.obj", self.succeed("check", "--help"))
        for option in ("--seed", "--period", "--lattice", "--tolerance", "--strict", "--repeat"):
            self.assertIn(option, self.succeed("mesh", "--help"))
        self.assertRegex(self.succeed("--version"), r"^pcvt \d+\.\d+\.\d+\n$")

    def test_strict_writes_the_files_and_ends_with_5(self):
        done = self.run_pcvt("mesh", "--sites", 300, "--max-iterations", 3, "--strict", "-o", "t.ply")
        self.assertEqual(done.returncode, 5)
        self.assertRegex(done.stderr.decode(), r"^pcvt: not converged .*iteration-limit.*\n$")
        self.succeed("check", "t.ply")
        self.succeed("mesh", "--sites", 30, "--strict")
        self.succeed("mesh", "--sites", 300, "--max-iterations", 3)


class AcceptedSites(CliTest):
    def tile_of(self, text, **options):
        self.write("s.txt", text)
        self.succeed("mesh", "--input", "s.txt", "-o", "t.ply", "--force", **options)
        return self.path("t.ply").read_bytes()

    def test_unusual_but_valid_texts_give_the_same_sites(self):
        plain = self.tile_of("0 0\n0.5 0.25\n0.25 0.75\n")
        odd = {
            "CRLF": "0 0\r\n0.5 0.25\r\n0.25 0.75\r\n",
            "byte order mark": b"\xef\xbb\xbf0 0\n0.5 0.25\n0.25 0.75\n",
            "comments": "# sites\n0 0 # first\n\n0.5 0.25\n   # more\n0.25 0.75\n",
            "tabs": "\t0\t0\n 0.5 \t 0.25 \n0.25\t0.75\n",
            "no final newline": "0 0\n0.5 0.25\n0.25 0.75",
            "negative zero": "-0.0 -0\n0.5 0.25\n0.25 0.75\n",
            "other spellings": "0e0 +0\n5e-1 .25\n0.250 7.5E-1\n",
        }
        for name, text in odd.items():
            with self.subTest(name):
                self.assertEqual(self.tile_of(text), plain)

    def test_sites_outside_of_the_domain_are_wrapped(self):
        self.tile_of("3 -7\n-0.5 0.25\n1000.25 -99.25\n")
        self.succeed("check", "t.ply", "--cvt")

    def test_standard_input_serves_as_a_file(self):
        plain = self.tile_of("0 0\n0.5 0.25\n")
        self.succeed("mesh", "--input", "-", "-o", "piped.ply", input=b"0 0\n0.5 0.25\n")
        self.assertEqual(self.path("piped.ply").read_bytes(), plain)


class Cancelling(CliTest):
    def cancel(self, number):
        # The tolerance is below the rounding error of the residual, so the run takes much longer.
        run = subprocess.Popen(
            [self.binary(), "mesh", "--sites", "20000", "--solver", "lloyd", "--tolerance", "1e-20",
             "--max-iterations", "1000000000", "-o", "t.obj"],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(1)
        run.send_signal(number)
        out, err = run.communicate(timeout=TIMEOUT)
        self.assertEqual((run.returncode, out), (128 + number, b""))
        self.assertRegex(err.decode(), r"^pcvt: cancelled.*\n$")
        self.assertEqual(self.contents(), {})

    def test_ctrl_c_leaves_nothing(self):
        self.cancel(signal.SIGINT)

    def test_sigterm_leaves_nothing(self):
        self.cancel(signal.SIGTERM)


if __name__ == "__main__":
    main()
