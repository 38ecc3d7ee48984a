'use strict';

/**
 * The tile of the page as typed arrays, and questions about it.
 *
 * A corner is a position in the list of all faces' vertices; it is also the halfedge from its
 * vertex to that of the next corner of the face. A cell is the set of all faces of one site; for
 * Delaunay triangles each triangle is a cell.
 */
class Tile {
    constructor(data) {
        this.name = data.name;
        this.kind = data.kind;
        this.a = data.lattice[0];
        this.b = data.lattice[1];
        this.points = Float64Array.from(data.points);
        this.sitePoints = data.site_points.length > 0 ? Float64Array.from(data.site_points) : null;
        this.densities = data.densities;
        this.phases = data.phases;
        this.sitePhases = data.site_phases;
        this.poleColours = data.pole_colours;
        this.orbits = data.orbits;
        this.orbitClasses = data.orbit_classes;
        this.colourClasses = data.classes;
        this.hasTriangles = this.kind === 'triangles';
        this.storeFaces(data.faces);
        this.measureBox();
        this.groupCells(data);
        this.linkHalfedges();
        this.linkWalls(data.walls ?? [0, 0], data.wall_edges ?? []);
        this.linkPartners(data.edge_pairs);
        this.fillBins();
    }

    storeFaces(faces) {
        this.nFaces = faces.length;
        this.begin = new Int32Array(faces.length + 1);
        faces.forEach((face, f) => {
            this.begin[f + 1] = this.begin[f] + face.length;
        });
        this.corners = new Int32Array(this.begin[faces.length]);
        this.faceOf = new Int32Array(this.corners.length);
        let c = 0;
        for (let f = 0; f < faces.length; ++f) {
            for (const v of faces[f]) {
                if (!(v >= 0 && 2 * v < this.points.length)) {
                    throw new Error(`face ${f} names vertex ${v}, which does not exist`);
                }
                this.faceOf[c] = f;
                this.corners[c++] = v;
            }
        }
    }

    measureBox() {
        this.low = [Infinity, Infinity];
        this.high = [-Infinity, -Infinity];
        for (let k = 0; k < this.points.length; ++k) {
            this.low[k % 2] = Math.min(this.low[k % 2], this.points[k]);
            this.high[k % 2] = Math.max(this.high[k % 2], this.points[k]);
        }
        this.area = Math.abs(this.a[0] * this.b[1] - this.a[1] * this.b[0]);
    }

    /** Numbers the cells, sums their areas and stores their sides and sites. */
    groupCells(data) {
        const number = new Map();
        this.cellOf = new Int32Array(this.nFaces);
        this.sites = data.sites;
        this.sides = [];
        this.cellSite = [];
        for (let f = 0; f < this.nFaces; ++f) {
            const key = this.hasTriangles ? f : data.sites[f];
            if (!number.has(key)) {
                number.set(key, number.size);
                this.sides.push(this.hasTriangles ? 3 : data.sides[f]);
                this.cellSite.push(key);
            }
            this.cellOf[f] = number.get(key);
        }
        this.nCells = number.size;
        this.valences = this.hasTriangles ? data.sides : null;
        this.cellArea = new Float64Array(this.nCells);
        for (let f = 0; f < this.nFaces; ++f) this.cellArea[this.cellOf[f]] += this.faceArea(f);
        this.h = Math.sqrt(this.area / this.nCells);
    }

    faceArea(f) {
        let sum = 0;
        for (let c = this.begin[f]; c < this.begin[f + 1]; ++c) {
            const v = this.corners[c], w = this.corners[this.next(c)];
            const x0 = this.points[2 * v] - this.low[0], y0 = this.points[2 * v + 1] - this.low[1];
            const x1 = this.points[2 * w] - this.low[0], y1 = this.points[2 * w + 1] - this.low[1];
            sum += x0 * y1 - x1 * y0;
        }
        return sum / 2;
    }

    next(c) {
        const f = this.faceOf[c];
        return c + 1 === this.begin[f + 1] ? this.begin[f] : c + 1;
    }

    /** Finds the opposite corner of each corner, -1 on the boundary. */
    linkHalfedges() {
        const n = this.points.length / 2;
        this.outBegin = new Int32Array(n + 1);
        for (const v of this.corners) ++this.outBegin[v + 1];
        for (let v = 0; v < n; ++v) this.outBegin[v + 1] += this.outBegin[v];
        const next = this.outBegin.slice();
        this.outgoing = new Int32Array(this.corners.length);
        for (let c = 0; c < this.corners.length; ++c) this.outgoing[next[this.corners[c]]++] = c;
        this.opposite = new Int32Array(this.corners.length);
        for (let c = 0; c < this.corners.length; ++c) {
            this.opposite[c] = this.halfedge(this.corners[this.next(c)], this.corners[c]);
        }
    }

    /** Returns the corner of the halfedge from vertex v to vertex w, or -1. */
    halfedge(v, w) {
        for (let k = this.outBegin[v]; k < this.outBegin[v + 1]; ++k) {
            if (this.corners[this.next(this.outgoing[k])] === w) return this.outgoing[k];
        }
        return -1;
    }

    /** Stores the wall of each corner on one: `walls` tells whether those across x and y are. */
    linkWalls(walls, edges) {
        this.walls = walls;
        this.wallOf = new Map();
        for (const [v, w, wall] of edges) {
            const c = this.halfedge(v, w);
            if (c < 0 || this.opposite[c] >= 0) {
                throw new Error(`edge ${v}–${w} of ${wall} is not on the boundary`);
            }
            this.wallOf.set(c, wall);
        }
    }

    /** Links each boundary corner with its partner: position(partner) = position + offset. */
    linkPartners(pairs) {
        this.partner = new Int32Array(this.corners.length).fill(-1);
        this.offset = new Map();
        const tolerance = 1e-9 * (Math.hypot(...this.a) + Math.hypot(...this.b));
        for (const [v0, v1, w0, w1, i, j] of pairs) {
            const c = this.halfedge(v0, v1), d = this.halfedge(w1, w0);
            const [x, y] = this.translation(i, j);
            const gap = Math.max(this.gap(v0, w0, x, y), this.gap(v1, w1, x, y));
            if (c < 0 || d < 0 || !(gap <= tolerance)) {
                throw new Error(`edges ${v0}–${v1} and ${w0}–${w1} do not fit by (${i}, ${j})`);
            }
            this.partner[c] = d;
            this.partner[d] = c;
            this.offset.set(c, [i, j]);
            this.offset.set(d, [-i, -j]);
        }
        for (let c = 0; c < this.corners.length; ++c) {
            const isOnSeam = this.opposite[c] < 0 && !this.wallOf.has(c);
            if (isOnSeam === (this.partner[c] >= 0)) continue;
            const edge = `${this.corners[c]}–${this.corners[this.next(c)]}`;
            throw new Error(
                `edge ${edge} has ${this.partner[c] < 0 ? 'no' : 'a needless'} partner`);
        }
    }

    gap(v, w, x, y) {
        return Math.hypot(
            this.points[2 * w] - this.points[2 * v] - x,
            this.points[2 * w + 1] - this.points[2 * v + 1] - y);
    }

    translation(i, j) {
        return [i * this.a[0] + j * this.b[0], i * this.a[1] + j * this.b[1]];
    }

    /** Puts the faces into bins of a grid over the bounding box, about one face a bin. */
    fillBins() {
        const width = this.high[0] - this.low[0], height = this.high[1] - this.low[1];
        this.binSize = Math.sqrt(width * height / this.nFaces);
        this.columns = Math.max(1, Math.ceil(width / this.binSize));
        this.rows = Math.max(1, Math.ceil(height / this.binSize));
        this.bins = Array.from({length: this.columns * this.rows}, () => []);
        for (let f = 0; f < this.nFaces; ++f) {
            const [x0, y0, x1, y1] = this.faceBox(f);
            const right = this.column(x1), top = this.row(y1);
            for (let r = this.row(y0); r <= top; ++r) {
                for (let c = this.column(x0); c <= right; ++c)
                    this.bins[r * this.columns + c].push(f);
            }
        }
    }

    column(x) {
        return Math.min(
            this.columns - 1, Math.max(0, Math.floor((x - this.low[0]) / this.binSize)));
    }

    row(y) {
        return Math.min(this.rows - 1, Math.max(0, Math.floor((y - this.low[1]) / this.binSize)));
    }

    faceBox(f) {
        let x0 = Infinity, y0 = Infinity, x1 = -Infinity, y1 = -Infinity;
        for (let c = this.begin[f]; c < this.begin[f + 1]; ++c) {
            const x = this.points[2 * this.corners[c]], y = this.points[2 * this.corners[c] + 1];
            x0 = Math.min(x0, x);
            x1 = Math.max(x1, x);
            y0 = Math.min(y0, y);
            y1 = Math.max(y1, y);
        }
        return [x0, y0, x1, y1];
    }

    /** Returns the face that contains a point of the base copy, or -1. */
    faceAt(x, y) {
        if (x < this.low[0] || x > this.high[0] || y < this.low[1] || y > this.high[1]) return -1;
        const bin = this.bins[this.row(y) * this.columns + this.column(x)];
        return bin.find((f) => this.contains(f, x, y)) ?? -1;
    }

    contains(f, x, y) {
        let inside = false;
        for (let c = this.begin[f]; c < this.begin[f + 1]; ++c) {
            const [x0, y0, x1, y1] = this.edge(c);
            if (y0 > y !== y1 > y && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)) inside = !inside;
        }
        return inside;
    }

    /** Returns x0, y0, x1, y1 of the edge from a corner to the next one. */
    edge(c) {
        const v = 2 * this.corners[c], w = 2 * this.corners[this.next(c)];
        return [this.points[v], this.points[v + 1], this.points[w], this.points[w + 1]];
    }

    facesOfCell(cell) {
        if (!this.cellFaces) {
            this.cellFaces = Array.from({length: this.nCells}, () => []);
            for (let f = 0; f < this.nFaces; ++f) this.cellFaces[this.cellOf[f]].push(f);
        }
        return this.cellFaces[cell];
    }

    /** Returns the corners along the outline of a cell, of all of its pieces. */
    outline(cell) {
        const corners = [];
        for (const f of this.facesOfCell(cell)) {
            for (let c = this.begin[f]; c < this.begin[f + 1]; ++c) {
                const d = this.opposite[c];
                if (d < 0 || this.cellOf[this.faceOf[d]] !== cell) corners.push(c);
            }
        }
        return corners;
    }

    /** Returns the middle of the bounding box of a face. */
    middle(f) {
        const [x0, y0, x1, y1] = this.faceBox(f);
        return [(x0 + x1) / 2, (y0 + y1) / 2];
    }

    /** Returns the phase of the site of a face of cells or grains, as an index. */
    phaseOf(face) {
        return this.sitePhases[this.sites[face] % this.sitePhases.length];
    }

    /** Returns the orbit of the site of a face of cells or grains. */
    orbitOf(face) {
        return this.orbits[this.sites[face] % this.orbits.length];
    }

    /** Returns the density of a cell, or the mean at the corners of a Delaunay triangle. */
    densityOf(cell) {
        const at = (site) => this.densities[site % this.densities.length];
        if (!this.hasTriangles) return at(this.cellSite[cell]);
        let sum = 0;
        for (let c = this.begin[cell]; c < this.begin[cell + 1]; ++c) {
            sum += at(this.sites[this.corners[c]]) / 3;
        }
        return sum;
    }

    get hasDual() {
        return this.hasTriangles || this.sitePoints !== null;
    }

    /** Returns the ends x0, y0, x1, y1 of all dual edges; those across the seam are there twice. */
    dual() {
        if (this.dualEnds) return this.dualEnds;
        const centres = this.hasTriangles ? this.circumcentres() : this.sitePoints;
        const ends = [];
        for (let c = 0; c < this.corners.length; ++c) {
            const d = this.opposite[c] < 0 ? this.partner[c] : this.opposite[c];
            if (this.opposite[c] > c || this.wallOf.has(c)) continue;
            const [i, j] = this.opposite[c] < 0 ? this.offset.get(c) : [0, 0];
            const [x, y] = this.translation(i, j);
            const f = 2 * this.faceOf[c], g = 2 * this.faceOf[d];
            ends.push(centres[f], centres[f + 1], centres[g] - x, centres[g + 1] - y);
        }
        this.dualEnds = Float64Array.from(ends);
        return this.dualEnds;
    }

    circumcentres() {
        const centres = new Float64Array(2 * this.nFaces);
        for (let f = 0; f < this.nFaces; ++f) {
            const [x, y, x1, y1] = this.edge(this.begin[f]);
            const [, , x2, y2] = this.edge(this.begin[f] + 1);
            const ux = x1 - x, uy = y1 - y, vx = x2 - x, vy = y2 - y;
            const d = 2 * (ux * vy - uy * vx), u = ux * ux + uy * uy, v = vx * vx + vy * vy;
            centres[2 * f] = x + (vy * u - uy * v) / d;
            centres[2 * f + 1] = y + (ux * v - vx * u) / d;
        }
        return centres;
    }

    /** Returns lattice coordinates of a point. */
    toLattice(x, y) {
        const [ax, ay] = this.a, [bx, by] = this.b, area = ax * by - ay * bx;
        return [(x * by - y * bx) / area, (ax * y - ay * x) / area];
    }

    /**
     * Returns the corners of the fundamental domain: the parallelogram along which a box outline
     * is cut, or the one at the lattice point where it covers a whole outline best.
     */
    domain() {
        let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
        for (let v = 0; v < this.points.length; v += 2) {
            const u = this.toLattice(this.points[v], this.points[v + 1]);
            low = low.map((value, k) => Math.min(value, u[k]));
            high = high.map((value, k) => Math.max(value, u[k]));
        }
        if (Math.max(high[0] - low[0], high[1] - low[1]) > 1 + 1e-9) {
            const middle =
                this.toLattice((this.low[0] + this.high[0]) / 2, (this.low[1] + this.high[1]) / 2);
            low = middle.map((value) => Math.round(value - 0.5));
        }
        const [i, j] = low;
        return [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map((k) => this.translation(...k));
    }
}
