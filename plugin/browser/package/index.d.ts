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
    /** Their number, or the sites themselves: x, y, x, y, ... (in three dimensions x, y, z, ...) */
    sites: number | ArrayLike<number>;
    seed?: number;
    /** Width and height; a depth as well makes polyhedra in three dimensions. */
    period?: ArrayLike<number>;
    /** ax, ay, bx, by; or ax, ay, az, bx, by, bz, cx, cy, cz in three dimensions. */
    lattice?: ArrayLike<number>;
    origin?: ArrayLike<number> | 'auto';
    density?: string;
    /** A law such as 'lognormal:0.3', or one area a site. */
    areas?: string | ArrayLike<number>;
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
    phases?: string;
    start?: words.Start;
    solver?: words.Solver;
    tolerance?: number;
    maxIterations?: number;
    repeat?: [columns: number, rows: number];
    size?: number;
    perEdge?: number;
    order?: 1 | 2;
    shortEdges?: number;
    /** Called once an iteration; `false` ends the run, and mesh() then throws. */
    progress?: (state: Progress) => boolean | void;
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

export interface Result {
    readonly energy: number;
    /** NaN with a density. */
    readonly energyBound: number;
    readonly residual: number;
    readonly hexagons: number;
    readonly iterations: number;
    readonly evaluations: number;
    readonly stop: 'converged' | 'iteration limit' | 'stalled';
    readonly sites: Float64Array;
    /** valences[k] cells have k sides. */
    readonly valences: Int32Array;
    /** Each site that `duplicates: 'drop'` left out, and the earlier one with which it coincides. */
    readonly dropped: Int32Array;
    /** The bytes of a file; a promise in a browser, where the tile is in a worker. */
    write(name: string, options?: WriteOptions): Uint8Array | Promise<Uint8Array>;
    free(): void;
}

/** An error of an option; the message is the line that the command prints after "pcvt: ". */
export class OptionError extends Error {
    option: string;
}

export function mesh(options: MeshOptions): Promise<Result>;
