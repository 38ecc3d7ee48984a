"""The same job through the command, a C host and Python gives the same sites, bit for bit.

    pcvt_same_sites_test.py COMMAND LIBRARY C_HOST
"""

import os
import subprocess
import sys

from support.cli import CliTest, main
from support.python_package import ROOT, pcvt

import numpy as np

C_HOST = os.path.abspath(sys.argv.pop())
SQUARE = (1, 0, 0, 1)
HEXAGONAL = (1, 0, 0.5, 0.75 ** 0.5)
OBLIQUE = (1, 0, 0.37, 0.81)
RIDGE = "1 + 9 * exp(-((v - 0.5) / 0.1)^2)"


def recorded_symmetries():
    """Returns the numbers of the plane groups in pcvt.h by their words, "p4m": 11."""
    prefix = "number PCVT_SYMMETRY_"
    lines = (ROOT / "tests" / "plugin" / "abi" / "pcvt_abi.txt").read_text().splitlines()
    words = [line.removeprefix(prefix).lower().split() for line in lines if line.startswith(prefix)]
    return {word: int(number) for word, number in words}


SYMMETRIES = recorded_symmetries()


class SameSites(CliTest):
    def of_command(self, n_sites, seed, lattice, density, symmetry):
        """Returns the numbers of the file; its decimals determine every bit."""
        more = ["--density", density] if density else []
        more += ["--symmetry", symmetry] if symmetry else []
        self.succeed("mesh", "--sites", n_sites, "--seed", seed, "--lattice",
                     ",".join(map(str, lattice)), "-o", "sites.txt", "--force", *more)
        return np.loadtxt(self.path("sites.txt"), ndmin=2)

    @staticmethod
    def of_c(n_sites, seed, lattice, density, symmetry):
        number = SYMMETRIES[symmetry or "none"]
        done = subprocess.run([C_HOST, *map(str, (n_sites, seed, *lattice, number)),
                               *([density] if density else [])], check=True, capture_output=True)
        return np.frombuffer(done.stdout).reshape(-1, 2)

    def compare(self, n_sites, seed, lattice, density=None, symmetry=None):
        of_python = pcvt.mesh(n_sites, np.reshape(lattice, (2, 2)), density, seed=seed, symmetry=symmetry).sites
        self.assertEqual(of_python.shape, (n_sites, 2))
        for sites in (self.of_command(n_sites, seed, lattice, density, symmetry),
                      self.of_c(n_sites, seed, lattice, density, symmetry)):
            self.assertEqual(sites.tobytes(), of_python.tobytes())

    def test_on_the_square(self):
        self.compare(150, 3, SQUARE)

    def test_few_on_an_oblique_lattice(self):
        for n_sites in (1, 7):
            self.compare(n_sites, 5, OBLIQUE)

    def test_many_from_a_coarse_start(self):
        self.compare(2000, 1, OBLIQUE)

    def test_graded_by_an_expression(self):
        self.compare(30, 2, SQUARE, RIDGE)

    def test_with_the_symmetry_of_each_plane_group(self):
        words = [word for word in SYMMETRIES if word != "none"]
        self.assertEqual(len(words), 17)
        for word in words:
            self.compare(24, 3, HEXAGONAL if word[1] in "36" else SQUARE, symmetry=word)
        self.compare(60, 1, SQUARE, "2 + cos(2 * pi * u)", "pmm")


if __name__ == "__main__":
    main()
