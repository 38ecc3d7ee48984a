// Errors of runs, and the rule by which a progress function ends one.
import { OptionError } from './option_table.js';

/** The error of a run that its progress function ended. */
export class Cancelled extends Error {
    constructor() {
        super('cancelled by the progress callback; nothing is written');
        this.name = 'Cancelled';
    }
}

/** Whether the answer of progress() ends the run: a true value does, as in Python. */
export function cancels(answer) {
    if (typeof answer?.then === 'function') {
        throw new TypeError('progress() returned a promise, which is a true value and would cancel the run; ' +
            'return true to cancel, or nothing');
    }
    return Boolean(answer);
}

/** Words of messages of the C interface that name no option, and the option that they concern. */
const concerns = [
    [/^character \d+: |^the density /, 'density'],
    [/^the period vectors |^the lattice /, 'lattice'],
    [/laws? of sizes|^areas? |^the areas /, 'areas'],
    [/^the symmetry /, 'symmetry'],
    [/^the area fraction |fibre/, 'fibres'],
];

/** The option whose table a message begins with: "grains.csv:7: ...". */
function tableOption(line, options) {
    const name = Object.keys(options.files ?? {}).find((file) => line.startsWith(`${file}:`));
    if (name === undefined) return undefined;
    return ['input', 'areas', 'weights'].find((option) =>
        typeof options[option] === 'string' && options[option].includes(name));
}

/** The last error of the module, as the command words it. */
export function lastError(module, options = {}) {
    const line = module.UTF8ToString(module._pcvt_last_error()).replaceAll('/out/', '');
    // A message about options begins with the field of one: wall_cells.
    const first = line.split(' ', 1)[0].replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
    const option = tableOption(line, options) ?? (options[first] !== undefined ? first
        : concerns.find(([words, name]) => words.test(line) && options[name] !== undefined)?.[1]);
    if (option === 'density') return new OptionError(option, `--density '${options.density}': ${line}`);
    if (option === 'lattice') return new OptionError(option, `--lattice ${[...options.lattice]}: ${line}`);
    return option ? new OptionError(option, line) : new Error(line);
}
