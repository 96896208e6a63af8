// Chapter 2: the z of the source text's prose, beside the right one.
figures.misprint = {
    controls: [
        {name: 'n', label: 'exponent n', low: 1, high: 1000, log: true, value: 5},
        {name: 'z', label: 'z is', choices: ['u^(1/(n+1)), as in the code', '1 − u^(1/(n+1)), as in the prose'], value: '1 − u^(1/(n+1)), as in the prose'},
    ],
    draw(figure, {n, z}) {
        const prose = z.startsWith('1'), samples = figure.rows(6, 'web_misprint', n, 600)
        const {sheet} = figure
        sheet.begin({x: [-1.1, 1.1], y: [-0.12, 1.1], equal: true, ticks: false})
        const arc = Array.from({length: 61}, (_, i) => [Math.cos((Math.PI * i) / 60), Math.sin((Math.PI * i) / 60)])
        sheet.line(arc, 'line', {width: 1})
        sheet.line([[-1.1, 0], [1.1, 0]], 'soft', {width: 1})
        sheet.line([[0, 0], [0, 1.05]], 'soft', {width: 1, dash: [4, 4]})
        sheet.text([0.02, 1.03], 'the lobe’s axis', 'soft')
        sheet.dots(samples.map(s => (prose ? [s[2], s[3]] : [s[0], s[1]])), prose ? 'red' : 'blue', 3)
        const mean = column => samples.reduce((sum, s) => sum + s[column], 0) / samples.length
        const angle = mean(prose ? 5 : 4)
        return {words: prose
            ? `600 samples from the side: no length is 1, and on average they leave ${rounded(angle)}° from the axis; right ones ${rounded(mean(4))}°.`
            : `600 samples from the side: all of length 1 (those that look shorter point to you or away), on average ${rounded(angle)}° from the axis.`, n, prose, angle}
    },
}
