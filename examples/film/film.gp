# Profiles of in.film by its three models: gnuplot -e 'out="post"' film.gp, after
#	tsim -in in.film -var model automaton; tsim -in in.film -var model kinetic; tsim -in in.film -var model dem
if (!exists("out")) out = "post"
load "../flow/style.gp"
set terminal pngcairo size 1000,400 font ",10"
file(model) = sprintf("%s/profile_%s.txt", out, model)
set output sprintf("%s/film.png", out)
set multiplot layout 1,3
set bmargin at screen 0.15 # the same for all, whatever the height of the labels
set tmargin at screen 0.96
set ylabel "y/H"
set yrange [0:1]
set key top right
set xlabel "u/U"
set xrange [0:1]
plot file("dem") u 2:1:5 w xerrorlines ls 1 t "grains", file("kinetic") u 2:1 w l ls 2 t "theory", \
     file("automaton") u 2:1:5 w xerrorlines ls 3 t "automaton"
set key off
set xlabel "nu / mean nu"
set xrange [*:*]
set xtics 0.1
plot file("dem") u 3:1:6 w xerrorlines ls 1, file("kinetic") u 3:1 w l ls 2, file("automaton") u 3:1:6 w xerrorlines ls 3
set xlabel "T/U^2"
set logscale x
set xrange [1e-3:1]
set xtics 10
set format x "10^{%T}"
plot file("dem") u 4:1:7 w xerrorlines ls 1, file("kinetic") u 4:1 w l ls 2, file("automaton") u 4:1:7 w xerrorlines ls 3
unset multiplot
