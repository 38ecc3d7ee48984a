/* SPDX-License-Identifier: MIT
 *
 * The C interface of pcvt: periodic centroidal Voronoi tessellations, for hosts in any language.
 * Only this header is under the MIT licence; the library behind it is GPL-3.0-or-later.
 *
 *     pcvt_options options;
 *     pcvt_result* result;
 *     pcvt_tile tile;
 *     pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION);
 *     options.n_sites = 300;
 *     if (pcvt_generate(&options, &result) < 0) puts(pcvt_last_error());
 *     pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile);
 *     ...
 *     pcvt_free(result);
 *
 * In three dimensions the cells are polyhedra: set options.dimension to 3 and options.lattice3, and
 * take pcvt_get_cells() in place of pcvt_get_tile().
 *
 * Rules for the whole interface:
 *   (1) A call that does not return text, a number or nothing returns a status: 0 or positive as
 *       stated below, negative for an error, which pcvt_last_error() then explains.
 *   (2) No exception, signal, exit or output leaves the library. It neither uses nor changes the
 *       locale and the floating-point environment of the host, and calls callbacks in the latter.
 *   (3) A result never changes. Its views borrow its memory and are valid until pcvt_free(). The
 *       same holds for proofs and studies.
 *   (4) The same options give the same result to the last bit, for any number of threads, but for
 *       measured times.
 *   (5) Positions are x, y in length units, in three dimensions x, y, z. Sites are numbered from 0
 *       in the order of the input, everything else from 0 as well. An offset i, j means the
 *       translation i a + j b, and i, j, k means i a + j b + k c, with a, b, c the period vectors
 *       of the options, or in a tile of its own `lattice`.
 *   (6) While the major version is 0, a host needs a library of the same minor version;
 *       PCVT_ABI_VERSION is the version of the host.
 */
#ifndef PCVT_H
#define PCVT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define PCVT_API __attribute__((visibility("default")))
#else
#define PCVT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** major << 16 | minor of the interface that this header describes. */
#define PCVT_ABI_VERSION 0x00000003u

/** How a call ended. */
typedef int32_t pcvt_status;
enum {
    PCVT_OK = 0,
    /** The progress callback cancelled the run; there is no result. */
    PCVT_CANCELLED = 1,
    /** There is a result, but the run ended above the tolerance: at the iteration limit, or at the
     *  limit of double precision. Not for max_iterations = 0. */
    PCVT_NOT_CONVERGED = 2,
    /** pcvt_check() found that a file is damaged, not a periodic tile, or without a property. */
    PCVT_REFUTED = 3,
    /** A null pointer, a value that is out of range or not finite, or an unknown choice. */
    PCVT_ERROR_ARGUMENT = -1,
    /** A struct of an unknown size or with unknown fields, or another version. */
    PCVT_ERROR_ABI = -2,
    /** A density that is not finite and positive, or a callback that threw. */
    PCVT_ERROR_DOMAIN = -3,
    /** Out of memory, or a limit of pcvt. */
    PCVT_ERROR_MEMORY = -4,
    /** Coincident sites, cells that are too small, or cells that the format of a file refuses. */
    PCVT_ERROR_GEOMETRY = -5,
    /** A file could not be written. */
    PCVT_ERROR_IO = -6,
    /** A fault of pcvt. */
    PCVT_ERROR_INTERNAL = -7
};

/** Where the sites begin when none are given. Three dimensions have DEFAULT, which is COARSE there
 *  from 1000 sites on that are optimised, else RANDOM; RANDOM; COARSE; and LATTICE, the best exact
 *  lattice for n_sites. */
enum {
    PCVT_START_DEFAULT = 0,
    PCVT_START_RANDOM = 1,
    PCVT_START_COARSE = 2,
    PCVT_START_LATTICE = 3,
    PCVT_START_BEST = 4
};

/** Three dimensions have DEFAULT, which is LBFGS there, LBFGS and LLOYD. */
enum {
    PCVT_SOLVER_DEFAULT = 0,
    PCVT_SOLVER_LBFGS = 1,
    PCVT_SOLVER_LLOYD = 2,
    PCVT_SOLVER_NEWTON = 3
};

/** The faces of a mesh or tile: Voronoi cells, Delaunay triangles, triangles inside of cells; in
 * three dimensions cells, Delaunay tetrahedra, tetrahedra inside of cells. */
enum { PCVT_VORONOI = 0, PCVT_DELAUNAY = 1, PCVT_GRAINS = 2 };

/** The boundary of a tile: no cell is cut, or cut along the period parallelogram. */
enum { PCVT_WHOLE = 0, PCVT_BOX = 1 };

/** The nodes of a glTF file: one for each cell, or one for all, which then share their vertices. */
enum { PCVT_NODES_DEFAULT = 0, PCVT_NODES_CELLS = 1, PCVT_NODES_ONE = 2 };

/** The elements of .inp files: triangles for plane strain or plane stress, or one layer of wedges
 *  along z, which is periodic there as well, of pcvt_options.grain_order 1 (C3D6) or 2 (C3D15). */
enum { PCVT_CPE = 0, PCVT_CPS = 1, PCVT_C3D6 = 2, PCVT_C3D15 = 3 };

/** Contents of .inp files besides the mesh: nothing, or materials and steps that CalculiX runs. */
enum { PCVT_JOB_NONE = 0, PCVT_JOB_ELASTIC = 1 };

/** Contents of .obj, .ply, .glb and .stl in space: every cell, or the boundary of the tile. */
enum { PCVT_SURFACE_CELLS = 0, PCVT_SURFACE_BOUNDARY = 1 };

/** The quantity that the colours of a file show, CELLS: neighbours differ. */
enum { PCVT_COLOUR_DEFAULT = 0, PCVT_COLOUR_SIDES = 1, PCVT_COLOUR_SIZE = 2 };
enum { PCVT_COLOUR_CELLS = 3, PCVT_COLOUR_DENSITY = 4, PCVT_COLOUR_PHASE = 5 };
enum { PCVT_COLOUR_ORBIT = 6, PCVT_COLOUR_TAG = 7 };
/* In three dimensions, of SIZE, CELLS, PHASE and these: */
enum { PCVT_COLOUR_FACES = 8, PCVT_COLOUR_ORIENTATION = 9 };

/** The plane group of drawn sites (International Tables A). Any lattice fits P1 and P2. */
enum { PCVT_SYMMETRY_NONE = 0, PCVT_SYMMETRY_P1 = 1, PCVT_SYMMETRY_P2 = 2 };
/*  Rectangles; the mirrors and glides of PM, PG and CM, and the mirrors of PMG, lie along a. */
enum { PCVT_SYMMETRY_PM = 3, PCVT_SYMMETRY_PG = 4, PCVT_SYMMETRY_CM = 5, PCVT_SYMMETRY_PMM = 6 };
enum { PCVT_SYMMETRY_PMG = 7, PCVT_SYMMETRY_PGG = 8, PCVT_SYMMETRY_CMM = 9 };
/*  Squares. */
enum { PCVT_SYMMETRY_P4 = 10, PCVT_SYMMETRY_P4M = 11, PCVT_SYMMETRY_P4G = 12 };
/*  Two equal lengths at 60 or 120 degrees, such as 1, 0, 0.5, sqrt(0.75). */
enum { PCVT_SYMMETRY_P3 = 13, PCVT_SYMMETRY_P3M1 = 14, PCVT_SYMMETRY_P31M = 15 };
enum { PCVT_SYMMETRY_P6 = 16, PCVT_SYMMETRY_P6M = 17 };

/** The sides of the domain that are walls: across x, across y, all four. */
enum { PCVT_WALLS_NONE = 0, PCVT_WALLS_X = 1, PCVT_WALLS_Y = 2, PCVT_WALLS_XY = 3 };

/** The cells beside walls: whole, or halves of cells whose sites lie on the wall. */
enum { PCVT_WALL_CELLS_WHOLE = 0, PCVT_WALL_CELLS_HALF = 1 };

/** One wall: at x = 0, at the width, at y = 0, at the height. */
enum {
    PCVT_WALL_LEFT = 0,
    PCVT_WALL_RIGHT = 1,
    PCVT_WALL_BOTTOM = 2,
    PCVT_WALL_TOP = 3,
    PCVT_WALL_HOLE = 4
};

/** The treatment of given sites that are nearer to an earlier one than 1e-9 h. */
enum { PCVT_DUPLICATES_REFUSE = 0, PCVT_DUPLICATES_DROP = 1 };

/** Why a run ended. */
enum { PCVT_STOP_CONVERGED = 0, PCVT_STOP_ITERATION_LIMIT = 1, PCVT_STOP_STALLED = 2 };

/** The phases of a run, in their order; a run may leave out some. */
enum {
    PCVT_PHASE_START = 0,    /**< placing or searching sites to begin with */
    PCVT_PHASE_OPTIMISE = 1, /**< and the runs of pcvt_study() */
    PCVT_PHASE_BUILD = 2,    /**< this phase and the next ones: in pcvt_write() */
    PCVT_PHASE_PROVE = 3,    /**< and in pcvt_check() */
    PCVT_PHASE_WRITE = 4     /**< and in pcvt_study() */
};

/** Whether a result is a minimum of the energy, as the eigenvalues of the Hessian prove. */
enum { PCVT_MINIMUM_UNKNOWN = 0, PCVT_MINIMUM_YES = 1, PCVT_MINIMUM_NO = 2 };

/** The state of a run. Later versions may append fields. */
typedef struct pcvt_progress {
    size_t struct_size;
    int32_t iteration;
    int32_t evaluations;
    double energy;       /**< density x length^4; in three dimensions length^5 */
    double energy_bound; /**< of the hexagonal lattice for uniform density, else NaN; in three
                            dimensions of the body-centred cubic lattice */
    double residual;     /**< largest |x_i - g_i| / h, h = sqrt(area / n_sites); in three dimensions
                            the cube root of volume / n_sites */
    double rms_residual; /**< its root mean square */
    int32_t phase;       /**< PCVT_PHASE_... */
    int32_t reserved;
    double fraction;        /**< part of the phase that is done, 0 to 1; negative: unknown. It never
                               falls within a phase */
    const char* phase_text; /**< the phase in words, "writing big.msh, 1 of 1"; valid during the
                               call of the callback */
} pcvt_progress;

/** Called on the thread that called pcvt_generate(), pcvt_write(), pcvt_check() or pcvt_study():
 *  once an iteration, at the beginning of each later phase, and ten times a second in long steps.
 *  Non-zero cancels soon. */
typedef int (*pcvt_progress_callback)(const pcvt_progress* progress, void* data);

/** A density at many points, called only on the thread that called pcvt_generate().
 *
 *  It must be periodic, finite and positive, and depend only on the point.
 *  @param points  n_points pairs x, y; anywhere in the plane.
 *  @param values  n_points numbers, to be filled.
 *  @returns       0; any other number ends the run with PCVT_ERROR_DOMAIN.
 */
typedef int (*pcvt_density_callback)(const double* points, size_t n_points, double* values,
                                     void* data);

/** The options of a run. pcvt_options_init() fills in the defaults, given here in brackets. */
typedef struct pcvt_options {
    size_t struct_size;
    double lattice[4];   /**< ax, ay, bx, by: any two independent period vectors [1, 0, 0, 1] */
    double origin[2];    /**< corner of the domain of the tiles, which is the parallelogram of the
                            period vectors; if these are not reduced, PCVT_WHOLE takes the reduced
                            parallelogram with the same centre; in three dimensions x and y of
                            the corner of the parallelepiped [0, 0] */
    const double* sites; /**< n_sites pairs x, y, anywhere in the plane, or triples x, y, z,
                            anywhere in space; NULL: drawn from seed [NULL] */
    int32_t n_sites;     /**< at least 1, at most 2^28, in three dimensions 2^26 [0: an error] */
    int32_t start;       /**< PCVT_START_...; only where `sites` is NULL [default] */
    uint64_t seed;       /**< [0] */
    int32_t solver;      /**< PCVT_SOLVER_... [default] */
    int32_t max_iterations; /**< negative: no limit; 0: the Voronoi diagram of the sites as given;
                               with areas: steps that move each site to the centroid of its cell
                               [-1] */
    double tolerance;       /**< converged once the residual is at most this [1e-6] */
    int32_t n_threads;      /**< 0: as many as there are cores; at most 1024 [0] */
    int32_t columns;        /**< a tile covers columns x rows domains, at least 1 [1] */
    int32_t rows;           /**< [1] */
    int32_t grain_order; /**< of the triangles of PCVT_GRAINS: 1, or 2 with mid-side nodes [0: 1] */
    double grain_size;   /**< edge length of these triangles, in three dimensions of the tetrahedra
                            [0: pcvt chooses] */
    double short_edges;  /**< removes cell edges shorter than this times h; in three dimensions at
                            most 0.1, and for files that state it (.vtu, .foam) [0: none] */
    int64_t budget;      /**< evaluations of PCVT_START_BEST [0: pcvt chooses] */
    const char* density_source; /**< expression in x, y, u, v, or the name of a .png file [NULL] */
    double density_range[2];    /**< of the image; 0, 0: pcvt chooses [0, 0] */
    pcvt_density_callback density; /**< excludes density_source; both NULL: uniform [NULL] */
    void* density_data;
    pcvt_progress_callback progress; /**< [NULL] */
    void* progress_data;
    int32_t grain_per_edge; /**< parts of each cell edge; excludes grain_size [0: grain_size] */
    int32_t find_origin;    /**< 1: tiles with PCVT_BOX ignore `origin`; they are cut where the
                               shortest edge of the cut is longest, in three dimensions where
                               the cut makes the fewest narrow angles [0] */
    const double* areas; /**< n_areas positive numbers, in any unit: cells whose areas are to each
                            other as these, as power cells; excludes a density [NULL] */
    int32_t n_areas;     /**< n_sites, or 0 where `areas` is NULL [0] */
    int32_t reserved;
    const char* area_law; /**< "equal", or "lognormal:S" or "gamma:S", drawn from `seed`, with S the
                             standard deviation over the mean of the equivalent diameters, or a
                             mixture "SHARE*LAW@MEAN+SHARE*LAW@MEAN", the share of the cells and
                             their mean diameter in any unit; excludes `areas` [NULL] */
    double aspect; /**< the length of the cells along aspect_degrees over their width, 0.01 to
                      100 [1] */
    double aspect_degrees; /**< from x, in two dimensions; see aspect_axis for three [0] */
    const char* phases; /**< "NAME:FRACTION,NAME:FRACTION,...": each cell gets a phase; fractions of
                           the area, sum 1, spread evenly, drawn from `seed` [NULL] */
    const double* orientations;  /**< n_orientations triples phi1, Phi, phi2, Bunge's angles in
                                    degrees, one a site; or a list from which orientations are
                                    drawn by `seed`, if it is longer or has weights [NULL] */
    int32_t n_orientations;      /**< at least n_sites, or with weights at least 1; 0 where
                                    `orientations` is NULL [0] */
    int32_t random_orientations; /**< 1: orientations without a texture, drawn from `seed`; excludes
                                    `orientations` [0] */
    int32_t symmetry; /**< PCVT_SYMMETRY_...: drawn sites have, and keep, the symmetry of a group,
                         which the lattice must fit; excludes `sites`, areas, PCVT_START_LATTICE
                         and PCVT_START_BEST [PCVT_SYMMETRY_NONE] */
    int32_t walls; /**< PCVT_WALLS_...: straight walls at 0 and at the period in place of periods,
                      of a lattice (width, 0, 0, height); excludes aspect, symmetry,
                      PCVT_START_LATTICE and PCVT_START_BEST [PCVT_WALLS_NONE] */
    int32_t wall_cells; /**< PCVT_WALL_CELLS_...; Delaunay triangles need halves
                           [PCVT_WALL_CELLS_WHOLE] */
    int32_t reserved2;
    const char* inclusions; /**< shapes whose outlines no cell crosses, one a line: "circle TAG x y
                               r", "ellipse TAG x y a b DEGREES" or "polygon TAG x1 y1 x2 y2 ...";
                               images are implied; the tags are the phases of the cells, after
                               "matrix"; shapes do not touch walls; excludes `sites`, phases, areas,
                               aspect, symmetry and starts other than PCVT_START_RANDOM [NULL] */
    const char* fibres; /**< "FRACTION,N" or "FRACTION,N,GAP": in place of inclusions, N circles of
                           the tag "fibre" with this part of the area, at random places by `seed`,
                           not nearer than GAP to each other and to walls [NULL] */
    const double* fixed_sites; /**< n_fixed_sites pairs x, y that stay where they are; they are the
                                  first of n_sites, the others are drawn; excludes `sites`, areas,
                                  symmetry, walls, inclusions and starts other than
                                  PCVT_START_RANDOM [NULL] */
    int32_t n_fixed_sites;     /**< at most n_sites; 0 where `fixed_sites` is NULL [0] */
    int32_t reserved3;
    const char* holes; /**< tags of inclusions with commas between them: their cells are left out of
                          tiles and files, whose edges there are walls; their sites are left out of
                          pcvt_sites, and the others are numbered from 0 again [NULL] */
    int32_t dimension; /**< 2 or 3. With 3 the cells are polyhedra, and the fields that apply are
                          sites, n_sites, start, seed, solver, max_iterations, tolerance,
                          n_threads, progress, progress_data, short_edges, lattice3 and duplicates;
                          any other field is refused unless it has its default [2] */
    int32_t reserved4;
    double lattice3[9]; /**< ax, ay, az, bx, by, bz, cx, cy, cz: any three independent period
                           vectors, of either orientation; refused unless it has its default with
                           dimension 2 [1, 0, 0, 0, 1, 0, 0, 0, 1] */
    int32_t duplicates; /**< PCVT_DUPLICATES_...: `sites` or `fixed_sites` nearer to an earlier one
                           than 1e-9 h, h = sqrt(area / n_sites), in three dimensions the cube root
                           of volume / n_sites, modulo the lattice: an error that names them all, or
                           left out, with their areas and orientations, and the others are numbered
                           from 0 again; see pcvt_statistics [PCVT_DUPLICATES_REFUSE] */
    int32_t n_weights;  /**< n_sites, or 0 where `weights` is NULL [0] */
    const double* weights;      /**< n_weights lengths squared: the power cells of `sites`, which
                                   stay where they are; needs max_iterations 0 [NULL] */
    const int32_t* site_phases; /**< n_site_phases indices from 0: the phase of each site, of the
                                   names that `phases` then lists as "NAME,NAME,..." [NULL] */
    int32_t n_site_phases;      /**< n_sites, or 0 where `site_phases` is NULL [0] */
    int32_t reserved5;

    double origin_z; /**< in three dimensions: the third coordinate of `origin` [0] */

    const double* volumes;  /**< in three dimensions: n_volumes volumes of the cells in any unit,
                               scaled to the volume of the domain, one a site; NULL: none */
    const char* volume_law; /**< in three dimensions: "equal", "lognormal:S", "gamma:S" or a
                               mixture, as area_law, in place of `volumes`; NULL: none */
    int32_t n_volumes;      /**< n_sites, or 0 where `volumes` is NULL [0] */
    int32_t reserved6;

    const double* orientation_weights; /**< n_orientations numbers from 0 on, not all 0, by which
                                          `orientations` are drawn [NULL] */
    double aspect_axis[3]; /**< in three dimensions: the axis along which the cells are `aspect`
                              times as long as across it; all 0: x [0, 0, 0] */
    int32_t layers; /**< in three dimensions: the periods along the third vector that files hold, as
                       `columns` and `rows` along the others; views show one period [0: one] */
    int32_t sites_are_centroids; /**< 1: `sites` are the centroids of measured grains, whose sizes
                                    are `areas` or `volumes`: the sites are found whose cells have
                                    these sizes and, as nearly as they can, these centroids, and
                                    residuals are those of the centroids; excludes walls and aspect
                                    [0] */
} pcvt_options;

/** The optimised sites. */
typedef struct pcvt_sites {
    double lattice[4];    /**< as in the options */
    const double* points; /**< n_sites pairs x, y, wrapped into the domain at `origin` */
    int32_t n_sites;
    int32_t reserved;
    const double* weights; /**< n_sites numbers, length^2; NULL without areas. The cell of site i is
                              where |p - x_i|^2 - weights[i] is least; with an aspect, lengths are
                              those of its metric */
    const int32_t* phases; /**< n_sites indices into phase_names; NULL without phases */
    const char* const* phase_names; /**< n_phases names; NULL without phases */
    const double* orientations;     /**< n_sites triples phi1, Phi, phi2 in degrees, or NULL */
    int32_t n_phases;
    int32_t n_orbits; /**< 0 without a symmetry */
    const int32_t*
        orbits; /**< n_sites numbers, equal for sites that the symmetry maps to each other,
                   counted from 0 in the order of their first sites; NULL without one */
} pcvt_sites;

/** The form of an inclusion. */
enum { PCVT_CIRCLE = 0, PCVT_ELLIPSE = 1, PCVT_POLYGON = 2 };

/** The inclusions of a run, as they were given or drawn; images are implied, and those that were
 *  listed as well are left out.
 *
 *  Shape k has numbers[begin[k]] ... numbers[begin[k + 1] - 1]: x, y, r of a circle, x, y, a, b and
 *  degrees of an ellipse, x and y of each corner of a polygon.
 */
typedef struct pcvt_inclusions {
    const double* numbers;   /**< NULL without inclusions, as the others */
    const int32_t* begin;    /**< n_shapes + 1 numbers */
    const int32_t* form;     /**< PCVT_CIRCLE, PCVT_ELLIPSE or PCVT_POLYGON */
    const char* const* tags; /**< the name of the tag of each shape */
    int32_t n_shapes;        /**< 0 without inclusions */
    int32_t reserved;
} pcvt_inclusions;

/** The cells or the triangles on the torus: one face and one vertex for all of its images.
 *
 *  Face f has the corners face_begin[f] ... face_begin[f + 1] - 1, counter-clockwise. Its corner c
 *  lies at vertices[corner_vertex[c]] + the translation of corner_offset[c].
 */
typedef struct pcvt_mesh {
    double lattice[4];            /**< as in the options */
    const double* vertices;       /**< n_vertices pairs x, y */
    const int32_t* face_begin;    /**< n_faces + 1 numbers */
    const int32_t* corner_vertex; /**< n_corners numbers */
    const int32_t* corner_offset; /**< n_corners pairs i, j */
    const int32_t* opposite;      /**< the corner that the same edge leaves on the face across; -1
                                     on walls */
    const int32_t* site;          /**< the site of each face (cells) or vertex (triangles) */
    const double* site_points;    /**< position of the site of each cell, x, y; triangles: NULL */
    int32_t kind;                 /**< PCVT_VORONOI or PCVT_DELAUNAY */
    int32_t n_vertices;
    int32_t n_faces;
    int32_t n_corners;
} pcvt_mesh;

/** The boundary edge v0 -> v1 of a tile (its face on the left) is glued to w0 -> w1 (its face on
 *  the right): position(w_k) = position(v_k) + i a + j b for k = 0 and 1. */
typedef struct pcvt_edge_pair {
    int32_t v0, v1;
    int32_t w0, w1;
    int32_t i, j;
} pcvt_edge_pair;

/** The boundary edge v0 -> v1 of a tile (its face on the left) lies on a wall. */
typedef struct pcvt_wall_edge {
    int32_t wall; /**< PCVT_WALL_LEFT, ...; PCVT_WALL_HOLE + k for hole_names[k] */
    int32_t v0, v1;
} pcvt_wall_edge;

/** A tile: a mesh of one fundamental domain as an open disc, with the pairing of its boundary.
 *
 *  For each vertex v: position(v) = position(vertex_orbit[v]) + the translation of
 *  vertex_offset[v]. Each boundary edge belongs to exactly one of the edge pairs or wall edges. A
 *  tile with holes is not a disc, and need not be connected before gluing.
 */
typedef struct pcvt_tile {
    double lattice[4];            /**< columns a, rows b */
    const double* points;         /**< n_vertices pairs x, y */
    const int32_t* face_begin;    /**< n_faces + 1 numbers: face f has corners face_begin[f] ... */
    const int32_t* corners;       /**< n_corners vertices, face after face, counter-clockwise */
    const int32_t* face_site;     /**< the site of each face; of Delaunay triangles: NULL */
    const double* site_points;    /**< position of that site, x, y; of Delaunay triangles: NULL */
    const int32_t* vertex_site;   /**< the site at each vertex of Delaunay triangles, else NULL */
    const int32_t* vertex_orbit;  /**< the smallest vertex on the same orbit */
    const int32_t* vertex_offset; /**< n_vertices pairs i, j */
    const pcvt_edge_pair* edge_pairs; /**< n_edge_pairs */
    int32_t kind;                     /**< PCVT_VORONOI, PCVT_DELAUNAY or PCVT_GRAINS */
    int32_t outline;                  /**< PCVT_WHOLE or PCVT_BOX */
    int32_t n_vertices;
    int32_t n_faces;
    int32_t n_corners;
    int32_t n_edge_pairs;
    const pcvt_wall_edge* wall_edges; /**< n_wall_edges; NULL without walls */
    int32_t n_wall_edges;
    int32_t n_holes;
    const char* const* hole_names; /**< n_holes tags; NULL without holes */
} pcvt_tile;

/** The cells of a result in three dimensions, as one tile of whole polyhedra with the pairing of
 * its boundary. Cell s is the cell of site s.
 *
 *  Face f has the points face_points[face_begin[f]] ... face_points[face_begin[f + 1] - 1]. Inner
 *  faces come first, sorted by owner, then by neighbour, which is the larger of the two; their
 *  points are counter-clockwise seen from the neighbour. Boundary faces follow; their points are
 *  counter-clockwise seen from outside. Equal translations follow each other.
 *
 *  Boundary face f = n_inner_faces + b is glued to the face g = partner[b], whose points are those
 *  of f plus the translation of partner_offset[b]: the first point of g belongs to the first of f,
 *  the second of g to the last of f, and so on. For each point p: position(p) =
 *  position(point_orbit[p]) + the translation of point_offset[p].
 *
 *  The tile is connected and proved; it need not be a ball.
 */
typedef struct pcvt_cells {
    double lattice[9];             /**< lattice3 of the options */
    const double* points;          /**< n_points triples x, y, z */
    const int32_t* point_orbit;    /**< the smallest point on the same orbit */
    const int32_t* point_offset;   /**< n_points triples i, j, k */
    const int32_t* face_begin;     /**< n_faces + 1 numbers */
    const int32_t* face_points;    /**< n_face_points numbers */
    const int32_t* owner;          /**< n_faces cells, behind the faces */
    const int32_t* neighbour;      /**< n_faces cells, in front of the faces; -1 on the boundary */
    const int32_t* partner;        /**< n_faces - n_inner_faces faces */
    const int32_t* partner_offset; /**< n_faces - n_inner_faces triples i, j, k */
    const double* volumes;         /**< n_cells numbers, length^3; with short_edges, which bends
                                      faces, those that finite-volume solvers compute */
    const double* site_points;     /**< n_cells triples: the image of each site in its cell */
    const double* sites; /**< n_cells triples: the image of each site in the domain of the reduced
                            period vectors, as .txt files hold it */
    int32_t n_cells;
    int32_t n_faces;
    int32_t n_inner_faces;
    int32_t n_points;
    int32_t n_face_points;
    int32_t n_phases;
    const int32_t* phases;          /**< n_cells indices into phase_names; NULL without phases */
    const char* const* phase_names; /**< n_phases names; NULL without phases */
    const double* orientations;     /**< n_cells triples phi1, Phi, phi2 in degrees, or NULL */
    const double*
        weights; /**< n_cells numbers, length^2, as in pcvt_sites; NULL of Voronoi cells */
} pcvt_cells;

/** Statistics of a run. */
typedef struct pcvt_statistics {
    double energy;       /**< sum over the cells of the integral of density |p - x_i|^2 */
    double energy_bound; /**< 5 area^2 / (18 sqrt(3) n) for uniform density, else NaN; in three
                            dimensions 19 volume^(5/3) / (64 2^(1/3) n^(2/3)), of truncated
                            octahedra */
    double residual;     /**< largest |x_i - g_i| / h, h = sqrt(area / n_sites); in three dimensions
                            the cube root of volume / n_sites */
    double rms_residual; /**< its root mean square */
    double seconds_build; /**< in three dimensions 0: part of seconds_optimize */
    double seconds_optimize;
    const int32_t* valences; /**< valences[k]: cells with k sides, edges under 1e-5 h not counted;
                                in three dimensions cells with k faces */
    int32_t n_valences;
    int32_t n_hexagons; /**< in three dimensions 0 */
    int32_t stop;       /**< PCVT_STOP_... */
    int32_t n_sites;
    int32_t iterations;
    int32_t evaluations;
    int32_t n_threads;
    int32_t n_mirrors;      /**< -1 if the triangulation was built without mirrors, and in three
                               dimensions */
    double area_error;      /**< largest |area - target| / target; NaN without areas */
    int32_t newton_steps;   /**< that found the weights; 0 without areas */
    int32_t n_dropped;      /**< sites that PCVT_DUPLICATES_DROP left out */
    const int32_t* dropped; /**< n_dropped pairs: the number of such a site in the options, and that
                               of the earlier one; NULL for none */
} pcvt_statistics;

/** The options of pcvt_write(). Zero in all fields but struct_size is the default. In three
 *  dimensions only report, kind, replace, progress, progress_data and surface apply; any other
 * field is refused unless it has its default. */
typedef struct pcvt_write_options {
    size_t struct_size;
    const char* report; /**< also write the statistics of the run to this .json file [NULL: no] */
    int32_t kind;       /**< [PCVT_VORONOI] */
    int32_t outline;    /**< [PCVT_WHOLE] */
    int32_t replace;    /**< not 0: replace existing files [0] */
    int32_t colour;     /**< PCVT_COLOUR_... [PCVT_COLOUR_DEFAULT] */
    pcvt_progress_callback progress; /**< [NULL] */
    void* progress_data;
    int32_t gltf_nodes;       /**< PCVT_NODES_... of .glb and .gltf [by the number of cells] */
    int32_t single_precision; /**< not 0: .ply with 32-bit coordinates and triangles [0] */
    int32_t pixels;           /**< width of .png [0: 1024] */
    int32_t element;          /**< of .inp [PCVT_CPE] */
    double cut_width;       /**< .svg and .dxf with only lines to cut, of a tile with this width in
                               millimetres [0: a picture as .svg, .dxf in the unit of the periods] */
    const char* background; /**< of .svg, "#rrggbb" or "none" [NULL: none] */
    int32_t voxels[2];      /**< of .vti, along x and y [0, 0: about 16 along h, in three
                               dimensions along z, too] */
    int32_t job;            /**< of .inp: PCVT_JOB_... [PCVT_JOB_NONE] */
    int32_t voxel_layers;   /**< of .vti: equal layers along z [0: 1]; in three dimensions the
                               voxels along z, 2 or more beside `voxels` [0 with voxels 0, 0] */
    double thickness; /**< height of the layer along z: of the cells of .foam, and of the wedges of
                         PCVT_C3D6 and PCVT_C3D15 [0: sqrt(area / faces)] */
    int32_t surface;  /**< PCVT_SURFACE_..., only in three dimensions [PCVT_SURFACE_CELLS] */
    int32_t reserved2;
    const char* materials; /**< of .inp with PCVT_JOB_ELASTIC, and of .vti: elastic constants of
                              each phase, "NAME:E,NU", "NAME:C11,C12,C44" of cubic crystals or
                              "NAME:C11,C12,C13,C33,C44" of hexagonal ones (axis z), with blanks or
                              line ends between them; without phases the name is GRAINS; "same":
                              all phases are the same steel, or with orientations iron, in MPa;
                              a line with the name of a .yaml file: its phases, in the form of
                              DAMASK. A job with two phases needs it [NULL] */
    double coriolis[2];    /**< of .nc: the parameter coriolis[0] + coriolis[1] y [0, 0: none] */
} pcvt_write_options;

/** The options of pcvt_check(): properties that a file must have besides the laws of tiles. Zero in
 *  all fields but struct_size is the default. */
typedef struct pcvt_check_options {
    size_t struct_size;
    double lattice[4];      /**< ax, ay, bx, by of files that state no lattice; a stated one must be
                               equal [0, 0, 0, 0: that of the file] */
    double tolerance;       /**< the sides of a tile of another program agree within this length
                               [0: 4 ulps of the largest coordinate, in the precision of the file] */
    double cvt;             /**< cells are centroidal Voronoi cells, triangles Delaunay, within this
                               times h, h = sqrt(area / n), such as 1e-5 [0: not examined] */
    const char* areas;      /**< FILE or FILE:COLUMN: power cells have the areas of this table, one
                               row a site [NULL] */
    const char* inclusions; /**< FILE: no cell crosses the outline of a shape of this file, of the
                               form of pcvt_options.inclusions [NULL] */
    const char* density; /**< of the centroids of cvt: an expression in x, y, u, v, or the name of
                            a .png file [NULL: uniform] */
    double density_range[2];         /**< of the image; 0, 0: pcvt chooses [0, 0] */
    pcvt_progress_callback progress; /**< [NULL] */
    void* progress_data;
    const char* volumes; /**< FILE or FILE:COLUMN: cells in space have the volumes of this table,
                            one row a site [NULL] */
} pcvt_check_options;

/** The options of pcvt_study(). pcvt_study_options_init() fills in the defaults of a study. */
typedef struct pcvt_study_options {
    size_t struct_size;
    const char* name;     /**< "table1", "fig7", ..., as `pcvt study --help` lists them */
    const int32_t* sites; /**< n_sites numbers of sites, each once */
    int32_t n_sites;
    int32_t runs;      /**< random starts for each number of sites, at least 1 */
    uint64_t seed;     /**< run r starts from the random sites of seed + r */
    int32_t n_threads; /**< 0: as many as there are cores; at most 1024 [0] */
    int32_t replace;   /**< not 0: replace existing files [0] */
    const char* path;  /**< FILE.csv: the tables, FILE.svg: the pictures, FILE.html: a page with
                          both, a folder, which exists or whose name ends in /: all of them
                          [NULL: no file] */
    pcvt_progress_callback progress; /**< [NULL] */
    void* progress_data;
} pcvt_study_options;

/** What a study consists of. */
typedef struct pcvt_study_contents {
    const char* text; /**< the first columns of the main table and the conclusions, as `pcvt study`
                         prints them; lines with line ends */
    int32_t n_tables;
    int32_t n_pictures;
} pcvt_study_contents;

/** One table of a study. Table 0 is the main one, the last one has the runs. */
typedef struct pcvt_table {
    const char* name;           /**< of its file without .csv: "fig11", "fig11-runs" */
    const char* const* columns; /**< n_columns names */
    const char* const* cells;   /**< n_rows times n_columns texts, row after row; numbers have a
                                   decimal point in every locale */
    const char* const* notes;   /**< n_notes lines: the study, the columns, the conclusions */
    int32_t n_columns;
    int32_t n_rows;
    int32_t n_notes;
    int32_t reserved;
} pcvt_table;

/** One picture of a study. */
typedef struct pcvt_picture {
    const char* name; /**< of its file without .svg */
    const char* svg;  /**< the text of that file */
} pcvt_picture;

/** An optimised periodic tessellation. */
typedef struct pcvt_result pcvt_result;
/** The verdict on a file. */
typedef struct pcvt_proof pcvt_proof;
/** The tables and pictures of many runs. */
typedef struct pcvt_study_result pcvt_study_result;

/*  The next four: any thread, any time. */

/** PCVT_ABI_VERSION of the library. */
PCVT_API uint32_t pcvt_abi_version(void);
/** "major.minor.patch" of the library. */
PCVT_API const char* pcvt_version(void);
/** A status in a few English words. */
PCVT_API const char* pcvt_status_text(pcvt_status status);
/** The reason why this thread's last call with a status did not return PCVT_OK, in one line; ""
 *  after PCVT_OK. The text is valid until the next such call of this thread. */
PCVT_API const char* pcvt_last_error(void);

/** Fills in the defaults; fields that this library does not have become zero.
 *  @param struct_size  sizeof(pcvt_options) of the host.
 *  @param abi_version  PCVT_ABI_VERSION of the host.
 *  @returns PCVT_ERROR_ABI if the two do not fit this library; *options does not change then.
 *  Any thread, any time, on options of its own. */
PCVT_API pcvt_status pcvt_options_init(pcvt_options* options, size_t struct_size,
                                       uint32_t abi_version);

/** Generates a periodic centroidal Voronoi tessellation.
 *  @param result  the result for PCVT_OK and PCVT_NOT_CONVERGED, to be freed; else NULL.
 *  Any thread, any number of calls at once. The call starts threads and ends them before it
 * returns. It calls callbacks only on the calling thread; callbacks may call this library. */
PCVT_API pcvt_status pcvt_generate(const pcvt_options* options, pcvt_result** result);

/** Frees a result and ends its views; ignores NULL. Any thread, once no call uses the result. */
PCVT_API void pcvt_free(pcvt_result* result);

/** The sites at the iteration that a progress callback reports. Only for the duration of that
 *  callback, on its thread: once an iteration of PCVT_PHASE_OPTIMISE, in the plane. The view has
 *  lattice, points and n_sites, in the order of the result with the sites inside of holes among
 *  them; the rest is zero. A run costs and gives the same whether a callback calls this or not.
 *  @param view_size  sizeof(*view) of the host.
 *  @returns PCVT_ERROR_ARGUMENT where the sites are not known. */
PCVT_API pcvt_status pcvt_get_progress_sites(pcvt_sites* view, size_t view_size);

/*  The views. `view_size` is sizeof(*view) of the host: fields that only the host knows become
 * zero, fields that only the library knows are left out. The first call computes the contents of a
 * view; a mesh or a tile that cannot fit into the memory is refused by an estimate before. Any
 * thread, any number of calls on one result at once.
 *
 * A result in three dimensions has pcvt_get_cells() and pcvt_get_statistics(); a result in the
 * plane has all but pcvt_get_cells(). */

PCVT_API pcvt_status pcvt_get_sites(const pcvt_result* result, pcvt_sites* view, size_t view_size);
PCVT_API pcvt_status pcvt_get_inclusions(const pcvt_result* result, pcvt_inclusions* view,
                                         size_t view_size);
PCVT_API pcvt_status pcvt_get_statistics(const pcvt_result* result, pcvt_statistics* view,
                                         size_t view_size);

/** @param minimum  becomes PCVT_MINIMUM_...: unknown if the run did not converge, has a density or
 * more than 10,000 sites (2,000 in three dimensions), or if an eigenvalue is too small. The first
 * call takes time of order n^1.5 (n^2). Any thread, any number of calls on one result at once. */
PCVT_API pcvt_status pcvt_get_minimum(const pcvt_result* result, int32_t* minimum);

/** @param kind  PCVT_VORONOI or PCVT_DELAUNAY. */
PCVT_API pcvt_status pcvt_get_mesh(const pcvt_result* result, int32_t kind, pcvt_mesh* view,
                                   size_t view_size);

/** @param kind     PCVT_VORONOI, PCVT_DELAUNAY or PCVT_GRAINS.
 *  @param outline  PCVT_WHOLE or PCVT_BOX. */
PCVT_API pcvt_status pcvt_get_tile(const pcvt_result* result, int32_t kind, int32_t outline,
                                   pcvt_tile* view, size_t view_size);

PCVT_API pcvt_status pcvt_get_cells(const pcvt_result* result, pcvt_cells* view, size_t view_size);

/** Writes a tile, or the sites for the extension .txt, a table of the cells for .csv. In three
 * dimensions it writes polyhedra (.vtu, .foam), surfaces (.obj, .ply, .glb, .stl), the boundary of
 * the tile (.om, and these four for PCVT_SURFACE_BOUNDARY), tetrahedra (.msh, .inp, .vtu of
 * PCVT_DELAUNAY; these and .foam of PCVT_GRAINS, and the surfaces of grains as .stl),
 * pictures (.svg, .png) or the sites (.txt). Either all files appear, complete and proved to be a
 * periodic tile, or none; only the report appears where the single precision of the file does not
 * hold the tile (PCVT_ERROR_ARGUMENT). Missing folders are made. Calls and runs that write to one
 * folder at the same time rename their files one after the other.
 *  @param path     its extension selects the format; NULL: only the report.
 *  @param options  NULL: the defaults.
 *  @returns PCVT_CANCELLED if the progress callback cancelled; no file appears then.
 *  Any thread, any number of calls on one result at once. */
PCVT_API pcvt_status pcvt_write(const pcvt_result* result, const char* path,
                                const pcvt_write_options* options);

/*  Files and studies. The module for browsers does not have these calls. */

/** Proves that a file is a periodic tile, only from positions and lattice, as `pcvt check` does.
 *  The files that belong to it, such as the .seam.json of an .obj, are found beside it.
 *
 *      if (pcvt_check("tile.obj", NULL, &proof) >= 0) puts(pcvt_proof_text(proof));
 *      pcvt_free_proof(proof);
 *
 *  @param path     a file, or a .foam folder; its extension selects the format.
 *  @param options  NULL: the defaults.
 *  @param proof    the verdict for PCVT_OK and PCVT_REFUTED, to be freed; else NULL.
 *  @returns PCVT_OK: proved. PCVT_REFUTED: damaged, not a periodic tile, or without a property.
 *  PCVT_ERROR_ARGUMENT: it cannot be opened, names no lattice where none is given, or is of a kind
 *  that cannot have a property.
 *  Any thread, any number of calls at once. */
PCVT_API pcvt_status pcvt_check(const char* path, const pcvt_check_options* options,
                                pcvt_proof** proof);
/** The proved properties with their figures, or the first fault: one line that begins with the
 * path, without a line end. "" for NULL. Valid until pcvt_free_proof(). Any thread, any time. */
PCVT_API const char* pcvt_proof_text(const pcvt_proof* proof);
/** Frees a proof; ignores NULL. Any thread, once no call uses it. */
PCVT_API void pcvt_free_proof(pcvt_proof* proof);

/** Fills in the defaults of a study: the sites, runs and seed of the paper. Strings and lists
 * belong to the library. Fields that this library does not have become zero.
 *  @param struct_size  sizeof(pcvt_study_options) of the host.
 *  @param abi_version  PCVT_ABI_VERSION of the host.
 *  @param name         "fig11", ...
 *  @returns PCVT_ERROR_ARGUMENT for an unknown study, PCVT_ERROR_ABI if the two do not fit this
 *  library; *options does not change then. Any thread, any time, on options of its own. */
PCVT_API pcvt_status pcvt_study_options_init(pcvt_study_options* options, size_t struct_size,
                                             uint32_t abi_version, const char* name);
/** Makes the runs of a study, and its tables and pictures, as `pcvt study` does.
 *  @param study  for PCVT_OK, to be freed; else NULL. Either all files of the path appear, or none.
 *  @returns PCVT_CANCELLED if the progress callback cancelled.
 *  Any thread, any number of calls at once. It calls the callback only on the calling thread. */
PCVT_API pcvt_status pcvt_study(const pcvt_study_options* options, pcvt_study_result** study);

/*  Views of a study, as those of a result: any thread, any number of calls at once, valid until
 *  pcvt_free_study().
 *  @param k  PCVT_ERROR_ARGUMENT unless 0 ... n_tables - 1, or n_pictures - 1. */

PCVT_API pcvt_status pcvt_get_study_contents(const pcvt_study_result* study,
                                             pcvt_study_contents* view, size_t view_size);
PCVT_API pcvt_status pcvt_get_table(const pcvt_study_result* study, int32_t k, pcvt_table* view,
                                    size_t view_size);
PCVT_API pcvt_status pcvt_get_picture(const pcvt_study_result* study, int32_t k, pcvt_picture* view,
                                      size_t view_size);
/** Frees a study and ends its views; ignores NULL. Any thread, once no call uses it. */
PCVT_API void pcvt_free_study(pcvt_study_result* study);

#ifdef __cplusplus
}
#endif

#endif
