// Pictures and photons as files, and a link that holds the state: scene, camera, and everything that was set.

function download(name, blob) {
    const link = element('a', {download: name, href: URL.createObjectURL(blob)})
    link.click()
    setTimeout(() => URL.revokeObjectURL(link.href), 60000)
}

const stem = () => $('scene').value.replace(/\.yaml$/, '')

function savePicture() {
    state.lab.draw()
    $('picture').toBlob(blob => download(`${stem()}.png`, blob))
}

function savePhotons() {
    download(`${stem()}.ply`, new Blob([state.lab.photonFile('photons.ply')]))
}

// ---- the link ----

async function through(stream, bytes) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer())
}

const toText = bytes => btoa(String.fromCharCode(...bytes)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '')
const toBytes = text => Uint8Array.from(atob(text.replace(/-/g, '+').replace(/_/g, '/')), letter => letter.charCodeAt(0))

// {scene, yaml where it was changed, parameters}: packed, behind the #.
async function stateText() {
    const yaml = $('yaml').value, name = $('scene').value
    const parameters = Object.fromEntries(Object.entries(state.lab.all()).filter(([key]) => !NOT_SHARED.includes(key)))
    const all = {scene: name, ...(yaml === scenes[name] ? {} : {yaml}), parameters}
    return toText(await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(JSON.stringify(all))))
}
const NOT_SHARED = ['most_points', 'rendered', 'width', 'height', 'passes', 'flight']

// What a link holds; null where there is none, or none that can be read.
async function stateOf(text) {
    try {
        return text ? JSON.parse(new TextDecoder().decode(await through(new DecompressionStream('deflate-raw'), toBytes(text)))) : null
    } catch (error) {
        fault('The link holds no state of the lab; this is how it begins.')
        return null
    }
}

async function share() {
    history.replaceState(null, '', '#' + (await stateText()))
    try {
        await navigator.clipboard.writeText(location.href)
        say('The link was copied.')
    } catch (error) {
        say('The link stands in the address bar.')
    }
}
