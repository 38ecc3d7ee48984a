// The compiled module, from the file beside this one.

export async function compile() {
    const url = new URL('./pcvt_wasm.wasm', import.meta.url);
    if (url.protocol !== 'file:') return WebAssembly.compileStreaming(fetch(url));
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
}
