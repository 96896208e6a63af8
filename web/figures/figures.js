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
