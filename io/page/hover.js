/** How near to an edge the pointer points at it, in CSS pixels. */
const EDGE_REACH = 12;
/** The radius of the ring around small cells, in CSS pixels. */
const RING_RADIUS = 12;

function distanceToSegment(x, y, [x0, y0, x1, y1]) {
    const dx = x1 - x0, dy = y1 - y0, length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / length)) : 0;
    return Math.hypot(x - x0 - t * dx, y - y0 - t * dy);
}

/**
 * Returns the place under a point in length units: {cell, face, edge, copy}, or null. `edge` is the
 * corner of the nearest boundary edge of the cell within `reach`, or -1.
 */
function placeAt(tile, copies, x, y, reach) {
    for (const copy of copies) {
        const [dx, dy] = tile.translation(...copy);
        const face = tile.faceAt(x - dx, y - dy);
        if (face < 0) continue;
        const place = {cell: tile.cellOf[face], face, edge: -1, copy, point: [x - dx, y - dy]};
        let nearest = reach;
        for (const c of boundaryCorners(tile, place.cell)) {
            const distance = distanceToSegment(x - dx, y - dy, tile.edge(c));
            if (distance < nearest) [nearest, place.edge] = [distance, c];
        }
        return place;
    }
    return null;
}

function boundaryCorners(tile, cell) {
    return tile.outline(cell).filter((c) => tile.partner[c] >= 0);
}

/** Returns the values of a place as [term, value, isPointedAt]; a value of null fills the line. */
function describe(tile, place) {
    const {cell, face} = place, area = shortNumber(tile.cellArea[cell]);
    const rows = tile.hasTriangles ? describeTriangle(tile, place) : [
        ['Site', String(tile.cellSite[cell])],
        ['Sides', String(tile.sides[cell])],
    ];
    const mean = tile.area / tile.nCells;
    rows.push(['Area', area], ['Area / mean', shortNumber(tile.cellArea[cell] / mean)]);
    if (tile.densities.length > 0) rows.push(['Density', shortNumber(tile.densityOf(cell))]);
    if (!tile.hasTriangles && tile.phases.length > 0)
        rows.push(['Phase', tile.phases[tile.phaseOf(face)]]);
    if (tile.orbitClasses.length > 0) rows.push(['Orbit', String(tile.orbitOf(face))]);
    if (tile.kind === 'grains')
        rows.push(['Triangle', `${face}, ${shortNumber(tile.faceArea(face))}`]);
    const walls = new Set(tile.outline(cell).map((c) => tile.wallOf.get(c)));
    walls.delete(undefined);
    if (walls.size > 0)
        rows.push(['Walls', [...walls].map((wall) => wall.replace('wall_', '')).join(', ')]);
    const corners = boundaryCorners(tile, cell);
    const start = (c) => tile.corners[c], end = (c) => tile.corners[tile.next(c)];
    rows.push(['Partner edges', String(corners.length)]);
    for (const c of corners) {
        const d = tile.partner[c], other = tile.cellOf[tile.faceOf[d]];
        const [i, j] = tile.offset.get(c).map((k) => String(k).replace('-', '−'));
        const owner = tile.hasTriangles ? 'triangle' : 'site';
        rows.push([
            null,
            `${start(c)}–${end(c)} ↔ ${end(d)}–${start(d)}, by (${i}, ${j}), ` +
                `${owner} ${tile.cellSite[other]}`,
            c === place.edge
        ]);
    }
    return rows;
}

/** The nearest corner of a Delaunay triangle is the site pointed at. */
function describeTriangle(tile, {cell, point}) {
    const corners = [0, 1, 2].map((k) => tile.corners[tile.begin[cell] + k]);
    const distance = (v) =>
        Math.hypot(tile.points[2 * v] - point[0], tile.points[2 * v + 1] - point[1]);
    const nearest = corners.reduce((v, w) => distance(w) < distance(v) ? w : v);
    return [
        ['Site', String(tile.sites[nearest])], ['Valence', String(tile.valences[nearest])],
        ['Triangle', String(cell)], ['Its sites', corners.map((v) => tile.sites[v]).join(', ')]
    ];
}

/** Draws a ring around a cell that is too small to be seen. */
function drawRing(context, {theme}, [x, y]) {
    for (const [width, colour] of [[6, theme.casing], [3, theme.accent]]) {
        context.beginPath();
        context.arc(x, y, RING_RADIUS, 0, 2 * Math.PI);
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.stroke();
    }
}

/** Draws the outline of a place, the partners of its boundary edges, and the edge pointed at. */
function drawPlace(context, scene, place) {
    const {tile, theme} = scene, [x, y] = tile.translation(...place.copy);
    const at = (px, py) => toScreen(scene.view, scene.width, scene.height, px + x, py + y);
    const line = (corners, width, colour) => {
        context.beginPath();
        for (const c of corners) {
            const [x0, y0, x1, y1] = tile.edge(c);
            context.moveTo(...at(x0, y0));
            context.lineTo(...at(x1, y1));
        }
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.stroke();
    };
    const outline = tile.outline(place.cell);
    const partners = boundaryCorners(tile, place.cell).map((c) => tile.partner[c]);
    for (const [width, colour] of [[6, theme.casing], [3, theme.ink]]) line(outline, width, colour);
    for (const [width, colour] of [[7, theme.casing], [3.5, theme.accent]])
        line(partners, width, colour);
    if (tile.h * scene.view.scale < RING_RADIUS)
        drawRing(context, scene, at(...tile.middle(place.face)));
    if (place.edge < 0) return;
    const pair = [place.edge, tile.partner[place.edge]];
    for (const [width, colour] of [[11, theme.casing], [7, theme.accent]])
        line(pair, width, colour);
    drawTranslation(
        context, scene, pair.map((c) => {
            const [x0, y0, x1, y1] = tile.edge(c);
            return at((x0 + x1) / 2, (y0 + y1) / 2);
        }),
        tile.offset.get(place.edge));
}

/** Draws the arrow from the middle of an edge to that of its partner, labelled with the offset. */
function drawTranslation(context, {theme}, [[x0, y0], [x1, y1]], [i, j]) {
    const angle = Math.atan2(y1 - y0, x1 - x0);
    const wing = (turn) => [x1 - 14 * Math.cos(angle + turn), y1 - 14 * Math.sin(angle + turn)];
    for (const [width, colour] of [[5, theme.casing], [2, theme.accent]]) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.setLineDash([7, 6]);
        context.beginPath();
        context.moveTo(x0, y0);
        context.lineTo(x1, y1);
        context.stroke();
        context.setLineDash([]);
        context.beginPath();
        context.moveTo(...wing(0.4));
        context.lineTo(x1, y1);
        context.lineTo(...wing(-0.4));
        context.stroke();
    }
    context.font = '600 13px sans-serif';
    context.textAlign = 'center';
    context.lineWidth = 5;
    context.strokeStyle = theme.casing;
    context.fillStyle = theme.ink;
    const text = `(${i}, ${j})`.replace(/-/g, '−');
    const x = (x0 + x1) / 2, y = (y0 + y1) / 2 - 8;
    context.strokeText(text, x, y);
    context.fillText(text, x, y);
}
