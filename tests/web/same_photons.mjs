// Are the photons of the module those of the program, to the byte? Usage: node same_photons.mjs PROGRAM MODULE.wasm
// Also when they are traced in parts, as the page does.
import {execFileSync} from 'node:child_process'
import fs from 'node:fs'
import os from 'node:os'
import path from 'node:path'
import {openModule} from './module.mjs'

const [program, wasm] = process.argv.slice(2)
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'same-photons-'))
const PHOTONS = 50000, PARTS = 7
let passed = 0, failed = 0

function native(scene, seed, spectral) {
    const file = path.join(folder, 'native.ply')
    execFileSync(program, ['photons', scene, '-o', file, '--photons', PHOTONS, '--seed', seed, '--quiet', ...(spectral ? ['--spectral'] : [])])
    return fs.readFileSync(file)
}

async function inModule(scene, seed, spectral) {
    const lab = await openModule(wasm)
    lab.scene(fs.readFileSync(scene, 'utf8'), scene)
    lab.set({photons: PHOTONS, seed, ...(spectral && {spectral: 1})})
    for (let part = 0; part < PARTS; part++) lab.run('photons', part, PARTS)
    return Buffer.from(lab.photonFile('photons.ply'))
}

for (const name of ['box_glass', 'box_glossy', 'prism', 'diamond', 'ring', 'sodium', 'prism spectral', 'raindrop spectral'])
    for (const seed of ['1', '20260131']) {
        const [stem, spectral] = name.split(' '), scene = `scenes/${stem}.yaml`
        const same = native(scene, seed, spectral).equals(await inModule(scene, Number(seed), spectral))
        console.log(`${same ? '✓' : '✗'} ${name}, seed ${seed}: ${same ? 'the same photons' : 'other photons'}`)
        same ? passed++ : failed++
    }
fs.rmSync(folder, {recursive: true})
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed ? 1 : 0)
