# Called by ./study: results/plate.png
load '../style.gp'
set terminal pngcairo size 1100,420 font 'Helvetica,10'
set output 'results/plate.png'
set multiplot layout 1,3
set title '20 cells; times in H^2/{/Symbol n}'
set xlabel 'u/U'; set ylabel 'y/H'
set xrange [0:1]; set yrange [0:1]
plot for [t in "0.01 0.04 0.16 0.64"] 'results/quadratic.80.'.t using 4:2 every ::1 with lines ls 9 notitle, \
	for [k=1:4] 'results/quadratic.20.'.word("0.01 0.04 0.16 0.64", k) using 3:2 every ::1 with points ls k \
		title word("0.01 0.04 0.16 0.64", k)
set title 'largest error (dotted: wall linear)'
set logscale xy
set format y '10^{%T}'
set xlabel 'h/H'; set ylabel 'of the velocity of the plate'
set xtics (0.0125, 0.025, 0.05, 0.1)
set xrange [0.01:0.12]; set yrange [1e-7:0.1]
set key bottom right
plot x**2 with lines ls 9 title 'second order', \
	for [k=1:4] of('quadratic.at.'.word("0.01 0.04 0.16 0.64", k), 'results/space.txt') using 2:3 \
		with linespoints ls k title 't = '.word("0.01 0.04 0.16 0.64", k), \
	for [k=1:4] of('linear.at.'.word("0.01 0.04 0.16 0.64", k), 'results/space.txt') using 2:3 \
		with linespoints ls k dt 3 pt 6 notitle
schemes = "euler ab2 rk2 rk3 implicit backward"
set style line 6 lc rgb '#b03a2e' lw 1.8 pt 4 ps 0.9
set title '16 cells, t = 0.04: error of the time step'
set xlabel 'step, in limits of explicit diffusion'; set ylabel ''
set xtics (0.0625, 0.125, 0.25, 0.5)
set xrange [0.05:0.6]; set yrange [1e-13:0.1]
plot 0.003*x with lines ls 9 title 'orders 1, 2, 3', 0.001*x**2 with lines ls 9 notitle, \
	0.0003*x**3 with lines ls 9 notitle, \
	for [k=1:6] of(word(schemes, k), 'results/time.txt') using 2:3 with linespoints ls k title word(schemes, k)
unset multiplot
