/**
 * The time of a frame in which the picture is painted, in milliseconds. It shrinks after a slow
 * frame, because the browser draws some commands only after the script has ended.
 */
const MOST_PAINT_TIME = 9;
const LEAST_PAINT_TIME = 1;
const SLOW_FRAME = 25;
const MARGIN = 28;
/** The height of the buttons for zooming, which lie over the picture. */
const FOOT = 32;
/** The part of the picture that is painted beyond each border, so that it can be moved at once. */
const BORDER = 0.2;
const MOST_SVG_FACES = 200000;
const STEPS_OF_ZOOM = 1.3;

function element(id) {
    return document.getElementById(id);
}

/** The page: its settings, its view and its picture, which frames keep up to date. */
class Viewer {
    constructor(data) {
        this.tile = new Tile(data);
        this.canvas = element('picture');
        this.context = this.canvas.getContext('2d');
        const ofCells = ['cells', 'phase', 'orientation', 'orbit'].includes(data.colouring);
        this.mode = ofCells && this.tile.hasTriangles ? 'sides' : data.colouring;
        this.show = {seam: true, dual: false, edges: true, sites: true, domain: false};
        this.repeat = [1, 1];
        this.place = null;
        this.buffers = [0, 1].map(() => document.createElement('canvas'));
        this.shown = null;
        this.painting = null;
        this.paintTime = MOST_PAINT_TIME;
    }

    /** Starts after the controls have read their settings. */
    start() {
        this.fit();
        this.recolour();
        new ResizeObserver(() => this.resize()).observe(this.canvas);
        this.resize();
    }

    get copies() {
        const copies = [];
        for (let j = 0; j < this.repeat[1]; ++j) {
            for (let i = 0; i < this.repeat[0]; ++i) copies.push([i, j]);
        }
        return copies;
    }

    get themeName() {
        return document.documentElement.dataset.theme;
    }

    recolour() {
        this.colouring = new Colouring(this.tile, this.mode, this.themeName);
        this.seams = boundaryClasses(this.tile, this.themeName);
        this.repaint();
    }

    resize() {
        const box = this.canvas.getBoundingClientRect();
        this.ratio = window.devicePixelRatio || 1;
        const isFirst = !this.width;
        [this.width, this.height] = [Math.max(1, box.width), Math.max(1, box.height)];
        this.canvas.width = Math.round(this.width * this.ratio);
        this.canvas.height = Math.round(this.height * this.ratio);
        if (isFirst || this.isFitted) this.fit();
        this.repaint();
    }

    /** Shows all copies, with a margin. */
    fit() {
        const {tile} = this, [columns, rows] = this.repeat;
        const corners = [[0, 0], [columns - 1, 0], [0, rows - 1], [columns - 1, rows - 1]].map(
            (copy) => tile.translation(...copy));
        const least = [0, 1].map((k) => tile.low[k] + Math.min(...corners.map((c) => c[k])));
        const most = [0, 1].map((k) => tile.high[k] + Math.max(...corners.map((c) => c[k])));
        const width = Math.max(40, (this.width ?? 800) - 2 * MARGIN);
        const height = Math.max(40, (this.height ?? 600) - 2 * MARGIN - FOOT);
        const scale = Math.min(width / (most[0] - least[0]), height / (most[1] - least[1]));
        this.fittedScale = scale;
        const y = (least[1] + most[1]) / 2 - FOOT / (2 * scale);
        this.look({x: (least[0] + most[0]) / 2, y, scale});
        this.isFitted = true;
    }

    look(view) {
        const scale = Math.min(this.fittedScale * 1e6, Math.max(this.fittedScale / 50, view.scale));
        this.view = {...view, scale};
        this.isFitted = false;
        this.isStale = true;
        this.requestFrame();
    }

    /** Moves the picture by CSS pixels. */
    move(dx, dy) {
        const {x, y, scale} = this.view;
        this.look({x: x - dx / scale, y: y + dy / scale, scale});
    }

    /** Zooms by a factor; the point at (px, py) keeps its place. */
    zoom(factor, px = this.width / 2, py = this.height / 2) {
        const [x, y] = this.pointAt(px, py), scale = this.view.scale * factor;
        this.look(
            {x: x - (px - this.width / 2) / scale, y: y + (py - this.height / 2) / scale, scale});
    }

    pointAt(px, py) {
        const {x, y, scale} = this.view;
        return [x + (px - this.width / 2) / scale, y - (py - this.height / 2) / scale];
    }

    /** Returns the CSS pixels of a point of the tile. */
    pixelOf(x, y) {
        return toScreen(this.view, this.width, this.height, x, y);
    }

    scene(border) {
        // The ramp's colours are light in both themes.
        const overRamp =
            this.colouring.ramp ? {dot: THEMES.light.dot, dual: THEMES.light.dual} : {};
        const theme = {...THEMES[this.themeName], ...overRamp};
        return {
            tile: this.tile,
            colouring: this.colouring,
            seams: this.seams,
            theme,
            sideColours: theme.sides,
            show: this.show,
            copies: this.copies,
            view: this.view,
            width: Math.round(this.width * (1 + 2 * border)),
            height: Math.round(this.height * (1 + 2 * border)),
            ratio: this.ratio,
        };
    }

    /** Discards the picture that is being painted; settings have changed. */
    repaint() {
        this.painting = null;
        this.isStale = true;
        this.requestFrame();
    }

    requestFrame() {
        if (this.frame || !this.width) return;
        this.frame = requestAnimationFrame((time) => {
            this.frame = null;
            const factor = time - this.lastFrame > SLOW_FRAME ? 0.5 : 1.2;
            this.lastFrame = time;
            this.paintTime =
                Math.min(MOST_PAINT_TIME, Math.max(LEAST_PAINT_TIME, factor * this.paintTime));
            this.paint(performance.now() + this.paintTime);
            this.draw();
            if (this.painting || this.isStale) this.requestFrame();
        });
    }

    /**
     * Paints the next picture into the hidden buffer until the deadline, and shows it when ready.
     */
    paint(deadline) {
        if (!this.painting) {
            if (!this.isStale) return;
            const scene = this.scene(BORDER), buffer = this.buffers[1];
            buffer.width = Math.round(scene.width * this.ratio);
            buffer.height = Math.round(scene.height * this.ratio);
            this.painting = {scene, slices: new Painter(scene, buffer.getContext('2d')).paint()};
            this.isStale = false;
        }
        while (!this.painting.slices.next().done) {
            if (performance.now() < deadline) continue;
            // A copy of one pixel makes the browser draw now, and not all at once in the end.
            this.context.drawImage(this.buffers[1], 0, 0, 1, 1, 0, 0, 1, 1);
            return;
        }
        this.shown = this.painting.scene;
        this.buffers.reverse();
        this.painting = null;
    }

    /** Draws the last complete picture where the view has it now, and the place pointed at. */
    draw() {
        const {context, ratio} = this;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.fillStyle = THEMES[this.themeName].background;
        context.fillRect(0, 0, this.width, this.height);
        if (this.shown) {
            const {view, width, height} = this.shown, factor = this.view.scale / view.scale;
            const [x, y] = this.pixelOf(view.x, view.y);
            context.drawImage(
                this.buffers[0], x - factor * width / 2, y - factor * height / 2, factor * width,
                factor * height);
        }
        if (this.place) {
            context.lineJoin = context.lineCap = 'round';
            drawPlace(
                context, {...this.scene(0), width: this.width, height: this.height}, this.place);
        }
    }

    /** Points at the place under CSS pixels; returns whether it is another one than before. */
    pointTo(px, py) {
        const [x, y] = this.pointAt(px, py);
        return this.select(placeAt(this.tile, this.copies, x, y, EDGE_REACH / this.view.scale));
    }

    select(place) {
        const key = (p) => p && `${p.face} ${p.edge} ${p.copy}`;
        if (key(place) === key(this.place) && !this.tile.hasTriangles) return false;
        this.place = place;
        this.requestFrame();
        return true;
    }

    /** Selects a cell and moves the view so that it is seen. */
    visit(cell, edge = -1) {
        const face = this.tile.facesOfCell(cell)[0], copy = this.place?.copy ?? [0, 0];
        const shift = this.tile.translation(...copy), middle = this.tile.middle(face);
        const [x, y] = middle.map((value, k) => value + shift[k]), [px, py] = this.pixelOf(x, y);
        if (px < 0 || py < 0 || px > this.width || py > this.height) {
            this.look({x, y, scale: this.view.scale});
        }
        this.select({cell, face, edge, copy, point: middle});
    }

    svg(title, entries) {
        const scene = this.scene(0);
        if (scene.copies.length * this.tile.nFaces > MOST_SVG_FACES) return null;
        return encodeSvg(scene, title, entries);
    }
}
