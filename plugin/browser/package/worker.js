// Runs in a module worker, one after another. The page sends {type: 'load', wasm} once, then for each run
// {type: 'mesh', options, withProgress}, {type: 'write', id, name, options} for each file, and {type: 'free'}.
import { runHere, sizeOfMemory, useModule } from './engine.js';

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

function write({ id, name, options }) {
    try {
        const bytes = result.write(name, options);
        postMessage({ type: 'written', id, bytes }, [bytes.buffer]);
    } catch (error) {
        postMessage({ type: 'written', id, error: failure(error) });
    }
}

const handlers = {
    load: ({ wasm }) => useModule(wasm),
    mesh: start,
    write,
    free: () => result.free(),
};

onmessage = ({ data }) => handlers[data.type](data);
