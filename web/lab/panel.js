// The lab's controls. What may be set, and how far, comes from the module's own lists; here stand the looks.

function element(kind, properties = {}, ...inside) {
    const made = Object.assign(document.createElement(kind), properties)
    made.append(...inside)
    return made
}

function row(words, control, output) {
    return element('label', {className: 'row'}, element('span', {textContent: words}), control, ...(output ? [output] : []))
}

function chooser(name, words, then) {
    const select = element('select', {id: name})
    for (const word of state.lab.list[name]) select.add(new Option(word, word))
    select.value = state.lab.get(name)
    select.onchange = () => {
        state.lab.set({[name]: select.value})
        then()
    }
    return row(words, select)
}

function tick(name, words, then) {
    const box = element('input', {type: 'checkbox', id: name, checked: state.lab.get(name) !== 0})
    box.onchange = () => {
        state.lab.set({[name]: box.checked ? 1 : 0})
        then()
    }
    return row(words, box)
}

// `get` and `set`: of the number. Over several powers of ten (`logarithmic`) the slider's own steps are those of the logarithm.
// `least`: the word for the lowest place.
function slider(id, words, {low, high, whole = false, logarithmic = false, least = null, unit = ''}, get, set) {
    const input = element('input', {type: 'range', id, min: 0, max: logarithmic ? 200 : whole ? high - low : 1000})
    const output = element('output')
    const placeOf = value => (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low))
    const value = () => {
        const place = input.value / input.max
        const exact = logarithmic ? low * (high / low) ** place : low + (high - low) * place
        return whole && exact < 1000 ? Math.round(exact) : Number(exact.toPrecision(whole ? 2 : 3))
    }
    const show = number => {
        const text = number.toLocaleString('en-GB', {maximumSignificantDigits: 4}) + (unit === 'degrees' ? '°' : unit && ` ${unit}`)
        output.textContent = least !== null && number <= low ? least : text
        input.setAttribute('aria-valuetext', output.textContent)
    }
    input.value = Math.min(Math.max(placeOf(get()), 0), 1) * input.max
    show(get())
    input.oninput = () => {
        show(value())
        set(value())
    }
    return row(words, input, output)
}

function parameterSlider(name, words, range, then) {
    return slider(name, words, range, () => state.lab.get(name), value => {
        state.lab.set({[name]: value})
        then()
    })
}

function fieldset(title, ...rows) {
    return element('fieldset', {}, element('legend', {textContent: title}), ...rows)
}

function button(id, words, act) {
    return element('button', {type: 'button', id, textContent: words, onclick: act})
}

// ---- what the present view can choose ----

const SETTING_HIGH = {'lobe.exponent': 1000, 'paths.path': 999, 'paths.bounce': 30, 'screen.surface': 40} // as far as the slider goes

function viewSettings(view) {
    const then = view === 'lobe' ? findForView : wantPicture
    return state.lab.list.parameters.filter(p => p.kind && p.name.startsWith(view + '.')).map(p => {
        const words = p.name.split('.')[1], high = Math.min(p.high, SETTING_HIGH[p.name] || p.high)
        if (p.kind === 'switch') return tick(p.name, words, then)
        return parameterSlider(p.name, words, {low: p.low, high, whole: p.kind === 'whole', least: p.low < 0 ? 'all' : null}, then)
    })
}

// ---- numbers of the scene, changed in its text ----

// In place of the number that stands there.
function putNumber(yaml, {line, column}, value) {
    const lines = yaml.split('\n'), before = lines[line - 1].slice(0, column - 1)
    const behind = lines[line - 1].slice(column - 1).replace(/^[-+.\deE]+/, '')
    lines[line - 1] = before + Number(value.toPrecision(6)) + behind
    return lines.join('\n')
}

const place = v => `${v.section}-${v.entry}-${v.key}`

// The present value of that place; others before it may have become longer.
function presentValue(where) {
    return state.lab.values($('yaml').value).find(v => place(v) === where)
}

function changeScene(where, number, part = 0) {
    const value = presentValue(where)
    if (value) $('yaml').value = putNumber($('yaml').value, value.numbers[part], number)
    wantScene()
}

// A range that a slider can show: of lengths and the like, a tenth to ten times what the scene has.
function sliderRange(v) {
    const now = v.numbers[0].value, {low, high, unit, whole} = v
    if (v.key.startsWith('index')) return {low: 1, high: 3}
    if (high - low <= 360) return {low, high, unit}
    return {low: now > 0 ? now / 10 : 0.1, high: now > 0 ? now * 10 : 10, unit, whole: Boolean(whole), logarithmic: true}
}

// Turns where a light stands about what it looks at, in the plane: the angle of the beam.
function turnSlider(position, target) {
    const [x, , z] = position.numbers.map((n, i) => n.value - target.numbers[i].value)
    const where = place(position)
    let angle = 0
    return slider(`${where}-turn`, 'turned by', {low: -45, high: 45, unit: 'degrees'}, () => angle, degrees => {
        angle = degrees
        const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180)
        changeScene(where, target.numbers[0].value + c * x - s * z, 0)
        changeScene(where, target.numbers[2].value + s * x + c * z, 2)
    })
}

function sceneFields(yaml) {
    const sets = new Map(), values = state.lab.values(yaml)
    for (const v of values) {
        const title = v.name || (v.section === 'lights' ? `${v.type} light` : v.type), id = `${v.section}-${v.entry}`
        if (!sets.has(id)) sets.set(id, {title, rows: []})
        if (v.numbers.length === 1)
            sets.get(id).rows.push(slider(place(v), v.key, sliderRange(v), () => v.numbers[0].value, number => changeScene(place(v), number)))
        const target = v.key === 'position' && values.find(t => t.section === v.section && t.entry === v.entry && t.key === 'target')
        if (target) sets.get(id).rows.push(turnSlider(v, target))
    }
    return [...sets.values()].filter(set => set.rows.length).map(set => fieldset(set.title, ...set.rows))
}

// ---- all of it ----

function fillPanel() {
    const {lab} = state
    const viewChanged = () => {
        fillPanel()
        findForView()
        wantPicture()
    }
    const buttons = element('div', {className: 'buttons'},
        button('frame', 'frame', () => act(() => lab.frame())), button('home', 'camera', () => act(() => lab.home())),
        button('near', '+', () => act(() => lab.zoom(0.8))), button('far', '−', () => act(() => lab.zoom(1.25))),
        button('slow', 'slow light', toggleFlight))
    const rendering = element('div', {className: 'buttons'}, button('render', state.rendering ? 'stop' : 'render', toggleRender))
    const tree = element('div', {className: 'buttons'}, button('save', 'save picture', savePicture),
        button('ply', 'save photons', savePhotons), button('share', 'share link', share))
    const focused = document.activeElement && document.activeElement.id
    const again = () => state.rendering && restartRender()
    const size = Math.max(...['x', 'y', 'z'].map(axis => Math.abs(lab.get(`target_${axis}`))), lab.get('distance'))
    $('panel').replaceChildren(
        fieldset('picture', chooser('view', 'view', viewChanged), chooser('colour', 'colour', wantPicture), tick('wireframe', 'wires', wantPicture),
            ...viewSettings(lab.get('view')), buttons),
        fieldset('photons', parameterSlider('photons', 'photons', {low: 1000, high: 2e6, whole: true, logarithmic: true}, tracePhotons),
            parameterSlider('depth', 'depth', {low: 1, high: 50, whole: true}, tracePhotons),
            parameterSlider('seed', 'seed', {low: 1, high: 100, whole: true}, tracePhotons), tick('spectral', 'wavelengths', tracePhotons)),
        ...sceneFields($('yaml').value),
        fieldset('rendered picture', chooser('integrator', 'light by', again), chooser('radii', 'radii', again),
            parameterSlider('k', 'k', {low: 5, high: 2000, whole: true, logarithmic: true}, again),
            parameterSlider('radius', 'radius', {low: 0, high: size / 4, unit: 'm', least: 'no limit'}, again), rendering),
        tree)
    if (focused && $(focused)) $(focused).focus()
}
