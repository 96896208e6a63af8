load "course_notes/figures/src/2_style.gp"
set terminal svg size 640,340 dynamic font "sans-serif,14" background "white"
set output figures . "/2_misprint.svg"
set multiplot
set size ratio -1
unset border
unset tics
set lmargin at screen 0.02
set rmargin at screen 0.48
set tmargin at screen 0.97
set bmargin at screen 0.2
set xrange [-1.12:1.12]
set yrange [-0.15:1.12]
set arrow 1 from 0, -0.1 to 0, 1.1 lc rgb grey lw 1
set label 1 "axis" at 0.03, 1.1
set key at screen 0.04, screen 0.16 left top vertical samplen 1 reverse Left
plot data . "2_sample.dat" index 2 using 1:2 with points pt 7 ps 0.25 lc rgb blue title "z = u^{1/(n+1)}", \
     "" index 2 using 1:3 with points pt 6 ps 0.35 lc rgb orange title "z = 1 − u^{1/(n+1)}"
unset arrow 1
unset label 1
set size noratio
set border 3
set tics nomirror
set xtics nomirror 0, 15, 90
set ytics nomirror 0.02
set lmargin at screen 0.6
set rmargin at screen 0.97
set bmargin at screen 0.18
set xrange [0:90]
set yrange [0:0.13]
set xlabel "angle to the axis, degrees"
set ylabel "share per degree"
set key at graph 0.98, graph 0.98 right top samplen 2 noreverse Right vertical
set style fill solid 0.3 noborder
set boxwidth 1
n = 20
right(a) = (n + 1) * cos(a*rad)**n * sin(a*rad) * rad
plot data . "2_sample.dat" index 1 using 1:2 with boxes lc rgb blue notitle, \
     "" index 1 using 1:3 with boxes lc rgb orange notitle, \
     right(x) with lines lw 2 lc rgb blue title "as in the code", \
     (x > 45 ? 2*right(2*(90 - x)) : NaN) with lines lw 2 dt 2 lc rgb orange title "as in the prose"
unset multiplot
