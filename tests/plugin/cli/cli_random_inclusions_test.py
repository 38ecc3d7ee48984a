"""Random inclusions: every file is written, `pcvt check` accepts it, and each tag has the area of its shapes.

PCVT_INCLUSION_JOBS=N runs N jobs instead of a few, PCVT_INCLUSION_SEED=S others.
"""

import collections
import math
import os
import random
import re
import unittest

from support.cli import CliTest, main

TAGS = ("glass", "steel", "void")
FORMATS = ("obj", "glb", "vtu")
SMALLEST_GAP = 0.02
# The refusals that well-posed shapes may meet.
REFUSALS = (r"sites are too few for the inclusions; take \d+", r"single precision is too coarse",
            r"has no area in float32")


class Torus:
    """Period vectors, and the distance of points modulo them."""

    def __init__(self, draw):
        ratio = 10 ** draw.uniform(-0.6, 0.6)
        self.a = (ratio**0.5, 0.0)
        self.b = (draw.choice((0, draw.uniform(-0.5, 0.5))) * self.a[0], ratio**-0.5)
        self.area = self.a[0] * self.b[1]
        self.period = min(math.hypot(i * self.a[0] + j * self.b[0], j * self.b[1])
                          for i in range(-9, 10) for j in range(-9, 10) if (i, j) != (0, 0))

    def option(self):
        return ",".join(map(repr, (*self.a, *self.b)))

    def random_point(self, draw):
        # Points on the seam and at the corner of the domain are frequent.
        u, v = (draw.choice((0, draw.random(), draw.random())) for _ in range(2))
        return u * self.a[0] + v * self.b[0], v * self.b[1]

    def distance(self, p, q):
        x, y = p[0] - q[0], p[1] - q[1]
        n = 1 + math.ceil(self.area / self.period**2)
        j = round(y / self.b[1])
        images = ((x - i * self.a[0] - (j + k) * self.b[0], y - (j + k) * self.b[1])
                  for k in range(-n, n + 1) for i in range(round((x - (j + k) * self.b[0]) / self.a[0]) - n,
                                                           round((x - (j + k) * self.b[0]) / self.a[0]) + n + 1))
        return min(math.hypot(*image) for image in images)


def shape_within(draw, tag, centre, radius):
    """A shape that touches the circle from within: its line and its area."""
    x, y = centre
    kind = draw.choice(("circle", "circle", "ellipse", "polygon"))
    if kind == "circle":
        return f"circle {tag} {x!r} {y!r} {radius!r}", math.pi * radius**2
    if kind == "ellipse":
        other = radius * draw.uniform(0.3, 1)
        return f"ellipse {tag} {x!r} {y!r} {radius!r} {other!r} {draw.uniform(0, 360)!r}", math.pi * radius * other
    n = draw.randint(3, 8)
    start, step = draw.uniform(0, 7), 2 * math.pi / n
    angles = [start + step * (k + draw.uniform(-0.3, 0.3)) for k in range(n)]
    corners = [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in angles]
    if draw.random() < 0.5:
        corners.reverse()
    area = abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, corners[1:] + corners[:1]))) / 2
    return f"polygon {tag} " + " ".join(f"{p!r} {q!r}" for p, q in corners), area


def random_shapes(draw, torus):
    """Lines of a file, and the area of each tag."""
    gap = torus.period * draw.choice((SMALLEST_GAP, 0.05, 0.1))
    placed, lines, areas = [], [], collections.Counter()
    n_wanted, fraction = draw.randint(1, 30), draw.uniform(0.05, 0.6)
    largest = min(0.5 * (torus.period - gap), math.sqrt(fraction * torus.area / math.pi / n_wanted) * 1.5)
    for attempt in range(2000):
        if len(placed) == n_wanted or sum(math.pi * r**2 for _, r in placed) > fraction * torus.area:
            break
        centre = torus.random_point(draw)
        radius = largest * (1 - 0.7 * attempt / 2000) * draw.uniform(0.7, 1)
        if any(torus.distance(centre, other) < radius + r + gap for other, r in placed):
            continue
        placed.append((centre, radius))
        tag = draw.choice(TAGS)
        line, area = shape_within(draw, tag, centre, radius)
        lines.append(line)
        areas[tag] += area
    return lines, areas


def options_of(draw, torus):
    mesh = draw.choice(("voronoi", "voronoi", "grains"))
    # From 300 sites on, the random shapes leave room for cells of the matrix.
    options = ["--lattice", torus.option(), "--sites", round(draw.choice((300, 1000, 3000)) * draw.uniform(1, 3)),
               "--seed", draw.randrange(10**6), "--mesh", mesh, "--tolerance", "1e-3"]
    if draw.random() < 0.3:
        options += ["--density", draw.choice(("1 + u", "2 + cos(2 * _pi * v)", "1 + 9 * exp(-((u - 0.5) / 0.2)^2)"))]
    if draw.random() < 0.4:
        options += ["--outline", "box"]
    if draw.random() < 0.3:
        options += ["--short-edges", draw.choice((0.05, 0.2))]
    if draw.random() < 0.2:
        options += ["--repeat", "2x1"]
    if draw.random() < 0.3:
        options += ["--origin", "0.3,-0.4"]
    return [str(option) for option in options]


def areas_by_phase(path):
    """The area of the faces of each material of an OBJ file."""
    points, areas, phase = [(0, 0)], collections.defaultdict(list), None
    for line in path.read_text().splitlines():
        words = line.split()
        if line.startswith("v "):
            points.append((float(words[1]), float(words[2])))
        elif line.startswith("usemtl"):
            phase = words[1].removeprefix("phase_")
        elif line.startswith("f "):
            corners = [points[int(word.split("/")[0])] for word in words[1:]]
            x, y = corners[0]
            areas[phase] += [((p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x)) / 2
                             for p, q in zip(corners[1:], corners[2:])]
    return {phase: math.fsum(parts) for phase, parts in areas.items()}


class RandomInclusions(CliTest):
    def check_files(self, torus, options, areas):
        copies = 2 if "--repeat" in options else 1
        for extension in FORMATS:
            self.assertIn("genus 1 after gluing", self.succeed("check", f"a.{extension}"))
        found = areas_by_phase(self.path("a.obj"))
        self.assertEqual(set(found) - {"matrix"}, set(areas))
        for tag, area in areas.items():
            self.assertAlmostEqual(found[tag] / copies / torus.area, area / torus.area, delta=1e-12)

    def test_files_of_random_jobs_are_accepted(self):
        draw = random.Random(int(os.environ.get("PCVT_INCLUSION_SEED", "1")))
        n_jobs = int(os.environ.get("PCVT_INCLUSION_JOBS", "15"))
        refused = collections.Counter()
        for number in range(n_jobs):
            torus = Torus(draw)
            lines, areas = random_shapes(draw, torus)
            options = options_of(draw, torus)
            self.path("shapes.txt").write_text("\n".join(lines))
            with self.subTest(number=number, options=" ".join(options)):
                outputs = [word for extension in FORMATS for word in ("-o", f"a.{extension}")]
                done = self.run_pcvt("mesh", "--inclusions", "shapes.txt", *options, *outputs, "--force", "--quiet")
                error = done.stderr.decode()
                if done.returncode != 0:
                    self.assertTrue(any(re.search(text, error) for text in REFUSALS), error)
                    refused[error] += 1
                    continue
                self.check_files(torus, options, areas)
        if n_jobs > 15:
            print(n_jobs, "jobs; refused:", dict(refused))
        self.assertLess(sum(refused.values()), 0.2 * n_jobs, refused)


if __name__ == "__main__":
    main()
