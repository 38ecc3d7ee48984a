/**
 * The colours of lines, cells and the background, for each theme. Those of the sides and of the
 * first four classes of the seam differ by at least 15 (CIE 1976), for readers with protanopia and
 * deuteranopia as well; tests/consumers/html_page measures it.
 */
const THEMES = {
    light: {
        background: '#ffffff',
        ink: '#1c1f26',
        edge: '#565c68',
        fineEdge: '#a9adb5',
        dual: '#30343c',
        dot: '#30343c',
        casing: '#ffffff',
        accent: '#d9187f',
        seams: ['#077974', '#812ed1', '#975944', '#0d93e2', '#799946', '#db1879'],
        sides: ['#14215c', '#255fb0', '#62b0df', '#f3efe4', '#f2a23c', '#cb4b1e', '#701518'],
    },
    dark: {
        background: '#14161b',
        ink: '#e8eaef',
        edge: '#0b0c10',
        fineEdge: '#5b6270',
        dual: '#f4f5f8',
        dot: '#d5d8df',
        casing: '#14161b',
        accent: '#ff6fb5',
        seams: ['#4dbf75', '#d440ff', '#e67ec0', '#e6d439', '#5fd0f2', '#d7b3a5'],
        sides: ['#cfeaff', '#86c4f2', '#4189cf', '#3b414e', '#c9792a', '#f0b35a', '#ffe3b0'],
    },
};

/** From small to large, each lighter than the one before; distinguishable for colour-blind eyes. */
const RAMP = ['#3a57a6', '#4086b7', '#5fb3b0', '#98cb90', '#d7e894', '#fff9d6'];
/** Of cells that differ from their neighbours; the tile says which cell has which colour. */
const CELLS = ['#93e9f4', '#f7d689', '#b9dca5', '#d5908a', '#c5aded', '#f3efe4', '#80c5bd'];
const STEPS = 32;
/** Dashes in widths of the line, so that no reader depends on the hues of the seam. */
const DASHES = [[], [4, 2.5], [0.01, 2.2], [5, 2.2, 0.01, 2.2], [8, 3], [2, 2]];

function bytesOf(hex) {
    return [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
}

function rampColour(share) {
    const place = Math.min(1, Math.max(0, share)) * (RAMP.length - 1);
    const below = Math.min(Math.floor(place), RAMP.length - 2), part = place - below;
    const from = bytesOf(RAMP[below]), to = bytesOf(RAMP[below + 1]);
    return '#' +
        from.map(
                (value, k) =>
                    Math.round(value + part * (to[k] - value)).toString(16).padStart(2, '0'))
            .join('');
}

function shortNumber(value) {
    const rounded = Number(value.toPrecision(3)), size = Math.abs(rounded);
    const isLong = size !== 0 && (size < 1e-3 || size >= 1e6);
    const text = isLong ? rounded.toExponential().replace('e+', 'e') : String(rounded);
    return text.replace(/-/g, '−');
}

function sideColour(sides, theme) {
    return THEMES[theme].sides[Math.min(6, Math.max(0, sides - 3))];
}

/**
 * A colouring of the cells: faces sorted by the class of their colour, and the legend.
 *
 * `order` lists the faces, those of class k from start[k] to start[k + 1] with colours[k].
 */
class Colouring {
    constructor(tile, mode, theme) {
        const classes = new Int32Array(tile.nFaces);
        if (mode === 'sides')
            this.bySides(tile, theme, classes);
        else if (mode === 'cells')
            this.byCells(tile, classes);
        else if (mode === 'phase')
            this.byPhase(tile, classes);
        else if (mode === 'orientation')
            this.byOrientation(tile, classes);
        else if (mode === 'orbit')
            this.byOrbit(tile, classes);
        else
            this.byValue(tile, mode, classes);
        this.start = new Int32Array(this.colours.length + 1);
        for (const k of classes) ++this.start[k + 1];
        for (let k = 0; k < this.colours.length; ++k) this.start[k + 1] += this.start[k];
        const next = this.start.slice();
        this.order = new Int32Array(tile.nFaces);
        for (let f = 0; f < tile.nFaces; ++f) this.order[next[classes[f]]++] = f;
    }

    /** One class for each number of sides; Delaunay triangles are pale, their sites have marks. */
    bySides(tile, theme, classes) {
        this.title = tile.hasTriangles ? 'Valence of the sites' : 'Sides of the cells';
        const values = tile.hasTriangles ? siteValences(tile) : tile.sides;
        const counts = new Map();
        for (const n of values) counts.set(n, (counts.get(n) ?? 0) + 1);
        const numbers = [...counts.keys()].sort((a, b) => a - b);
        this.entries = numbers.map((n) => ({
                                       colour: sideColour(n, theme),
                                       label: `${n}`,
                                       count: counts.get(n),
                                   }));
        if (tile.hasTriangles) {
            this.colours = [sideColour(6, theme)];
            return;
        }
        this.colours = this.entries.map((entry) => entry.colour);
        const classOf = new Map(numbers.map((n, k) => [n, k]));
        for (let f = 0; f < tile.nFaces; ++f) classes[f] = classOf.get(tile.sides[tile.cellOf[f]]);
    }

    /** Colours that differ between neighbours and mean nothing else. */
    byCells(tile, classes) {
        this.title = `Neighbouring ${tile.kind} differ`;
        this.colours = CELLS;
        classes.set(tile.colourClasses);
    }

    /** One class for each phase; colours repeat where there are more phases than colours. */
    byPhase(tile, classes) {
        this.title = 'Phases';
        this.colours = tile.phases.map((_, k) => CELLS[k % CELLS.length]);
        const counts = tile.phases.map(() => 0);
        for (const k of tile.sitePhases) ++counts[k];
        this.entries =
            tile.phases.map((name, k) => ({colour: this.colours[k], label: name, count: counts[k]}));
        for (let f = 0; f < tile.nFaces; ++f) classes[f] = tile.phaseOf(f);
    }

    /** The inverse pole figure along z of cubic crystals. */
    byOrientation(tile, classes) {
        this.title = 'Orientation: red 001, green 011, blue 111 along z';
        this.colours = [...new Set(tile.poleColours)];
        const classOf = new Map(this.colours.map((colour, k) => [colour, k]));
        for (let f = 0; f < tile.nFaces; ++f) {
            classes[f] = classOf.get(tile.poleColours[tile.sites[f] % tile.poleColours.length]);
        }
    }

    /** Colours that are equal in an orbit of the symmetry; neighbours of other orbits differ. */
    byOrbit(tile, classes) {
        this.title = 'Orbits of the symmetry';
        this.colours = CELLS;
        classes.set(tile.orbitClasses);
    }

    /** Classes of equal steps on a logarithmic scale, or a linear one where a value is not > 0. */
    byValue(tile, mode, classes) {
        const values = Float64Array.from(
            {length: tile.nCells},
            (_, cell) => mode === 'size' ? Math.sqrt(Math.max(tile.cellArea[cell], 0)) / tile.h :
                                           tile.densityOf(cell));
        let least = Infinity, most = -Infinity;
        for (const value of values) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
        const scale = least > 0 ? Math.log : (value) => value;
        const range = scale(most) - scale(least);
        const share = (value) => range > 1e-9 ? (scale(value) - scale(least)) / range : 1;
        this.title = mode === 'size' ? 'Size, √(area / mean)' : 'Density';
        this.colours = Array.from({length: STEPS}, (_, k) => rampColour(k / (STEPS - 1)));
        if (range > 1e-9) {
            this.ramp = [least, least > 0 ? Math.sqrt(least * most) : (least + most) / 2, most];
        } else {
            this.entries = [{colour: rampColour(1), label: shortNumber(most), count: tile.nCells}];
        }
        for (let f = 0; f < tile.nFaces; ++f) {
            classes[f] = Math.min(STEPS - 1, Math.floor(STEPS * share(values[tile.cellOf[f]])));
        }
    }
}

/** Returns the valence of each site, from one vertex of each orbit. */
function siteValences(tile) {
    const valence = new Map();
    tile.sites.forEach((site, v) => valence.set(site, tile.valences[v]));
    return [...valence.values()];
}

/** Returns the classes of the boundary's lines: the translations of the seam, and the walls. */
function boundaryClasses(tile, theme) {
    const lines = seamClasses(tile, theme).map((line) => {
        const name = `seam (${line.label.replace(/-/g, '−')})`;
        return {...line, name, count: line.corners.length / 2};
    });
    const corners = [...tile.wallOf.keys()];
    if (corners.length > 0) {
        const colour = THEMES[theme].ink;
        lines.push({name: 'wall', count: corners.length, corners, colour, dash: []});
    }
    return lines;
}

/** Returns the translation classes of the seam, each with its corners and its line. */
function seamClasses(tile, theme) {
    const classes = new Map();
    for (const [c, [i, j]] of tile.offset) {
        const negative = i < 0 || (i === 0 && j < 0);
        const key = (negative ? [-i, -j] : [i, j]).join(', ');
        if (!classes.has(key))
            classes.set(key, {label: key, length: Math.abs(i) + Math.abs(j), corners: []});
        classes.get(key).corners.push(c);
    }
    const sorted =
        [...classes.values()].sort((p, q) => p.length - q.length || (p.label < q.label ? 1 : -1));
    sorted.forEach((line, k) => {
        line.colour = THEMES[theme].seams[k % 6];
        line.dash = DASHES[k % 6];
    });
    return sorted;
}
