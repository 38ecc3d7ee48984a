// The options of mesh() and write(): names of the command's long options in camelCase. Each entry checks a
// value, with the command's message, and says which field of the C interface takes it.

import { words } from './words.js';

const flag = (name) => `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** An error of an option: the message is the command's line, `option` the name here. */
export class OptionError extends Error {
    constructor(option, message) {
        super(message);
        this.name = 'OptionError';
        this.option = option;
    }
}

function refuse(name, value, complaint) {
    throw new OptionError(name, `${flag(name)} ${value}: ${complaint}`);
}

const whole = (field, lowest, highest) => (name, value) => {
    const form = `give a whole number from ${lowest} to ${highest}`;
    if (!Number.isInteger(value) || value < 0) refuse(name, value, `not a whole number; ${form}`);
    if (value < lowest) refuse(name, value, `too small; ${form}`);
    if (value > highest) refuse(name, value, `too large for pcvt; ${form}`);
    return { field, value };
};

const positive = (field) => (name, value) => {
    if (typeof value !== 'number' || !(value > 0) || !Number.isFinite(value)) {
        refuse(name, value, 'not above 0; give a positive number, such as 1e-6');
    }
    return { field, value };
};

const anyOf = (words) => words.slice(0, -1).join(', ') + (words.length > 1 ? ' or ' : '') + words.at(-1);

/** One of the words of an option, whose field has the number of the word in pcvt.h. */
const choice = (field, numbersOfWords) => (name, value) => {
    if (!Object.hasOwn(numbersOfWords, value)) refuse(name, value, `unknown; take ${anyOf(Object.keys(numbersOfWords))}`);
    return { field, value: numbersOfWords[value] };
};

/** @param form  the numbers in words; where there may be several counts of them, the forms that the option takes. */
const numbers = (field, counts, form) => (name, value) => {
    const list = Float64Array.from(value);
    if (counts && !counts.includes(list.length)) {
        const given = list.length === 1 ? '1 was given' : `${list.length} were given`;
        refuse(name, [...value].join(','), counts.length > 1 ? `takes ${form}; ${given}`
            : `${list.length} of ${counts[0]} numbers; give ${form}`);
    }
    const bad = [...list].findIndex((x) => !Number.isFinite(x));
    if (bad >= 0) refuse(name, [...value].join(','), `'${value[bad]}' is not a finite number; give finite numbers`);
    return { field, value: list };
};

const text = (field) => (name, value) => {
    if (typeof value !== 'string') refuse(name, value, 'not a text');
    return { field, value };
};

/** The largest number of sites. */
export const mostSites = 268435456;

function sites(name, value) {
    if (typeof value === 'number') return whole('n_sites', 1, mostSites)(name, value);
    const list = numbers('sites')(name, value);
    if (list.value.length === 0) refuse(name, '', 'holds no sites; give at least one');
    return list;
}

function seed(name, value) {
    if (!Number.isSafeInteger(value) || value < 0) {
        refuse(name, value, 'not a seed; give a whole number from 0 to 18446744073709551615');
    }
    return { field: 'seed', value };
}

function period(name, value) {
    const sides = numbers('', [2, 3], 'two numbers W,H, or three in space W,H,D')(name, value).value;
    if (sides.some((side) => side <= 0)) {
        refuse(name, [...sides].join(','), 'a side is not above 0; give two positive lengths');
    }
    const [w, h, d] = sides;
    if (sides.length === 2) return { field: 'lattice', value: Float64Array.of(w, 0, 0, h) };
    return { field: 'lattice3', value: Float64Array.of(w, 0, 0, 0, h, 0, 0, 0, d) };
}

function lattice(name, value) {
    const takes = 'the four numbers of two period vectors, or the nine of three in space';
    const list = numbers('lattice', [4, 9], takes)(name, value);
    return list.value.length === 9 ? { ...list, field: 'lattice3' } : list;
}

/** Numbers, or a text that the module reads: the name of a table, of areas also a law. */
const numbersOrText = (field) => (name, value) =>
    (typeof value === 'string' ? text : numbers)(field)(name, value);

/** "NAME:FRACTION,...", {name: fraction}, or a list with the name of each site's phase. */
function phases(name, value) {
    if (typeof value === 'string') return { field: 'phases', value };
    if (!Array.isArray(value)) {
        const parts = Object.entries(value).map(([phase, fraction]) => `${phase}:${fraction}`);
        return { field: 'phases', value: parts.join(',') };
    }
    const names = [...new Set(value.map(String))];
    const indices = new Map(names.map((phase, k) => [phase, k]));
    return [{ field: 'phases', value: names.join(',') },
        { field: 'site_phases', value: Float64Array.from(value, (phase) => indices.get(String(phase))) }];
}

function orientations(name, value) {
    if (value === 'random') return { field: 'random_orientations', value: 1 };
    const list = numbers('orientations')(name, value);
    if (list.value.length % 3 !== 0) refuse(name, '', 'not three angles for each site; give phi1, Phi, phi2, ...');
    return list;
}

function aspect(name, value) {
    const [ratio, degrees = 0] = [value].flat();
    if (!(ratio >= 0.01 && ratio <= 100)) {
        refuse(name, [value].flat().join(','), 'the aspect ratio must lie between 0.01 and 100');
    }
    return [{ field: 'aspect', value: ratio }, { field: 'aspect_degrees', value: degrees }];
}

function fibres(name, value) {
    return { field: 'fibres', value: typeof value === 'string' ? value : [...value].join(',') };
}

function hole(name, value) {
    return { field: 'holes', value: [value].flat().join(',') };
}

function origin(name, value) {
    if (value === 'auto') return { field: 'find_origin', value: 1 };
    return numbers('origin', [2], 'X,Y')(name, value);
}

function repeat(name, value) {
    const [columns, rows] = numbers('', [2], 'IxJ')(name, value).value;
    return [whole('columns', 1, 1e6)(name, columns), whole('rows', 1, 1e6)(name, rows)].flat();
}

export const runOptions = {
    period,
    lattice,
    sites,
    seed,
    origin,
    input: text('input'),
    areas: numbersOrText('areas'),
    weights: numbersOrText('weights'),
    aspect,
    fibres,
    hole,
    repeat,
    density: text('density_source'),
    fixed: numbers('fixed_sites'),
    duplicates: choice('duplicates', words.duplicates),
    inclusions: text('inclusions'),
    maxIterations: whole('max_iterations', 0, 2147483647),
    order: whole('grain_order', 1, 2),
    perEdge: whole('grain_per_edge', 1, 2147483647),
    orientations,
    phases,
    shortEdges: positive('short_edges'),
    size: positive('grain_size'),
    solver: choice('solver', words.solver),
    start: choice('start', words.start),
    symmetry: choice('symmetry', words.symmetry),
    tolerance: positive('tolerance'),
    wallCells: choice('wall_cells', words.wallCells),
    walls: choice('walls', words.walls),
};

export const writeOptions = {
    mesh: choice('kind', words.mesh),
    outline: choice('outline', words.outline),
    colour: choice('colour', words.colour),
    glbNodes: choice('gltf_nodes', words.glbNodes),
    float32: (name, value) => ({ field: 'single_precision', value: value ? 1 : 0 }),
    pixels: whole('pixels', 1, 65536),
    surface: choice('surface', words.surface),
};

/** The fields of the C interface that `options` sets, those of the lattice first. */
export function fieldsOf(table, options, others = []) {
    for (const name of Object.keys(options)) {
        if (!(name in table) && !others.includes(name)) {
            throw new OptionError(name, `${flag(name)}: unknown option`);
        }
    }
    return Object.keys(table)
        .filter((name) => options[name] !== undefined && options[name] !== null)
        .flatMap((name) => [table[name](name, options[name])].flat().map((set) => ({ ...set, name })));
}

/** The fields of the options of mesh(); the others are not for the C interface. */
export function runFields(options) {
    const { sites, input } = options, isMissing = sites === undefined;
    if (isMissing && input === undefined) throw new OptionError('sites', 'no sites; give --sites N or --input FILE');
    if (!isMissing && input !== undefined) {
        throw new OptionError('sites', '--sites and --input exclude each other; remove one');
    }
    return fieldsOf(runOptions, options, ['progress', 'progressSites', 'files']);
}
