// refusals.mjs PACKAGE PCVT: mesh() of the npm package in the folder PACKAGE refuses wrong options with the line of the
// command PCVT, and names the option. Exits with 1 where it does not.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { argumentsOf, writeTables } from './jobs.mjs';

const [folder, pcvt] = process.argv.slice(2);
const { mesh } = await import(pathToFileURL(resolve(folder, 'index.js')));

const files = {
    'points.csv': 'x,y\n0.1,0.2\n0.5,0.5\n',
    'twins.csv': 'x,y\n# the same site twice\n0.1,0.2\n0.5,0.5\n1.1,0.2\n0.1,1.2\n',
    'word.csv': 'x;y\n0,1;0,2\n0,5;up\n',
    'deep.csv': 'x,y,z\n1,2,3\n',
    'empty.csv': '\n',
    'weights.csv': 'x,y,weight\n0.1,0.1,0\n0.6,0.6,0.1\n',
    'sizes.csv': 'id,ECD,area\n1,2,3\n',
    'sizes.txt': '1\n2\n-3\n',
    'three.txt': '1\n2\n3\n',
    'phases.csv': 'x,y,phase\n0.1,0.1,a b\n',
    'empty_cell.csv': 'x,y,weight\n0.1,0.1,0\n0.12,0.1,0.5\n0.6,0.6,0.1\n',
    'binary.csv': Uint8Array.of(1, 0, 2, 0),
};

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
    ['areas', { sites: 10, areas: 'wide:1' }, "'wide:1' is not a law of sizes; choose equal, lognormal:S, gamma:S or a mixture such as 0.7*lognormal:0.3@1+0.3*gamma:0.2@3"],
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
    ['sites', { sites: 2, input: 'points.csv', files }],
    ['input', { input: 'twins.csv', files }],
    ['input', { input: 'word.csv', files }],
    ['input', { input: 'deep.csv', files }],
    ['input', { input: 'empty.csv', files }],
    ['input', { input: 'points.csv:x', files }],
    ['input', { input: 'points.csv', files, period: [1, 1, 1] }],
    ['input', { input: 'weights.csv', files }],
    ['input', { input: 'phases.csv', files }],
    ['input', { input: 'binary.csv', files }],
    ['input', { input: 'empty_cell.csv', files, maxIterations: 0 },
        'empty_cell.csv:2: the cell of site 0 is empty, because its weight is too small beside those of the neighbours; ' +
            'leave such sites out, or give larger weights'],
    ['areas', { sites: 1, areas: 'sizes.csv', files }],
    ['areas', { sites: 1, areas: 'diameter:sizes.csv:area', files }],
    ['areas', { sites: 3, areas: 'sizes.txt', files }],
    ['areas', { input: 'points.csv', areas: 'three.txt', files }],
    ['weights', { input: 'points.csv', weights: 'three.txt', maxIterations: 0, files }],
    // Where the module has no such file, it takes the text for a law.
    ['areas', { sites: 1, areas: 'none.csv', files }, "'none.csv' is not a law of sizes; choose equal, lognormal:S, gamma:S or a mixture such as 0.7*lognormal:0.3@1+0.3*gamma:0.2@3"],
];

for (const [option, options, message] of wrong) {
    const args = ['mesh', ...argumentsOf(options), '-o', 'tile.obj'];
    const cwd = mkdtempSync(join(tmpdir(), 'pcvt_refusals_'));
    writeTables(options, cwd);
    const native = spawnSync(resolve(pcvt), args, { cwd, encoding: 'utf8' });
    rmSync(cwd, { recursive: true });
    const line = message ?? native.stderr.trim().replace(/^pcvt: /, '');
    let error = { message: 'no error' };
    try {
        (await mesh(options)).free();
    } catch (thrown) {
        error = thrown;
    }
    const isSame = native.status > 0 && error.message === line && error.option === option;
    console.log(`${args.slice(1, -2).join(' ')}: ${error.message}`);
    if (!isSame) {
        console.log(`  DIFFERENT: option ${error.option}; exit code ${native.status}; expected: ${line}`);
        process.exitCode = 1;
    }
}
