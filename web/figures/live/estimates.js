// Chapter 4: where gathering estimates irradiance, and how far each estimate reaches.
figures.estimates = {
    scene: 'box_diffuse.yaml',
    controls: [{name: 'circles', label: 'reach', choices: ['shown', 'hidden'], value: 'shown'}],
    open({lab}) {
        lab.set({view: 'estimates', photons: 20000})
        lab.run(lab.shows())
    },
    draw({lab}, {circles}) {
        lab.set({'estimates.no-circles': circles === 'hidden' ? 1 : 0})
        lab.draw()
        return {words: lab.describe(), circles, said: lab.describe()}
    },
}
