"""Pictures of values on the cells or elements of a tile, for the samples beside this file.

The tile is drawn twice along each of its periods, and once across walls, above a scale of the values.
"""

import math
import pathlib
import re
import sys

WIDTH = 640
BAR_HEIGHT = 70
TICKS = 5
# The smallest quantity that is not 0 in any other unit either.
SMALLEST = 1e-300
# The most digits of a count or of a number of points.
MOST_DIGITS = 12


class BadFile(Exception):
    """A file that cannot be drawn. The message is one line: `file: fault; remedy`."""

    def __init__(self, path, fault, remedy):
        super().__init__(" ".join(f"{path}: {fault}; {remedy}".split()))


def text_of(path, remedy):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise BadFile(path, error.strerror or error, remedy) from None
    except ValueError:
        raise BadFile(path, "this is not a text file in UTF-8, but compressed, binary or in another encoding", remedy) from None


def is_count(word):
    """Returns whether int() takes the word and it has no sign; str.isdigit also accepts '²' and any length."""
    return word.isascii() and word.isdigit() and len(word) <= MOST_DIGITS


def numbers_of(words, n, path, remedy):
    """Returns the numbers of n words or more; all must be finite."""
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        numbers = []
    if len(numbers) < n:
        raise BadFile(path, f"'{' '.join(words)[:60]}' is not {n} numbers", remedy)
    if not all(map(math.isfinite, numbers)):
        raise BadFile(path, f"'{' '.join(words)[:60]}' has a value that is not finite", remedy)
    return numbers


def periods_of(text, path, remedy):
    """Returns the period vectors along which the tile repeats, two or three, as the comments of pcvt state them."""
    found = re.search(r"pcvt lattice (.*)", text)
    if found is None:
        raise BadFile(path, "it has no comment 'pcvt lattice' with the periods", remedy)
    numbers = numbers_of(found[1].split(), 4, path, remedy)
    n = 3 if len(numbers) == 9 else 2
    walls = re.search(r"pcvt walls (.*)", text)
    across = (numbers_of(walls[1].split(), 2, path, remedy)[:2] if walls else [0, 0]) + [0]
    return [tuple(numbers[n * k:n * k + n]) for k in range(n) if not across[k]]


def colour(colours, t):
    """Returns the colour at a share t of the scale."""
    t = min(max(t, 0), 1) * (len(colours) - 1)
    k = min(int(t), len(colours) - 2)
    return "#" + "".join(f"{round(p + (t - k) * (q - p)):02x}" for p, q in zip(colours[k], colours[k + 1]))


def scale_bar(title, colours, largest, digits, top, is_exceeded):
    """Returns a colour bar with the values at its ticks, and the title of the quantity.

    is_exceeded  whether values are above the last tick
    """
    steps, left, width, height = 64, 20, WIDTH - 40, 14
    lines = [f'<text x="{left}" y="{top + 18}">{title}</text>']
    for k in range(steps):
        lines.append(f'<rect x="{left + width * k / steps:.2f}" y="{top + 28}" width="{width / steps + 0.5:.2f}" '
                     f'height="{height}" fill="{colour(colours, (k + 0.5) / steps)}"/>')
    for k in range(TICKS):
        share = k / (TICKS - 1)
        sign = "≥ " if is_exceeded and k == TICKS - 1 else ""
        anchor = "start" if k == 0 else "end" if k == TICKS - 1 else "middle"
        lines.append(f'<text x="{left + width * share:.1f}" y="{top + 28 + height + 18}" '
                     f'text-anchor="{anchor}">{sign}{share * largest:.{digits}g}</text>')
    return lines


class Picture:
    """The text of a picture in SVG: `polygons` of points (x, y), with one of `values` each."""

    def __init__(self, path, polygons, values, periods):
        shifts = [(0.0, 0.0)]
        for a, b in periods:
            shifts += [(x + a, y + b) for x, y in shifts]
        xs, ys = zip(*(point for polygon in polygons for point in polygon)) if polygons else ((0,), (0,))
        self.left, right = min(xs) + min(x for x, _ in shifts), max(xs) + max(x for x, _ in shifts)
        low, self.high = min(ys) + min(y for _, y in shifts), max(ys) + max(y for _, y in shifts)
        if not (right > self.left and self.high > low and math.isfinite(right - self.left + self.high - low)):
            raise BadFile(path, "its elements cover no area", "give a tile that pcvt wrote")
        self.scale = WIDTH / (right - self.left)
        self.bottom = round(self.scale * (self.high - low))
        self.shifts, self.polygons, self.values = shifts, polygons, values

    def place(self, point):
        return f"{self.scale * (point[0] - self.left):.1f},{self.scale * (self.high - point[1]):.1f}"

    def svg(self, title, quantity, colours, largest, digits, stroke, edges=()):
        """Returns the picture.

        stroke  the width of the outlines of polygons, which cover the hairlines between them
        edges   pairs of points, drawn over the polygons
        """
        height = self.bottom + BAR_HEIGHT
        lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
                 f'viewBox="0 0 {WIDTH} {height}">',
                 f"<title>{title}</title>",
                 "<style>@media (prefers-color-scheme: dark) { .ink { fill: #e8eaef } }</style>",
                 f'<defs><g id="tile" stroke-width="{stroke}" stroke-linejoin="round">']
        for polygon, value in zip(self.polygons, self.values):
            shade = colour(colours, value / largest)
            lines.append(f'<polygon points="{" ".join(map(self.place, polygon))}" fill="{shade}" stroke="{shade}"/>')
        if edges:
            path = " ".join(f"M{self.place(v)}L{self.place(w)}" for v, w in edges)
            lines.append(f'<path d="{path}" fill="none" stroke="#0008" stroke-width="0.6"/>')
        lines.append("</g></defs>")
        lines += [f'<use href="#tile" x="{self.scale * x:.2f}" y="{-self.scale * y:.2f}"/>' for x, y in self.shifts]
        lines.append('<g class="ink" font-family="sans-serif" font-size="15" fill="#1c1f26">')
        bar = scale_bar(quantity, colours, largest, digits, self.bottom, max(self.values) > largest)
        return "\n".join([*lines, *bar, "</g>", "</svg>", ""])


def run(draw, usage, n_arguments, n_optional=0):
    """Writes what draw(arguments...) returns to the last argument of the command, which may have further ones before it.

    Exits with 2 and one line if a file cannot be drawn, with 3 if the picture cannot be written.
    """
    if not n_arguments <= len(sys.argv) - 1 <= n_arguments + n_optional:
        print(usage, file=sys.stderr)
        sys.exit(2)
    *arguments, out = sys.argv[1:]
    try:
        picture = draw(*arguments)
    except BadFile as error:
        print(error, file=sys.stderr)
        sys.exit(2)
    try:
        pathlib.Path(out).write_text(picture, encoding="utf-8")
    except OSError as error:
        print(f"{out}: cannot write: {error.strerror or error}; choose another file", file=sys.stderr)
        sys.exit(3)
