"""The same job in three dimensions through the command and a C host gives the same bytes.

    pcvt_space_same_bytes_test.py COMMAND C_HOST
"""

import os
import subprocess
import sys

from support.cli import CliTest, main

C_HOST = os.path.abspath(sys.argv.pop())
CUBE = (1, 0, 0, 0, 1, 0, 0, 0, 1)
OBLIQUE = (1, 0, 0, 0.37, 0.81, 0, 0.2, 0.4, 0.9)
LEFT_HANDED = (1, 0, 0, 0, 0, 1.1, 0.3, 0.8, 0)
FILES = ("a.vtu", "a.foam", "a.msh", "a.obj", "a.ply", "a.glb", "a.om", "a.txt")
# Numbers of pcvt.h.
STARTS = {"random": 1, "coarse": 2, "lattice": 3}
SOLVERS = {"lbfgs": 1, "lloyd": 2}


class SameBytes(CliTest):
    def files_of(self, *command):
        """Returns the files of a command that runs in a folder of its own."""
        folder = self.path("f")
        folder.mkdir()
        done = subprocess.run(list(map(str, command)), cwd=folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        files = {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        folder.rename(self.path(f"done{len(list(self.folder.iterdir()))}"))
        return files

    def compare(self, n_sites, seed, lattice, start="random", solver="lbfgs", limit=-1):
        drawn = ["--seed", seed] if start != "lattice" else []
        limits = ["--max-iterations", limit] if limit >= 0 else []
        of_command = self.files_of(self.binary(), "mesh", "--sites", n_sites, *drawn, "--lattice",
                                   ",".join(map(str, lattice)), "--start", start, "--solver", solver, *limits,
                                   *(word for file in FILES for word in ("-o", file)))
        of_host = self.files_of(C_HOST, n_sites, seed, STARTS[start], SOLVERS[solver], limit, *lattice, *FILES)
        self.assertGreater(len(of_command), 10)
        self.assertEqual(sorted(of_host), sorted(of_command))
        for name, data in of_command.items():
            self.assertEqual(of_host[name], data, name)

    def test_random_sites_on_three_lattices(self):
        for lattice in (CUBE, OBLIQUE, LEFT_HANDED):
            self.compare(50, 5, lattice)

    def test_the_best_lattice(self):
        self.compare(7, 0, OBLIQUE, start="lattice")

    def test_from_coarse_to_fine(self):
        self.compare(300, 4, OBLIQUE, start="coarse", limit=20)

    def test_steps_of_lloyd(self):
        self.compare(80, 1, CUBE, solver="lloyd", limit=4)

    def test_many_sites_as_they_were_drawn(self):
        self.compare(2000, 2, OBLIQUE, limit=0)


if __name__ == "__main__":
    main()
