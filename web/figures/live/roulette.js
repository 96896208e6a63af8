// Chapter 1: Russian roulette, its cost and its variance.
figures.roulette = {
    controls: [
        {name: 'rho', label: 'reflectance', low: 0.05, high: 0.95, step: 0.01, value: 0.7},
        {name: 'paths', label: 'paths', low: 10, high: 20000, log: true, value: 300, step: 1},
    ],
    draw(figure, {rho, paths}) {
        const bounces = 16, all = figure.numbers('web_roulette', rho, bounces, paths), [mean, spread, rays] = all
        const {sheet} = figure, right = 1 / (1 - rho)
        sheet.begin({x: [-0.6, bounces - 0.4], y: [0, 1.08], labels: ['bounce', 'share alive (bars), power of each (dots)']})
        for (let i = 0; i < bounces; i++) {
            const alive = all[3 + 2 * i], power = all[4 + 2 * i]
            sheet.area([[i - 0.35, 0], [i + 0.35, 0], [i + 0.35, alive], [i - 0.35, alive]], 'glass', 'blue')
            if (alive > 0) sheet.dots([[i, power]], 'blue', 7)
            sheet.dots([[i, rho ** i]], 'orange', 5)
        }
        sheet.text([bounces - 0.6, 0.93], 'with roulette every survivor keeps its power', 'blue', 'right')
        sheet.text([bounces - 0.6, 0.82], 'without it all live, and fade', 'orange', 'right')
        const error = spread / Math.sqrt(paths)
        return {words: `The walls receive ${rounded(mean)} ± ${rounded(error, 2)} powers of a photon (right: ${rounded(right)}), for ${rounded(rays)} rays a path. ` +
            `Without roulette the answer has no noise here, but a path never ends: after 16 bounces ${rounded(100 * rho ** 16, 2)} % of the power is still on its way.`, rho, paths, mean, right, error, rays}
    },
}
