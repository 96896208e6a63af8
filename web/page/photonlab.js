// The module in a page: web/README.md tells how it is used. No page needs more of it than the class Photonlab.

// The numbers of the interface in the order of web_collected().
const COLLECTED = ['photonsAt', 'photons', 'photonBytes', 'legsAt', 'legs', 'legBytes', 'emitted', 'segments', 'passes', 'farthest']

class Photonlab {
    // `compiled`: a WebAssembly.Module, see Photonlab.compile. `canvas`: to draw into; without one (in a worker) photons
    // can be traced, and nothing can be drawn.
    static async open(compiled, canvas) {
        const lab = new Photonlab()
        const memory = () => lab.exports.memory
        const gl = canvas && canvas.getContext('webgl2', {alpha: false, antialias: false, depth: false})
        if (canvas && !gl) throw new Error('this browser draws no WebGL 2')
        const drawing = gl ? photonlabGl(gl, memory) : {}
        const missing = name => () => {
            throw new Error(`${name}: there is no canvas to draw into`)
        }
        drawing.photonlab_send = (...message) => lab.sent(...message)
        drawing.photonlab_beat = fraction => lab.beat(fraction)
        drawing.photonlab_stop = why => {
            throw Object.assign(new Error('stopped'), {why: ['loop', 'memory', 'null', 'bounds'][why]})
        }
        const imports = {env: {}, wasi_snapshot_preview1: photonlabWasi(memory, text => lab.print(text))}
        for (const {module, name} of WebAssembly.Module.imports(compiled))
            if (module === 'env') imports.env[name] = drawing[name] || missing(name)
            else imports[module][name] ||= () => 52 // ENOSYS
        lab.canvas = canvas
        lab.exports = (await WebAssembly.instantiate(compiled, imports)).exports
        lab.exports._initialize()
        return lab
    }

    // Text that make_page.sh put into the page, packed, as an ArrayBuffer.
    static async unpack(element) {
        const packed = Uint8Array.from(atob(element.textContent.trim()), letter => letter.charCodeAt(0))
        return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()
    }

    // The page's module: compiled once, for as many instances as are wanted.
    static compile() {
        Photonlab.compiled ||= Photonlab.unpack(document.getElementById('photonlab-module')).then(bytes => WebAssembly.compile(bytes))
        return Photonlab.compiled
    }

    // ---- calling the module: any of its functions by name, with text where it takes text ----

    bytes() {
        return new Uint8Array(this.exports.memory.buffer)
    }

    // A copy of the bytes, or the text, in the module's memory, with a 0 behind it; to be freed, or given away.
    put(content) {
        const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : new Uint8Array(content)
        const at = this.exports.web_allocate(bytes.length + 1)
        if (!at) throw new Error('not enough memory')
        this.bytes().set(bytes, at)
        this.bytes()[at + bytes.length] = 0
        return at
    }

    text(at) {
        const all = this.bytes()
        return new TextDecoder().decode(all.slice(at, all.indexOf(0, at)))
    }

    call(name, ...values) {
        const texts = []
        const given = values.map(value => (typeof value === 'string' ? (texts.push(this.put(value)), texts.at(-1)) : value))
        const answer = this.exports[name](...given)
        texts.forEach(at => this.exports.free(at))
        return answer
    }

    // Of functions that answer whether they could: throws what they say if not.
    must(name, ...values) {
        if (!this.call(name, ...values)) throw new Error(this.text(this.call('web_error')))
    }

    // ---- the scene ----

    // A mesh that scenes name: file('meshes/diamond.obj', bytes).
    file(name, content) {
        const at = this.put(content)
        const size = typeof content === 'string' ? new TextEncoder().encode(content).length : content.byteLength
        if (!this.call('web_put_file', name, at, size)) throw new Error(`${name}: too many files`)
    }

    // Throws "name:line:column: …" for a scene with a fault; the one before stays then.
    scene(yaml, name = 'scene.yaml', keepView = false) {
        const size = new TextEncoder().encode(yaml).length
        this.must('web_scene', yaml, size, name, keepView)
        this.list = JSON.parse(this.text(this.call('web_parameters')))
    }

    // Numbers in a scene's text that may be changed, and where they stand: see values.c.
    values(yaml) {
        return JSON.parse(this.text(this.call('web_values', yaml, new TextEncoder().encode(yaml).length)))
    }

    // ---- parameters: set({photons: 1e5, view: 'paths', 'lobe.exponent': 50}); their names, ranges and words in lab.list ----

    set(values) {
        for (const [name, value] of Object.entries(values)) {
            if (name === 'steps') this.must('web_steps', (this.steps = value))
            else this.must('web_set', name, typeof value === 'string' ? this.numberOf(name, value) : Number(value))
        }
    }

    numberOf(name, word) {
        const number = (this.list[name] || []).indexOf(word)
        if (number < 0) throw new Error(`${name}: there is no '${word}'`)
        return number
    }

    // A word where lab.list has words for it, a number otherwise.
    get(name) {
        const value = this.call('web_get', name)
        return this.list[name] ? this.list[name][value] : value
    }

    // {name: value} of all parameters, and the steps that were chosen.
    all() {
        return {steps: this.steps || '', ...Object.fromEntries(this.list.parameters.map(({name}) => [name, this.call('web_get', name)]))}
    }

    // ---- runs ----

    // All photons that are asked for, at once.
    trace() {
        this.run('photons')
    }

    // 'photons', or what a view shows (lab.shows()), or 'render'; or one part of it: parts in their order give the same.
    run(kind, part = 0, parts = 1) {
        if (part === 0) this.begin(kind)
        this.must('web_run', this.list.runs.indexOf(kind), part, parts)
    }

    // What runs of this kind have found is forgotten.
    begin(kind) {
        if (this.canvas && kind !== 'photons') this.must('web_open_canvas')
        this.call('web_begin', this.list.runs.indexOf(kind))
    }

    // The kind of run that the present view shows.
    shows() {
        return this.list.shows[this.call('web_get', 'view')]
    }

    // Called with what a run finds, as it finds it: two pieces of memory. Here it goes into this instance; a worker gives it
    // to another's receive.
    sent(run, kind, first, firstSize, rest, restSize) {
        const whole = restSize ? this.put(this.joined(first, firstSize, rest, restSize)) : first
        this.must('web_receive', run, kind, whole, firstSize + restSize)
        if (restSize) this.exports.free(whole)
    }

    joined(first, firstSize, rest, restSize) {
        const bytes = new Uint8Array(firstSize + restSize)
        bytes.set(this.bytes().subarray(first, first + firstSize))
        bytes.set(this.bytes().subarray(rest, rest + restSize), firstSize)
        return bytes.buffer
    }

    receive({run, kind, bytes}) {
        const at = this.put(bytes)
        this.must('web_receive', run, kind, at, bytes.byteLength)
        this.exports.free(at)
    }

    // Some part of a run is done, 0…1.
    beat() {}

    // What the module's code writes to the terminal.
    print(text) {
        console.log(text)
    }

    // {photons, legs, emitted, segments, passes}: how many there are by now.
    collected() {
        const numbers = new Float64Array(this.exports.memory.buffer, this.call('web_collected'), COLLECTED.length)
        return Object.fromEntries(COLLECTED.map((name, i) => [name, numbers[i]]))
    }

    // What right steps never do, a line each.
    oddities() {
        return this.text(this.call('web_oddities'))
    }

    // All photons as the bytes of a file: 'photons.ply' or 'photons.csv'.
    photonFile(name) {
        this.must('web_write_photons', name)
        const at = this.call('web_file', name)
        return this.bytes().slice(at, at + this.call('web_file_size', name))
    }

    // ---- the picture ----

    // What was collected by now is drawn from now on.
    show() {
        this.must('web_show')
    }

    // As large as canvas.width × canvas.height; no words in it.
    draw() {
        this.must('web_draw', this.canvas.width, this.canvas.height)
    }

    // What the picture shows, in words.
    describe() {
        return this.text(this.call('web_describe'))
    }

    // What its colours mean: [['#rrggbb', 'words'], …].
    legend() {
        return JSON.parse(this.text(this.call('web_legend')))
    }

    // By heights of the picture, as the scene follows the hand; zoom below 1: nearer.
    turn(right, down) {
        this.call('web_turn', right, down)
    }
    move(right, down) {
        this.call('web_move', right, down)
    }
    zoom(factor) {
        this.call('web_zoom', factor)
    }
    frame() {
        this.call('web_frame', this.canvas.width / this.canvas.height)
    }
    home() {
        this.call('web_home')
    }
    choose(sideways, step) {
        this.call('web_choose', sideways, step)
    }
}
