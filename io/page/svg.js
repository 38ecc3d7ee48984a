const LEGEND_LINE = 22;
const LEGEND_MARGIN = 20;

function escapeXml(text) {
    return text.replace(/&/g, '&amp;')
        .replace(/</g, '&lt;')
        .replace(/>/g, '&gt;')
        .replace(/"/g, '&quot;');
}

/**
 * A drawing context that writes SVG: the part of the canvas' interface that Painter uses, so that
 * the file shows the picture as it is on the page.
 */
class SvgContext {
    constructor() {
        this.lines = [];
        this.dash = [];
        this.beginPath();
    }

    setTransform() {}
    setLineDash(dash) {
        this.dash = dash;
    }

    beginPath() {
        this.path = [];
        this.isFilled = false;
    }

    moveTo(x, y) {
        this.path.push(`M${this.number(x)} ${this.number(y)}`);
    }
    lineTo(x, y) {
        this.path.push(`L${this.number(x)} ${this.number(y)}`);
    }
    closePath() {
        this.path.push('Z');
    }
    number(value) {
        return String(Math.round(100 * value) / 100);
    }

    arc(x, y, radius) {
        const [px, py, r] = [x - radius, y, radius].map(this.number);
        const width = this.number(2 * radius);
        this.path.push(`M${px} ${py}a${r} ${r} 0 1 0 ${width} 0a${r} ${r} 0 1 0 -${width} 0Z`);
    }

    fillRect(x, y, width, height) {
        this.lines.push(`<rect width="${width}" height="${height}" fill="${this.fillStyle}"/>`);
    }

    /** Joins paths that follow each other with one fill, as dots do. */
    fill() {
        const head = `<path fill="${this.fillStyle}" d="`;
        const last = this.lines.at(-1);
        if (last.startsWith(head) && last.length < 50000) {
            this.lines[this.lines.length - 1] = last.slice(0, -3) + this.path.join('') + '"/>';
        } else {
            this.lines.push(`${head}${this.path.join('')}"/>`);
        }
        this.isFilled = true;
    }

    /** A path that was filled just before gets the stroke as well. */
    stroke() {
        if (this.path.length === 0) return;
        const dashes = this.dash.map(this.number).join(' ');
        const stroke =
            `stroke="${this.strokeStyle}" stroke-width="${this.number(this.lineWidth)}"` +
            (dashes ? ` stroke-dasharray="${dashes}"` : '');
        if (this.isFilled) {
            this.lines[this.lines.length - 1] = this.lines.at(-1).replace(' d=', ` ${stroke} d=`);
        } else {
            this.lines.push(`<path fill="none" ${stroke} d="${this.path.join('')}"/>`);
        }
    }
}

/** Returns the marks of a legend as SVG, in the box of 28 x 16 pixels at (x, y). */
function legendMark(entry, x, y) {
    if (entry.line) {
        const dash = entry.line.dash.map((length) => 3.2 * length).join(' ');
        return `<path d="M${x + 2} ${y + 8}h24" stroke="${entry.line.colour}" stroke-width="3.2" ` +
            `stroke-linecap="round"${dash ? ` stroke-dasharray="${dash}"` : ''}/>`;
    }
    return `<rect x="${x + 3}" y="${y + 1}" width="22" height="14" rx="3" fill="${entry.colour}" ` +
        'stroke="#7a808c" stroke-width="0.8"/>';
}

/** Returns a bar of the ramp's colours as SVG. */
function rampMark(colours, x, y, width, height) {
    const step = width / colours.length;
    return colours
        .map(
            (colour, k) => `<rect x="${x + k * step}" y="${y}" width="${step + 0.5}" ` +
                `height="${height}" fill="${colour}" shape-rendering="crispEdges"/>`)
        .join('');
}

/** Lays legend entries out in lines of at most `width` pixels; returns SVG and the height. */
function svgLegend(scene, entries, width, top) {
    const measure = document.createElement('canvas').getContext('2d');
    measure.font = '13px sans-serif';
    const marks = [];
    let x = LEGEND_MARGIN, y = top + 12;
    const text = (label, at) =>
        marks.push(`<text x="${at}" y="${y + 13}">${escapeXml(label)}</text>`);
    const {colouring} = scene;
    const place = (needed) => {
        if (x > LEGEND_MARGIN && x + needed > width - LEGEND_MARGIN) {
            x = LEGEND_MARGIN;
            y += LEGEND_LINE;
        }
    };
    text(colouring.title, x);
    x += measure.measureText(colouring.title).width + 20;
    if (colouring.ramp) {
        const [least, , most] = colouring.ramp.map(shortNumber);
        text(least, x);
        x += measure.measureText(least).width + 8;
        marks.push(rampMark(colouring.colours, x, y + 1, 160, 14));
        x += 168;
        text(most, x);
        x += measure.measureText(most).width + 20;
    }
    for (const entry of entries) {
        const length = measure.measureText(entry.text).width;
        place(length + 34);
        marks.push(legendMark(entry, x, y));
        text(entry.text, x + 34);
        x += length + 54;
    }
    return {svg: marks.join('\n'), height: y + LEGEND_LINE + 12 - top};
}

/** Returns the picture as the page shows it, with a legend beneath. */
function encodeSvg(scene, title, entries) {
    const context = new SvgContext();
    // Cells are drawn as polygons at any size.
    const painter = new Painter({...scene, ratio: 1}, context);
    painter.fillPixels = painter.drawFaces;
    for (const slice of painter.paint()) void slice;
    const legend = svgLegend(scene, entries, scene.width, scene.height);
    const height = scene.height + legend.height;
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${scene.width}" height="${height}" ` +
        `viewBox="0 0 ${scene.width} ${height}">\n<title>${escapeXml(title)}</title>\n` +
        `<rect width="${scene.width}" height="${height}" fill="${scene.theme.background}"/>\n` +
        `<svg width="${scene.width}" height="${scene.height}">\n` +
        `<g stroke-linejoin="round" stroke-linecap="round">\n${context.lines.join('\n')}\n</g>\n` +
        `</svg>\n<g font-family="sans-serif" font-size="13" fill="${scene.theme.ink}">\n` +
        `${legend.svg}\n</g>\n</svg>\n`;
}
