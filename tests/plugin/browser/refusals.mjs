// refusals.mjs PACKAGE PCVT: mesh() of the npm package in the folder PACKAGE refuses wrong options with the line of the
// command PCVT, and names the option. Exits with 1 where it does not.
import { spawnSync } from 'node:child_process';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { argumentsOf } from './jobs.mjs';

const [folder, pcvt] = process.argv.slice(2);
const { mesh } = await import(pathToFileURL(resolve(folder, 'index.js')));

// The option that the message names, the options, and the message where that of the command names a file or its options.
const wrong = [
    ['sites', {}],
    ['sites', { sites: 0 }],
    ['sites', { sites: -5 }],
    ['sites', { sites: 1.5 }],
    ['sites', { sites: 3e8 }],
    ['seed', { sites: 10, seed: -1 }],
    ['period', { sites: 10, period: [1] }],
    ['period', { sites: 10, period: [1, 0] }],
    ['lattice', { sites: 10, lattice: [1, 0, 2, 0] }],
    ['lattice', { sites: 10, lattice: [1, 0, 1] }],
    ['density', { sites: 10, density: '1 +' }],
    ['density', { sites: 10, density: 'q' }],
    ['density', { sites: 10, density: 'u - 0.5' }],
    ['areas', { sites: 10, areas: 'wide:1' }, "'wide:1' is not a law of areas; choose equal, lognormal:S or gamma:S"],
    ['aspect', { sites: 10, aspect: 1000 }],
    ['tolerance', { sites: 10, tolerance: -1 }],
    ['maxIterations', { sites: 10, maxIterations: -2 }],
    ['solver', { sites: 10, solver: 'simplex' }],
    ['start', { sites: 10, start: 'middle' }],
    ['symmetry', { sites: 10, symmetry: 'p5' }],
    ['symmetry', { sites: 10, symmetry: 'p4', lattice: [1, 0, 0.3, 0.9] }],
    ['walls', { sites: 10, walls: 'x', lattice: [1, 0, 0.3, 0.9] },
        'walls needs a rectangle along x and y; give the two sides as its period'],
    ['wallCells', { sites: 10, wallCells: 'half' }, 'wall_cells half needs walls; add walls'],
    ['fibres', { sites: 10, fibres: [2, 5] }],
];

for (const [option, options, message] of wrong) {
    const args = ['mesh', ...argumentsOf(options), '-o', 'tile.obj'];
    const native = spawnSync(resolve(pcvt), args, { cwd: '/', encoding: 'utf8' });
    const line = message ?? native.stderr.trim().replace(/^pcvt: /, '');
    let error = { message: 'no error' };
    try {
        (await mesh(options)).free();
    } catch (thrown) {
        error = thrown;
    }
    const isSame = native.status > 0 && error.message === line && error.option === option;
    console.log(`${JSON.stringify(options)}: ${error.message}`);
    if (!isSame) {
        console.log(`  DIFFERENT: option ${error.option}; exit code ${native.status}; expected: ${line}`);
        process.exitCode = 1;
    }
}
