"""pcvt study: tables and pictures, shards and merging, refusals and cancelling."""

import collections
import csv
import io
import json
import os
import pty
import re
import signal
import subprocess
import time
import xml.etree.ElementTree

from support.cli import TIMEOUT, CliTest, main

SMALL = ("fig11", "--sites", "4,5,11", "--runs", 9, "--seed", 2)


class Help(CliTest):
    def test_every_study_has_a_line_of_its_name_and_one_of_its_defaults(self):
        text = self.succeed("study", "--help")
        refusal = self.run_pcvt("study").stderr.decode()
        self.assertIn("no study; take one of ", refusal)
        studies = refusal.strip().split("take one of ")[1].split(", ")
        self.assertIn("gersho3d", studies)
        for name in studies:
            self.assertRegex(
                text, rf"(?m)^  {name}  +[^ ].+\n +[0-9,.]+; \d+, seed \d+$")


class Files(CliTest):
    def table(self, name):
        lines = self.path(name).read_text().splitlines(keepends=True)
        return list(csv.DictReader(io.StringIO("".join(l for l in lines if not l.startswith("#")))))

    def test_a_folder_gets_all_tables_and_pictures(self):
        self.path("r").mkdir()
        self.succeed("study", *SMALL, "-o", "r")
        self.assertEqual(
            set(self.contents()), {
                f"r/fig11{end}"
                for end in (".csv", "-patterns.csv", "-runs.csv", ".svg", "-shares.svg", ".html")
            })
        for name in ("r/fig11.svg", "r/fig11-shares.svg"):
            xml.etree.ElementTree.fromstring(self.path(name).read_bytes())
        shares = {row["n"]: row["percent"] for row in self.table("r/fig11.csv")}
        self.assertEqual((shares["4"], shares["5"]), ("100", "0"))
        self.assertIn("--sites 4,5,11 --runs 9 --seed 2", self.path("r/fig11.csv").read_text())

    def test_a_missing_folder_is_made(self):
        self.succeed("study", "table1", "--sites", 3, "--runs", 2, "-o", "results/today/")
        self.assertEqual(set(self.contents()), {"results/today/table1.csv",
                                                "results/today/table1-runs.csv",
                                                "results/today/table1.html"})

    def test_the_examples_of_the_help_work(self):
        lines = [line.split()[1:] for line in self.succeed("study", "--help").splitlines()
                 if line.startswith("  pcvt ")]
        self.assertEqual(len(lines), 5)
        parts = [["study", "fig11", "--shard", f"{k}/4", "-o", f"part{k}.csv"] for k in (1, 3, 4)]
        for line in parts + lines:
            # The defaults would take minutes.
            short = ["--runs", "6"] if "--runs" not in line and "--merge" not in line else []
            self.succeed(*line, *short, *(["--force"] if "--merge" in line else []))
        self.assertIn("results/fig11.html", self.contents())
        self.assertIn("mine-patterns.csv", self.contents())

    def test_a_page_is_written_alone_or_in_a_folder(self):
        self.succeed("study", "fig9", "--sites", 20, "-o", "f.html", "-o", "r/")
        self.assertEqual(set(self.contents()), {
            "f.html", *(f"r/fig9{end}" for end in (".csv", "-runs.csv", ".svg", "-excess.svg",
                                                   ".html"))})
        page = self.path("f.html").read_text()
        self.assertEqual(page, self.path("r/fig9.html").read_text())
        addresses = set(re.findall(r"https?://[^\"']+", page))
        self.assertEqual(addresses, {"http://www.w3.org/2000/svg"})
        data = json.loads(re.search(r'id="data">([^<]*)<', page)[1])
        self.assertEqual(data["csv"]["fig9"], self.path("r/fig9.csv").read_text())
        energies = [point[3] for point in data["points"]["fig9"][1]["points"]]
        self.assertEqual(energies, [float(row["energy"]) for row in self.table("r/fig9-runs.csv")
                                    if row["method"] == "periodic"])

    def test_a_run_of_the_table_agrees_with_pcvt_mesh(self):
        self.succeed("study", "fig11", "--sites", 11, "--runs", 3, "--seed", 40, "-o", "t.csv")
        last = self.table("t-runs.csv")[-1]
        self.assertEqual((last["run"], last["seed"]), ("2", "42"))
        said = self.succeed("mesh", "--sites", 11, "--seed", 42, "--tolerance", "1e-8")
        self.assertIn(f"{float(last['energy']):.5g}"[:6], said)

    def test_the_command_in_a_table_makes_the_runs_of_the_table(self):
        for study, n, options in (("gersho3d", 5, {}), ("symmetry", 48, {"GROUP": "p4m"}), ("fig11", 11, {}), ("fig10", 1000, {}),
                                  ("sizes", 60, {"LAW": "gamma:0.3"}), ("sizes3d", 60, {"LAW": "lognormal:0.35"})):
            self.succeed("study", study, "--sites", n, "--runs", 2, "--seed", 7, "-o", f"{study}.csv", "--quiet")
            head = self.path(f"{study}-runs.csv").read_text()
            command = re.search(r"^# run r starts from .*\(pcvt (.*)\)$", head, re.M)[1].split()
            row = self.table(f"{study}-runs.csv")[-1]
            given = {"n": n, "s": row["seed"], **options}
            self.succeed(*(given.get(word, word) for word in command), "--report", "r.json", "--force", "--quiet",
                         *(("--max-iterations", 0) if study == "fig10" else ()))
            report = json.loads(self.path("r.json").read_text())
            self.assertEqual(report["start"], "random")
            if study == "gersho3d":
                self.assertEqual((report["energy"], report["lattice"]),
                                 (float(row["energy"]), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
            if study.startswith("sizes"):
                self.succeed(*(given.get(word, word) for word in command), "--cells", "c.csv", "--force", "--quiet")
                diameters = [float(cell["diameter"]) for cell in self.table("c.csv")]
                counts = collections.Counter(round(60 * d / sum(diameters) * 10) for d in diameters)
                reached = {round(float(r["diameter"]) * 10): int(r["reached"]) for r in self.table(f"{study}-runs.csv")
                           if (r["law"], r["run"]) == (options["LAW"], "1")}
                self.assertEqual({k: n for k, n in reached.items() if n > 0}, dict(counts))
            if study == "sizes3d":
                row = next(r for r in self.table("sizes3d-runs.csv") if (r["law"], r["run"]) == (options["LAW"], "1"))
                self.assertAlmostEqual(float(row["sphericity"]), report["volumes"]["sphericity_mean"], 4)
            if study == "symmetry":
                rows = [r for r in self.table("symmetry-runs.csv") if (r["group"], r["sites_at"]) == ("p4m", "general")]
                self.assertAlmostEqual(report["energy"] / report["energy_bound"], float(rows[-1]["energy/bound"]), 6)

    def test_table1_prints_its_columns(self):
        said = self.succeed("study", "table1", "--sites", "3,30", "--runs", 12)
        self.assertRegex(said, r"n +F_CVT +F_PCVT +F_hex")
        self.assertRegex(said, r"\n *30 +0\.0055\d+ +0\.0053481481 ")
        self.assertIn("5.3453e-3 for n = 30", said)
        self.assertEqual(self.contents(), {})

    def test_every_study_runs_and_draws(self):
        for name in ("fig7", "fig8", "fig9", "fig10", "sizes", "sizes3d", "symmetry"):
            with self.subTest(name):
                said = self.succeed("study", name, "--sites", "20,120", "--runs", 1, "-o",
                                    f"{name}.csv", "-o", f"{name}.svg")
                self.assertRegex(said, "120")
                xml.etree.ElementTree.fromstring(self.path(f"{name}.svg").read_bytes())
                self.assertGreaterEqual(len(self.table(f"{name}.csv")), 2)

    def test_random_starts_in_the_cube_find_the_known_optima(self):
        self.succeed("study", "gersho3d", "--sites", "1,2,4,8,16,5", "--runs", 12, "-o", "t.csv", "-o", "t.svg", "--quiet")
        rows = {int(row["n"]): row for row in self.table("t.csv")}
        for n, best, lattice, winner in ((1, 1.0609861, 1.0609861, "equal"), (2, 1, 1, "equal"), (4, 1.0025691, 1.0025691, "equal"),
                                         (5, 1.0508204, 1.0942085, "random"), (8, 1.0024454, 1.0105617, "random"),
                                         (16, 1, 1, "equal")):
            self.assertAlmostEqual(float(rows[n]["best"]), best, 6)
            self.assertAlmostEqual(float(rows[n]["lattice"]), lattice, 6)
            self.assertEqual(rows[n]["winner"], winner)
            self.assertGreaterEqual(float(rows[n]["mean"]), best - 1e-6)
        self.assertIn("No result lies below the body-centred cubic lattice", self.path("t.csv").read_text())
        xml.etree.ElementTree.fromstring(self.path("t.svg").read_bytes())

    def test_grains_in_space_are_as_round_as_grown_ones(self):
        self.succeed("study", "sizes3d", "--sites", "1000", "--runs", 1, "-o", "t.csv", "--quiet")
        rows = {row["law"]: row for row in self.table("t.csv")}
        self.assertEqual(len(rows), 4)
        for row in rows.values():
            self.assertLessEqual(float(row["largest_error"]), 1e-10)
            self.assertEqual(float(row["largest_difference"]), 0)
        self.assertAlmostEqual(1 - float(rows["lognormal:0.35"]["sphericity"]), 0.144, delta=0.006)
        self.assertAlmostEqual(float(rows["lognormal:0.35"]["spread_wanted"]), 0.35, delta=0.03)
        self.assertGreater(float(rows["equal"]["sphericity"]), float(rows["gamma:0.42"]["sphericity"]))

    def test_quiet_says_nothing(self):
        self.assertEqual(self.succeed("study", *SMALL, "--quiet"), "")


class Shards(CliTest):
    def test_merged_shards_give_the_unsplit_bytes(self):
        for folder in ("whole", "merged"):
            self.path(folder).mkdir()
        said = self.succeed("study", *SMALL, "--threads", 2, "-o", "whole")
        for k in (1, 2, 3):
            self.assertEqual(
                self.succeed("study", *SMALL, "--threads", 1, "--shard", f"{k}/3", "-o",
                             f"p{k}.csv"), "")
        merged = self.succeed("study", "fig11", "--merge", "p2.csv", "p1.csv", "p3.csv", "-o",
                              "merged")
        self.assertEqual(merged, said)
        self.assertEqual(self.contents(self.path("merged")), self.contents(self.path("whole")))

    def test_a_wrong_set_of_shards_is_refused(self):
        for k in (1, 2):
            self.succeed("study", *SMALL, "--shard", f"{k}/2", "-o", f"p{k}.csv")
        self.write("noise.csv", "a,b\n1,2\n")
        self.write("bytes.csv", b"\0\1")
        merge = ("study", "fig11", "--merge")
        self.refuse(2, "run 1 of 4 sites is in no file; give", *merge, "p1.csv")
        self.refuse(2, "^p1.csv: .*another file too", *merge, "p1.csv", "p2.csv", "p1.csv")
        self.refuse(2, "^noise.csv: ", *merge, "noise.csv")
        self.refuse(2, "^bytes.csv:1: ", *merge, "bytes.csv")
        self.refuse(2, "^missing.csv: ", *merge, "missing.csv")
        self.refuse(2, "^p1.csv: runs of fig11", "study", "fig9", "--merge", "p1.csv", "p2.csv")
        self.refuse(2, "an input", *merge, "p1.csv", "p2.csv", "--force", "-o", "p1.csv")
        self.refuse(2, "--runs.*--merge", *merge, "p1.csv", "p2.csv", "--runs", 9)

    def test_a_damaged_shard_is_refused(self):
        self.succeed("study", *SMALL, "--shard", "1/2", "-o", "p1.csv")
        self.succeed("study", *SMALL, "--shard", "2/2", "-o", "p2.csv")
        text = self.path("p2.csv").read_text()
        for damage in (text[:-30], text.replace("4,1,3,", "4,x,3,"), text.replace("--runs 9", "--runs x"),
                       text.replace(",energy,", ",power,")):
            self.assertNotEqual(damage, text)
            self.write("p2.csv", damage)
            self.refuse(2, "p2.csv|is in no file", "study", "fig11", "--merge", "p1.csv", "p2.csv")


class BadInput(CliTest):
    def test_impossible_studies_are_refused(self):
        for code, pattern, arguments in (
            (2, "no study", ()),
            (2, "fig12.*unknown; take one of table1 fig7", ("fig12", )),
            (2, "--sites", ("fig11", "--sites", "4,,5")),
            (2, "--sites", ("fig11", "--sites", "0")),
            (2, "--sites", ("fig11", "--sites", "4;5")),
            (2, "twice", ("fig11", "--sites", "4,4")),
            (4, "too many", ("fig11", "--sites", "100000")),
            (2, "--runs", ("fig11", "--runs", "0")),
            (2, "--seed", ("fig11", "--seed", "-1")),
            (2, "--shard", ("fig11", "--shard", "5/4", "-o", "a.csv")),
            (2, "--shard", ("fig11", "--shard", "2", "-o", "a.csv")),
            (2, "--shard.*give -o", ("fig11", "--shard", "1/4")),
            (2, "no picture", ("fig11", "--shard", "1/4", "-o", "a.svg")),
            (2, "no picture", ("fig11", "--shard", "1/4", "-o", "a.html")),
            (2, "neither .csv, .svg nor .html", ("fig11", "-o", "a.txt")),
            (3, "/dev/null/t.csv", ("fig11", "-o", "/dev/null/t.csv")),
        ):
            with self.subTest(arguments):
                self.refuse(code, pattern, "study", *arguments, timeout=20)

    def test_an_existing_output_is_refused_before_any_run(self):
        self.write("t-patterns.csv", "precious")
        self.refuse(3, "t-patterns.csv.*--force", "study", "fig11", "-o", "t.csv", timeout=10)
        self.succeed("study", *SMALL, "-o", "t.csv", "--force")
        self.assertNotEqual(self.path("t-patterns.csv").read_text(), "precious")


class Running(CliTest):
    LONG = ("study", "fig11", "--sites", "150", "--runs", "1000000", "--threads", "1", "-o", "new/t.csv")

    def test_a_signal_leaves_nothing(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number):
                run = subprocess.Popen([self.binary(), *self.LONG], cwd=self.folder,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                time.sleep(0.5)
                run.send_signal(number)
                out, err = run.communicate(timeout=TIMEOUT)
                self.assertEqual((run.returncode, out), (code, b""))
                self.assertRegex(err.decode(), r"^pcvt: cancelled.*\n$")
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_progress_is_shown_on_a_terminal(self):
        master, slave = pty.openpty()
        with subprocess.Popen([self.binary(), *self.LONG], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=slave) as run:
            os.close(slave)
            shown = os.read(master, 4096).decode()
            run.send_signal(signal.SIGINT)
            self.assertEqual(run.wait(TIMEOUT), 130)
        os.close(master)
        self.assertRegex(shown, r"^\r\d+ of 1000000 runs")


if __name__ == "__main__":
    main()
