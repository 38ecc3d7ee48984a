// In the page of one file, in place of package/wasm.js: the compiled module and the worker, from elements of the page.

export async function compile() {
    const text = atob(document.getElementById('module').textContent);
    return WebAssembly.compile(Uint8Array.from(text, (letter) => letter.charCodeAt(0)));
}

export function startWorker() {
    const text = `${document.getElementById('scripts').textContent}\nneed('package/worker.js');`;
    return new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
}
