# Called by ./study: results/poiseuille.png
load '../style.gp'
set terminal pngcairo size 1100,420 font 'Helvetica,10'
set output 'results/poiseuille.png'
set multiplot layout 1,3
set title 'between plates, 10 cells'
set xlabel 'u/U'; set ylabel 'y/H'
set xrange [0:1.75]; set yrange [0:1]
set key left center
plot '+' using (6*$1*(1-$1)):1 with lines ls 9 title 'parabola', \
	'results/plates.inlet.quadratic.10.dat' using 4:2 every ::1 with points ls 1 title 'uniform inlet', \
	'results/plates.force.quadratic.10.dat' using 4:2 every ::1 with points ls 2 pt 4 ps 1.5 title 'body force'
set title 'square duct, 10 cells: planes z/H = 0.05, 0.25, 0.45'
set key top right
row(n, file) = sprintf('< awk ''NF == 5 && $3 > %g-0.01 && $3 < %g+0.01'' %s', n, n, file)
set xrange [0:2.4]
plot for [z in "0.05 0.25 0.45"] row(z+0, 'results/duct.force.quadratic.10.dat') using 5:2 with lines ls 9 notitle, \
	for [z in "0.05 0.25 0.45"] row(z+0, 'results/duct.force.quadratic.10.dat') using 4:2 with points ls 1 notitle
set title 'largest error'
set logscale xy
set xlabel 'h/H'; set ylabel '% of mean velocity'
set xtics (0.05, 0.1, 0.2)
set xrange [0.04:0.25]; set yrange [0.05:30]
set key bottom right
plot 150*x**2 with lines ls 9 title 'second order', \
	of('plates.inlet.quadratic', 'results/errors.txt') using 2:3 with linespoints ls 1 title 'plates, inlet', \
	of('duct.inlet.quadratic', 'results/errors.txt') using 2:3 with linespoints ls 2 title 'duct, inlet', \
	of('duct.force.quadratic', 'results/errors.txt') using 2:3 with linespoints ls 3 title 'duct, force', \
	of('duct.force.linear', 'results/errors.txt') using 2:3 with linespoints ls 4 title 'duct, force, wall linear'
unset multiplot
