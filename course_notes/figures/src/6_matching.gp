# Colour-matching functions, the colour of a wavelength, and the density by which wavelengths are drawn.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,720 dynamic font "sans-serif,14" background "white"
set output figures . "/6_matching.svg"
table = data . "6_curves.dat"
set multiplot layout 3,1
set xrange [380:730]
set lmargin 8
set key off
set ytics 0.5
set format y "%.1f"
set label 1 "x" at 599,1.17 center textcolor rgb orange
set label 2 "y" at 545,1.10 center textcolor rgb green
set label 3 "z" at 468,1.75 center textcolor rgb blue
set yrange [0:2]
set ylabel "colour matching"
plot table using 1:2 with lines lw 2.5 lc rgb orange, table using 1:3 with lines lw 2.5 dt 4 lc rgb green, \
     table using 1:4 with lines lw 2.5 dt 2 lc rgb blue
unset label
set label 1 "red" at 622,6.7 left textcolor rgb orange
set label 2 "green" at 545,6.1 left textcolor rgb green
set label 3 "blue" at 466,6.1 left textcolor rgb blue
set yrange [-3:8]
set ytics 2
set format y "%.0f"
set ylabel "colour, step 6.3"
set arrow 99 from 380,0 to 730,0 nohead lc rgb grey lw 0.8
plot table using 1:5 with lines lw 2.5 lc rgb orange, table using 1:6 with lines lw 2.5 dt 4 lc rgb green, \
     table using 1:7 with lines lw 2.5 dt 2 lc rgb blue
unset label
unset arrow
set yrange [0:1.8]
set ytics 0.5
set format y "%.1f"
set xlabel "wavelength, nm"
set ylabel "density × 350 nm"
set label 1 "even" at 700,1.14 center textcolor rgb grey
plot 1 with lines dt 2 lc rgb grey, table using 1:8 with lines lw 2.5 lc rgb blue
unset multiplot
