// mesh(): in node in this thread, in a browser in a worker.
import { OptionError, fieldsOf, runOptions } from './option_table.js';

const inNode = typeof process !== 'undefined' && Boolean(process.versions?.node);

function errorOf({ message, option }) {
    return option ? new OptionError(option, message) : new Error(message);
}

/** The result of a worker, which keeps the tile. */
class RemoteResult {
    #worker;
    #waiting = new Map();

    constructor(worker, values) {
        this.#worker = worker;
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
        const id = crypto.randomUUID();
        return new Promise((resolve, reject) => {
            this.#waiting.set(id, { resolve, reject });
            this.#worker.postMessage({ type: 'write', id, name, options });
        });
    }

    free() {
        this.#worker?.terminate();
        this.#worker = null;
    }
}

function runInWorker({ progress, ...options }) {
    fieldsOf(runOptions, options, ['progressSites']);
    const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    return new Promise((resolve, reject) => {
        const fail = (error) => {
            worker.terminate();
            reject(error);
        };
        worker.onerror = (event) => fail(new Error(event.message || 'the worker could not start'));
        worker.onmessage = ({ data }) => {
            if (data.type === 'done') resolve(new RemoteResult(worker, data.values));
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
