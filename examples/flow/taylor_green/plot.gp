# Called by ./study: results/taylor_green.png
load '../style.gp'
set terminal pngcairo size 900,420 font 'Helvetica,10'
set output 'results/taylor_green.png'
set multiplot layout 1,2
set logscale xy
set format y '10^{%T}'
set title 'largest error at t = 1, of the amplitude'
set xlabel 'h/side'
set xtics ('1/128' 1/128., '1/64' 1/64., '1/32' 1/32., '1/16' 1/16.)
set xrange [0.006:0.08]; set yrange [1e-5:1]
set key bottom right
keys = "central.fv quick.fv cubista.fv donor.fv"
plot 5*x**2 with lines ls 9 title 'second order', \
	for [k=1:4] of(word(keys, k), 'results/space.txt') using 2:3 with linespoints ls k title word(keys, k), \
	of('central.fd', 'results/space.txt') using 2:3 with points ls 5 pt 6 ps 1.6 title 'central.fd'
set title '32^2 cells: error of the time step'
set xlabel 'step'
set xtics (0.005, 0.01, 0.02, 0.04)
set xrange [0.004:0.05]; set yrange [1e-9:0.1]
plot 0.1*x with lines ls 9 title 'orders 1, 2, 3', 0.1*x**2 with lines ls 9 notitle, 0.1*x**3 with lines ls 9 notitle, \
	for [k=1:4] of(word("euler ab2 rk2 rk3", k), 'results/time.txt') using 2:3 \
		with linespoints ls k title word("euler ab2 rk2 rk3", k)
unset multiplot
