# CIE 1931 colour matching functions, and the linear sRGB that a single wavelength would need.
set terminal svg size 640,520 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/further_matching.svg"
data = system('printf %s "$BUILD"') . "/figures/further_matching.dat"
set multiplot layout 2,1
set xrange [380:720]
set lmargin 8
set key top right samplen 2
set ytics 0.5
set format y "%.1f"
set label 1 "x" at 599,1.17 center textcolor "#d9730d"
set label 2 "y" at 545,1.10 center textcolor "#3a7d44"
set label 3 "z" at 465,1.80 center textcolor "#1b6ca8"
set yrange [0:2]
set ylabel "colour matching"
plot data using 1:2 with lines lw 2.5 lc "#d9730d" notitle, \
     data using 1:3 with lines lw 2.5 dt 4 lc "#3a7d44" notitle, \
     data using 1:4 with lines lw 2.5 dt 2 lc "#1b6ca8" notitle
unset label
set for [nm in "464.31 549.13 611.28"] arrow from nm,-2 to nm,3 nohead dt 2 lc "#999999"
set label 1 "B" at 464.31,2.55 center
set label 2 "G" at 549.13,2.55 center
set label 3 "R" at 611.28,2.55 center
set arrow 99 from 380,0 to 720,0 nohead lc "#555555"
set yrange [-2:3]
set ytics 1
set xlabel "wavelength, nm"
set ylabel "linear sRGB"
plot data using 1:5 with lines lw 2.5 lc "#d9730d" notitle, \
     data using 1:6 with lines lw 2.5 dt 4 lc "#3a7d44" notitle, \
     data using 1:7 with lines lw 2.5 dt 2 lc "#1b6ca8" notitle
unset multiplot
