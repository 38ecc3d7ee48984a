// page_parts.mjs PAGE: the parts of the page in the folder PAGE that need no browser: the plot, the runs, and the words of
// commands. Exits with 1 where one is wrong.
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

/** The address of a script with its text; the page finds the words of options in the package that is built beside it. */
const addressOf = (name) => {
    const text = readFileSync(resolve(process.argv[2], name), 'utf8');
    const own = text.replace('./package/words.js', () => addressOf('../package/words.js'));
    return `data:text/javascript,${encodeURIComponent(own)}`;
};
const load = (name) => import(addressOf(name));
const { Plot } = await load('plot.js');
const { Runs } = await load('run.js');
const { commandOf, hashOf, readOptions } = await load('fields.js');
const { contentsInWords, numberOutside } = await load('table.js');

/** Plots levels with these numbers of iterations, the last of which is the run; returns the picture. */
function plotted(levels) {
    const svg = {}, plot = new Plot(svg), n = levels.reduce((sum, level) => sum + level, 0);
    let done = 0;
    levels.forEach((level, l) => {
        const phase = l + 1 === levels.length ? 'optimise' : 'start';
        for (let iteration = 0; iteration < level; ++iteration, ++done) {
            // A long step reports its iteration several times.
            for (let k = 0; k < 3; ++k) plot.add({ iteration, phase, residual: 1, energyOverBound: 1 + 10 ** (-3 * done / n) });
        }
    });
    plot.draw();
    return svg.innerHTML;
}

/** A plot runs from left to right inside of its frame, to its last iteration. */
function checkPlot() {
    for (const levels of [[50], [2], [90, 40, 20], [2, 2, 2], [700, 300, 2500], [3, 0, 10]]) {
        const picture = plotted(levels), n = levels.reduce((sum, level) => sum + level, 0);
        const curve = picture.match(/class="curve" d="M([^"]*)"/)[1].split('L').map((point) => point.split(' ').map(Number));
        curve.forEach(([x, y], k) => {
            assert(x >= 40 && x <= 294 && y >= 16 && y <= 98, `${levels}: a point at ${x}, ${y}`);
            assert(k === 0 || x >= curve[k - 1][0], `${levels}: the plot runs back`);
        });
        assert.strictEqual(curve.at(-1)[0], 294);
        assert(picture.includes(`>${n - 1} iterations<`), `${levels}: ${picture}`);
        const begins = picture.match(/class="grid" d="M[\d.]+ 16V98"/g) ?? [];
        assert.strictEqual(begins.length, levels.filter((level) => level > 0).length - 1);
    }
}

/** A page that records its events, and runs whose ends the test chooses. */
function watchedRuns() {
    const seen = [], calls = [];
    const mesh = (options) => new Promise((finish, fail) => {
        const name = `result ${calls.length}`;
        const end = (sites) => finish({ name, sites: Float64Array.from(sites), free: () => seen.push(`free ${name}`) });
        calls.push({ options, end, fail });
    });
    const runs = new Runs(mesh, {
        progress: () => seen.push('progress'),
        ended: (result, stopped) => seen.push(`${stopped ? 'stopped' : 'ended'} ${result.name}`),
        failed: (error) => seen.push(`failed ${error.message}`),
    });
    const settle = () => new Promise((resolve) => { setTimeout(resolve); });
    /** Lets a run report sites, and cancels it if progress() returns a true value. */
    const report = async (k, sites) => {
        const ends = calls[k].options.progress({ sites: Float64Array.from(sites) });
        if (ends) calls[k].fail(new Error('cancelled'));
        await settle();
    };
    return { seen, calls, runs, settle, report };
}

/** The options that the page shows as a command are those that give the result. */
async function checkStopAndGoOn() {
    const { seen, calls, runs, settle, report } = watchedRuns();
    runs.start({ sites: 2, start: 'coarse', tolerance: 1e-8 });
    await report(0, [1, 2, 3, 4]);
    runs.stop();
    await report(0, [9, 9, 9, 9]);
    assert(runs.isRunning && runs.made === null, 'the stopped state is not yet evaluated');
    assert.deepStrictEqual(calls[1].options, { sites: Float64Array.of(1, 2, 3, 4), tolerance: 1e-8, maxIterations: 0 });
    calls[1].end([1, 2, 3, 4]);
    await settle();
    assert.deepStrictEqual(runs.made, calls[1].options);
    runs.goOn();
    assert.strictEqual(runs.made, null);
    calls[2].end([5, 6, 7, 8]);
    await settle();
    assert.deepStrictEqual(runs.made, { sites: Float64Array.of(1, 2, 3, 4), tolerance: 1e-8 });
    assert.deepStrictEqual(seen, ['progress', 'stopped result 1', 'free result 1', 'ended result 2']);
}

/** A run that is replaced no longer shows anything, in any state. */
async function checkReplacement() {
    for (const replace of ['running', 'stopping', 'evaluated']) {
        const { seen, calls, runs, settle, report } = watchedRuns();
        runs.start({ sites: 2 });
        await report(0, [1, 2, 3, 4]);
        if (replace !== 'running') runs.stop();
        if (replace === 'evaluated') await report(0, [1, 2, 3, 4]);
        runs.start({ sites: 3 });
        const last = calls.length - 1;
        calls[last].end([1, 2, 3, 4, 5, 6]);
        await settle();
        for (const call of calls.slice(0, last)) call.end([7, 7, 7, 7]);
        await settle();
        assert.strictEqual(runs.result.name, `result ${last}`);
        assert.deepStrictEqual(runs.made, { sites: 3 });
        assert.deepStrictEqual(seen.filter((word) => /ended|stopped|failed/.test(word)), [`ended result ${last}`]);
    }
    const { seen, calls, runs, settle } = watchedRuns();
    runs.start({ sites: 2 });
    calls[0].fail(new Error('no'));
    await settle();
    assert.deepStrictEqual([seen, runs.made, runs.isRunning], [['failed no'], null, false]);
}

function checkCommands() {
    const tile = { mesh: 'voronoi', outline: 'whole' };
    const given = { lattice: [1, 0, 0, 1], sites: Float64Array.of(0.5, 0.5), seed: 3 };
    const rows = [
        [{ lattice: [1, 0, 0, 1], sites: 20, seed: 0 }, tile, 'obj', 'pcvt mesh --sites 20 -o tile.obj'],
        [{ lattice: [1, 0, 0.5, 1], sites: 20, density: "1 + u' " }, { mesh: 'delaunay', outline: 'box', colour: 'size' }, 'svg',
            "pcvt mesh --sites 20 --lattice 1,0,0.5,1 --density '1 + u'\\'' ' --mesh delaunay --outline box --colour size -o tile.svg"],
        [given, tile, 'ply', 'pcvt mesh --input sites.txt -o tile.ply'],
        [{ ...given, maxIterations: 0, areas: 'equal' }, tile, 'ply',
            'pcvt mesh --input sites.txt --seed 3 --max-iterations 0 --areas equal -o tile.ply'],
    ];
    const files = { 'my points.csv': '0.5 0.5' }, lattice = [1, 0, 0, 1];
    rows.push(
        [{ lattice, input: 'my points.csv', files, seed: 3 }, tile, 'ply', "pcvt mesh --input 'my points.csv' -o tile.ply"],
        [{ lattice, input: 'my points.csv', files, seed: 3, areas: 'equal' }, tile, 'ply',
            "pcvt mesh --input 'my points.csv' --seed 3 --areas equal -o tile.ply"],
        [{ lattice, sites: 3, areas: 'g.csv:D', files, seed: 3 }, tile, 'ply',
            'pcvt mesh --sites 3 --seed 3 --areas g.csv:D -o tile.ply']);
    for (const [options, choices, extension, command] of rows) {
        assert.strictEqual(commandOf(options, choices, extension), command);
    }
    const texts = { sites: '30', seed: '0', lattice: '1, 0, 0, 1', density: '', symmetry: '', walls: '', wallCells: '', areas: '',
        start: '', solver: '', tolerance: '1e-4', maxIterations: '' };
    assert.deepStrictEqual(readOptions(texts), { tolerance: 1e-4, seed: 0, lattice: [1, 0, 0, 1], sites: 30 });
    globalThis.document = { getElementById: (id) => ({ value: { mesh: 'grains', outline: 'whole' }[id] }) };
    assert.strictEqual(hashOf(texts), 'tolerance=1e-4&sites=30&mesh=grains');
}

/** A run that goes on begins with its sites in place of the table of sites, and keeps a table of sizes. */
async function checkTablesOfRuns() {
    for (const [options, kept] of [
        [{ input: 'p.csv', files: { 'p.csv': '' } }, {}],
        [{ sites: 2, areas: 'a.csv', files: { 'a.csv': '' } }, { areas: 'a.csv', files: { 'a.csv': '' } }],
    ]) {
        const { calls, runs, settle } = watchedRuns();
        runs.start(options);
        calls[0].end([1, 2, 3, 4]);
        await settle();
        runs.goOn();
        const { progress, progressSites, ...others } = calls[1].options;
        assert.deepStrictEqual(others, { ...kept, sites: Float64Array.of(1, 2, 3, 4) });
    }
}

/** The page says what a table holds, and how many sites lie outside of the period. */
function checkWordsOfTables() {
    const oblique = [2, 0, 1, 2], sites = Float64Array.of(0, 0, 3, 2, 1.5, 1, 0.2, 1, -0.1, 0);
    assert.strictEqual(numberOutside(sites, oblique), 2);
    const table = { use: 'sites', rows: 5, quantity: 'sites', columns: ['x', 'y'], unit: 'um', sites };
    assert.strictEqual(contentsInWords(table, oblique), '5 sites from columns x, y. Lengths are those of the period vectors, ' +
        'which are in um as well. 2 of them lie outside of the period and count modulo the period vectors.');
    assert.match(contentsInWords(table, [1e-3, 0, 0, 1e-3]), / 4 of them lie .* vectors: the period vectors may be wrong\.$/);
    assert.strictEqual(contentsInWords({ use: 'sizes', rows: 1200, quantity: 'diameters', columns: ['ECD'], unit: 'um' }, oblique),
        '1,200 diameters from column ECD in um, one for each site. The areas of the cells are scaled to the area of the period.');
    assert.match(contentsInWords({ use: 'sizes', rows: 1, quantity: 'areas', columns: [], unit: '' }, oblique),
        /^1 area, without a header, one/);
}

checkPlot();
await checkTablesOfRuns();
checkWordsOfTables();
await checkStopAndGoOn();
await checkReplacement();
checkCommands();
console.log('tables are named in words; the plot stays in its frame; runs stop, go on and replace each other; commands name what gives the result');
