import type * as words from './words.js';

export type Symmetry = words.Symmetry;

export interface Progress {
    iteration: number;
    evaluations: number;
    energy: number;
    energyBound: number;
    energyOverBound: number;
    residual: number;
    phase: 'start' | 'optimise' | 'build' | 'prove' | 'write';
    /** The part of the phase that is done; negative: unknown. */
    fraction: number;
    text: string;
    /** The sites at this iteration: x, y, x, y, ... Only with `progressSites`, in the phase 'optimise', in the plane. */
    sites?: Float64Array;
}

/** The names and meanings are those of the long options of `pcvt mesh`. */
export interface MeshOptions {
    /** Their number, or the sites themselves: x, y, x, y, ... (in three dimensions x, y, z, ...); absent with `input`. */
    sites?: number | ArrayLike<number>;
    /**
     * A table of sites, "points.csv" or "points.csv:X,Y", of `files`: with its columns weight, phase, phi1, Phi and phi2, as
     * the command reads it.
     */
    input?: string;
    /** The tables that `input`, `areas` and `weights` name: their bytes or texts, by their names. */
    files?: { [name: string]: Uint8Array | string };
    seed?: number;
    /** Width and height; a depth as well makes polyhedra in three dimensions. */
    period?: ArrayLike<number>;
    /** ax, ay, bx, by; or ax, ay, az, bx, by, bz, cx, cy, cz in three dimensions. */
    lattice?: ArrayLike<number>;
    origin?: ArrayLike<number> | 'auto';
    density?: string;
    /** A law such as 'lognormal:0.3', a mixture such as '0.7*lognormal:0.3@1+0.3*gamma:0.2@3', one area a site, or the name of a table, "grains.csv" or "diameter:grains.csv:ECD". */
    areas?: string | ArrayLike<number>;
    /**
     * The power cells (Laguerre cells) of given sites, which stay where they are: one length squared a site, such as the
     * square of a radius, or the name of a table. Needs `maxIterations: 0`.
     */
    weights?: string | ArrayLike<number>;
    aspect?: number | [ratio: number, degrees: number];
    symmetry?: Symmetry;
    walls?: words.Walls;
    wallCells?: words.WallCells;
    fixed?: ArrayLike<number>;
    /** Given sites within 1e-9 h of an earlier one: an error that names them all, or left out. */
    duplicates?: words.Duplicates;
    inclusions?: string;
    fibres?: string | ArrayLike<number>;
    hole?: string | string[];
    /**
     * Fractions of the area with the sum 1, "NAME:FRACTION,..." or {name: fraction}, spread evenly and drawn from `seed`; or
     * the name of each site's phase.
     */
    phases?: string | { [name: string]: number } | string[];
    /** phi1, Phi, phi2, phi1, ... of each site (Bunge's angles in degrees), or drawn from `seed`. */
    orientations?: 'random' | ArrayLike<number>;
    start?: words.Start;
    solver?: words.Solver;
    tolerance?: number;
    maxIterations?: number;
    repeat?: [columns: number, rows: number];
    size?: number;
    perEdge?: number;
    order?: 1 | 2;
    shortEdges?: number;
    /**
     * Called once an iteration. A true value ends the run, as in Python: mesh() then throws a Cancelled. An exception ends
     * it as well, and mesh() throws it. A promise is refused.
     */
    progress?: (state: Progress) => unknown;
    /** Whether progress() gets the sites; a run gives the same bits with and without them. */
    progressSites?: boolean;
}

export interface WriteOptions {
    mesh?: words.Mesh;
    outline?: words.Outline;
    colour?: words.Colour;
    glbNodes?: words.GlbNodes;
    float32?: boolean;
    pixels?: number;
    /** In three dimensions: every cell, or the boundary of the tile. */
    surface?: words.Surface;
}

/** A value that is a promise of the same in a browser, where the tile is in a worker. */
export type Late<Value> = Value | Promise<Value>;

/**
 * A tile in the plane: one fundamental domain as an open disc, with the pairing of its boundary. With holes it is not a disc.
 * Vertex v lies at points[2 v], points[2 v + 1]. An offset i, j means the translation i a + j b.
 */
export interface Tile {
    /** ax, ay, bx, by; of a repeated tile the repeated lattice. */
    lattice: Float64Array;
    /** n_vertices pairs x, y. */
    points: Float64Array;
    /**
     * n_faces + 1 numbers: face f has the vertices corners[faceBegin[f]] ... corners[faceBegin[f + 1] - 1],
     * counter-clockwise.
     */
    faceBegin: Int32Array;
    corners: Int32Array;
    /** n_faces sites; null for Delaunay triangles. */
    faceSite: Int32Array | null;
    /** n_faces pairs x, y: the position of that site; null for Delaunay triangles. */
    sitePoints: Float64Array | null;
    /** n_vertices sites of Delaunay triangles, else null. */
    vertexSite: Int32Array | null;
    /** n_vertices numbers: the smallest vertex on the same orbit. */
    vertexOrbit: Int32Array;
    /** n_vertices pairs i, j: vertex v lies at the point of vertexOrbit[v] plus this translation. */
    vertexOffset: Int32Array;
    /**
     * Six numbers v0, v1, w0, w1, i, j for each pair: the boundary edge v0 -> v1, whose face is on its left, is glued to
     * w0 -> w1, whose face is on its right, and w0 and w1 lie at v0 and v1 plus the translation of i, j.
     */
    seam: Int32Array;
    /** Three numbers wall, v0, v1 for each boundary edge on a wall: 0 left, 1 right, 2 bottom, 3 top, 4 + k: holes[k]. */
    wallEdges: Int32Array;
    /** The names of the holes. */
    holes: string[];
}

/** The cells or triangles on the torus: one face and one vertex for all of its images. */
export interface TorusMesh {
    lattice: Float64Array;
    /** n_vertices pairs x, y. */
    vertices: Float64Array;
    /** n_faces + 1 numbers: face f has the corners faceBegin[f] ... faceBegin[f + 1] - 1, counter-clockwise. */
    faceBegin: Int32Array;
    /** n_corners vertices: corner c lies at this vertex plus the translation of its cornerOffset. */
    cornerVertex: Int32Array;
    /** n_corners pairs i, j. */
    cornerOffset: Int32Array;
    /** n_corners numbers: the corner that the same edge leaves on the face across; -1 on walls. */
    opposite: Int32Array;
    /** The site of each cell, or of each vertex of triangles. */
    site: Int32Array;
    /** n_faces pairs x, y: the position of the site of each cell; null for triangles. */
    sitePoints: Float64Array | null;
}

/** The cells in three dimensions as one connected tile of whole polyhedra; cell s is the cell of site s. */
export interface SpaceTile {
    /** ax, ay, az, bx, by, bz, cx, cy, cz. */
    lattice: Float64Array;
    /** n_points triples x, y, z. */
    points: Float64Array;
    /** n_points numbers: the smallest point on the same orbit. */
    pointOrbit: Int32Array;
    /** n_points triples i, j, k: point p lies at the point of pointOrbit[p] plus i a + j b + k c. */
    pointOffset: Int32Array;
    /** n_faces + 1 numbers: face f has the points facePoints[faceBegin[f]] ... facePoints[faceBegin[f + 1] - 1]. */
    faceBegin: Int32Array;
    /** Counter-clockwise seen from the neighbour, of boundary faces from outside. */
    facePoints: Int32Array;
    /** Inner faces come first. */
    nInnerFaces: number;
    /** n_faces cells, behind the faces. */
    owner: Int32Array;
    /** n_faces cells, in front of the faces; -1 on the boundary. */
    neighbour: Int32Array;
    /**
     * n_faces - nInnerFaces faces: boundary face nInnerFaces + b is glued to partner[b], whose points are those of the face plus
     * the translation of partnerOffset: the first point of one belongs to the first of the other, the second to the last, ...
     */
    partner: Int32Array;
    /** A triple i, j, k for each partner. */
    partnerOffset: Int32Array;
    /** n_cells numbers, length^3. */
    volumes: Float64Array;
    /** n_cells triples: the image of each site in its cell. */
    sitePoints: Float64Array;
}

/** The columns of .csv files, an entry for each cell; arrays that do not apply are null. */
export interface Cells {
    site: Int32Array;
    /** n_cells pairs x, y. */
    sites: Float64Array;
    weights: Float64Array | null;
    /** length^2. */
    area: Float64Array;
    /** The diameter of the circle with the same area. */
    diameter: Float64Array;
    sides: Int32Array;
    /** The perimeter of that circle over that of the cell. */
    circularity: Float64Array;
    phases: Int32Array | null;
    /** n_cells triples phi1, Phi, phi2 in degrees. */
    orientations: Float64Array | null;
    orbits: Int32Array | null;
    /** n_cells + 1 numbers: cell c has the neighbours neighbours[neighbourBegin[c]] ... neighbours[neighbourBegin[c + 1] - 1]. */
    neighbourBegin: Int32Array;
    neighbours: Int32Array;
}

/** The figures of a run in the plane or in space. */
interface AnyResult {
    /** In three dimensions density x length^5. */
    readonly energy: number;
    /** NaN with a density. */
    readonly energyBound: number;
    readonly residual: number;
    /** In three dimensions 0. */
    readonly hexagons: number;
    readonly iterations: number;
    readonly evaluations: number;
    readonly stop: 'converged' | 'iteration limit' | 'stalled';
    /** x, y, x, y, ..., in three dimensions x, y, z, ... */
    readonly sites: Float64Array;
    /** valences[k] cells have k sides, in three dimensions k faces. */
    readonly valences: Int32Array;
    /** Each site that `duplicates: 'drop'` left out, and the earlier one with which it coincides. */
    readonly dropped: Int32Array;
    /** The bytes of a file. */
    write(name: string, options?: WriteOptions): Late<Uint8Array>;
    free(): void;
}

export interface Result extends AnyResult {
    readonly dimension: 2;
    /** ax, ay, bx, by. */
    readonly lattice: Float64Array;
    /** length^2, null without areas and weights: the cell of site i is where |p - sites[i]|^2 - weights[i] is least. */
    readonly weights: Float64Array | null;
    /** The index of each cell's phase in phaseNames, null without phases. */
    readonly phases: Int32Array | null;
    readonly phaseNames: string[];
    /** Triples phi1, Phi, phi2 in degrees, null without orientations. */
    readonly orientations: Float64Array | null;
    /** Equal for sites that the symmetry maps to each other, null without one. */
    readonly orbits: Int32Array | null;
    tile(options?: { mesh?: words.Mesh; outline?: words.Outline }): Late<Tile>;
    torusMesh(options?: { mesh?: 'voronoi' | 'delaunay' }): Late<TorusMesh>;
    cells(): Late<Cells>;
}

export interface SpaceResult extends AnyResult {
    readonly dimension: 3;
    tile(): Late<SpaceTile>;
}

/** What a table holds, as readTable() finds it. */
export interface TableContents {
    use: 'sites' | 'sizes';
    rows: number;
    /** The name for `input` or `areas`; that of sites with weights, phases or orientations names the columns of the positions. */
    name: string;
    quantity: 'sites' | 'areas' | 'diameters' | 'radii';
    /** The names of the columns, without units; none without a header. */
    columns: string[];
    /** In ASCII; '' where the header states none. */
    unit: string;
    /** x, y, x, y, ... of sites, else null. */
    sites: Float64Array | null;
}

/** An error of an option; the message is the line that the command prints after "pcvt: ". */
export class OptionError extends Error {
    option: string;
}

/** The error of a run that its progress function ended. */
export class Cancelled extends Error {}

/** Three numbers in `period`, or nine in `lattice`, give a SpaceResult: mesh<SpaceResult>(...). Two or four give a Result. */
export function mesh<Found extends Result | SpaceResult = Result>(options: MeshOptions): Promise<Found>;

/**
 * Reads a whole table, in the plane, before a run takes it. Without `use`, columns x and y of a header are sites, else a column
 * of areas, diameters or radii holds sizes; without a header, two columns are sites, and one holds sizes. Errors have the
 * command's line, "file:line: fault; remedy".
 */
export function readTable(given: {
    table: string;
    files: { [name: string]: Uint8Array | string };
    use?: 'sites' | 'sizes';
}): Promise<TableContents>;
