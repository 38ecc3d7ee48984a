// Opens each page in headless Chromium over a pipe of the DevTools protocol, points with the mouse
// at a cell and at an edge of the seam, presses keys, repeats the tile, and saves the SVG. Exits
// with 1 if a value on the page is wrong, if the picture is empty, or if the console has an error.
// The script html_page runs it.
const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {spawn} = require('child_process');
const {checkColours} = require('./html_page_colours.js');

const kFlags = [
    '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--hide-scrollbars', '--remote-debugging-pipe', '--window-size=1280,860'
];
const kPatience = 60000;
// The usual rate is 60 frames a second. Without a graphics processor and beside compilers it falls to
// 6, so that this limit finds pages that hang and nothing else.
const kLeastRate = 2;

// A browser with one tab; messages are JSON, each ended by a NUL byte.
class Browser {
    constructor(program, profile) {
        this.process = spawn(
            program, [...kFlags, `--user-data-dir=${profile}`, 'about:blank'],
            {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
        this.waiting = new Map();
        this.events = [];
        this.last = 0;
        let rest = Buffer.alloc(0);
        this.process.stdio[4].on('data', (bytes) => {
            rest = Buffer.concat([rest, bytes]);
            for (let end = rest.indexOf(0); end >= 0; end = rest.indexOf(0)) {
                this.receive(JSON.parse(rest.subarray(0, end).toString()));
                rest = rest.subarray(end + 1);
            }
        });
        this.process.on('exit', () => {
            for (const {reject} of this.waiting.values()) reject(new Error('the browser ended'));
        });
    }

    receive(message) {
        const answer = this.waiting.get(message.id);
        this.waiting.delete(message.id);
        if (!answer)
            this.events.push(message);
        else if (message.error)
            answer.reject(new Error(message.error.message));
        else
            answer.resolve(message.result);
    }

    send(method, params = {}) {
        const id = ++this.last;
        this.process.stdio[3].write(
            JSON.stringify({id, method, params, sessionId: this.session}) + '\0');
        return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
    }

    async open() {
        const {targetInfos} = await this.send('Target.getTargets');
        const {targetId} = targetInfos.find((target) => target.type === 'page');
        this.session =
            (await this.send('Target.attachToTarget', {targetId, flatten: true})).sessionId;
        for (const domain of ['Page', 'Runtime', 'Log', 'Network'])
            await this.send(`${domain}.enable`);
        await this.send(
            'Emulation.setDeviceMetricsOverride',
            {width: 1280, height: 860, deviceScaleFactor: 1, mobile: false});
    }

    // Returns the value of an expression on the page, which may be a promise.
    async value(expression) {
        const {result, exceptionDetails} = await this.send(
            'Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
        if (exceptionDetails) {
            throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        }
        return result.value;
    }

    async show(address) {
        this.events = [];
        // A change of the hash alone would not load the page.
        await this.send('Page.navigate', {url: 'about:blank'});
        await this.send('Page.navigate', {url: address});
        await this.until(
            'document.readyState === "complete" && ' +
            '(!document.getElementById("fault").hidden || ' +
            '(window.viewer?.shown && !viewer.painting && !viewer.isStale))');
    }

    async until(condition) {
        const end = Date.now() + kPatience;
        while (!await this.value(`Boolean(${condition})`)) {
            if (Date.now() > end) throw new Error(`waited in vain for ${condition}`);
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
    }

    async point(x, y) {
        await this.send('Input.dispatchMouseEvent', {type: 'mouseMoved', x, y});
    }

    async picture() {
        return Buffer.from(
            (await this.send('Page.captureScreenshot', {format: 'png'})).data, 'base64');
    }

    // Errors of the console and of scripts, refused loads, and requests of other addresses.
    complaints() {
        const texts = [];
        for (const {method, params} of this.events) {
            if (method === 'Runtime.exceptionThrown') texts.push(params.exceptionDetails.text);
            if (method === 'Log.entryAdded' && params.entry.level === 'error')
                texts.push(params.entry.text);
            if (method === 'Runtime.consoleAPICalled') texts.push(`console: ${params.type}`);
            const url = params?.request?.url;
            if (method === 'Network.requestWillBeSent' && !/^(file|about|data|blob):/.test(url))
                texts.push(`loads ${url}`);
        }
        return texts;
    }
}

// Returns the number of different colours of the canvas, on a grid of its pixels.
const kCountColours = `(() => {
    const {width, height} = viewer.canvas, seen = new Set();
    const {data} = viewer.context.getImageData(0, 0, width, height);
    for (let k = 0; k < data.length; k += 28) {
        seen.add(data[k] << 16 | data[k + 1] << 8 | data[k + 2]);
    }
    return seen.size;
})()`;

// Returns the lines of the values of a cell, "term value" or the text of a partner edge.
const kCellText = `[...document.querySelectorAll('#cell dt, #cell dd')].map((e) => e.textContent)`;

// Returns the pixels of the window at a point of the tile.
function windowPoint(point) {
    return `(() => {
        const box = viewer.canvas.getBoundingClientRect(), [x, y] = viewer.pixelOf(...${point});
        return [box.x + x, box.y + y];
    })()`;
}

// The centroid of the face `face` of a tile.
function centroid({points, faces}, face) {
    const corners = faces[face];
    return [0, 1].map(
        (k) => corners.reduce((sum, v) => sum + points[2 * v + k], 0) / corners.length);
}

// Moves the view so that the cells around a point are large enough for a mouse.
function lookAt(browser, [x, y]) {
    const scale = 'Math.max(viewer.view.scale, 20 / viewer.tile.h)';
    return browser.value(`viewer.look({x: ${x}, y: ${y}, scale: ${scale}})`);
}

// Returns the frames a second while the picture is moved for two seconds.
function frameRate(browser) {
    return browser.value(`new Promise((resolve) => {
        const begin = performance.now();
        let frames = 0;
        const step = (now) => {
            ++frames;
            viewer.move(2 * Math.sin(frames / 9), 1);
            if (now - begin < 2000) requestAnimationFrame(step);
            else resolve(Math.round(1000 * frames / (now - begin)));
        };
        requestAnimationFrame(step);
    })`);
}

async function checkHover(browser, tile) {
    const face = Math.floor(tile.faces.length / 2);
    await lookAt(browser, centroid(tile, face));
    await browser.point(...await browser.value(windowPoint(JSON.stringify(centroid(tile, face)))));
    const cell = await browser.value(kCellText);
    const sites =
        tile.kind === 'triangles' ? tile.faces[face].map((v) => tile.sites[v]) : [tile.sites[face]];
    assert(
        cell[0] === 'Site' && sites.includes(Number(cell[1])),
        `hover shows ${cell}, not site ${sites}`);
    assert(cell.includes('Area') && cell.includes('Partner edges'), `hover shows ${cell}`);
}

// Points beside the middle of a boundary edge, inside of its face, which must name the partner.
async function checkSeam(browser, tile) {
    const pair = tile.edge_pairs[Math.floor(tile.edge_pairs.length / 2)],
          [v0, v1, w0, w1, i, j] = pair;
    const middle = [0, 1].map((k) => (tile.points[2 * v0 + k] + tile.points[2 * v1 + k]) / 2);
    const face =
        tile.faces.findIndex((f) => f.some((v, k) => v === v0 && f[(k + 1) % f.length] === v1));
    await lookAt(browser, middle);
    const inner = centroid(tile, face).map((value, k) => middle[k] + 0.1 * (value - middle[k]));
    await browser.point(...await browser.value(windowPoint(JSON.stringify(inner))));
    const text = `${v0}–${v1} ↔ ${w0}–${w1}, by (${i}, ${j})`.replace(/-/g, '−');
    const now = await browser.value(`document.querySelector('#cell dd.now')?.textContent ?? ''`);
    assert(now.startsWith(text), `the edge shows '${now}', not '${text}'`);
}

// The page follows the colour scheme that the reader prefers.
async function checkScheme(browser, address) {
    for (const value of ['dark', 'light']) {
        const features = [{name: 'prefers-color-scheme', value}];
        await browser.send('Emulation.setEmulatedMedia', {features});
        await browser.show(address);
        const theme = await browser.value('document.documentElement.dataset.theme');
        assert.strictEqual(theme, value);
    }
}

async function checkKeys(browser) {
    await browser.value(`viewer.select(null), viewer.canvas.focus()`);
    for (const key of ['.', '+', 'ArrowLeft']) {
        await browser.send(
            'Input.dispatchKeyEvent', {type: 'keyDown', key, text: key.length === 1 ? key : ''});
    }
    const status = await browser.value(`document.getElementById('status').textContent`);
    assert(/^Site \d+\. /.test(status), `the key shows '${status}'`);
}

// Returns the SVG that the button saves.
async function savedSvg(browser, folder) {
    await browser.send('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: folder});
    await browser.value(`document.getElementById('download').click()`);
    for (const end = Date.now() + kPatience; Date.now() < end;) {
        const name = fs.readdirSync(folder).find((file) => file.endsWith('.svg'));
        if (name) {
            const text = fs.readFileSync(path.join(folder, name), 'utf8');
            fs.rmSync(path.join(folder, name));
            return text;
        }
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error('no SVG was saved');
}

async function checkPage(browser, file, folder) {
    const address = `file://${path.resolve(file)}`;
    const page = fs.readFileSync(file, 'utf8');
    const tile = JSON.parse(page.match(/<script type="application\/json" id="data">([^<]*)</)[1]);
    await browser.show(address);
    const fault = await browser.value(`document.getElementById('fault').textContent`);
    assert(fault === '', fault);
    assert(await browser.value(kCountColours) >= 4, 'the picture is empty');
    await checkHover(browser, tile);
    // A box between four walls has no seam.
    if (tile.edge_pairs.length > 0) await checkSeam(browser, tile);
    await browser.value('viewer.fit()');
    const rate = await frameRate(browser);
    assert(rate >= kLeastRate, `the page draws ${rate} frames a second`);
    await browser.value('viewer.fit()');
    const svg = await savedSvg(browser, folder);
    assert(
        svg.startsWith('<svg ') && (svg.match(/Z/g) ?? []).length >= tile.faces.length,
        'the SVG lacks cells');
    await checkKeys(browser);
    await browser.show(`${address}#theme=dark&repeat=3x3&dual=1&colour=size`);
    const copies = (tile.walls ?? [0, 0]).map((wall) => wall ? 1 : 3);
    assert.deepStrictEqual(await browser.value('viewer.repeat'), copies);
    assert.strictEqual(
        await browser.value('viewer.seams.some((line) => line.name === "wall")'), Boolean(tile.walls));
    assert(
        await browser.value(`getComputedStyle(document.body).colorScheme`) === 'dark',
        'the page is not dark');
    assert(await browser.value(kCountColours) >= 4, 'the dark picture is empty');
    await checkHover(browser, tile);
    await checkScheme(browser, address);
    checkColours(await browser.value('THEMES'));
    assert.deepStrictEqual(browser.complaints(), []);
    return `${tile.faces.length} faces, ${rate} frames a second`;
}

async function main([program, ...files]) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'html_page_'));
    const browser = new Browser(program, path.join(folder, 'profile'));
    try {
        await browser.open();
        for (const file of files) {
            try {
                console.log(`${file}: ${await checkPage(browser, file, folder)}`);
            } catch (error) {
                console.log(`${file}: ${error.message}`);
                process.exitCode = 1;
            }
        }
    } finally {
        browser.process.kill();
        await new Promise((resolve) => browser.process.once('close', resolve));
        fs.rmSync(folder, {recursive: true, force: true, maxRetries: 5});
    }
}

module.exports = {Browser};
if (require.main === module) {
    main(process.argv.slice(2)).catch((fault) => {
        console.error(`html_page: ${fault}`);
        process.exitCode = 1;
    });
}
