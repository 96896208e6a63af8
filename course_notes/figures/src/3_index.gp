# Refractive index against wavelength; above: as it is, below: what it changes from its value at 587.6 nm.
set terminal svg size 640,640 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/3_index.svg"
data = '< "$BUILD/figures/3_curves" index'
set multiplot layout 2,1
set xrange [400:700]
set for [nm in "464.31 549.13 611.28"] arrow from nm, graph 0 to nm, graph 1 nohead dt 2 lc "#999999"
set lmargin 10
set rmargin 14
set ylabel "n"
set yrange [1.2:2.6]
set key off
set label 1 "B" at 464.31,2.53 center
set label 2 "G" at 549.13,2.53 center
set label 3 "R" at 611.28,2.53 center
set label 11 "diamond" at 704,2.41
set label 12 "N-SF11" at 704,1.80
set label 13 "SF10" at 704,1.69
set label 14 "N-BK7" at 704,1.55
set label 15 "fused silica" at 704,1.44
set label 16 "water" at 704,1.33
plot for [c=2:7] data using 1:c with lines lw 2 lc rgb word("#1b6ca8 #555555 #3a7d44 #555555 #1b6ca8 #d9730d", c-1)
set for [i=11:16] label i ""
unset label 1
unset label 2
unset label 3
unset for [i=11:16] label i
set xlabel "wavelength, nm"
set ylabel "n − n_d"
set yrange [-0.015:0.08]
set key right top Left reverse samplen 2
set format y "%.2f"
plot data using 1:13 with lines lw 2.5 lc "#d9730d" title "N-SF11", \
     data using 1:15 with lines lw 1.5 dt 3 lc "#d9730d" title "its Cauchy curve", \
     data using 1:12 with lines lw 2.5 lc "#1b6ca8" title "SF10", \
     data using 1:11 with lines lw 1.5 dt 5 lc "#555555" title "diamond", \
     data using 1:10 with lines lw 2.5 lc "#3a7d44" title "N-BK7", \
     data using 1:8 with lines lw 1.5 dt 2 lc "#1b6ca8" title "water"
unset multiplot
