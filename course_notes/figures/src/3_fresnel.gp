# Fresnel reflectance against the angle of incidence, from air into glass of n = 1.5 and out of it.
set terminal svg size 640,400 dynamic font "sans-serif,14" background "white"
set output system('printf %s "$FIGURES"') . "/3_fresnel.svg"
data = '< "$BUILD/figures/3_curves" fresnel'
set xlabel "angle of incidence, degrees"
set ylabel "share reflected"
set xrange [0:90]
set yrange [0:1.02]
set xtics 15
set key left top Left reverse samplen 2
set label 1 "critical angle\n41.81°" at 43,0.62 textcolor "#d9730d"
set label 2 "Brewster's angle\n56.31°: R_p = 0" at 46,0.38 textcolor "#1b6ca8"
set arrow 2 from 54,0.28 to 56.31,0.005 lc "#1b6ca8" size 1,20
plot data using 1:4 with lines lw 3 lc "#1b6ca8" title "into glass: R", \
     data using 1:2 with lines lw 1.5 dt 2 lc "#1b6ca8" title "into glass: R_s", \
     data using 1:3 with lines lw 1.5 dt 3 lc "#1b6ca8" title "into glass: R_p", \
     data using 1:7 with lines lw 3 lc "#d9730d" title "out of glass: R", \
     data using 1:5 with lines lw 1.5 dt 2 lc "#d9730d" notitle, \
     data using 1:6 with lines lw 1.5 dt 3 lc "#d9730d" notitle
