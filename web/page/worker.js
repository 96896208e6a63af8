// What a worker does: runs steps, in an instance of the module of its own, and gives away what they find.
const PRINTED = 100 // lines of a run that are shown
// A browser's words for a trap.
const TRAPS = [[/divi/, 'divide'], [/out of bounds/, 'bounds']]

async function photonlabWorker() {
    let lab = null, id = 0, lines = 0 // that were printed
    Error.stackTraceLimit = 30
    const answers = {
        open: async ({compiled, students}) => {
            lab = await Photonlab.open(compiled)
            lab.call('web_students', students)
            lab.print = text => lines++ < PRINTED && postMessage({id, print: text})
            lab.sent = (run, kind, ...pieces) => {
                const bytes = lab.joined(...pieces)
                postMessage({id, message: {run, kind, bytes}}, [bytes])
            }
            lab.beat = fraction => postMessage({id, fraction})
        },
        scene: async ({yaml, name, files}) => {
            for (const [path, bytes] of files) lab.file(path, bytes)
            lab.scene(yaml, name)
        },
        run: async ({settings, kind, part, parts}) => {
            lines = 0
            lab.set(settings)
            lab.run(kind, part, parts)
        },
    }
    // Why code of steps ended in the midst of it, and all that tells where; null: it has answered.
    const describeTrap = error => {
        const {__stack_pointer: stackPointer, memory} = lab ? lab.exports : {}
        const overflow = error instanceof RangeError || error.name === 'InternalError' || (stackPointer && stackPointer.value < 0)
        if (!overflow && !error.why && !(error instanceof WebAssembly.RuntimeError)) return null
        const offsets = [...String(error.stack).matchAll(/wasm-function\[\d+\]:0x([0-9a-f]+)/g)].map(match => match[1])
        const aborted = /^(.*\n)?\s*(at )?abort\b/.test(error.stack)
        const why = overflow ? 'stack' : error.why || (aborted ? 'abort' : (TRAPS.find(([pattern]) => pattern.test(error.message)) || [0, 'trap'])[1])
        return {why, offsets, megabytes: memory ? memory.buffer.byteLength >> 20 : 0}
    }
    let before = Promise.resolve() // one after the other
    onmessage = ({data}) => {
        before = before.then(async () => {
            id = data.id
            try {
                await answers[data.what](data)
                postMessage({id, done: true})
            } catch (error) {
                postMessage({id, fault: error.message, trap: describeTrap(error)})
            }
        })
    }
}
