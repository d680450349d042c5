# Called by ./study: results/channel_cylinder.png. sizes: cells to the diameter
load '../style.gp'
set terminal pngcairo size 1100,380 font 'Helvetica,10'
set output 'results/channel_cylinder.png'
set multiplot
set grid lc rgb '#e5e5e5' lt 1
set lmargin at screen 0.06; set rmargin at screen 0.36
set tmargin at screen 0.92; set bmargin at screen 0.14
set title 'drag (dashed: greatest and least, converged)'
set xlabel 't, s'; set ylabel 'C_D'
set xrange [0:8]; set xtics 2
set yrange [2.4:3.4]; set ytics 0.2
set key bottom right
plot 3.227393 with lines ls 9 notitle, 3.164263 with lines ls 9 notitle, \
	for [k=1:words(sizes)] 'results/'.word(sizes, k).'.forces' using 1:2 with lines ls k \
		title word(sizes, k).' cells to D'
set lmargin at screen 0.42; set rmargin at screen 0.70
set title 'lift'
set ylabel 'C_L'
set yrange [-1.2:1.2]; set ytics 0.4
plot for [k=1:words(sizes)] 'results/'.word(sizes, k).'.forces' using 1:3 with lines ls k notitle
set lmargin at screen 0.77; set rmargin at screen 0.98
set title 'off the converged values'
set xlabel 'cells to D'; set ylabel '%'
set logscale xy
set xrange [8:100]; set xtics (10, 20, 40, 80)
set yrange [2e-4:200]; set ytics (0.01, 0.1, 1, 10, 100)
set key bottom left
line(name) = sprintf("< awk '$2 == \"%s\"' results/lines", name)
names = "dfg2.Cl.swing dfg2.Cd.greatest dfg2.St dfg1.Cd"
titles = "'swing of C_L' 'greatest C_D' 'St' 'C_D at Re 20'"
plot for [k=1:4] line(word(names, k)) using 1:(100*abs($3/$4 - 1)) with linespoints ls k title word(titles, k), \
	5e3/x**2 with lines ls 9 title 'second order'
unset multiplot
