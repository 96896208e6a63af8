# The error of the mean over passes against their number, with a radius that shrinks and with one that does not.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,440 dynamic font "sans-serif,14" background "white"
set output figures . "/5_error.svg"
table = data . "5_error.dat"
set logscale xy
set xrange [1:1100]
set format x "%g"
set format y "10^{%T}"
set xlabel "passes"
set ylabel "error, relMSE"
set key bottom left Left reverse samplen 2
first = real(system("awk 'NR == 1 { print $2 }' \"" . table . "\""))
plot table using 1:6 with linespoints lw 2 pt 4 ps 0.6 lc rgb grey title "α = 1: the radius stays", \
     table using 1:4 with linespoints lw 2 dt 2 pt 2 ps 0.6 lc rgb orange title "5.3: a radius for each pixel", \
     table using 1:2 with linespoints lw 2.5 pt 7 ps 0.6 lc rgb blue title "5.1: a radius for each pass", \
     first * x**(-2. / 3) with lines dt 3 lw 1.5 lc rgb blue title "slope −2/3"
