"""The views of a result: statistics, the mesh on the torus, the tile with its seam."""

from ctypes import byref, c_int32, sizeof
from typing import NamedTuple

import numpy as np

from . import _library, _structs
from ._calls import written
from ._library import Error
from ._shown import MOST_SHOWN, count, one_line, outcome, svg_of
from ._words import CHOICES

KINDS = tuple(CHOICES[2]["mesh"])
OUTLINES = tuple(CHOICES[2]["outline"])
FORMS = ("circle", "ellipse", "polygon")
STOPS = ("converged", "iteration-limit", "stalled")
EDGE_PAIR = np.dtype([(name, np.int32) for name in ("v0", "v1", "w0", "w1", "i", "j")])
WALL_EDGE = np.dtype([(name, np.int32) for name in ("wall", "v0", "v1")])


def inclusions_of(handle):
    """The shapes of a result, in the form that mesh() takes."""
    view = handle.view(_library.library.pcvt_get_inclusions, _structs.Inclusions)
    if view.n_shapes == 0:
        return ()
    begin = handle.array(view.begin, np.int32, view.n_shapes + 1)
    numbers = handle.array(view.numbers, np.float64, begin[-1])
    forms = handle.array(view.form, np.int32, view.n_shapes)
    shapes = []
    for form, tag, own in zip(forms, view.tags[:view.n_shapes], np.split(numbers, begin[1:-1])):
        values = (own.reshape(-1, 2),) if FORMS[form] == "polygon" else own.tolist()
        shapes.append((FORMS[form], tag.decode(), *values))
    return tuple(shapes)


def statistics_of(handle):
    """The Statistics of a result."""
    view = handle.view(_library.library.pcvt_get_statistics, _structs.Statistics)
    figures = {name: getattr(view, name) for name in Statistics._fields}
    figures["valences"] = handle.array(view.valences, np.int32, view.n_valences)
    figures["stop"] = STOPS[view.stop]
    dropped = handle.array(view.dropped, np.int32, view.n_dropped, 2)
    figures["dropped"] = np.empty((0, 2), np.int32) if dropped is None else dropped
    return Statistics(**figures)


def minimum_of(handle):
    """True for a minimum, False for a saddle, None where neither is known."""
    number = c_int32()
    _library.checked(_library.library.pcvt_get_minimum(handle.pointer, byref(number)))
    return (None, True, False)[number.value]


class Statistics(NamedTuple):
    """Statistics of a run. In three dimensions the energy has the unit length^5, energy_bound is that of
    truncated octahedra, h the cube root of volume / n, and valences[k] cells have k faces.

    energy        sum over the cells of the integral of density |p - x_i|^2, density x length^4
    energy_bound  5 area^2 / (18 sqrt(3) n) for uniform density, else NaN
    residual      largest |x_i - g_i| / h, h = sqrt(area / n); rms_residual: its root mean square
    valences      int32: valences[k] cells have k sides, edges under 1e-5 h not counted
    stop          "converged", "iteration-limit" or "stalled"
    n_mirrors     -1 if the triangulation was built without mirrors
    area_error    largest |area - target| / target; NaN without areas
    newton_steps  that found the weights; 0 without areas
    dropped       int32 of shape (k, 2): each site that duplicates="drop" left out, by its number in the
                  input, and the earlier site with which it coincides
    """

    energy: float
    energy_bound: float
    residual: float
    rms_residual: float
    seconds_build: float
    seconds_optimize: float
    valences: np.ndarray
    n_hexagons: int
    stop: str
    n_sites: int
    iterations: int
    evaluations: int
    n_threads: int
    n_mirrors: int
    area_error: float
    newton_steps: int
    dropped: np.ndarray

    @one_line
    def __repr__(self):
        return f"{outcome(self)}, {count(self.iterations, 'iteration')}, energy {self.energy:.6g}"


class TorusMesh:
    """Cells or triangles on the torus: one face and one vertex for all of its images.

    Face f has the corners face_begin[f] ... face_begin[f + 1] - 1, counter-clockwise. Corner c of
    it lies at vertices[corner_vertex[c]] + corner_offset[c] @ lattice.

    kind           "voronoi" or "delaunay"
    lattice        (2, 2), rows a, b
    vertices       (n_vertices, 2)
    face_begin     (n_faces + 1,)
    corner_vertex  (n_corners,)
    corner_offset  (n_corners, 2), i, j
    opposite       (n_corners,), the corner that the same edge leaves on the face across
    site           the site of each cell, (n_faces,); triangles: of each vertex, (n_vertices,)
    site_points    (n_faces, 2), the position of the site of each cell; triangles: None
    """

    def __init__(self, handle, view):
        n_vertices, n_faces, n_corners = view.n_vertices, view.n_faces, view.n_corners
        self.kind = KINDS[view.kind]
        self.lattice = np.array(view.lattice).reshape(2, 2)
        self.vertices = handle.array(view.vertices, np.float64, n_vertices, 2)
        self.face_begin = handle.array(view.face_begin, np.int32, n_faces + 1)
        self.corner_vertex = handle.array(view.corner_vertex, np.int32, n_corners)
        self.corner_offset = handle.array(view.corner_offset, np.int32, n_corners, 2)
        self.opposite = handle.array(view.opposite, np.int32, n_corners)
        n_sites = n_faces if self.kind == "voronoi" else n_vertices
        self.site = handle.array(view.site, np.int32, n_sites)
        self.site_points = handle.array(view.site_points, np.float64, n_faces, 2)

    @one_line
    def __repr__(self):
        return f"{self.kind}, {count(len(self.face_begin) - 1, 'face')}, {len(self.vertices)} vertices"


class Tile:
    """One fundamental domain as an open disc, with the pairing of its boundary, the seam. With holes
    it is not a disc.

    The boundary edge v0 -> v1 (its face on the left) is glued to w0 -> w1 (its face on the right):
    points[w] = points[v] + (i, j) @ lattice. Each boundary edge belongs to one pair or one wall. For
    every vertex v, points[v] = points[vertex_orbit[v]] + vertex_offset[v] @ lattice.

    kind           "voronoi", "delaunay" or "grains"
    outline        "whole" or "box"
    lattice        (2, 2), rows a, b; of a repeated tile the repeated lattice
    points         (n_vertices, 2)
    face_begin     (n_faces + 1,): face f has corners[face_begin[f]:face_begin[f + 1]]
    corners        (n_corners,), vertices, face after face, counter-clockwise
    face_site      (n_faces,), the site of each face; of Delaunay triangles: None
    site_points    (n_faces, 2), the position of that site; of Delaunay triangles: None
    vertex_site    (n_vertices,), the site at each vertex of Delaunay triangles, else None
    vertex_orbit   (n_vertices,), the smallest vertex on the same orbit
    vertex_offset  (n_vertices, 2), i, j
    seam           (n_pairs,) with the fields v0, v1, w0, w1, i, j
    wall_edges     (n_wall_edges,) with the fields wall (0: left, 1: right, 2: bottom, 3: top, 4 + k:
                   holes[k]), v0, v1: boundary edges on walls, which are in no pair
    holes          the names of the holes
    """

    def __init__(self, handle, view):
        n_vertices, n_faces = view.n_vertices, view.n_faces
        self._handle = handle
        self.kind = KINDS[view.kind]
        self.outline = OUTLINES[view.outline]
        self.lattice = np.array(view.lattice).reshape(2, 2)
        self.points = handle.array(view.points, np.float64, n_vertices, 2)
        self.face_begin = handle.array(view.face_begin, np.int32, n_faces + 1)
        self.corners = handle.array(view.corners, np.int32, view.n_corners)
        self.face_site = handle.array(view.face_site, np.int32, n_faces)
        self.site_points = handle.array(view.site_points, np.float64, n_faces, 2)
        self.vertex_site = handle.array(view.vertex_site, np.int32, n_vertices)
        self.vertex_orbit = handle.array(view.vertex_orbit, np.int32, n_vertices)
        self.vertex_offset = handle.array(view.vertex_offset, np.int32, n_vertices, 2)
        seam = handle.array(view.edge_pairs, EDGE_PAIR, view.n_edge_pairs)
        self.seam = np.empty(0, EDGE_PAIR) if seam is None else seam
        wall_edges = handle.array(view.wall_edges, WALL_EDGE, view.n_wall_edges)
        self.wall_edges = np.empty(0, WALL_EDGE) if wall_edges is None else wall_edges
        self.holes = [view.hole_names[k].decode() for k in range(view.n_holes)]

    @one_line
    def __repr__(self):
        return (f"{self.kind}, outline {self.outline}, {count(len(self.face_begin) - 1, 'face')}, "
                f"{len(self.points)} points, {count(len(self.seam), 'pair')} on the seam")

    def _repr_svg_(self):
        """The picture that notebooks show, as written to .svg files; None above 20,000 faces."""
        if len(self.face_begin) - 1 > MOST_SHOWN:
            return None
        choices = {"kind": KINDS.index(self.kind), "outline": OUTLINES.index(self.outline)}
        options = _structs.WriteOptions(struct_size=sizeof(_structs.WriteOptions), **choices)
        try:
            return svg_of(lambda path: written(self._handle, path, options, None))
        except (Error, OSError):
            return None

    def polygons(self):
        """The corners of each face, a list of n_faces copies of shape (k, 2)."""
        return np.split(self.points[self.corners], self.face_begin[1:-1])

    def plot(self, axes=None):
        """Draws the tile with matplotlib: the colour of a cell shows its number of sides, hexagons
        are palest; seam edges that one translation glues have one colour.

        axes  of matplotlib; None: the current axes of pyplot

        Returns the axes.
        """
        from ._plot import draw_tile

        return draw_tile(self, axes)
