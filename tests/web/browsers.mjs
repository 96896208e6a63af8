// Chromium and Firefox, driven by puppeteer-core; pages of build/site from the disk or from a server of ours.
import fs from 'node:fs'
import http from 'node:http'
import path from 'node:path'
import {createRequire} from 'node:module'

const PLACES = {
    chromium: ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'],
    firefox: ['/usr/bin/firefox-esr', '/usr/bin/firefox'],
}
const executable = name => PLACES[name].find(place => fs.existsSync(place))
export const installed = () => Object.keys(PLACES).filter(executable)

// `tools`: the folder into which npm put puppeteer-core.
export async function launch(name, tools) {
    const {default: puppeteer} = await import(createRequire(path.resolve(tools, 'x.js')).resolve('puppeteer-core'))
    const browser = await puppeteer.launch(name === 'firefox' // draws WebGL on a display only
        ? {browser: 'firefox', executablePath: executable(name), headless: !process.env.DISPLAY}
        : {executablePath: executable(name), args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist']})
    const open = browser.newPage.bind(browser)
    browser.newPage = async () => {
        const page = await open()
        page.setDefaultTimeout(120000) // on a busy machine, too
        return page
    }
    return browser
}

// The folder below a path of its own, and nothing else; {url, close, asked: paths that were asked for}.
export function serve(folder, prefix) {
    const asked = []
    const server = http.createServer((request, response) => {
        asked.push(request.url)
        const file = path.join(folder, path.normalize(request.url.slice(prefix.length)))
        if (!request.url.startsWith(prefix) || !fs.existsSync(file)) return response.writeHead(404).end()
        response.writeHead(200, {'Content-Type': 'text/html'}).end(fs.readFileSync(file))
    })
    return new Promise(resolve => server.listen(0, '127.0.0.1', () =>
        resolve({url: `http://127.0.0.1:${server.address().port}${prefix}`, close: () => server.close(), asked})))
}

export const median = list => list.sort((a, b) => a - b)[list.length >> 1]

// Seconds that a process and all that it started have used, with those that have ended: columns 14 to 17 of
// /proc/PID/stat, hundredths.
export function processorSeconds(root) {
    const stat = Object.fromEntries(fs.readdirSync('/proc').filter(name => /^\d+$/.test(name)).flatMap(pid => {
        try {
            return [[pid, fs.readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ')]]
        } catch (gone) {
            return []
        }
    }))
    const below = pid => pid === String(root) || (stat[pid] && pid !== '0' && below(stat[pid][1]))
    return Object.keys(stat).filter(below).reduce((sum, pid) => sum + [11, 12, 13, 14].reduce((all, i) => all + Number(stat[pid][i]), 0) / 100, 0)
}
