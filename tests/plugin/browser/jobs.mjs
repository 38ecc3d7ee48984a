// Jobs of mesh() and the arguments of the command that describe the same.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** The command's arguments for options of mesh() or write(); the tables lie in its folder. */
export function argumentsOf({ files, ...options }) {
    return Object.entries(options).flatMap(([name, value]) => {
        const flag = `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
        return [flag, [value].flat().join(',')];
    });
}

/** Writes the tables of options into a folder. */
export function writeTables({ files = {} }, folder) {
    for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
}

/** Sites with weights, phases and orientations, as the command writes them to .csv. */
const cells = `# cells
site,x,y,weight,area,phase,phi1,Phi,phi2
0,0.1,0.2,0.01,,ferrite,10,20,30
1,0.6,0.3,0,,austenite,40,50,60
2,0.3,0.7,0.02,,ferrite,1,2,3
3,0.9,0.8,0.015,,austenite,200,100,5
`;
const files = {
    'points.csv': '\ufeffid;X (mm);Y (mm)\r\n1;0,25;0,25\r\n2;0,75;0,2\r\n3;0,5;0,7\r\n4;-0,1;0,6\r\n',
    'cells.csv': cells,
    'grains.tsv': 'Grain\tECD [um]\n1\t10,5\n2\t12\n3\t8,25\n4\t9\n',
    'radii.txt': '0.1\n0.12\n0.05\n0.1\n',
    'space.csv': 'x y z\n0.1 0.2 0.3\n0.7 0.6 0.5\n0.4 0.1 0.9\n',
};

const ridge = '1 + 30 / (1 + 100 * (v - 0.5)^2)';
const waves = '2 + sin(6.28 * u) * exp(-v) + log10(1 + u) + v^4';
const oblique = [1, 0, 0.3, 0.9];
const oblique3 = [1, 0, 0, 0.3, 0.9, 0, 0.2, 0.1, 1];

/** Options of mesh() and those of write(). */
export const jobs = [
    [{ sites: 1 }],
    [{ sites: 2, seed: 1 }],
    [{ sites: 3, seed: 2, lattice: oblique }],
    [{ sites: 8, seed: 3 }, { mesh: 'delaunay' }],
    [{ sites: 30, seed: 4, lattice: oblique }],
    [{ sites: 37, start: 'lattice', lattice: oblique }],
    [{ sites: 22, start: 'best' }],
    [{ sites: 150, seed: 5, lattice: [1, 0, 0.37, 0.81] }, { outline: 'box' }],
    [{ sites: 100, seed: 6, lattice: oblique }, { mesh: 'grains', outline: 'box' }],
    [{ sites: 200, seed: 7, period: [100, 0.1] }],
    [{ sites: 300, seed: 8, lattice: [1, 0, 40.3, 0.02] }],
    [{ sites: 400, seed: 9, density: ridge }],
    [{ sites: 300, seed: 10, areas: 'lognormal:0.42', maxIterations: 5 }],
    [{ sites: 60, seed: 10, areas: '0.7*lognormal:0.3@1 + 0.3*gamma:0.2@3', maxIterations: 2 }],
    [{ sites: 200, seed: 11, lattice: oblique, areas: 'gamma:0.3', maxIterations: 3, aspect: [2, 30] }],
    [{ sites: 200, seed: 12, density: waves, start: 'coarse' }],
    [{ sites: 96, symmetry: 'p4' }],
    [{ sites: 100, symmetry: 'p2', lattice: oblique }],
    [{ sites: 400, seed: 3, walls: 'x', period: [1, 2] }],
    [{ sites: 100, seed: 2, walls: 'xy' }],
    [{ sites: 600, seed: 14, fibres: [0.4, 12] }],
    [{ sites: 150, seed: 15, solver: 'lloyd', tolerance: 1e-3, phases: 'soft:0.7,hard:0.3' }],
    [{ sites: 800, seed: 6, period: [3, 0.5] }],
    [{ sites: 1000, seed: 16, lattice: oblique }],
    [{ sites: 2000, seed: 9, solver: 'newton' }],
    [{ sites: 5000, seed: 17, tolerance: 1e-4 }],
    [{ sites: 20000, seed: 18, tolerance: 1e-3 }],
    [{ input: 'points.csv', files, lattice: oblique }],
    [{ input: 'points.csv:Y,X', files, areas: 'grains.tsv' }],
    [{ sites: 4, seed: 3, areas: 'diameter:grains.tsv:ECD', files, maxIterations: 4 }],
    [{ input: 'cells.csv', files, maxIterations: 0 }],
    [{ input: 'cells.csv:x,y', files, weights: 'radius:radii.txt', maxIterations: 0 }],
    [{ input: 'space.csv', files, lattice: oblique3 }],
    [{ sites: 1, lattice: oblique3 }],
    [{ sites: 54, period: [1, 1, 1], start: 'lattice' }],
    [{ sites: 150, seed: 19, lattice: oblique3, tolerance: 1e-6 }],
    [{ sites: 1000, seed: 20, period: [1, 1, 1], start: 'coarse', tolerance: 1e-4 }],
];
