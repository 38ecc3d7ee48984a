import * as fields from './fields.js';
import {Plot} from './plot.js';
import {Runs} from './run.js';
import {Stage} from './stage.js';

const FORMATS = [
    'obj', 'glb', 'gltf', 'ply', 'svg', 'png', 'vtu', 'msh', 'inp', 'nc', 'vti', 'dxf', 'html', 'om',
    'csv', 'txt'
];
/** Above this number of sites the tile is shown on request alone. */
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
        this.runs = new Runs({
            progress: (now) => this.progress(now),
            ended: (result, stopped) => this.ended(result, stopped),
            failed: (error) => this.failed(error),
        });
        this.chosen = 'tile';
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
        element('show-sites').addEventListener('click', () => this.choose('sites'));
        element('show-tile').addEventListener('click', () => this.choose('tile'));
        element('download').addEventListener('click', () => this.download());
        element('copy-command')
            .addEventListener(
                'click', (event) => copy(event.target, element('command').textContent));
        element('copy-link')
            .addEventListener('click', (event) => copy(event.target, location.href));
        addEventListener('hashchange', () => {
            if (location.hash.slice(1) === fields.hashOf()) return;
            fields.restore(location.hash.slice(1));
            this.run();
        });
    }

    /** Reads the form and starts a run; a fault of the form appears at its field. */
    run() {
        fields.clearFaults();
        let options;
        try {
            options = fields.readOptions();
        } catch (error) {
            this.failed(error);
            return;
        }
        history.replaceState(null, '', `#${fields.hashOf()}`);
        this.showCommand();
        this.begin(options);
        this.runs.start(options);
    }

    begin(options) {
        this.lattice = options.lattice;
        this.plot.clear();
        this.show('sites');
        this.say('Running…');
        this.setButtons(true);
    }

    goOn() {
        this.show('sites');
        this.say('Running…');
        this.setButtons(true);
        this.plot.clear();
        this.runs.goOn();
    }

    progress(now) {
        this.plot.add(now);
        this.last = now;
        if (this.frame) return;
        this.frame = requestAnimationFrame(() => {
            this.frame = null;
            if (!this.runs.isRunning) return;
            if (this.last.sites) this.stage.show(this.last.sites, this.lattice);
            this.plot.draw();
            this.showFigures(this.last);
        });
    }

    ended(result, stopped) {
        this.setButtons(false);
        this.stage.show(result.sites, this.lattice);
        this.plot.draw();
        const energyOverBound = result.energy / result.energyBound;
        this.showFigures({
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
        fields.showError(error);
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

    showFigures({iteration, energy, energyOverBound, residual, hexagons}) {
        const rows = [['Iterations', iteration], ['Energy', shortNumber(energy)]];
        if (Number.isFinite(energyOverBound)) {
            rows.push(
                ['Over the hexagonal bound', `${(100 * (energyOverBound - 1)).toFixed(3)} %`]);
        }
        rows.push(['Residual', shortNumber(residual)]);
        if (hexagons !== undefined) rows.push(['Hexagons', hexagons.toLocaleString('en')]);
        element('figures').replaceChildren(...rows.flatMap(([name, value]) => {
            const [term, text] = [document.createElement('dt'), document.createElement('dd')];
            [term.textContent, text.textContent] = [name, value ?? ''];
            return [term, text];
        }));
    }

    showCommand() {
        try {
            const command = fields.commandOf(fields.readOptions(), element('format').value);
            element('command').textContent = command;
        } catch {
            element('command').textContent = '–';
        }
    }

    /** Shows a picture, also at the end of the next runs. */
    choose(what) {
        this.chosen = what;
        this.show(what);
    }

    /** Shows the moving sites, or the tile as tile.html shows it. */
    async show(what) {
        const isTile = what === 'tile';
        this.shown = what;
        element('show-sites').setAttribute('aria-pressed', !isTile);
        element('show-tile').setAttribute('aria-pressed', isTile);
        element('stage').classList.toggle('tile', isTile);
        element('picture').hidden = element('stage-note').hidden = isTile;
        element('tile').hidden = !isTile;
        if (!isTile || this.tileOf === this.runs.result) return;
        const bytes = await this.write('html');
        if (!bytes) {
            if (this.shown === 'tile') this.show('sites');
            return;
        }
        URL.revokeObjectURL(this.tileAddress);
        this.tileOf = this.runs.result;
        this.tileAddress = URL.createObjectURL(new Blob([bytes], {type: 'text/html'}));
        element('tile').src = this.tileAddress;
    }

    chooseTile() {
        this.tileOf = null;
        history.replaceState(null, '', `#${fields.hashOf()}`);
        this.showCommand();
        if (this.shown === 'tile') this.show('tile');
    }

    /** Returns the bytes of a file, or null after showing why there are none. */
    async write(extension) {
        fields.showFault('format', '');
        const tile = {mesh: element('mesh').value, outline: element('outline').value};
        try {
            return await this.runs.result.write(`tile.${extension}`, tile);
        } catch (error) {
            element('format-fault').textContent = error.message;
            return null;
        }
    }

    async download() {
        const extension = element('format').value, bytes = await this.write(extension);
        if (!bytes) return;
        const link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([bytes]));
        link.download = `tile.${extension}`;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    }

    /** Moves the sites with the period vectors; the run follows when the hand is still. */
    dragTo(lattice, ended) {
        element('lattice').value = lattice.join(', ');
        clearTimeout(this.dragTimer);
        this.dragTimer = setTimeout(() => this.run(), ended ? 0 : DRAG_PAUSE);
    }
}

function shortNumber(value) {
    const text = Number(value.toPrecision(6));
    return Math.abs(text) < 1e-3 ? value.toExponential(3).replace('-', '−') : String(text);
}

/** Copies a text and says so on the button for a while. */
async function copy(button, text) {
    const label = button.textContent;
    try {
        await navigator.clipboard.writeText(text);
        button.textContent = 'Copied';
    } catch {
        button.textContent = 'Not allowed here';
    }
    setTimeout(() => {
        button.textContent = label;
    }, 1500);
}

/** A global, for the console and for tests. */
window.page = new Page();
