// Live figures: a figure in the notes that has `live=NAME` is opened when it is scrolled to, and drawn anew when something
// is moved. What it shows is computed by the module; its own file (NAME.js) says what can be moved, and draws.
//
// figures.NAME = {
//     controls: [{name, label, low, high, value, step, log, unit}      a slider; `log`: its middle is the geometric mean
//                {name, label, choices: ['…'], value}],                one of several
//     alone: true,          it needs no module, and takes its picture's place
//     scene: 'box.yaml',    the picture is one of the preview, of this scene; without it, a sheet to draw on
//     async open(figure),   once; may be left out
//     draw(figure, values), gives {words, …numbers}: what is said below the picture, and what a test reads
//     drag(figure, x, y),   a finger on the sheet, in its units; gives {name: value, …} of controls. May be left out
// }
const figures = {}

const rounded = (number, digits = 3) => (Number.isFinite(number) ? String(Number(number.toPrecision(digits))) : '–')

// ---- a sheet with axes ----

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

// open and draw of a figure in which one follows photons bounce by bounce; `settings` as for lab.set.
const followPhotons = (count, settings) => ({
    open({lab}) {
        lab.set({photons: count, paths: count, view: 'paths', colour: 'photon', ...settings})
        lab.trace()
        lab.show()
    },
    draw({lab}, {photon, bounce}) {
        lab.set({'paths.path': photon, 'paths.bounce': bounce})
        lab.draw()
        return {words: lab.describe(), photon, bounce, said: lab.describe()}
    },
})

// ---- a figure ----

class LiveFigure {
    constructor(place, kind) {
        Object.assign(this, {place, kind, values: {}, pending: false})
        for (const c of kind.controls) this.values[c.name] = c.value
    }

    async open() {
        const {place, kind} = this
        this.canvas = document.createElement('canvas')
        this.canvas.className = kind.scene ? 'of-scene' : 'of-sheet'
        if (!kind.alone) this.lab = await Photonlab.open(await Photonlab.compile(), kind.scene ? this.canvas : undefined)
        if (kind.scene) {
            for (const mesh of document.querySelectorAll('script[type="text/mesh"]'))
                this.lab.file(mesh.dataset.name, await Photonlab.unpack(mesh))
            const scene = document.querySelector(`script[type="text/yaml"][data-name="${kind.scene}"]`).textContent
            this.lab.scene(scene, kind.scene)
        } else this.sheet = new Sheet(this.canvas)
        this.words = Object.assign(document.createElement('output'), {className: 'words'})
        this.panel = Object.assign(document.createElement('div'), {className: 'controls'})
        this.inputs = {}
        for (const control of kind.controls) this.panel.append(this.row(control))
        if (kind.open) await kind.open(this)
        place.append(this.canvas, this.words, this.panel)
        if (kind.alone) place.parentElement.classList.add('lives')
        this.hand()
        new ResizeObserver(() => this.want()).observe(this.canvas)
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.want())
        this.want()
    }

    // What an exported function gives, as a list.
    numbers(name, ...values) {
        const count = this.lab.call(name, ...values)
        return [...new Float64Array(this.lab.exports.memory.buffer, this.lab.call('web_numbers'), count)]
    }

    // The same in groups of so many.
    rows(size, name, ...values) {
        const all = this.numbers(name, ...values), rows = []
        for (let i = 0; i + size <= all.length; i += size) rows.push(all.slice(i, i + size))
        return rows
    }

    row(control) {
        const label = document.createElement('label')
        label.append(Object.assign(document.createElement('span'), {textContent: control.label}))
        const input = document.createElement(control.choices ? 'select' : 'input'), output = document.createElement('output')
        const show = value => {
            output.textContent = control.choices ? '' : rounded(value, 4) + (control.unit || '')
            input.setAttribute('aria-valuetext', output.textContent)
        }
        if (control.choices) {
            control.choices.forEach(words => input.append(new Option(words, words)))
            input.value = control.value
        } else {
            const whole = control.step ? value => Math.round(value / control.step) * control.step : value => value
            const {low, high, log} = control
            const toPlace = v => (log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low)) * 1000
            const toValue = p => whole(log ? low * (high / low) ** (p / 1000) : low + ((high - low) * p) / 1000)
            const grain = control.step && !log ? (1000 * control.step) / (high - low) : 1
            Object.assign(input, {type: 'range', min: 0, max: 1000, step: grain, value: toPlace(control.value)})
            input.toValue = toValue
            input.toPlace = toPlace
        }
        input.name = control.name
        input.addEventListener('input', () => {
            this.values[control.name] = control.choices ? input.value : input.toValue(Number(input.value))
            show(this.values[control.name])
            this.want()
        })
        this.inputs[control.name] = {input, show}
        show(control.value)
        label.append(input, output)
        return label
    }

    set(values) {
        for (const [name, value] of Object.entries(values)) {
            const control = this.kind.controls.find(c => c.name === name), {input, show} = this.inputs[name]
            this.values[name] = control.choices ? value : Math.min(Math.max(value, control.low), control.high)
            input.value = control.choices ? value : input.toPlace(this.values[name])
            show(this.values[name])
        }
        this.want()
    }

    // A finger or the mouse on the picture; arrow keys turn a scene.
    hand() {
        const {canvas, kind, lab} = this
        let last = null
        const move = event => {
            if (!last) return
            const size = canvas.getBoundingClientRect(), x = event.clientX - size.left, y = event.clientY - size.top
            if (kind.scene) lab.turn((x - last[0]) / size.height, (y - last[1]) / size.height)
            else if (kind.drag) this.set(kind.drag(this, ...this.sheet.at(x, y)) || {})
            last = [x, y]
            this.want()
        }
        canvas.addEventListener('pointerdown', event => {
            const size = canvas.getBoundingClientRect()
            last = [event.clientX - size.left, event.clientY - size.top]
            canvas.setPointerCapture(event.pointerId)
            move(event)
        })
        canvas.addEventListener('pointermove', move)
        for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => (last = null))
        if (!kind.scene) return
        canvas.tabIndex = 0
        canvas.setAttribute('aria-label', 'the picture; arrow keys turn it')
        canvas.addEventListener('keydown', event => {
            const turn = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[event.key]
            if (!turn) return
            event.preventDefault()
            lab.turn(...turn)
            this.want()
        })
    }

    want() {
        if (this.pending) return
        this.pending = true
        requestAnimationFrame(() => this.draw())
    }

    draw() {
        this.pending = false
        const {canvas, place} = this, scale = Math.min(window.devicePixelRatio || 1, 2)
        const width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale)
        if (width < 1 || height < 1) return
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height})
        try {
            const {words, ...numbers} = this.kind.draw(this, this.values)
            this.words.textContent = words
            place.dataset.numbers = JSON.stringify(numbers)
        } catch (error) {
            this.words.textContent = error.message
        }
    }
}

const sight = new IntersectionObserver(entries => {
    for (const {isIntersecting, target} of entries) {
        if (!isIntersecting) continue
        sight.unobserve(target)
        const place = target.querySelector('.live'), live = (place.live = new LiveFigure(place, figures[place.dataset.live]))
        live.open().catch(error => {
            place.textContent = `This figure does not move here: ${error.message}`
        })
    }
})
addEventListener('DOMContentLoaded', () => document.querySelectorAll('.live').forEach(place => sight.observe(place.parentElement)))
