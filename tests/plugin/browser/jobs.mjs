// Jobs of mesh() and the arguments of the command that describe the same.

/** The command's arguments for options of mesh() or write(). */
export function argumentsOf(options) {
    return Object.entries(options).flatMap(([name, value]) => {
        const flag = `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
        return [flag, [value].flat().join(',')];
    });
}

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
    [{ sites: 1, lattice: oblique3 }],
    [{ sites: 54, period: [1, 1, 1], start: 'lattice' }],
    [{ sites: 150, seed: 19, lattice: oblique3, tolerance: 1e-6 }],
    [{ sites: 1000, seed: 20, period: [1, 1, 1], start: 'coarse', tolerance: 1e-4 }],
];
