// Chapter 5: the disks of some points, pass by pass.
figures.radii = {
    scene: 'box_glass.yaml',
    controls: [{name: 'pass', label: 'pass', low: 0, high: 64, step: 1, value: 1}],
    open({lab}) {
        lab.set({view: 'radii', photons: 20000})
        lab.run(lab.shows())
    },
    draw({lab}, {pass}) {
        lab.set({'radii.pass': pass})
        lab.draw()
        return {words: lab.describe(), pass, said: lab.describe()}
    },
}
