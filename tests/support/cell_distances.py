"""The cells of a file in space against their definition: each element lies in the cell of its site, by distances alone.

A cell has the points p with the least |p - site|^2 - weight. Elements of positive volume that lie in their cells and whose
volumes sum to det L fill the cells exactly; so their volumes are those of the cells. Nothing here builds a cell.
"""

import csv
import itertools

import numpy as np

from support.space_count import require

# Points of cells with many equal distances are joined within 1e-9 h; the distance to a bisector differs by as much.
JOINED = 4e-9
# Terms of the differences of distances that are computed at the same time.
CHUNK = 4_000_000


class Cells:
    """The sites, weights and volumes of one period, from the table of the cells, and the rows of its lattice."""

    def __init__(self, path, lattice):
        with path.open() as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.sites = np.array([[row["x"], row["y"], row["z"]] for row in rows], float)
        self.weights = np.array([row["weight"] or 0 for row in rows], float)
        self.volumes = np.array([row["volume"] for row in rows], float)
        self.lattice = lattice
        self.h = (abs(np.linalg.det(lattice)) / len(rows)) ** (1 / 3)

    def owners_of(self, images):
        """The site of which each point is an image."""
        gap = (images[:, None, :] - self.sites[None]) @ np.linalg.inv(self.lattice)
        return np.abs(gap - np.round(gap)).max(axis=2).argmin(axis=1)


def reduced(lattice):
    """A basis of the lattice such that the vector nearest to a point is at most one step from its rounded coordinates."""
    basis = lattice.astype(float)
    while True:
        basis = basis[np.argsort(np.linalg.norm(basis, axis=1))]
        best = min((basis[2] - i * basis[0] - j * basis[1] for i, j in steps_to(basis[:2], basis[2])), key=np.linalg.norm)
        second = basis[1] - round(basis[1] @ basis[0] / (basis[0] @ basis[0])) * basis[0]
        if np.linalg.norm(best) > 0.999999 * np.linalg.norm(basis[2]) and np.linalg.norm(second) > 0.999999 * np.linalg.norm(basis[1]):
            return basis
        basis = np.array([basis[0], second, best])


def steps_to(pair, vector):
    middle = np.round(np.linalg.lstsq(pair.T, vector, rcond=None)[0]).astype(int)
    return [(middle[0] + i, middle[1] + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]


def shortened(aspect):
    """The map of volume 1 into the space in which cells are those of their sites: it shortens lengths along the axis."""
    if aspect is None:
        return np.eye(3)
    ratio, *axis = aspect
    axis = np.array(axis) / np.linalg.norm(axis)
    return ratio ** (1 / 3) * (np.eye(3) - (1 - 1 / ratio) * np.outer(axis, axis))


def require_cells(cells, points, elements, owners, room, aspect=None):
    """Requires that the corners of each element, padded by -1, lie in one image of the cell of its site, up to the length room."""
    image = shortened(aspect)
    points, sites = points @ image, cells.sites @ image
    basis = reduced(cells.lattice @ image)
    steps = np.array(list(itertools.product((-1, 0, 1), repeat=3)))
    near = steps @ basis
    used = elements >= 0
    centres = np.where(used[:, :, None], points[elements], 0).sum(axis=1) / used.sum(axis=1)[:, None]
    own = owners % len(sites)
    offsets = np.round((centres - sites[own]) @ np.linalg.inv(basis)).astype(int)
    gaps = (sites[own] + offsets @ basis - centres)[:, None, :] + near
    offsets += steps[(gaps**2).sum(axis=2).argmin(axis=1)]
    element, corner = np.nonzero(used)
    rows = np.unique(np.column_stack([elements[element, corner], own[element], offsets[element]]), axis=0)
    places, own = points[rows[:, 0]], rows[:, 1]
    homes = sites[own] + rows[:, 2:] @ basis
    part = max(1, CHUNK // (len(sites) * len(near)))
    for first in range(0, len(rows), part):
        some = slice(first, first + part)
        beyond = excess(places[some], homes[some], own[some], sites, cells.weights, basis, near)
        worst = beyond.argmax()
        require(beyond[worst] < JOINED * cells.h + room,
                f"a corner of an element of cell {own[some][worst]} is outside of it by {beyond[worst] / cells.h:.3g} h")


def excess(places, homes, own, sites, weights, basis, near):
    """By how much each place lies beyond the bisector of its home and any other image of a site: at least 0 up to rounding."""
    inverse = np.linalg.inv(basis)
    gap = places[:, None, :] - sites[None]
    nearest = sites[None] + np.round(gap @ inverse) @ basis
    others = nearest[:, :, None, :] + near
    apart = others - homes[:, None, None, :]
    length = np.linalg.norm(apart, axis=3)
    to_other = ((places[:, None, None, :] - others) ** 2).sum(axis=3) - weights[None, :, None]
    to_home = ((places - homes) ** 2).sum(axis=1) - weights[own]
    is_home = length < 1e-9 * np.abs(basis).max()
    beyond = (to_home[:, None, None] - to_other) / (2 * np.where(is_home, 1, length))
    return np.where(is_home, 0, beyond).max(axis=(1, 2))


def require_volumes(cells, owners, volumes, tolerance):
    """Requires that the volumes of the elements sum to those of the table, cell by cell, over all copies of the period."""
    n = len(cells.volumes)
    copies = round(volumes.sum() / cells.volumes.sum())
    gap = np.abs(np.bincount(owners % n, volumes, n) / copies - cells.volumes).max()
    require(gap < tolerance * cells.h**3, f"the volume of a cell is off that of the table by {gap / cells.h**3:.3g} of the mean")


def require_targets(cells, targets, tolerance=1e-9):
    """Requires that the volumes of the table are the prescribed ones, scaled to the domain."""
    wanted = np.array(targets) / sum(targets) * cells.volumes.sum()
    gap = np.abs(cells.volumes - wanted).max()
    require(gap < tolerance * cells.h**3, f"the volume of a cell is off its target by {gap / cells.h**3:.3g} of the mean")
