// From a save to new photons in the tab. Usage: node bench_tab.mjs TOOLS WORK
// By the clock, which what else the machine does makes longer, and in processor time of compiler, server and browser.
import fs from 'node:fs'
import {installed, launch, median, processorSeconds} from './browsers.mjs'
import {BROKEN, startTab} from './tab_server.mjs'

const [tools, work] = process.argv.slice(2)
const SAVES = 20
const good = fs.readFileSync(`solutions/${BROKEN}`, 'utf8')

for (const name of installed()) {
    const tab = await startTab(work), browser = await launch(name, tools), page = await browser.newPage()
    const used = () => processorSeconds(browser.process().pid) + processorSeconds(tab.pid)
    await page.setViewport({width: 1280, height: 900})
    await page.goto(tab.url)
    await page.waitForFunction(() => student.module > 0 && state.seconds > 0, {timeout: 60000})
    // When the first photons of a module were drawn, by the machine's clock.
    await page.evaluate(() => {
        const before = draw
        window.drawn = {}
        window.draw = now => {
            before(now)
            if (state.shown > 0) drawn[student.module] ||= Date.now()
        }
    })
    const clock = [], processor = []
    for (let i = 0; i < SAVES; i++) {
        const next = 1 + await page.evaluate(() => student.module), before = used(), began = Date.now()
        tab.save(BROKEN, `${good}// ${i}\n`)
        await page.waitForFunction(module => drawn[module], {polling: 20, timeout: 60000}, next)
        clock.push((await page.evaluate(module => drawn[module], next) - began) / 1000)
        await page.waitForFunction(() => state.seconds > 0, {polling: 20, timeout: 60000}) // all of them
        processor.push(used() - before)
        await new Promise(resolve => setTimeout(resolve, 300))
    }
    console.log(`${name}: first new photons ${median(clock).toFixed(2)} s after a save (median of ${SAVES}; the longest ${Math.max(...clock).toFixed(2)} s), ` +
        `${median(processor).toFixed(2)} s of processor time until all are there`)
    await browser.close()
    await tab.end()
}
