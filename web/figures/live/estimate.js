// Chapter 1: k and radius, bias against noise, and the disk of one estimate.
figures.estimate = {
    controls: [
        {name: 'k', label: 'k', low: 3, high: 400, log: true, step: 1, value: 50},
        {name: 'radius', label: 'radius, at most', low: 0.01, high: 0.4, log: true, value: 0.4, unit: ' m'},
        {name: 'photons', label: 'photons per m²', low: 500, high: 30000, log: true, step: 1, value: 4000},
        {name: 'x', label: 'place', low: -0.45, high: 0.45, value: -0.15, unit: ' m'},
    ],
    draw(figure, {k, radius, photons, x}) {
        const all = figure.numbers('web_estimate', photons, k, radius, x, 1), [noise, found] = all.splice(-2)
        const curve = []
        for (let i = 0; i < all.length; i += 3) curve.push(all.slice(i, i + 3))
        const dots = figure.rows(2, 'web_estimate_photons', photons, 1)
        const {sheet} = figure
        // A strip of the floor, a fifth of it high, above the curve.
        sheet.begin({x: [-0.45, 0.45], y: [0, 1.3], labels: ['x, m', '']})
        const strip = sheet.box.width / 0.9 / (sheet.box.height / 1.3) // metres of the floor as high as they are wide
        const up = y => 1.05 + y * strip, half = 0.25 / strip
        sheet.dots(dots.filter(([, y]) => Math.abs(y) < half).map(([px, y]) => [px, up(y)]), 'soft', 1.5)
        sheet.circle([x, 1.05], found, 'red')
        sheet.line(curve.map(r => [r[0], r[1]]), 'soft', {dash: [5, 4]})
        sheet.line(curve.map(r => [r[0], r[2]]), 'blue')
        sheet.line([[x, 0], [x, 1.3]], 'red', {width: 1, dash: [2, 4]})
        sheet.text([-0.44, 0.06], 'irradiance: right (dashed), estimated (line)', 'soft')
        const here = curve.reduce((best, r) => (Math.abs(r[0] - x) < Math.abs(best[0] - x) ? r : best))
        return {words: `At x = ${rounded(x, 2)} m the disk has a radius of ${rounded(found, 2)} m: ${rounded(here[2])} W/m² in place of ${rounded(here[1])}. ` +
            `Noise on the slope: ${rounded(100 * noise, 2)} %. At the shadow’s edge the disk reaches over: that is bias.`,
        k, noise, radius: found, estimate: here[2], right: here[1]}
    },
    drag: (figure, x) => ({x}),
}
