# Across the caustic's edge in scenes/ring.yaml.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,380 dynamic font "sans-serif,14" background "white"
set output figures . "/5_edge.svg"
table = data . "5_edge.dat"
set xrange [-7:7]
set yrange [0:*]
set xlabel "across the curve, mm"
set ylabel "L, W/(m²·sr)"
set key top left Left reverse samplen 2
set arrow from 0, graph 0 to 0, graph 1 nohead dt 3 lc rgb grey
plot table using 1:2 with lines lw 2 lc rgb grey title "512 passes, fixed radius", \
     table using 1:3 with lines lw 1.5 lc rgb orange title "8 passes", \
     table using 1:4 with lines lw 1.5 lc rgb green title "64 passes", \
     table using 1:5 with lines lw 2.5 lc rgb blue title "512 passes"
