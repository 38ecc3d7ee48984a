"""Outputs: names, pipes, runs that were killed, runs side by side."""

import fcntl
import os
import shutil
import signal
import statistics
import subprocess
import time

from support.cli import CliTest, main

MESH = ("mesh", "--sites", "20", "--seed", "3", "--threads", "1", "--quiet")


class Outputs(CliTest):
    def test_names_with_blanks_are_written(self):
        for period in ("1,1", "1,1,1"):
            self.succeed("mesh", "--sites", 20, "--period", period, "--tolerance", "1e-2", "-o", "my tile.obj", "-o", "my tile.ply",
                         "--force")
            self.succeed("check", "my tile.obj", "my tile.ply")
            # mtllib lists names with blanks between them.
            self.assertIn("\nmtllib my_tile.mtl\n", self.path("my tile.obj").read_text())
            self.assertIn("newmtl", self.path("my_tile.mtl").read_text())

    def test_names_with_control_characters_are_refused(self):
        for name in ("a\nb.obj", "a\tb.svg", "\x1b[2J.ply", "x\x7f.glb", "d\n/a.txt", "a\rb.foam"):
            with self.subTest(name):
                self.refuse(2, "control character; choose another name", *MESH, "-o", name)
        self.refuse(2, "control character", *MESH, "-o", "a.obj", "--report", "r\n.json")
        self.refuse(2, "control character", "study", "fig11", "--sites", "6", "--runs", "1", "-o", "a\n.csv")

    def run_into_closed_pipe(self, *arguments):
        reader, writer = os.pipe()
        os.close(reader)
        with os.fdopen(writer, "wb") as pipe:
            done = subprocess.run([self.binary(), *arguments], cwd=self.folder, stdout=pipe,
                                  stderr=subprocess.PIPE, check=False)
        return done.returncode, done.stderr.decode()

    def test_a_closed_pipe_changes_no_exit_code(self):
        tile = ("mesh", "--sites", "20", "-o", "t.ply", "-o", "t.obj")
        self.assertEqual(self.run_into_closed_pipe(*tile), (0, ""))
        self.succeed("check", "t.ply", "t.obj")
        for arguments in (("check", "t.ply", "t.obj"), ("mesh", "--sites", "20"), ("mesh", "--help"),
                          ("study", "fig11", "--sites", "6", "--runs", "1", "-o", "a.csv")):
            with self.subTest(arguments):
                self.assertEqual(self.run_into_closed_pipe(*arguments), (0, ""))
        self.write("bad.ply", "ply\n")
        self.assertEqual(self.run_into_closed_pipe("check", "t.ply", "bad.ply")[0], 2)

    def test_no_output_goes_into_a_file_when_the_standard_streams_are_closed(self):
        self.succeed(*MESH, "-o", "expected.ply")
        shell = ["sh", "-c", 'exec "$0" "$@" <&- >&- 2>&-', self.binary(), *MESH[:-1]]
        done = subprocess.run([*shell, "-o", "t.ply"], cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertEqual(self.path("t.ply").read_bytes(), self.path("expected.ply").read_bytes())

    def test_the_next_run_removes_what_a_killed_run_has_staged(self):
        run = subprocess.Popen([self.binary(), "mesh", "--sites", "300000", "--max-iterations", "0",
                                "--quiet", "-o", "a.obj", "-o", "new/a.ply"], cwd=self.folder)
        limit = time.monotonic() + 120
        while not list(self.folder.glob(".a.*")) and run.poll() is None and time.monotonic() < limit:
            time.sleep(0.005)
        run.send_signal(signal.SIGKILL)
        run.wait()
        left = [p.name for p in self.folder.iterdir()]
        self.assertTrue(any(name.startswith(".pcvt-") for name in left), left)
        self.succeed(*MESH, "-o", "b.txt")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["b.txt"])

    def test_runs_side_by_side_do_not_disturb_each_other(self):
        runs = [subprocess.Popen([self.binary(), *MESH, "-o", f"{k}.obj", "-o", f"out/{k}.glb"],
                                 cwd=self.folder, stderr=subprocess.PIPE) for k in range(12)]
        for run in runs:
            self.assertEqual((run.communicate()[1], run.returncode), (b"", 0))
        names = {str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file()}
        self.assertEqual(names, {f"{k}.{e}" for k in range(12) for e in ("obj", "mtl", "seam.json")}
                         | {f"out/{k}.glb" for k in range(12)})

    def lock(self):
        """Holds the lock that a run takes while it renames its files."""
        lock = open(self.path(".pcvt-lock"), "w")
        fcntl.flock(lock, fcntl.LOCK_EX)
        self.addCleanup(lock.close)
        return lock

    def start_behind(self, *arguments):
        """Starts a run that has nothing left to do but to wait for its turn."""
        run = subprocess.Popen([self.binary(), *arguments], cwd=self.folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
        self.addCleanup(run.stderr.close)
        time.sleep(1)
        self.assertIsNone(run.poll())
        return run

    WRITERS = (("a.obj", MESH), ("a.vtu", ("mesh", "--sites", "20", "--period", "1,1,1", "--threads", "1", "--quiet")),
               ("a.svg", ("pattern", "--sites", "7", "--quiet")),
               ("a.csv", ("study", "fig11", "--sites", "6", "--runs", "1", "--threads", "1", "--quiet")))

    def test_a_run_waits_until_another_one_has_written_its_files(self):
        for name, arguments in self.WRITERS:
            with self.subTest(name), self.lock() as lock:
                run = self.start_behind(*arguments, "-o", name)
                self.assertFalse(self.path(name).exists())
                # As another run does: it removes the lock before it ends.
                self.path(".pcvt-lock").unlink()
                lock.close()
                self.assertEqual((run.communicate(timeout=60)[1], run.returncode), (b"", 0))
                self.assertTrue(self.path(name).exists())
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith(".")], [])

    def test_ctrl_c_ends_the_waiting_and_leaves_nothing(self):
        seconds = []
        for name, arguments in self.WRITERS:
            with self.subTest(name), self.lock():
                run = self.start_behind(*arguments, "-o", name)
                run.send_signal(signal.SIGINT)
                began = time.monotonic()
                self.assertEqual((run.communicate(timeout=60)[1], run.returncode),
                                 (b"pcvt: cancelled; nothing was written\n", 130))
                seconds.append(time.monotonic() - began)
                self.assertEqual([p.name for p in self.folder.iterdir()], [".pcvt-lock"])
        # A busy machine may delay some of them, but not most.
        self.assertEqual(len(seconds), len(self.WRITERS))
        self.assertLess(statistics.median_low(seconds), 1)
        self.assertLess(max(seconds), 10)

    def test_runs_that_replace_the_same_files_leave_the_files_of_one_run(self):
        for spatial in ([], ["--period", "1,1,1"]):
            runs = [["mesh", "--sites", "20", "--seed", str(k), "--max-iterations", "2", "--threads", "1", "--quiet",
                     "--force", "-o", "z.foam", "-o", "new/z.ply", "-o", "z.obj", *spatial] for k in range(8)]

            def contents_left():
                found = self.contents()
                shutil.rmtree(self.path("z.foam"))
                shutil.rmtree(self.path("new"))
                self.path("z.obj").unlink()
                return found

            one_by_one = []
            for run in runs:
                self.succeed(*run)
                one_by_one.append(contents_left())
            for _ in range(4):
                begun = [subprocess.Popen([self.binary(), *run], cwd=self.folder, stderr=subprocess.PIPE)
                         for run in runs]
                for run in begun:
                    self.assertEqual((run.communicate()[1], run.returncode), (b"", 0))
                self.assertEqual(one_by_one.count(contents_left()), 1)


if __name__ == "__main__":
    main()
