#!/usr/bin/env python3
"""Draws the picture that the samples take for a density: craters in slanting light, without a seam.

    samples/moon.py moon.png

256 x 256 grey pixels, the same bytes on every run.
"""

import math
import random
import struct
import sys
import zlib

SIZE = 256
CRATERS = 14
LIGHT = (-0.62, 0.55, 0.56)


def wrapped(difference):
    """The shortest way round a torus of side 1."""
    return difference - round(difference)


def make_craters():
    """Position, radius and depth; few large ones and many small ones."""
    source = random.Random(7)
    craters = []
    for _ in range(CRATERS):
        radius = 0.04 * (1 - source.random()) ** -0.7
        craters.append((source.random(), source.random(), min(radius, 0.2)))
    return sorted(craters, key=lambda crater: -crater[2])


def height(craters, x, y):
    """A rolling plain with bowls in it, each with a raised rim."""
    turn = 2 * math.pi
    level = 0.010 * math.sin(turn * (x + 2 * y)) + 0.008 * math.cos(turn * (3 * x - y))
    for cx, cy, radius in craters:
        r = math.hypot(wrapped(x - cx), wrapped(y - cy)) / radius
        if r < 2.2:
            bowl = 0.30 * radius * (min(r, 1.0) ** 2 - 1)
            rim = 0.09 * radius * math.exp(-((r - 1) / 0.28) ** 2)
            level += bowl + rim
    return level


def shade(heights, column, row):
    """Lambert's cosine of the light's angle, 0 to 1."""
    across = (heights[row][(column + 1) % SIZE] - heights[row][column - 1]) * SIZE / 2
    down = (heights[(row + 1) % SIZE][column] - heights[row - 1][column]) * SIZE / 2
    length = math.sqrt(across**2 + down**2 + 1)
    light = (-across * LIGHT[0] + down * LIGHT[1] + LIGHT[2]) / length
    return min(1.0, max(0.0, 0.04 + 1.1 * light))


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def main(path):
    craters = make_craters()
    centres = [(k + 0.5) / SIZE for k in range(SIZE)]
    heights = [[height(craters, x, y) for x in centres] for y in centres]
    rows = b"".join(b"\0" + bytes(round(255 * shade(heights, c, r)) for c in range(SIZE))
                    for r in range(SIZE))
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
