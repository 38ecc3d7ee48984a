function shortNumber(value) {
    const text = Number(value.toPrecision(6));
    return Math.abs(text) < 1e-3 ? value.toExponential(3).replace('-', '−') : String(text);
}

/** Shows the figures of a run. */
export function showFigures({iteration, energy, energyOverBound, residual, hexagons}) {
    const rows = [['Iterations', iteration], ['Energy', shortNumber(energy)]];
    if (Number.isFinite(energyOverBound)) {
        rows.push(
            ['Over the hexagonal bound', `${(100 * (energyOverBound - 1)).toFixed(3)} %`]);
    }
    rows.push(['Residual', shortNumber(residual)]);
    if (hexagons !== undefined) rows.push(['Hexagons', hexagons.toLocaleString('en')]);
    document.getElementById('figures').replaceChildren(...rows.flatMap(([name, value]) => {
        const [term, text] = [document.createElement('dt'), document.createElement('dd')];
        [term.textContent, text.textContent] = [name, value ?? ''];
        return [term, text];
    }));
}
