import * as fields from './fields.js';
import {showFigures} from './figures.js';
import {mesh, readTable} from './package/index.js';
import {Plot} from './plot.js';
import {Runs} from './run.js';
import {copy, save} from './save.js';
import {Stage} from './stage.js';
import {Table} from './table.js';

const FORMATS = [
    'obj', 'glb', 'gltf', 'ply', 'svg', 'png', 'vtu', 'msh', 'inp', 'nc', 'vti', 'dxf', 'html', 'om',
    'csv', 'txt'
];
/** The formats whose files have colours. */
const COLOURED = ['obj', 'glb', 'gltf', 'ply', 'svg', 'png', 'html'];
/** Above this number of sites the tile is shown only on request. */
const MOST_SITES_AT_ONCE = 20000;
/** Between two runs while a period vector is dragged, in milliseconds. */
const DRAG_PAUSE = 60;

function element(id) {
    return document.getElementById(id);
}

/** How a run ended, by the first letter of the word for it. */
const STOPS = {
    c: 'Converged',
    i: 'Ended at the iteration limit',
    s: 'Ended at the limit of double precision',
};

/** The page: connects the form, the runs, the picture and the tile. */
class Page {
    constructor() {
        fields.fillForm();
        fields.fillSelect(element('format'), FORMATS.map((name) => [name, `.${name}`]));
        this.stage = new Stage(element('picture'), (lattice, ended) => this.dragTo(lattice, ended));
        this.plot = new Plot(element('plot'));
        this.runs = new Runs(mesh, {
            progress: (now) => this.progress(now),
            ended: (result, stopped) => this.ended(result, stopped),
            failed: (error) => this.failed(error),
        });
        this.table = new Table(readTable, {
            changed: (rows) => this.tableChanged(rows),
            failed: () => this.showCommand(),
        });
        this.chosen = 'tile';
        /** The tile in the frame: its result and its choices; and the one that is being loaded. */
        this.tileOf = this.loading = null;
        this.tileNumber = 0;
        /** The colours chosen in the frame; '' as long as nobody has chosen. */
        this.colour = '';
        /** The texts of the form at the last run. */
        this.texts = null;
        this.connect();
        fields.restore(location.hash.slice(1));
        this.run();
    }

    connect() {
        element('form').addEventListener('submit', (event) => {
            event.preventDefault();
            this.run();
        });
        element('stop').addEventListener('click', () => this.runs.stop());
        element('go-on').addEventListener('click', () => this.goOn());
        element('examples').addEventListener('change', ({target}) => {
            if (target.value === '') return;
            element('density').value = target.value;
            target.value = '';
            this.run();
        });
        for (const id of ['mesh', 'outline']) {
            element(id).addEventListener('change', () => this.chooseTile());
        }
        element('format').addEventListener('change', () => this.showCommand());
        element('form').addEventListener('input', () => this.showCommand());
        element('tile').addEventListener('load', () => this.tileLoaded());
        element('download-sites').addEventListener('click', () => this.downloadSites());
        element('show-sites').addEventListener('click', () => this.choose('sites'));
        element('show-tile').addEventListener('click', () => this.choose('tile'));
        element('download').addEventListener('click', () => this.download());
        element('copy-command')
            .addEventListener(
                'click', (event) => copy(event.target, element('command').textContent));
        element('copy-link')
            .addEventListener('click', (event) => copy(event.target, location.href));
        addEventListener('hashchange', () => {
            if (this.texts && location.hash.slice(1) === fields.hashOf(this.texts)) return;
            fields.restore(location.hash.slice(1));
            this.run();
        });
    }

    /** Starts a run of the form; a fault of the form appears at its field and changes nothing. */
    run() {
        if (this.table.isFaulty) {
            element('table').focus();
            return;
        }
        fields.clearFaults();
        this.table.fault('');
        const texts = fields.formTexts();
        let options;
        try {
            options = this.table.apply(fields.readOptions(texts));
        } catch (error) {
            fields.showError(error);
            if (this.texts === null) this.say('No result.');
            return;
        }
        this.texts = texts;
        this.table.showNote(options.lattice);
        this.keepHash();
        this.runs.start(options);
        this.begin();
    }

    /** Runs with another table, or without one. */
    tableChanged(rows) {
        if (rows > 0) element('sites').value = rows;
        this.run();
    }

    goOn() {
        this.runs.goOn();
        this.begin();
    }

    /** Shows that a run has begun. */
    begin() {
        this.last = null;
        this.plot.clear();
        this.show('sites');
        this.say('Running…');
        this.setButtons(true);
        this.showCommand();
    }

    keepHash() {
        history.replaceState(null, '', `#${fields.hashOf(this.texts)}`);
    }

    showSites(sites) {
        const {lattice, walls} = this.runs.options;
        this.stage.show(sites, lattice, walls);
    }

    progress(now) {
        this.plot.add(now);
        this.last = now;
        if (this.frame) return;
        this.frame = requestAnimationFrame(() => {
            this.frame = null;
            if (!this.runs.isRunning || !this.last) return;
            if (this.last.sites) this.showSites(this.last.sites);
            this.plot.draw();
            showFigures(this.last);
        });
    }

    ended(result, stopped) {
        this.setButtons(false);
        this.showSites(result.sites);
        this.plot.draw();
        this.showCommand();
        const energyOverBound = result.energy / result.energyBound;
        showFigures({
            ...this.last,
            ...result,
            energy: result.energy,
            energyOverBound,
            residual: result.residual,
            hexagons: result.hexagons
        });
        const n = result.sites.length / 2;
        this.say(`${stopped ? 'Stopped' : STOPS[result.stop[0]]}: ${n.toLocaleString('en')} site${
            n === 1 ? '' : 's'}.`);
        if (n <= MOST_SITES_AT_ONCE && !stopped && this.chosen === 'tile') this.show('tile');
    }

    failed(error) {
        this.setButtons(false);
        this.say('No result.');
        this.plot.clear();
        element('figures').replaceChildren();
        this.showSites(new Float64Array(0));
        this.showCommand();
        if (!this.table.concerns(error)) {
            fields.showError(error);
            return;
        }
        this.table.fault(error.message);
        element('table').focus();
    }

    setButtons(isRunning) {
        const hasResult = !isRunning && this.runs.result !== null;
        element('stop').disabled = !isRunning;
        element('go-on').disabled = !this.runs.canGoOn || isRunning;
        element('download').disabled = element('show-tile').disabled = !hasResult;
    }

    say(text) {
        if (element('status').textContent !== text) element('status').textContent = text;
    }

    /** The command that gives the files of the result, or of the run that has not ended. */
    showCommand() {
        const {isRunning, options, made} = this.runs, shown = isRunning ? options : made;
        const extension = element('format').value;
        element('command').textContent =
            shown ? fields.commandOf(shown, this.tileOptions(extension, shown), extension) : '–';
        const isGiven = shown !== null && fields.hasGivenSites(shown);
        const isChanged = this.texts && !isSame(this.texts, fields.formTexts());
        element('command-note').textContent =
            (isGiven ? `${fields.SITES_FILE} holds the sites at which the run was stopped. ` : '') +
            (shown?.files ? `${Object.keys(shown.files)} is your table; the link does not hold it. ` : '') +
            (isChanged ? 'The form has changed since this run.' : '');
        element('download-sites').hidden = !isGiven;
        element('copy-command').disabled = !shown;
    }

    /** Returns the options of a file of the result of a run. */
    tileOptions(extension, options) {
        const tile = fields.choices(), {colour} = this;
        const isShown = {
            '': false,
            cells: tile.mesh !== 'delaunay',
            density: Boolean(options.density),
            orbit: Boolean(options.symmetry),
        };
        const applies = COLOURED.includes(extension) && (isShown[colour] ?? true);
        return applies ? {...tile, colour} : tile;
    }

    /** Shows a picture, also at the end of the next runs. */
    choose(what) {
        this.chosen = what;
        this.show(what);
    }

    /** Shows the moving sites, or the tile as tile.html shows it, once it is that of the result. */
    async show(what) {
        this.shown = what;
        this.placePictures();
        const {result} = this.runs, tile = fields.choices();
        if (what !== 'tile' || !result || isSame(this.tileOf, {result, ...tile})) return;
        const bytes = await this.write('html', tile);
        // A newer run or choice shows its own tile.
        if (result !== this.runs.result || !isSame(tile, fields.choices())) return;
        if (!bytes) {
            if (this.shown === 'tile') this.show('sites');
            return;
        }
        this.loading = {result, ...tile};
        // A page without a server may look into a frame with a text, but not into one with an address.
        const number = `<meta name="number" content="${++this.tileNumber}">`;
        element('tile').srcdoc = new TextDecoder().decode(bytes) + number;
    }

    /** The tile of an older run stays hidden. */
    placePictures() {
        const isTile = this.shown === 'tile';
        const isInFrame =
            isTile && this.tileOf !== null && this.tileOf.result === this.runs.result;
        element('show-sites').setAttribute('aria-pressed', !isTile);
        element('show-tile').setAttribute('aria-pressed', isTile);
        element('stage').classList.toggle('tile', isInFrame);
        element('picture').hidden = element('stage-note').hidden = isInFrame;
        element('tile').hidden = !isInFrame;
    }

    tileLoaded() {
        const {contentDocument, contentWindow} = element('tile');
        const number = contentDocument.querySelector('meta[name="number"]')?.content;
        if (number !== `${this.tileNumber}`) return;
        this.tileOf = this.loading;
        const choice = `label:not([hidden]) > [name="mode"][value="${this.colour}"]`;
        contentDocument.querySelector(choice)?.click();
        this.placePictures();
        this.table.takeDrops(contentWindow);
        contentDocument.addEventListener('change', ({target}) => {
            if (target.name !== 'mode') return;
            this.colour = target.value;
            this.showCommand();
        });
    }

    chooseTile() {
        if (this.texts) this.keepHash();
        this.showCommand();
        if (this.shown === 'tile') this.show('tile');
    }

    /** Returns the bytes of a file of the result, or null after showing why there are none. */
    async write(extension, options) {
        const {result} = this.runs;
        fields.showFault('format', '');
        try {
            return await result.write(`tile.${extension}`, options);
        } catch (error) {
            if (result === this.runs.result) element('format-fault').textContent = error.message;
            return null;
        }
    }

    async download() {
        const extension = element('format').value;
        const bytes = await this.write(extension, this.tileOptions(extension, this.runs.made));
        if (bytes) save(`tile.${extension}`, bytes);
    }

    /** Saves the sites with which the run of the command begins. */
    downloadSites() {
        const {isRunning, options, made} = this.runs, {sites} = isRunning ? options : made;
        const row = (_, k) => `${sites[2 * k]} ${sites[2 * k + 1]}\n`;
        save(fields.SITES_FILE, Array.from({length: sites.length / 2}, row).join(''));
    }

    /** Moves the sites with the period vectors; the run follows when the hand is still. */
    dragTo(lattice, ended) {
        element('lattice').value = lattice.join(', ');
        clearTimeout(this.dragTimer);
        this.dragTimer = setTimeout(() => this.run(), ended ? 0 : DRAG_PAUSE);
    }
}

/** Whether two records have the same entries. */
function isSame(a, b) {
    return a !== null && Object.keys(b).every((key) => a[key] === b[key]);
}

/** A global, for the console and for tests. */
window.page = new Page();
