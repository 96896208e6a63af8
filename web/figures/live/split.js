// Chapter 3: white splits once, and its children go on alone.
figures.split = {
    scene: 'box_dispersion.yaml',
    controls: [
        {name: 'photon', label: 'photon', low: -1, high: 399, step: 1, value: 316},
        {name: 'bounce', label: 'up to bounce', low: 0, high: 30, step: 1, value: 12},
    ],
    ...followPhotons(400, {}),
}
