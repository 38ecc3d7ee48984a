const LEFT = 40;
const RIGHT = 294;
const TOP = 16;
const BOTTOM = 98;
const MOST_POINTS = 300;

/** The energy above the bound of the hexagonal lattice, or the residual where there is no bound. */
export class Plot {
    constructor(svg) {
        this.svg = svg;
        this.clear();
    }

    clear() {
        this.points = [];
        this.stride = 1;
        this.svg.innerHTML = '<title id="plot-title">No run yet</title>';
    }

    add(progress) {
        const {iteration, residual, energyOverBound} = progress;
        this.hasBound = Number.isFinite(energyOverBound);
        if (iteration % this.stride !== 0) return;
        const value = this.hasBound ? energyOverBound - 1 : residual;
        if (value > 0) this.points.push([iteration, Math.log10(value)]);
        if (this.points.length <= MOST_POINTS) return;
        this.stride *= 2;
        this.points = this.points.filter(([k]) => k % this.stride === 0);
    }

    draw() {
        const {points} = this;
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
        const path = points.map(([k, value]) => `${x(k).toFixed(1)} ${y(value).toFixed(1)}`);
        parts.push(`<path class="curve" d="M${path.join('L')}"/>`);
        parts.push(`<text x="${LEFT}" y="9">${name}</text>`);
        parts.push(`<text x="${LEFT}" y="112">${first}</text>`);
        parts.push(`<text x="${RIGHT}" y="112" text-anchor="end">${last} iterations</text>`);
        this.svg.innerHTML = parts.join('');
    }
}
