// mesh(): in node in this thread, in a browser in a worker.
import { OptionError, fieldsOf, runOptions } from './option_table.js';
import { compile } from './wasm.js';

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
    const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.postMessage({ type: 'load', wasm });
    return worker;
}

/** The result of a worker, which keeps the tile. */
class RemoteResult {
    #worker;
    #bytes;
    #waiting = new Map();
    #last = 0;

    constructor(worker, values, bytes) {
        this.#worker = worker;
        this.#bytes = bytes;
        Object.assign(this, values);
        worker.onmessage = ({ data }) => {
            const { resolve, reject } = this.#waiting.get(data.id);
            this.#waiting.delete(data.id);
            if (data.error) reject(errorOf(data.error));
            else resolve(data.bytes);
        };
    }

    write(name, options = {}) {
        if (!this.#worker) return Promise.reject(new Error('the result has been freed'));
        const id = ++this.#last;
        return new Promise((resolve, reject) => {
            this.#waiting.set(id, { resolve, reject });
            this.#worker.postMessage({ type: 'write', id, name, options });
        });
    }

    free() {
        const worker = this.#worker;
        if (!worker) return;
        this.#worker = null;
        for (const { reject } of this.#waiting.values()) reject(new Error('the result has been freed'));
        if (idle || this.#waiting.size > 0 || this.#bytes > mostBytesToKeep) {
            worker.terminate();
        } else {
            worker.postMessage({ type: 'free' });
            idle = worker;
        }
    }
}

async function runInWorker({ progress, ...options }) {
    fieldsOf(runOptions, options, ['progressSites']);
    const worker = await takeWorker();
    return new Promise((resolve, reject) => {
        const fail = (error) => {
            worker.terminate();
            reject(error);
        };
        worker.onerror = (event) => fail(new Error(event.message || 'the worker could not start'));
        worker.onmessage = ({ data }) => {
            if (data.type === 'done') resolve(new RemoteResult(worker, data.values, data.bytes));
            else if (data.type === 'failed') fail(errorOf(data.error));
            // The worker is busy until its run ends, so ending the worker ends the run.
            else if (progress(data.state) === false) fail(new Error('cancelled; nothing is written'));
        };
        worker.postMessage({ type: 'mesh', options, withProgress: Boolean(progress) });
    });
}

export async function mesh(options) {
    if (!inNode) return runInWorker(options);
    const { runHere } = await import('./engine.js');
    return runHere(options);
}

export { OptionError };
