# Called by ./study: results/fluidisation.png
load '../style.gp'
set terminal pngcairo size 520,430 font 'Helvetica,10'
set output 'results/fluidisation.png'
set title 'Air through 500 glass beads of 1 mm'
set xlabel 'superficial velocity, m/s'; set ylabel 'pressure drop, weight of the bed'
set key bottom right
weight = real(system("awk '/^0.1/ { print $4 }' results/0.8.txt"))
plot [0:0.9][0:1.2] 1 with lines ls 9 title 'weight', \
	'results/0.8.txt' using 1:($3 > 0 ? $3/weight : 1/0) with lines ls 3 title 'Ergun, bed at rest', \
	for [last in "0.65 0.7 0.8"] 'results/'.last.'.txt' using 1:($2/weight) with points ls 1 \
		title last eq '0.8' ? 'simulated' : ''
