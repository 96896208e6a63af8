# Left: the vectors of step 3.1, light from air into glass of n = 1.5 at 60°. Right: out of the glass, at six angles.
set terminal svg size 640,360 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/3_snell.svg"
set multiplot layout 1,2
unset border
unset tics
set key off
set size ratio -1
set xrange [-1.1:1.15]
set yrange [-1.25:1.15]
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
set angles degrees
a = 60.0
t = asin(sin(a)/1.5)
set object 1 rectangle from -1.1,-1.25 to 1.15,0 fillcolor "#e3edf4" fillstyle solid noborder behind
set arrow 1 from -1.1,0 to 1.15,0 nohead lc "#555555"
set arrow 2 from 0,0 to 0,1 lw 2 lc "#555555" size 0.08,20
set arrow 3 from -sin(a),cos(a) to 0,0 lw 3 lc "#d9730d" size 0.08,20
set arrow 4 from 0,0 to sin(t),-cos(t) lw 3 lc "#1b6ca8" size 0.08,20
set arrow 5 from 0,0 to 0,-1.1 nohead dt 2 lc "#555555"
set arrow 6 from -sin(a),cos(a) to 0,cos(a) dt 2 lw 2 lc "#d9730d" size 0.06,20
set arrow 7 from 0,-cos(t) to sin(t),-cos(t) dt 2 lw 2 lc "#1b6ca8" size 0.06,20
set label 1 "n" at 0.05,0.95
set label 2 "d" at -0.66,0.22 textcolor "#d9730d"
set label 3 "t" at 0.43,-0.42 textcolor "#1b6ca8"
set label 4 "sin θ_i" at -0.55,0.60 textcolor "#d9730d"
set label 5 "sin θ_t = η sin θ_i" at 0.02,-0.95 textcolor "#1b6ca8"
set label 6 "θ_i" at -0.20,0.30
set label 7 "θ_t" at 0.03,-0.32
set label 8 "cos θ_t" at -0.42,-0.45 textcolor "#1b6ca8"
set label 9 "air" at 0.8,0.12
set label 10 "glass" at 0.8,-0.10
plot NaN
unset label
unset arrow
set arrow 1 from -1.1,0 to 1.15,0 nohead lc "#555555"
set arrow 5 from 0,-1.1 to 0,1.1 nohead dt 2 lc "#555555"
set label 1 "50° and 65°:\nall of it\ncomes back" at 0.42,-0.88
set label 2 "20°" at -0.38,-1.07 center
set label 3 "35°" at -0.66,-0.93 center
set label 4 "65°" at -1.02,-0.50 center
set label 5 "41°" at 1.0,0.26
set label 6 "41°" at -0.74,-0.80 center
set label 7 "50°" at -0.88,-0.68 center
data = '< "$BUILD/figures/3_curves" total'
plot data using 2:3:(-$2):(-$3) with vectors nohead lw 1 lc "#555555", \
     data using (0):(0):4:5 with vectors nohead lw 2 lc "#d9730d", \
     data using (0):(0):7:8 with vectors nohead lw 2 lc "#1b6ca8"
unset multiplot
