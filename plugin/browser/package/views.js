// The arrays of a result: copies of the views of the C interface, in the order of views.cpp.
import { lastError } from './errors.js';
import { integersAt, numbersAt, withNumbers } from './memory.js';

/** Arrays of doubles; all others hold 32-bit integers. */
const reals = ['lattice', 'points', 'vertices', 'sitePoints', 'volumes', 'weights', 'orientations'];
/** Arrays that are null where a result does not have them; the others are empty. */
const optional = ['weights', 'phases', 'orientations', 'orbits', 'faceSite', 'sitePoints', 'vertexSite'];

const arraysOfSites = ['lattice', 'weights', 'phases', 'orientations', 'orbits'];
const arraysOfTile = ['lattice', 'points', 'faceBegin', 'corners', 'faceSite', 'sitePoints', 'vertexSite', 'vertexOrbit',
    'vertexOffset', 'seam', 'wallEdges'];
const arraysOfMesh = ['lattice', 'vertices', 'faceBegin', 'cornerVertex', 'cornerOffset', 'opposite', 'site', 'sitePoints'];
const arraysOfCells = ['lattice', 'points', 'pointOrbit', 'pointOffset', 'faceBegin', 'facePoints', 'owner', 'neighbour',
    'partner', 'partnerOffset', 'volumes', 'sitePoints'];

/** Calls look(arrays, more), which fills in the arrays of a view; `more` is the address of one more number or text. */
function viewOf(module, names, look, more = () => ({})) {
    return withNumbers(module, new Float64Array(names.length + 1), (address) => {
        const last = address + 8 * names.length;
        if (look(address, last) !== 0) throw lastError(module);
        const view = {};
        names.forEach((name, k) => {
            const begin = module.HEAPU32[address / 4 + 2 * k], n = module.HEAP32[address / 4 + 2 * k + 1];
            const copy = reals.includes(name) ? numbersAt : integersAt;
            view[name] = begin === 0 && optional.includes(name) ? null : copy(module, begin, begin === 0 ? 0 : n);
        });
        return { ...view, ...more(module.HEAPU32[last / 4]) };
    });
}

const words = (module, address) => module.UTF8ToString(address).split(',').filter((word) => word !== '');

export function sitesView(module, run) {
    return viewOf(module, arraysOfSites, (arrays, names) => module._view_sites(run, arrays, names),
        (names) => ({ phaseNames: words(module, names) }));
}

export function tileView(module, run, kind, outline) {
    return viewOf(module, arraysOfTile, (arrays, names) => module._view_tile(run, kind, outline, arrays, names),
        (names) => ({ holes: words(module, names) }));
}

export function meshView(module, run, kind) {
    return viewOf(module, arraysOfMesh, (arrays) => module._view_mesh(run, kind, arrays));
}

export function cellsView(module, run) {
    return viewOf(module, arraysOfCells, (arrays, inner) => module._view_cells(run, arrays, inner),
        (nInnerFaces) => ({ nInnerFaces }));
}
