"""Studies by the Python package, beside those of the command."""

import csv
import os
import signal
import threading
import unittest

from support.cli import CliTest, main
from support.python_package import pcvt

import numpy as np


def rows_of(file):
    lines = file.read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


class Studies(CliTest):
    def test_the_files_and_the_text_are_those_of_the_command(self):
        for name, sites in (("fig11", [4, 6]), ("sizes", [30]), ("fig9", [12])):
            options = ("--sites", ",".join(map(str, sites)), "--runs", 3, "--seed", 5)
            printed = self.succeed("study", name, *options, "-o", "command/")
            study = pcvt.study(name, sites, 3, 5, path=f"{self.path('python')}/")
            self.assertEqual(str(study), printed)
        self.assertEqual(self.contents(self.path("python")), self.contents(self.path("command")))

    def test_tables_hold_the_cells_of_their_files(self):
        study = pcvt.study("fig11", [4, 6], runs=3, path=self.path("t.csv"))
        self.assertEqual(list(study.tables), ["fig11", "fig11-patterns", "fig11-runs"])
        for name, table in study.tables.items():
            rows = rows_of(self.path(name.replace("fig11", "t") + ".csv"))
            self.assertEqual(len(table), len(rows))
            for column in table.dtype.names:
                cells = [row[column] for row in rows]
                self.assertEqual([type(x)(cell) for x, cell in zip(table[column], cells)], list(table[column]))
        self.assertIs(study.table, study.tables["fig11"])
        self.assertIs(study.runs, study.tables["fig11-runs"])
        self.assertEqual([study.runs.dtype[name] for name in ("n", "energy")], [np.int64, np.float64])
        self.assertEqual(study.runs.dtype["stop"].kind, "U")
        self.assertEqual(study.notes["fig11"][0], f"pcvt {pcvt.__version__}: study fig11 --sites 4,6 --runs 3 --seed 0")

    def test_missing_cells_are_not_a_number(self):
        table = pcvt.study("table1", [9], runs=1).table
        self.assertTrue(np.isnan(table["paper_CVT"]).all())
        self.assertEqual(table["n"].tolist(), [9])

    def test_pictures_are_those_of_the_files(self):
        study = pcvt.study("fig11", 4, runs=2, path=self.path("t.svg"))
        self.assertEqual(list(study.pictures), ["fig11", "fig11-shares"])
        self.assertEqual(study.pictures["fig11-shares"], self.path("t-shares.svg").read_text(encoding="utf-8"))
        self.assertEqual(study._repr_svg_(), self.path("t.svg").read_text(encoding="utf-8"))
        self.assertIsNone(pcvt.study("table1", 9, runs=1)._repr_svg_())

    def test_the_tables_do_not_depend_on_the_threads(self):
        one, two = (pcvt.study("fig11", [5, 7], runs=20, threads=n).runs for n in (1, 2))
        self.assertEqual(one.tobytes(), two.tobytes())

    def test_what_cannot_be_made_raises(self):
        self.write("t.csv", "")
        for kind, words, name, arguments in (
                (pcvt.ArgumentError, "unknown; take one of", "paper", {}),
                (pcvt.ArgumentError, "given twice", "fig11", {"sites": [4, 4]}),
                (pcvt.ArgumentError, "no number of sites", "fig11", {"sites": []}),
                (pcvt.ArgumentError, "runs is below 1", "fig11", {"runs": 0}),
                (pcvt.ArgumentError, "out of range", "fig11", {"runs": 2**40}),
                (pcvt.ArgumentError, "out of range", "fig11", {"seed": -1}),
                (pcvt.ArgumentError, "n_threads is not between", "fig11", {"threads": -1}),
                (pcvt.LimitError, "too many for study fig11", "fig11", {"sites": 2**40}),
                (TypeError, "integer", "fig11", {"sites": [4.5]}),
                (pcvt.ArgumentError, "t.txt: neither .csv", "fig11", {"path": "t.txt"}),
                (pcvt.ArgumentError, "table1 has no picture", "table1", {"path": "t.svg"}),
                (pcvt.OutputError, "t.csv.*set replace", "fig11", {"path": self.path("t.csv")})):
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                pcvt.study(name, **arguments)
        pcvt.study("fig11", 4, runs=1, path=self.path("t.csv"), replace=True)
        self.assertGreater(self.path("t.csv").stat().st_size, 0)

    def test_progress_counts_the_runs_and_cancels_without_files(self):
        seen = []
        pcvt.study("fig11", 4, runs=7, progress=seen.append, path=self.path("t.csv"))
        self.assertIn("7 of 7 runs", [progress.phase_text for progress in seen])
        self.assertEqual([progress.phase for progress in (seen[0], seen[-1])], ["optimise", "write"])
        self.assertRegex(repr(seen[0]), "^<pcvt.Progress: [^,]*, 0%>$")
        calls = []
        with self.assertRaises(pcvt.Cancelled):
            pcvt.study("fig11", 30, runs=10**6, path=self.path("none.csv"),
                       progress=lambda progress: calls.append(0) or len(calls) > 4)
        self.assertEqual(len(calls), 5)
        self.assertFalse(self.path("none.csv").exists())

    def test_an_interrupt_ends_a_study(self):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        self.addCleanup(timer.join)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            pcvt.study("fig11", 30, runs=10**6)

    def test_each_study_is_one_line_with_its_figures(self):
        self.assertEqual(repr(pcvt.study("fig11", [4, 6], runs=3)),
                         "<pcvt.StudyResult: fig11, 6 runs, 3 tables, 2 pictures>")
        self.assertEqual(repr(pcvt.study("table1", 9, runs=1)), "<pcvt.StudyResult: table1, 1 run, 2 tables, 0 pictures>")


if __name__ == "__main__":
    main()
