/**
 * The fields of the form. A row says how the text of a field becomes an option of mesh() and of the
 * command, and which words in a message of pcvt mean this field.
 */

import {words} from './package/words.js';

/** The words of an option with their labels, or without labels, behind the choice of no word. */
function choicesOf(option, labelOfNone, labels = {}) {
    const shown = Object.keys(words[option]).map((word) => [word, labels[word] ?? word]);
    return labelOfNone ? [['', labelOfNone], ...shown] : shown;
}

/** A message for one field. */
export class FieldFault extends Error {
    constructor(id, message) {
        super(message);
        this.id = id;
    }
}

function number(id, text) {
    const value = Number(text);
    if (!Number.isFinite(value)) throw new FieldFault(id, `“${text}” is not a number.`);
    return value;
}

function wholeNumber(id, text) {
    if (!/^-?\d+$/.test(text)) throw new FieldFault(id, 'Give a whole number.');
    const value = Number(text);
    if (!Number.isSafeInteger(value)) throw new FieldFault(id, 'This number is too large.');
    return value;
}

function notNegative(id, text) {
    const value = wholeNumber(id, text);
    if (value < 0) throw new FieldFault(id, 'Give a number of at least 0.');
    return value;
}

function atLeastOne(id, text) {
    const value = wholeNumber(id, text);
    if (value < 1) throw new FieldFault(id, 'Give a number of at least 1.');
    return value;
}

function vectors(id, text) {
    const parts = text.split(/[\s,;]+/).filter((part) => part !== '');
    if (parts.length !== 4) throw new FieldFault(id, 'Give four numbers: ax, ay, bx, by.');
    return parts.map((part) => number(id, part));
}

function asGiven(id, text) {
    return text;
}

/** In the order in which messages are searched for the field that they concern. */
export const FIELDS = [
    {id: 'density', value: '', read: asGiven, words: /densit|formula|expression/i},
    {
        id: 'symmetry',
        value: '',
        read: asGiven,
        words: /symmetr|plane group|p\d.*lattice/i,
        choices: choicesOf('symmetry', 'none')
    },
    {
        id: 'walls',
        value: '',
        read: asGiven,
        words: /walls|rectangle/i,
        choices: choicesOf('walls', 'none', {x: 'left, right', y: 'bottom, top', xy: 'all round'})
    },
    {
        id: 'wallCells',
        value: '',
        read: asGiven,
        words: /wall.cells|half cells/i,
        // The empty choice means whole cells.
        choices: choicesOf('wallCells', 'whole').filter(([word]) => word !== 'whole')
    },
    {id: 'areas', value: '', read: asGiven, words: /area|laws? of sizes/i},
    {
        id: 'start',
        value: '',
        read: asGiven,
        words: /start/i,
        choices: choicesOf('start', 'automatic', {lattice: 'best lattice', best: 'best of many'})
    },
    {
        id: 'solver',
        value: '',
        read: asGiven,
        words: /solver/i,
        // The empty choice means lbfgs.
        choices: choicesOf('solver', 'automatic', {lloyd: 'Lloyd', newton: 'Newton'})
                     .filter(([word]) => word !== 'lbfgs')
    },
    {id: 'tolerance', value: '', read: number, words: /tolerance/i},
    {id: 'maxIterations', value: '', read: notNegative, words: /iteration/i},
    {id: 'seed', value: '0', read: notNegative, words: /seed/i},
    {id: 'lattice', value: '1, 0, 0, 1', read: vectors, words: /lattice|period|parallel|vectors/i},
    {id: 'sites', value: '1000', read: atLeastOne, words: /site|memory/i},
];

/** The choices beside the form, which select the tile and not the run. */
export const CHOICES = {
    mesh: choicesOf('mesh', '', {
        voronoi: 'Voronoi cells',
        delaunay: 'Delaunay triangles',
        grains: 'triangles in cells'
    }),
    outline: choicesOf('outline', '', {whole: 'no cell is cut', box: 'cut along a, b'}),
};

export const EXAMPLES = [
    ['1 + 99 * exp(-((v - 0.5) / 0.1)^2)', 'A ridge'],
    ['exp(3 * cos(2 * pi * u) * cos(2 * pi * v))', 'Hills'],
    ['1 + 30 * exp(-40 * abs((u - 0.5)^2 + (v - 0.5)^2 - 0.08))', 'A ring'],
    ['(1.2 + sin(2 * pi * (u + v)))^2', 'A wave'],
];

function input(id) {
    return document.getElementById(id);
}

export function fillSelect(select, choices) {
    for (const [value, label] of choices) select.add(new Option(label, value));
}

export function fillForm() {
    for (const {id, value, choices} of FIELDS) {
        if (choices) fillSelect(input(id), choices);
        input(id).value = value;
    }
    for (const [id, choices] of Object.entries(CHOICES)) fillSelect(input(id), choices);
    fillSelect(input('examples'), EXAMPLES);
}

/** Shows a message at a field, '' removes it. */
export function showFault(id, message) {
    input(`${id}-fault`).textContent = message;
    if (message)
        input(id)?.setAttribute('aria-invalid', 'true');
    else
        input(id)?.removeAttribute('aria-invalid');
}

export function clearFaults() {
    for (const {id} of FIELDS) showFault(id, '');
    input('form-fault').textContent = '';
}

/**
 * Shows an error of the form or of pcvt at the field that it concerns, and moves the focus there.
 */
export function showError(error) {
    const known = error.id ?? error.option;
    const field =
        FIELDS.find(({id, words}) => known ? known === id : words.test(error.message));
    if (!field) {
        input('form-fault').textContent = error.message;
        return;
    }
    input(field.id).closest('details')?.setAttribute('open', '');
    showFault(field.id, error.message);
    input(field.id).focus();
}

/** Returns the texts of the fields, by id. */
export function formTexts() {
    return Object.fromEntries(FIELDS.map(({id}) => [id, input(id).value]));
}

/** Returns the choices beside the form, by id. */
export function choices() {
    return Object.fromEntries(Object.keys(CHOICES).map((id) => [id, input(id).value]));
}

/**
 * Returns the options of mesh() that differ from the defaults, and the sites; throws FieldFault.
 */
export function readOptions(texts) {
    const options = {};
    for (const {id, read} of FIELDS) {
        const text = texts[id].trim();
        if (text !== '' || id === 'sites' || id === 'lattice') options[id] = read(id, text);
    }
    return options;
}

function quoted(text) {
    return /^[\w.,:/+-]+$/.test(text) ? text : `'${text.replaceAll('\'', '\'\\\'\'')}'`;
}

/** The file of given sites in a command. */
export const SITES_FILE = 'sites.txt';

export function hasGivenSites(options) {
    return options.sites !== undefined && typeof options.sites !== 'number';
}

/**
 * Returns the command for options of mesh(), the options of the tile, and a file. Given sites are
 * read from SITES_FILE, unless they are those of the user's table.
 */
export function commandOf(options, tile, extension) {
    const words = ['pcvt mesh'], isGiven = hasGivenSites(options);
    if (options.input) words.push(`--input ${quoted(options.input)}`);
    const isDefault = {
        seed: (seed) => seed === 0 || ((isGiven || options.input) && !options.areas),
        lattice: (lattice) => `${lattice}` === '1,0,0,1',
    };
    for (const {id} of [...FIELDS].reverse()) {
        if (!(id in options) || isDefault[id]?.(options[id])) continue;
        const name = id.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
        words.push(
            id === 'sites' && isGiven ? `--input ${SITES_FILE}` :
                                        `--${name} ${quoted(`${options[id]}`)}`);
    }
    for (const [id, value] of Object.entries(tile)) {
        if (value !== undefined && value !== CHOICES[id]?.[0][0]) words.push(`--${id} ${value}`);
    }
    return `${words.join(' ')} -o tile.${extension}`;
}

/** Returns the hash that restores the texts of the form, and the choices. */
export function hashOf(texts) {
    const hash = new URLSearchParams();
    for (const {id, value} of FIELDS)
        if (texts[id] !== value) hash.set(id, texts[id]);
    for (const [id, value] of Object.entries(choices())) {
        if (value !== CHOICES[id][0][0]) hash.set(id, value);
    }
    return `${hash}`;
}

export function restore(hash) {
    const given = new URLSearchParams(hash);
    for (const {id, value} of FIELDS) input(id).value = given.get(id) ?? value;
    for (const [id, [[first]]] of Object.entries(CHOICES)) input(id).value = given.get(id) ?? first;
    // A select shows nothing for a value that it does not offer.
    for (const select of document.querySelectorAll('form select, #mesh, #outline')) {
        if (select.selectedIndex < 0) select.selectedIndex = 0;
    }
    input('more').open = input('more').open ||
        [...input('more').querySelectorAll('input, select')].some((field) => field.value !== '');
}
