// page_picture.js PAGE.html OUT.png: opens a page of pcvt in headless Chromium, points at an edge of
// its seam, and saves a picture of the window.
const fs = require('fs');
const path = require('path');
const {withBrowser} = require('../../tests/consumers/browser.js');

const kEdge = 18;

async function main(page, out) {
    await withBrowser('chromium', async (browser) => {
        await browser.send(
            'Emulation.setDeviceMetricsOverride',
            {width: 1000, height: 760, deviceScaleFactor: 1, mobile: false});
        await browser.show(`file://${path.resolve(page)}#theme=light`);
        const point = await browser.value(`(() => {
            const {tile} = viewer, c = [...tile.offset.keys()][${kEdge}];
            const [x0, y0, x1, y1] = tile.edge(c), [x, y] = tile.middle(tile.faceOf[c]);
            const box = viewer.canvas.getBoundingClientRect();
            const pixel = viewer.pixelOf(0.45 * (x0 + x1) + 0.1 * x, 0.45 * (y0 + y1) + 0.1 * y);
            return [box.x + pixel[0], box.y + pixel[1]];
        })()`);
        await browser.point(...point);
        await browser.until('viewer.place && !viewer.painting && !viewer.isStale');
        await new Promise((resolve) => setTimeout(resolve, 300));
        fs.writeFileSync(out, await browser.picture());
    });
}

main(...process.argv.slice(2)).catch((fault) => {
    console.error(`page_picture: ${fault}`);
    process.exitCode = 1;
});
