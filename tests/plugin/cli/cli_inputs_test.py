"""Files that are read: only regular ones and standard input, up to a limit, and none of them waited for."""

import os
import resource
import socket
import subprocess
import time

from support.cli import CliTest, limit, main


class Inputs(CliTest):
    def setUp(self):
        super().setUp()
        os.mkfifo(self.path("fifo"))
        for name in ("fifo.png", "fifo.obj", "fifo.csv"):
            os.symlink("fifo", self.path(name))
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(str(self.path("socket")))
        os.symlink("socket", self.path("socket.png"))
        for name in ("zero.png", "zero.obj", "zero.csv"):
            os.symlink("/dev/zero", self.path(name))
        for name in ("folder", "folder.png", "folder.obj", "folder.csv"):
            self.path(name).mkdir()

    def contents(self, folder=None):
        return sorted(path.name for path in self.folder.iterdir())

    def refuse_at_once(self, kind, *arguments):
        begin = time.monotonic()
        self.refuse(2, f"cannot read: it is a {kind}; give a regular file", *arguments, timeout=60)
        self.assertLess(time.monotonic() - begin, 30)

    def test_what_is_not_a_regular_file_is_refused_at_once(self):
        for kind, name in (("pipe", "fifo"), ("socket", "socket"), ("device", "/dev/zero"), ("folder", "folder")):
            with self.subTest(name):
                self.refuse_at_once(kind, "mesh", "--input", name, "-o", "t.obj")
        for kind, name in (("pipe", "fifo"), ("device", "zero"), ("folder", "folder")):
            with self.subTest(name):
                self.refuse_at_once(kind, "mesh", "--sites", "9", "--density", f"{name}.png", "-o", "t.obj")
                self.refuse_at_once(kind, "check", f"{name}.obj")
                self.refuse_at_once(kind, "study", "fig11", "--merge", f"{name}.csv", "-o", "t.csv")

    def test_a_density_that_names_a_folder_or_a_device_is_no_formula(self):
        for name in ("/tmp", "folder", "./fifo", "/dev/zero"):
            with self.subTest(name):
                self.refuse(2, f"--density '{name}': not a regular file; give a PNG picture, or a formula",
                            "mesh", "--sites", "9", "--density", name, "-o", "t.obj")
        # A formula may have the name of a folder.
        self.path("1").mkdir()
        self.succeed("mesh", "--sites", "9", "--density", "1", "--max-iterations", "1")

    def test_companions_and_files_of_a_case_are_opened_by_the_same_rule(self):
        self.succeed("mesh", "--sites", "9", "--quiet", "--mesh", "delaunay", "-o", "t.obj", "-o", "c.foam")
        self.path("t.seam.json").unlink()
        os.mkfifo(self.path("t.seam.json"))
        self.refuse_at_once("pipe", "check", "t.obj")
        points = self.path("c.foam") / "constant/polyMesh/points"
        points.unlink()
        os.mkfifo(points)
        self.refuse_at_once("pipe", "check", "c.foam")

    def test_a_companion_that_cannot_be_examined_is_refused_with_the_reason(self):
        self.succeed("mesh", "--sites", "9", "--quiet", "-o", "t.obj")
        self.path("t.seam.json").unlink()
        os.symlink("t.seam.json", self.path("t.seam.json"))
        self.refuse(2, r"t\.seam\.json: cannot read: Too many levels of symbolic links", "check", "t.obj")

    def test_files_are_read_up_to_a_limit(self):
        little = limit(resource.RLIMIT_AS, 1 << 30)
        for name, pattern in (("large.obj", "more than 4 GiB"), ("large.csv", "more than 1 GiB"),
                              ("large.png", "more than 256 MiB"), ("large.txt", "appears to be a binary file")):
            os.truncate(os.open(self.path(name), os.O_CREAT | os.O_WRONLY), (4 << 30) + 1)
            arguments = {"large.obj": ("check", name), "large.csv": ("study", "fig11", "--merge", name),
                         "large.png": ("mesh", "--sites", "9", "--density", name),
                         "large.txt": ("mesh", "--input", name)}[name]
            with self.subTest(name):
                self.refuse(4 if "GiB" in pattern or "MiB" in pattern else 2, pattern, *arguments,
                            preexec_fn=little)
            self.path(name).unlink()

    def test_standard_input_is_read_up_to_a_limit(self):
        with open("/dev/zero", "rb") as zero:
            self.refuse(2, "appears to be a binary file", "mesh", "--input", "-", stdin=zero)
        endless = 'tr "\\0" "#" < /dev/zero | "$0" mesh --input - -o t.obj'
        done = subprocess.run(["sh", "-c", endless, self.binary()], cwd=self.folder, capture_output=True,
                              check=False, timeout=300)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr.decode(), r"^pcvt: standard input: more than 1 GiB[^\n]*\n$")


if __name__ == "__main__":
    main()
