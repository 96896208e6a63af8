// Chapter 1: one photon after another, bounce by bounce.
figures.path = {
    scene: 'box_glass.yaml',
    controls: [
        {name: 'photon', label: 'photon', low: 0, high: 199, step: 1, value: 142},
        {name: 'bounce', label: 'up to bounce', low: 0, high: 8, step: 1, value: 3},
    ],
    ...followPhotons(200, {steps: '1.5'}),
}
