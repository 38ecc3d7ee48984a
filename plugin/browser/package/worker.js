// One run in a module worker. The page sends {type: 'mesh', options}, then {type: 'write', id, name, options}.
import { runHere } from './engine.js';

let result;

const failure = (error) => ({ message: error.message, option: error.option });

async function start({ options, withProgress }) {
    const progress = (state) => {
        postMessage({ type: 'progress', state });
        return true;
    };
    try {
        result = await runHere(withProgress ? { ...options, progress } : options);
        postMessage({ type: 'done', values: { ...result } });
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

onmessage = ({ data }) => (data.type === 'mesh' ? start(data) : write(data));
