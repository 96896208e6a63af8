load "course_notes/figures/src/2_style.gp"
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output figures . "/2_gap.svg"
theta = 60
n = 10
above = 0.547818 # I_P at n = 10, θ = 60°
p(a) = cos((a - theta)*rad) > 0 ? 0.75 * cos((a - theta)*rad)**n / above : cos(a*rad) / pi
set multiplot
set size ratio -1
unset border
unset tics
set lmargin at screen 0.01
set rmargin at screen 0.53
set tmargin at screen 0.97
set bmargin at screen 0.15
set xrange [-0.62:1.35]
set yrange [-0.25:1.05]
set arrow 1 from -0.62, 0 to 1.35, 0 nohead lc rgb grey lw 2
set arrow 2 from 0, 0 to 0, 0.9 lc rgb grey lw 1
set label 2 "normal" at 0.03, 0.88
set arrow 3 from -0.6, 0.6/tan(theta*rad) to -0.03, 0.017 lc rgb grey lw 2
set label 3 "photon" at -0.62, 0.42
set arrow 4 from 0, 0 to -0.5*0.95, 0.866*0.95 nohead dt 2 lc rgb grey lw 1
set label 4 "α = 90°" at -0.6, 0.9
set label 5 "gap" at 0.02, 0.38
set label 6 "stays diffuse" at -0.6, -0.1
set arrow 6 from -0.3, -0.07 to -0.14, 0.1 lc rgb grey lw 1
set parametric
set trange [-90:90]
plot p(t)*sin(t*rad), p(t)*cos(t*rad) with lines lw 1.5 lc rgb orange notitle, \
     data . "2_gap.dat" using ($2*sin($1*rad)):($2*cos($1*rad)) with points pt 7 ps 0.35 lc rgb blue notitle
unset parametric
unset arrow
unset label
set size noratio
set border 3
set tics nomirror
set lmargin at screen 0.62
set rmargin at screen 0.97
set logscale y
set xrange [-90:90]
set yrange [1e-4:12]
set format y "10^{%T}"
set xtics nomirror -90, 45, 90
set ytics nomirror
set xlabel "angle to the normal, degrees"
set ylabel "density, 1/sr" offset 1
set key top left reverse Left samplen 2
set arrow 7 from -30, 1e-4 to -30, 1 nohead dt 2 lc rgb grey
plot data . "2_gap.dat" using 1:($2 > 0 ? $2 : NaN) with points pt 7 ps 0.4 lc rgb blue title "drawn", \
     p(x) with lines lw 1.5 lc rgb orange title "formula"
unset multiplot
