# The floor's photons from above, by what lay between them and the light.
load "course_notes/figures/src/1_style.gp"
set terminal pngcairo size 504,210 font "sans-serif,10" background "white"
set output figures . "/1_floor.png"
file = data . "1_floor.csv"
set datafile separator ","
unset border
unset tics
unset key
set xrange [-1:1]
set yrange [1:-1]
set size ratio -1
set multiplot layout 1, 3 margins 0.01, 0.99, 0.02, 0.88 spacing 0.02
names = "direct caustic indirect"
colours = blue . " " . orange . " " . green
do for [i = 0:2] {
    set title word(names, i + 1) offset 0, -0.6
    set object 1 rectangle from -1, -1 to 1, 1 fs empty border lc rgb grey
    plot file skip 1 using ($2 < -0.999 && $14 == i ? $1 : 1/0):3 with dots lc rgb word(colours, i + 1)
}
unset multiplot
