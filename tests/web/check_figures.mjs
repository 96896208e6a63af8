// The live figures of the notes in real browsers: each control moved by its keys, each picture by the mouse; what they say is
// read back as numbers. Usage: node check_figures.mjs SITE TOOLS SHOTS [CHAPTER]
import fs from 'node:fs'
import path from 'node:path'
import {gzipSync} from 'node:zlib'
import {installed, launch} from './browsers.mjs'

const [site, tools, shots, only = ''] = process.argv.slice(2)
let passed = 0, failed = 0
function check(what, fine, found = '') {
    fine ? passed++ : failed++
    console.log(`${fine ? '✓' : '✗'} ${what}${fine ? '' : `: ${JSON.stringify(found)}`}`)
}
const near = (found, expected, off) => Math.abs(found - expected) <= off

// What a figure says when it is set so: [values, whether its numbers are right].
const FACTS = {
    roulette: [[{rho: 0.5, paths: 20000}, n => near(n.mean, 2, 5 * n.error) && near(n.rays, 2, 0.1)]],
    search: [[{step: 60, k: 12, x: 0.3, y: 0.35}, n => n.step === n.boxes && n.radius < 0.1]],
    estimate: [[{k: 400, radius: 0.4, photons: 30000, x: -0.15}, n => n.noise < 0.06], [{k: 5, radius: 0.4, photons: 30000, x: -0.15}, n => n.noise > 0.2]],
    lobe: [[{n: 20, theta: 60, scheme: '2.3 the source text’s'}, n => near(n.albedo, 1, 1e-6)], [{n: 1000, theta: 0, scheme: '2.4 modified Phong'}, n => near(n.albedo, 1, 0.01)]],
    misprint: [[{n: 20, z: '1 − u^(1/(n+1)), as in the prose'}, n => n.angle > 75], [{n: 20, z: 'u^(1/(n+1)), as in the code'}, n => n.angle < 20]],
    albedo: [[{n: 20, theta: 88}, n => near(n.source, 1, 1e-6) && near(n.phong, 0.1, 0.06)]],
    surface: [[{angle: 0, index: 1.5, way: 'from the air'}, n => near(n.reflected, 0.04, 1e-4)], [{angle: 42, index: 1.5, way: 'from inside the glass'}, n => n.out === null && n.reflected === 1]],
    prism: [[{incidence: 63.6, apex: 60, glass: 'N-SF11'}, n => near(n.turned[1], 67.187, 0.01)], [{incidence: 51.5, apex: 60}, n => n.leave === 1 && n.turned[0] !== null],
        [{incidence: 45, apex: 60}, n => n.leave === 0]],
    drop: [[{b: 0.86, nm: 650}, n => near(n.bow, 42.3, 0.2)], [{b: 0.86, nm: 400}, n => near(n.bow, 40.6, 0.3)]],
    disk: [[{passes: 2000, alpha: 0.67, radius: 0.1, x: 0.04}, n => near(n.radius, 0.1 * 2000 ** (-0.33 / 2), 0.002) && near(n.mean, n.right, 0.02)],
        [{passes: 500, alpha: 1, radius: 0.1, x: 0.09}, n => near(n.radius, 0.1, 1e-6) && n.mean < n.right - 0.1]],
    spectrum: [[{nm: 520, glass: 'N-BK7'}, n => n.r < 0 && n.g > 1 && near(n.index, 1.5202, 3e-4)]],
}

const numbers = async place => JSON.parse((await place.evaluate(e => e.dataset.numbers)) || 'null')
const still = page => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))))

async function tryFigure(page, place, name, where) {
    await place.evaluate(e => e.parentElement.scrollIntoView({block: 'center'}))
    await page.waitForFunction(e => e.dataset.numbers, {timeout: 90000}, place).catch(() => 0)
    const first = await numbers(place)
    check(`${where}: opens`, first !== null, await place.evaluate(e => e.textContent))
    if (!first) return
    for (const control of await place.$$('input, select')) {
        const [what, tag] = await control.evaluate(e => [e.name, e.tagName])
        await place.evaluate(e => e.live.set(Object.fromEntries(e.live.kind.controls.map(c => [c.name, c.value]))))
        await still(page)
        const before = await place.evaluate(e => e.dataset.numbers), moved = async () => (await place.evaluate(e => e.dataset.numbers)) !== before
        await control.focus()
        for (const key of tag === 'SELECT' ? ['ArrowUp', 'ArrowDown'] : ['Home', 'ArrowRight', 'End'])
            if (!(await moved())) {
                await page.keyboard.press(key)
                await still(page)
            }
        check(`${where}: ${what} by its keys`, await moved(), before)
    }
    const canvas = await place.$('canvas')
    await canvas.evaluate(c => c.scrollIntoView({block: 'center'}))
    await still(page)
    const box = await canvas.boundingBox()
    if (await place.evaluate(e => Boolean(figures[e.dataset.live].drag || figures[e.dataset.live].scene))) {
        const seen = () => place.evaluate(e => { // what a canvas shows is gone with its frame
            e.live.draw()
            return e.live.canvas.toDataURL()
        })
        const before = await seen()
        await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.4 * box.height)
        await page.mouse.down()
        await page.mouse.move(box.x + 0.62 * box.width, box.y + 0.55 * box.height, {steps: 3})
        await page.mouse.up()
        await still(page)
        check(`${where}: the picture follows the mouse`, (await seen()) !== before)
    }
    for (const [values, fine] of FACTS[name] || []) {
        await place.evaluate((e, values) => e.live.set(values), values)
        await still(page)
        const now = await numbers(place)
        check(`${where}: ${JSON.stringify(values)}`, fine(now), now)
    }
}

async function openPage(browser, name, viewport = {width: 1280, height: 900}) {
    const page = await browser.newPage(), said = []
    page.on('pageerror', error => said.push(error.message))
    page.on('console', message => message.type() === 'error' && said.push(message.text()))
    await page.setViewport(viewport)
    await page.goto(`file://${path.resolve(site, name)}`)
    return {page, said}
}

// Right and wrong over each other in the gallery.
async function tryTiles(browser, kind) {
    const {page, said} = await openPage(browser, 'gallery.html'), where = `${kind}, gallery`
    const pairs = await page.$$eval('.compared', all => all.map(e => {
        const [wrong, right] = e.querySelectorAll('img'), before = [...document.querySelectorAll('.tile.right img')].filter(i => i.src === right.src)
        const step = image => image.alt.split(',')[0]
        return wrong.naturalWidth === right.naturalWidth && wrong.naturalHeight === right.naturalHeight && before.some(i => step(i) === step(wrong))
    }))
    check(`${where}: ${pairs.length} wrong pictures lie below a right one of their step and size`, pairs.length > 200 && pairs.every(Boolean), pairs.indexOf(false))
    const place = await page.$('.compared'), slider = await page.$('.tile input'), share = () => slider.evaluate(e => Number(e.value))
    await place.evaluate(e => e.scrollIntoView({block: 'center'}))
    const before = await place.screenshot({encoding: 'base64'}), {x, y, width, height} = await place.boundingBox()
    await page.mouse.move(x + 0.2 * width, y + height / 2)
    await page.mouse.down()
    await page.mouse.move(x + 0.7 * width, y + height / 2, {steps: 3})
    await page.mouse.up()
    check(`${where}: the line follows the mouse`, near(await share(), 70, 2), await share())
    check(`${where}: and the picture changes`, (await place.screenshot({encoding: 'base64'})) !== before)
    await page.screenshot({path: `${shots}/gallery_${kind}_1280.png`})
    await slider.focus()
    await page.keyboard.press('Home')
    check(`${where}: the slider's keys move it`, (await share()) === 0, await share())
    check(`${where}: no error in the console`, said.length === 0, said)
    await page.close()
}

async function tryTilesByFinger(browser) {
    const {page} = await openPage(browser, 'gallery.html', {width: 400, height: 800, hasTouch: true})
    await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}])
    const place = await page.$('.compared')
    await place.evaluate(e => e.scrollIntoView({block: 'center'}))
    const {x, y, width} = await place.boundingBox()
    await page.touchscreen.touchStart(x + 5, y + 20)
    await page.touchscreen.touchMove(x + width / 2, y + 20)
    await page.touchscreen.touchEnd()
    const share = await page.$eval('.tile input', e => Number(e.value))
    check('gallery: the line follows a finger', near(share, 50, 3), share)
    await page.screenshot({path: `${shots}/gallery_400.png`})
    await page.close()
}

async function tryPage(browser, kind, chapter) {
    const {page, said} = await openPage(browser, chapter)
    const quiet = await page.$$eval('.live', places => places.filter(e => e.querySelector('canvas')).length)
    check(`${kind}, ${chapter}: quiet until it is scrolled to`, quiet <= 1, quiet)
    const places = await page.$$('.live')
    for (const [i, place] of places.entries()) {
        const name = await place.evaluate(e => e.dataset.live)
        await tryFigure(page, place, name, `${kind}, ${chapter.slice(0, 1)} ${name}`)
        if (kind === 'chromium')
            for (const [width, scheme] of [[1280, 'light'], [400, 'dark']]) {
                await page.setViewport({width, height: 900})
                await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}])
                await place.evaluate(e => e.parentElement.scrollIntoView({block: 'center'}))
                await new Promise(done => setTimeout(done, 150))
                await (await place.evaluateHandle(e => e.parentElement)).screenshot({path: `${shots}/figure_${chapter.slice(0, 1)}_${i}_${name}_${width}.png`})
                const juts = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth)
                check(`${chapter.slice(0, 1)} ${name}: fits ${width} px`, juts <= 0, juts)
            }
        await page.setViewport({width: 1280, height: 900})
    }
    check(`${kind}, ${chapter}: no error in the console`, said.length === 0, said)
    await page.close()
    return places.length
}

// What a disk, and a phone that loads it packed, have of a page.
function sizes() {
    for (const name of fs.readdirSync(site).filter(name => name.endsWith('.html'))) {
        const bytes = fs.readFileSync(path.join(site, name)), packed = gzipSync(bytes).length
        check(`${name}: ${Math.round(bytes.length / 1000)} kB, packed ${Math.round(packed / 1000)} kB`, bytes.length < 3e6 && packed < 1e6)
    }
}

fs.mkdirSync(shots, {recursive: true})
if (!only || only === 'sizes') sizes()
const chapters = fs.readdirSync(site).filter(name => name.startsWith(only) && /^[1-6].*\.html$/.test(name))
for (const kind of installed()) {
    const browser = await launch(kind, tools)
    let all = 0
    for (const chapter of chapters) all += await tryPage(browser, kind, chapter)
    if (!only || only === 'gallery') await tryTiles(browser, kind)
    if (kind === 'chromium' && (!only || only === 'gallery')) await tryTilesByFinger(browser)
    if (!only) check(`${kind}: ${all} live figures`, all >= 10, all)
    await browser.close()
}
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed ? 1 : 0)
