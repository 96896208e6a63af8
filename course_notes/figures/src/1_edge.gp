load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,340 dynamic font "sans-serif,14" background "white"
set output figures . "/1_edge.svg"
set border 3
set xrange [-0.3:0.3]
set yrange [0:1.15]
set xlabel "distance from the edge, m"
set ylabel "mean irradiance found, W/m²"
set key bottom right
set label "shadow" at -0.28, 0.9
set label "light" at 0.2, 0.85
truth(x) = x > 0 ? 1 : 0
set samples 2001
plot truth(x) with lines lw 1 dt 2 lc rgb grey title "truth", \
     data . "1_edge.dat" index 0 using 1:2 with lines lw 2 lc rgb blue title "k = 50", \
     "" index 1 using 1:2 with lines lw 2 lc rgb orange title "k = 400"
