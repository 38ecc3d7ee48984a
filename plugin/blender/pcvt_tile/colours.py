"""The material of each cell. Uses arrays of pcvt only, and nothing of Blender."""

import numpy as np

# The palette of Okabe and Ito without black, which colour-blind people can distinguish.
CELLS = ["#56b4e9", "#e69f00", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7"]
N_COLOURS = len(CELLS)

# Edges shorter than this, in units of h = sqrt(area / n), do not count as sides.
SHORTEST_SIDE = 1e-5


def _cell_of_corner(cells):
    return np.repeat(np.arange(len(cells.face_begin) - 1), np.diff(cells.face_begin))


def sides_of_sites(cells):
    """The number of sides of each site's cell; `cells` is pcvt's mesh of cells on the torus."""
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
    """For each site the set of its neighbours, without itself."""
    cell = _cell_of_corner(cells)
    around = [set() for _ in cells.site]
    for one, other in zip(cells.site[cell].tolist(), cells.site[cell[cells.opposite]].tolist()):
        if one != other:
            around[one].add(other)
    return around


def colours_of_sites(cells):
    """A number below N_COLOURS for each site, different for neighbours on the torus.

    Seven colours are enough (Heawood). On the torus nodes - edges + faces = 0, so there are at most
    three times as many edges as nodes, and some node has at most six neighbours; the same holds
    after that node is removed. Added again in reverse order, each node finds a free colour, and gets
    the least used one.
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
