"""Random jobs with walls: every file is written, and `pcvt check` accepts it.

PCVT_WALL_JOBS=N runs N jobs instead of a few, PCVT_WALL_SEED=S others.
"""

import os
import random
import re
import unittest

from support.cli import CliTest, main

DENSITIES = ("1 + 20 * exp(-8 * v)", "1 + 5 * cos(2 * _pi * u)^2", "exp(3 * u * v)", "u < 0.4 ? 9 : 1")
LAWS = ("equal", "lognormal:0.42", "gamma:0.3")
FORMATS = ("obj", "glb", "vtu")
# The refusals that a well-posed job may meet.
REFUSALS = (r"no cells of sites on the walls came about", r"reaches the opposite one", r"too thin", r"too small",
            r"single precision is too coarse")


def job(draw):
    """The options of one random job."""
    walls = draw.choice(("x", "y", "xy"))
    cells = draw.choice(("whole", "whole", "half"))
    n_sites = round(300 ** draw.random())
    ratio = 10 ** draw.uniform(-1.5, 1.5)
    meshes = ("voronoi", "grains") + (("delaunay",) if cells == "half" else ())
    mesh = draw.choice(meshes)
    options = ["--walls", walls, "--wall-cells", cells, "--sites", n_sites, "--seed", draw.randrange(10**6),
               "--period", f"{ratio ** 0.5:.6g},{ratio ** -0.5:.6g}", "--mesh", mesh, "--tolerance", "1e-4",
               "--threads", 1]
    sizes = draw.random()
    if sizes < 0.3:
        options += ["--density", draw.choice(DENSITIES)]
    elif sizes < 0.7:
        steps = draw.choice((0, 1, 5)) if cells == "whole" else draw.choice((1, 5))
        options += ["--areas", draw.choice(LAWS), "--max-iterations", steps]
    if draw.random() < 0.3 and mesh != "delaunay":
        options += ["--outline", "box"]
    if draw.random() < 0.3 and mesh != "delaunay":
        options += ["--short-edges", draw.choice((0.05, 0.1, 0.2))]
    if draw.random() < 0.3 and walls != "xy":
        options += ["--repeat", "1x2" if walls == "x" else "2x1"]
    if draw.random() < 0.3 and walls != "xy":
        options += ["--origin", "0,0.3" if walls == "x" else "-0.4,0"]
    return options


class RandomWalls(CliTest):
    def test_a_cell_that_holds_two_corners_leaves_the_one_that_has_a_site(self):
        self.succeed("mesh", "--walls", "xy", "--wall-cells", "half", "--sites", 40, "--seed", 573719, "--period",
                     "0.372589,2.68393", "--mesh", "delaunay", "--tolerance", "1e-4", "--areas", "equal",
                     "--max-iterations", 1, "-o", "box.obj")
        self.assertIn("a box with four walls", self.succeed("check", "box.obj"))

    def test_files_of_random_jobs_are_accepted(self):
        draw = random.Random(int(os.environ.get("PCVT_WALL_SEED", "1")))
        refused = {}
        n_jobs = int(os.environ.get("PCVT_WALL_JOBS", "25"))
        for number in range(n_jobs):
            options = [str(option) for option in job(draw)]
            outputs = [word for extension in FORMATS for word in ("-o", f"a.{extension}")]
            with self.subTest(number=number, options=" ".join(options)):
                done = self.run_pcvt("mesh", *options, *outputs, "--force", "--quiet")
                error = done.stderr.decode()
                if done.returncode != 0:
                    self.assertTrue(any(re.search(text, error) for text in REFUSALS), error)
                    self.assertNotIn("fault of pcvt", error)
                    refused[error] = refused.get(error, 0) + 1
                    continue
                for extension in FORMATS:
                    text = self.succeed("check", f"a.{extension}")
                    self.assertIn("a disc" if "xy" in options else "an annulus after gluing", text)
        if n_jobs > 25:
            print(n_jobs, "jobs; refused:", refused)
        self.assertLess(sum(refused.values()), 0.2 * n_jobs, refused)


if __name__ == "__main__":
    main()
