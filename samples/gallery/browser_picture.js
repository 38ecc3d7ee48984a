// browser_picture.js PAGE OUT.png: opens the page in the folder PAGE in headless Chromium and saves a
// picture of its window.
const fs = require('fs');
const {withBrowser} = require('../../tests/consumers/browser.js');
const {withServer} = require('../../tests/plugin/browser/static_server.js');

const kHash = 'sites=400&seed=3&lattice=1,0,0.3,0.9';

async function save(address, out) {
    await withBrowser('chromium', async (browser) => {
        await browser.send(
            'Emulation.setDeviceMetricsOverride',
            {width: 1280, height: 1080, deviceScaleFactor: 1, mobile: false});
        await browser.send('Page.navigate', {url: `${address}#${kHash}`});
        const viewer = `document.getElementById('tile').contentWindow?.viewer`;
        await browser.until(`window.page && ${viewer}?.shown && !${viewer}.painting`);
        await new Promise((resolve) => setTimeout(resolve, 300));
        fs.writeFileSync(out, await browser.picture());
    });
}

function main(page, out) {
    return withServer(page, (address) => save(address, out));
}

main(...process.argv.slice(2)).catch((fault) => {
    console.error(`browser_picture: ${fault}`);
    process.exitCode = 1;
});
