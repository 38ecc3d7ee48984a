// same_bytes.mjs PACKAGE PCVT: mesh() of the npm package in the folder PACKAGE gives the bytes of the command PCVT
// in OBJ, GLB, PLY, SVG and VTU. Exits with 1 where a byte differs.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { argumentsOf, jobs, writeTables } from './jobs.mjs';

const [folder, pcvt] = process.argv.slice(2);
const { mesh } = await import(pathToFileURL(resolve(folder, 'index.js')));

const extensions = ['obj', 'glb', 'ply', 'svg', 'vtu'];

function nativeFiles(options, args) {
    const out = mkdtempSync(join(tmpdir(), 'pcvt_same_bytes_'));
    try {
        writeTables(options, out);
        const outputs = extensions.flatMap((extension) => ['-o', `tile.${extension}`]);
        const begin = performance.now();
        execFileSync(resolve(pcvt), ['mesh', ...args, ...outputs, '--threads', '1', '--quiet'], { cwd: out });
        const seconds = (performance.now() - begin) / 1000;
        return { seconds, files: extensions.map((extension) => readFileSync(join(out, `tile.${extension}`))) };
    } finally {
        rmSync(out, { recursive: true });
    }
}

for (const [options, form = {}] of jobs) {
    const args = argumentsOf({ ...options, ...form });
    const native = nativeFiles(options, args);
    const begin = performance.now();
    const result = await mesh(options);
    const files = extensions.map((extension) => result.write(`tile.${extension}`, form));
    result.free();
    const different = extensions.filter((_, k) => !native.files[k].equals(files[k]));
    const ratio = (performance.now() - begin) / 1000 / native.seconds;
    console.log(`${args.join(' ')}: ${different.length ? `DIFFERENT: ${different}` : 'equal'}, ` +
        `${ratio.toFixed(1)} times the native time`);
    if (different.length) process.exitCode = 1;
}
