// One's own code in the lab: the server says what was built and how the steps are, workers run it, and the panel stands beside.

const student = {number: -1, module: -1, now: null, good: null, lost: false, printed: '', unplayed: ''}
const MARK_CLASSES = {pass: 'right', fail: 'wrong', error: 'wrong'}

globalThis.photonlabHome = {
    banner: text => [student.lost, student.now && student.now.fault, student.now && student.now.warning, student.unplayed, text].filter(Boolean).join('\n'),
    compiled: () => WebAssembly.compileStreaming(fetch('photonlab.wasm')),
    workers: async compiled => {
        LIMITS.run = 3 * LIMIT // guard.c ends loops of steps sooner, and knows where; a busy machine is none
        buildPanel()
        await askState()
        home.scene = student.now.scene
        home.parameters.steps = student.now.play
        const workers = new PhotonlabWorkers((await newModule()) || compiled, student.now.students)
        workers.print = showPrinted
        return workers
    },
    started: () => follow(),
    keys: {n: () => tellServer('next'), '?': () => tellServer('hint')},
    done: messages => {
        student.good = messages
        student.unplayed = state.lab.text(state.lab.call('web_unplayed', student.now.saved))
        fault(state.fault)
    },
    // The last good photons stay; the server finds the words, and looks up the line.
    failed: (error, run) => {
        if (!error.trap) return fault(error.message)
        if (run === 'photons' && student.good) {
            state.lab.begin('photons')
            student.good.forEach(message => state.lab.receive(message))
            state.lab.show()
            wantPicture()
        }
        tellServer('fault', [student.module, error.trap.why, run, error.trap.megabytes, ...error.trap.offsets].join(' '))
    },
}

const tellServer = (name, text = '') => fetch(name, {method: 'POST', body: text}).catch(() => {})

// ---- what is new ----

async function askState() {
    const response = await fetch(`state?after=${student.number}`)
    if (!response.ok) throw new Error(`the server refuses: ${response.status}`)
    student.now = await response.json()
    student.number = student.now.number
    student.lost = ''
}

// null: it is the one that runs already.
async function newModule() {
    const {module} = student.now
    if (module === student.module || module === 0) return null
    const compiled = await WebAssembly.compileStreaming(fetch(`students.wasm?${module}`))
    student.module = module
    return compiled
}

async function follow() {
    showState()
    for (;;)
        try {
            const {scene} = student.now
            await askState()
            const compiled = await newModule()
            if (compiled) {
                state.workers.replace(compiled, student.now.students)
                showPrinted(null)
                if (state.rendering) restartRender()
                tracePhotons()
                findForView()
            }
            if (student.now.scene !== scene) chooseScene(student.now.scene)
            showState()
        } catch (error) {
            student.lost = 'make preview has ended, or cannot be reached. What is shown are the last photons.'
            fault(state.fault)
            await new Promise(resolve => setTimeout(resolve, 1000))
        }
}

// ---- the panel: what lib/preview/view/panel.c shows in the window ----

function buildPanel() {
    const side = element('div', {id: 'side'})
    $('panel').before(side)
    side.append(element('section', {id: 'verdicts', ariaLabel: 'How the steps are', hidden: true}), $('panel'))
    $('words').append(element('pre', {id: 'printed', hidden: true}))
    document.querySelector('h1').textContent = 'Your photons'
    document.querySelector('header a').remove()
}

function showState() {
    const {now} = student, step = now.steps[now.present]
    fault(state.fault)
    $('fault').classList.toggle('old', now.building)
    $('verdicts').hidden = !now.judged
    const rows = [...new Set(now.steps.map(s => s.stage))].map(stage => element('div', {}, ...now.steps.filter(s => s.stage === stage).map(s =>
        element('span', {className: `${s.old ? 'old' : MARK_CLASSES[s.state] || ''} ${s === step ? 'present' : ''}`,
            title: s.title, textContent: `${s.id} ${s.mark}${s.judged ? '‥' : ''}`}))))
    const line = (className, text) => (text ? [element('p', {className, textContent: text})] : [])
    const wrong = step.state === 'fail' || step.state === 'error', right = step.state === 'pass'
    $('verdicts').replaceChildren(element('div', {className: 'marks'}, ...rows),
        element('h2', {textContent: `${step.mark} ${step.id} ${step.title}`}),
        ...line('soft', `${now.source}/${step.file}.c`),
        ...line('soft', step.state === 'todo' && 'not started: take away the line with todo(), and write'),
        ...line(step.old ? 'soft' : '', (wrong || step.state === 'skip') && step.message),
        ...line('soft', wrong && step.where && `in ${step.where}`),
        ...line('like', step.like && `looks like: ${step.like}`),
        ...line('soft', step.judged && 'being judged …'),
        ...line('right', right && (now.finished ? 'All steps are right! make report, make finale' : !step.judged && `Right. On to ${now.next}`)),
        ...line('hint', now.hint),
        element('div', {className: 'buttons'}, button('next', 'next step', () => tellServer('next')), button('hint', 'hint', () => tellServer('hint'))))
}

// What steps print, as text whatever it is. null: a run begins.
function showPrinted(text) {
    student.printed = text === null ? '' : (student.printed + text).slice(0, 16384)
    $('printed').textContent = student.printed
    $('printed').hidden = !student.printed
}
