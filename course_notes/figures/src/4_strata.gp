load "course_notes/figures/src/4_style.gp"
set terminal svg size 640,330 dynamic font "sans-serif,14" background "white"
set output figures . "/4_strata.svg"
set multiplot layout 1,2
set size ratio -1
unset border
unset tics
set xrange [-1.02:1.02]
set yrange [-1.02:1.02]
set object 1 circle at 0,0 size 1 fc rgb grey lw 1
set title "chance"
plot data . "4_strata.dat" index 0 using 1:2 with points pt 7 ps 0.28 lc rgb orange notitle
set title "one ray a cell"
do for [j=1:11] { set object 10+j circle at 0,0 size sqrt(j/12.0) fc rgb "#cccccc" lw 0.6 }
do for [k=0:35] { set arrow 10+k from 0,0 to cos(2*pi*k/36), sin(2*pi*k/36) nohead lc rgb "#cccccc" lw 0.6 }
plot data . "4_strata.dat" index 1 using 1:2 with points pt 7 ps 0.28 lc rgb blue notitle
unset multiplot
