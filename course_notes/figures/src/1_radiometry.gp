# A drawing, not a measurement: flux, irradiance and radiance side by side.
load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,290 dynamic font "sans-serif,16" background "white"
set output figures . "/1_radiometry.svg"
unset border
unset tics
unset key
set margins 0, 0, 0, 0
set xrange [0:64]
set yrange [2.5:28]
# Flux: everything that leaves a lamp.
set object 1 rectangle from 6, 22 to 14, 23 fc rgb orange fs solid
do for [a = -60:60:20] {
    set arrow from 10 + 3*sin(a*pi/180), 22 to 10 + 9*sin(a*pi/180), 22 - 9*cos(a*pi/180) lw 1.5 lc rgb orange
}
set label "flux Φ" at 9, 7 center font ",19"
set label "W" at 9, 4 center font ",17"
# Irradiance: what arrives on a piece of surface, from everywhere.
set object 2 rectangle from 22, 11.4 to 42, 12 fc rgb "#dddddd" fs solid noborder
set object 3 rectangle from 29, 11.2 to 35, 12.2 fc rgb blue fs solid
set arrow from 25, 19 to 30, 12.6 lw 1.5 lc rgb blue
set arrow from 29, 22 to 31, 12.6 lw 1.5 lc rgb blue
set arrow from 34, 23 to 32, 12.6 lw 1.5 lc rgb blue
set arrow from 38.5, 20 to 33.5, 12.6 lw 1.5 lc rgb blue
set arrow from 41, 15.5 to 34.5, 12.6 lw 1.5 lc rgb blue
set label "dA" at 32, 9.8 center tc rgb blue
set label "irradiance E" at 32, 7 center font ",19"
set label "W/m²" at 32, 4 center font ",17"
# Radiance: one direction, and the area seen from there.
set object 4 rectangle from 45, 11.4 to 63, 12 fc rgb "#dddddd" fs solid noborder
set object 5 rectangle from 50, 11.2 to 55, 12.2 fc rgb green fs solid
set arrow from 52.5, 12.2 to 52.5, 25 nohead lw 1 dt 2 lc rgb grey
set label "n" at 52.2, 26 center tc rgb grey
set arrow from 52.5, 12.2 to 59.2, 22.6 nohead lw 1 lc rgb green
set arrow from 52.5, 12.2 to 61.2, 20.8 nohead lw 1 lc rgb green
set object 6 ellipse center 60.2, 21.7 size 3.2, 1.4 angle -42 fs empty border lc rgb green
set label "dω" at 61.4, 23.8 center tc rgb green
set label "θ" at 54.2, 18.4 center tc rgb grey
set label "dA" at 52.5, 9.8 center tc rgb green
set label "radiance L" at 53, 7 center font ",19"
set label "W/(m²·sr)" at 53, 4 center font ",17"
plot NaN
