# Passes at one point: the radius, and the error of the mean over the passes.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,620 dynamic font "sans-serif,14" background "white"
set output figures . "/5_point.svg"
table = data . "5_point.dat"
set multiplot layout 2,1
set logscale xy
set xrange [1:10000]
set format x "10^{%T}"
set lmargin 9
set key bottom left Left reverse samplen 2
set ylabel "radius, by the first one"
set yrange [0.04:1.5]
plot table using 1:6 with lines lw 2.5 lc rgb grey title "α = 1", \
     table using 1:4 with lines lw 2.5 lc rgb blue title "α = 2/3", \
     table using 1:2 with lines lw 2.5 dt 2 lc rgb orange title "α = 1/3"
set xlabel "passes"
set ylabel "error, rms"
set yrange [0.008:0.4]
plot table using 1:7 with linespoints pt 4 ps 0.5 lc rgb grey title "α = 1", \
     table using 1:5 with linespoints pt 7 ps 0.5 lc rgb blue title "α = 2/3", \
     table using 1:3 with linespoints pt 2 ps 0.6 lc rgb orange title "α = 1/3", \
     [30:10000] 0.27*x**(-1./3) with lines dt 2 lc rgb blue title "slope −1/3", \
     [30:10000] 0.155*x**(-1./6) with lines dt 3 lc rgb orange title "slope −1/6"
unset multiplot
