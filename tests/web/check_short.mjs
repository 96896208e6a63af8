// The least that must go in a browser, in seconds: the lab opens from the disk with the program's photons, follows mouse and
// keys, and a live figure moves. check-site does the rest. Usage: node check_short.mjs PROGRAM LAB.html MODULE.wasm TOOLS
import {execFileSync} from 'node:child_process'
import fs from 'node:fs'
import os from 'node:os'
import path from 'node:path'
import {installed, launch} from './browsers.mjs'

const [program, lab, wasm, tools] = process.argv.slice(2), name = installed()[0], PHOTONS = 20000
let passed = 0, failed = 0
function check(what, fine, found = '') {
    fine ? passed++ : failed++
    console.log(`${fine ? '✓' : '✗'} ${name}: ${what}${fine ? '' : `: ${found}`}`)
}
if (!name) {
    console.log('○ no browser here: the lab was not opened\n0 passed, 0 failed')
    process.exit(0)
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'check-short-')), file = path.join(folder, 'photons.ply'), figure = path.join(folder, 'figure.html')
execFileSync(program, ['photons', 'scenes/box_glass.yaml', '-o', file, '--photons', PHOTONS, '--quiet'])
fs.writeFileSync(figure, '<!DOCTYPE html>\n<link rel="icon" href="data:,">\n<body>\n<figure><div class="live" data-live="roulette"></div></figure>\n</body>\n')
fs.writeFileSync(figure, execFileSync('sh', ['web/figures/add_figures.sh', wasm, figure]))

const browser = await launch(name, tools), page = await browser.newPage(), said = []
page.on('console', message => said.push(message.text()))
page.on('pageerror', error => said.push(error.message))
await page.setViewport({width: 640, height: 480})
await page.goto(`file://${path.resolve(lab)}`)
const settled = () => page.waitForFunction(() => state.seconds > 0, {timeout: 60000})
await settled()
await page.evaluate(photons => {
    state.seconds = 0
    state.lab.set({photons})
    tracePhotons()
}, PHOTONS)
await settled()
const photons = Buffer.from(await page.evaluate(() => [...new Uint8Array(state.lab.photonFile('x.ply'))]))
check('from the disk, the program’s photons to the byte', photons.equals(fs.readFileSync(file)), `${photons.length} bytes`)
const picture = () => page.evaluate(() => {
    state.rested = 0
    draw(0)
    return document.getElementById('picture').toDataURL()
})
const before = await picture(), canvas = await page.$('#picture'), box = await canvas.boundingBox()
await page.mouse.move(box.x + 100, box.y + 100)
await page.mouse.down()
await page.mouse.move(box.x + 160, box.y + 100, {steps: 2})
await page.mouse.up()
check('the mouse turns the picture', (await picture()) !== before)
await canvas.focus()
await page.keyboard.press('0')
check('0 puts it back', (await picture()) === before)

await page.goto(`file://${figure}`)
const numbers = () => page.$eval('.live', place => place.dataset.numbers)
await page.waitForFunction(() => document.querySelector('.live').dataset.numbers, {timeout: 60000})
const first = await numbers()
await page.focus('.live input')
await page.keyboard.press('End')
await page.waitForFunction(first => document.querySelector('.live').dataset.numbers !== first, {timeout: 10000}, first).catch(() => 0)
check('a live figure moves by its keys', (await numbers()) !== first, first)
check('nothing in the console', said.length === 0, said)
await browser.close()
fs.rmSync(folder, {recursive: true})
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed ? 1 : 0)
