"""Random polycrystals: every format is written, `pcvt check` and `check --areas` accept it, and the faces of each
cell have the target area. Where many edges are removed, no weights may give the areas: then the report says so, and
`check --areas` refuses.

PCVT_GRAIN_JOBS=N runs N jobs instead of a few, PCVT_GRAIN_SEED=S others.
"""

import csv
import json
import math
import os
import random
import re
import unittest

from support.cli import CliTest, main

LAWS = ("equal", "lognormal:0.2", "lognormal:0.42", "gamma:0.3", "gamma:0.42", "FILE", "DIAMETERS")
# For each kind of mesh, the formats that hold the sites with their weights.
FORMATS = {"voronoi": ("obj", "ply", "glb", "gltf", "om", "vtu"),
           "delaunay": ("obj", "ply", "glb", "gltf", "om", "vtu", "msh", "inp"),
           "grains": ("obj", "ply", "glb", "gltf", "om", "vtu", "msh", "inp")}
QUADRATIC = ("vtu", "msh", "inp")
SAME_AREA = 1e-8
# The refusals that a well-posed job may meet.
REFUSALS = (r"too thin", r"too small", r"single precision is too coarse", r"closer than", r"smaller spread",
            r"times longer than wide", r"cells are so small")


def lattice(draw):
    """The option of a random domain, and whether it is a rectangle."""
    ratio = 10 ** draw.uniform(-1, 1)
    width, height = ratio ** 0.5, ratio ** -0.5
    if draw.random() < 0.5:
        return ["--period", f"{width:.6g},{height:.6g}"], True
    shear = draw.choice((0.37, -0.5, 3.2))
    return ["--lattice", f"{width:.6g},0,{shear * width:.6g},{height:.6g}"], False


class RandomGrains(CliTest):
    def targets(self, draw, n_sites):
        """The word of --areas; a file is written."""
        law = draw.choice(LAWS)
        if law not in ("FILE", "DIAMETERS"):
            return law
        head = "diameter\n" if law == "DIAMETERS" else ""
        self.write("targets.txt", head + "".join(f"{draw.uniform(0.3, 2):.6g}\n" for _ in range(n_sites)))
        return "targets.txt"

    def job(self, draw):
        """The options of one random job, and its outputs."""
        n_sites = round(300 ** draw.random())
        domain, is_rectangle = lattice(draw)
        mesh = draw.choice(("voronoi", "grains", "grains", "delaunay"))
        options = [*domain, "--sites", n_sites, "--seed", draw.randrange(10**6), "--areas", self.targets(draw, n_sites),
                   "--max-iterations", draw.choice((0, 1, 5)), "--mesh", mesh, "--threads", 1]
        formats = FORMATS[mesh]
        if draw.random() < 0.3:
            options += ["--aspect", f"{10 ** draw.uniform(-0.5, 0.5):.4g},{draw.uniform(0, 180):.4g}"]
        if mesh != "delaunay":
            if draw.random() < 0.5:
                options += ["--outline", "box"]
            if draw.random() < 0.3:
                options += ["--short-edges", draw.choice((0.05, 0.1, 0.2))]
        if draw.random() < 0.3:
            options += ["--repeat", draw.choice(("2x1", "1x2", "2x3"))]
        if draw.random() < 0.3:
            options += [f"--origin={draw.uniform(-1, 1):.4g},{draw.uniform(-1, 1):.4g}"]
        if mesh == "grains":
            options += draw.choice(([], ["--per-edge", draw.choice((1, 3))]))
            if draw.random() < 0.3:
                options += ["--order", 2]
                formats = QUADRATIC
            if draw.random() < 0.4:
                options += ["--phases", draw.choice(("a:1", "a:0.3,b:0.7", "a:0.2,b:0.3,c:0.5"))]
            if draw.random() < 0.4:
                options += ["--orientations", "random"]
        formats = [*formats, *(("vti",) if is_rectangle and "--repeat" not in options else ())]
        return options, formats

    def table(self, name):
        lines = (line for line in self.path(name).read_text().splitlines() if not line.startswith("#"))
        return list(csv.DictReader(lines))

    def areas_of_faces(self, name):
        """The sum of the areas of the faces of each site in an OBJ file."""
        points, areas, sites = [], [], []
        for line in self.path(name).read_text().splitlines():
            words = line.split()
            if line.startswith("# pcvt sites "):
                sites += map(int, words[3:])
            elif line.startswith("v "):
                points.append(complex(float(words[1]), float(words[2])))
            elif line.startswith("f "):
                corners = [points[int(word.split("/")[0]) - 1] for word in words[1:]]
                areas.append(sum((p.conjugate() * q).imag for p, q in zip(corners, corners[1:] + corners[:1])) / 2)
        sums = {}
        for site, area in zip(sites, areas, strict=True):
            sums[site] = sums.get(site, 0) + area
        return sums

    def expect_areas(self, options, targets):
        areas = self.areas_of_faces("t.obj")
        copies = math.prod(map(int, options[options.index("--repeat") + 1].split("x"))) if "--repeat" in options else 1
        self.assertEqual(len(areas), len(targets))
        for site, target in enumerate(targets):
            self.assertAlmostEqual(areas[site] / copies / target, 1, delta=SAME_AREA)

    def run_job(self, options, formats):
        """Returns the refusal, in words; nothing if all held."""
        outputs = [word for extension in formats for word in ("-o", f"t.{extension}")]
        done = self.run_pcvt("mesh", *options, *outputs, "-o", "cells.csv", "--report", "r.json", "--force",
                             "--quiet")
        error = done.stderr.decode()
        if done.returncode != 0:
            self.assertTrue(any(re.search(text, error) for text in REFUSALS), error)
            self.assertNotIn("fault of pcvt", error)
            return error
        targets = [float(row["area"]) for row in self.table("cells.csv")]
        self.write("areas.txt", "".join(f"{area!r}\n" for area in targets))
        error_of_mesh = json.loads(self.path("r.json").read_text())["areas"]["largest_relative_mesh_error"] or 0
        for extension in formats:
            self.succeed("check", f"t.{extension}")
            if error_of_mesh < SAME_AREA or extension == "vti":
                self.succeed("check", f"t.{extension}", "--areas", "areas.txt")
            else:
                self.refuse(2, "law of the areas", "check", f"t.{extension}", "--areas", "areas.txt")
        if error_of_mesh >= SAME_AREA:
            self.assertIn("--short-edges", options)
            return "areas are not reached"
        if options[options.index("--areas") + 1] == "targets.txt":
            self.succeed("check", f"t.{formats[0]}", "--areas", "targets.txt")
        if "obj" in formats and "delaunay" not in options:
            self.expect_areas(options, targets)
        return None

    def test_files_of_random_jobs_are_accepted(self):
        draw = random.Random(int(os.environ.get("PCVT_GRAIN_SEED", "1")))
        n_jobs = int(os.environ.get("PCVT_GRAIN_JOBS", "12"))
        refused = {}
        for number in range(n_jobs):
            options, formats = self.job(draw)
            with self.subTest(number=number, options=" ".join(map(str, options))):
                refusal = self.run_job(options, formats)
                if refusal:
                    refused[refusal] = refused.get(refusal, 0) + 1
        if n_jobs > 12:
            print(n_jobs, "jobs; refused:", refused)
        self.assertLess(sum(refused.values()), 0.2 * n_jobs, refused)


if __name__ == "__main__":
    main()
