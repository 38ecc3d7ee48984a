// Opens each page in headless Chromium, points with the mouse at a cell and at an edge of the seam,
// presses keys, repeats the tile, and saves the SVG. Exits
// with 1 if a value on the page is wrong, if the picture is empty, or if the console has an error.
// The script html_page runs it.
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const {checkPages} = require('./browser.js');
const {checkColours} = require('./html_page_colours.js');

// The usual rate is 60 frames a second. Without a graphics processor and beside compilers it falls to
// 6, so that this limit finds pages that hang and nothing else.
const kLeastRate = 2;

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

async function checkPage(browser, file) {
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
    const svg = await browser.saved('#download');
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

checkPages('html_page', checkPage, process.argv.slice(2));
