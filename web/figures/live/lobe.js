// Chapter 2: the lobe of either scheme, samples of the step falling on it.
figures.lobe = {
    scene: 'box_glossy.yaml',
    controls: [
        {name: 'n', label: 'exponent n', low: 1, high: 1000, log: true, value: 20},
        {name: 'theta', label: 'angle θ', low: 0, high: 89, step: 1, value: 40, unit: '°'},
        {name: 'scheme', label: 'bounce', choices: ['2.3 the source text’s', '2.4 modified Phong'], value: '2.4 modified Phong'},
    ],
    draw(figure, {n, theta, scheme}) {
        const {lab} = figure, steps = scheme.slice(0, 3)
        const asked = [n, theta, steps].join()
        if (figure.asked !== asked) {
            figure.asked = asked
            lab.set({view: 'lobe', 'lobe.exponent': n, 'lobe.angle': theta, steps})
            lab.run(lab.shows())
            figure.albedo = figure.numbers('web_albedo', n, theta, 4000).slice(-3)
        }
        lab.draw()
        const albedo = figure.albedo[steps === '2.3' ? 1 : 2]
        return {words: `Samples at n = ${rounded(n)}, the photon coming in at ${rounded(theta)}°. Of its flux goes on: ${rounded(100 * albedo)} %.`, n, theta, steps, albedo}
    },
}
