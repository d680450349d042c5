# Called by ./study: results/settling.png
load '../style.gp'
set terminal pngcairo size 900,400 font 'Helvetica,10'
set output 'results/settling.png'
set multiplot layout 1,2
set title 'A sphere let go: 50 {/Symbol m}m in water, steps of 0.1 {/Symbol t}'
set xlabel 't/{/Symbol t}, {/Symbol t} without added mass'; set ylabel 'v/v_t'
set key bottom right
plot [0:6.2][0:1] 1-exp(-x) with lines ls 9 title 'exponentials', 1-exp(-x/1.2) with lines ls 9 notitle, \
	'results/stokes.txt' using 1:2 with points ls 1 title "Stokes' drag", \
	'results/added.txt' using ($1*1.2):2 with points ls 2 title 'with added mass'
set title 'Drag of a sphere: Schiller and Naumann, and measured'
set xlabel 'Re'; set ylabel 'C_d'
set logscale xy
set key top right
cd(x) = x < 1000 ? 24/x*(1+0.15*x**0.687) : 0.44
set datafile separator ','
plot [1:2e5][0.2:40] cd(x) with lines ls 1 title 'fit', \
	'../../../tests/data/sphere_drag_roos_willmarth1971.csv' using 1:2 with points ls 2 ps 0.4 \
		title 'Roos, Willmarth 1971'
