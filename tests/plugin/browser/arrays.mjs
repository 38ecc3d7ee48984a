// arrays.mjs PACKAGE: the arrays of results of the npm package in the folder PACKAGE fit each other and the files; progress()
// ends a run by a true value; wrong tables, freed results and options of the other dimension are refused. Exits with 1 otherwise.
import assert from 'node:assert';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const { Cancelled, OptionError, mesh, readTable } = await import(pathToFileURL(resolve(process.argv[2], 'index.js')));

const oblique = [1, 0, 0.3, 0.9];
const near = (a, b) => Math.abs(a - b) < 1e-9;
const sum = (values) => values.reduce((total, value) => total + value, 0);

/** The point of vertex v, moved by the offset (i, j) or (i, j, k). */
function moved(points, v, lattice, offset) {
    const d = offset.length;
    return offset.map((_, axis) => points[d * v + axis] + sum(offset.map((n, k) => n * lattice[d * k + axis])));
}

function assertNear(p, q, what) {
    assert(p.every((x, k) => near(x, q[k])), `${what}: ${p} and ${q}`);
}

const triple = (array, k, n) => [...array.subarray(n * k, n * k + n)];

/** Every vertex is the image of its orbit, and each pair of the seam is glued by its translation. */
function checkTile(tile, nFaces, kind) {
    const { lattice, points, faceBegin, corners, vertexOrbit, vertexOffset, seam } = tile;
    const n = points.length / 2;
    assert(points instanceof Float64Array && corners instanceof Int32Array && seam instanceof Int32Array);
    assert.deepStrictEqual([faceBegin.length, faceBegin[0], faceBegin.at(-1)], [nFaces + 1, 0, corners.length]);
    assert.deepStrictEqual([vertexOrbit.length, vertexOffset.length], [n, 2 * n]);
    for (let v = 0; v < n; ++v) {
        assertNear(triple(points, v, 2), moved(points, vertexOrbit[v], lattice, triple(vertexOffset, v, 2)), `vertex ${v}`);
    }
    for (let s = 0; s < seam.length; s += 6) {
        const [v0, v1, w0, w1, i, j] = seam.subarray(s, s + 6);
        assertNear(triple(points, w0, 2), moved(points, v0, lattice, [i, j]), 'the first end of a pair');
        assertNear(triple(points, w1, 2), moved(points, v1, lattice, [i, j]), 'the second end of a pair');
    }
    let area = 0;
    for (let f = 0; f < nFaces; ++f) {
        const face = corners.subarray(faceBegin[f], faceBegin[f + 1]);
        face.forEach((v, k) => {
            const w = face[(k + 1) % face.length];
            area += (points[2 * v] * points[2 * w + 1] - points[2 * v + 1] * points[2 * w]) / 2;
        });
    }
    assert(near(area, 0.9 * nFaces / tile.nFacesOfPeriod), `${kind}: the area is ${area}`);
}

async function checkPlane() {
    const result = await mesh({ sites: 40, seed: 2, lattice: oblique });
    assert.strictEqual(result.dimension, 2);
    assert.deepStrictEqual([...result.lattice], oblique);
    for (const outline of ['whole', 'box']) {
        const tile = result.tile({ outline }), nFaces = tile.faceBegin.length - 1;
        checkTile({ ...tile, nFacesOfPeriod: nFaces }, nFaces, outline);
        assert.strictEqual(tile.faceSite.length, nFaces);
    }
    const whole = result.tile();
    assert.deepStrictEqual([...whole.faceSite].sort((a, b) => a - b), Array.from({ length: 40 }, (_, s) => s));
    const triangles = result.tile({ mesh: 'delaunay' });
    checkTile({ ...triangles, nFacesOfPeriod: 80 }, 80, 'delaunay');
    assert.deepStrictEqual([triangles.faceSite, triangles.sitePoints], [null, null]);
    assert.strictEqual(triangles.vertexSite.length, triangles.points.length / 2);
    assert(result.tile({ mesh: 'grains' }).faceBegin.length > 41);
    checkTorus(result);
    checkCells(result);
    assert.throws(() => result.tile({ mesh: 'squares' }), /^OptionError: --mesh squares: unknown; take voronoi, delaunay or grains$/);
    assert.throws(() => result.tile({ colour: 'size' }), /--colour: unknown option/);
    result.free();
    assert.throws(() => result.tile(), /the result has been freed/);
}

/** The corner that the same edge leaves on the face across has the same edge. */
function checkTorus(result) {
    for (const [kind, nFaces] of [['voronoi', 40], ['delaunay', 80]]) {
        const torus = result.torusMesh({ mesh: kind }), { faceBegin, cornerVertex, opposite } = torus;
        assert.deepStrictEqual([faceBegin.length - 1, torus.site.length], [nFaces, 40]);
        opposite.forEach((o, c) => assert.strictEqual(opposite[o], c));
        const after = Int32Array.from(cornerVertex, (_, c) => c + 1);
        for (let f = 0; f < nFaces; ++f) after[faceBegin[f + 1] - 1] = faceBegin[f];
        opposite.forEach((o, c) => assert.strictEqual(cornerVertex[after[o]], cornerVertex[c]));
        assert.strictEqual(torus.sitePoints?.length, kind === 'voronoi' ? 80 : undefined);
    }
}

/** The measures of the cells are those of the .csv file. */
function checkCells(result) {
    const cells = result.cells(), lines = new TextDecoder().decode(result.write('cells.csv')).split('\n');
    const begin = lines.findIndex((line) => line.startsWith('site,')), columns = lines[begin].split(',');
    const rows = lines.slice(begin + 1).filter((line) => line !== '');
    assert.strictEqual(rows.length, cells.site.length);
    rows.forEach((line, c) => {
        const row = Object.fromEntries(line.split(',').map((value, k) => [columns[k], value]));
        assert.deepStrictEqual([cells.site[c], cells.sides[c]], [Number(row.site), Number(row.sides)]);
        assert.deepStrictEqual(triple(cells.sites, c, 2), [Number(row.x), Number(row.y)]);
        for (const name of ['area', 'diameter', 'circularity']) {
            assert(near(cells[name][c], Number(row[name])), `${name} of cell ${c}: ${cells[name][c]}, in the file ${row[name]}`);
        }
        const own = [...cells.neighbours.subarray(cells.neighbourBegin[c], cells.neighbourBegin[c + 1])];
        const order = (a, b) => a - b;
        assert.deepStrictEqual(own.sort(order), row.neighbours.split(' ').map(Number).sort(order));
        if (row.weight) assert.strictEqual(cells.weights[c], Number(row.weight));
        if (row.phase) assert.strictEqual(result.phaseNames[cells.phases[c]], row.phase);
    });
}

async function checkSpace() {
    const result = await mesh({ sites: 30, seed: 1, period: [1, 1.5, 1] }), tile = result.tile();
    assert.strictEqual(result.dimension, 3);
    assert.deepStrictEqual([result.sites.length, tile.volumes.length, tile.sitePoints.length], [90, 30, 90]);
    assert(near(sum(tile.volumes), 1.5));
    const { points, lattice, faceBegin, facePoints, nInnerFaces: inner } = tile, nFaces = faceBegin.length - 1;
    for (let p = 0; p < points.length / 3; ++p) {
        assertNear(triple(points, p, 3), moved(points, tile.pointOrbit[p], lattice, triple(tile.pointOffset, p, 3)), `point ${p}`);
    }
    assert.deepStrictEqual([tile.owner.length, tile.neighbour.length, tile.partner.length, tile.partnerOffset.length],
        [nFaces, nFaces, nFaces - inner, 3 * (nFaces - inner)]);
    tile.neighbour.forEach((cell, f) => assert.strictEqual(cell === -1, f >= inner));
    tile.partner.forEach((g, b) => {
        const first = facePoints[faceBegin[inner + b]], glued = facePoints[faceBegin[g]];
        assertNear(triple(points, glued, 3), moved(points, first, lattice, triple(tile.partnerOffset, b, 3)), `face ${inner + b}`);
    });
    assert.throws(() => result.cells(), /cells\(\) is for the plane/);
    assert.throws(() => result.tile({ mesh: 'delaunay' }), OptionError);
    result.free();
}

/** Weights and the phases of sites, as pcvt.mesh() of Python takes them. */
async function checkWeightsAndPhases() {
    const sites = Float64Array.of(0.1, 0.1, 0.5, 0.6, 0.8, 0.3), weights = [0, 0.01, 0.02], angles = [1, 2, 3, 4, 5, 6, 7, 8, 9];
    const result = await mesh({ sites, weights, maxIterations: 0, phases: ['soft', 'hard', 'soft'], orientations: angles });
    assert.deepStrictEqual([...result.weights], weights);
    assert.deepStrictEqual([[...result.phases], result.phaseNames], [[0, 1, 0], ['soft', 'hard']]);
    assert.deepStrictEqual([...result.orientations], angles);
    checkCells(result);
    result.free();
    // Nearly, four cells meet in each corner of squares: the edges between two of them are too short to count as sides.
    const nearSquares = Float64Array.of(0.1, 0.1, 0.6, 0.1000003, 0.1, 0.6, 0.6000002, 0.6);
    const squares = await mesh({ sites: nearSquares, maxIterations: 0 });
    assert.strictEqual(squares.torusMesh().cornerVertex.length, 24);
    assert.deepStrictEqual([...squares.cells().sides], [4, 4, 4, 4]);
    checkCells(squares);
    squares.free();
    const plain = await mesh({ sites: 12 });
    assert.deepStrictEqual([plain.weights, plain.phases, plain.orientations, plain.orbits], [null, null, null, null]);
    plain.free();
    const drawn = await mesh({ sites: 12, phases: { a: 0.5, b: 0.5 }, orientations: 'random' });
    assert.deepStrictEqual([drawn.phaseNames, drawn.phases.length, drawn.orientations.length], [['a', 'b'], 12, 36]);
    drawn.free();
    const refused = [[{ sites: 3, weights }, /weights/], [{ sites, weights: [1], maxIterations: 0 }, /n_weights is not n_sites/],
        [{ sites, phases: ['a'] }, /n_site_phases is not n_sites/], [{ sites, orientations: [1, 2] }, /three angles for each site/]];
    for (const [options, message] of refused) await assert.rejects(mesh(options), message);
}

/** A true value of progress() ends a run, any other one does not; an exception ends it and passes through. */
async function checkProgress() {
    for (const answer of [undefined, false, null, 0, '', NaN]) {
        const result = await mesh({ sites: 50, progress: () => answer });
        assert.strictEqual(result.stop, 'converged');
        result.free();
    }
    for (const answer of [true, 1, 'stop', {}]) {
        let calls = 0;
        await assert.rejects(mesh({ sites: 50, progress: () => (++calls, answer) }), Cancelled);
        assert.strictEqual(calls, 1);
    }
    await assert.rejects(mesh({ sites: 50, progress: async () => {} }), /progress\(\) returned a promise/);
    await assert.rejects(mesh({ sites: 50, progress: () => { throw new RangeError('mine'); } }), /^RangeError: mine$/);
}

async function checkTableContents() {
    const files = { 'a:b.csv': 'x (um),y (um)\n1,2\n3,4\n', 'e.csv': 'id;Area;ECD\n1;2;3\n' };
    assert.deepStrictEqual(await readTable({ table: 'a:b.csv', files }), {
        use: 'sites', rows: 2, name: 'a:b.csv', quantity: 'sites', columns: ['x', 'y'], unit: 'um', sites: Float64Array.of(1, 2, 3, 4),
    });
    const found = await readTable({ table: 'diameter:e.csv', files });
    assert.deepStrictEqual([found.name, found.quantity, found.columns, found.sites], ['diameter:e.csv', 'diameters', ['ECD'], null]);
    await assert.rejects(readTable({ table: 'e.csv', files }), /^OptionError: e\.csv:1: both column 'Area' and column 'ECD' hold sizes/);
    await assert.rejects(readTable({ table: 'e.csv', files, use: 'lengths' }), /take sites or sizes/);
    await assert.rejects(readTable({ table: 'none.csv', files }), /^Error: none\.csv: cannot read: /);
    for (const name of ['-', '..', 'a/b', '']) {
        await assert.rejects(readTable({ table: name, files: { [name]: '1\n' } }), /is not the name of a file/);
    }
    // A table of an earlier call is gone.
    await assert.rejects(mesh({ input: 'e.csv' }), /cannot read/);
}

await checkPlane();
await checkSpace();
await checkWeightsAndPhases();
await checkProgress();
await checkTableContents();
console.log('the arrays fit each other and the files; progress() ends runs by a true value; tables are read');
