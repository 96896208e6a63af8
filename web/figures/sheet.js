// A sheet with axes, for figures that are drawn by a pen.

const INK = {blue: ['#14598c', '#79b8ee'], red: ['#b3261e', '#ff8a7a'], green: ['#2e7d32', '#7fd08a'], orange: ['#b26a00', '#f0b35e'],
    ink: ['#1d2227', '#dde2e6'], soft: ['#5b6570', '#9aa5af'], line: ['#d5d9dd', '#3a424a'], paper: ['#fdfdfb', '#15181b'], glass: ['#cfe6f5', '#27414f']}

class Sheet {
    constructor(canvas) {
        this.canvas = canvas
        this.pen = canvas.getContext('2d')
    }

    // x from…to and y from…to are what is seen; `equal`: a unit has the same length both ways.
    begin({x, y, equal = false, left = 46, bottom = 34, top = 8, right = 10, labels = ['', ''], ticks = true}) {
        const {canvas, pen} = this, scale = canvas.width / canvas.clientWidth
        pen.setTransform(scale, 0, 0, scale, 0, 0)
        this.dark = matchMedia('(prefers-color-scheme: dark)').matches
        const width = canvas.clientWidth, height = canvas.clientHeight
        pen.fillStyle = this.ink('paper')
        pen.fillRect(0, 0, width, height)
        if (!ticks) left = bottom = top = right = 0
        this.box = {left, top, width: width - left - right, height: height - top - bottom}
        if (equal) {
            const unit = Math.min(this.box.width / (x[1] - x[0]), this.box.height / (y[1] - y[0]))
            const wide = this.box.width / unit, high = this.box.height / unit
            x = [(x[0] + x[1] - wide) / 2, (x[0] + x[1] + wide) / 2]
            y = [(y[0] + y[1] - high) / 2, (y[0] + y[1] + high) / 2]
        }
        Object.assign(this, {x, y})
        pen.font = '13px system-ui, "DejaVu Sans", sans-serif'
        if (ticks) this.axes(labels)
    }

    ink(name) {
        return INK[name] ? INK[name][this.dark ? 1 : 0] : name
    }
    px(x) {
        return this.box.left + ((x - this.x[0]) / (this.x[1] - this.x[0])) * this.box.width
    }
    py(y) {
        return this.box.top + ((this.y[1] - y) / (this.y[1] - this.y[0])) * this.box.height
    }
    at(left, top) {
        return [this.x[0] + ((left - this.box.left) / this.box.width) * (this.x[1] - this.x[0]),
            this.y[1] - ((top - this.box.top) / this.box.height) * (this.y[1] - this.y[0])]
    }

    static steps([low, high], most) {
        const rough = (high - low) / most, ten = 10 ** Math.floor(Math.log10(rough))
        const step = [1, 2, 5, 10].find(s => s * ten >= rough) * ten, found = []
        for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push(Number((i * step).toPrecision(12)))
        return found
    }

    axes([across, up]) {
        const {pen, box} = this
        pen.strokeStyle = this.ink('line')
        pen.lineWidth = 1
        pen.fillStyle = this.ink('soft')
        pen.textAlign = 'center'
        for (const x of Sheet.steps(this.x, box.width / 70)) {
            this.stroke([[x, this.y[0]], [x, this.y[1]]])
            pen.fillText(rounded(x, 6), this.px(x), box.top + box.height + 15)
        }
        pen.textAlign = 'right'
        for (const y of Sheet.steps(this.y, box.height / 40)) {
            this.stroke([[this.x[0], y], [this.x[1], y]])
            pen.fillText(rounded(y, 6), box.left - 5, this.py(y) + 4)
        }
        pen.textAlign = 'right'
        pen.fillText(across, box.left + box.width, box.top + box.height + 30)
        this.write(up, box.left + 6, box.top + 13, 'left')
    }

    // In as many lines as it takes within the sheet; from the line at `top` on, or as low as there is room.
    write(words, left, top, align) {
        const {pen, box} = this, room = align === 'left' ? box.left + box.width - left : align === 'right' ? left - box.left : Infinity
        const lines = ['']
        for (const word of words.split(' ')) {
            const longer = `${lines.at(-1)} ${word}`.trim()
            if (lines.at(-1) && pen.measureText(longer).width > room) lines.push(word)
            else lines[lines.length - 1] = longer
        }
        const first = Math.min(top, box.top + box.height - 4 - 15 * (lines.length - 1))
        pen.textAlign = align
        lines.forEach((line, i) => pen.fillText(line, left, first + 15 * i))
    }

    stroke(points) {
        const {pen} = this
        pen.beginPath()
        points.forEach(([x, y], i) => (Number.isFinite(y) ? pen[i ? 'lineTo' : 'moveTo'](this.px(x), this.py(y)) : 0))
        pen.stroke()
    }
    clip(work) {
        const {pen, box} = this
        pen.save()
        pen.beginPath()
        pen.rect(box.left, box.top, box.width, box.height)
        pen.clip()
        work()
        pen.restore()
    }
    line(points, colour, {width = 2, dash = []} = {}) {
        this.clip(() => {
            Object.assign(this.pen, {strokeStyle: this.ink(colour), lineWidth: width})
            this.pen.setLineDash(dash)
            this.stroke(points)
        })
    }
    area(points, colour, edge) {
        this.clip(() => {
            const {pen} = this
            pen.beginPath()
            points.forEach(([x, y], i) => pen[i ? 'lineTo' : 'moveTo'](this.px(x), this.py(y)))
            pen.closePath()
            pen.fillStyle = this.ink(colour)
            pen.fill()
            if (!edge) return
            pen.strokeStyle = this.ink(edge)
            pen.lineWidth = 1
            pen.stroke()
        })
    }
    dots(points, colour, size = 2) {
        this.clip(() => {
            this.pen.fillStyle = this.ink(colour)
            for (const [x, y] of points) this.pen.fillRect(this.px(x) - size / 2, this.py(y) - size / 2, size, size)
        })
    }
    circle([x, y], radius, colour, {width = 2, fill} = {}) {
        this.clip(() => {
            const {pen} = this
            pen.beginPath()
            pen.ellipse(this.px(x), this.py(y), Math.abs(this.px(x + radius) - this.px(x)), Math.abs(this.px(x + radius) - this.px(x)), 0, 0, 2 * Math.PI)
            if (fill) {
                pen.fillStyle = this.ink(fill)
                pen.fill()
            }
            Object.assign(pen, {strokeStyle: this.ink(colour), lineWidth: width})
            pen.stroke()
        })
    }
    text([x, y], words, colour = 'ink', align = 'left') {
        this.pen.fillStyle = this.ink(colour)
        this.write(words, this.px(x), this.py(y), align)
    }
}

// Linear light as a colour of the screen.
function screenColour(rgb) {
    const code = v => Math.round(255 * (v <= 0.0031308 ? 12.92 * Math.max(v, 0) : 1.055 * Math.min(v, 1) ** (1 / 2.4) - 0.055))
    return `rgb(${rgb.map(code).join(' ')})`
}
