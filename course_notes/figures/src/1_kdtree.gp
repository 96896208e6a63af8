load "course_notes/figures/src/1_style.gp"
set terminal svg size 480,480 dynamic font "sans-serif,14" background "white"
set output figures . "/1_kdtree.svg"
file = data . "1_kdtree.dat"
unset border
unset tics
unset key
set size ratio -1
set margins 0, 0, 0, 0
set xrange [-0.01:1.01]
set yrange [-0.01:1.01]
plot file index 1 using 1:2:1:3:2:4 with boxxyerror fs empty lc rgb grey lw 1, \
     file index 2 using 1:2:1:3:2:4 with boxxyerror fs transparent solid 0.25 lc rgb orange lw 1.5, \
     file index 0 using 1:2 with points pt 7 ps 0.35 lc rgb blue, \
     file index 3 using 1:2:3 with circles fs empty lw 2 lc rgb "black", \
     file index 3 using 1:2 with points pt 2 ps 1 lw 2 lc rgb "black"
