'use strict';

/** The distance from the pointer at which a point shows its values, in pixels of the picture. */
const REACH = 24;
const data = JSON.parse(document.getElementById('data').textContent);
const values = document.getElementById('values');

/** Returns the mark of a plot nearest to a position, or null if none is within reach. */
function nearest(series, x, y) {
    let best = null, least = REACH;
    for (const {label, points} of series) {
        for (const [px, py, ...value] of points) {
            const distance = Math.hypot(px - x, py - y);
            if (distance >= least) continue;
            least = distance;
            best = {label, value, px, py};
        }
    }
    return best;
}

/** Draws a ring around a point, or removes it. */
function markPoint(svg, point) {
    let ring = svg.querySelector('.mark');
    if (!ring) {
        ring = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
        const shape = {class: 'mark rule', r: 7, fill: 'none', stroke: '#1c1f26', 'stroke-width': 1.5};
        for (const [name, value] of Object.entries(shape)) ring.setAttribute(name, value);
        svg.append(ring);
    }
    ring.setAttribute('visibility', point ? 'visible' : 'hidden');
    if (!point) return;
    ring.setAttribute('cx', point.px);
    ring.setAttribute('cy', point.py);
}

function connectPlot(section) {
    const series = data.points[section.dataset.picture], svg = section.querySelector('svg');
    if (!series) return;
    const show = (point, event) => {
        values.hidden = point === null;
        markPoint(svg, point);
        if (!point) return;
        const [x, y] = point.value;
        values.textContent = `${point.label ? `${point.label}: ` : ''}${x}, ${y}`;
        const right = document.documentElement.clientWidth - values.offsetWidth - 4;
        values.style.left = `${Math.min(event.clientX + 14, right)}px`;
        values.style.top = `${Math.max(event.clientY - 34, 0)}px`;
    };
    svg.addEventListener('pointermove', (event) => {
        const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
        const x = scale * (event.clientX - box.left), y = scale * (event.clientY - box.top);
        show(nearest(series, x, y), event);
    });
    svg.addEventListener('pointerleave', (event) => show(null, event));
}

function save(name, type, text) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const savers = {
    csv: (name) => save(`${name}.csv`, 'text/csv', data.csv[name]),
    svg: (name, button) => {
        const copy = button.closest('section').querySelector('svg').cloneNode(true);
        copy.querySelector('.mark')?.remove();
        save(`${name}.svg`, 'image/svg+xml', new XMLSerializer().serializeToString(copy));
    },
};

document.querySelectorAll('section.picture').forEach(connectPlot);
document.querySelectorAll('[data-save]').forEach((button) => {
    button.addEventListener('click', () => savers[button.dataset.save](button.dataset.name, button));
});
