# Called by ./study: results/gap.png
load '../flow/style.gp'
set terminal pngcairo size 900,420 font 'Helvetica,10'
set output 'results/gap.png'
set multiplot layout 1,2
set title 'full equations: load beside Reynolds'' theory'
set xlabel 'length by gap at the outlet'; set ylabel '% off'
set logscale xy
set xtics (5, 10, 20, 40)
set xrange [4:50]; set yrange [0.1:100]
set key top right
plot for [k=1:2] '< awk ''$1 == "cfd" && $3 == '.word("12 24", k)."' results/table.txt" using 2:(abs($4)) \
		with linespoints ls k title word("12 24", k).' cells', 450/x**2 with lines ls 9 title '4.5 (h/L)^2'
set title 'length 20: error of the numerical solution against its price'
set xlabel 'processor seconds'; set ylabel '% off in the load'
set xtics auto
set xrange [0.001:1000]; set yrange [0.0001:100]
plot '< awk ''$1 == "film" && $2 == 20'' results/table.txt' using ($7 + 0.001):(abs($4)) \
		with linespoints ls 1 title 'film, to Reynolds'' theory', \
	'< awk ''$1 == "cfd" && $2 == 20'' results/table.txt' using 7:(abs($4)) \
		with linespoints ls 2 title 'full equations, to Reynolds'' theory'
unset multiplot
