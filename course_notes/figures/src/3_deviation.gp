# By how much a 60° prism of N-SF11 turns red, green and blue, against the angle of incidence.
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/3_deviation.svg"
data = '< "$BUILD/figures/3_curves" deviation'
set xlabel "angle of incidence, degrees"
set ylabel "deviation D, degrees"
set xrange [40:90]
set yrange [58:90]
set datafile missing "nan"
set key right bottom Left reverse samplen 2
set object 1 rectangle from 40,58 to 50.955,90 fillcolor "#eeeeee" fillstyle solid noborder behind
set label 1 "black prism:\nnothing leaves\nthrough face 2" at 41,86
set for [x in "45 51.5 63.5935"] arrow from x,58 to x,90 nohead dt 2 lc "#999999"
set label 2 "51.5°: only red" at 51.9,88.6
set label 3 "63.59°: green turns least" at 64,88.6
plot data using 1:4 with lines lw 3 lc "#1b6ca8" title "blue, n = 1.81369", \
     data using 1:3 with lines lw 3 dt 4 lc "#3a7d44" title "green, n = 1.79132", \
     data using 1:2 with lines lw 3 dt 2 lc "#d9730d" title "red, n = 1.78133"
