// Runs in a worker, one after another. The page sends {type: 'load', wasm} once, then for each run
// {type: 'mesh', options, withProgress}, {type: 'call', id, method, given} for each use of its result, and {type: 'free'};
// {type: 'call', id, method: 'readTable', given} reads a table.
import { readTableHere, runHere, sizeOfMemory, useModule } from './engine.js';

let result;

const failure = (error) => ({ message: error.message, option: error.option });

function progress(state) {
    postMessage({ type: 'progress', state }, state.sites ? [state.sites.buffer] : []);
}

async function start({ options, withProgress }) {
    try {
        result = await runHere(withProgress ? { ...options, progress } : options);
        postMessage({ type: 'done', values: { ...result }, bytes: await sizeOfMemory() });
    } catch (error) {
        postMessage({ type: 'failed', error: failure(error) });
    }
}

async function call({ id, method, given }) {
    try {
        const value = method === 'readTable' ? await readTableHere(...given) : result[method](...given);
        postMessage({ id, value });
    } catch (error) {
        postMessage({ id, error: failure(error) });
    }
}

const handlers = {
    load: ({ wasm }) => useModule(wasm),
    mesh: start,
    call,
    free: () => result.free(),
};

onmessage = ({ data }) => handlers[data.type](data);
