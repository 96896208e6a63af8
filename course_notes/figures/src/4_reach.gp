load "course_notes/figures/src/4_style.gp"
set terminal svg size 640,320 dynamic font "sans-serif,14" background "white"
set output figures . "/4_reach.svg"
set xrange [0:1]
set yrange [0:2.6]
set xlabel "distance to the wall, m"
set ylabel "m"
set key top left horizontal
plot data . "4_reach.dat" using 1:3 with lines lw 2 lc rgb orange title "mean of the rays' lengths", \
     "" using 1:2 with lines lw 3 lc rgb blue title "harmonic mean: the reach R", \
     "" using 1:4 with lines lw 2 lc rgb grey title "the shortest ray"
