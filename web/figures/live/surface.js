// Chapter 3: Snell, Fresnel, total reflection.
figures.surface = {
    controls: [
        {name: 'angle', label: 'angle', low: 0, high: 89.5, step: 0.5, value: 50, unit: '°'},
        {name: 'index', label: 'index', low: 1, high: 2.5, step: 0.01, value: 1.5},
        {name: 'way', label: 'light comes', choices: ['from the air', 'from inside the glass'], value: 'from the air'},
    ],
    draw(figure, {angle, index, way}) {
        const inside = way.endsWith('glass'), all = figure.numbers('web_surface', index, angle, inside ? 1 : 0)
        const [tx, ty] = all.splice(-2), reflected = all.pop(), {sheet} = figure, a = (angle * Math.PI) / 180
        sheet.begin({x: [0, 2.6], y: [0, 1.1], labels: ['', '']  , ticks: false})
        // Left: the rays.
        const middle = [0.62, 0.55], scale = (sheet.box.width / 2.6) / (sheet.box.height / 1.1)
        const to = (x, y, length) => [middle[0] + x * length, middle[1] + y * length * scale]
        const corners = inside ? [[0, 0.55], [1.24, 0.55], [1.24, 1.1], [0, 1.1]] : [[0, 0], [1.24, 0], [1.24, 0.55], [0, 0.55]]
        sheet.area(corners, 'glass')
        sheet.line([[0.62, 0.02], [0.62, 1.08]], 'soft', {width: 1, dash: [4, 4]})
        sheet.line([to(-Math.sin(a), Math.cos(a), 0.6), middle], 'ink', {width: 3})
        sheet.line([middle, to(Math.sin(a), Math.cos(a), 0.6)], 'orange', {width: 0.5 + 3 * reflected})
        if (ty) sheet.line([middle, to(tx, ty, 0.6)], 'blue', {width: 0.5 + 3 * (1 - reflected)})
        sheet.text([0.03, inside ? 1.02 : 0.06], 'glass', 'soft')
        // Right: reflectance over the angle.
        const px = d => 1.4 + d / 80, py = r => 0.08 + r * 0.95
        for (const d of [0, 30, 60, 90]) {
            sheet.line([[px(d), py(0)], [px(d), py(1)]], 'line', {width: 1})
            sheet.text([px(d), 0.01], `${d}°`, 'soft', 'center')
        }
        for (const r of [0, 0.5, 1]) sheet.line([[px(0), py(r)], [px(90), py(r)]], 'line', {width: 1})
        sheet.text([px(2), py(0.93)], 'share that is reflected, 0 to 1', 'soft')
        sheet.line(all.map((r, d) => [px(d), py(r)]), 'orange')
        sheet.dots([[px(angle), py(reflected)]], 'orange', 8)
        const out = ty ? (Math.atan2(tx, -ty) * 180) / Math.PI : NaN
        const limit = (Math.asin(1 / index) * 180) / Math.PI
        return {words: ty
            ? `${rounded(100 * reflected)} % is reflected; the rest goes on at ${rounded(out)}° to the normal.` + (inside ? ` From ${rounded(limit)}° on nothing will get out.` : '')
            : `Total reflection: beyond ${rounded(limit)}° nothing gets out.`, angle, index, inside, reflected, out: ty ? out : null}
    },
}
