// Chapter 1: one photon after another, bounce by bounce.
figures.path = {
    scene: 'box_glass.yaml',
    controls: [
        {name: 'photon', label: 'photon', low: 0, high: 199, step: 1, value: 142},
        {name: 'bounce', label: 'up to bounce', low: 0, high: 8, step: 1, value: 3},
    ],
    open({lab}) {
        lab.set({photons: 200, paths: 200, view: 'paths', colour: 'photon', steps: '1.5'})
        lab.trace()
        lab.show()
    },
    draw({lab}, {photon, bounce}) {
        lab.set({'paths.path': photon, 'paths.bounce': bounce})
        lab.draw()
        return {words: lab.describe(), photon, bounce, said: lab.describe()}
    },
}
