// Photons by workers, a core each: parts of a pass, taken in their order, so that the photons are the same however many
// workers there are. A worker that does not answer within LIMIT milliseconds is ended, and what it did is told.

const LIMIT = 2000
const FIRST_PART = 500 // paths; later ones take about PART_TIME
const PART_TIME = 60 // ms

class PhotonlabWorkers {
    // The classes above as they stand in the page, in a worker of its own: pages from a disk may not load files.
    constructor(compiled, count = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 8))) {
        const source = [photonlabWasi, Photonlab, photonlabWorker].map(String)
        source.push(`const COLLECTED = ${JSON.stringify(COLLECTED)}`, 'photonlabWorker()')
        this.url = URL.createObjectURL(new Blob([source.join('\n')], {type: 'text/javascript'}))
        this.compiled = compiled
        this.workers = Array.from({length: count}, () => null)
        this.ids = 0
        this.run = 0
    }

    // `scene`: {yaml, name, files}, the same object while it is the same scene. `take` is called with each part, in their
    // order. Resolves when all are there, or with false when another pass has begun meanwhile; rejects with a fault.
    async trace(scene, settings, photons, take) {
        const run = ++this.run
        let next = 0, part = FIRST_PART, taken = 0, failure = null
        const waiting = new Map() // by their first path
        const work = async i => {
            while (next < photons && run === this.run && !failure) {
                const first = next, last = Math.min(first + part, photons), began = performance.now()
                next = last
                const answer = await this.ask(i, scene, {what: 'trace', settings, first, last})
                if (run !== this.run) return
                waiting.set(first, answer)
                for (let at; (at = waiting.get(taken)); taken = at.last) {
                    waiting.delete(taken)
                    take(at)
                }
                const speed = (last - first) / Math.max(performance.now() - began, 0.1)
                part = Math.round(Math.min(speed * PART_TIME, 2 * part, 50000)) || 1
            }
        }
        const all = this.workers.map((worker, i) => work(i).catch(error => (failure ||= error)))
        await Promise.all(all)
        if (failure && run === this.run) throw failure
        return run === this.run
    }

    // What is under way is of no interest any more.
    stop() {
        this.run++
    }

    // Worker number i is asked, with this scene loaded; it is started when it does not run. It does one after the other, so
    // that nothing can come between the scene and the question.
    ask(i, scene, message) {
        const questions = []
        if (!this.workers[i]) {
            const worker = new Worker(this.url)
            this.workers[i] = {worker, scene: null, asked: new Map(), clock: 0}
            worker.onmessage = ({data}) => this.answered(i, data)
            worker.onerror = event => this.end(i, event.message || 'the worker failed')
            questions.push(this.send(i, {what: 'open', compiled: this.compiled}, 5 * LIMIT))
        }
        if (this.workers[i].scene !== scene) {
            this.workers[i].scene = scene
            questions.push(this.send(i, {what: 'scene', ...scene}, 5 * LIMIT))
        }
        questions.push(this.send(i, message, LIMIT))
        return Promise.all(questions).then(answers => answers.at(-1))
    }

    send(i, message, limit) {
        const id = ++this.ids, {worker, asked} = this.workers[i]
        return new Promise((resolve, reject) => {
            asked.set(id, {resolve, reject, limit})
            if (asked.size === 1) this.watch(i)
            worker.postMessage({...message, id})
        })
    }

    // From now on the time of the question runs that is answered next.
    watch(i) {
        const {asked} = this.workers[i], [next] = asked.values()
        clearTimeout(this.workers[i].clock)
        if (next) this.workers[i].clock = setTimeout(() => this.end(i, `no answer for ${next.limit / 1000} s: an endless loop?`), next.limit)
    }

    answered(i, {id, fault, ...answer}) {
        const {asked} = this.workers[i], waiting = asked.get(id)
        asked.delete(id)
        this.watch(i)
        if (fault === undefined) waiting.resolve(answer)
        else waiting.reject(new Error(fault))
    }

    end(i, why) {
        const {worker, asked, clock} = this.workers[i]
        clearTimeout(clock)
        worker.terminate()
        this.workers[i] = null
        for (const {reject} of asked.values()) reject(new Error(why))
    }
}
