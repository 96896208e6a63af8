// How fast is the lab? Usage: node bench_lab.mjs PROGRAM SITE TOOLS
// Processor time, of the program and of all of a browser's processes, so that what else the machine does hardly counts; two
// cores, which share a frame, need half of it by the clock.
import {execFileSync} from 'node:child_process'
import fs from 'node:fs'
import path from 'node:path'
import {installed, launch, median, processorSeconds} from './browsers.mjs'

const [program, site, tools] = process.argv.slice(2)
const ROUNDS = 5, PHOTONS = 500000, FRAMES = 40, FILE = '/tmp/bench_lab.ply'

function nativeSeconds(scene) {
    const command = `TIMEFORMAT=%U; { time ${program} photons scenes/${scene} -o ${FILE} --photons ${PHOTONS} --threads 1 --quiet; } 2>&1`
    return Number(execFileSync('bash', ['-c', command], {encoding: 'utf8'}))
}

const inPage = (page, scene) => page.evaluate(async (scene, photons) => {
    state.workers.stop('photons')
    const compiled = await Photonlab.compile(), lab = await Photonlab.open(compiled)
    for (const [name, bytes] of state.files) lab.file(name, bytes)
    lab.scene(scenes[scene], scene)
    lab.set({photons, paths: 0})
    lab.trace()
}, scene, PHOTONS)

// Seconds from the page's beginning until there are photons in its picture.
async function opening(page) {
    await page.goto('about:blank')
    await page.goto(`file://${path.resolve(site)}/lab.html`, {waitUntil: 'domcontentloaded'})
    const milliseconds = await page.evaluate(() => new Promise(resolve => {
        const before = draw
        draw = now => {
            before(now)
            if (!state.shown) return
            draw = before
            document.getElementById('picture').getContext('webgl2').finish()
            resolve(performance.now())
        }
    }))
    await page.waitForFunction(() => state.seconds > 0, {timeout: 120000})
    return milliseconds / 1000
}

// The same in browsers that have never opened it, nor anything else: at once, and after some seconds, as long as people take.
async function coldOpenings(name, rest) {
    const seconds = []
    for (let round = 0; round < ROUNDS; round++) {
        const browser = await launch(name, tools), page = await browser.newPage()
        await page.setViewport({width: 1600, height: 1000})
        await new Promise(resolve => setTimeout(resolve, 1000 * rest))
        seconds.push(await opening(page))
        await browser.close()
    }
    return `${median(seconds).toFixed(2)} s (${Math.min(...seconds).toFixed(2)} to ${Math.max(...seconds).toFixed(2)})`
}

// Turns the scene for so many seconds, with so many points or as many as the lab chooses; then lets it rest.
const orbit = (page, points, seconds) => page.evaluate(async (points, seconds) => {
    const gl = document.getElementById('picture').getContext('webgl2'), one = new Uint8Array(4)
    const drawn = [], began = performance.now(), finished = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one)
    if (points) keepPace = () => { state.points = points }
    while (performance.now() - began < 1000 * seconds) {
        state.lab.turn(0.01, 0)
        moved()
        await new Promise(requestAnimationFrame) // which waits for the frames before
        drawn.push(state.points)
    }
    finished()
    const ended = performance.now()
    while (state.lab.get('most_points')) await new Promise(requestAnimationFrame)
    finished()
    const {width, height} = gl.canvas
    return {width, height, rate: drawn.length / (ended - began) * 1000, points: drawn.at(-1), rest: performance.now() - ended}
}, points, seconds)

// Draws frame after frame, each read back, as turning the scene does.
const frames = (page, points) => page.evaluate((points, count) => {
    const {lab} = state, canvas = document.getElementById('picture'), gl = canvas.getContext('webgl2'), one = new Uint8Array(4)
    Object.assign(canvas, {width: 1280, height: 720})
    lab.set({most_points: points})
    for (let i = 0; i < count; i++) {
        lab.turn(0.01, 0)
        lab.draw()
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one)
    }
}, points, FRAMES)

for (const name of installed()) {
    const browser = await launch(name, tools), page = await browser.newPage()
    const used = async act => {
        const before = processorSeconds(browser.process().pid)
        await act()
        return processorSeconds(browser.process().pid) - before
    }
    await page.setViewport({width: 1600, height: 1000})
    const opened = []
    for (let round = 0; round < ROUNDS; round++) opened.push(await opening(page))
    console.log(`${name}: first photons drawn ${median(opened).toFixed(2)} s after opening (median of ${ROUNDS}); in a new browser, never used, ` +
        `${await coldOpenings(name, 2)}; in one that is itself just starting ${await coldOpenings(name, 0)}`)
    await page.addStyleTag({content: '#stage { position: fixed; inset: 0 auto auto 0; width: 1280px; height: 720px; max-height: none }'})
    for (const points of [0, 50000]) {
        const {width, height, rate, points: drawn, rest} = await orbit(page, points, 4)
        console.log(`${name}: turned at ${rate.toFixed(0)} frames a second, ${width} x ${height}, with ${drawn} points${points ? '' : ', as many as the lab chooses'}; ` +
            `all of them ${(rest / 1000).toFixed(2)} s after coming to rest (by the clock: worth something on an idle machine)`)
    }
    for (const scene of ['box_glass.yaml', 'box_glossy.yaml', 'prism.yaml']) {
        const ratios = []
        for (let round = 0; round < ROUNDS; round++)
            ratios.push(nativeSeconds(scene) / await used(() => inPage(page, scene)))
        console.log(`${name}: ${scene}: paths a second in the page are ${median(ratios).toFixed(2)} of the program's on one thread`)
    }
    for (const points of [50000, 0]) {
        const seconds = await used(() => frames(page, points))
        console.log(`${name}: ${points || 'all 268 000'} points at 1280 x 720: ${(1000 * seconds / FRAMES).toFixed(0)} ms of processor time a frame`)
    }
    await browser.close()
}
fs.rmSync(FILE, {force: true})
