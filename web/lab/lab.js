// The lab: the preview in a page.

const $ = id => document.getElementById(id)
const PART = 4000 // paths of a part of a run
const PASSES = 64 // of a rendered picture

// What the page brings along.
const scenes = Object.fromEntries([...document.querySelectorAll('script[type="text/yaml"]')].map(script => [script.dataset.name, script.textContent]))

// What a page of its own around the lab does otherwise (serve/tab.js).
const home = {
    scene: 'box_glass.yaml',
    parameters: {photons: 200000}, // of a scene that is chosen
    banner: text => text, // what stands in it: the lab's own words, and perhaps more
    compiled: () => Photonlab.compile(),
    workers: async compiled => new PhotonlabWorkers(compiled),
    failed: error => fault(error.message), // a run
    done: () => {}, // all photons are there: the messages that they came in
    started: () => {},
    keys: {}, // letter: what it does
    ...globalThis.photonlabHome,
}

const state = {
    lab: null, workers: null,
    scene: null, // {yaml, name, files}: that photons are of
    pending: false, moved: false, rested: 0, resting: 0, drawn: 0, points: 50000, // of drawing; of points, those of a moving frame
    shown: 0, seconds: 0, // photons; the time that all took
    found: 'photons', // the kind of run that was last asked for beside photons
    rendering: false, flying: 0,
    said: '',
}

function fault(text) {
    state.fault = text || ''
    $('fault').textContent = home.banner(state.fault)
    $('fault').hidden = !$('fault').textContent
}

function say(text) {
    state.said = text
    tell()
}

// ---- photons, and what views show beside them ----

async function tracePhotons() {
    const {lab, workers} = state, began = performance.now()
    stopRender()
    lab.begin('photons')
    state.shown = state.seconds = 0
    state.said = ''
    const messages = [], receive = message => {
        messages.push(message)
        lab.receive(message)
        const {photons} = lab.collected()
        if (photons < 1.5 * state.shown + 100) return
        state.shown = photons
        lab.show()
        wantPicture()
    }
    try {
        const parts = Math.max(1, Math.round(lab.get('photons') / PART))
        if (!(await workers.run('photons', state.scene, lab.all(), parts, receive))) return
        state.seconds = (performance.now() - began) / 1000
        lab.show()
        fault(lab.oddities())
        home.done(messages)
        wantPicture()
    } catch (error) {
        home.failed(error, 'photons')
    }
}

async function findForView() {
    const {lab, workers} = state, kind = lab.shows()
    state.found = kind
    if (kind === 'photons') return
    lab.begin(kind)
    try {
        if (await workers.run(kind, state.scene, lab.all(), 1, message => lab.receive(message))) wantPicture()
    } catch (error) {
        home.failed(error, kind)
    }
}

// ---- a rendered picture of what is seen, pass by pass ----

function stopRender() {
    if (!state.rendering) return
    state.rendering = false
    state.workers.stop('render')
    state.lab.set({rendered: 0})
    $('render').textContent = 'render'
    wantPicture()
}

async function startRender() {
    const {lab, workers} = state, {width, height} = $('picture')
    state.rendering = true
    $('render').textContent = 'stop'
    lab.set({rendered: 1, width, height, passes: PASSES})
    lab.begin('render')
    tell()
    const receive = message => {
        lab.receive(message)
        wantPicture()
    }
    try {
        await workers.run('render', state.scene, lab.all(), lab.get('radii') === 'alike' ? PASSES : 1, receive)
    } catch (error) {
        if (state.rendering) home.failed(error, 'render')
    }
}

function toggleRender() {
    state.rendering ? stopRender() : startRender()
}

function restartRender() {
    stopRender()
    startRender()
}

// ---- the scene ----

// False, with the fault beside the text, when it is no scene.
function readScene(yaml, name, keepView) {
    let wrong = ''
    try {
        state.lab.scene(yaml, name, keepView)
    } catch (error) {
        wrong = error.message
    }
    $('wrong').textContent = wrong
    $('wrong').hidden = !wrong
    $('yaml').setAttribute('aria-invalid', String(Boolean(wrong)))
    if (wrong) return false
    state.scene = {yaml, name, files: state.files}
    return true
}

// The text as it stands, once it rests for so long.
function wantScene(rest = 0) {
    clearTimeout(state.typing)
    state.typing = setTimeout(() => {
        if (!readScene($('yaml').value, $('scene').value, true)) return
        if (rest) fillPanel() // by hand; a slider goes on being held
        fault('')
        tracePhotons()
        findForView()
    }, rest)
}

function chooseScene(name, yaml = scenes[name], parameters = home.parameters) {
    $('scene').value = name
    $('yaml').value = yaml
    if (!readScene(yaml, name, false)) return
    for (const [key, value] of Object.entries(parameters))
        try {
            state.lab.set({[key]: value})
        } catch (error) {
            fault(error.message) // a link by another version, say
        }
    fault('')
    tracePhotons()
    findForView()
    fillPanel()
}

// ---- the beginning ----

async function start() {
    try {
        const compiled = await home.compiled()
        state.workers = await home.workers(compiled) // they open while WebGL does
        fitCanvas() // another size would cost WebGL a tenth of a second
        state.lab = await Photonlab.open(compiled, $('picture'))
        const meshes = [...document.querySelectorAll('script[type="text/mesh"]')]
        state.files = await Promise.all(meshes.map(async script => [script.dataset.name, await Photonlab.unpack(script)]))
        for (const [name, bytes] of state.files) state.lab.file(name, bytes)
        for (const name of Object.keys(scenes)) $('scene').add(new Option(name, name))
        const shared = await stateOf(location.hash.slice(1))
        listen()
        if (shared && scenes[shared.scene] !== undefined) chooseScene(shared.scene, shared.yaml, shared.parameters)
        else chooseScene(home.scene)
        home.started()
    } catch (error) {
        fault(`The lab does not run here: ${error.message}`)
        throw error
    }
}
start()
