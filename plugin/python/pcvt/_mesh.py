"""Runs in the plane and in space."""

import numpy as np

from ._arguments import (period_vectors, refuse_plane_only, set_fixed, set_inclusions,
                         set_aspect, set_materials, set_origin, set_sizes, set_site_phases, set_weights)
from ._calls import (choice, default_options, generated, require_numbers, set_doubles, set_fields, set_integers,
                     set_sites, shaped)
from ._result import Result
from ._shown import count
from ._space import SpaceResult
from ._structs import Options


def mesh(sites, lattice=None, density=None, *, period=None, density_range=(0, 0), origin=(0, 0),
         repeat=(1, 1), seed=0, start="default", solver="default", tolerance=1e-6,
         max_iterations=-1, threads=0, grain_order=0, grain_size=0.0, grain_per_edge=0, short_edges=0.0,
         budget=0, progress=None, areas=None, volumes=None, weights=None, aspect=1.0, phases=None,
         orientations=None, orientation_weights=None, symmetry=None, walls="none", wall_cells="whole",
         fixed=None, inclusions=None, fibres=None, holes=(), duplicates="refuse",
         sites_are_centroids=False, **fields):
    """Generates a periodic centroidal Voronoi tessellation of the plane, or, with three period vectors,
    of space, whose cells are polyhedra. The same arguments give the same result to the last bit.
    Ctrl-C ends the run at the next iteration.

        result = pcvt.mesh(100, ((1, 0, 0), (0.37, 0.81, 0), (0.2, 0.4, 0.9)))
        result.tile().volumes.sum()                  # 0.729, the volume of the domain
        result.write("tile.foam")

    Space has the arguments sites to fields, with its own units: h is the cube root of volume / n,
    and energies have the unit length^5.

    sites           the number of sites, drawn from `seed`; or their positions, shape (n, 2), anywhere
                    in the plane, or (n, 3)
    lattice         (2, 2) or 4 numbers, the period vectors as rows a, b; (3, 3) or 9 numbers: a, b, c, of
                    either orientation; None: the unit square, or with p3 to p6m vectors of length 1
                    at 60 degrees
    period          (width, height) of a rectangle, or (x, y, z) of a box, in place of lattice
    seed            of all random numbers
    start           where drawn sites begin: default (coarse from 1000 sites on, else random), random,
                    coarse (few sites first, then between them more), lattice (the best exact
                    lattice for their number), in the plane best (a global search)
    solver          default, lbfgs, lloyd, in the plane newton
    tolerance       converged once the residual max |x_i - g_i| / h is at most this
    max_iterations  negative: no limit; 0: the periodic Voronoi diagram of the sites as given. With
                    areas: steps that move each site to the centroid of its cell
    threads         0: as many as there are cores
    short_edges     edges of cells shorter than this times h are removed, in space at most 0.1; files of such
                    cells in space are .vtu and .foam
    progress        called with a Progress once an iteration; a true return value cancels. Its
                    `phase` is start or optimise; the later phases belong to write()
    duplicates      given sites nearer to an earlier one than 1e-9 h: refuse, an error that names them all, or
                    drop, which leaves them out with their areas and orientations, and numbers the others
                    from 0 again. See Statistics.dropped
    origin          corner of the domain of the tiles, (x, y), in space (x, y, z); "auto" cuts the outline "box"
                    where the shortest edge is longest, in space where the cut makes the fewest narrow angles
    phases          each cell gets a phase: {name: fraction of the area or volume}, or "NAME:FRACTION,...", with the
                    sum 1; spread evenly, drawn from `seed`; or a list with the name of each site's phase.
                    See Result.phases
    orientations    each cell gets an orientation: shape (n, 3), Bunge's angles phi1, Phi, phi2 in
                    degrees; or "random", drawn from `seed`; or a list of shape (m, 3), from which they
                    are drawn, if m is more than the number of sites or the list has weights. See
                    Result.orientations
    orientation_weights
                    shape (m,), weights of the list of orientations, such as volume fractions
    volumes         in space, cells of prescribed volumes, power cells: shape (n,), positive numbers in any
                    unit, scaled to the volume of the domain; or "equal", "lognormal:S", "gamma:S" or a mixture,
                    drawn from `seed`, with S the standard deviation over the mean of the equivalent diameters.
                    max_iterations centroidal steps, five where it is negative, make the cells round
    aspect          R or (R, degrees): cells R times as long along degrees from x as across, 0.01 to
                    100; in space R or (R, (x, y, z)), along that axis
    repeat          the domains that a tile covers, (columns, rows), in space those that files hold,
                    (columns, rows, layers)
    sites_are_centroids
                    True: sites are the centroids of measured grains, whose sizes areas or volumes give: the
                    sites are found whose cells have these sizes and, as nearly as they can, these
                    centroids. statistics.residual is the largest misfit, in h
    fields          numbers of pcvt_options, by their names in pcvt.h

    The arguments that follow are for the plane only.

    density         periodic, finite and positive: a function of x, y, each float64 of shape (m,),
                    that returns shape (m,) or one number; or, as text, an expression in x, y, u, v
                    or the name of a .png file. None: uniform. A function is called on the calling
                    thread, for a few thousand points at a time
    density_range   of the image; 0, 0: pcvt chooses
    grain_order, grain_size, grain_per_edge, budget
                    as in pcvt.h
    areas           cells of prescribed areas, power cells: shape (n,), positive numbers in any unit,
                    scaled to the area of the domain; or "equal", or "lognormal:S" or "gamma:S", drawn
                    from `seed`, with S the standard deviation over the mean of the equivalent
                    diameters; or a mixture, "0.7*lognormal:0.3@1+0.3*gamma:0.2@3": the share of the
                    cells, their law and their mean diameter in any unit. See Result.weights
    weights         the power cells (Laguerre cells) of given sites that stay where they are, with
                    max_iterations=0: shape (n,), lengths squared, such as radii ** 2
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

    Returns a Result, in space a SpaceResult, also if the run did not converge: see statistics.stop. Raises
    Cancelled, another Error with the library's message, or the exception of density or progress.
    """
    arguments = locals()
    vectors = period_vectors(lattice, period, symmetry)
    dimension = len(vectors)
    if dimension == 3:
        refuse_plane_only(mesh, arguments)
    options = default_options()
    options.dimension = dimension
    # Alive while the library reads them.
    _points = set_sites(options, sites, dimension)
    _areas, _volumes = set_sizes(options, "area", areas), set_sizes(options, "volume", volumes)
    _weights, _phases = set_weights(options, weights), None
    if phases is not None and not isinstance(phases, (str, dict)):
        _phases, phases = set_site_phases(options, phases), None
    _angles = set_materials(options, phases, orientations, orientation_weights)
    _fixed = set_fixed(options, fixed)
    set_inclusions(options, inclusions, fibres, holes)
    columns, rows, *layers = repeat
    set_integers(options, seed=seed, max_iterations=max_iterations, n_threads=threads,
                 columns=columns, rows=rows, layers=layers[0] if layers else 0, grain_order=grain_order,
                 grain_per_edge=grain_per_edge,
                 budget=budget, walls=choice("walls", walls), wall_cells=choice("wall_cells", wall_cells),
                 sites_are_centroids=sites_are_centroids,
                 symmetry=0 if symmetry is None else choice("symmetry", symmetry),
                 duplicates=choice("duplicates", duplicates, dimension=dimension),
                 start=choice("start", start, dimension=dimension),
                 solver=choice("solver", solver, dimension=dimension))
    set_origin(options, origin, dimension)
    set_doubles(options, density_range=density_range,
                **{"lattice" if dimension == 2 else "lattice3": vectors.ravel()})
    set_fields("mesh", options, fields)
    options.tolerance, options.grain_size = tolerance, grain_size
    options.short_edges = short_edges
    set_aspect(options, aspect, dimension)
    handle = generated(options, density, progress)
    if dimension == 2:
        return Result(handle, columns * rows)
    known = [] if duplicates == "drop" else [count(options.n_sites, "site")]
    if max_iterations != 0:
        known.append("converged" if handle.converged else "not converged")
    return SpaceResult(handle, ", ".join(known))


def space(sites, lattice=None, *, period=None, seed=0, start="default", solver="default", tolerance=1e-6,
          max_iterations=-1, threads=0, short_edges=0.0, progress=None, duplicates="refuse", **fields):
    """Calls mesh() with three period vectors, by default those of the unit cube. Returns a SpaceResult.

        result = pcvt.space(sites=100)               # pcvt.mesh(sites=100, period=(1, 1, 1))
    """
    require_numbers("space", Options, fields)
    if lattice is not None:
        shaped("lattice", lattice, (3, 3), (9,))
    if period is not None:
        shaped("period", period, (3,))
    elif lattice is None:
        lattice = np.eye(3)
    return mesh(sites, lattice, period=period, seed=seed, start=start, solver=solver, tolerance=tolerance,
                max_iterations=max_iterations, threads=threads, short_edges=short_edges, progress=progress,
                duplicates=duplicates, **fields)


def pattern(sites, lattice=None, *, period=None, **options):
    """Calls mesh() with start="lattice" and max_iterations=0: the best exact lattice for a number of sites, whose
    cells are all alike. In the plane these are hexagons, as far as the period vectors allow it.

        pcvt.pattern(56).write("pattern.svg")        # the command: pcvt pattern --sites 56 -o pattern.svg

    sites    the number of sites
    lattice, period
             as in mesh(); three vectors: in space
    options  other arguments of mesh(), such as origin, repeat or progress
    """
    return mesh(sites, lattice, period=period, start="lattice", max_iterations=0, **options)
