"""Which material each cell has. It knows arrays of pcvt, and nothing of Blender."""

import numpy as np

# The seven of Okabe and Ito that are not black: the colour-blind can tell them apart too.
CELLS = ["#56b4e9", "#e69f00", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7"]
N_COLOURS = len(CELLS)

# Edges shorter than this, in units of h = sqrt(area / n), are no sides.
SHORTEST_SIDE = 1e-5


def _cell_of_corner(cells):
    return np.repeat(np.arange(len(cells.face_begin) - 1), np.diff(cells.face_begin))


def sides_of_sites(cells):
    """The number of sides of each site's cell, of `cells`, pcvt's mesh of cells on the torus."""
    n_cells, n_corners = len(cells.site), len(cells.corner_vertex)
    corner = cells.vertices[cells.corner_vertex] + cells.corner_offset @ cells.lattice
    following = np.arange(1, n_corners + 1)
    following[cells.face_begin[1:] - 1] = cells.face_begin[:-1]
    length = np.linalg.norm(corner[following] - corner, axis=1)
    h = np.sqrt(abs(np.linalg.det(cells.lattice)) / n_cells)
    counted = _cell_of_corner(cells)[length > SHORTEST_SIDE * h]
    sides = np.empty(n_cells, int)
    sides[cells.site] = np.bincount(counted, minlength=n_cells)
    return sides


def _neighbours(cells):
    """For each site the set of the sites round it, without itself."""
    cell = _cell_of_corner(cells)
    around = [set() for _ in cells.site]
    for one, other in zip(cells.site[cell].tolist(), cells.site[cell[cells.opposite]].tolist()):
        if one != other:
            around[one].add(other)
    return around


def colours_of_sites(cells):
    """A number below N_COLOURS for each site, so that no two neighbours on the torus have the same.

    Seven are enough (Heawood). On the torus nodes - edges + faces = 0, so there are at most three
    times as many edges as nodes, and some node has at most six neighbours; so it is when that one
    is taken away. Put back in reverse, each finds a colour free; it gets the one used least.
    """
    around = _neighbours(cells)
    left = [len(sites) for sites in around]
    removed = [False] * len(around)
    order = []
    ready = [site for site, n in enumerate(left) if n < N_COLOURS]
    while ready:
        site = ready.pop()
        if removed[site]:
            continue
        removed[site] = True
        order.append(site)
        for other in sorted(around[site]):
            left[other] -= 1
            if left[other] < N_COLOURS:
                ready.append(other)
    colours = np.full(len(around), -1)
    used = [0] * N_COLOURS
    for site in reversed(order):
        taken = {colours[other] for other in around[site]}
        colours[site] = min(set(range(N_COLOURS)) - taken, key=lambda c: (used[c], c))
        used[colours[site]] += 1
    return colours
