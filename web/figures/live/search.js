// Chapter 1: how a search in the kd-tree finds the k nearest photons, box by box.
figures.search = {
    controls: [
        {name: 'step', label: 'boxes so far', low: 0, high: 60, step: 1, value: 6},
        {name: 'k', label: 'k', low: 1, high: 200, log: true, step: 1, value: 12},
        {name: 'x', label: 'place, x', low: 0, high: 1, value: 0.62},
        {name: 'y', label: 'place, y', low: 0, high: 1, value: 0.5},
    ],
    open(figure) {
        figure.photons = figure.rows(2, 'web_search_photons')
    },
    draw(figure, {step, k, x, y}) {
        const all = figure.rows(6, 'web_search', x, y, k), visited = all.slice(0, step)
        const {sheet} = figure
        sheet.begin({x: [0, 1], y: [0, 1], equal: true, ticks: false})
        sheet.dots(figure.photons, 'soft', 2)
        const corners = r => [[r[1], r[2]], [r[3], r[2]], [r[3], r[4]], [r[1], r[4]]]
        visited.forEach((r, i) => {
            const last = i === visited.length - 1
            if (r[0] === 2) sheet.area(corners(r), last ? '#f0b35e88' : '#f0b35e33')
            sheet.line([...corners(r), corners(r)[0]], ['line', 'blue', 'orange'][r[0]], {width: last ? 3 : 1})
        })
        const radius = visited.length ? visited.at(-1)[5] : 2, looked = visited.filter(r => r[0] === 2).length
        if (radius < 1.5) sheet.circle([x, y], radius, 'red')
        sheet.dots([[x, y]], 'red', 8)
        const what = ['is too far away: it stays closed', 'is opened', 'is a leaf: its photons are looked at'][visited.length ? visited.at(-1)[0] : 1]
        const leaves = all.filter(r => r[0] === 2).length
        return {words: visited.length
            ? `Box ${visited.length} of ${all.length} ${what}. ${looked} of the ${leaves} leaves that this search opens; ` +
              (radius < 1.5 ? `the ${k} nearest by now lie within ${rounded(radius)} m.` : `fewer than ${k} photons by now.`)
            : `The search begins at the root. ${figure.photons.length} photons; drag the place, and open box after box.`,
        step: visited.length, boxes: all.length, leaves, radius}
    },
    drag: (figure, x, y) => ({x, y}),
}
