// The module outside a browser: opens build/web/photonlab.wasm as a page does. Node.js 18 or later.
import fs from 'node:fs'

const parts = ['gl.js', 'wasi.js', 'photonlab.js'].map(name => fs.readFileSync(`web/page/${name}`, 'utf8'))
export const Photonlab = new Function(`${parts.join('\n')}\nreturn Photonlab`)()

// An instance with the meshes of scenes/; it draws nothing.
export async function openModule(path) {
    const lab = await Photonlab.open(await WebAssembly.compile(fs.readFileSync(path)))
    for (const name of fs.readdirSync('scenes/meshes')) lab.file(`meshes/${name}`, fs.readFileSync(`scenes/meshes/${name}`))
    return lab
}
