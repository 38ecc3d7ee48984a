const MARGIN = 46;
/** The height of the buttons above the picture. */
const TOP = 40;
const HANDLE = 7;
const REACH = 22;
/** Above this number of sites the pictures of a run leave out the images. */
const MOST_SITES_WITH_IMAGES = 5000;

/**
 * The picture of the sites: one period filled, its images around it, and the period vectors, whose
 * ends can be dragged.
 */
export class Stage {
    /**
     * @param onDrag  called with the four numbers of the lattice, and whether the drag has ended.
     */
    constructor(canvas, onDrag) {
        this.canvas = canvas;
        this.context = canvas.getContext('2d');
        this.onDrag = onDrag;
        this.lattice = [1, 0, 0, 1];
        this.walls = '';
        this.sites = new Float64Array(0);
        this.frames = 0;
        new ResizeObserver(() => this.resize()).observe(canvas);
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.request());
        this.connectPointer();
    }

    /** @param walls  the axes across which walls end the tile: '', 'x', 'y' or 'xy'. */
    show(sites, lattice, walls = '') {
        [this.sites, this.lattice, this.walls] = [sites, lattice, walls];
        if (!this.dragged) this.fit();
        this.request();
    }

    resize() {
        const box = this.canvas.getBoundingClientRect();
        this.ratio = window.devicePixelRatio || 1;
        [this.width, this.height] = [box.width, box.height];
        this.canvas.width = Math.round(box.width * this.ratio);
        this.canvas.height = Math.round(box.height * this.ratio);
        this.fit();
        this.request();
    }

    fit() {
        if (!this.width) return;
        const [ax, ay, bx, by] = this.lattice;
        const xs = [0, ax, bx, ax + bx], ys = [0, ay, by, ay + by];
        const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
        this.scale = Math.min(
            (this.width - 2 * MARGIN) / (high[0] - low[0]),
            (this.height - TOP - 2 * MARGIN) / (high[1] - low[1]));
        this.middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    }

    pixel(x, y) {
        return [
            (x - this.middle[0]) * this.scale + this.width / 2,
            (this.middle[1] - y) * this.scale + (this.height + TOP) / 2,
        ];
    }

    request() {
        if (this.frame || !this.width) return;
        this.frame = requestAnimationFrame(() => {
            this.frame = null;
            this.draw();
            ++this.frames;
        });
    }

    draw() {
        const {context, ratio} = this, style = getComputedStyle(this.canvas);
        const colour = (name) => style.getPropertyValue(`--${name}`);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.clearRect(0, 0, this.width, this.height);
        const [ax, ay, bx, by] = this.lattice;
        context.fillStyle = colour('domain');
        context.beginPath();
        for (const corner of [[0, 0], [ax, ay], [ax + bx, ay + by], [bx, by]]) {
            context.lineTo(...this.pixel(...corner));
        }
        context.fill();
        context.fillStyle = colour('image');
        for (const [i, j] of this.images()) this.drawSites(i * ax + j * bx, i * ay + j * by);
        context.fillStyle = colour('site');
        this.drawSites(0, 0);
        this.drawVector(ax, ay, 'a', colour('handle'));
        this.drawVector(bx, by, 'b', colour('handle'));
    }

    /** The translations whose copies of the period meet the picture; there is none across walls. */
    images() {
        const [ax, ay, bx, by] = this.lattice, copies = [];
        if (this.sites.length > 2 * MOST_SITES_WITH_IMAGES) return copies;
        const [columns, rows] = ['x', 'y'].map((axis) => this.walls.includes(axis) ? 0 : 2);
        for (let i = -columns; i <= columns; ++i) {
            for (let j = -rows; j <= rows; ++j) {
                const corners = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]].map(
                    ([k, l]) => this.pixel(k * ax + l * bx, k * ay + l * by));
                const meets = [this.width, this.height].every(
                    (size, k) => corners.some((p) => p[k] > 0) && corners.some((p) => p[k] < size));
                if (meets && (i !== 0 || j !== 0)) copies.push([i, j]);
            }
        }
        return copies;
    }

    drawSites(dx, dy) {
        const {context, sites, width, height} = this;
        const [ax, ay, bx, by] = this.lattice;
        const spacing = Math.sqrt(2 * Math.abs(ax * by - ay * bx) / Math.max(1, sites.length));
        const radius = Math.min(4.5, Math.max(0.6, 0.17 * spacing * this.scale));
        const [x0, y0] = this.pixel(dx, dy), isRound = radius > 1.6;
        context.beginPath();
        for (let k = 0; k < sites.length; k += 2) {
            const x = x0 + this.scale * sites[k], y = y0 - this.scale * sites[k + 1];
            if (x < -5 || y < -5 || x > width + 5 || y > height + 5) continue;
            if (isRound) {
                context.moveTo(x + radius, y);
                context.arc(x, y, radius, 0, 6.2832);
            } else {
                context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
            }
        }
        context.fill();
    }

    drawVector(x, y, name, colour) {
        const {context} = this, from = this.pixel(0, 0), to = this.pixel(x, y);
        context.strokeStyle = context.fillStyle = colour;
        context.lineWidth = 2;
        context.beginPath();
        context.moveTo(...from);
        context.lineTo(...to);
        context.stroke();
        context.beginPath();
        context.arc(...to, HANDLE, 0, 6.2832);
        context.fill();
        context.font = 'italic 15px Georgia, "DejaVu Serif", serif';
        context.fillText(name, to[0] + 11, to[1] - 9);
    }

    /** Returns 0 for the end of a, 2 for that of b, -1 elsewhere. */
    handleAt(event) {
        const box = this.canvas.getBoundingClientRect();
        const gaps = [0, 2].map((k) => {
            const [x, y] = this.pixel(this.lattice[k], this.lattice[k + 1]);
            return Math.hypot(event.clientX - box.x - x, event.clientY - box.y - y);
        });
        const nearest = gaps[0] <= gaps[1] ? 0 : 1;
        return gaps[nearest] <= REACH ? 2 * nearest : -1;
    }

    connectPointer() {
        const {canvas} = this, stage = canvas.parentElement;
        canvas.addEventListener('pointerdown', (event) => {
            const handle = this.handleAt(event);
            if (handle < 0) return;
            event.preventDefault();
            canvas.setPointerCapture(event.pointerId);
            this.dragged = {handle};
        });
        canvas.addEventListener('pointermove', (event) => {
            stage.classList.toggle(
                'over-handle', Boolean(this.dragged) || this.handleAt(event) >= 0);
            if (this.dragged) this.drag(event);
        });
        const end = () => {
            if (!this.dragged) return;
            this.dragged = null;
            this.onDrag(this.lattice, true);
            this.fit();
            this.request();
        };
        canvas.addEventListener('pointerup', end);
        canvas.addEventListener('pointercancel', end);
        // A finger on a handle drags it; elsewhere it scrolls the page.
        canvas.addEventListener('touchstart', (event) => {
            if (this.handleAt(event.touches[0]) >= 0) event.preventDefault();
        }, {passive: false});
    }

    drag(event) {
        const box = this.canvas.getBoundingClientRect();
        const x = this.middle[0] + (event.clientX - box.x - this.width / 2) / this.scale;
        const y = this.middle[1] - (event.clientY - box.y - (this.height + TOP) / 2) / this.scale;
        const old = this.lattice, lattice = [...old];
        lattice[this.dragged.handle] = Number(x.toFixed(3));
        lattice[this.dragged.handle + 1] = Number(y.toFixed(3));
        // The sites keep their coordinates along the period vectors.
        const [ax, ay, bx, by] = old, area = ax * by - ay * bx;
        const [cx, cy, dx, dy] = lattice;
        if (Math.abs(cx * dy - cy * dx) < 1e-3) return;
        this.sites = this.sites.map((value, k, all) => {
            const px = all[k - k % 2], py = all[k - k % 2 + 1];
            const u = (px * by - py * bx) / area, v = (ax * py - ay * px) / area;
            return k % 2 === 0 ? u * cx + v * dx : u * cy + v * dy;
        });
        this.lattice = lattice;
        this.onDrag(lattice, false);
        this.request();
    }
}
