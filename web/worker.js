// What a worker does: traces photons, in an instance of the module of its own, and gives them away.

async function photonlabWorker() {
    let lab = null
    const answers = {
        open: async ({compiled}) => {
            lab = await Photonlab.open(compiled)
        },
        scene: async ({yaml, name, files}) => {
            for (const [path, bytes] of files) lab.file(path, bytes)
            lab.scene(yaml, name)
        },
        trace: async ({settings, first, last}) => {
            lab.set(settings)
            lab.trace(first, last)
            return lab.give()
        },
    }
    let before = Promise.resolve() // one after the other
    onmessage = ({data}) => {
        before = before.then(async () => {
            try {
                const answer = (await answers[data.what](data)) || {}
                postMessage({...answer, id: data.id}, [answer.photons, answer.legs].filter(Boolean))
            } catch (error) {
                postMessage({id: data.id, fault: error.message})
            }
        })
    }
}
