"""Random jobs in three dimensions: every file is written, and `pcvt check` accepts it.

PCVT_SPACE_JOBS=N runs N jobs instead of a few, PCVT_SPACE_SEED=S others.
"""

import math
import os
import random
import re
import unittest

from support.cli import CliTest, main

FORMATS = ("vtu", "foam", "msh", "obj", "ply", "glb", "om", "txt")
SURFACES = {"obj", "ply", "glb"}
# The refusals that a well-posed job may meet, with their exit codes.
REFUSALS = (
    (2, r"-o a\.msh: (one tetrahedron of these sites is|\d+ tetrahedra of these sites are) flat, "),
    (2, r"single precision is too coarse"),
    (5, r"^pcvt: not converged \((iteration-limit|stalled)"),
)
# Mistakes that may be added to any job, and the messages of pcvt; the exit code is 2.
MISTAKES = (
    (("--density", "1"), r"--density is not for three dimensions"),
    (("--sites", "0"), r"--sites 0|--sites.*exclude"),
    (("--tolerance", "-1"), r"--tolerance( -1)?: "),
    (("-o", "b.html"), r"-o b\.html: \.html does not support three dimensions"),
    (("--start", "coarsest"), r"--start coarsest: |--start is"),
    (("--surfaces", "cells"), r"--surfaces"),
)


def periods(draw):
    """A lattice of any kind."""
    kind = draw.choice(("cube", "box", "thin", "oblique", "left-handed", "unreduced"))
    if kind == "cube":
        return ["--period", "1,1,1"]
    if kind in ("box", "thin"):
        thin = kind == "thin"
        sides = [10 ** draw.uniform(-1, 1) if thin else draw.uniform(0.5, 2) for _ in range(3)]
        return ["--period", ",".join(f"{side:.6g}" for side in sides)]
    rows = [[1, 0, 0], [draw.uniform(-1, 1), 1, 0], [draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(0.5, 2)]]
    if kind == "left-handed":
        rows[0], rows[1] = rows[1], rows[0]
    if kind == "unreduced":
        times = draw.randrange(-5, 6)
        rows[1] = [x + times * y for x, y in zip(rows[1], rows[0])]
        rows[2] = [x - (times + 2) * y for x, y in zip(rows[2], rows[1])]
    return ["--lattice", ",".join(f"{x:.6g}" for row in rows for x in row)]


def volume_of(options):
    """The volume of the lattice that the first two options give."""
    numbers = [float(word) for word in options[1].split(",")]
    if len(numbers) == 3:
        return math.prod(numbers)
    a, b, c = numbers[:3], numbers[3:6], numbers[6:]
    return abs(sum(a[k] * (b[k - 2] * c[k - 1] - b[k - 1] * c[k - 2]) for k in range(3)))


def rows_of_sites(draw):
    """Sites of a file: anywhere, on a grid, or in a plane, with any wrap."""
    kind = draw.choice(("random", "grid", "plane"))
    n = round(60 ** draw.random())
    if kind == "grid":
        m = draw.randrange(1, 4)
        return [[i / m, j / m, k / m] for i in range(m) for j in range(m) for k in range(m)]
    sites = [[draw.uniform(-3, 3) for _ in range(3)] for _ in range(n)]
    return [[x, y, 0.25] for x, y, _ in sites] if kind == "plane" else sites


def job(draw):
    """The options of one random job and the rows of its site file, if it has one."""
    options = periods(draw)
    rows = rows_of_sites(draw) if draw.random() < 0.4 else None
    if rows is None:
        options += ["--sites", round(200 ** draw.random()), "--seed", draw.randrange(10**6)]
        if draw.random() < 0.3:
            options += ["--start", draw.choice(("random", "lattice"))]
    else:
        options += ["--input", "s.txt"]
    if draw.random() < 0.5:
        options += ["--max-iterations", draw.choice((0, 0, 1, 10))]
    if draw.random() < 0.7:
        options += ["--tolerance", draw.choice(("1e-2", "1e-3", "1e-5"))]
    if draw.random() < 0.2:
        options += ["--solver", "lbfgs"] if "--tolerance" in options else ["--solver", "lloyd", "--tolerance", "0.05"]
    if draw.random() < 0.2:
        options += ["--strict"]
    formats = [extension for extension in FORMATS if draw.random() < 0.6] or ["vtu"]
    if SURFACES.intersection(formats) and draw.random() < 0.5:
        options += ["--surface", draw.choice(("cells", "boundary"))]
    return options, rows, formats


class RandomSpace(CliTest):
    def sites_text(self, rows):
        return "".join("%r %r %r\n" % tuple(row) for row in rows)

    def expect_one_mistake_in_one_line(self, draw, options, outputs):
        words, pattern = draw.choice(MISTAKES)
        self.refuse(2, pattern, "mesh", *options, *outputs, *words, "--force")

    def expect_refusal(self, done):
        """Returns whether the job was refused; it then left a single line."""
        error = done.stderr.decode()
        if done.returncode == 0:
            self.assertEqual(error, "")
            return ""
        self.assertEqual(error.count("\n"), 1, error)
        self.assertTrue(any(done.returncode == code and re.search(text, error) for code, text in REFUSALS), error)
        return re.sub(r"[\d.e+-]+", "N", error)

    def expect_proved(self, formats, options):
        """`pcvt check` accepts each file but those of sites, and states the volume of the lattice."""
        for extension in set(formats) - {"txt"}:
            said = self.succeed("check", f"a.{extension}")
            self.assertRegex(said, rf"^a\.{extension}: (a periodic tile of |the boundary of |surfaces of )")
            volume = float(re.search(r"volume ([\d.e+-]+)", said)[1])
            self.assertAlmostEqual(volume / volume_of(options), 1, 4)

    def expect_round_trip_of_sites(self, options):
        """Sites that are written, read and written again keep their coordinates."""
        lattice = options[:2]
        self.succeed("mesh", *lattice, "--input", "a.txt", "--max-iterations", 0, "--quiet", "-o", "again.txt", "--force")
        first, again = (
            [line.split() for line in self.path(name).read_text().splitlines() if not line.startswith("#")]
            for name in ("a.txt", "again.txt"))
        self.assertEqual(first, again)

    def run_job(self, draw, options, rows, formats):
        if rows is not None:
            self.write("s.txt", self.sites_text(rows))
        outputs = [word for extension in formats for word in ("-o", f"a.{extension}")]
        if draw.random() < 0.2:
            self.expect_one_mistake_in_one_line(draw, options, outputs)
        done = self.run_pcvt("mesh", *options, *outputs, "--threads", 1, "--force", "--quiet")
        refusal = self.expect_refusal(done)
        if refusal and done.returncode != 5:
            self.assertFalse([name for name in self.contents() if name.startswith("a.")])
            return refusal
        self.expect_proved(formats, options)
        first = self.contents()
        again = self.run_pcvt("mesh", *options, *outputs, "--threads", 2, "--force", "--quiet")
        self.assertEqual(again.returncode, done.returncode)
        self.assertEqual(self.contents(), first)
        if "txt" in formats:
            self.expect_round_trip_of_sites(options)
        return refusal

    def test_files_of_random_jobs_are_accepted(self):
        seed = os.environ.get("PCVT_SPACE_SEED", "1")
        n_jobs = int(os.environ.get("PCVT_SPACE_JOBS", "8"))
        refused = {}
        for number in range(n_jobs):
            draw = random.Random(f"{seed} {number}")
            options, rows, formats = job(draw)
            with self.subTest(number=number, options=" ".join(map(str, options)), formats=formats):
                for path in list(self.folder.iterdir()):
                    self.remove(path)
                refusal = self.run_job(draw, options, rows, formats)
                refused[refusal] = refused.get(refusal, 0) + 1
        if n_jobs > 8:
            print(n_jobs, "jobs; outcomes:", refused)

    def remove(self, path):
        if path.is_dir():
            for inner in path.iterdir():
                self.remove(inner)
            path.rmdir()
        else:
            path.unlink()


if __name__ == "__main__":
    main()
