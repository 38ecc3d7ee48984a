"""Large runs must fit into the memory of a small machine."""

import os
import re
import resource
import subprocess
import time
import unittest

from support.cli import CliTest, limit, main

# The memory of the command that does not depend on the number of sites.
FIXED_BYTES = 16 << 20


class Large(CliTest):
    def peak_bytes(self, *arguments):
        """Runs the command and returns the largest memory that it had resident."""
        command = [self.binary(), *map(str, arguments)]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return 1024 * usage.ru_maxrss

    def estimate_by_peak(self, *arguments):
        """Runs mesh with one thread, since two free their memory in another order each time, and returns the
        estimate of its memory divided by the peak."""
        summary = self.succeed("mesh", *arguments, "--threads", 1, "--force")
        found = re.search(r"^memory +(\S+) ([MG])B at the peak, (\S+) ([MG])B estimated$", summary, re.M)
        peak, estimate = (float(found[k]) * {"M": 1e6, "G": 1e9}[found[k + 1]] for k in (1, 3))
        return estimate / peak

    def test_a_run_without_a_mesh_takes_220_bytes_a_site(self):
        n = 500_000
        outputs = {"nothing": [], "sites": ["-o", "s.txt"], "report": ["--report", "r.json"]}
        for name, options in outputs.items():
            with self.subTest(name):
                peak = self.peak_bytes("mesh", "--sites", n, "--max-iterations", 3, *options)
                self.assertLess(peak, FIXED_BYTES + 220 * n)

    def test_the_estimate_of_the_memory_is_at_most_half_above_the_peak(self):
        density = ["--density", "1 + u", "--max-iterations", 2]
        quick = ["--max-iterations", 3]
        fixed = ["--max-iterations", 0]
        both = ["--mesh", "voronoi", "--mesh", "delaunay"]
        jobs = {
            "sites": ["--sites", 150_000, *quick, "-o", "s.txt"],
            "built": ["--sites", 150_000, "--max-iterations", 0],
            "built in a box": ["--sites", 150_000, *fixed, "--outline", "box", "-o", "s.txt"],
            "density": ["--sites", 50_000, *density],
            "cells": ["--sites", 50_000, *quick, "-o", "t.obj"],
            "triangles": ["--sites", 50_000, *quick, "--mesh", "delaunay", "-o", "t.glb"],
            "grains": ["--sites", 5000, *quick, "--mesh", "grains", "-o", "t.msh"],
            "tied triangles": ["--sites", 40_000, *fixed, "--mesh", "delaunay", "-o", "t.inp"],
            "tied grains": ["--sites", 4000, *fixed, "--mesh", "grains", "--outline", "box", "-o", "t.inp"],
            "grouped triangles": ["--sites", 40_000, *fixed, "--mesh", "delaunay", "-o", "t.msh"],
            "cut cells": ["--sites", 40_000, *fixed, "--outline", "box", "-o", "t.vtu"],
            "curved grains": ["--sites", 4000, *fixed, "--mesh", "grains", "--order", 2, "-o", "t.vtu"],
            "an ocean": ["--sites", 40_000, "--start", "lattice", *fixed, "-o", "t.nc"],
            "a case": ["--sites", 40_000, *fixed, "--mesh", "delaunay", "-o", "t.foam"],
            "copies": ["--sites", 10_000, *quick, "--repeat", "3x3", "-o", "t.ply"],
            "two meshes": ["--sites", 50_000, *quick, *both, "-o", "t.obj", "-o", "t.glb"],
            "voxels of few cells": ["--sites", 100, *fixed, "--voxels", "2000,2000", "-o", "t.vti"],
            "voxels of many cells": ["--sites", 50_000, *fixed, "--voxels", "2000,2000", "-o", "t.vti"],
            "a picture": ["--sites", 100, *quick, "--pixels", 4000, "-o", "t.png"],
        }
        for name, options in jobs.items():
            with self.subTest(name):
                ratio = self.estimate_by_peak(*options)
                self.assertGreater(ratio, 0.95)
                self.assertLess(ratio, 1.5)

    def test_the_estimate_of_a_run_in_space_lies_above_the_peak(self):
        outputs = (), ("t.vtu",), ("t.foam",), ("t.msh",), ("s.vtu", "s.foam", "s.msh")
        smooth = ("--short-edges", 0.001)
        jobs = [(names, ()) for names in outputs] + [(names, smooth) for names in ((), ("t.vtu",), ("t.foam",))]
        for names, options in jobs:
            with self.subTest(f"{names} {options}"):
                ratio = self.estimate_by_peak("--sites", 10000, "--period", "1,1,1", "--max-iterations", 1,
                                              *options, *(word for name in names for word in ("-o", name)))
                self.assertGreater(ratio, 1)
                self.assertLess(ratio, 1.5)

    def test_the_estimate_of_tetrahedra_in_random_cells_lies_above_the_peak(self):
        for order in (1, 2):
            with self.subTest(order):
                ratio = self.estimate_by_peak("--sites", 60, "--period", "1,1,1", "--max-iterations", 0, "--mesh", "grains",
                                              "--order", order, "-o", "t.inp")
                self.assertGreater(ratio, 1)
                self.assertLess(ratio, 2)

    def test_a_run_in_space_that_cannot_fit_is_refused_before_it_begins(self):
        small = limit(resource.RLIMIT_AS, 4 << 30)
        self.refuse(4, r"^pcvt: the run takes about \S+ GB of memory, and \S+ GB are available; take fewer sites",
                    "mesh", "--sites", 60_000_000, "--period", "1,1,1", "-o", "t.vtu", preexec_fn=small)

    def test_a_run_that_cannot_fit_is_refused_before_it_begins(self):
        small = limit(resource.RLIMIT_AS, 4 << 30)
        began = time.monotonic()
        self.refuse(4, r"the run takes about \S+ GB of memory, and \S+ GB are available; take",
                    "mesh", "--sites", 1 << 28, "-o", "s.txt", preexec_fn=small)
        self.assertLess(time.monotonic() - began, 5)

    def test_the_estimate_is_printed_before_a_large_run(self):
        done = self.run_pcvt("mesh", "--sites", 1_000_000, "--max-iterations", 0)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, rb"^pcvt: takes about \S+ GB of memory; \S+ GB are available\n$")

    def test_a_hundred_thousand_sites_fit_into_4_GiB(self):
        small = limit(resource.RLIMIT_AS, 4 << 30)
        self.succeed("mesh", "--sites", 100000, "--max-iterations", 10, "--mesh", "voronoi",
                     "--mesh", "delaunay", "-o", "t.obj", "-o", "t.glb", "--quiet", preexec_fn=small)
        names = [f"t-{kind}.{e}" for kind in ("voronoi", "delaunay") for e in ("obj", "glb")]
        self.assertLessEqual(set(names), set(self.contents()))
        proofs = self.succeed("check", *names, preexec_fn=small)
        self.assertEqual(len(proofs.splitlines()), 4)


if __name__ == "__main__":
    main()
