// The picture: when it is drawn and with how many points, and the words below it.

const LEAST_POINTS = 10000 // drawn while the camera moves, and more where frames stay below SLOW ms; all are when it rests
const SLOW = 36, QUICK = 20 // the 30th and the 60th part of a second, and what clocks waver
const REST = 180 // ms without a movement
const FLIGHT = 6 // s that slow light takes

function wantPicture() {
    if (state.pending) return
    state.pending = true
    requestAnimationFrame(draw)
}

// As many pixels as are seen.
function fitCanvas() {
    const canvas = $('picture'), scale = Math.min(window.devicePixelRatio || 1, 2)
    const width = Math.max(1, Math.round(canvas.clientWidth * scale)), height = Math.max(1, Math.round(canvas.clientHeight * scale))
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height})
}

function draw(now) {
    state.pending = false
    fitCanvas()
    // What moved is drawn with fewer points however late its frame comes: with all of them the next would come later still.
    const {lab} = state, moving = state.moved || performance.now() < state.rested
    state.moved = false
    if (state.flying) lab.set({flight: ((now - state.flying) / 1000 / FLIGHT % 1.1) * lab.collected().farthest})
    keepPace(moving ? now : 0)
    lab.set({most_points: moving ? state.points : 0})
    lab.draw()
    clearTimeout(state.resting)
    if (state.flying) wantPicture()
    else if (moving) state.resting = setTimeout(wantPicture, REST)
    if (!moving) tell()
}

// As many points as 30 frames a second allow. `now`: 0 at rest.
function keepPace(now) {
    const took = now - state.drawn, begins = !state.drawn
    state.drawn = now
    if (begins || !now) return
    if (took > SLOW) state.points = Math.max(LEAST_POINTS, Math.round(0.8 * state.points))
    else if (took < QUICK && state.points < state.lab.collected().photons) state.points = Math.round(1.25 * state.points)
}

function moved() {
    stopRender()
    state.moved = true
    state.rested = performance.now() + REST
    wantPicture()
}

function tell() {
    const {photons, emitted, passes} = state.lab.collected(), count = number => number.toLocaleString('en-GB')
    const words = [`${count(emitted)} photons, ${count(photons)} stored`]
    if (state.seconds) words[0] += `, ${state.seconds.toFixed(2)} s`
    if (state.rendering) words.push(passes ? `${passes} pass${passes === 1 ? '' : 'es'}` : 'the picture is on its way')
    if (state.said) words.push(state.said)
    const legend = (state.rendering ? [] : state.lab.legend()).map(([colour, text]) => {
        const patch = element('span')
        patch.style.background = colour
        return element('li', {}, patch, text)
    })
    $('legend').replaceChildren(...legend)
    $('description').textContent = state.rendering ? `what you see, rendered; light by ${state.lab.get('integrator')}` : state.lab.describe()
    $('status').textContent = words.join(' · ')
}

// Photons in the order of their flight, again and again.
function toggleFlight() {
    state.flying = state.flying ? 0 : performance.now()
    state.lab.set({flight: state.flying ? 0 : -1})
    wantPicture()
}
