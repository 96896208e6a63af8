load "course_notes/figures/src/2_style.gp"
set terminal svg size 640,360 dynamic font "sans-serif,14" background "white"
set output figures . "/2_sample.svg"
set border 3
set logscale y
set xrange [0:1]
set yrange [0.002:30]
set format y "%g"
set xlabel "cos α"
set ylabel "density of cos α"
set key bottom right reverse Left
d(n, x) = (n + 1) * x**n
measured = data . "2_sample.dat"
plot measured index 0 using 1:2 with points pt 7 ps 0.45 lc rgb blue notitle, \
     measured index 0 using 1:3 with points pt 9 ps 0.5 lc rgb orange notitle, \
     measured index 0 using 1:($4 > 0 ? $4 : NaN) with points pt 5 ps 0.4 lc rgb green notitle, \
     d(1, x) with lines lw 1.5 lc rgb blue title "n = 1", \
     d(5, x) with lines lw 1.5 dt 2 lc rgb orange title "n = 5", \
     d(20, x) with lines lw 1.5 lc rgb green title "n = 20"
