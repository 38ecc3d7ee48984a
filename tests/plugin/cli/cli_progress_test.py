"""The status line on a terminal: its phases, its width, how often it changes, and Ctrl-C in each phase."""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import termios
import time

from support.cli import TIMEOUT, CliTest, main

LLOYD = ("mesh", "--sites", "40000", "--solver", "lloyd", "--tolerance", "1e-9", "--max-iterations",
         "1500", "--threads", "1")
LARGE = ("mesh", "--sites", "100000", "--mesh", "voronoi", "--mesh", "delaunay", "-o", "big.ply", "-o",
         "sites.txt")
PHASES = ("placing the sites", "optimising", "building", "proving", "writing")


class Terminal(CliTest):
    def start(self, run, columns):
        """Starts a run whose standard error is a terminal."""
        master, slave = pty.openpty()
        self.addCleanup(os.close, master)
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        started = subprocess.Popen([self.binary(), *run], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        return started, master

    def drawings(self, master):
        """Yields the time and the text of each drawing of the line."""
        pending = ""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError:
                break
            if not part:
                break
            *complete, pending = (pending + part.decode()).split("\r")
            for line in complete:
                yield time.monotonic(), line
        yield time.monotonic(), pending

    def on_a_terminal(self, run, *more, columns=80):
        """Returns the seconds and the drawings of a whole run."""
        began = time.monotonic()
        started, master = self.start((*run, *more), columns)
        shown = [(at - began, line) for at, line in self.drawings(master)]
        self.assertEqual(started.wait(TIMEOUT), 0)
        return shown


class Line(Terminal):
    def test_it_shows_the_optimisation_and_is_cleared(self):
        lines = [line for _, line in self.on_a_terminal(LLOYD)]
        self.assertRegex("\n".join(lines), r"\noptimising \d+ %  \d+ s left  iteration \d+  residual "
                         r"\de-\d+  energy/bound 1\.\d+")
        self.assertRegex(lines[-2], r"^ +$")
        self.assertEqual(lines[-1], "")
        self.assertLess(max(map(len, lines)), 80)

    def test_a_search_shows_its_lowest_energy_and_its_budget(self):
        lines = [line for _, line in self.on_a_terminal(("mesh", "--sites", "150", "--start", "best"))]
        self.assertRegex("\n".join(lines), r"\nsearching \d+ %  start \d+  lowest energy/bound 1\.\d+")
        self.assertLess(max(map(len, lines)), 80)

    def test_quiet_shows_none(self):
        self.assertEqual([line for _, line in self.on_a_terminal(LLOYD, "--quiet")], [""])

    def test_it_is_not_shown_elsewhere(self):
        self.succeed(*LLOYD)


class LargeRun(Terminal):
    def test_no_line_is_wider_than_a_terminal_of_40_columns(self):
        shown = self.on_a_terminal(LARGE, "--force", columns=40)
        self.assertLessEqual(max(len(line) for _, line in shown), 39)
        text = "\n".join(line for _, line in shown)
        for phase in PHASES:
            self.assertIn("\n" + phase, text)
        self.assertRegex(text, r"\nwriting big-\w+\.ply, [12] of 3 \d+ %")

    def test_a_phase_that_lasts_less_than_the_time_between_two_drawings_is_shown(self):
        shown = self.on_a_terminal(("mesh", "--sites", "40000", "--tolerance", "1e-3", "-o", "small.ply"))
        drawn = [line for _, line in shown]
        first = next(at for at, line in enumerate(drawn) if line.strip())
        for phase in PHASES[2:]:
            self.assertTrue(any(line.startswith(phase) for line in drawn[first:]), (phase, drawn))

    def test_no_third_of_the_run_passes_without_a_change(self):
        shown = self.on_a_terminal(LARGE)
        total = shown[-1][0]
        changes = [0.0]
        last = ""
        for at, line in shown:
            if line != last:
                changes.append(at)
                last = line
        pauses = [(after - before) / total for before, after in zip(changes, changes[1:])]
        self.assertLess(max(pauses), 1 / 3, (total, shown))


class Cancelling(Terminal):
    def interrupt(self, phase):
        """Sends SIGINT once the line shows the phase; returns the exit code and the last drawings."""
        started, master = self.start(LARGE, 80)
        for _, line in self.drawings(master):
            if line.startswith(phase):
                started.send_signal(signal.SIGINT)
                break
        rest = "".join(line for _, line in self.drawings(master))
        return started.wait(TIMEOUT), rest

    def test_ctrl_c_leaves_nothing_in_any_phase(self):
        for phase in PHASES:
            with self.subTest(phase):
                # On a busy machine the signal may come after the end of a run, which is complete then.
                for _ in range(5):
                    code, rest = self.interrupt(phase)
                    if code != 0:
                        break
                    for file in [*self.folder.iterdir()]:
                        file.unlink()
                self.assertEqual(code, 130, rest)
                self.assertTrue(re.search(r"pcvt: cancelled; nothing was written\n$", rest), rest)
                self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
