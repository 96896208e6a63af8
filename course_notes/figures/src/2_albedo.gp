load "course_notes/figures/src/2_style.gp"
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output figures . "/2_albedo.svg"
set multiplot
set border 3
set xrange [0:90]
set yrange [0:1.4]
set xtics nomirror 0, 30, 90
set bmargin at screen 0.32
set tmargin at screen 0.92
set lmargin at screen 0.11
set rmargin at screen 0.49
set title "light in, at θ: what goes on" offset 0, -0.5
set xlabel "θ, degrees" offset 0, 0.4
set ylabel "share of the power" offset 0.5
set key at screen 0.03, screen 0.19 left top reverse Left samplen 2.5 maxrows 3 width 1
plot 1 with lines lw 2 lc rgb orange title "source text", \
     data . "2_albedo.dat" index 0 using 1:4 with lines lw 2 dt 3 lc rgb orange title "… its lobe", \
     data . "2_albedo.dat" index 0 using 1:2 with lines lw 2 dt 2 lc rgb green title "absorbed below", \
     data . "2_albedo.dat" index 0 using 1:3 with lines lw 2 lc rgb blue title "modified Phong", \
     1/0 with lines lw 2 dt 4 lc rgb "black" title "redrawn", \
     1/0 with lines lw 2 dt 5 lc rgb grey title "normalised", \
     data . "2_albedo.dat" index 1 using 1:2 with points pt 7 ps 0.5 lc rgb orange notitle, \
     data . "2_albedo.dat" index 1 using 1:3 with points pt 7 ps 0.5 lc rgb green notitle, \
     data . "2_albedo.dat" index 1 using 1:5 with points pt 7 ps 0.5 lc rgb blue notitle
set lmargin at screen 0.62
set rmargin at screen 0.97
unset key
set title "even sky: light out, at θ_o" offset 0, -0.5
set xlabel "θ_o, degrees" offset 0, 0.4
set ylabel "radiance, sky = 1" offset 0.5
set arrow 1 from 0, 1 to 90, 1 nohead lw 0.7 lc rgb grey
plot data . "2_albedo.dat" index 2 using 1:2 with lines lw 2 lc rgb orange, \
     "" index 2 using 1:3 with lines lw 2 dt 4 lc rgb "black", \
     "" index 2 using 1:4 with lines lw 2 lc rgb blue, \
     "" index 2 using 1:5 with lines lw 2 dt 5 lc rgb grey
unset multiplot
