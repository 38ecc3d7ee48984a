"""Pictures of tiles, by matplotlib."""

import numpy as np

try:
    from matplotlib import pyplot
    from matplotlib.collections import LineCollection, PolyCollection
except ModuleNotFoundError as missing:
    raise ModuleNotFoundError("plots need matplotlib; install it: pip install matplotlib, or on Debian "
                              "python3-matplotlib", name=missing.name) from None

from ._palette import PALE, SIDES


def face_colours(tile):
    if tile.kind != "voronoi":
        return PALE
    sides = np.diff(tile.face_begin)
    return [SIDES[side] for side in np.clip(sides, 3, 9) - 3]


def draw_seam(tile, axes):
    """Draws the edges that one translation (i, j) glues in one colour, with a legend."""
    offsets = np.unique(tile.seam[["i", "j"]])
    for number, offset in enumerate(offsets):
        pairs = tile.seam[tile.seam[["i", "j"]] == offset]
        edges = np.concatenate([np.column_stack([pairs["v0"], pairs["v1"]]),
                                np.column_stack([pairs["w0"], pairs["w1"]])])
        axes.add_collection(LineCollection(tile.points[edges], linewidths=2.5,
                                           colors=f"C{number}", capstyle="round",
                                           label=f"({offset['i']}, {offset['j']})"))


def draw_tile(tile, axes):
    axes = pyplot.gca() if axes is None else axes
    axes.add_collection(PolyCollection(tile.polygons(), facecolors=face_colours(tile),
                                       edgecolors="#404040", linewidths=0.5))
    draw_seam(tile, axes)
    axes.legend(title="(i, j)", loc="center left", bbox_to_anchor=(1, 0.5))
    axes.set_aspect("equal")
    axes.autoscale_view()
    return axes
