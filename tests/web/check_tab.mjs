// One's own code in a tab, in real browsers: a step is broken in every way there is, and mended. Usage: node check_tab.mjs TOOLS SHOTS
import fs from 'node:fs'
import {installed, launch} from './browsers.mjs'
import {BROKEN, startTab, step} from './tab_server.mjs'

const [tools, shots] = process.argv.slice(2)
let passed = 0, failed = 0
function check(what, fine, found = '') {
    fine ? passed++ : failed++
    console.log(`${fine ? '✓' : '✗'} ${what}${fine ? '' : `: ${found}`}`)
}

const text = (page, id) => page.$eval(`#${id}`, element => element.textContent)
const module = page => page.evaluate(() => student.module)
const photons = page => page.evaluate(() => state.lab.collected().photons)
const within = (page, test, ...values) => page.waitForFunction(test, {timeout: 90000, polling: 20}, ...values).then(() => true, () => false)
const good = fs.readFileSync(`solutions/${BROKEN}`, 'utf8')

// What is saved, and what the banner says then.
const DRILLS = [
    ['a null pointer', /^1\.3_scatter_diffuse\.c:9: scatter_diffuse: segmentation fault: .*null pointer/, '', 'float *nothing = (float *)(size_t)(rng->state * 0);\nnormal.x = *nothing; return normal;'],
    ['an index beyond an array', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: segmentation fault/, '', 'volatile int far = 9; float three[3] = {0}; normal.x = three[far]; return normal;'],
    ['an address that is not there', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: segmentation fault/, '', 'normal.x = *(volatile float *)(size_t)(0x7f000000 + (rng_u32(rng) & 3) * 4); return normal;'],
    ['a division by zero', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: an integer was divided by 0/, '', 'volatile int none = 0; normal.x = (float)(7 / none); return normal;'],
    ['an endless loop', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: ran for 2 s without finishing a photon; an endless loop\?/, '', 'volatile int forever = 1; while (forever) normal.x += 0.0f * rng_float(rng); return normal;'],
    ['a loop of nothing', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: ran for 2 s/, '', 'for (volatile int i = 0;; i++) { } return normal;'],
    ['calls without end', /^1\.3_scatter_diffuse\.c:5: deeper: the stack overflowed: it calls itself without end/,
        'static Vec3 deeper(Vec3 n, Rng *rng, int d) { volatile char room[4096]; room[d % 4096] = 1; Vec3 v = deeper(n, rng, d + 1); v.x += (float)room[0]; return v; }', 'return deeper(normal, rng, 0);'],
    ['calls without end or arrays', /^1\.3_scatter_diffuse\.c:5: deeper: the stack overflowed: it calls itself without end/,
        'static float deeper(Rng *rng, float d) { return d < 0.0f ? d : 1.0f + deeper(rng, d + 1.0f) * rng_float(rng); }', 'normal.x = deeper(rng, 0.0f); return normal;'],
    ['a large array', /^1\.3_scatter_diffuse\.c:\d+: scatter_diffuse: the stack overflowed/, '', 'volatile float large[4000000]; large[rng_u32(rng) % 4000000] = 1.0f; normal.x += 0.0f * large[0]; return normal;'],
    ['memory without end', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: asked for (ever more|more than 1 GB of) memory/, '',
        'for (;;) { volatile char *room = malloc(64 << 20); room[rng_u32(rng) % 64] = 1; normal.x += (float)room[0]; }'],
    ['abort', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: abort\(\) was called/, '', 'if (rng) abort(); return normal;'],
    ['exit', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: called exit, which ends the whole program/, '', 'if (rng) exit(0); return normal;'],
    ['a build error', /^1\.3_scatter_diffuse\.c:\d+:\d+: error: /, '', 'return normal'],
    ['a function that nobody has', /^1\.3_scatter_diffuse\.c:8: scatter_diffuse: calls `no_such_function`, and there is no such function/, 'Vec3 no_such_function(Vec3);', 'return no_such_function(normal);'],
]

// Waits for new photons of a module that is newer than `before`.
const shown = (page, before) => within(page, before => student.module > before && state.seconds > 0 && !document.getElementById('fault').textContent, before)

async function drill(tab, page, name, [what, pattern, head, body]) {
    const before = await photons(page)
    tab.save(BROKEN, step(head, body))
    const told = await within(page, pattern => new RegExp(pattern).test(document.getElementById('fault').textContent), pattern.source)
    check(`${name}: ${what}: ${(await text(page, 'fault')).split('\n')[0]}`, told, await text(page, 'status'))
    const words = (await text(page, 'fault')).split('\n')[0]
    check(`${name}: ${what}: the terminal has it, too`, tab.said().includes(words), tab.said().slice(-300))
    check(`${name}: ${what}: the last good photons stay`, await photons(page) === before, `${await photons(page)} of ${before}`)
    if (what === 'an endless loop') await page.screenshot({path: `${shots}/tab_${name}_loop.png`})
    const last = await module(page)
    tab.save(BROKEN, good)
    check(`${name}: ${what}: mended`, await shown(page, last), await text(page, 'fault'))
}

// Half as bright, and right again; the panel says so, and the present step is the one that was saved.
async function verdicts(tab, page, name) {
    tab.save(BROKEN, good.replace(/return ([^;]+);/, 'return vec3_scale($1, 0.5f);'))
    check(`${name}: a wrong step is judged`, await within(page, () => document.querySelector('#verdicts h2').textContent.startsWith('✗ 1.3') &&
        !student.now.steps[student.now.present].judged), await text(page, 'verdicts'))
    check(`${name}: and what right steps never do is told`, await within(page, () => /gave a direction whose length is 0\.5/.test(document.getElementById('fault').textContent)), await text(page, 'fault'))
    await page.screenshot({path: `${shots}/tab_${name}_wrong.png`})
    await page.click('#hint')
    check(`${name}: a hint`, await within(page, () => /hint 1 of 3/.test(document.querySelector('#verdicts').textContent)))
    tab.save(BROKEN, good)
    check(`${name}: a right one, too`, await within(page, () => document.querySelector('#verdicts h2').textContent.startsWith('✓ 1.3')), await text(page, 'verdicts'))
}

// With 3.4 written, the loop of 1.5 does not play: a save of it changes nothing, and that is said. Another save takes it away.
async function notPlayed(tab, page, name) {
    const loop = '1_diffuse_photon_map/1.5_trace_photon.c'
    tab.save(loop, fs.readFileSync(`solutions/${loop}`, 'utf8'))
    check(`${name}: a step that another plays for`,
        await within(page, () => document.getElementById('fault').textContent === '1.5 is built, but another step plays in its place; make preview WEB=1 FLAGS="--steps 1.5" plays it'), await text(page, 'fault'))
    const last = await module(page)
    tab.save(BROKEN, good)
    check(`${name}: … and no more after another's save`, await shown(page, last), await text(page, 'fault'))
}

// What that sentence advises.
async function chosen(browser, name) {
    const tab = await startTab(`${shots}/../tab_check`, 'FLAGS=--steps 1.5'), page = await browser.newPage()
    await page.goto(tab.url)
    await shown(page, 0)
    const unplayed = id => page.evaluate(id => state.lab.text(state.lab.call('web_unplayed', id)), id)
    check(`${name}: --steps 1.5 plays it`, await unplayed('1.5') === '' && /^3\.4 is built, but/.test(await unplayed('3.4')), await unplayed('1.5'))
    await tab.end()
}

// What a step prints is text, whatever it says; a million lines are a hundred.
async function printed(tab, page, name) {
    tab.save(BROKEN, step('', 'printf("<img src=x onerror=alert(1)><script>alert(2)</script>\\n"); return normal;'))
    check(`${name}: what a step prints is text`, await within(page, () => document.getElementById('printed').textContent.startsWith('<img src=x onerror')))
    check(`${name}: … of a hundred lines`, (await text(page, 'printed')).split('\n').length <= 1 + 100 * 8)
    check(`${name}: … and nothing else`, await page.evaluate(() => !document.querySelector('#printed *, img') && document.scripts.length === [...document.scripts].filter(s => s.src || s.type.startsWith('text/')).length))
    // Even if a page of ours forgot that: scripts come from the server alone.
    await page.evaluate(() => {
        window.broken = false
        const holder = document.createElement('div')
        holder.innerHTML = '<img src="data:," onerror="window.broken = true">'
        document.body.append(holder)
    })
    await new Promise(resolve => setTimeout(resolve, 300))
    check(`${name}: the page runs no script that is written into it`, !await page.evaluate(() => window.broken))
    tab.save(BROKEN, good)
}

async function checkBrowser(name) {
    const tab = await startTab(`${shots}/../tab_check`), browser = await launch(name, tools), said = []
    const page = await browser.newPage()
    page.on('pageerror', error => /Content-Security-Policy/.test(error.message) || said.push(error.message)) // that one is wanted
    await page.setViewport({width: 1280, height: 900})
    await page.goto(tab.url)
    check(`${name}: the student's photons`, await shown(page, 0), await text(page, 'fault'))
    check(`${name}: all steps are the student's`, (await page.evaluate(() => student.now.students)).split(' ').length === 28)
    await page.screenshot({path: `${shots}/tab_${name}.png`})
    for (const row of DRILLS) await drill(tab, page, name, row)
    await verdicts(tab, page, name)
    await notPlayed(tab, page, name)
    await printed(tab, page, name)
    await tab.end()
    check(`${name}: the end of make preview is told`, await within(page, () => /make preview has ended/.test(document.getElementById('fault').textContent)))
    await chosen(browser, name)
    check(`${name}: no error in the page`, said.length === 0, said)
    await browser.close()
}

fs.mkdirSync(shots, {recursive: true})
for (const name of process.env.BROWSERS ? process.env.BROWSERS.split(' ') : installed()) await checkBrowser(name)
console.log(`${passed} passed, ${failed} failed`)
process.exit(failed || !passed ? 1 : 0)
