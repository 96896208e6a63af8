// Two pictures that lie side by side in one file, over each other: a slider uncovers the right one. Needs no module.
figures.compare = {
    alone: true,
    controls: [{name: 'right', label: 'left | right', low: 0, high: 100, step: 1, value: 50, unit: ' %'}],
    async open(figure) {
        figure.image = figure.place.parentElement.querySelector('.zoom img')
        await figure.image.decode()
    },
    draw(figure, {right}) {
        const {image, canvas, sheet, place} = figure
        const parts = Number(place.dataset.parts || 2), [first, second] = (place.dataset.pair || `1 ${parts}`).split(' ').map(Number)
        const gap = Number(place.dataset.gap || 8), width = (image.naturalWidth - gap * (parts - 1)) / parts, height = image.naturalHeight
        canvas.style.aspectRatio = `${width} / ${height}`
        sheet.begin({x: [0, 1], y: [0, 1], ticks: false})
        const {pen} = sheet, wide = canvas.clientWidth, high = canvas.clientHeight, at = 1 - right / 100
        const put = (part, from, to) => {
            if (to > from) pen.drawImage(image, (part - 1) * (width + gap) + from * width, 0, (to - from) * width, height, from * wide, 0, (to - from) * wide, high)
        }
        put(first, 0, at)
        put(second, at, 1)
        sheet.line([[at, 0], [at, 1]], '#ffffff', {width: 2})
        return {words: 'Left of the line the first picture, right of it the other. Drag the line.', right}
    },
    drag: (figure, x) => ({right: Math.round(100 * (1 - x))}),
}
