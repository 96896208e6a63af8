# What the plots of chapter 5 share: where files lie, colours readable in grey, thin axes.
figures = system("echo \"${FIGURES:-course_notes/figures}\"")
data = system("echo \"${BUILD:-build}\"") . "/figures/"
set encoding utf8
blue = "#1b6ca8"; orange = "#d9730d"; grey = "#555555"; green = "#3a7d44"
set border lw 0.8 lc rgb grey
set tics nomirror
set key spacing 1.2
