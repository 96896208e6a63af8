// `make preview WEB=1` for a student who has solved everything, and an editor of theirs.
import {spawn} from 'node:child_process'
import fs from 'node:fs'
import path from 'node:path'

// {url, said(): what the terminal has, save(file, text), end()}; `file` below the folder of steps. `work`: a folder for them.
export async function startTab(work, ...settings) {
    const code = path.join(work, 'code')
    fs.rmSync(work, {recursive: true, force: true})
    fs.cpSync('solutions', code, {recursive: true})
    const make = spawn('make', ['--no-print-directory', 'preview', 'WEB=1', `CODE=${code}`, 'STAGE=1', ...settings], {detached: true})
    let said = ''
    for (const stream of [make.stdout, make.stderr]) stream.on('data', data => { said += data })
    const ended = new Promise(resolve => make.on('exit', resolve))
    const tab = {
        pid: make.pid,
        said: () => said,
        save(file, text) { // as editors do: whole, and then in its place
            fs.writeFileSync(path.join(work, 'saved'), text)
            fs.renameSync(path.join(work, 'saved'), path.join(code, file))
        },
        async end() {
            process.kill(-make.pid, 'SIGTERM')
            await ended
        },
    }
    let running = true
    ended.then(() => { running = false })
    while (!/Your photons: \S+\n/.test(said)) {
        if (!running) throw new Error(`make preview WEB=1 ended: ${said}`)
        await new Promise(resolve => setTimeout(resolve, 50))
    }
    tab.url = said.match(/Your photons: (\S+)/)[1]
    return tab
}

export const BROKEN = '1_diffuse_photon_map/1.3_scatter_diffuse.c'

// Step 1.3 with this before the function and this in it.
export const step = (head, body) =>
    `#include "photonlab.h"\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n${head}\nVec3 scatter_diffuse(Vec3 normal, Rng *rng)\n{\n${body}\n}\n`
