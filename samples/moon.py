#!/usr/bin/env python3
"""Draws the picture that the samples use as a density: a half-lit moon with craters.

    samples/moon.py moon.png

The picture has 256 x 256 grey pixels and the same bytes on every run.
"""

import math
import random
import struct
import sys
import zlib

SIZE = 256
RADIUS = 0.42
CRATERS = 26
LIGHT = (-0.62, 0.50, 0.60)


def make_craters():
    """Returns positions and radii of craters on the disc, few of them large and many small."""
    source = random.Random(11)
    craters = []
    while len(craters) < CRATERS:
        x, y = source.uniform(-RADIUS, RADIUS), source.uniform(-RADIUS, RADIUS)
        if math.hypot(x, y) < 0.9 * RADIUS:
            craters.append((x, y, min(0.022 * (1 - source.random()) ** -0.7, 0.11)))
    return craters


def height(craters, x, y):
    """Returns the height at a point: craters are bowls with raised rims; `shade` adds the globe."""
    level = 0.004 * math.sin(23 * x + 11 * y) * math.cos(17 * y - 9 * x)
    for cx, cy, radius in craters:
        r = math.hypot(x - cx, y - cy) / radius
        if r < 2.2:
            level += 0.24 * radius * (min(r, 1.0) ** 2 - 1)
            level += 0.09 * radius * math.exp(-((r - 1) / 0.28) ** 2)
    return level


def shade(craters, x, y):
    """Returns the brightness by Lambert's law, 0 to 1; the sky is black."""
    rest = RADIUS**2 - x * x - y * y
    if rest <= 0:
        return 0.0
    step = 1 / SIZE
    across = (height(craters, x + step, y) - height(craters, x - step, y)) / (2 * step)
    up = (height(craters, x, y + step) - height(craters, x, y - step)) / (2 * step)
    normal = (x / RADIUS - across, y / RADIUS - up, math.sqrt(rest) / RADIUS)
    length = math.sqrt(sum(part * part for part in normal))
    light = sum(part * ray for part, ray in zip(normal, LIGHT)) / length
    # The rim fades over two pixels.
    fade = min(1.0, (RADIUS - math.hypot(x, y)) * SIZE / 2)
    return fade * min(1.0, max(0.015, 1.15 * light))


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def main(path):
    craters = make_craters()
    centres = [(k + 0.5) / SIZE - 0.5 for k in range(SIZE)]
    rows = b"".join(b"\0" + bytes(round(255 * shade(craters, x, -y)) for x in centres)
                    for y in centres)
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
