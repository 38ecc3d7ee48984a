"""Results in three dimensions."""

from ctypes import sizeof

import numpy as np

from . import _structs
from ._arguments import material_text
from ._calls import choice, set_fields, set_voxels, text, written
from ._cells import space_cell_table
from ._library import library
from ._shown import count, one_line, outcome
from ._views import minimum_of, statistics_of


class SpaceResult:
    """An optimised periodic tessellation of space. It never changes.

    sites       (n, 3), wrapped into the domain of the reduced period vectors, as .txt files hold them
    weights     (n,), length^2, or None of Voronoi cells: the cell of site i is where
                |p - sites[i]|^2 - weights[i] is least
    phases      (n,), the index of each cell's phase in phase_names, or None without phases
    phase_names in the order in which they were given
    orientations
                (n, 3), phi1, Phi, phi2 in degrees, or None without orientations
    cells       (n,), the columns of .csv files as an array with the fields site, x, y, z, weight, volume,
                diameter, faces, sphericity, phase (an index into phase_names), phi1, Phi, phi2 and neighbours; fields
                that do not apply are NaN, or -1 as a phase
    statistics  a Statistics; valences[k] cells have k faces, and the energy has the unit length^5. The first
                use builds and proves the tile
    """

    def __init__(self, handle, known):
        self._handle, self._known = handle, known
        self._statistics = None

    @one_line
    def __repr__(self):
        # The statistics count the faces, for which the library builds the tile.
        return self._known if self._statistics is None else outcome(self._statistics)

    def _view(self):
        return self._handle.view(library.pcvt_get_cells, _structs.Cells)

    @property
    def sites(self):
        view = self._view()
        return self._handle.array(view.sites, np.float64, view.n_cells, 3)

    @property
    def weights(self):
        view = self._view()
        return self._handle.array(view.weights, np.float64, view.n_cells)

    @property
    def phases(self):
        view = self._view()
        return self._handle.array(view.phases, np.int32, view.n_cells)

    @property
    def phase_names(self):
        view = self._view()
        return tuple(view.phase_names[k].decode() for k in range(view.n_phases))

    @property
    def orientations(self):
        view = self._view()
        return self._handle.array(view.orientations, np.float64, view.n_cells, 3)

    @property
    def cells(self):
        return space_cell_table(self)

    @property
    def statistics(self):
        if self._statistics is None:
            self._statistics = statistics_of(self._handle)
        return self._statistics

    @property
    def minimum(self):
        """Whether the result is a minimum of the energy, as the eigenvalues of its Hessian prove: True, or
        False for a saddle. None where they prove neither, for a run that did not converge, and above
        2,000 sites. The first use takes time of order n^2.
        """
        return minimum_of(self._handle)

    def tile(self):
        """The cells as one SpaceTile. The first use builds and proves it."""
        return SpaceTile(self._handle, self._view())

    def write(self, path, *, mesh="voronoi", outline="whole", surface="cells", report=None, replace=False, progress=None,
              voxels=(0, 0, 0), materials=None, colour="default", job="none", **fields):
        """Writes the polyhedra (.vtu, .foam), their surfaces (.obj, .ply, .glb, .stl), pictures (.svg, .png), the boundary of the tile
        (.om), tetrahedra (.msh, .inp, .vtu), the cells as voxels (.vti), a table of the cells (.csv)
        or the sites (.txt), by the extension. Either all files
        appear, complete and proved to be a periodic tile, or none. Ctrl-C ends the call soon.

        path        None: only the report

        mesh        what .vtu shows: voronoi, the polyhedra, delaunay, the tetrahedra, or grains, those in cells
        outline     whole: no cell is cut; box: cells and grains are cut along the period vectors at the origin
        surface     what .obj, .ply, .glb and .stl show: cells, or the boundary of the tile
        report      also write the statistics of the run to this .json file
        replace     whether files that exist are replaced
        progress    called with a Progress ten times a second; a true return value cancels
        voxels      of .vti: the numbers along x, y and z; (0, 0, 0): about 16 along h
        materials   of .inp with job="elastic", and of .vti: the elastic constants of the phases, as in the plane
        job         of .inp: none, or elastic: materials and steps, so that CalculiX runs the file
        colour      what the colours of .obj, .ply, .glb, .svg and .png show: faces, size, cells (neighbours differ),
                    phase or orientation (inverse pole figure along z of cubic crystals)
        fields      numbers of pcvt_write_options, by their names in pcvt.h

        Raises OutputError, ArgumentError (another extension), GeometryError (.msh with flat
        tetrahedra, a boundary that touches itself), LimitError, Cancelled, or the exception of progress.
        """
        options = _structs.WriteOptions(struct_size=sizeof(_structs.WriteOptions), replace=bool(replace),
                                        kind=choice("mesh", mesh, dimension=3),
                                        outline=choice("outline", outline, dimension=3),
                                        surface=choice("surface", surface, dimension=3),
                                        colour=choice("colour", colour, dimension=3),
                                        job=choice("job", job, dimension=3),
                                        report=None if report is None else text("report", report))
        if materials is not None:
            options.materials = material_text(materials)
        set_voxels(options, voxels)
        set_fields("write", options, fields)
        written(self._handle, path, options, progress)


class SpaceTile:
    """The cells of one period as a connected tile of whole polyhedra, with the pairing of its
    boundary. Cell s is the cell of site s.

    Face f has the points face_points[face_begin[f]:face_begin[f + 1]]. Inner faces come first; their
    points are counter-clockwise seen from the neighbour, those of boundary faces seen from outside.
    Boundary face n_inner_faces + b is glued to the face partner[b], whose points are those of the face
    plus partner_offset[b] @ lattice: the first of one belongs to the first of the other, the second
    to the last, and so on. For every point p, points[p] = points[point_orbit[p]] + point_offset[p] @
    lattice.

    lattice         (3, 3), rows a, b, c
    points          (n_points, 3)
    point_orbit     (n_points,), the smallest point on the same orbit
    point_offset    (n_points, 3), i, j, k
    face_begin      (n_faces + 1,)
    face_points     (n_face_points,)
    n_inner_faces   the number of faces between two cells of the tile
    owner           (n_faces,), the cell behind each face
    neighbour       (n_faces,), the cell in front of each face; -1 on the boundary
    partner         (n_faces - n_inner_faces,)
    partner_offset  (n_faces - n_inner_faces, 3), i, j, k
    volumes         (n_cells,), length^3; with short_edges, which bends faces, those that finite-volume
                    solvers compute
    site_points     (n_cells, 3), the image of each site in its cell
    """

    def __init__(self, handle, view):
        n_points, n_faces, n_cells = view.n_points, view.n_faces, view.n_cells
        n_boundary = n_faces - view.n_inner_faces
        self.n_inner_faces = view.n_inner_faces
        self.lattice = np.array(view.lattice).reshape(3, 3)
        self.points = handle.array(view.points, np.float64, n_points, 3)
        self.point_orbit = handle.array(view.point_orbit, np.int32, n_points)
        self.point_offset = handle.array(view.point_offset, np.int32, n_points, 3)
        self.face_begin = handle.array(view.face_begin, np.int32, n_faces + 1)
        self.face_points = handle.array(view.face_points, np.int32, view.n_face_points)
        self.owner = handle.array(view.owner, np.int32, n_faces)
        self.neighbour = handle.array(view.neighbour, np.int32, n_faces)
        self.partner = handle.array(view.partner, np.int32, n_boundary)
        self.partner_offset = handle.array(view.partner_offset, np.int32, n_boundary, 3)
        self.volumes = handle.array(view.volumes, np.float64, n_cells)
        self.site_points = handle.array(view.site_points, np.float64, n_cells, 3)

    @one_line
    def __repr__(self):
        return (f"{count(len(self.volumes), 'cell')}, {count(len(self.owner), 'face')}, {len(self.points)} points, "
                f"{len(self.partner)} faces on the seam")

    def polygons(self):
        """The corners of each face, a list of n_faces copies of shape (k, 3)."""
        return np.split(self.points[self.face_points], self.face_begin[1:-1])
