"""Results in the plane."""

from ctypes import sizeof

import numpy as np

from . import _structs
from ._arguments import material_text
from ._calls import choice, set_fields, set_integers, set_voxels, text, written
from ._library import library
from ._shown import MOST_SHOWN, one_line, outcome
from ._views import Tile, TorusMesh, inclusions_of, minimum_of, statistics_of


class Result:
    """An optimised periodic tessellation. It never changes.

    lattice     (2, 2), rows a, b
    sites       (n, 2), wrapped into the domain at `origin`
    weights     (n,), length^2, or None without areas: the cell of site i is where
                |p - sites[i]|^2 - weights[i] is least; with an aspect, in its metric
    phases      (n,), the index of each cell's phase in phase_names, or None without phases
    phase_names in the order in which they were given
    orientations
                (n, 3), phi1, Phi, phi2 in degrees, or None without orientations
    inclusions  the shapes of the run as mesh() takes them, given or drawn: ("circle", tag, x, y, r), ("ellipse",
                tag, x, y, a, b, degrees) or ("polygon", tag, corners of shape (k, 2)) each; () without
    orbits      (n,), equal for sites that the symmetry maps to each other, counted from 0 in the order of
                their first sites; None without a symmetry
    statistics  a Statistics
    cells       (n,), the columns of .csv files as an array with the fields site, x, y, weight, area,
                diameter, sides, circularity, phase (an index into phase_names), phi1, Phi, phi2,
                orbit and neighbours; fields that do not apply are NaN, or -1 as a phase or an orbit
    """

    def __init__(self, handle, n_domains=1):
        self._handle, self._n_domains = handle, n_domains
        view = handle.view(library.pcvt_get_sites, _structs.Sites)
        self.lattice = np.array(view.lattice).reshape(2, 2)
        self.sites = handle.array(view.points, np.float64, view.n_sites, 2)
        self.weights = handle.array(view.weights, np.float64, view.n_sites)
        self.phases = handle.array(view.phases, np.int32, view.n_sites)
        self.phase_names = tuple(view.phase_names[k].decode() for k in range(view.n_phases))
        self.inclusions = inclusions_of(handle)
        self.orbits = handle.array(view.orbits, np.int32, view.n_sites)
        self.orientations = handle.array(view.orientations, np.float64, view.n_sites, 3)

    @one_line
    def __repr__(self):
        return outcome(self.statistics)

    def _repr_svg_(self):
        """The tile of cells as notebooks show it; None above 20,000 cells, those of repeated domains included."""
        return None if len(self.sites) * self._n_domains > MOST_SHOWN else self.tile()._repr_svg_()

    @property
    def statistics(self):
        return statistics_of(self._handle)

    @property
    def minimum(self):
        """Whether the result is a minimum of the energy, as the eigenvalues of its Hessian prove: True, or
        False for a saddle. None where they prove neither, for a run that did not converge, with a
        density, and above 10,000 sites. The first use takes time of order n^1.5.
        """
        return minimum_of(self._handle)

    @property
    def cells(self):
        """The measures of the cells that .csv files hold, one entry a site; neighbours are arrays."""
        from ._cells import cell_table

        return cell_table(self)

    def mesh(self, kind="voronoi"):
        """The cells ("voronoi") or triangles ("delaunay") on the torus, a TorusMesh."""
        number = choice("kind", kind, "mesh")
        return TorusMesh(self._handle, self._handle.view(library.pcvt_get_mesh, _structs.Mesh,
                                                         number))

    def tile(self, kind="voronoi", outline="whole"):
        """A Tile of kind "voronoi", "delaunay" or "grains" and outline "whole" or "box"."""
        numbers = choice("kind", kind, "mesh"), choice("outline", outline)
        return Tile(self._handle, self._handle.view(library.pcvt_get_tile, _structs.Tile, *numbers))

    def write(self, path, kind="voronoi", outline="whole", *, report=None, replace=False,
              gltf_nodes="default", float32=False, pixels=0, cut_width=0.0, element="CPE", job="none",
              progress=None, colour="default", background="none", voxels=(0, 0), thickness=0.0, materials=None,
              coriolis=(0.0, 0.0), **fields):
        """Writes a tile, the sites (.txt) or a table of the cells (.csv), by the extension.
        Either the file appears, complete and proved to be a periodic tile, or no file appears.
        Ctrl-C ends the call soon.

        path        None: only the report
        report      also write the statistics of the run to this .json file
        replace     whether files that exist are replaced
        gltf_nodes  of .glb and .gltf: cells (a node for each cell) or one
        float32     of .ply: 32-bit coordinates, and cells as triangles
        pixels      width of .png; 0: 1024
        cut_width   of .svg and .dxf: only lines to cut, of a tile with this width in millimetres
        element     of .inp: CPE (plane strain), CPS (plane stress), or C3D6 or C3D15, one layer of wedges along z
                    (grain_order 1 or 2), which is periodic there as well
        job         of .inp: none, or elastic: materials and steps, so that CalculiX runs the file
        materials   of .inp with job="elastic", and of .vti: the elastic constants of each phase, {name: (E, nu)},
                    (C11, C12, C44) of cubic crystals or (C11, C12, C13, C33, C44) of hexagonal ones (axis z);
                    without phases the name is GRAINS; "same": all phases are the same steel, or with
                    orientations iron, in MPa; or the path of a .yaml file with its phases in the form of DAMASK.
                    A job with two phases needs it
        progress    called with a Progress ten times a second; a true return value cancels
        colour      what colours show: sides, size, cells (neighbours differ), density, phase, orbit or tag
        background  of .svg: none or #rrggbb
        voxels      of .vti: the numbers along x and y; (0, 0): about 16 along h; a third one repeats the layer along z
        thickness   of .foam, and of .inp with wedges: height of the layer along z; 0: sqrt(area / faces)
        coriolis    of .nc: (f, beta) of the Coriolis parameter f + beta y; (0, 0): none
        fields      numbers of pcvt_write_options, by their names in pcvt.h
        """
        options = _structs.WriteOptions(
            struct_size=sizeof(_structs.WriteOptions), kind=choice("kind", kind, "mesh"),
            outline=choice("outline", outline), replace=bool(replace),
            gltf_nodes=choice("gltf_nodes", gltf_nodes, "glb_nodes"),
            element=choice("element", element), job=choice("job", job),
            colour=choice("colour", colour), background=text("background", background),
            single_precision=bool(float32), cut_width=cut_width, thickness=thickness,
            report=None if report is None else text("report", report))
        if materials is not None:
            options.materials = material_text(materials)
        set_integers(options, pixels=pixels)
        set_voxels(options, voxels)
        options.coriolis[:] = coriolis
        set_fields("write", options, fields)
        written(self._handle, path, options, progress)

    def plot(self, kind="voronoi", outline="whole", axes=None):
        """Draws a tile, as Tile.plot()."""
        return self.tile(kind, outline).plot(axes)
