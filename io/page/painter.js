/** Below this spacing of the sites, in CSS pixels, cells are filled pixel by pixel. */
const LEAST_DRAWN_SPACING = 6;
const LEAST_DOTTED_SPACING = 9;
const FACES_A_PATH = 500;
const FACES_A_SLICE = 4000;

/** A view: the point in the middle of the picture, and CSS pixels per length unit. */
function toScreen(view, width, height, x, y) {
    return [(x - view.x) * view.scale + width / 2, (view.y - y) * view.scale + height / 2];
}

/**
 * Paints a tile and its copies. paint() is a generator that yields after each slice of work, so
 * that the page shows the last complete picture at full rate while a new one is painted.
 *
 * A scene has: tile, colouring, seams, dark, theme (its colours), show ({seam, dual, edges, sites,
 * domain}), copies ([[i, j], ...]), view, width, height (CSS pixels) and ratio (device pixels per
 * CSS pixel).
 */
class Painter {
    constructor(scene, context) {
        Object.assign(this, scene);
        this.context = context;
        this.spacing = this.tile.h * this.view.scale;
        this.visible = this.copies.map(([i, j]) => this.tile.translation(i, j))
                           .filter((shift) => this.sees(this.tile.low, this.tile.high, shift));
    }

    /** A line width that follows the size of the cells within limits, in CSS pixels. */
    lineWidth(share, least, most) {
        return Math.min(most, Math.max(least, share * this.spacing));
    }

    sees(low, high, [x, y]) {
        const [left, bottom] = this.pixel(low[0] + x, low[1] + y);
        const [right, top] = this.pixel(high[0] + x, high[1] + y);
        return right >= -4 && left <= this.width + 4 && bottom >= -4 && top <= this.height + 4;
    }

    pixel(x, y) {
        return toScreen(this.view, this.width, this.height, x, y);
    }

    * paint() {
        const {context, ratio} = this;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.fillStyle = this.theme.background;
        context.fillRect(0, 0, this.width, this.height);
        context.lineJoin = context.lineCap = 'round';
        if (this.spacing < LEAST_DRAWN_SPACING)
            yield* this.fillPixels();
        else
            yield* this.drawFaces();
        if (this.tile.kind === 'grains' && this.spacing > 1.5) yield* this.drawGrainBoundaries();
        if (this.show.dual && this.tile.hasDual && this.spacing > 1.5) yield* this.drawDual();
        if (this.show.domain) this.drawDomain();
        if (this.show.seam) yield* this.drawSeam();
        if (this.show.sites) yield* this.drawSites();
    }

    /** Fills the faces of each colour and draws their edges. */
    * drawFaces() {
        const {context, tile, colouring} = this;
        const isFine = tile.kind !== 'cells';
        context.strokeStyle = isFine ? this.theme.fineEdge : this.theme.edge;
        const width = this.show.edges ? this.lineWidth(isFine ? 0.015 : 0.03, 0.25, 1.6) : 0.7;
        for (const shift of this.visible) {
            for (let k = 0; k < colouring.colours.length; ++k) {
                context.fillStyle = colouring.colours[k];
                if (!this.show.edges) context.strokeStyle = colouring.colours[k];
                context.lineWidth = width;
                const end = colouring.start[k + 1];
                for (let at = colouring.start[k]; at < end; at += FACES_A_PATH) {
                    this.drawBatch(at, Math.min(end, at + FACES_A_PATH), shift);
                    yield;
                }
            }
        }
    }

    drawBatch(from, to, [x, y]) {
        const {context, tile, colouring, view} = this;
        const left = x - view.x, low = y - view.y, scale = view.scale;
        const halfWidth = this.width / 2, halfHeight = this.height / 2;
        let isEmpty = true;
        context.beginPath();
        for (let at = from; at < to; ++at) {
            const f = colouring.order[at], begin = tile.begin[f], end = tile.begin[f + 1];
            if (!this.seesFace(f, left, low)) continue;
            isEmpty = false;
            for (let c = begin; c < end; ++c) {
                const v = 2 * tile.corners[c];
                const px = (tile.points[v] + left) * scale + halfWidth;
                const py = halfHeight - (tile.points[v + 1] + low) * scale;
                if (c === begin)
                    context.moveTo(px, py);
                else
                    context.lineTo(px, py);
            }
            context.closePath();
        }
        if (isEmpty) return;
        context.fill();
        context.stroke();
    }

    seesFace(f, left, low) {
        const {tile, view} = this, reachX = this.width / (2 * view.scale);
        const reachY = this.height / (2 * view.scale);
        let isLeft = true, isRight = true, isBelow = true, isAbove = true;
        for (let c = tile.begin[f]; c < tile.begin[f + 1]; ++c) {
            const x = tile.points[2 * tile.corners[c]] + left;
            const y = tile.points[2 * tile.corners[c] + 1] + low;
            isLeft &&= x < -reachX;
            isRight &&= x > reachX;
            isBelow &&= y < -reachY;
            isAbove &&= y > reachY;
        }
        return !(isLeft || isRight || isBelow || isAbove);
    }

    /** Fills small cells without edges: a pixel belongs to the face that contains its centre. */
    * fillPixels() {
        const {tile, colouring, ratio} = this;
        const width = Math.round(this.width * ratio), height = Math.round(this.height * ratio);
        const image = new ImageData(width, height);
        const wordOf = (colour) => {
            const [r, g, b] = bytesOf(colour);
            return (255 << 24 | b << 16 | g << 8 | r) >>> 0;
        };
        const raster = new Raster(image, this.view, ratio);
        raster.words.fill(wordOf(this.theme.background));
        const words = colouring.colours.map(wordOf);
        for (const [x, y] of this.visible) {
            for (let k = 0; k < words.length; ++k) {
                for (let at = colouring.start[k]; at < colouring.start[k + 1]; ++at) {
                    raster.fill(tile, colouring.order[at], x, y, words[k]);
                    if (at % FACES_A_SLICE === 0) yield;
                }
            }
        }
        this.context.putImageData(image, 0, 0);
        yield;
    }

    * drawGrainBoundaries() {
        if (!this.tile.boundaries) {
            const {tile} = this, found = [];
            for (let c = 0; c < tile.corners.length; ++c) {
                const d = tile.opposite[c];
                if (d > c && tile.cellOf[tile.faceOf[d]] !== tile.cellOf[tile.faceOf[c]]) {
                    found.push(...tile.edge(c));
                }
            }
            tile.boundaries = Float64Array.from(found);
        }
        yield*
            this.drawSegments(
                this.tile.boundaries, this.theme.edge, this.lineWidth(0.045, 0.5, 2.2));
    }

    * drawDual() {
        yield*
            this.drawSegments(this.tile.dual(), this.theme.dual, this.lineWidth(0.035, 0.4, 1.6));
    }

    * drawSegments(ends, colour, width) {
        const {context} = this;
        context.strokeStyle = colour;
        context.lineWidth = width;
        for (const [x, y] of this.visible) {
            for (let from = 0; from < ends.length; from += 4 * FACES_A_PATH) {
                context.beginPath();
                const to = Math.min(ends.length, from + 4 * FACES_A_PATH);
                for (let k = from; k < to; k += 4) {
                    this.addSegment(ends[k] + x, ends[k + 1] + y, ends[k + 2] + x, ends[k + 3] + y);
                }
                context.stroke();
                yield;
            }
        }
    }

    addSegment(x0, y0, x1, y1) {
        const [px, py] = this.pixel(x0, y0), [qx, qy] = this.pixel(x1, y1);
        if (Math.max(px, qx) < 0 || Math.min(px, qx) > this.width) return;
        if (Math.max(py, qy) < 0 || Math.min(py, qy) > this.height) return;
        this.context.moveTo(px, py);
        this.context.lineTo(qx, qy);
    }

    drawDomain() {
        const {context} = this;
        context.beginPath();
        this.tile.domain().forEach(([x, y], k) => {
            const at = this.pixel(x, y);
            if (k === 0)
                context.moveTo(...at);
            else
                context.lineTo(...at);
        });
        context.closePath();
        context.lineWidth = 3;
        context.strokeStyle = this.theme.casing;
        context.stroke();
        context.lineWidth = 1.3;
        context.strokeStyle = this.theme.ink;
        context.setLineDash([6, 4]);
        context.stroke();
        context.setLineDash([]);
    }

    /**
     * Draws each class of the seam with its own dashes over a casing that frees it from the cells.
     */
    * drawSeam() {
        const width = this.lineWidth(0.1, 1.6, 4.5);
        for (const line of this.seams) {
            line.ends ??= Float64Array.from(line.corners.flatMap((c) => this.tile.edge(c)));
            yield* this.drawSegments(line.ends, this.theme.casing, width + 1.6);
        }
        for (const line of this.seams) {
            this.context.setLineDash(line.dash.map((length) => length * width));
            yield* this.drawSegments(line.ends, line.colour, width);
            this.context.setLineDash([]);
        }
    }

    /** Draws dots at the sites, and on a Delaunay tile the marks of valences. */
    * drawSites() {
        if (this.spacing < LEAST_DOTTED_SPACING) return;
        const {tile} = this;
        if (tile.hasTriangles) {
            for (let v = 0; v < tile.valences.length; ++v) this.drawValence(v);
        } else if (tile.sitePoints) {
            const dot = this.lineWidth(0.045, 0.8, 3);
            this.context.fillStyle = this.theme.dot;
            for (const [x, y] of this.visible) {
                for (let f = 0; f < tile.nFaces; ++f) {
                    const [px, py] = [tile.sitePoints[2 * f], tile.sitePoints[2 * f + 1]];
                    // The site of a cut cell lies in one of its pieces.
                    if (this.seesFace(f, x - this.view.x, y - this.view.y) &&
                        tile.contains(f, px, py)) {
                        this.addDot(px + x, py + y, dot);
                    }
                    if (f % FACES_A_SLICE === 0) yield;
                }
            }
        }
    }

    addDot(x, y, radius) {
        const [px, py] = this.pixel(x, y);
        if (px < -radius || py < -radius || px > this.width + radius || py > this.height + radius)
            return;
        this.context.beginPath();
        this.context.arc(px, py, radius, 0, 2 * Math.PI);
        this.context.fill();
    }

    drawValence(v) {
        const {tile, context} = this, valence = tile.valences[v], isRegular = valence === 6;
        const radius = isRegular ? this.lineWidth(0.045, 0.8, 3) : this.lineWidth(0.19, 2.5, 9);
        for (const [x, y] of this.visible) {
            const [px, py] = [tile.points[2 * v] + x, tile.points[2 * v + 1] + y];
            context.fillStyle = this.theme.dot;
            this.addDot(px, py, radius);
            if (isRegular) continue;
            context.fillStyle = this.sideColours[Math.min(6, Math.max(0, valence - 3))];
            this.addDot(px, py, radius - 1);
        }
    }
}

/**
 * Fills convex polygons into an image; faces that share an edge leave no pixel out and share none.
 */
class Raster {
    constructor(image, view, ratio) {
        this.width = image.width;
        this.height = image.height;
        this.words = new Uint32Array(image.data.buffer);
        this.scale = view.scale * ratio;
        this.view = view;
        this.left = new Float64Array(image.height);
        this.right = new Float64Array(image.height);
    }

    fill(tile, f, x, y, word) {
        const dx = x - this.view.x, dy = y - this.view.y;
        let top = Infinity, bottom = -Infinity;
        for (let c = tile.begin[f]; c < tile.begin[f + 1]; ++c) {
            const py = this.height / 2 - (tile.points[2 * tile.corners[c] + 1] + dy) * this.scale;
            top = Math.min(top, py);
            bottom = Math.max(bottom, py);
        }
        const first = Math.max(0, Math.ceil(top - 0.5));
        const last = Math.min(this.height, Math.ceil(bottom - 0.5));
        if (first >= last) return;
        this.left.fill(Infinity, first, last);
        this.right.fill(-Infinity, first, last);
        const end = tile.begin[f + 1];
        for (let c = tile.begin[f]; c < end; ++c) {
            const d = c + 1 === end ? tile.begin[f] : c + 1;
            this.cross(tile.points, 2 * tile.corners[c], 2 * tile.corners[d], dx, dy);
        }
        for (let row = first; row < last; ++row) {
            const from = Math.max(0, Math.ceil(this.left[row] - 0.5));
            const to = Math.min(this.width, Math.ceil(this.right[row] - 0.5));
            if (from < to) this.words.fill(word, row * this.width + from, row * this.width + to);
        }
    }

    /** Notes where an edge crosses the middles of rows. */
    cross(points, v, w, dx, dy) {
        let x0 = this.width / 2 + (points[v] + dx) * this.scale;
        let y0 = this.height / 2 - (points[v + 1] + dy) * this.scale;
        let x1 = this.width / 2 + (points[w] + dx) * this.scale;
        let y1 = this.height / 2 - (points[w + 1] + dy) * this.scale;
        // Both faces of an edge compute it from the upper end.
        if (y0 > y1) [x0, y0, x1, y1] = [x1, y1, x0, y0];
        const first = Math.max(0, Math.ceil(y0 - 0.5));
        const last = Math.min(this.height, Math.ceil(y1 - 0.5));
        for (let row = first; row < last; ++row) {
            const x = x0 + (row + 0.5 - y0) / (y1 - y0) * (x1 - x0);
            if (x < this.left[row]) this.left[row] = x;
            if (x > this.right[row]) this.right[row] = x;
        }
    }
}
