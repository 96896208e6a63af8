// Chapters 3 and 6: one drop, and why there is a bow.
figures.drop = {
    controls: [
        {name: 'b', label: 'height of the ray', low: 0, high: 0.99, step: 0.01, value: 0.86},
        {name: 'nm', label: 'wavelength', low: 400, high: 700, step: 1, value: 620, unit: ' nm'},
    ],
    open(figure) {
        figure.colours = figure.rows(4, 'web_wavelengths')
    },
    draw(figure, {b, nm}) {
        const rows = figure.rows(10, 'web_drop', nm, b), ray = rows.pop(), {sheet} = figure
        const bow = Math.max(...rows.map(r => r[8])), colour = screenColour(figure.colours[Math.round(nm) - 380].slice(0, 3).map(v => 0.7 * v))
        sheet.begin({x: [-3.4, 1.3], y: [-2.9, 1.2], equal: true, ticks: false})
        sheet.circle([0, 0], 1, 'soft', {fill: 'glass', width: 1})
        for (let i = 2; i < 100; i += 2) { // many rays leave near the bow
            const [, , , , x, y, dx, dy] = rows[i]
            sheet.line([[x, y], [x + 4 * dx, y + 4 * dy]], `${colour.slice(0, -1)} / 0.25)`, {width: 1.5})
        }
        const [x0, y0, x1, y1, x2, y2, dx, dy, angle, share] = ray
        sheet.line([[-3.4, y0], [x0, y0], [x1, y1], [x2, y2], [x2 + 4 * dx, y2 + 4 * dy]], colour, {width: 3})
        sheet.line([[-3.4, 0], [1.3, 0]], 'soft', {width: 1, dash: [4, 4]})
        return {words: `This ray comes back ${rounded(angle)}° from the way it came, and ${rounded(100 * share, 2)} % of its light with it. None of this colour comes back at more than ${bow.toFixed(1)}°: there the rays crowd, and that is the bow.`,
            b, nm, angle, bow, share}
    },
    drag: (figure, x, y) => ({b: Math.abs(y)}),
}
