// Chapter 5: a disk that shrinks from pass to pass.
figures.disk = {
    controls: [
        {name: 'passes', label: 'passes', low: 1, high: 2000, log: true, step: 1, value: 40},
        {name: 'alpha', label: 'α', low: 0.3, high: 1, step: 0.01, value: 0.67},
        {name: 'radius', label: 'first radius', low: 0.02, high: 0.2, value: 0.1, unit: ' m'},
        {name: 'x', label: 'place', low: -0.1, high: 0.3, value: 0.04, unit: ' m'},
    ],
    draw(figure, {passes, alpha, radius, x}) {
        const rows = figure.rows(3, 'web_passes', passes, alpha, radius, x, 2000), {sheet} = figure
        const right = x < 0.1 ? 0.35 + 0.5 * (x + 0.5) : 0.05
        const at = i => Math.log10(i + 1)
        sheet.begin({x: [0, Math.max(at(passes - 1), 0.5)], y: [0, 1.2], labels: ['log₁₀ of the pass', 'irradiance: passes (dots), mean (line)']})
        sheet.line([[0, right], [4, right]], 'soft', {dash: [5, 4]})
        sheet.dots(rows.map((r, i) => [at(i), r[1]]), 'soft', 3)
        sheet.line(rows.map((r, i) => [at(i), r[2]]), 'blue')
        sheet.line(rows.map((r, i) => [at(i), r[0] / radius]), 'red', {width: 1.5})
        sheet.text([0.03, 1.03], 'radius, in first radii', 'red')
        const [last, , mean] = rows.at(-1)
        return {words: `After ${passes} passes: radius ${rounded(1000 * last)} mm, mean ${rounded(mean)} W/m² in place of ${rounded(right)} (the shadow's edge is ${rounded(1000 * Math.abs(0.1 - x))} mm away).`,
            passes, alpha, radius: last, mean, right}
    },
}
