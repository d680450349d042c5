# Called by ./study: results/filter.png
load '../style.gp'
set terminal pngcairo size 520,430 font 'Helvetica,10'
set output 'results/filter.png'
set title 'Water through a bed of 900 spheres of 1 mm'
set xlabel 'superficial velocity, mm/s'; set ylabel 'pressure gradient, Pa/m'
set logscale xy
set key top left
plot [1.5:60] 'results/ergun.txt' using ($1*1000):3 with lines ls 9 title 'equations, by the void fraction', \
	'results/carman.txt' using ($1*1000):3 with lines ls 9 notitle, \
	'results/ergun.txt' using ($1*1000):2 with points ls 1 title 'drag/ergun', \
	'results/carman.txt' using ($1*1000):2 with points ls 2 title 'C1 180 C2 0 (Carman, Kozeny)'
