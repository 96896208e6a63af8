// Chapter 3: a prism of real glass, in three bands and in all wavelengths.
figures.prism = {
    controls: [
        {name: 'incidence', label: 'incidence', low: 20, high: 89, step: 0.1, value: 63.6, unit: '°'},
        {name: 'apex', label: 'apex', low: 20, high: 75, step: 1, value: 60, unit: '°'},
        {name: 'glass', label: 'glass', choices: ['N-SF11', 'N-BK7', 'diamond', 'water_20C'], value: 'N-SF11'},
        {name: 'light', label: 'light', choices: ['red, green, blue', 'all wavelengths'], value: 'red, green, blue'},
    ],
    open(figure) {
        figure.colours = figure.rows(4, 'web_wavelengths')
    },
    draw(figure, {incidence, apex, glass, light}) {
        const lines = 61, all = figure.rows(8, 'web_prism', glass, apex, incidence, lines), {sheet} = figure
        const bands = all.slice(0, 3), a = (apex / 2) * (Math.PI / 180)
        sheet.begin({x: [-1.3, 1.9], y: [-1.25, 0.12], equal: true, ticks: false})
        sheet.area([[0, 0], [-Math.sin(a), -Math.cos(a)], [Math.sin(a), -Math.cos(a)]], 'glass', 'soft')
        const coming = incidence * (Math.PI / 180) - a, [, ex, ey] = bands[0]
        sheet.line([[ex - 2 * Math.cos(coming), ey - 2 * Math.sin(coming)], [ex, ey]], 'ink', {width: 3})
        const rays = light.startsWith('red') ? bands : all.slice(3)
        rays.forEach(([, x0, y0, x1, y1, dx, dy, turned], i) => {
            const nm = 700 - (300 * i) / (lines - 1)
            const colour = rays === bands ? ['#e53935', '#2e9e3f', '#3f6fe8'][i] : screenColour(figure.colours[Math.round(nm) - 380].slice(0, 3).map(v => 0.6 * v))
            const out = Number.isFinite(turned) ? [[x1 + 4 * dx, y1 + 4 * dy]] : []
            sheet.line([[x0, y0], [x1, y1], ...out], colour, {width: 2})
        })
        const names = ['red', 'green', 'blue'], told = bands.map((r, i) => `${names[i]} ${Number.isFinite(r[7]) ? `${r[7].toFixed(2)}°` : 'stays inside'}`)
        const left = bands.filter(r => Number.isFinite(r[7])).length
        return {words: `Turned by: ${told.join(', ')}.` + (left === 0 ? ' The prism is black from behind.' : left < 3 ? ' Total reflection has taken the rest.' : ''),
            incidence, apex, rays: rays.length, leave: left, turned: bands.map(r => (Number.isFinite(r[7]) ? r[7] : null))}
    },
}
