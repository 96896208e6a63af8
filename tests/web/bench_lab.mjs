// How fast is the lab? Usage: node bench_lab.mjs PROGRAM SITE TOOLS
// Native and page by turns, so that what else the machine does falls on both.
import {execFileSync} from 'node:child_process'
import path from 'node:path'
import {installed, launch} from './browsers.mjs'

const [program, site, tools] = process.argv.slice(2)
const ROUNDS = 5, PHOTONS = 100000, FRAMES = 40
const median = list => list.sort((a, b) => a - b)[list.length >> 1]

function nativeSeconds(scene) {
    const json = execFileSync(program, ['photons', `scenes/${scene}`, '-o', '/tmp/bench_lab.ply', '--photons', PHOTONS, '--threads', '1', '--quiet', '--json'])
    return JSON.parse(json).seconds
}

const inPage = (page, scene) => page.evaluate(async (scene, photons) => {
    state.workers.stop('photons')
    const compiled = await Photonlab.compile(), lab = await Photonlab.open(compiled)
    for (const [name, bytes] of state.files) lab.file(name, bytes)
    lab.scene(scenes[scene], scene)
    lab.set({photons, paths: 0})
    const began = performance.now()
    lab.trace()
    return (performance.now() - began) / 1000
}, scene, PHOTONS)

// Draws frame after frame, each read back, as turning the scene does.
const frames = (page, points) => page.evaluate((points, count) => {
    const {lab} = state, canvas = document.getElementById('picture'), gl = canvas.getContext('webgl2'), one = new Uint8Array(4)
    Object.assign(canvas, {width: 1280, height: 720})
    lab.set({most_points: points})
    const times = []
    for (let i = 0; i < count; i++) {
        const began = performance.now()
        lab.turn(0.01, 0)
        lab.draw()
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one)
        times.push(performance.now() - began)
    }
    return times
}, points, FRAMES)

for (const name of installed()) {
    const browser = await launch(name, tools), page = await browser.newPage()
    await page.setViewport({width: 1280, height: 900})
    const began = performance.now()
    await page.goto(`file://${path.resolve(site)}/lab.html`)
    await page.waitForFunction(() => state.lab && state.lab.collected().photons > 0, {polling: 10})
    console.log(`${name}: first photons ${((performance.now() - began) / 1000).toFixed(2)} s after opening`)
    await page.waitForFunction(() => state.seconds > 0, {timeout: 120000})
    for (const scene of ['box_glass.yaml', 'box_glossy.yaml', 'prism.yaml']) {
        const ratios = []
        for (let round = 0; round < ROUNDS; round++) {
            const before = nativeSeconds(scene), page_ = await inPage(page, scene), after = nativeSeconds(scene)
            ratios.push((before + after) / 2 / page_)
        }
        console.log(`${name}: ${scene}: paths a second in the page are ${median(ratios).toFixed(2)} of the program's on one thread`)
    }
    for (const points of [50000, 0]) {
        const times = await frames(page, points)
        console.log(`${name}: ${points || 'all 268 000'} points at 1280 x 720: ${median(times).toFixed(1)} ms a frame (median of ${FRAMES})`)
    }
    await browser.close()
}
