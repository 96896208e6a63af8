// Chapter 2: what share of light a glossy surface sends on, as one turns.
figures.albedo = {
    controls: [
        {name: 'n', label: 'exponent n', low: 1, high: 1000, log: true, value: 20},
        {name: 'theta', label: 'angle θ', low: 0, high: 88, step: 1, value: 70, unit: '°'},
    ],
    draw(figure, {n, theta}) {
        const rows = figure.rows(3, 'web_albedo', n, theta, 3000), [, source, phong] = rows.pop()
        const {sheet} = figure
        sheet.begin({x: [0, 90], y: [0, 1.12], labels: ['angle of arrival, degrees', 'share of the flux that goes on']})
        sheet.line(rows.map(r => [r[0], r[1]]), 'orange')
        sheet.line(rows.map(r => [r[0], r[2]]), 'blue')
        sheet.line([[theta, 0], [theta, 1.12]], 'soft', {width: 1, dash: [4, 4]})
        sheet.dots([[theta, source]], 'orange', 8)
        sheet.dots([[theta, phong]], 'blue', 8)
        sheet.text([87, 0.93], '2.3: nothing is lost', 'orange', 'right')
        sheet.text([3, 0.06], '2.4: what points into the surface is lost, and the weight falls with the cosine', 'blue')
        return {words: `At θ = ${rounded(theta)}° step 2.3 sends on ${rounded(100 * source)} %, step 2.4 ${rounded(100 * phong)} %.`, n, theta, source, phong}
    },
    drag: (figure, x) => ({theta: x}),
}
