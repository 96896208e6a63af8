# Indirect light along a line on the back wall: the map looked up at once, and by final gathering.
set terminal svg size 640,520 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/4_line.svg"
data = system('printf %s "$BUILD"') . "/figures/4_line.dat"
set multiplot layout 2,1
set xrange [-0.9:0.9]
set yrange [0:0.1]
set ytics 0.02
set format y "%.2f"
set ylabel "L, W/(m²·sr)"
set lmargin 8
set key bottom center horizontal samplen 2
plot data using 1:2 with lines lw 3 lc "#bbbbbb" title "reference", \
     data using 1:3 with lines lw 2 lc "#d9730d" title "map, looked up at once, k = 100"
set xlabel "x along the wall, m"
plot data using 1:2 with lines lw 3 lc "#bbbbbb" title "reference", \
     data using 1:4 with points pt 2 ps 0.35 lc "#555555" title "16 rays", \
     data using 1:7 with linespoints lw 1.5 pt 7 ps 0.3 lc "#1b6ca8" title "1024 rays"
unset multiplot
