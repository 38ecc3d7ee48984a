// mesh() and readTable(): in node in this thread, in a browser in a worker.
import { Cancelled, cancels } from './errors.js';
import { OptionError, runFields } from './option_table.js';
import { compile, startWorker } from './wasm.js';

const inNode = typeof process !== 'undefined' && Boolean(process.versions?.node);

function errorOf({ message, option }) {
    return option ? new OptionError(option, message) : new Error(message);
}

/** A worker whose module takes more bytes ends with its result, because the memory of a module never shrinks. */
const mostBytesToKeep = 2 ** 28;

/** The compiled module, which all workers share. */
let compiled;
/** A worker that waits for its next run. */
let idle = null;

async function takeWorker() {
    compiled ??= compile();
    const wasm = await compiled;
    if (idle) {
        const worker = idle;
        idle = null;
        return worker;
    }
    const worker = startWorker();
    worker.postMessage({ type: 'load', wasm });
    return worker;
}

/** Keeps a worker for the next run, or ends it. */
function giveBack(worker, isSmall) {
    if (idle || !isSmall) worker.terminate();
    else idle = worker;
}

/** Calls of functions in a worker. */
class Calls {
    #worker;
    #waiting = new Map();
    #last = 0;

    constructor(worker) {
        this.#worker = worker;
        worker.onmessage = ({ data }) => {
            const { resolve, reject } = this.#waiting.get(data.id);
            this.#waiting.delete(data.id);
            if (data.error) reject(errorOf(data.error));
            else resolve(data.value);
        };
        worker.onerror = (event) => {
            this.isBroken = true;
            this.fail(new Error(event.message || 'the worker could not start'));
        };
    }

    make(method, ...given) {
        const id = ++this.#last;
        return new Promise((resolve, reject) => {
            this.#waiting.set(id, { resolve, reject });
            this.#worker.postMessage({ type: 'call', id, method, given });
        });
    }

    /** Ends the calls that wait; returns whether there are any. */
    fail(error) {
        const waiting = [...this.#waiting.values()];
        this.#waiting.clear();
        for (const { reject } of waiting) reject(error);
        return waiting.length > 0;
    }
}

/** The result of a worker, which keeps the tile. */
class RemoteResult {
    #worker;
    #bytes;
    #calls;

    constructor(worker, values, bytes) {
        this.#worker = worker;
        this.#bytes = bytes;
        this.#calls = new Calls(worker);
        Object.assign(this, values);
    }

    #call(...given) {
        return this.#worker ? this.#calls.make(...given) : Promise.reject(new Error('the result has been freed'));
    }

    write(name, options = {}) {
        return this.#call('write', name, options);
    }

    tile(options = {}) {
        return this.#call('tile', options);
    }

    torusMesh(options = {}) {
        return this.#call('torusMesh', options);
    }

    cells() {
        return this.#call('cells');
    }

    free() {
        const worker = this.#worker;
        if (!worker) return;
        this.#worker = null;
        const isBusy = this.#calls.fail(new Error('the result has been freed'));
        if (!isBusy) worker.postMessage({ type: 'free' });
        giveBack(worker, !isBusy && !this.#calls.isBroken && this.#bytes <= mostBytesToKeep);
    }
}

async function runInWorker({ progress, ...options }) {
    runFields(options);
    const worker = await takeWorker();
    return new Promise((resolve, reject) => {
        const fail = (error) => {
            worker.terminate();
            reject(error);
        };
        const show = (state) => {
            try {
                // The worker is busy until its run ends, so ending the worker ends the run.
                if (cancels(progress(state))) fail(new Cancelled());
            } catch (error) {
                fail(error);
            }
        };
        worker.onerror = (event) => fail(new Error(event.message || 'the worker could not start'));
        worker.onmessage = ({ data }) => {
            if (data.type === 'done') resolve(new RemoteResult(worker, data.values, data.bytes));
            else if (data.type === 'failed') fail(errorOf(data.error));
            else show(data.state);
        };
        worker.postMessage({ type: 'mesh', options, withProgress: Boolean(progress) });
    });
}

export async function mesh(options) {
    if (!inNode) return runInWorker(options);
    const { runHere } = await import('./engine.js');
    return runHere(options);
}

export async function readTable(given) {
    if (inNode) {
        const { readTableHere } = await import('./engine.js');
        return readTableHere(given);
    }
    const worker = await takeWorker();
    const calls = new Calls(worker);
    try {
        return await calls.make('readTable', given);
    } finally {
        giveBack(worker, !calls.isBroken);
    }
}

export { Cancelled, OptionError };
