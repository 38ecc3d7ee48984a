const PIXELS_A_KEY = 60;

function choiceOf(name, choices, otherwise) {
    return choices.includes(name) ? name : otherwise;
}

/**
 * Connects the controls of the page with the viewer; they take their first values from the hash.
 */
class Controls {
    constructor(viewer) {
        this.viewer = viewer;
        this.tile = viewer.tile;
        this.options = new URLSearchParams(location.hash.slice(1));
        this.fillHead();
        this.connectTheme();
        this.connectSettings();
        this.connectPointer();
        viewer.canvas.addEventListener('keydown', (event) => this.pressKey(event));
        viewer.start();
        this.showLegend();
        if (this.options.has('site')) this.find(this.options.get('site'));
    }

    fillHead() {
        const {tile} = this,
              count = (n, noun) => `${n.toLocaleString('en')} ${noun}${n === 1 ? '' : 's'}`;
        const parts = {
            cells: tile.nFaces === tile.nCells ?
                count(tile.nCells, 'cell') :
                `${count(tile.nFaces, 'piece')} of ${count(tile.nCells, 'cell')}`,
            triangles: count(tile.nFaces, 'Delaunay triangle'),
            grains: `${count(tile.nCells, 'grain')}, ${count(tile.nFaces, 'triangle')}`,
        };
        const vector = ([x, y]) => `(${shortNumber(x)}, ${shortNumber(y)})`;
        element('summary').textContent = `${parts[tile.kind]} · a = ${vector(tile.a)}, ` +
            `b = ${vector(tile.b)} · ${count(tile.offset.size / 2, 'pair')} of edges on the seam` +
            (tile.wallOf.size > 0 ? ` · ${count(tile.wallOf.size, 'edge')} on walls` : '');
        viewerLabel(tile, parts[tile.kind]);
        element('with-phases').hidden = tile.hasTriangles || tile.phases.length === 0;
        element('with-orientations').hidden = tile.hasTriangles || tile.poleColours.length === 0;
        element('with-orbits').hidden = tile.orbitClasses.length === 0;
        element('with-density').hidden = tile.densities.length === 0;
        element('with-dual').hidden = !tile.hasDual;
        element('with-sites').hidden = tile.kind === 'grains';
        if (tile.hasTriangles) element('mode-sides').textContent = 'Valence';
        element('with-cells').hidden = tile.hasTriangles;
        if (tile.kind === 'grains') element('mode-cells').textContent = 'Grains';
        element('dual-label').textContent = tile.hasTriangles ? 'Dual cells' : 'Dual triangles';
    }

    connectTheme() {
        const select = element('theme'), dark = matchMedia('(prefers-color-scheme: dark)');
        select.value = choiceOf(this.options.get('theme'), ['light', 'dark'], 'auto');
        const apply = () => {
            const automatic = dark.matches ? 'dark' : 'light';
            document.documentElement.dataset.theme =
                select.value === 'auto' ? automatic : select.value;
        };
        const change = () => {
            apply();
            this.viewer.recolour();
            this.showLegend();
        };
        apply();
        select.addEventListener('change', change);
        dark.addEventListener('change', change);
    }

    connectSettings() {
        const {viewer, options} = this;
        const modes = ['sides', 'size'];
        if (!this.tile.hasTriangles) modes.push('cells');
        if (this.tile.densities.length > 0) modes.push('density');
        if (!this.tile.hasTriangles && this.tile.phases.length > 0) modes.push('phase');
        if (!this.tile.hasTriangles && this.tile.poleColours.length > 0) modes.push('orientation');
        if (this.tile.orbitClasses.length > 0) modes.push('orbit');
        viewer.mode = choiceOf(options.get('colour'), modes, viewer.mode);
        for (const radio of document.querySelectorAll('[name=mode]')) {
            radio.checked = radio.value === viewer.mode;
            radio.addEventListener('change', () => {
                viewer.mode = radio.value;
                viewer.recolour();
                this.showLegend();
            });
        }
        for (const box of document.querySelectorAll('#layers input')) {
            if (options.has(box.name)) box.checked = options.get(box.name) === '1';
            viewer.show[box.name] = box.checked;
            box.addEventListener('change', () => {
                viewer.show[box.name] = box.checked;
                viewer.repaint();
                this.showLegend();
            });
        }
        const repeat = (options.get('repeat') ?? '').match(/^([1-5])x([1-5])$/) ?? [0, 1, 1];
        ['columns', 'rows'].forEach((id, k) => {
            for (let n = 1; n <= 5; ++n) element(id).add(new Option(n, n));
            // Copies lie side by side along the periods only.
            const hasWalls = this.tile.walls[k] === 1;
            element(id).disabled = hasWalls;
            viewer.repeat[k] = element(id).value = hasWalls ? 1 : Number(repeat[k + 1]);
            element(id).addEventListener('change', () => {
                viewer.repeat[k] = Number(element(id).value);
                viewer.select(null);
                viewer.fit();
                viewer.repaint();
            });
        });
        this.connectButtons();
    }

    connectButtons() {
        const {viewer} = this;
        const onClick = (id, action) => element(id).addEventListener('click', action);
        onClick('zoom-in', () => viewer.zoom(STEPS_OF_ZOOM));
        onClick('zoom-out', () => viewer.zoom(1 / STEPS_OF_ZOOM));
        onClick('zoom-fit', () => viewer.fit());
        onClick('download', () => this.download());
        element('find').addEventListener('submit', (event) => {
            event.preventDefault();
            this.find(element('site').value.trim());
        });
    }

    /**
     * One pointer moves the picture, two zoom it; a pointer that is not pressed points at cells.
     */
    connectPointer() {
        const {viewer} = this, {canvas} = viewer, pressed = new Map();
        const spread = () => {
            const [p, q] = [...pressed.values()];
            return Math.hypot(p.offsetX - q.offsetX, p.offsetY - q.offsetY);
        };
        canvas.addEventListener('pointerdown', (event) => {
            canvas.setPointerCapture(event.pointerId);
            pressed.set(event.pointerId, event);
            this.pointTo(event);
        });
        canvas.addEventListener('pointermove', (event) => {
            const last = pressed.get(event.pointerId);
            if (!last) {
                this.pointTo(event);
                return;
            }
            const before = pressed.size === 2 ? spread() : 0;
            pressed.set(event.pointerId, event);
            const share = 1 / pressed.size;
            viewer.move(
                share * (event.offsetX - last.offsetX), share * (event.offsetY - last.offsetY));
            if (before > 0) viewer.zoom(spread() / before, event.offsetX, event.offsetY);
        });
        for (const name of ['pointerup', 'pointercancel']) {
            canvas.addEventListener(name, (event) => pressed.delete(event.pointerId));
        }
        canvas.addEventListener('pointerleave', () => {
            if (viewer.select(null)) this.showPlace();
        });
        canvas.addEventListener('wheel', (event) => {
            event.preventDefault();
            const lines = event.deltaMode === 1 ? 30 : 1;
            viewer.zoom(Math.exp(-0.0015 * lines * event.deltaY), event.offsetX, event.offsetY);
        }, {passive: false});
    }

    pointTo(event) {
        if (this.viewer.pointTo(event.offsetX, event.offsetY)) this.showPlace();
    }

    pressKey(event) {
        const {viewer, tile} = this;
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const cell = viewer.place?.cell ?? -1, n = tile.nCells;
        const actions = {
            'ArrowLeft': () => viewer.move(PIXELS_A_KEY, 0),
            'ArrowRight': () => viewer.move(-PIXELS_A_KEY, 0),
            'ArrowUp': () => viewer.move(0, PIXELS_A_KEY),
            'ArrowDown': () => viewer.move(0, -PIXELS_A_KEY),
            '+': () => viewer.zoom(STEPS_OF_ZOOM),
            '=': () => viewer.zoom(STEPS_OF_ZOOM),
            '-': () => viewer.zoom(1 / STEPS_OF_ZOOM),
            '0': () => viewer.fit(),
            '.': () => this.visit((cell + 1) % n),
            ',': () => this.visit((Math.max(cell, 0) + n - 1) % n),
            'e': () => this.visitEdge(),
            'Escape': () => viewer.select(null) && this.showPlace(),
        };
        const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (!action) return;
        event.preventDefault();
        action();
    }

    visitEdge() {
        const {viewer, tile} = this;
        if (!viewer.place) return;
        const corners = boundaryCorners(tile, viewer.place.cell);
        if (corners.length === 0)
            this.say('This cell has no edge on the seam.');
        else
            this.visit(
                viewer.place.cell,
                corners[(corners.indexOf(viewer.place.edge) + 1) % corners.length]);
    }

    visit(cell, edge) {
        this.viewer.visit(cell, edge);
        this.showPlace();
        this.say(describe(this.tile, this.viewer.place)
                     .filter(([term, , isNow]) => term !== null || isNow)
                     .map(([term, value]) => term === null ? value : `${term} ${value}`)
                     .join('. '));
    }

    find(text) {
        const {tile} = this, site = /^\d+$/.test(text) ? Number(text) : -1;
        const face = tile.hasTriangles ?
            tile.faceOf[tile.corners.findIndex((v) => tile.sites[v] === site)] ?? -1 :
            tile.sites.indexOf(site);
        if (face < 0)
            this.say(`There is no site ${text}.`);
        else
            this.visit(tile.cellOf[face]);
        if (face < 0) element('cell').replaceChildren(term(`There is no site ${text}.`, 'hint'));
    }

    say(text) {
        element('status').textContent = text;
    }

    showPlace() {
        const {place} = this.viewer, list = element('cell');
        if (!place) {
            list.replaceChildren(term('Point at a cell.', 'hint'));
            return;
        }
        list.replaceChildren(...describe(this.tile, place).flatMap(([name, value, isNow]) => {
            const item = document.createElement('dd');
            item.textContent = value;
            if (name === null) item.className = isNow ? 'wide now' : 'wide';
            return name === null ? [item] : [term(name), item];
        }));
    }

    /** The entries of the legend besides a ramp: classes of sides, and the lines of the seam. */
    entries() {
        const {colouring, seams, show} = this.viewer, entries = [];
        for (const {colour, label, count} of colouring.entries ?? []) {
            entries.push(
                {colour, label, count: count.toLocaleString('en'), text: `${label}: ${count}`});
        }
        for (const line of show.seam ? seams : []) {
            entries.push({line, label: line.name, count: `${line.count}`, text: line.name});
        }
        return entries;
    }

    showLegend() {
        const {colouring} = this.viewer, parts = [];
        element('legend-title').textContent = colouring.title;
        if (colouring.ramp) {
            const bar = rampMark(colouring.colours, 0, 0, 100, 7);
            const ticks = colouring.ramp.map((value) => `<span>${shortNumber(value)}</span>`);
            parts.push(
                '<li class="ramp"><svg viewBox="0 0 100 7" preserveAspectRatio="none" ' +
                `height="16" aria-hidden="true">${bar}</svg>` +
                `<span class="ticks">${ticks.join('')}</span></li>`);
        }
        for (const entry of this.entries()) {
            parts.push(
                `<li><svg width="28" height="16" aria-hidden="true">${
                    legendMark(entry, 0, 0)}</svg>` +
                `<span>${entry.label}</span><span class="count">${entry.count}</span></li>`);
        }
        element('legend').innerHTML = parts.join('');
    }

    download() {
        const name = this.tile.name.replace(/\.[^.]*$/, '');
        const svg = this.viewer.svg(name, this.entries());
        if (svg === null) {
            this.say('There are too many cells for an SVG; show fewer copies.');
            element('cell').replaceChildren(term(element('status').textContent, 'hint'));
            return;
        }
        const link = document.createElement('a');
        link.href = URL.createObjectURL(new Blob([svg], {type: 'image/svg+xml'}));
        link.download = `${name}.svg`;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    }
}

function term(text, style = '') {
    const item = document.createElement('dt');
    item.textContent = text;
    item.className = style;
    return item;
}

/** Names the picture for screen readers. */
function viewerLabel(tile, contents) {
    element('picture').setAttribute('aria-label', `Periodic tile ${tile.name}: ${contents}`);
}

/** The viewer is a global of the page, for the console and for tests. */
window.addEventListener('DOMContentLoaded', () => {
    try {
        window.viewer = new Viewer(JSON.parse(element('data').textContent));
        new Controls(window.viewer);
    } catch (error) {
        element('fault').textContent =
            `This page is damaged: ${error.message}. Write it again with pcvt.`;
        element('fault').hidden = false;
    }
});
