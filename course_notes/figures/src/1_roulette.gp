load "course_notes/figures/src/1_style.gp"
set terminal svg size 640,360 dynamic font "sans-serif,14" background "white"
set output figures . "/1_roulette.svg"
set border 3
set xrange [-4:1]
set yrange [1e-5:2]
set logscale y
set format y "10^{%T}"
set xtics ("1/10 000" -4, "1/1000" -3, "1/100" -2, "1/10" -1, "1" 0, "10" 1)
set xlabel "flux of a stored photon, over what it left the lamp with"
set ylabel "share of photons"
set key top left reverse Left
plot data . "1_roulette.dat" index 2 using 1:2 with boxes fs solid 0.25 lc rgb grey title "no roulette: Φ becomes Φρ", \
     "" index 1 using 1:2 with histeps lw 2 lc rgb orange title "p = mean of ρ", \
     "" index 0 using ($2 > 0 ? 0 : 1/0):2 with impulses lw 5 lc rgb blue title "p from the photon's own channels"
