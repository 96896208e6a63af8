load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,760 dynamic font "sans-serif,14" background "white"
set output figures . "/1_error.svg"
file = data . "1_error.dat"
set border 3
set logscale xy
set ylabel "error / mean irradiance"
set format y "%g"
set multiplot layout 2, 1
set title "Against k: 20 000 photons to the square metre"
set xlabel "k"
set xrange [4:2500]
set yrange [0.003:1]
set key at 5, 0.03 left top reverse Left
plot file index 0 using 1:7 with lines lw 1 lc rgb blue notitle, \
     "" index 0 using 1:6 with lines lw 1 lc rgb orange notitle, \
     "" index 0 using 1:4 with points pt 7 ps 0.7 lc rgb blue title "noise, line: √(1.5/(k − 2))", \
     "" index 0 using ($1 >= 350 ? $1 : 1/0):3 with points pt 9 ps 0.8 lc rgb orange title "bias, line: slope 1", \
     "" index 0 using 1:2 with linespoints pt 5 ps 0.5 lw 2 lc rgb grey title "both"
set title "Against the number of photons"
set xlabel "photons to the square metre"
set format x "10^{%T}"
set xrange [350:200000]
set yrange [0.01:1]
unset key
set key inside bottom left reverse Left
half(x) = sqrt(1.5 / (pi * 0.08**2 * x))
third(x) = 1.61 * x**(-1/3.0)
plot file index 1 using 1:2 with points pt 7 ps 0.7 lc rgb blue title "k = 50", \
     0.1838 with lines lw 1 lc rgb blue notitle, \
     file index 2 using 1:2 with points pt 9 ps 0.8 lc rgb orange title "radius 0.08 m; line: slope −1/2", \
     half(x) with lines lw 1 lc rgb orange notitle, \
     file index 3 using 1:2 with points pt 5 ps 0.7 lc rgb green title "k = 0.87 N^{2/3}; line: slope −1/3", \
     third(x) with lines lw 1 lc rgb green notitle
unset multiplot
