"""Runs from one to a thousand sites converge and are proved on every lattice."""

import json
import unittest

from support.cli import CliTest, main

LATTICES = {
    "square": ("--period", "1,1"),
    "flat": ("--period", "20,1"),
    "tall": ("--period", "1,20"),
    "tiny": ("--period", "0.001,0.002"),
    "huge": ("--period", "1e6,1e6"),
    "oblique": ("--lattice", "1,0,0.37,0.81"),
    "sheared": ("--lattice", "1,0,7,1"),
    "turned": ("--lattice", "0.5,0.1,-0.2,2"),
    "left-handed": ("--lattice", "0,1,1,0.2"),
    "hexagonal": ("--lattice", "1,0,0.5,0.8660254037844386"),
}
SITES = (1, 2, 3, 4, 5, 7, 8, 30, 150, 300, 1000)


class Lattices(CliTest):
    def converge_and_prove(self, n, lattice):
        names = [f"t-{kind}.{e}" for kind in ("voronoi", "delaunay") for e in ("obj", "glb")]
        self.succeed("mesh", "--sites", n, *LATTICES[lattice], "--tolerance", "1e-7", "--strict",
                     "--mesh", "voronoi", "--mesh", "delaunay", "-o", "t.obj", "-o", "t.glb",
                     "--report", "run.json", "--force", "--quiet")
        report = json.loads(self.path("run.json").read_text())
        self.assertEqual(report["stop"], "converged")
        self.assertGreaterEqual(report["energy"], report["energy_bound"] * (1 - 1e-12))
        self.assertEqual(len(self.succeed("check", *names, "--cvt").splitlines()), 4)

    def test_each_number_of_sites_converges_and_is_proved(self):
        for lattice in LATTICES:
            for n in SITES:
                with self.subTest(lattice=lattice, n=n):
                    self.converge_and_prove(n, lattice)


if __name__ == "__main__":
    main()
