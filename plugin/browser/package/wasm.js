// The files beside this one: the compiled module, and the worker.

export async function compile() {
    const url = new URL('./pcvt_wasm.wasm', import.meta.url);
    if (url.protocol !== 'file:') return WebAssembly.compileStreaming(fetch(url));
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
}

export function startWorker() {
    return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
}
