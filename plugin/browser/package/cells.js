// Measures of the cells of a result in the plane: the columns of .csv files.

/** Edges shorter than this, in units of sqrt(mean area), do not count as sides. */
const shortEdge = 1e-5;

/**
 * @param mesh    the cells on the torus.
 * @param result  its sites, and what else they have.
 * @returns typed arrays with an entry for each cell; the neighbours of cell c are
 *          neighbours[neighbourBegin[c]] ... neighbours[neighbourBegin[c + 1] - 1].
 */
export function cellTable({ lattice, vertices, faceBegin, cornerVertex, cornerOffset, opposite, site }, result) {
    const n = faceBegin.length - 1, [ax, ay, bx, by] = lattice;
    const cells = {
        site, sites: result.sites, weights: result.weights, phases: result.phases, orientations: result.orientations,
        orbits: result.orbits, area: new Float64Array(n), diameter: new Float64Array(n), sides: new Int32Array(n),
        circularity: new Float64Array(n), neighbourBegin: new Int32Array(n + 1),
    };
    const corner = (c) => {
        const v = 2 * cornerVertex[c], i = cornerOffset[2 * c], j = cornerOffset[2 * c + 1];
        return [vertices[v] + i * ax + j * bx, vertices[v + 1] + i * ay + j * by];
    };
    const faceOf = new Int32Array(cornerVertex.length);
    for (let f = 0; f < n; ++f) faceOf.fill(f, faceBegin[f], faceBegin[f + 1]);
    const short = shortEdge * Math.sqrt(Math.abs(ax * by - ay * bx) / n), neighbours = [];
    for (let f = 0; f < n; ++f) {
        const begin = faceBegin[f], end = faceBegin[f + 1], [x0, y0] = corner(begin);
        let twice = 0, perimeter = 0;
        for (let c = begin; c < end; ++c) {
            const [x1, y1] = corner(c), [x2, y2] = corner(c + 1 < end ? c + 1 : begin);
            const length = Math.hypot(x2 - x1, y2 - y1);
            twice += (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0);
            perimeter += length;
            if (length <= short) continue;
            ++cells.sides[f];
            // No cell lies across a wall, or in a hole.
            if (opposite[c] >= 0) neighbours.push(site[faceOf[opposite[c]]]);
        }
        cells.area[f] = twice / 2;
        cells.diameter[f] = 2 * Math.sqrt(twice / 2 / Math.PI);
        cells.circularity[f] = Math.PI * cells.diameter[f] / perimeter;
        cells.neighbourBegin[f + 1] = neighbours.length;
    }
    return { ...cells, neighbours: Int32Array.from(neighbours) };
}
