// Headless Chromium with one tab, over a pipe of the DevTools protocol.
const fs = require('fs');
const os = require('os');
const path = require('path');
const {spawn} = require('child_process');

const kFlags = [
    '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--hide-scrollbars', '--remote-debugging-pipe', '--window-size=1280,860'
];
const kPatience = 60000;

// A browser with one tab; messages are JSON, each ended by a NUL byte.
class Browser {
    // The profile and the files that pages save lie in the folder.
    constructor(program, folder) {
        this.folder = folder;
        // In a group of its own, so that close() reaches the processes that the browser starts.
        this.process = spawn(
            program, [...kFlags, `--user-data-dir=${path.join(folder, 'profile')}`, 'about:blank'],
            {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], detached: true});
        this.closed = new Promise((resolve) => this.process.once('close', resolve));
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
        await this.send(
            'Browser.setDownloadBehavior',
            {behavior: 'allow', downloadPath: this.folder, eventsEnabled: true});
    }

    // Ends the browser with the processes that it started.
    async close() {
        try {
            process.kill(-this.process.pid, 'SIGKILL');
        } catch (fault) {
            if (fault.code !== 'ESRCH') throw fault;
        }
        await this.closed;
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
        // A change of only the hash would not load the page.
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

    // Returns the text of the file that an element saves when it is clicked. The file is read when the
    // browser says that it is complete: its name appears earlier.
    async saved(selector) {
        const completed = () => this.events.findIndex(
            ({method, params}) =>
                method === 'Browser.downloadProgress' && params.state === 'completed');
        const started = () => this.events.findIndex(({method}) => method === 'Browser.downloadWillBegin');
        await this.value(`document.querySelector('${selector}').click()`);
        for (const end = Date.now() + kPatience; started() < 0 || completed() < 0;) {
            if (Date.now() > end) throw new Error(`${selector} saved no file`);
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
        this.events.splice(completed(), 1);
        const [{params}] = this.events.splice(started(), 1);
        const file = path.join(this.folder, params.suggestedFilename);
        const text = fs.readFileSync(file, 'utf8');
        fs.rmSync(file);
        return text;
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

// Calls use(browser) with a new browser, whose folder is removed at the end.
async function withBrowser(program, use) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pcvt_browser_'));
    const browser = new Browser(program, folder);
    try {
        await browser.open();
        await use(browser);
    } finally {
        await browser.close();
        fs.rmSync(folder, {recursive: true, force: true, maxRetries: 5});
    }
}

// Opens every file by checkPage(browser, file) and prints its result or why it failed; the process
// exits with 1 after a failure.
async function checkPages(name, checkPage, [program, ...files]) {
    try {
        await withBrowser(program, async (browser) => {
            for (const file of files) {
                try {
                    console.log(`${file}: ${await checkPage(browser, file)}`);
                } catch (error) {
                    console.log(`${file}: ${error.message}`);
                    process.exitCode = 1;
                }
            }
        });
    } catch (fault) {
        console.error(`${name}: ${fault}`);
        process.exitCode = 1;
    }
}

module.exports = {checkPages, withBrowser};
