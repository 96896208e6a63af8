// The lab in real browsers: moved by mouse, fingers and keys, numbers read back. Usage:
// node check_lab.mjs PROGRAM SITE TOOLS SHOTS
import {execFileSync} from 'node:child_process'
import fs from 'node:fs'
import path from 'node:path'
import {installed, launch, serve} from './browsers.mjs'

const [program, site, tools, shots] = process.argv.slice(2)
let passed = 0, failed = 0
function check(what, fine, found = '') {
    fine ? passed++ : failed++
    console.log(`${fine ? '✓' : '✗'} ${what}${fine ? '' : `: ${found}`}`)
}

// FNV-1a of bytes: what a page and this program can both compute.
const hash = bytes => bytes.reduce((h, byte) => Math.imul(h ^ byte, 16777619) >>> 0, 2166136261)
const settled = page => page.waitForFunction(() => state.lab && state.seconds > 0, {timeout: 60000})
const get = (page, name) => page.evaluate(name => state.lab.get(name), name)
const status = page => page.evaluate(() => document.getElementById('status').textContent)
const picture = page => page.evaluate(() => { // once it is at rest
    state.rested = 0
    draw(0)
    const canvas = document.getElementById('picture'), small = document.createElement('canvas')
    Object.assign(small, {width: 64, height: 36}).getContext('2d').drawImage(canvas, 0, 0, 64, 36)
    return [...small.getContext('2d').getImageData(0, 0, 64, 36).data]
})
const difference = (a, b) => a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length
const choose = async (page, scene) => {
    await page.evaluate(scene => {
        state.seconds = 0
        chooseScene(scene)
    }, scene)
    await settled(page)
}

function nativePhotons(scene) {
    const file = path.join(shots, 'native.ply')
    execFileSync(program, ['photons', `scenes/${scene}`, '-o', file, '--photons', '200000', '--quiet'])
    return hash(fs.readFileSync(file))
}

async function byHand(page, name) {
    const before = await picture(page), yaw = await get(page, 'yaw')
    check(`${name}: there is something to see`, Math.max(...before.filter((v, i) => i % 4 < 3)) > 60)
    const box = await (await page.$('#picture')).boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + box.height / 4, y, {steps: 4})
    await page.mouse.up()
    const turned = await get(page, 'yaw')
    check(`${name}: the mouse turns the scene by what it moved`, Math.abs(Math.abs(turned - yaw) - 1) < 0.02, turned - yaw)
    check(`${name}: and the picture changes`, difference(before, await picture(page)) > 1)
    await page.focus('#picture')
    await page.keyboard.press('0')
    check(`${name}: 0 puts the camera back, and the picture with it`,
        await get(page, 'yaw') === yaw && difference(before, await picture(page)) < 0.2)
    await page.keyboard.down('Shift')
    await page.keyboard.press('ArrowRight')
    await page.keyboard.up('Shift')
    check(`${name}: shift and an arrow turn it, too`, await get(page, 'yaw') !== yaw)
    await page.keyboard.press('2')
    await page.keyboard.press('ArrowRight')
    check(`${name}: 2 shows paths, an arrow chooses one`,
        await get(page, 'view') === 'paths' && await get(page, 'paths.path') === 0, await get(page, 'paths.path'))
    await page.keyboard.press('1')
    await page.focus('#photons')
    await page.evaluate(() => { state.seconds = 0 })
    await page.keyboard.press('ArrowLeft')
    await settled(page)
    const photons = await get(page, 'photons')
    check(`${name}: a slider by an arrow key emits so many photons`,
        photons < 200000 && (await status(page)).startsWith(photons.toLocaleString('en-GB')), await status(page))
}

async function sceneText(page, name) {
    await choose(page, 'box_glossy.yaml')
    const before = await picture(page)
    const type = change => page.evaluate(change => {
        const text = document.getElementById('yaml')
        text.value = text.value.replace(...change)
        text.oninput()
    }, change)
    await type(['type: glossy', 'type: glosy'])
    await page.waitForFunction(() => document.getElementById('wrong').textContent)
    const wrong = await page.$eval('#wrong', element => element.textContent)
    check(`${name}: a fault in the text has line and column`, /^box_glossy\.yaml:23:26: .*'glosy'.*'glossy'/.test(wrong), wrong)
    check(`${name}: the photons of before stay`, difference(before, await picture(page)) < 0.2)
    await type(['type: glosy', 'type: glossy'])
    await page.waitForFunction(() => !document.getElementById('wrong').textContent)
    await page.focus('#materials-3-exponent')
    await page.keyboard.press('End')
    await page.waitForFunction(() => /name: copper.*exponent: 200}/.test(document.getElementById('yaml').value), {timeout: 5000})
    check(`${name}: a slider writes into the scene's text`, true)
}

async function rendered(page, name) {
    await choose(page, 'cornell_box.yaml')
    const points = await picture(page)
    await page.click('#render')
    await page.waitForFunction(() => state.lab.collected().passes > 1, {timeout: 60000})
    const image = await picture(page)
    check(`${name}: a rendered picture comes in place of the photons`, difference(points, image) > 5)
    await page.screenshot({path: `${shots}/${name}_rendered.png`})
    await page.click('#render')
    check(`${name}: and goes`, difference(points, await picture(page)) < 0.2)
}

async function views(page, name) {
    await choose(page, 'box_diffuse.yaml')
    for (const view of await page.evaluate(() => state.lab.list.view)) {
        await page.select('#view', view)
        await page.waitForFunction(() => {
            const words = state.lab.describe()
            return words && !/on their way|^0 samples|\n0 samples/.test(words)
        }, {timeout: 60000})
        const levels = await picture(page)
        check(`${name}: the view ${view} is not empty`, view === 'spectrum' || difference(levels, levels.slice(0, 4).concat(levels)) > 0.3)
        await page.screenshot({path: `${shots}/${name}_${view}.png`})
    }
    await page.select('#view', 'points')
}

// Software WebGL has its points from web/module/points.c: they are where WebGL's own are, and as bright.
async function points(page, name) {
    await choose(page, 'box_glass.yaml')
    const [ours, gl] = await page.evaluate(async () => {
        const before = photonlabGl, pictures = []
        for (const software of [true, false]) {
            photonlabGl = (...given) => ({...before(...given), photonlab_software: () => software})
            const canvas = Object.assign(document.createElement('canvas'), {width: 640, height: 360}), lab = await Photonlab.open(await Photonlab.compile(), canvas)
            lab.scene(scenes['box_glass.yaml'])
            lab.set({photons: 20000, wireframe: 0})
            lab.trace()
            lab.show()
            lab.draw()
            const small = Object.assign(document.createElement('canvas'), {width: 32, height: 18}).getContext('2d')
            small.drawImage(canvas, 0, 0, 32, 18)
            pictures.push([...small.getImageData(0, 0, 32, 18).data])
        }
        photonlabGl = before
        return pictures
    })
    check(`${name}: points of a loop of ours are WebGL's`, Math.max(...ours.filter((v, i) => i % 4 < 3)) > 60 && difference(ours, gl) < 1, difference(ours, gl))
}

async function narrow(browser, url, name) {
    const page = await browser.newPage()
    await page.setViewport({width: 400, height: 800, hasTouch: name === 'chromium'})
    if (name === 'chromium') await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}])
    await page.goto(url)
    await settled(page)
    if (name === 'chromium') {
        const box = await (await page.$('#picture')).boundingBox(), x = box.x + 60, y = box.y + 60, yaw = await get(page, 'yaw')
        await page.touchscreen.touchStart(x, y)
        await page.touchscreen.touchMove(x + box.height / 4, y)
        await page.touchscreen.touchEnd()
        check(`${name}: a finger turns the scene`, Math.abs(Math.abs(await get(page, 'yaw') - yaw) - 1) < 0.05)
    }
    const width = await page.evaluate(() => document.scrollingElement.scrollWidth)
    check(`${name}: 400 pixels are wide enough`, width <= 400, width)
    if (name === 'chromium') check(`${name}: dark where that is wished`, await page.evaluate(() => getComputedStyle(document.body).backgroundColor === 'rgb(21, 24, 27)'))
    await page.screenshot({path: `${shots}/${name}_400.png`})
    await page.close()
}

async function shared(browser, page, name, prefix) {
    await page.evaluate(() => state.lab.set({yaw: 0.75, colour: 'bounce', seed: 9}))
    await page.evaluate(() => share())
    const link = await page.evaluate(() => location.hash), other = await browser.newPage()
    await other.goto(prefix + link)
    await settled(other)
    const same = async key => await get(page, key) === await get(other, key)
    check(`${name}: a link holds scene, camera, colour and seed`, await same('yaw') && await same('colour') && await same('seed') &&
        await page.$eval('#yaml', e => e.value) === await other.$eval('#yaml', e => e.value))
    await other.goto('about:blank')
    await other.goto(`${prefix}#nonsense`)
    await settled(other)
    check(`${name}: a link of nonsense opens the lab all the same`, (await status(other)).includes('photons'))
    await other.close()
}

async function checkBrowser(name) {
    const browser = await launch(name, tools), server = await serve(site, '/a/course/')
    const file = `file://${path.resolve(site)}/lab.html`, said = []
    const page = await browser.newPage()
    page.on('console', message => message.type() === 'error' && said.push(message.text()))
    page.on('pageerror', error => said.push(error.message))
    await page.setViewport({width: 1280, height: 900})
    await page.goto(file)
    await settled(page)
    const photons = await page.evaluate(hash => new Function(`return ${hash}`)()(state.lab.photonFile('x.ply')), String(hash))
    check(`${name}: from the disk, the program's photons to the byte`, photons === nativePhotons('box_glass.yaml'), photons)
    await byHand(page, name)
    await sceneText(page, name)
    await views(page, name)
    await rendered(page, name)
    await points(page, name)
    await shared(browser, page, name, file)
    await narrow(browser, file, name)
    await page.goto(`${server.url}lab.html`)
    await settled(page)
    check(`${name}: below a path of a server, which is asked for nothing but the page`,
        server.asked.every(url => url === '/a/course/lab.html' || url === '/favicon.ico'), server.asked)
    server.close()
    if (name === 'chromium') await page.setOfflineMode(true)
    await choose(page, 'prism.yaml')
    check(`${name}: goes on when server and network are gone`, (await status(page)).startsWith('200,000 photons'), await status(page))
    check(`${name}: no error in the console`, said.filter(text => !/favicon/.test(text)).length === 0, said)
    await browser.close()
}

fs.mkdirSync(shots, {recursive: true})
for (const name of installed()) await checkBrowser(name)
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed || !passed ? 1 : 0)
