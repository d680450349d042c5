# Called by ./study: results/cylinder.png
load '../style.gp'
data = '../../../tests/data/'
set terminal pngcairo size 1250,420 font 'Helvetica,10'
set output 'results/cylinder.png'
set datafile missing '-'
set multiplot layout 1,3
tables = system("ls results/table.* | sed 's/.*table[.]//'")
set xlabel 'Re'
set xrange [0:180]
set title 'Strouhal number'
set ylabel 'f D/U'
set key bottom right
set yrange [0.1:0.2]
set xrange [40:180]
csv(file) = '< sed "s/,,/,-,/; s/,/ /g" '.data.file
plot [49:178] 0.1816 - 3.3265/x + 1.6e-4*x with lines ls 9 dt 1 title 'Williamson 1988, parallel', \
	0.212*(1 - 21.2/x) with lines ls 9 title 'Roshko 1954', \
	csv('cylinder_williamson1989.csv') using 2:3 every ::1 with points lc rgb '#bbbbbb' pt 6 ps 0.4 title 'measured (oblique above Re 64)', \
	csv('cylinder_computed.csv') using 1:4 with points lc rgb '#444444' pt 2 ps 0.9 title 'grid that fits', \
	for [k=1:words(tables)] 'results/table.'.word(tables, k) using 1:2 with points ls k ps 1.1 \
		title word(tables, k).' cells to D'
set title 'length of the bubble in the mean flow'
set ylabel 'L/D'
set xrange [0:180]
set yrange [0:2.6]
set key bottom right
plot csv('cylinder_computed.csv') using 1:5 with linespoints lc rgb '#444444' pt 2 ps 0.9 title 'grid that fits', \
	for [k=1:words(tables)] 'results/table.'.word(tables, k) using 1:5 with points ls k ps 1.1 \
		title word(tables, k).' cells to D'
set title 'drag coefficient'
set ylabel 'mean C_D'
set yrange [1:2.4]
set key top right
plot csv('cylinder_computed.csv') using 1:2 with linespoints lc rgb '#444444' pt 2 ps 0.9 title 'grid that fits', \
	for [k=1:words(tables)] 'results/table.'.word(tables, k) using 1:7 with points ls k ps 1.1 \
		title word(tables, k).' cells to D'
unset multiplot
