load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,330 dynamic font "sans-serif,14" background "white"
set output figures . "/1_cosine.svg"
set multiplot
set origin 0, 0
set size 0.45, 1
set size ratio -1
unset border
unset tics
set lmargin at screen 0.02
set rmargin at screen 0.43
set xrange [-1.1:1.1]
set yrange [-1.25:1.1]
set object 1 circle at 0, 0 size 1 fillstyle empty border lc rgb grey lw 1
set label 1 "500 samples, seen along the normal" at 0, -1.2 center
plot data . "1_cosine.dat" index 1 using 1:2 with points pt 7 ps 0.22 lc rgb blue notitle
unset label 1
unset object 1
set size noratio
set origin 0.45, 0
set size 0.55, 1
set border 3
set xtics nomirror
set ytics nomirror
set lmargin at screen 0.55
set rmargin at screen 0.97
set xrange [0:1]
set yrange [0:2.9]
set xlabel "cos θ"
set ylabel "density of cos θ" offset 1
set key top left reverse Left
plot data . "1_cosine.dat" index 0 using 1:2 with boxes fs solid 0.35 lc rgb blue title "100 000 samples", \
     2*x with lines lw 2 lc rgb orange title "2 cos θ", \
     1 with lines lw 1.5 dt 2 lc rgb grey title "uniform hemisphere"
unset multiplot
