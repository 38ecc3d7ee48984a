// proved_files.mjs PACKAGE PCVT: `PCVT check` proves the files of mesh() whose last digits may differ from those of the
// command: power cells, densities, three dimensions. Exits with 1 where it refutes one.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, pcvt] = process.argv.slice(2);
const { mesh } = await import(pathToFileURL(resolve(folder, 'index.js')));

const oblique = [1, 0, 0, 0.3, 0.9, 0, 0.2, 0.1, 1];
const jobs = [
    [{ sites: 300, areas: 'lognormal:0.42', maxIterations: 5 }, ['obj', 'ply', 'glb', 'vtu', 'om']],
    [{ sites: 300, density: '2 + cos(2 * _pi * v)' }, ['obj', 'ply', 'glb', 'vtu', 'om']],
    [{ sites: 16, start: 'lattice', period: [1, 1, 1] }, ['vtu', 'obj', 'ply', 'glb', 'om']],
    [{ sites: 200, lattice: oblique }, ['vtu', 'msh', 'obj', 'ply', 'glb']],
];

for (const [options, extensions] of jobs) {
    const out = mkdtempSync(join(tmpdir(), 'pcvt_proved_files_'));
    try {
        const result = await mesh(options);
        const names = extensions.map((extension) => `tile.${extension}`);
        for (const name of names) writeFileSync(join(out, name), result.write(name));
        result.free();
        execFileSync(resolve(pcvt), ['check', ...names], { cwd: out, stdio: ['ignore', 'ignore', 'inherit'] });
        console.log(`${JSON.stringify(options)}: ${names.length} files proved`);
    } catch (error) {
        console.log(`${JSON.stringify(options)}: ${error.message}`);
        process.exitCode = 1;
    } finally {
        rmSync(out, { recursive: true });
    }
}
