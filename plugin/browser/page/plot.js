const LEFT = 40;
const RIGHT = 294;
const TOP = 16;
const BOTTOM = 98;
const MOST_POINTS = 300;

/**
 * The energy above the bound of the hexagonal lattice, or the residual where there is no bound, by
 * iteration. A coarse start counts the iterations of each of its levels from 0; the plot puts the
 * levels and the run one behind the other.
 */
export class Plot {
    constructor(svg) {
        this.svg = svg;
        this.clear();
    }

    clear() {
        this.points = [];
        this.stride = 1;
        /** The number of iterations of the levels that have ended, and the last iteration. */
        this.before = 0;
        this.last = null;
        /** Where levels begin, the first one left out. */
        this.begins = [];
        this.svg.innerHTML = '<title id="plot-title">No run yet</title>';
    }

    add(progress) {
        const {iteration, phase, residual, energyOverBound} = progress;
        this.hasBound = Number.isFinite(energyOverBound);
        // A long step reports its iteration several times.
        if (this.last && this.last.iteration === iteration && this.last.phase === phase) return;
        if (this.last && (iteration < this.last.iteration || phase !== this.last.phase)) {
            this.before += this.last.iteration + 1;
            this.begins.push(this.before + iteration);
        }
        this.last = {iteration, phase};
        const value = this.hasBound ? energyOverBound - 1 : residual;
        if (value > 0) this.end = [this.before + iteration, Math.log10(value)];
        if ((this.before + iteration) % this.stride !== 0) return;
        if (value > 0) this.points.push(this.end);
        if (this.points.length <= MOST_POINTS) return;
        this.stride *= 2;
        this.points = this.points.filter(([k]) => k % this.stride === 0);
    }

    draw() {
        const points = this.points.at(-1) === this.end ? this.points : [...this.points, this.end];
        if (points.length < 2) return;
        const name =
            this.hasBound ? 'Energy over the hexagonal bound, minus 1' : 'Largest residual';
        const first = points[0][0], last = points.at(-1)[0];
        const values = points.map(([, value]) => value);
        const low = Math.floor(Math.min(...values)), high = Math.ceil(Math.max(...values));
        const x = (k) => LEFT + (RIGHT - LEFT) * (k - first) / Math.max(1, last - first);
        const y = (value) => BOTTOM - (BOTTOM - TOP) * (value - low) / Math.max(1, high - low);
        const parts = [`<title id="plot-title">${name}, after ${last} iterations 10 to the power ${
            values.at(-1).toFixed(1)}</title>`];
        const step = Math.max(1, Math.ceil((high - low) / 4));
        for (let decade = low; decade <= high; decade += step) {
            parts.push(
                `<path class="grid" d="M${LEFT} ${y(decade)}H${RIGHT}"/>` +
                `<text x="${LEFT - 5}" y="${y(decade) + 3}" text-anchor="end">10` +
                `<tspan dy="-4" font-size="7">${`${decade}`.replace('-', '−')}</tspan></text>`);
        }
        for (const k of this.begins) {
            if (k > first && k <= last) {
                parts.push(`<path class="grid" d="M${x(k).toFixed(1)} ${TOP}V${BOTTOM}"/>`);
            }
        }
        const path = points.map(([k, value]) => `${x(k).toFixed(1)} ${y(value).toFixed(1)}`);
        parts.push(`<path class="curve" d="M${path.join('L')}"/>`);
        parts.push(`<text x="${LEFT}" y="9">${name}</text>`);
        parts.push(`<text x="${LEFT}" y="112">${first}</text>`);
        parts.push(`<text x="${RIGHT}" y="112" text-anchor="end">${last} iterations</text>`);
        this.svg.innerHTML = parts.join('');
    }
}
