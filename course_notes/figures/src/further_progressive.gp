# Progressive photon mapping at one point: the radius, and the error of the mean over the passes.
set terminal svg size 640,620 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/further_progressive.svg"
data = system('printf %s "$BUILD"') . "/figures/further_progressive.dat"
set multiplot layout 2,1
set logscale xy
set xrange [1:10000]
set format x "10^{%T}"
set lmargin 9
set key bottom left Left reverse samplen 2
set ylabel "radius r_i / r_1"
set yrange [0.04:1.5]
plot data using 1:6 with lines lw 2.5 lc "#555555" title "α = 1", \
     data using 1:4 with lines lw 2.5 lc "#1b6ca8" title "α = 2/3", \
     data using 1:2 with lines lw 2.5 dt 2 lc "#d9730d" title "α = 1/3"
set xlabel "passes"
set ylabel "rms error"
set yrange [0.008:0.4]
plot data using 1:7 with linespoints pt 4 ps 0.5 lc "#555555" title "α = 1", \
     data using 1:5 with linespoints pt 7 ps 0.5 lc "#1b6ca8" title "α = 2/3", \
     data using 1:3 with linespoints pt 2 ps 0.6 lc "#d9730d" title "α = 1/3", \
     [30:10000] 0.27*x**(-1./3) with lines dt 2 lc "#1b6ca8" title "slope −1/3", \
     [30:10000] 0.155*x**(-1./6) with lines dt 3 lc "#d9730d" title "slope −1/6"
unset multiplot
