"""Measures of the cells of a result."""

import numpy as np

# The columns of .csv files, in their order.
CELL = np.dtype([("site", np.int32), ("x", np.float64), ("y", np.float64), ("weight", np.float64),
                 ("area", np.float64), ("diameter", np.float64), ("sides", np.int32),
                 ("circularity", np.float64), ("phase", np.int32), ("phi1", np.float64),
                 ("Phi", np.float64), ("phi2", np.float64), ("orbit", np.int32), ("neighbours", object)])

# Edges shorter than this, in units of sqrt(mean area), do not count as sides.
_SHORT_EDGE = 1e-5


def cell_table(result):
    """One entry for each cell of a Result; fields that do not apply are NaN, or -1 as a phase or an orbit."""
    mesh = result.mesh()
    first, n_corners = mesh.face_begin[:-1], len(mesh.corner_vertex)
    face = np.repeat(np.arange(len(first)), np.diff(mesh.face_begin))
    corner = mesh.vertices[mesh.corner_vertex] + mesh.corner_offset @ mesh.lattice
    after = np.arange(1, n_corners + 1)
    after[mesh.face_begin[1:] - 1] = first
    p, q = (points - corner[first][face] for points in (corner, corner[after]))
    length = np.hypot(*(q - p).T)
    cells = np.empty(len(first), CELL)
    cells["site"] = mesh.site
    cells["x"], cells["y"] = result.sites.T
    cells["weight"] = np.nan if result.weights is None else result.weights
    cells["phase"] = -1 if result.phases is None else result.phases
    cells["orbit"] = -1 if result.orbits is None else result.orbits
    angles = np.full((len(first), 3), np.nan) if result.orientations is None else result.orientations
    cells["phi1"], cells["Phi"], cells["phi2"] = angles.T
    cells["area"] = np.add.reduceat(p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0], first) / 2
    cells["diameter"] = 2 * np.sqrt(cells["area"] / np.pi)
    cells["circularity"] = np.pi * cells["diameter"] / np.add.reduceat(length, first)
    is_side = length > _SHORT_EDGE * np.sqrt(abs(np.linalg.det(mesh.lattice)) / len(first))
    cells["sides"] = np.add.reduceat(is_side.astype(np.int32), first)
    # No cell lies across a wall, or in a hole.
    has_neighbour = is_side & (mesh.opposite >= 0)
    across = mesh.site[face[mesh.opposite[has_neighbour]]]
    n_across = np.add.reduceat(has_neighbour.astype(np.int32), first)
    for cell, sites_across in enumerate(np.split(across, np.cumsum(n_across)[:-1])):
        cells["neighbours"][cell] = sites_across
    return cells


SPACE_CELL = np.dtype([("site", np.int32), ("x", np.float64), ("y", np.float64), ("z", np.float64),
                       ("weight", np.float64), ("volume", np.float64), ("diameter", np.float64), ("faces", np.int32),
                       ("sphericity", np.float64), ("phase", np.int32), ("phi1", np.float64),
                       ("Phi", np.float64), ("phi2", np.float64), ("neighbours", object)])


def space_cell_table(result):
    """One entry for each cell of a SpaceResult."""
    tile = result.tile()
    # Fans of triangles from the first corner of each face.
    first = tile.face_begin[:-1]
    corner = tile.points[tile.face_points]
    face = np.repeat(np.arange(len(first)), np.diff(tile.face_begin))
    after = np.arange(1, len(corner) + 1)
    after[tile.face_begin[1:] - 1] = first
    start = corner[first][face]
    normal = np.add.reduceat(np.cross(corner - start, corner[after] - start), first)
    area = np.sqrt((normal ** 2).sum(axis=1)) / 2
    n_inner = tile.n_inner_faces
    across = np.concatenate([tile.neighbour[:n_inner], tile.owner[tile.partner]])
    # Inner faces have two cells; each side of the seam has its own face.
    owner = np.concatenate([tile.owner, tile.neighbour[:n_inner]])
    other = np.concatenate([across, tile.owner[:n_inner]])
    area = np.concatenate([area, area[:n_inner]])
    cells = np.empty(len(tile.volumes), SPACE_CELL)
    cells["site"] = np.arange(len(cells))
    cells["x"], cells["y"], cells["z"] = result.sites.T
    cells["weight"] = np.nan if result.weights is None else result.weights
    cells["volume"] = tile.volumes
    cells["diameter"] = np.cbrt(6 * tile.volumes / np.pi)
    cells["faces"] = np.bincount(owner, minlength=len(cells))
    cells["sphericity"] = np.pi * cells["diameter"] ** 2 / np.bincount(owner, area, len(cells))
    cells["phase"] = -1 if result.phases is None else result.phases
    angles = np.full((len(cells), 3), np.nan) if result.orientations is None else result.orientations
    cells["phi1"], cells["Phi"], cells["phi2"] = angles.T
    order = np.lexsort((other, owner))
    for cell, sites_across in enumerate(np.split(other[order], np.cumsum(cells["faces"])[:-1])):
        cells["neighbours"][cell] = sites_across
    return cells
