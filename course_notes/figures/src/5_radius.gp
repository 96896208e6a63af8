# The radius by both views: by the pass's number, and by what a point has found.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output figures . "/5_radius.svg"
table = data . "5_views.dat"
set logscale xy
set xrange [1:1000]
set yrange [0.2:1.3]
set ytics (0.2, 0.3, 0.4, 0.5, 0.7, 1)
set format x "%g"
set xlabel "pass"
set ylabel "radius in this pass, by the first one"
set key bottom left Left reverse samplen 2
plot table using 1:2 with lines lw 3 lc rgb blue title "5.1, by the pass's number", \
     table using 1:5 with lines lw 2 lc rgb green title "5.3, a bright point: 100 photons in the first pass", \
     table using 1:4 with lines lw 1.5 lc rgb orange title "5.3, 3 photons", \
     table using 1:3 with lines lw 1.5 lc rgb grey title "5.3, a dim point: 0.1 photons"
