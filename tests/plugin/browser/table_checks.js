// Checks of the user's own tables on the page: chosen as files, dropped, wrong ones, and removed.
const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {spawnSync} = require('child_process');

const text = (id) => `document.getElementById('${id}').textContent`;
const field = (id) => `document.getElementById('${id}').value`;

// Files with what spreadsheets of some countries and exporters put there.
const kTables = {
    'points.csv': '\ufeffid;X (mm);Y (mm)\r\n1;0,25;0,25\r\n2;0,75;0,2\r\n3;0,5;0,7\r\n4;-0,1;0,6\r\n',
    'sizes.tsv': '# grains\nGrain\tECD [um]\n1\t10,5\n2\t12\n3\t8,25\n4\t9\n5\t11\n6\t10\n',
    'cells.csv': 'site,x,y,weight,area\n0,0.2,0.3,0,0.5\n1,0.7,0.6,0.01,0.5\n',
    'plain.txt': '1\n2\n1.5\n1\n2\n',
};

// A name, a text, the fault or, where the fault is that of the command, its option.
const kWrong = [
    ['word.csv', 'x,y\n0.1,0.2\n0.5,up\n', '--input'],
    ['twins.csv', 'x,y\n0.1,0.2\n0.5,0.5\n1.1,0.2\n', '--input'],
    ['empty.csv', '', '--input'],
    ['sizes.csv', 'diameter\n1\n-2\n', '--areas'],
    ['two.csv', 'ECD,area\n1,2\n', '--areas'],
    ['volumes.csv', 'id,volume\n1,2\n', '--areas'],
    ['comma.txt', '1,5\n2,5\n',
        "comma.txt:1: '1,5' may be one number or two; choose sites, or for sizes write decimal points"],
    ['other.csv', 'a,b\n1,2\n', 'other.csv:1: no columns are called x and y, and none area or diameter; name the ' +
        'columns of the coordinates, other.csv:X,Y, or that of the sizes, area:other.csv:COLUMN or diameter:other.csv:COLUMN'],
];

const settled = 'window.page && !page.runs.isRunning && ' +
    `(page.table.contents !== null || ${text('table-fault')} !== '') && ${text('status')} !== 'Running…'`;

// Opens the page, so that no table is left from before.
async function open(browser, address) {
    await browser.send('Page.navigate', {url: 'about:blank'});
    await browser.send('Page.navigate', {url: `${address}#sites=20`});
    await browser.until(`window.page && !page.runs.isRunning && ${text('status')} !== 'Running…'`);
}

// Waits for the table that a call of act() gives to the page.
async function after(browser, act) {
    const number = await browser.value('page.table.number');
    await act();
    await browser.until(`page.table.number > ${number} && ${settled}`);
}

async function choose(browser, file) {
    const {root} = await browser.send('DOM.getDocument');
    const {nodeId} = await browser.send('DOM.querySelector', {nodeId: root.nodeId, selector: '#table-file'});
    await after(browser, () => browser.send('DOM.setFileInputFiles', {nodeId, files: [file]}));
}

// Drops files on the picture as a hand does. The picture must not change from the sites to the tile meanwhile, because a
// hand moves on over the new one, which this function does not.
async function drop(browser, ...files) {
    await browser.until('page.runs.result === null || page.tileOf?.result === page.runs.result');
    const data = {items: [], files, dragOperationsMask: 1};
    const move = (type) => browser.send('Input.dispatchDragEvent', {type, x: 300, y: 400, data});
    await move('dragEnter');
    await move('dragOver');
    await browser.until('document.body.classList.contains("dropping")');
    await after(browser, () => move('drop'));
    assert(!await browser.value('document.body.classList.contains("dropping")'));
}

async function set(browser, id, value) {
    await after(browser, () => browser.value(`(() => {
        const input = document.getElementById('${id}');
        input.value = ${JSON.stringify(value)};
        input.dispatchEvent(new Event('change', {bubbles: true}));
    })()`));
}

// The saved OBJ has the bytes of the command on the page, which reads the same table.
async function checkSaved(browser, pcvt, folder, command) {
    const shown = await browser.value(text('command'));
    assert.strictEqual(shown, command);
    for (const name of fs.readdirSync(folder).filter((file) => file.startsWith('tile.'))) fs.rmSync(path.join(folder, name));
    const {status, stderr} = spawnSync(pcvt, [...shown.split(' ').slice(1), '--quiet'], {cwd: folder, encoding: 'utf8'});
    assert.strictEqual(status, 0, stderr);
    const native = fs.readFileSync(path.join(folder, 'tile.obj'), 'utf8');
    assert(await browser.saved('#download') === native, `${command}: the OBJ differs from that of the command`);
}

async function checkTables(browser, address, pcvt, folder) {
    await open(browser, address);
    await choose(browser, path.join(folder, 'points.csv'));
    assert.strictEqual(await browser.value(text('table-note')),
        '4 sites from columns X, Y. Lengths are those of the period vectors, which are in mm as well. ' +
            '1 of them lies outside of the period and counts modulo the period vectors.');
    assert.strictEqual(await browser.value(field('sites')), '4');
    assert(await browser.value(`document.getElementById('sites').disabled`));
    await checkSaved(browser, pcvt, folder, 'pcvt mesh --input points.csv -o tile.obj');
    await drop(browser, path.join(folder, 'sizes.tsv'));
    assert.strictEqual(await browser.value(text('table-note')),
        '6 diameters from column ECD in um, one for each site. The areas of the cells are scaled to the area of the period.');
    await checkSaved(browser, pcvt, folder, 'pcvt mesh --sites 6 --areas sizes.tsv -o tile.obj');
    await set(browser, 'table', 'area:sizes.tsv:Grain');
    await checkSaved(browser, pcvt, folder, 'pcvt mesh --sites 6 --areas area:sizes.tsv:Grain -o tile.obj');
    await drop(browser, path.join(folder, 'plain.txt'));
    assert.match(await browser.value(text('table-note')), /^5 areas, without a header, one for each site/);
    // Only the positions count, and the command says so.
    await drop(browser, path.join(folder, 'cells.csv'));
    await checkSaved(browser, pcvt, folder, 'pcvt mesh --input cells.csv:x,y -o tile.obj');
    await set(browser, 'table-use', 'sizes');
    await checkSaved(browser, pcvt, folder, 'pcvt mesh --sites 2 --areas cells.csv -o tile.obj');
    await browser.value(`document.getElementById('table-remove').click()`);
    await browser.until('!page.runs.isRunning');
    assert.strictEqual(await browser.value(text('command')), 'pcvt mesh --sites 2 -o tile.obj');
}

// The line of the command for a wrong table.
function commandLine(pcvt, folder, name, option) {
    const options = option === '--input' ? [option, name] : ['--sites', '2', option, name];
    const {stderr} = spawnSync(pcvt, ['mesh', ...options, '-o', 'no.obj', '--quiet'], {cwd: folder, encoding: 'utf8'});
    return stderr.trim().replace(/^pcvt: /, '');
}

async function checkWrongTables(browser, address, pcvt, folder) {
    await open(browser, address);
    for (const [name, , fault] of kWrong) {
        const line = fault.startsWith('--') ? commandLine(pcvt, folder, name, fault) : fault;
        assert.match(line, new RegExp(`^${name}:`));
        await drop(browser, path.join(folder, name));
        assert.strictEqual(await browser.value(text('table-fault')), line);
        console.log(`table ${line}`);
        // The page does not run on without the table that it was given.
        await browser.value('page.run()');
        assert.strictEqual(await browser.value('document.activeElement.id'), 'table');
    }
    await drop(browser, path.join(folder, 'points.csv'), path.join(folder, 'cells.csv'));
    assert.strictEqual(await browser.value(text('table-fault')), '2 files; take one table');
    // The lines of a table are named when a run refuses it.
    await drop(browser, path.join(folder, 'sizes.tsv'));
    await browser.value(`document.getElementById('sites').value = 7, page.run()`);
    await browser.until(settled);
    assert.strictEqual(await browser.value(text('table-fault')),
        'sizes.tsv:8: the last of 6 areas, but there are 7 sites; give one area for each site');
}

// Calls check(browser, address, pcvt, folder) with a folder of tables.
async function withTables(use) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pcvt_tables_'));
    try {
        for (const [name, content] of [...Object.entries(kTables), ...kWrong]) {
            fs.writeFileSync(path.join(folder, name), content);
        }
        await use(folder);
    } finally {
        fs.rmSync(folder, {recursive: true});
    }
}

// The checks of the page at an address.
async function checkOwnTables(browser, address, pcvt) {
    await withTables(async (folder) => {
        await checkTables(browser, address, pcvt, folder);
        await checkWrongTables(browser, address, pcvt, folder);
    });
}

module.exports = {checkOwnTables};
