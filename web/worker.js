// What a worker does: runs steps, in an instance of the module of its own, and gives away what they find.

async function photonlabWorker() {
    let lab = null, id = 0
    const answers = {
        open: async ({compiled}) => {
            lab = await Photonlab.open(compiled)
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
            lab.set(settings)
            lab.run(kind, part, parts)
        },
    }
    let before = Promise.resolve() // one after the other
    onmessage = ({data}) => {
        before = before.then(async () => {
            id = data.id
            try {
                await answers[data.what](data)
                postMessage({id, done: true})
            } catch (error) {
                postMessage({id, fault: error.message, stack: error.stack, trap: error instanceof WebAssembly.RuntimeError})
            }
        })
    }
}
