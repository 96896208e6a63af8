// Runs by workers, a core each: parts of one, whose messages are given in the parts' order, so that what is found is the same
// however many workers there are. A worker that gives no sign of life for LIMIT milliseconds is ended, and that is told.

const LIMIT = 2000
const LIMITS = {open: 10000, scene: 10000, run: LIMIT}

class PhotonlabWorkers {
    // The classes above as they stand in the page, in a worker of its own: pages from a disk may not load files.
    // `students`: the ids of the steps that are a student's.
    constructor(compiled, students = '', count = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 8))) {
        const source = [photonlabWasi, Photonlab, photonlabWorker].map(String)
        source.push(`const COLLECTED = ${JSON.stringify(COLLECTED)}, PRINTED = ${PRINTED}, TRAPS = [${TRAPS.map(([pattern, why]) => `[${pattern}, '${why}']`)}]`, 'photonlabWorker()')
        this.url = URL.createObjectURL(new Blob([source.join('\n')], {type: 'text/javascript'}))
        Object.assign(this, {compiled, students})
        this.workers = Array.from({length: count}, () => null)
        this.ids = 0
        this.runs = {} // by kind: the number of the last one
        this.startAll()
    }

    // `scene`: {yaml, name, files}, the same object while it is the same scene. `settings`: lab.all(). `receive` is called with
    // each message, in order. Resolves to true when all is there, or to false when another run of its kind has begun, or
    // stop(kind) was called, meanwhile; rejects with a fault.
    async run(kind, scene, settings, parts, receive) {
        const run = (this.runs[kind] = (this.runs[kind] || 0) + 1), present = () => run === this.runs[kind]
        let next = 0, turn = 0, failure = null
        const waiting = Array.from({length: parts}, () => []), done = new Set()
        const take = (part, message) => {
            if (!present()) return
            if (part === turn) receive(message)
            else waiting[part].push(message)
        }
        const finish = part => {
            done.add(part)
            while (present() && done.has(turn)) (waiting[++turn] || []).splice(0).forEach(receive)
        }
        const work = async i => {
            while (next < parts && present() && !failure) {
                const part = next++
                await this.ask(i, scene, {what: 'run', settings, kind, part, parts}, message => take(part, message))
                finish(part)
            }
        }
        await Promise.all(this.workers.slice(0, parts).map((worker, i) => work(i).catch(error => (failure ||= error))))
        if (failure && present()) throw failure
        return present()
    }

    // What is under way is of no interest any more; what may take long is ended.
    stop(kind) {
        this.runs[kind] = (this.runs[kind] || 0) + 1
        this.workers.forEach((worker, i) => {
            if (worker && [...worker.asked.values()].some(question => question.kind === kind && kind !== 'photons')) this.end(i, 'stopped')
        })
    }

    startAll() {
        this.workers.forEach((worker, i) => this.start(i).catch(() => {})) // who asks it is told
    }

    start(i) {
        const worker = new Worker(this.url)
        this.workers[i] = {worker, scene: null, asked: new Map(), clock: 0}
        worker.onmessage = ({data}) => this.workers[i] && this.workers[i].worker === worker && this.hear(i, data)
        worker.onerror = event => this.end(i, event.message || 'the worker failed')
        return this.send(i, {what: 'open', compiled: this.compiled, students: this.students})
    }

    // Worker number i is asked, with this scene loaded; it is started when it does not run. It does one after the other, so
    // that nothing can come between the scene and the question.
    ask(i, scene, question, receive) {
        const questions = this.workers[i] ? [] : [this.start(i)]
        if (this.workers[i].scene !== scene) {
            this.workers[i].scene = scene
            questions.push(this.send(i, {what: 'scene', ...scene}))
        }
        questions.push(this.send(i, question, receive))
        return Promise.all(questions)
    }

    send(i, question, receive) {
        const id = ++this.ids, {worker, asked} = this.workers[i], {kind} = question
        const limit = LIMITS[question.what] * (kind && kind !== 'photons' && kind !== 'lobe' ? 5 : 1) // pictures
        return new Promise((resolve, reject) => {
            asked.set(id, {resolve, reject, receive, limit, kind})
            if (asked.size === 1) this.watch(i)
            worker.postMessage({...question, id})
        })
    }

    // From now on the time of the question runs that is worked on.
    watch(i) {
        const {asked} = this.workers[i], [now] = asked.values()
        clearTimeout(this.workers[i].clock)
        if (now) this.workers[i].clock = setTimeout(() => this.end(i, `no sign of life for ${now.limit / 1000} s: an endless loop?`, {why: 'loop', offsets: [], megabytes: 0}), now.limit)
    }

    // What steps print.
    print(text) {
        console.log(text)
    }

    // From now on by another module. Whatever runs is ended.
    replace(compiled, students) {
        Object.assign(this, {compiled, students})
        for (const kind in this.runs) this.runs[kind]++
        this.workers.forEach((worker, i) => worker && this.end(i, 'replaced'))
        this.startAll()
    }

    hear(i, {id, message, print, done, fault, trap}) {
        if (print !== undefined) return this.print(print)
        const {asked} = this.workers[i], question = asked.get(id)
        if (message) question.receive(message)
        if (done || fault !== undefined) asked.delete(id)
        if (this.workers[i]) this.watch(i)
        if (done) question.resolve()
        else if (fault !== undefined) question.reject(Object.assign(new Error(fault), {trap}))
        if (trap) this.end(i, fault) // its memory may be anything now
    }

    end(i, why, trap = null) {
        const {worker, asked, clock} = this.workers[i]
        clearTimeout(clock)
        worker.terminate()
        this.workers[i] = null
        for (const {reject} of asked.values()) reject(Object.assign(new Error(why), {trap}))
    }
}
