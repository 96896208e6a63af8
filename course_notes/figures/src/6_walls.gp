# What a red, a green and a blue wall reflect over wavelength: they sum to 1.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,280 dynamic font "sans-serif,14" background "white"
set output figures . "/6_walls.svg"
table = data . "6_curves.dat"
set xrange [380:730]
set yrange [0:1.05]
set lmargin 8
set key off
set ytics 0.5
set xlabel "wavelength, nm"
set ylabel "reflectance"
set arrow from 589.3,0 to 589.3,1.05 nohead dt 3 lc rgb grey
set label "sodium" at 593,0.25 left textcolor rgb grey
set label "blue" at 420,0.88 textcolor rgb blue
set label "green" at 530,0.92 textcolor rgb green
set label "red" at 640,0.94 textcolor rgb orange
plot table using 1:9 with lines lw 2.5 lc rgb orange, table using 1:10 with lines lw 2.5 dt 4 lc rgb green, \
     table using 1:11 with lines lw 2.5 dt 2 lc rgb blue
