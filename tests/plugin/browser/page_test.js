// page_test.js CHROMIUM PCVT PAGE: drives the page in the folder PAGE in headless Chromium.
// It runs, stops and goes on, drags a period vector, compares downloaded OBJs with the files of the
// command, reads tables, and gives wrong inputs, each of which must show a message at its field. Exits
// with 1 if a value is wrong or if the console has an entry. The same checks drive PAGE/pcvt.html as a
// double click opens it, without a server and without a network.
const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {execFileSync} = require('child_process');
const {pathToFileURL} = require('url');
const {withBrowser} = require('../../consumers/browser.js');
const {withServer} = require('./static_server.js');
const {checkOwnTables} = require('./table_checks.js');

// Field, wrong text, and other fields that the fault needs.
const kWrong = [
    ['sites', ''],
    ['sites', '0'],
    ['sites', '-5'],
    ['sites', '1.5'],
    ['sites', 'many'],
    ['seed', '-1'],
    ['seed', 'x'],
    ['lattice', '1, 0, 2, 0'],
    ['lattice', '1, 0, 1'],
    ['lattice', '1, 0, 0, up'],
    ['density', '1 +'],
    ['density', 'q'],
    ['tolerance', '-1'],
    ['areas', 'wide:1'],
    ['symmetry', 'p4', {lattice: '1, 0, 0.3, 0.9'}],
    ['walls', 'x', {lattice: '1, 0, 0.3, 0.9'}],
];

const text = (id) => `document.getElementById('${id}').textContent`;
const idle = `window.page && !page.runs.isRunning && ${text('status')} !== 'Running…'`;

async function open(browser, address, hash) {
    browser.events = [];
    await browser.send('Page.navigate', {url: 'about:blank'});
    await browser.send('Page.navigate', {url: `${address}#${hash}`});
    await browser.until(idle);
}

async function checkRun(browser, address) {
    await open(browser, address, 'sites=200&seed=3&lattice=1,0,0.3,0.9');
    assert(/^Converged: 200 sites/.test(await browser.value(text('status'))));
    assert.strictEqual(await browser.value('page.runs.result.sites.length'), 400);
    await browser.until(`document.getElementById('tile').contentWindow?.viewer?.shown`);
    const cells = `document.getElementById('tile').contentWindow.viewer.tile.nCells`;
    assert.strictEqual(await browser.value(cells), 200);
}

// The downloaded OBJ is that of the command on the page, byte for byte.
async function checkDownload(browser, pcvt) {
    const [program, ...options] = (await browser.value(text('command'))).split(' ');
    assert.strictEqual(program, 'pcvt');
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pcvt_page_'));
    try {
        execFileSync(pcvt, [...options, '--quiet'], {cwd: folder});
        const native = fs.readFileSync(path.join(folder, 'tile.obj'), 'utf8');
        assert(
            await browser.saved('#download') === native,
            'the OBJ differs from that of the command');
    } finally {
        fs.rmSync(folder, {recursive: true});
    }
}

async function checkDrag(browser, address) {
    await open(browser, address, 'sites=100');
    await browser.value(`document.getElementById('show-sites').click()`);
    await browser.until('page.stage.width > 0 && !page.stage.frame');
    const at = (x, y) => browser.value(`(() => {
        const box = page.stage.canvas.getBoundingClientRect(), [x, y] = page.stage.pixel(${x}, ${
        y});
        return [box.x + x, box.y + y];
    })()`);
    const [[x0, y0], [x1, y1]] = [await at(0, 1), await at(0.25, 0.75)];
    const mouse = (type, x, y) => browser.send(
        'Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons: 1, clickCount: 1});
    await mouse('mousePressed', x0, y0);
    await mouse('mouseMoved', (x0 + x1) / 2, (y0 + y1) / 2);
    await mouse('mouseMoved', x1, y1);
    await mouse('mouseReleased', x1, y1);
    await new Promise((resolve) => setTimeout(resolve, 100));
    await browser.until(idle);
    const lattice =
        (await browser.value(`document.getElementById('lattice').value`)).split(', ').map(Number);
    [1, 0, 0.25, 0.75].forEach(
        (value, k) => assert(Math.abs(lattice[k] - value) < 0.02, `${lattice}`));
    assert.deepStrictEqual(await browser.value('page.runs.options.lattice'), lattice);
    assert.strictEqual(
        new URLSearchParams(await browser.value('location.hash.slice(1)')).get('lattice'),
        lattice.join(', '));
}

async function checkStop(browser, address) {
    await open(browser, address, 'sites=20');
    await browser.value(`document.getElementById('sites').value = '20000', page.run()`);
    await browser.until('page.runs.sites?.length === 40000');
    await browser.value(`document.getElementById('stop').click()`);
    await browser.until(idle);
    assert(/^Stopped: 20,000 sites/.test(await browser.value(text('status'))));
    // The run has ended at its last state, and did not go on to its own end.
    assert.strictEqual(await browser.value('page.runs.made.maxIterations'), 0);
    await browser.value(`document.getElementById('go-on').click()`);
    await browser.until('page.runs.isRunning');
    await browser.until(idle);
    assert(/^Converged: 20,000/.test(await browser.value(text('status'))));
}

async function checkWrong(browser, address) {
    for (const [id, value, others = {}] of kWrong) {
        await open(browser, address, new URLSearchParams({sites: 50, ...others, [id]: value}));
        const message = await browser.value(text(`${id}-fault`));
        assert(message !== '', `no message at ${id} for '${value}'`);
        assert.strictEqual(await browser.value('document.activeElement.id'), id);
        assert.strictEqual(
            await browser.value('document.querySelectorAll("[aria-invalid]").length'), 1);
        console.log(`${id} '${value}': ${message}`);
    }
}

// The package in the page, whose runs are in a worker: arrays, and the rule by which progress() ends a run.
async function checkPackage(browser, address) {
    await open(browser, address, 'sites=20');
    const found = await browser.value(`(async () => {
        const {mesh} = typeof need === 'function' ? need('package/index.js') : await import('./package/index.js');
        const result = await mesh({sites: 30, progress: () => false});
        const [tile, torus, cells] = [await result.tile({outline: 'box'}), await result.torusMesh(), await result.cells()];
        const arrays = [tile.points, torus.vertices, cells.area].map((array) => array.constructor.name);
        const area = cells.area.reduce((sum, own) => sum + own);
        const fault = await result.tile({mesh: 'squares'}).catch((error) => error.option);
        result.free();
        const ends = async (progress) => {
            const error = await mesh({sites: 500, progress}).then(() => 'none', (fault) => fault);
            return error.name + ': ' + error.message;
        };
        return {arrays, nCells: cells.site.length, isWhole: Math.abs(area - 1) < 1e-12, seam: tile.seam.length % 6, fault,
            ends: [await ends(() => 1), await ends(() => { throw new RangeError('mine'); }), await ends(async () => {})]};
    })()`);
    assert.deepStrictEqual(found, {
        arrays: ['Float64Array', 'Float64Array', 'Float64Array'],
        nCells: 30,
        isWhole: true,
        seam: 0,
        fault: 'mesh',
        ends: [
            'Cancelled: cancelled by the progress callback; nothing is written', 'RangeError: mine',
            'TypeError: progress() returned a promise, which is a true value and would cancel the run; ' +
                'return true to cancel, or nothing'
        ],
    });
}

function complaints(browser, address) {
    return browser.complaints().filter((line) => !line.startsWith(`loads ${address}`));
}

async function drive(browser, pcvt, address) {
    await checkRun(browser, address);
    await checkDownload(browser, pcvt);
    assert.deepStrictEqual(complaints(browser, address), []);
    for (const check of [checkDrag, checkWrong, checkStop, checkPackage, checkOwnTables]) {
        await check(browser, address, pcvt);
        assert.deepStrictEqual(complaints(browser, address), []);
    }
    console.log(`${address}: the page runs, drags, downloads, reads tables, refuses, stops and goes on`);
}

// The page of one file has its scripts and its module inside.
async function driveFile(browser, pcvt, page) {
    await browser.send('Network.emulateNetworkConditions',
        {offline: true, latency: 0, downloadThroughput: -1, uploadThroughput: -1});
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pcvt one file '));
    try {
        const file = path.join(folder, 'pcvt.html');
        fs.copyFileSync(path.join(page, 'pcvt.html'), file);
        await drive(browser, pcvt, pathToFileURL(file).href);
    } finally {
        fs.rmSync(folder, {recursive: true});
    }
}

async function main(chromium, pcvt, page) {
    await withServer(
        page, (address) => withBrowser(chromium, (browser) => drive(browser, pcvt, address)));
    await withBrowser(chromium, (browser) => driveFile(browser, pcvt, page));
}

main(...process.argv.slice(2)).catch((fault) => {
    console.error(`page_test: ${fault.stack}`);
    process.exitCode = 1;
});
