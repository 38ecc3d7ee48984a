// Runs of pcvt in this thread, on the WebAssembly module.
import { cellTable } from './cells.js';
import { Cancelled, cancels, lastError } from './errors.js';
import { found, integersAt, numbersAt, withNumbers, withText } from './memory.js';
import loadModule from './pcvt_wasm.mjs';
import { OptionError, fieldsOf, runFields, writeOptions } from './option_table.js';
import { cellsView, meshView, sitesView, tileView } from './views.js';
import { compile } from './wasm.js';

const stops = ['converged', 'iteration limit', 'stalled'];
const phases = ['start', 'optimise', 'build', 'prove', 'write'];
const cancelled = 1;
/** The folders of the module's file system in which files are written, and from which tables are read. */
const folder = '/out';
const inputs = '/in';

let loading;

/** Takes a compiled module, which another thread may share. */
export function useModule(wasm) {
    const instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm));
        return {};
    };
    loading = loadModule({ instantiateWasm }).then((module) => {
        module.FS.mkdir(inputs);
        module.FS.chdir(inputs);
        return module;
    });
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

/** Calls use() while the module's folder of inputs has the files {name: bytes or text}. */
function withFiles(module, files, use) {
    const names = Object.keys(files);
    for (const name of names) {
        if (/^$|^\.{1,2}$|^-$|[/\0\n]/.test(name)) throw new OptionError('files', `--files: '${name}' is not the name of a file`);
    }
    try {
        for (const name of names) module.FS.writeFile(name, files[name]);
        return use();
    } finally {
        for (const name of names) if (module.FS.analyzePath(name).exists) module.FS.unlink(name);
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

    constructor(module, run, dimension) {
        this.#module = module;
        this.#run = run;
        Object.assign(this, { dimension }, statisticsOf(module, run));
        const sites = found(module, (at) => module._run_sites(run, at));
        this.sites = numbersAt(module, sites.address, sites.n);
        const sides = found(module, (at) => module._run_valences(run, at));
        this.valences = integersAt(module, sides.address, sides.n);
        const dropped = found(module, (at) => module._run_dropped(run, at));
        this.dropped = integersAt(module, dropped.address, dropped.n);
        if (dimension === 2) Object.assign(this, sitesView(module, run));
    }

    /** The run, in the dimension that a method needs. */
    #runOf(method, dimension = this.dimension) {
        if (this.#run === 0) throw new Error('the result has been freed');
        if (dimension !== this.dimension) throw new Error(`${method}() is for the plane; in space take tile()`);
        return this.#run;
    }

    /** The bytes of a file; the extension of `name` selects the format. */
    write(name, options = {}) {
        const module = this.#module, run = this.#runOf('write');
        if (name.endsWith('.foam')) throw new Error(`${name}: a folder of files; the command writes it`);
        const path = `${folder}/${name.split('/').at(-1)}`;
        module._run_write_defaults(run);
        for (const set of fieldsOf(writeOptions, options)) setField(module, run, set);
        const status = withText(module, path, (text) => module._run_write(run, text));
        if (status !== 0) throw lastError(module);
        const bytes = module.FS.readFile(path);
        for (const file of module.FS.readdir(folder)) {
            if (file !== '.' && file !== '..') module.FS.unlink(`${folder}/${file}`);
        }
        return bytes;
    }

    /** The tile as arrays; in space the polyhedra. */
    tile(options = {}) {
        const run = this.#runOf('tile');
        const { kind = 0, outline = 0 } = choicesOf(options, this.dimension === 2 ? ['mesh', 'outline'] : []);
        return this.dimension === 2 ? tileView(this.#module, run, kind, outline) : cellsView(this.#module, run);
    }

    /** The cells or triangles on the torus as arrays. */
    torusMesh(options = {}) {
        const run = this.#runOf('torusMesh', 2);
        return meshView(this.#module, run, choicesOf(options, ['mesh']).kind ?? 0);
    }

    /** The measures of the cells. */
    cells() {
        return cellTable(meshView(this.#module, this.#runOf('cells', 2), 0), this);
    }

    /** Gives the memory of the result back. */
    free() {
        if (this.#run !== 0) this.#module._run_free(this.#run);
        this.#run = 0;
    }
}

/** The numbers of the words of options, by their fields. */
function choicesOf(options, names) {
    const table = Object.fromEntries(names.map((name) => [name, writeOptions[name]]));
    return Object.fromEntries(fieldsOf(table, options).map(({ field, value }) => [field, value]));
}

function dimensionOf(fields) {
    return fields.some(({ field }) => field === 'lattice3') ? 3 : 2;
}

/**
 * Makes the module call progress(state). Returns an object whose `fault` is the exception of
 * progress(), which must not pass through the module and therefore ends the run as `true` does.
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
                return cancels(progress(state)) ? 1 : 0;
            } catch (fault) {
                seen.fault = fault;
                return 1;
            }
        };
    return seen;
}

/** Runs in this thread; see mesh() in index.d.ts. */
export async function runHere({ progress, progressSites = false, files = {}, ...options }) {
    const fields = runFields(options), dimension = dimensionOf(fields);
    const module = await load();
    const run = module._run_new();
    try {
        setField(module, run, { field: 'dimension', value: dimension });
        for (const set of fields) setField(module, run, set);
        const seen = progress ? watch(module, progress) : {};
        const status = withFiles(module, files, () =>
            module._run_generate(run, Boolean(progress), Boolean(progressSites)));
        if ('fault' in seen) throw seen.fault;
        if (status === cancelled) throw new Cancelled();
        if (status < 0) throw lastError(module, { ...options, files });
        return new Result(module, run, dimension);
    } catch (error) {
        module._run_free(run);
        throw error;
    }
}

const uses = [undefined, 'sites', 'sizes'];

/** Reads a table in this thread; see readTable() in index.d.ts. */
export async function readTableHere({ table, files, use }) {
    if (!uses.includes(use)) throw new OptionError('use', `--use ${use}: unknown; take sites or sizes`);
    const module = await load();
    return withFiles(module, files, () => {
        const address = withText(module, table, (text) => module._table_lines(text, uses.indexOf(use)));
        if (address === 0) throw lastError(module, { input: table, files });
        const [chosen, rows, name, quantity, columns, unit] = module.UTF8ToString(address).split('\n');
        const points = found(module, (at) => module._table_points(at));
        const sites = chosen === 'sites' ? numbersAt(module, points.address, points.n) : null;
        const names = columns === '' ? [] : columns.split('\t');
        return { use: chosen, rows: Number(rows), name, quantity, columns: names, unit, sites };
    });
}
