// Texts and numbers in the memory of the module.
import { lastError } from './errors.js';

function withMemory(module, bytes, use) {
    const address = module._malloc(bytes) >>> 0;
    if (address === 0) throw new Error('out of memory; take fewer sites');
    try {
        return use(address);
    } finally {
        module._free(address);
    }
}

/** Calls use(address) with a text in the memory of the module. */
export function withText(module, text, use) {
    const size = module.lengthBytesUTF8(text) + 1;
    return withMemory(module, size, (address) => {
        module.stringToUTF8(text, address, size);
        return use(address);
    });
}

/** Calls use(address) with numbers in the memory of the module. */
export function withNumbers(module, numbers, use) {
    return withMemory(module, 8 * Math.max(1, numbers.length), (address) => {
        module.HEAPF64.set(numbers, address / 8);
        return use(address);
    });
}

/** A copy of n doubles in the memory of the module, whose addresses above 2 GiB arrive as negative numbers. */
export function numbersAt(module, address, n) {
    const begin = (address >>> 0) / 8;
    return module.HEAPF64.slice(begin, begin + n);
}

/** A copy of n integers in the memory of the module. */
export function integersAt(module, address, n) {
    const begin = (address >>> 0) / 4;
    return module.HEAP32.slice(begin, begin + n);
}

/** The address and the number of values that `find` stores and returns. */
export function found(module, find) {
    return withNumbers(module, [0], (address) => {
        const n = find(address);
        if (n < 0) throw lastError(module);
        return { address: module.HEAPU32[address / 4], n };
    });
}
