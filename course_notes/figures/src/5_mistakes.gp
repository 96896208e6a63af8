# Mistakes at one point: the error of the mean over the passes.
load "course_notes/figures/src/5_style.gp"
set terminal svg size 640,460 dynamic font "sans-serif,14" background "white"
set output figures . "/5_mistakes.svg"
table = data . "5_point.dat"
set logscale xy
set xrange [1:10000]
set format x "10^{%T}"
set yrange [0.008:2]
set xlabel "passes"
set ylabel "error, rms"
set key below Left reverse samplen 2 maxcols 3
plot table using 1:19 with lines lw 1.5 lc rgb grey title "the last pass alone", \
     table using 1:17 with lines lw 1.5 dt 4 lc rgb grey title "the same seed", \
     table using 1:13 with lines lw 2 lc rgb green title "(αi + 1)/(i + 1)", \
     table using 1:11 with lines lw 2 dt 2 lc rgb orange title "r for r²", \
     table using 1:9 with lines lw 2 dt 3 lc rgb blue title "counted from 0", \
     table using 1:5 with lines lw 2.5 lc rgb blue title "right"
