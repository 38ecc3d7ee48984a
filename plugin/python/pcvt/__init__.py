"""Periodic centroidal Voronoi tessellations as numpy arrays, by the C interface of pcvt.

    import pcvt
    result = pcvt.mesh(sites=300, lattice=((1, 0), (0.37, 0.81)), seed=7)
    tile = result.tile()                         # cells; result.tile("delaunay"): triangles
    seam = tile.seam                             # pairs of boundary edges v0 -> v1, w0 -> w1
    move = np.column_stack([seam["i"], seam["j"]]) @ tile.lattice
    np.allclose(tile.points[seam["w0"]], tile.points[seam["v0"]] + move)    # True
    result.write("tile.glb")
    result.plot()                                # needs matplotlib

In three dimensions the cells are polyhedra:

    result = pcvt.space(sites=100, period=(1, 1, 1))
    tile = result.tile()                         # points, faces, owner, neighbour, partners
    result.write("tile.vtu")

The environment variable PCVT_LIBRARY names libpcvt.so. Without it the package looks for
libpcvt.so.0.3 in its own folder, in the folder above, in the `lib` that it is installed in, and then
where the system's loader finds libraries.

Arrays are read-only views of the library's memory, without a copy. Each array keeps that memory
alive. Use array.copy() to change one. Numbers are float64 and int32, positions in length units;
sites, vertices and faces are numbered from 0, sites in the order of the input. An offset i, j means
the translation i a + j b, with a, b the rows of `lattice`; an offset i, j, k means i a + j b + k c.
"""

import operator
from ctypes import sizeof

try:
    import numpy as np
except ModuleNotFoundError as missing:
    raise ModuleNotFoundError("pcvt needs numpy; install it: pip install numpy, or on Debian "
                              "python3-numpy", name=missing.name) from None

from . import _library
from ._callbacks import Progress
from ._calls import (DUPLICATES as _DUPLICATES, SOLVERS as _SOLVERS, STARTS as _STARTS, choice as _choice, default_options, doubles as _doubles,
                     generated, set_doubles as _set_doubles, set_integers as _set_integers, set_sites as _set_sites,
                     text as _text, written)
from ._library import (ArgumentError, Cancelled, DensityError, Error, GeometryError, LimitError, OutputError,
                       library)
from ._space import SpaceResult, SpaceTile, space
from ._views import KINDS, OUTLINES, Statistics, Tile, TorusMesh, inclusions_of, minimum_of, statistics_of

__all__ = ["mesh", "space", "version", "Result", "Tile", "TorusMesh", "SpaceResult", "SpaceTile", "Statistics",
           "Progress", "Error", "Cancelled", "ArgumentError", "DensityError", "GeometryError", "LimitError",
           "OutputError"]

_COLOURS = ("default", "sides", "size", "cells", "density", "phase", "orbit", "tag")
_GLTF_NODES = ("default", "cells", "one")
_SYMMETRIES = ("p1", "p2", "pm", "pg", "cm", "pmm", "pmg", "pgg", "cmm", "p4", "p4m", "p4g", "p3", "p3m1", "p31m",
               "p6", "p6m")
_WALLS = ("none", "x", "y", "xy")
_WALL_CELLS = ("whole", "half")
_ELEMENTS = ("CPE", "CPS")
_JOBS = ("none", "elastic")


def version():
    """"major.minor.patch" of the library."""
    return library.pcvt_version().decode()


def _period_vectors(lattice, period, symmetry):
    if period is None and lattice is None:
        is_hexagonal = symmetry is not None and symmetry[1] in "36"
        return ((1, 0), (0.5, 0.75 ** 0.5)) if is_hexagonal else ((1, 0), (0, 1))
    if period is None:
        return lattice
    if lattice is not None:
        raise ArgumentError("lattice and period exclude each other; give one of the two")
    width, height = _doubles("period", period, 2)
    if not (width > 0 and height > 0):
        raise ArgumentError(f"period {period!r}: a side is not above 0; give two positive lengths")
    return ((width, 0), (0, height))


def _set_areas(options, areas):
    """Returns the array that must stay alive as long as the options are used, or None."""
    if areas is None:
        return None
    if isinstance(areas, str):
        options.area_law = _text("areas", areas)
        return None
    array = _doubles("areas", areas, np.size(areas))
    _set_integers(options, n_areas=len(array))
    options.areas = array.ctypes.data
    return array


def _set_materials(options, phases, orientations):
    """Returns the array that must stay alive as long as the options are used, or None."""
    if phases is not None:
        if not isinstance(phases, str):
            phases = ",".join(f"{name}:{float(fraction)!r}" for name, fraction in phases.items())
        options.phases = _text("phases", phases)
    if orientations is None:
        return None
    if isinstance(orientations, str):
        if orientations != "random":
            raise ArgumentError(f"orientations {orientations!r} is unknown; give random or angles")
        options.random_orientations = 1
        return None
    array = _doubles("orientations", orientations, len(orientations), 3)
    _set_integers(options, n_orientations=len(array))
    options.orientations = array.ctypes.data
    return array


def _material_text(materials):
    """Elastic constants as text: {name: numbers}, or text."""
    if not isinstance(materials, str):
        materials = " ".join(f"{name}:" + ",".join(repr(float(x)) for x in np.ravel(constants))
                             for name, constants in materials.items())
    return _text("materials", materials)


def _set_fixed(options, fixed):
    """Returns the array that must stay alive as long as the options are used, or None."""
    if fixed is None:
        return None
    points = _doubles("fixed", fixed, len(fixed), 2)
    _set_integers(options, n_fixed_sites=len(points))
    options.fixed_sites = points.ctypes.data
    return points


def _shape_line(shape):
    """The line of a shape: (word, tag, numbers...), or (word, tag, array of corners)."""
    word, tag, *numbers = shape
    return f"{word} {tag} " + " ".join(repr(float(x)) for part in numbers for x in np.ravel(part))


def _set_inclusions(options, inclusions, fibres, holes):
    if len(holes) > 0:
        options.holes = _text("holes", holes if isinstance(holes, str) else ",".join(holes))
    if fibres is not None:
        options.fibres = ",".join(map(repr, fibres)).encode()
    if inclusions is None:
        return
    if not isinstance(inclusions, str):
        inclusions = "\n".join(map(_shape_line, inclusions))
    options.inclusions = _text("inclusions", inclusions)


def mesh(sites, lattice=None, density=None, *, period=None, density_range=(0, 0), origin=(0, 0),
         repeat=(1, 1), seed=0, start="default", solver="default", tolerance=1e-6,
         max_iterations=-1, threads=0, grain_order=0, grain_size=0.0, grain_per_edge=0, short_edges=0.0,
         budget=0, progress=None, areas=None, aspect=1.0, phases=None,
         orientations=None, symmetry=None, walls="none", wall_cells="whole", fixed=None, inclusions=None, fibres=None, holes=(), duplicates="refuse"):
    """Generates a periodic centroidal Voronoi tessellation. The same arguments give the same result
    to the last bit. Ctrl-C ends the run at the next iteration.

    sites           the number of sites, drawn from `seed`; or their positions, shape (n, 2), anywhere
                    in the plane
    lattice         (2, 2), the period vectors as rows a, b; None: the unit square, or with p3 to p6m
                    vectors of length 1 at 60 degrees
    period          (width, height) of a rectangle, in place of lattice
    density         periodic, finite and positive: a function of x, y, each float64 of shape (m,),
                    that returns shape (m,) or one number; or, as text, an expression in x, y, u, v
                    or the name of a .png file. None: uniform. A function is called on the calling
                    thread, for a few thousand points at a time
    density_range   of the image; 0, 0: pcvt chooses
    origin          corner of the domain of the tiles, (x, y); "auto" cuts the outline BOX where the
                    shortest edge of the cut is longest
    repeat          (columns, rows): the domains that a tile covers
    start           where drawn sites begin: default, random, coarse, lattice, best
    solver          default, lbfgs, lloyd, newton
    tolerance       converged once the residual max |x_i - g_i| / h is at most this
    max_iterations  negative: no limit; 0: the periodic Voronoi diagram of the sites as given. With
                    areas: steps that move each site to the centroid of its cell
    threads         0: as many as there are cores
    grain_order, grain_size, grain_per_edge, short_edges, budget
                    as in pcvt.h
    areas           cells of prescribed areas, power cells: shape (n,), positive numbers in any unit,
                    scaled to the area of the domain; or "equal", or "lognormal:S" or "gamma:S", drawn
                    from `seed`, with S the standard deviation over the mean of the equivalent
                    diameters. See Result.weights
    aspect          R or (R, degrees): cells R times as long along degrees from x as across, 0.01 to
                    100
    phases          each cell gets a phase: {name: fraction of the area}, or "NAME:FRACTION,...", with the
                    sum 1; spread evenly, drawn from `seed`. See Result.phases
    orientations    each cell gets an orientation: shape (n, 3), Bunge's angles phi1, Phi, phi2 in
                    degrees; or "random", drawn from `seed`. See Result.orientations
    symmetry        drawn sites have, and keep, the symmetry of a plane group: p1, p2, pm, pg, cm, pmm, pmg,
                    pgg, cmm, p4, p4m, p4g, p3, p3m1, p31m, p6 or p6m; sites counts those of one period
    walls           straight walls at 0 and at the period in place of periods: x (across x), y, xy, none
    wall_cells      cells beside walls: whole, or half, whose sites lie on the wall; triangles need half
    fixed           sites that stay where they are, shape (k, 2): the first k of the sites; the others are
                    drawn
    inclusions      shapes whose outlines no cell crosses, which may cross the sides of the domain:
                    ("circle", tag, x, y, r), ("ellipse", tag, x, y, a, b, degrees) or ("polygon", tag,
                    corners of shape (k, 2)) each; or text with one a line. The tags become the
                    phases of the cells, after "matrix". See Result.phases
    fibres          (fraction, n) or (fraction, n, gap): in place of inclusions, n circles of the tag
                    "fibre" with this part of the area, at random places by `seed`, not nearer than gap
    holes           tags of inclusions, or one tag: their cells are left out of tiles and files, whose edges
                    there are walls with these names. See Tile.wall_edges
    duplicates      given sites nearer to an earlier one than 1e-9 h: refuse, an error that names them all, or
                    drop, which leaves them out with their areas and orientations, and numbers the others
                    from 0 again. See Statistics.dropped
    progress        called with a Progress once an iteration; a true return value cancels. Its
                    `phase` is start or optimise; the later phases belong to Result.write()

    Returns a Result, also if the run did not converge: see statistics.stop. Raises Cancelled,
    another Error with the library's message, or the exception of density or progress.
    """
    options = default_options()
    # Alive while the library reads them.
    _points, _areas = _set_sites(options, sites, 2), _set_areas(options, areas)
    _angles = _set_materials(options, phases, orientations)
    _fixed = _set_fixed(options, fixed)
    _set_inclusions(options, inclusions, fibres, holes)
    columns, rows = repeat
    _set_integers(options, seed=seed, max_iterations=max_iterations, n_threads=threads,
                  columns=columns, rows=rows, grain_order=grain_order, grain_per_edge=grain_per_edge,
                  budget=budget,
                  walls=_choice("walls", walls, _WALLS),
                  wall_cells=_choice("wall_cells", wall_cells, _WALL_CELLS),
                  symmetry=0 if symmetry is None else 1 + _choice("symmetry", symmetry, _SYMMETRIES),
                  duplicates=_choice("duplicates", duplicates, _DUPLICATES),
                  start=_choice("start", start, _STARTS),
                  solver=_choice("solver", solver, _SOLVERS))
    options.find_origin = isinstance(origin, str) and origin == "auto"
    _set_doubles(options, lattice=_doubles("lattice", _period_vectors(lattice, period, symmetry), 2, 2).ravel(),
                 origin=(0, 0) if options.find_origin else origin, density_range=density_range)
    options.tolerance, options.grain_size = tolerance, grain_size
    options.short_edges = short_edges
    options.aspect, options.aspect_degrees = (aspect, 0) if np.ndim(aspect) == 0 else aspect
    return Result(generated(options, density, progress))


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

    def __init__(self, handle):
        self._handle = handle
        view = handle.view(library.pcvt_get_sites, _library.Sites)
        self.lattice = np.array(view.lattice).reshape(2, 2)
        self.sites = handle.array(view.points, np.float64, view.n_sites, 2)
        self.weights = handle.array(view.weights, np.float64, view.n_sites)
        self.phases = handle.array(view.phases, np.int32, view.n_sites)
        self.phase_names = tuple(view.phase_names[k].decode() for k in range(view.n_phases))
        self.inclusions = inclusions_of(handle)
        self.orbits = handle.array(view.orbits, np.int32, view.n_sites)
        self.orientations = handle.array(view.orientations, np.float64, view.n_sites, 3)

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
        number = _choice("kind", kind, KINDS)
        return TorusMesh(self._handle, self._handle.view(library.pcvt_get_mesh, _library.Mesh,
                                                         number))

    def tile(self, kind="voronoi", outline="whole"):
        """A Tile of kind "voronoi", "delaunay" or "grains" and outline "whole" or "box"."""
        numbers = _choice("kind", kind, KINDS), _choice("outline", outline, OUTLINES)
        return Tile(self._handle, self._handle.view(library.pcvt_get_tile, _library.Tile, *numbers))

    def write(self, path, kind="voronoi", outline="whole", *, report=None, replace=False,
              gltf_nodes="default", float32=False, pixels=0, cut_width=0.0, element="CPE", job="none",
              progress=None, colour="default", background="none", voxels=(0, 0), thickness=0.0, materials=None,
              coriolis=(0.0, 0.0)):
        """Writes a tile, the sites (.txt) or a table of the cells (.csv), by the extension.
        Either the file appears, complete and proved to be a periodic tile, or no file appears.
        Ctrl-C ends the call soon.

        path        None: only the report
        report      also write the statistics of the run to this .json file
        replace     whether files that exist are replaced
        gltf_nodes  of .glb and .gltf: cells (a node for each cell) or one
        float32     of .ply: 32-bit coordinates, and cells as triangles
        pixels      width of .png; 0: 1024
        cut_width   of .svg and .dxf: lines to cut alone, of a tile with this width in millimetres
        element     of .inp: CPE (plane strain) or CPS (plane stress)
        job         of .inp: none, or elastic: materials and steps, so that CalculiX runs the file
        materials   of .inp with job="elastic", and of .vti: the elastic constants of each phase, {name: (E, nu)},
                    (C11, C12, C44) of cubic crystals or (C11, C12, C13, C33, C44) of hexagonal ones (axis z);
                    without phases the name is GRAINS; "same": all phases are the same steel, or with
                    orientations iron, in MPa. A job with two phases needs it
        progress    called with a Progress ten times a second; a true return value cancels
        colour      what colours show: sides, size, cells (neighbours differ), density, phase, orbit or tag
        background  of .svg: none or #rrggbb
        voxels      of .vti: the numbers along x and y; (0, 0): about 16 along h; a third one repeats the layer along z
        thickness   of .foam: height of the layer of cells along z; 0: sqrt(area / faces)
        coriolis    of .nc: (f, beta) of the Coriolis parameter f + beta y; (0, 0): none
        """
        options = _library.WriteOptions(
            struct_size=sizeof(_library.WriteOptions), kind=_choice("kind", kind, KINDS),
            outline=_choice("outline", outline, OUTLINES), replace=bool(replace),
            gltf_nodes=_choice("gltf_nodes", gltf_nodes, _GLTF_NODES),
            element=_choice("element", element, _ELEMENTS), job=_choice("job", job, _JOBS),
            colour=_choice("colour", colour, _COLOURS), background=_text("background", background),
            single_precision=bool(float32), cut_width=cut_width, thickness=thickness,
            report=None if report is None else _text("report", report))
        if materials is not None:
            options.materials = _material_text(materials)
        _set_integers(options, pixels=pixels)
        columns, rows, *layers = voxels
        options.voxels[:] = operator.index(columns), operator.index(rows)
        _set_integers(options, voxel_layers=layers.pop() if layers else 0)
        options.coriolis[:] = coriolis
        written(self._handle, path, options, progress)

    def plot(self, kind="voronoi", outline="whole", axes=None):
        """Draws a tile, as Tile.plot()."""
        return self.tile(kind, outline).plot(axes)


for _name in __all__:  # Messages show the public name.
    globals()[_name].__module__ = __name__
