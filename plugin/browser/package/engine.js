// Runs of pcvt in this thread, on the WebAssembly module.
import loadModule from './pcvt_wasm.mjs';
import { OptionError, fieldsOf, runOptions, writeOptions } from './option_table.js';
import { compile } from './wasm.js';

const stops = ['converged', 'iteration limit', 'stalled'];
const phases = ['start', 'optimise', 'build', 'prove', 'write'];
const cancelled = 1;
/** The folder of the module's file system in which files are written. */
const folder = '/out';

let loading;

/** Takes a compiled module, which another thread may share. */
export function useModule(wasm) {
    const instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm));
        return {};
    };
    loading = loadModule({ instantiateWasm });
    return loading;
}

/** The module, which is loaded once. */
function load() {
    loading ??= compile().then(useModule);
    return loading;
}

/** The size of the module's memory in bytes. */
export async function sizeOfMemory() {
    return (await load()).HEAPU8.length;
}

/** Words of messages of the C interface that name no option, and the option that they concern. */
const concerns = [
    [/^character \d+: |^the density /, 'density'],
    [/^the period vectors |^the lattice /, 'lattice'],
    [/law of areas|^areas? |^the areas /, 'areas'],
    [/^the symmetry /, 'symmetry'],
    [/^the area fraction |fibre/, 'fibres'],
];

/** The last error of the module, as the command words it. */
function lastError(module, options = {}) {
    const line = module.UTF8ToString(module._pcvt_last_error()).replaceAll(`${folder}/`, '');
    // A message about options begins with the field of one: wall_cells.
    const first = line.split(' ', 1)[0].replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
    const option = options[first] !== undefined ? first
        : concerns.find(([words, name]) => words.test(line) && options[name] !== undefined)?.[1];
    if (option === 'density') return new OptionError(option, `--density '${options.density}': ${line}`);
    if (option === 'lattice') return new OptionError(option, `--lattice ${[...options.lattice]}: ${line}`);
    return option ? new OptionError(option, line) : new Error(line);
}

/** Calls use(address) with a text in the memory of the module. */
function withText(module, text, use) {
    const size = module.lengthBytesUTF8(text) + 1;
    const address = module._malloc(size) >>> 0;
    if (address === 0) throw new Error('out of memory; take fewer sites');
    try {
        module.stringToUTF8(text, address, size);
        return use(address);
    } finally {
        module._free(address);
    }
}

/** Calls use(address) with numbers in the memory of the module. */
function withNumbers(module, numbers, use) {
    const address = module._malloc(8 * Math.max(1, numbers.length)) >>> 0;
    if (address === 0) throw new Error('out of memory; take fewer sites');
    try {
        module.HEAPF64.set(numbers, address / 8);
        return use(address);
    } finally {
        module._free(address);
    }
}

function setField(module, run, { field, value }) {
    const known = withText(module, field, (name) => {
        if (typeof value === 'number') return module._run_number(run, name, value);
        if (typeof value === 'string') {
            return withText(module, value, (text) => module._run_text(run, name, text));
        }
        return withNumbers(module, value, (at) => module._run_numbers(run, name, at, value.length));
    });
    if (!known) throw new Error(`the module has no field ${field}`);
}

/** A copy of n doubles in the memory of the module, whose addresses above 2 GiB arrive as negative numbers. */
function numbersAt(module, address, n) {
    const begin = (address >>> 0) / 8;
    return module.HEAPF64.slice(begin, begin + n);
}

/** The address and the number of values that `find` stores and returns. */
function found(module, find) {
    return withNumbers(module, [0], (address) => {
        const n = find(address);
        if (n < 0) throw lastError(module);
        return { address: module.HEAPU32[address / 4], n };
    });
}

function statisticsOf(module, run) {
    return withNumbers(module, new Float64Array(7), (address) => {
        if (module._run_statistics(run, address) !== 0) throw lastError(module);
        const [energy, energyBound, residual, hexagons, iterations, evaluations, stop] =
            numbersAt(module, address, 7);
        return { energy, energyBound, residual, hexagons, iterations, evaluations, stop: stops[stop] };
    });
}

/** A finished run. */
class Result {
    #module;
    #run;

    constructor(module, run) {
        this.#module = module;
        this.#run = run;
        Object.assign(this, statisticsOf(module, run));
        const sites = found(module, (at) => module._run_sites(run, at));
        this.sites = numbersAt(module, sites.address, sites.n);
        const sides = found(module, (at) => module._run_valences(run, at));
        this.valences = module.HEAP32.slice(sides.address / 4, sides.address / 4 + sides.n);
        const dropped = found(module, (at) => module._run_dropped(run, at));
        this.dropped = module.HEAP32.slice(dropped.address / 4, dropped.address / 4 + dropped.n);
    }

    /** The bytes of a file; the extension of `name` selects the format. */
    write(name, options = {}) {
        if (this.#run === 0) throw new Error('the result has been freed');
        if (name.endsWith('.foam')) throw new Error(`${name}: a folder of files; the command writes it`);
        const module = this.#module;
        const path = `${folder}/${name.split('/').at(-1)}`;
        module._run_write_defaults(this.#run);
        for (const set of fieldsOf(writeOptions, options)) setField(module, this.#run, set);
        const status = withText(module, path, (text) => module._run_write(this.#run, text));
        if (status !== 0) throw lastError(module);
        const bytes = module.FS.readFile(path);
        for (const file of module.FS.readdir(folder)) {
            if (file !== '.' && file !== '..') module.FS.unlink(`${folder}/${file}`);
        }
        return bytes;
    }

    /** Gives the memory of the result back. */
    free() {
        if (this.#run !== 0) this.#module._run_free(this.#run);
        this.#run = 0;
    }
}

function dimensionOf(fields) {
    return fields.some(({ field }) => field === 'lattice3') ? 3 : 2;
}

/**
 * Makes the module call progress(state). Returns an object whose `fault` is the exception of
 * progress(), which must not pass through the module and therefore ends the run as `false` does.
 */
function watch(module, progress) {
    const seen = {};
    module.progress =
        (iteration, evaluations, energy, energyBound, residual, phase, fraction, words, points, n) => {
            const state = {
                iteration, evaluations, energy, energyBound, residual, fraction,
                energyOverBound: energy / energyBound, phase: phases[phase], text: module.UTF8ToString(words),
            };
            if (n > 0) state.sites = numbersAt(module, points, 2 * n);
            try {
                return progress(state) === false ? 1 : 0;
            } catch (fault) {
                seen.fault = fault;
                return 1;
            }
        };
    return seen;
}

/** Runs in this thread; see mesh() in index.d.ts. */
export async function runHere({ progress, progressSites = false, ...options }) {
    const fields = fieldsOf(runOptions, options);
    if (options.sites === undefined) throw new OptionError('sites', 'no sites; give --sites N or --input FILE');
    const module = await load();
    const run = module._run_new();
    try {
        setField(module, run, { field: 'dimension', value: dimensionOf(fields) });
        for (const set of fields) setField(module, run, set);
        const seen = progress ? watch(module, progress) : {};
        const status = module._run_generate(run, Boolean(progress), Boolean(progressSites));
        if ('fault' in seen) throw seen.fault;
        if (status < 0 || status === cancelled) throw lastError(module, options);
        return new Result(module, run);
    } catch (error) {
        module._run_free(run);
        throw error;
    }
}
