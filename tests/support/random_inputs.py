"""Random lattices, and files that runs of pcvt read: sites, areas, densities, shapes, orientations; good and bad.

Each function takes a random.Random, which decides everything.
"""

import math
import struct
import zlib

FORMULAS = ("1 + u", "1 + 20*exp(-8*v)", "exp(3*sin(2*_pi*u))", "u < 0.4 ? 9 : 1", "1e30", "x^2 + 1")
BAD_FORMULAS = ("0", "-1", "1/u", "u +", "name", "sqrt(-1)", "1e-70", "")
TAGS = ("fibre", "glass", "t-1")


def plane_lattice_option(draw, kind, unit):
    if kind == "bad":
        return "--period", draw.choice(("1", "0,1", "1,x", "nan,1", "1e999,1", "1,1e8", "", "1,1,"))
    if kind in ("box", "long"):
        ratio = 10 ** (draw.uniform(-2.5, 2.5) if kind == "long" else draw.uniform(-0.3, 0.3))
        return "--period", f"{unit * ratio:.9g},{unit:.9g}"
    a = [1, draw.choice((0, draw.uniform(-0.5, 0.5)))]
    b = [draw.uniform(-0.5, 0.5), draw.uniform(0.3, 3)]
    if kind == "sheared":
        times = draw.randrange(-30, 31)
        b = [b[0] + times * a[0], b[1] + times * a[1]]
    if kind == "left":
        a, b = b, a
    return "--lattice", ",".join(f"{unit * x:.9g}" for x in (*a, *b))


def space_lattice_option(draw, kind, unit):
    if kind == "bad":
        return draw.choice((("--period", "1,0,1"), ("--period", "1,1,1e9"), ("--lattice", "1,0,0,0,1,0,1,1,0"),
                            ("--period", "1,,1"), ("--lattice", "1,0,0,0,1,0,0,0,nan")))
    if kind in ("cube", "box", "thin"):
        spread = {"cube": 0, "box": 0.3, "thin": 1.5}[kind]
        return "--period", ",".join(f"{unit * 10 ** draw.uniform(-spread, spread):.9g}" for _ in range(3))
    rows = [[1, 0, 0], [draw.uniform(-0.5, 0.5), 1, 0],
            [draw.uniform(-0.5, 0.5), draw.uniform(-0.5, 0.5), draw.uniform(0.4, 2)]]
    if kind == "sheared":
        times = draw.randrange(-20, 21)
        rows[1] = [x + times * y for x, y in zip(rows[1], rows[0])]
        rows[2] = [x - times * y for x, y in zip(rows[2], rows[1])]
    return "--lattice", ",".join(f"{unit * x:.9g}" for line in rows for x in line)


def row(numbers):
    return " ".join(f"{x:.17g}" for x in numbers)


def good_sites(draw, dimension, n):
    """Sites of unit size: at random, on a grid, a circle or a line, in clusters, or almost coincident."""
    kind = draw.choice(("random", "random", "wide", "grid", "circle", "line", "cluster", "pair", "one"))

    def point():
        return [draw.random() for _ in range(dimension)]

    if kind == "one":
        return [point()]
    if kind == "wide":
        return [[draw.uniform(-50, 50) for _ in range(dimension)] for _ in range(n)]
    if kind == "grid":
        m = max(1, round(n ** (1 / dimension)))
        cells = [[]]
        for _ in range(dimension):
            cells = [[*cell, k / m] for cell in cells for k in range(m)]
        return cells
    if kind == "circle":
        angles = [2 * math.pi * k / n for k in range(n)]
        return [[0.5 + 0.3 * math.cos(t), 0.5 + 0.3 * math.sin(t), 0.5][:dimension] for t in angles]
    if kind == "line":
        return [[(k + 0.5) / n, 0.25, 0.75][:dimension] for k in range(n)]
    if kind == "cluster":
        size = 10 ** draw.uniform(-6, -1)
        return [[0.5 + size * draw.uniform(-1, 1) for _ in range(dimension)] for _ in range(n)] + [point()]
    distance = 10 ** draw.uniform(-12, -3)
    first = point()
    return [first, [first[0] + distance, *first[1:]], *(point() for _ in range(n))]


def bad_sites(draw, dimension):
    good = "0.1 0.2 0.3"[:4 * dimension - 1]
    return draw.choice(("", "# nothing\n", "0.5\n", "a b c\n", f"{good}\n{good}\n", f"{good} 7 7\n", "nan nan nan\n", "1e400 0 0\n",
                        f"{good}\n\x00\xff\n", "1e15 1e15 1e15\n", f"x,y,z\n{good}\n", "[[0.1, 0.2]]\n", f"{good}\n0.5\n"))


def site_text(draw, dimension, unit, may_be_bad):
    """The text of a file of sites, and their number."""
    if may_be_bad and draw.random() < 0.3:
        return bad_sites(draw, dimension), 1
    n = round(10 ** draw.uniform(0, 1.7))
    points = good_sites(draw, dimension, n)
    end = draw.choice(("\n", "\n", "\r\n"))
    lines = [row(unit * x for x in point) for point in points]
    if draw.random() < 0.2:
        lines.insert(0, "# sites")
    return end.join(lines) + end, len(points)


def area_text(draw, n, may_be_bad):
    """One area a site, or too few, too many, negative ones or words."""
    numbers = [f"{10 ** draw.uniform(-1, 1):.6g}" for _ in range(n)]
    fault = draw.choice(("", "", "few", "negative", "word", "wide")) if may_be_bad else draw.choice(("", "", "diameter"))
    if fault == "few":
        numbers = numbers[1:]
    elif fault == "negative":
        numbers[0] = "-1"
    elif fault == "word":
        numbers[0] = "large"
    elif fault == "wide":
        numbers[0] = "1e6"
    elif fault == "diameter":
        numbers.insert(0, "diameter")
    return "\n".join(numbers) + "\n"


def orientation_text(draw, n, may_be_bad):
    lines = [row((draw.uniform(0, 360), draw.uniform(0, 180), draw.uniform(0, 360))) for _ in range(n)]
    if may_be_bad and draw.random() < 0.4:
        lines[0] = draw.choice(("1 2", "a b c", "nan 0 0", "1 500 1", ""))
    return "\n".join(lines) + "\n"


def fixed_text(draw, unit, may_be_bad):
    if may_be_bad and draw.random() < 0.3:
        return bad_sites(draw, 2)
    return "".join(row((unit * draw.random(), unit * draw.random())) + "\n" for _ in range(draw.choice((1, 1, 2))))


def inclusion_text(draw, unit, may_be_bad):
    """The text of a file of shapes, which may overlap or lie inside of each other, and its tags."""
    lines, tags = [], []
    for _ in range(draw.choice((1, 1, 2, 3, 5))):
        tag = draw.choice(TAGS)
        tags.append(tag)
        x, y, r = (unit * draw.uniform(0, 1), unit * draw.uniform(0, 1), unit * draw.uniform(0.02, 0.12))
        lines.append(draw.choice((
            f"circle {tag} {row((x, y, r))}", f"circle {tag} {row((x, y, r))}",
            f"ellipse {tag} {row((x, y, r, r / 3, 30))}",
            f"polygon {tag} {row((x, y, x + r, y, x + r, y + r, x, y + r))}",
            f"polygon {tag} {row((x, y, x + r, y, x + r / 3, y + r))}")))
        if lines[-1].startswith("circle") and draw.random() < 0.2:
            tags.append(draw.choice(TAGS))
            lines.append(f"circle {tags[-1]} {row((x, y, 0.6 * r))}")
    if may_be_bad and draw.random() < 0.3:
        lines.append(draw.choice(("circle", "circle t 0.5 0.5 -1", "square t 0 0 1", "polygon t 0 0 1 1", "circle t 0 0 nan",
                                  "circle a:b 0.5 0.5 0.1", "ellipse t 0 0 0.1 0.1", "circle matrix 0.5 0.5 0.1")))
    return "\n".join(lines) + "\n", tags


def picture(draw):
    """A small grey PNG."""
    width, height = draw.choice(((1, 1), (3, 2), (8, 8)))
    rows = b"".join(b"\0" + bytes(draw.randrange(256) for _ in range(width)) for _ in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def density_option(draw, inputs, may_be_bad):
    """The words of a density; a picture is added to the inputs."""
    if draw.random() < 0.7:
        return ["--density", draw.choice(FORMULAS + BAD_FORMULAS * may_be_bad)]
    data = picture(draw)
    if may_be_bad and draw.random() < 0.3:
        data = draw.choice((b"", b"no picture", data[: len(data) // 2]))
    inputs["grey scale.png"] = data
    words = ["--density", "grey scale.png"]
    if draw.random() < 0.4:
        words += ["--density-range", draw.choice(("1,5", "0.1,2") + ("0,1", "5,1", "1", "1e-70,1") * may_be_bad)]
    return words
