load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output figures . "/1_estimators.svg"
set border 3
set logscale x
set xrange [3.5:115]
set yrange [0.45:1.45]
set xtics (4, 6, 8, 12, 20, 30, 50, 100)
set xlabel "k"
set ylabel "mean estimate / truth"
set key at 100, 0.95 right width -3
set samples 300
file = data . "1_estimators.dat"
wide(k) = 1 + (1 - 1/1.5) / ((1 - 2/4.5) * (k - 1))
plot x/(x - 1) with lines lw 1.5 lc rgb orange notitle, \
     file using 1:2 with points pt 7 ps 0.7 lc rgb orange title "box, all k", \
     wide(x) with lines lw 1.5 lc rgb green notitle, \
     file using 1:5 with points pt 9 ps 0.8 lc rgb green title "cone, κ = 1.5", \
     1 with lines lw 1.5 lc rgb blue notitle, \
     file using 1:4 with points pt 5 ps 0.7 lc rgb blue title "cone of step 1.6", \
     0.5312 with lines lw 1.5 lc rgb grey notitle, \
     file using 1:6 with points pt 11 ps 0.8 lc rgb grey title "Gaussian as printed"
