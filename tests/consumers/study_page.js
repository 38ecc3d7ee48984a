// Opens pages of studies in headless Chromium; the script study_page runs it.
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const {checkPages} = require('./browser.js');

// Points at one point of each plot, whose values must appear.
async function checkValues(browser, data) {
    for (const [name, series] of Object.entries(data.points)) {
        const {label, points} = series[0], [px, py, x, y] = points[points.length - 1];
        const place = await browser.value(`(() => {
            const svg = document.querySelector('[data-picture="${name}"] svg');
            svg.scrollIntoView();
            const box = svg.getBoundingClientRect(), scale = box.width / svg.viewBox.baseVal.width;
            return [box.left + scale * ${px}, box.top + scale * ${py}];
        })()`);
        await browser.point(...place);
        await browser.until('!document.getElementById("values").hidden');
        const text = await browser.value('document.getElementById("values").textContent');
        const wanted = `${label ? `${label}: ` : ''}${x}, ${y}`;
        assert.strictEqual(text, wanted, `${name} shows another value`);
    }
}

async function checkPage(browser, file) {
    const text = fs.readFileSync(file, 'utf8');
    const data =
        JSON.parse(text.match(/<script type="application\/json" id="data">([^<]*)</)[1]);
    browser.events = [];
    await browser.send('Page.navigate', {url: `file://${path.resolve(file)}`});
    await browser.until('document.readyState === "complete" && document.querySelector("main table")');
    await checkValues(browser, data);
    const csv = await browser.saved('[data-save=csv]');
    assert.strictEqual(csv, Object.values(data.csv)[0], 'another CSV was saved');
    const hasPicture = await browser.value('Boolean(document.querySelector("section.picture"))');
    if (hasPicture)
        assert((await browser.saved('[data-save=svg]')).startsWith('<svg '), 'no SVG');
    const inks = [];
    for (const value of ['light', 'dark']) {
        await browser.send(
            'Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value}]});
        inks.push(await browser.value(
            `getComputedStyle(document.querySelector('${hasPicture ? 'svg .ink' : 'h1'}')).${
                hasPicture ? 'fill' : 'color'}`));
    }
    assert.notStrictEqual(inks[0], inks[1], 'text does not follow the scheme');
    assert.deepStrictEqual(browser.complaints(), []);
    return `${Object.keys(data.points).length} plots, ${Object.keys(data.csv).length} tables`;
}

checkPages('study_page', checkPage, process.argv.slice(2));
