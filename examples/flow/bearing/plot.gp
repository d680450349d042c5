# Called by ./study: results/bearing.png
load '../style.gp'
set terminal pngcairo size 900,420 font 'Helvetica,10'
set output 'results/bearing.png'
set multiplot layout 1,2
set title 'length 20 outlets: film (symbols) and Reynolds'' equation'
set xlabel 'x/L'; set ylabel 'p h^2/({/Symbol m} U L)'
set key top left
plot for [K in "1.5 2 3"] 'results/'.K.'.12.20.dat' using ($2/20):($4/20) every ::1 with lines ls 9 notitle, \
	for [k=1:3] 'results/'.word("1.5 2 3", k).'.12.20.dat' using ($2/20):($3/20) every 6::1 \
		with points ls k title 'K = '.word("1.5 2 3", k)
set title 'K = 2: load'
set xlabel 'length by gap at the outlet'; set ylabel '% off Reynolds'' theory'
set logscale xy
set xtics (10, 20, 40)
set xrange [8:50]; set yrange [0.1:10]
set key top right
plot '< awk ''$1 == 2 && $2 == 24'' results/table.txt | sort -g -k3' using 3:(abs($4)) with linespoints ls 1 title '24 cells', \
	430/x**2 with lines ls 9 title '4.3 (h/L)^2'
unset multiplot
