load "course_notes/figures/src/2_style.gp"
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output figures . "/2_lobes.svg"
set size ratio -1
unset border
unset tics
set lmargin 1
set rmargin 1
set tmargin 0.5
set bmargin 0.5
set xrange [-1.0:1.3]
set yrange [-0.38:1.12]
set parametric
set trange [-90:90]
theta = 55
set arrow 1 from -1, 0 to 1.3, 0 nohead lc rgb grey lw 2
set arrow 2 from 0, 0 to 0, 1.0 lc rgb grey lw 1
set label 2 "normal" at 0.03, 1.03
set arrow 3 from -0.85*sin(theta*rad)*1.1, 0.85*cos(theta*rad)*1.1 to -0.02, 0.014 lc rgb grey lw 2
set label 3 "photon" at -0.93, 0.6
set arrow 4 from 0, 0 to 1.15*sin(theta*rad), 1.15*cos(theta*rad) lc rgb grey lw 1
set label 4 "mirror direction" at 0.88, 0.74
set label 5 "surface" at 1.02, -0.06
set label 6 "θ" at -0.2, 0.27
set label 7 "θ" at 0.06, 0.62
x(n, t) = cos(t*rad)**n * sin((theta+t)*rad)
y(n, t) = cos(t*rad)**n * cos((theta+t)*rad)
set key at -0.45, -0.03 samplen 2
plot x(1,t), y(1,t) with lines lw 2 lc rgb blue title "n = 1", \
     x(5,t), y(5,t) with lines lw 2 dt 2 lc rgb orange title "n = 5", \
     x(20,t), y(20,t) with lines lw 2 lc rgb green title "n = 20", \
     x(100,t), y(100,t) with lines lw 2 dt 3 lc rgb "black" title "n = 100"
