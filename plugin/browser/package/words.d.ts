// Words of options, by the names of mesh() and write(). Written by plugin/words.

export type Duplicates = 'refuse' | 'drop';
export type Symmetry = 'p1' | 'p2' | 'pm' | 'pg' | 'cm' | 'pmm' | 'pmg' | 'pgg' | 'cmm' | 'p4' | 'p4m' | 'p4g' |
    'p3' | 'p3m1' | 'p31m' | 'p6' | 'p6m';
export type Walls = 'x' | 'y' | 'xy';
export type WallCells = 'whole' | 'half';
export type Start = 'random' | 'coarse' | 'lattice' | 'best';
export type Solver = 'lbfgs' | 'lloyd' | 'newton';
export type Mesh = 'voronoi' | 'delaunay' | 'grains';
export type Outline = 'whole' | 'box';
export type Colour = 'sides' | 'size' | 'cells' | 'density' | 'phase' | 'orbit' | 'tag' | 'faces' | 'orientation';
export type GlbNodes = 'cells' | 'one';
export type Element = 'CPE' | 'CPS' | 'C3D6' | 'C3D15';
export type Job = 'elastic';
export type Surface = 'cells' | 'boundary';

export const words: { [option: string]: { [word: string]: number } };
