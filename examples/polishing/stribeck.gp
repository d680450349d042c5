# Picture of in.stribeck: gnuplot stribeck.gp
set terminal pngcairo size 1000,400 font ",10"
set output "post/stribeck.png"
set multiplot layout 1,2
set logscale x
set format x "10^{%T}"
set xlabel "Hersey number {/Symbol h} U/(P L)"
set ylabel "coefficient of friction"
set logscale y
set key left center
smooth = system("tail -n 1 post/stribeck.txt | awk '{ print $2/sqrt($1) }'")
plot [1e-10:3e-5] [5e-4:0.3] "post/stribeck.txt" u 1:2 w linespoints pt 7 t "rough bearing", \
     smooth*sqrt(x) w lines dt 2 lc "black" t "smooth bearing, closed form of the last K", 0.12 w lines dt 3 lc "black" t "boundary, 0.12"
unset logscale y
set ylabel "part of the load on the film"
set y2label "least gap by {/Symbol s}"
set y2tics
set logscale y2
set key top left
plot [1e-10:3e-5] [0:1.1] "post/stribeck.txt" u 1:3 w linespoints pt 7 t "film", "" u 1:4 axes x1y2 w lines lw 2 t "gap by {/Symbol s}"
unset multiplot
