// Words of options with their numbers in pcvt.h, by the names of mesh() and write(). Written by plugin/words.

export const words = {
    duplicates: {refuse: 0, drop: 1},
    symmetry: {
        p1: 1, p2: 2, pm: 3, pg: 4, cm: 5, pmm: 6, pmg: 7, pgg: 8, cmm: 9, p4: 10, p4m: 11, p4g: 12, p3: 13,
        p3m1: 14, p31m: 15, p6: 16, p6m: 17,
    },
    walls: {x: 1, y: 2, xy: 3},
    wallCells: {whole: 0, half: 1},
    start: {random: 1, coarse: 2, lattice: 3, best: 4},
    solver: {lbfgs: 1, lloyd: 2, newton: 3},
    mesh: {voronoi: 0, delaunay: 1, grains: 2},
    outline: {whole: 0, box: 1},
    colour: {sides: 1, size: 2, cells: 3, density: 4, phase: 5, orbit: 6, tag: 7, faces: 8, orientation: 9},
    glbNodes: {cells: 1, one: 2},
    element: {CPE: 0, CPS: 1, C3D6: 2, C3D15: 3},
    job: {elastic: 1},
    surface: {cells: 0, boundary: 1},
};
