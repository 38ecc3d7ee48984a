"""Plane groups in Python: sites that map to each other, lattices that fit, and refusals."""

import tempfile
import unittest
from pathlib import Path

from support.cli import main
from support.python_package import OBLIQUE, pcvt

import numpy as np
from pcvt._words import CHOICES


def wrapped(u):
    """Lattice coordinates in [0, 1), rounded, as a set of pairs."""
    return {tuple(pair) for pair in np.round(np.mod(np.round(u, 9), 1), 9).tolist()}


class Symmetry(unittest.TestCase):
    def test_sites_map_to_each_other(self):
        quarter, mirror = np.array([[0, -1], [1, 0]]), np.diag([1, -1])
        result = pcvt.mesh(58, symmetry="p4m", tolerance=1e-3)
        u = result.sites @ np.linalg.inv(result.lattice)
        self.assertEqual(len(wrapped(u)), 58)
        for operation in (quarter, mirror):
            self.assertEqual(wrapped(u @ operation.T), wrapped(u))
        without = pcvt.mesh(58, tolerance=1e-3).sites
        self.assertNotEqual(wrapped(without @ quarter.T), wrapped(without))

    def test_the_lattice_is_one_that_fits(self):
        for word in CHOICES[2]["symmetry"]:
            result = pcvt.mesh(24, symmetry=word, max_iterations=1)
            a, b = result.lattice
            self.assertEqual(np.hypot(*a), 1)
            self.assertAlmostEqual(a @ b, 0.5 if word[1] in "36" else 0, 15)
        result = pcvt.mesh(24, symmetry="pg", period=(2, 1), max_iterations=1)
        np.testing.assert_array_equal(result.lattice, [[2, 0], [0, 1]])

    def test_sites_of_an_orbit_share_a_number(self):
        result = pcvt.mesh(58, symmetry="p4m", tolerance=1e-3)
        orbits = result.orbits
        self.assertEqual(list(dict.fromkeys(orbits.tolist())), list(range(orbits.max() + 1)))
        np.testing.assert_array_equal(result.cells["orbit"], orbits)
        u = result.sites @ np.linalg.inv(result.lattice)
        turned = wrapped(u[orbits == 0] @ np.array([[0, -1], [1, 0]]).T)
        self.assertEqual(turned, wrapped(u[orbits == 0]))
        for s in range(58):
            copies = len(wrapped([sign * pair for pair in (u[s], u[s][::-1])
                                  for sign in np.array([(1, 1), (1, -1), (-1, 1), (-1, -1)])]))
            self.assertEqual(copies, (orbits == orbits[s]).sum())
        without = pcvt.mesh(20)
        self.assertIsNone(without.orbits)
        self.assertEqual(set(without.cells["orbit"]), {-1})

    def test_pictures_show_the_orbits(self):
        with tempfile.TemporaryDirectory() as folder:
            pcvt.mesh(20, symmetry="p4").write(folder + "/t.svg", colour="orbit")
            self.assertIn("by orbit", Path(folder + "/t.svg").read_text())
            with self.assertRaisesRegex(pcvt.ArgumentError, "colour orbit needs symmetry"):
                pcvt.mesh(20).write(folder + "/u.svg", colour="orbit")

    def test_what_does_not_fit_is_refused_in_one_line(self):
        for options, words in (
                ({"symmetry": "p5"}, "symmetry 'p5' is unknown; take one of p1, p2, .*, p6m"),
                ({"symmetry": "p4m", "period": (1, 2)}, "it fits squares"),
                ({"symmetry": "p3", "period": (1, 1)}, "it fits hexagonal lattices"),
                ({"symmetry": "pm", "lattice": OBLIQUE}, "it fits rectangles"),
                ({"symmetry": "p2", "start": "best"}, "take coarse or random"),
                ({"symmetry": "p2", "areas": "equal"}, "^symmetry does not work with areas; leave one of them out$"),
                ({"symmetry": "p4", "aspect": 2}, "elongated by the aspect")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words) as refusal:
                pcvt.mesh(8, **options)
            self.assertNotIn("\n", str(refusal.exception))
        with self.assertRaisesRegex(pcvt.ArgumentError, "take 6 or 8"):
            pcvt.mesh(7, symmetry="pg")
        with self.assertRaisesRegex(pcvt.ArgumentError, "symmetry draws its sites"):
            pcvt.mesh([[0.1, 0.2], [0.6, 0.7]], symmetry="p2")


if __name__ == "__main__":
    main()
