// The lab: the preview in a page. What may be set comes from the module's own list; here stand its looks and the hand's.

const $ = id => document.getElementById(id)
const MOVING_POINTS = 60000 // drawn while the camera moves; all are when it rests
const REST = 180 // ms without a movement

// ---- what the page brings along ----

const scenes = Object.fromEntries([...document.querySelectorAll('script[type="text/yaml"]')].map(element => [element.dataset.name, element.textContent]))
const files = []

const state = {scene: null, lab: null, workers: null, pending: false, rested: 0, shown: 0, seconds: 0}

function fault(text) {
    $('fault').textContent = text || ''
    $('fault').hidden = !text
}

// ---- drawing ----

function wantPicture() {
    if (state.pending) return
    state.pending = true
    requestAnimationFrame(draw)
}

function draw() {
    state.pending = false
    const {lab} = state, canvas = $('picture')
    const scale = Math.min(window.devicePixelRatio || 1, 2)
    const width = Math.max(1, Math.round(canvas.clientWidth * scale)), height = Math.max(1, Math.round(canvas.clientHeight * scale))
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height})
    const moving = performance.now() < state.rested
    lab.set({most_points: moving ? MOVING_POINTS : 0})
    lab.draw()
    if (moving) setTimeout(wantPicture, REST)
    tell()
}

function moved() {
    stopRender()
    state.rested = performance.now() + REST
    wantPicture()
}

function tell() {
    const {photons, emitted, passes} = state.lab.collected()
    const picture = state.rendering ? ` · rendered: ${passes ? `${passes} pass${passes === 1 ? '' : 'es'}` : 'on its way'}` : ''
    const time = state.seconds ? `, ${state.seconds.toFixed(2)} s` : ''
    const legend = state.lab.legend().map(([colour, words]) => {
        const item = document.createElement('li'), patch = document.createElement('span')
        patch.style.background = colour
        item.append(patch, words)
        return item
    })
    $('legend').replaceChildren(...legend)
    $('description').textContent = state.lab.describe()
    $('status').textContent = `${emitted.toLocaleString('en-GB')} photons, ${photons.toLocaleString('en-GB')} stored${time}${picture}`
}

// ---- photons ----

// Small at first, for a quick look.
const PART = 4000 // paths

async function tracePhotons() {
    const {lab, workers} = state
    const began = performance.now(), photons = lab.get('photons')
    lab.begin('photons')
    state.shown = state.seconds = 0
    fault('')
    stopRender()
    const receive = message => {
        lab.receive(message)
        const found = lab.collected()
        if (found.photons < 1.5 * state.shown + 100) return
        state.shown = found.photons
        lab.show()
        wantPicture()
    }
    try {
        if (!(await workers.run('photons', state.scene, lab.all(), Math.max(1, Math.round(photons / PART)), receive))) return
        state.seconds = (performance.now() - began) / 1000
        lab.show()
        fault(lab.oddities())
        wantPicture()
    } catch (error) {
        fault(error.message)
    }
}

// What the present view shows beside photons.
async function findForView() {
    const {lab, workers} = state, kind = lab.shows()
    if (kind === 'photons') return
    lab.begin(kind)
    const settings = {...lab.all(), photons: Math.min(lab.get('photons'), 200000)}
    try {
        if (await workers.run(kind, state.scene, settings, 1, message => lab.receive(message))) wantPicture()
    } catch (error) {
        fault(error.message)
    }
}

// ---- a rendered picture, pass by pass, of what is seen ----

const PASSES = 64

function stopRender() {
    if (!state.rendering) return
    state.rendering = false
    state.workers.stop('render')
    state.lab.set({rendered: 0})
    $('render').textContent = 'render'
    wantPicture()
}

async function startRender() {
    const {lab, workers} = state, canvas = $('picture')
    state.rendering = true
    $('render').textContent = 'stop'
    const {width, height} = canvas
    lab.set({rendered: 1, width, height, passes: PASSES})
    lab.begin('render')
    const receive = message => {
        lab.receive(message)
        wantPicture()
    }
    const settings = {...lab.all(), passes: PASSES}
    try {
        await workers.run('render', state.scene, settings, lab.get('radii') === 'alike' ? PASSES : 1, receive)
    } catch (error) {
        if (state.rendering) fault(error.message)
    }
}

// ---- the scene ----

// False, with the fault beside the text, when it is no scene.
function readScene(yaml, name, keepView) {
    const {lab} = state
    try {
        lab.scene(yaml, name, keepView)
    } catch (error) {
        $('wrong').textContent = error.message
        $('wrong').hidden = false
        $('yaml').setAttribute('aria-invalid', 'true')
        return false
    }
    $('wrong').hidden = true
    $('yaml').removeAttribute('aria-invalid')
    state.scene = {yaml, name, files}
    if (!keepView) {
        lab.set({photons: 200000})
        fillPanel()
    }
    tracePhotons()
    findForView()
    return true
}

function chooseScene(name) {
    $('yaml').value = scenes[name]
    readScene(scenes[name], name, false)
}

// ---- the panel, of the module's list of parameters ----

function row(name, control, output) {
    const label = document.createElement('label')
    label.className = 'row'
    label.append(Object.assign(document.createElement('span'), {textContent: name}), control, ...(output ? [output] : []))
    return label
}

function chooser(name, words, then) {
    const select = Object.assign(document.createElement('select'), {id: name})
    for (const word of words) select.add(new Option(word, word))
    select.value = state.lab.get(name)
    select.onchange = () => {
        state.lab.set({[name]: select.value})
        then()
    }
    return row(name, select)
}

function tick(name, words, then) {
    const box = Object.assign(document.createElement('input'), {type: 'checkbox', id: name, checked: state.lab.get(name) !== 0})
    box.onchange = () => {
        state.lab.set({[name]: box.checked ? 1 : 0})
        then()
    }
    return row(words, box)
}

// Over several powers of ten the slider's own steps are those of the logarithm.
function slider(name, words, low, high, {whole = false, logarithmic = false, none = null} = {}, then) {
    const input = Object.assign(document.createElement('input'), {type: 'range', id: name, min: 0, max: 1000})
    const output = document.createElement('output')
    const exact = place => (logarithmic ? low * (high / low) ** place : low + (high - low) * place)
    const place = value => (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low))
    if (!logarithmic && whole) input.max = high - low
    const value = () => {
        const found = exact(input.value / input.max)
        return whole ? Math.round(logarithmic && found > 100 ? Number(found.toPrecision(2)) : found) : Number(found.toPrecision(3))
    }
    const show = number => {
        output.textContent = none !== null && number === low ? none : number.toLocaleString('en-GB', {maximumSignificantDigits: 4})
        input.setAttribute('aria-valuetext', output.textContent)
    }
    const now = state.lab.get(name)
    input.value = Math.min(Math.max(place(now), 0), 1) * input.max
    show(now)
    input.oninput = () => {
        state.lab.set({[name]: value()})
        show(value())
        then()
    }
    return row(words, input, output)
}

function fieldset(title, ...rows) {
    const set = document.createElement('fieldset')
    set.append(Object.assign(document.createElement('legend'), {textContent: title}), ...rows)
    return set
}

function button(words, act, moves = true) {
    const made = Object.assign(document.createElement('button'), {type: 'button', textContent: words})
    made.onclick = () => {
        act()
        if (moves) moved()
    }
    return made
}

const SETTING_HIGH = {'lobe.exponent': 1000, 'paths.path': 999, 'paths.bounce': 30} // as far as the slider goes

function settingsOf(view) {
    return state.lab.list.parameters
        .filter(p => p.kind && p.name.startsWith(view + '.'))
        .map(p => {
            const words = p.name.split('.')[1], then = view === 'lobe' ? findForView : wantPicture
            if (p.kind === 'switch') return tick(p.name, words, then)
            const high = Math.min(p.high, SETTING_HIGH[p.name] || p.high)
            return slider(p.name, words, p.low, high, {whole: p.kind === 'whole', none: p.low < 0 ? 'all' : null}, then)
        })
}

function fillPanel() {
    const {lab} = state
    const changed = () => {
        fillPanel()
        findForView()
        wantPicture()
    }
    const buttons = document.createElement('div')
    buttons.className = 'buttons'
    buttons.append(button('frame', () => lab.frame()), button('camera', () => lab.home()), button('+', () => lab.zoom(0.8)), button('−', () => lab.zoom(1.25)))
    const render = button('render', () => (state.rendering ? stopRender() : startRender()), false)
    render.id = 'render'
    buttons.append(render)
    const focused = document.activeElement && document.activeElement.id
    $('panel').replaceChildren(
        fieldset('picture', chooser('view', lab.list.view, changed), chooser('colour', lab.list.colour, wantPicture),
            tick('wireframe', 'wires', wantPicture), ...settingsOf(lab.get('view')), buttons),
        fieldset('photons', slider('photons', 'photons', 1000, 2e6, {whole: true, logarithmic: true}, tracePhotons),
            slider('depth', 'depth', 1, 50, {whole: true}, tracePhotons), slider('seed', 'seed', 1, 100, {whole: true}, tracePhotons)),
    )
    if (focused && $(focused)) $(focused).focus()
}

// ---- the hand ----

function listen() {
    const canvas = $('picture'), pointers = new Map()
    const distance = () => {
        const [a, b] = [...pointers.values()]
        return Math.hypot(a.x - b.x, a.y - b.y)
    }
    canvas.onpointerdown = event => {
        canvas.setPointerCapture(event.pointerId)
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY})
    }
    canvas.onpointerup = canvas.onpointercancel = event => pointers.delete(event.pointerId)
    canvas.onpointermove = event => {
        const last = pointers.get(event.pointerId)
        if (!last) return
        const right = (event.clientX - last.x) / canvas.clientHeight, down = (event.clientY - last.y) / canvas.clientHeight
        const before = pointers.size === 2 ? distance() : 0
        pointers.set(event.pointerId, {x: event.clientX, y: event.clientY})
        if (pointers.size === 2) { // two fingers move and zoom
            state.lab.move(right / 2, down / 2)
            state.lab.zoom(before / Math.max(distance(), 1))
        } else if (event.buttons & 1 && !event.shiftKey) state.lab.turn(right, down)
        else state.lab.move(right, down)
        moved()
    }
    canvas.oncontextmenu = event => event.preventDefault()
    canvas.addEventListener('wheel', event => {
        event.preventDefault()
        state.lab.zoom(0.999 ** -event.deltaY)
        moved()
    }, {passive: false})
    canvas.onkeydown = onKey
    $('yaml').oninput = () => {
        clearTimeout(state.typing)
        state.typing = setTimeout(() => readScene($('yaml').value, $('scene').value, true), 250)
    }
    $('scene').onchange = () => chooseScene($('scene').value)
    new ResizeObserver(wantPicture).observe(canvas)
}

const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}

// The window's keys; with shift the arrows turn the scene.
function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return
    const {lab} = state, arrow = ARROWS[event.key], views = lab.list.view
    const next = (name, words) => lab.set({[name]: words[(words.indexOf(lab.get(name)) + 1) % words.length]})
    if (arrow && event.shiftKey) lab.turn(0.05 * arrow[0], 0.05 * arrow[1])
    else if (arrow) lab.choose(arrow[0] !== 0, arrow[0] - arrow[1])
    else if (event.key >= '1' && event.key <= String(views.length)) lab.set({view: views[event.key - 1]})
    else if (event.key === 'c') next('colour', lab.list.colour)
    else if (event.key === 'w') lab.set({wireframe: 1 - lab.get('wireframe')})
    else if (event.key === 'f') lab.frame()
    else if (event.key === '0') lab.home()
    else if (event.key === '+' || event.key === '=') lab.set({photons: Math.min(2 * lab.get('photons'), 16e6)})
    else if (event.key === '-') lab.set({photons: Math.max(lab.get('photons') / 2, 1000)})
    else if (event.key === 'r') lab.set({seed: lab.get('seed') + 1})
    else return
    event.preventDefault()
    if ('+=-r'.includes(event.key)) tracePhotons()
    fillPanel()
    findForView()
    moved()
}

// ---- the beginning ----

async function start() {
    try {
        const compiled = await Photonlab.compile()
        state.lab = await Photonlab.open(compiled, $('picture'))
        state.workers = new PhotonlabWorkers(compiled)
        for (const element of document.querySelectorAll('script[type="text/mesh"]')) {
            const bytes = await Photonlab.unpack(element)
            files.push([element.dataset.name, bytes])
            state.lab.file(element.dataset.name, bytes)
        }
        for (const name of Object.keys(scenes)) $('scene').add(new Option(name, name))
        $('scene').value = 'box_glass.yaml'
        listen()
        chooseScene($('scene').value)
    } catch (error) {
        fault(`The lab does not run here: ${error.message}`)
        throw error
    }
}
start()
