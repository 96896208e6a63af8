load "course_notes/figures/src/4_style.gp"
set terminal svg size 640,360 dynamic font "sans-serif,14" background "white"
set output figures . "/4_slope.svg"
set xrange [-1.6:1.6]
set yrange [0:3.2]
set xlabel "x, m"
set ylabel "E, W/m²"
plot data . "4_slope.dat" index 0 using 1:2 with lines lw 5 lc rgb "#cccccc" title "by the formula", \
     "" index 0 using 1:4 with lines lw 2 lc rgb orange title "estimates as they are", \
     "" index 0 using 1:3 with lines lw 2 lc rgb blue title "carried along their gradients", \
     "" index 1 using 1:2 with points pt 7 ps 0.8 lc rgb grey title "estimates"
