"""--start best, and samples/best_energies, which uses it to compute a table."""

import csv
import json
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from support.cli import TIMEOUT, CliTest, main

SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"
BELOW_THE_LATTICE = (7, 10, 13, 17, 19, 21, 22, 26, 27, 29, 31)


class Best(CliTest):
    def best(self, *arguments):
        self.succeed("mesh", *arguments, "--start", "best", "--report", "run.json", "--force",
                     "--quiet")
        return json.loads(self.path("run.json").read_text())

    def test_it_finds_energies_below_the_lattice_and_reports_their_origin(self):
        report = self.best("--sites", 31, "--budget", 3000, "-o", "t.ply")
        self.assertLess(report["energy"], report["pattern"]["energy"] * 0.98)
        self.assertEqual((report["start"], report["stop"]), ("best", "converged"))
        self.assertGreaterEqual(report["evaluations"], 3000)
        self.assertRegex(report["found"], "lattice of|random sites")
        self.succeed("check", "t.ply", "--cvt")
        self.assertRegex(self.succeed("mesh", "--sites", 7, "--start", "best"), r"\nfound +\w")

    def test_it_returns_the_lattice_where_no_lower_state_exists(self):
        report = self.best("--sites", 15)
        self.assertEqual(report["found"], "lattice of 15")
        self.assertEqual(report["hexagons"], 15)

    def test_the_number_of_threads_changes_no_byte(self):
        seen = []
        for threads in (1, 2, 5):
            report = self.best("--sites", 44, "--budget", 8000, "--seed", 3, "--lattice",
                               "1,0,0.37,0.81", "-o", "t.txt", "-o", "t.ply", "--threads", threads)
            del report["threads"], report["seconds"]
            seen.append((report, self.path("t.txt").read_bytes(), self.path("t.ply").read_bytes()))
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(seen[0], seen[2])

    def test_a_budget_without_a_search_or_without_a_number_is_refused(self):
        self.refuse(2, "--budget is for --start best; leave it out", "mesh", "--sites", 3, "--budget",
                    100)
        for budget in ("0", "-1", "1.5", "many"):
            self.refuse(2, "--budget " + budget, "mesh", "--sites", 3, "--start", "best", "--budget",
                        budget)

    def test_ctrl_c_during_the_search_leaves_nothing(self):
        run = subprocess.Popen(
            [self.binary(), "mesh", "--sites", "5000", "--start", "best", "--budget", "2000000000",
             "-o", "t.obj"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(1)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.communicate(timeout=TIMEOUT)[0], b"")
        self.assertEqual(run.returncode, 130)
        self.assertEqual(self.contents(), {})


class Table(CliTest):
    def make(self, output, *arguments):
        subprocess.run([sys.executable, "-B", SAMPLES / "best_energies", "--pcvt", self.binary(),
                        "--sites", "7-8", "--output", self.path(output), *arguments], check=True)
        return self.path(output).read_bytes()

    def test_an_interrupted_table_becomes_the_uninterrupted_one(self):
        self.make("interrupted.csv", "--passes", "1")
        self.assertEqual(self.make("interrupted.csv", "--passes", "2"),
                         self.make("whole.csv", "--passes", "2"))

    def test_the_committed_table_is_complete_and_goes_below_the_lattices(self):
        with open(SAMPLES / "best_energies.csv", newline="", encoding="ascii") as file:
            rows = {int(row["n"]): row for row in csv.DictReader(file)}
        self.assertEqual(list(rows), list(range(1, 401)))
        for n, row in rows.items():
            bound = 5 / (18 * 3**0.5 * n)
            self.assertAlmostEqual(float(row["energy"]) / bound, float(row["ratio_to_bound"]),
                                   delta=1e-9)
            self.assertGreaterEqual(float(row["ratio_to_bound"]), 1)
            self.assertLessEqual(float(row["ratio_to_best_lattice"]), 1)
        below = [n for n in rows if float(rows[n]["ratio_to_best_lattice"]) < 1 - 1e-6]
        self.assertEqual([n for n in below if n <= 31], list(BELOW_THE_LATTICE))
        self.assertGreaterEqual(len(below), 177)
        self.assertEqual(len([n for n in below if 100 <= n < 200]), 43)


if __name__ == "__main__":
    main()
