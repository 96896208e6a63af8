// What mouse, fingers and keys do.

function act(change) {
    change()
    moved()
}

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
        act(() => state.lab.zoom(0.999 ** -event.deltaY))
    }, {passive: false})
    canvas.onkeydown = onKey
    $('yaml').oninput = () => wantScene(250)
    $('scene').onchange = () => chooseScene($('scene').value)
    new ResizeObserver(wantPicture).observe(canvas)
}

const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}

// The window's keys; with shift the arrows turn the scene. True: it is one.
function pressed(event) {
    const {lab} = state, arrow = ARROWS[event.key], views = lab.list.view
    const next = name => lab.set({[name]: lab.list[name][(lab.list[name].indexOf(lab.get(name)) + 1) % lab.list[name].length]})
    const photons = values => {
        lab.set(values)
        tracePhotons()
    }
    const keys = {
        c: () => next('colour'),
        w: () => lab.set({wireframe: 1 - lab.get('wireframe')}),
        f: () => lab.frame(),
        0: () => lab.home(),
        '+': () => photons({photons: Math.min(2 * lab.get('photons'), 16e6)}),
        '-': () => photons({photons: Math.max(Math.round(lab.get('photons') / 2), 1000)}),
        r: () => photons({seed: lab.get('seed') + 1}),
        p: toggleRender,
        ' ': toggleFlight,
        s: savePicture,
        ...home.keys,
    }
    if (arrow && event.shiftKey) lab.turn(0.05 * arrow[0], 0.05 * arrow[1])
    else if (arrow) lab.choose(arrow[0] !== 0, arrow[0] - arrow[1])
    else if (event.key >= '1' && event.key <= String(views.length)) lab.set({view: views[event.key - 1]})
    else if (keys[event.key === '=' ? '+' : event.key]) keys[event.key === '=' ? '+' : event.key]()
    else return false
    return true
}

function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || !pressed(event)) return
    event.preventDefault()
    fillPanel()
    if (event.key !== 'p') moved()
    if (state.lab.shows() !== state.found) findForView()
}
