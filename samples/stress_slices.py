"""Slices of tetrahedra that repeat along three periods, as polygons and lines in a plane, for stress_picture."""

import itertools
import math
import re

from tile_picture import BadFile

CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))
SIDES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3))
NAMES = "uvw"
# The part of each period that is cut away to open the tile, and the weights of the normals of the three faces in the direction
# of the camera.
OPEN, CAMERA = 0.5, (0.75, 0.95, 0.6)


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def cross(p, q):
    return tuple(p[k - 2] * q[k - 1] - p[k - 1] * q[k - 2] for k in range(3))


def scaled(p, factor):
    return tuple(x * factor for x in p)


def normalised(p):
    return scaled(p, 1 / math.sqrt(dot(p, p)))


def reciprocal(periods, path, remedy):
    """Returns the vectors whose products with a position are its fractions of the periods."""
    a, b, c = periods
    volume = dot(a, cross(b, c))
    if not abs(volume) > 0:
        raise BadFile(path, "its periods span no volume", remedy)
    return tuple(scaled(cross(p, q), 1 / volume) for p, q in ((b, c), (c, a), (a, b)))


class Solid:
    """Tetrahedra with their cells, in fractions of the periods."""

    def __init__(self, points, elements, cells, periods, vectors):
        self.fractions = {number: tuple(dot(vector, p) for vector in vectors) for number, p in points.items()}
        self.elements, self.periods = elements, periods
        # Sides between cells, and those on the boundary of a tile of whole cells.
        owners = {}
        for element, corners in elements.items():
            for side in SIDES:
                owners.setdefault(tuple(sorted(corners[k] for k in side)), set()).add(cells[element])
        counts = {}
        for corners in elements.values():
            for side in SIDES:
                key = tuple(sorted(corners[k] for k in side))
                counts[key] = counts.get(key, 0) + 1
        self.boundaries = [side for side, found in owners.items() if len(found) == 2]
        self.outer = [side for side, n in counts.items() if n == 1]

    def polygons(self, axis, place, window):
        """Yields the element and the polygon of each piece of a slice in a window.

        axis, place  the plane at this fraction of this period
        window       the least and the greatest of each other fraction
        """
        for element, corners in self.elements.items():
            for points in shifted_cuts([self.fractions[v] for v in corners], axis, place):
                polygon = around(points)
                for shift in shifts_into(polygon, window):
                    inside = clipped([tuple(x + s for x, s in zip(p, shift)) for p in polygon], window)
                    if len(inside) > 2:
                        yield element, inside

    def lines(self, axis, place, window, sides):
        """Yields the lines in which sides cross a window."""
        for side in sides:
            for points in shifted_cuts([self.fractions[v] for v in side], axis, place):
                for shift in shifts_into(points, window) if len(points) == 2 else ():
                    inside = clipped_line([tuple(x + s for x, s in zip(p, shift)) for p in points], window)
                    if inside:
                        yield inside


def shifted_cuts(corners, axis, place):
    """Yields the points in which the edges between some corners, moved by whole periods, cross a plane."""
    heights = [p[axis] - place for p in corners]
    for whole in range(math.ceil(min(heights)), math.floor(max(heights)) + 1):
        points = []
        for (p, h), (q, g) in itertools.combinations(zip(corners, (height - whole for height in heights)), 2):
            if (h < 0) != (g < 0):
                t = h / (h - g)
                points.append(tuple(x + t * (y - x) for k, (x, y) in enumerate(zip(p, q)) if k != axis))
        if len(points) > 1:
            yield points


def around(points):
    """Returns three or four points in order round their mean."""
    x, y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    return sorted(points, key=lambda p: math.atan2(p[1] - y, p[0] - x))


def shifts_into(points, window):
    """Returns the translations by whole periods that take points to a window."""
    ranges = []
    for k, (low, high) in enumerate(window):
        values = [p[k] for p in points]
        ranges.append(range(math.ceil(low - max(values)), math.floor(high - min(values)) + 1))
    return itertools.product(*ranges)


def clipped(polygon, window):
    """Returns the part of a convex polygon inside of a window."""
    for k, (low, high) in enumerate(window):
        for limit, sign in ((low, 1), (high, -1)):
            inside = []
            for p, q in zip(polygon, polygon[1:] + polygon[:1]):
                h, g = sign * (p[k] - limit), sign * (q[k] - limit)
                if h >= 0:
                    inside.append(p)
                if (h < 0) != (g < 0):
                    t = h / (h - g)
                    inside.append(tuple(x + t * (y - x) for x, y in zip(p, q)))
            polygon = inside
            if not polygon:
                return polygon
    return polygon


def clipped_line(line, window):
    (p, q), begin, end = line, 0.0, 1.0
    for k, (low, high) in enumerate(window):
        step = q[k] - p[k]
        if step == 0:
            if not low <= p[k] <= high:
                return None
            continue
        first, last = sorted(((low - p[k]) / step, (high - p[k]) / step))
        begin, end = max(begin, first), min(end, last)
    if begin >= end:
        return None
    return tuple(tuple(x + t * (y - x) for x, y in zip(p, q)) for t in (begin, end))


def plane_of(word, path):
    """Returns the axis and the fraction of a slice `w=0.5`."""
    found = re.fullmatch(r"([uvw])=(\d*\.?\d+)", word)
    if found is None or not float(found[2]) <= 1:
        raise BadFile(path, f"'{word}' is no slice", "give open, or u=F, v=F or w=F with F from 0 to 1, such as w=0.5")
    return NAMES.index(found[1]), float(found[2])


def flat_view(periods, axis):
    """Returns what places fractions on paper, for a slice across a period, and the two periods on paper."""
    a, b = (period for k, period in enumerate(periods) if k != axis)
    right = normalised(a)
    up = normalised(tuple(y - dot(b, right) * x for x, y in zip(right, b)))
    flat = [(dot(period, right), dot(period, up)) for period in (a, b)]
    return (lambda p: tuple(sum(x * period[k] for x, period in zip(p, flat)) for k in (0, 1))), flat


def open_view(periods, vectors):
    """Returns what places three fractions on paper as a camera sees them that looks at the faces u = 1, v = 0 and w = 1."""
    signs = (1, -1, 1)
    camera = normalised(tuple(sum(weight * sign * normalised(vector)[k] for weight, sign, vector in zip(CAMERA, signs, vectors))
                              for k in range(3)))
    up = normalised(tuple(x - dot(periods[2], camera) * y for x, y in zip(periods[2], camera)))
    right = cross(up, camera)

    def place(fractions):
        point = tuple(sum(f * period[k] for f, period in zip(fractions, periods)) for k in range(3))
        return dot(point, right), dot(point, up)

    return place


# The part of each fraction that is cut away: u and w are seen from their end, v from its beginning.
REMOVED = ((1 - OPEN, 1), (0, OPEN), (1 - OPEN, 1))
# The faces that the camera sees, and those that it sees where the corner is cut away: an axis and a fraction.
FACES, CUTS = ((0, 1), (1, 0), (2, 1)), ((0, 1 - OPEN), (1, OPEN), (2, 1 - OPEN))


def removed_window(axis):
    return tuple(REMOVED[k] for k in range(3) if k != axis)


def rest(span):
    """The part of 0 ... 1 that is not cut away."""
    return (0, span[0]) if span[0] > 0 else (span[1], 1)


def open_windows():
    """Yields the axis, the fraction and the window of each piece of the faces of a tile without the corner next to the camera."""
    for axis, place in FACES:
        first, second = removed_window(axis)
        yield axis, place, (rest(first), (0, 1))
        yield axis, place, (first, rest(second))
    for axis, place in CUTS:
        yield axis, place, removed_window(axis)


def open_edges():
    """Yields the edges of these faces, as pairs of three fractions."""
    for axis, place in FACES:
        first, second = removed_window(axis)
        # Round the face, with the three other corners of the window in place of the one that is cut away.
        corners = []
        for x, y in CORNERS:
            if x in first and y in second:
                # The round comes along y to the corners with an even number, and along x to the others.
                u, v = first[1] if first[0] == x else first[0], second[1] if second[0] == y else second[0]
                ends = [(x, v), (u, v), (u, y)]
                corners += ends if CORNERS.index((x, y)) % 2 == 0 else ends[::-1]
            else:
                corners.append((x, y))
        points = [with_axis(corner, axis, place) for corner in corners]
        yield from zip(points, points[1:] + points[:1])
    for axis, place in CUTS:
        (a, b), (c, d) = removed_window(axis)
        points = [with_axis(corner, axis, place) for corner in ((a, c), (b, c), (b, d), (a, d))]
        yield from zip(points, points[1:] + points[:1])


def with_axis(point, axis, place):
    """Three fractions of two and that of a plane."""
    return (*point[:axis], place, *point[axis:])

