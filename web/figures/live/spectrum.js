// Chapter 6: a wavelength, its colour, its index, and how often it is drawn.
figures.spectrum = {
    controls: [
        {name: 'nm', label: 'wavelength', low: 380, high: 730, step: 1, value: 589, unit: ' nm'},
        {name: 'glass', label: 'glass', choices: ['N-SF11', 'N-BK7', 'diamond', 'water_20C'], value: 'N-SF11'},
    ],
    draw(figure, {nm, glass}) {
        const colours = figure.rows(4, 'web_wavelengths'), index = figure.numbers('web_glass', glass), {sheet} = figure
        const i = Math.round(nm) - 380, [r, g, b, weight] = colours[i]
        sheet.begin({x: [380, 730], y: [-3, 9.2], labels: ['wavelength, nm', '']})
        colours.forEach((c, j) => sheet.line([[380 + j, 8], [380 + j, 9]], screenColour(c.slice(0, 3).map(v => 0.5 * v)), {width: 2}))
        for (const [channel, name] of [[0, 'red'], [1, 'green'], [2, 'blue']]) sheet.line(colours.map((c, j) => [380 + j, c[channel]]), name)
        sheet.line(colours.map((c, j) => [380 + j, 1 / c[3]]), 'soft', {dash: [5, 4]})
        sheet.line([[nm, -3], [nm, 9.2]], 'ink', {width: 1})
        sheet.text([384, 7.4], 'step 6.3 in colours; dashed: what 6.2 draws', 'soft')
        return {words: `${rounded(nm)} nm: red ${rounded(r, 2)}, green ${rounded(g, 2)}, blue ${rounded(b, 2)}; drawn with weight ${rounded(weight)}. Index of ${glass}: ${index[i].toFixed(4)}.`,
            nm, r, g, b, weight, index: index[i]}
    },
    drag: (figure, x) => ({nm: x}),
}
