# Called by ./study: results/cavity.png, results/cost.png. N: cells a side of the profiles
load '../style.gp'
set terminal pngcairo size 1100,420 font 'Helvetica,10'
set output 'results/cavity.png'
set multiplot layout 1,3
set title 'on the vertical middle line, '.N.'^2 cells, quick'
set xlabel 'u/U'; set ylabel 'y'
set key bottom right
Re(k) = word("100 400 1000", k)
plot for [k=1:3] 'results/quick.fv.'.Re(k).'.'.N.'.u' using 4:2 every ::1 with lines ls 9 notitle, \
	for [k=1:3] 'results/quick.fv.'.Re(k).'.'.N.'.u' using 3:2 every 4::1 with points ls k title 'Re '.Re(k), \
	for [k=1:3] 'ghia1982.u' using k+1:1 with points lc rgb '#444444' pt 2 ps 0.6 notitle
set title 'on the horizontal one (crosses: Ghia et al. 1982)'
set xlabel 'x'; set ylabel 'v/U'
set key top right
plot for [k=1:3] 'results/quick.fv.'.Re(k).'.'.N.'.v' using 2:4 every ::1 with lines ls 9 notitle, \
	for [k=1:3] 'results/quick.fv.'.Re(k).'.'.N.'.v' using 2:3 every 4::1 with points ls k notitle, \
	for [k=1:3] 'ghia1982.v' using 1:k+1 with points lc rgb '#444444' pt 2 ps 0.6 notitle
set title 'largest error, Re = 1000'
set logscale xy
set xlabel 'cells a side'; set ylabel '% of the lid speed'
set xrange [N/5.:N*1.25]; set yrange [0.1:50]
set xtics (16, 32, 64, 128, 256)
set key bottom left
schemes = "donor.fv donor.fd central.fv central.fd quick.fv cubista.fv central.graded quick.graded"
at(key, re) = sprintf('< awk ''$1 == "%s" && $2 == %d'' results/schemes.txt', key, re)
set style line 6 lc rgb '#b03a2e' lw 1.8 pt 4 ps 0.9
set style line 7 lc rgb '#328cc1' lw 1.8 dt 2 pt 8 ps 0.9
set style line 8 lc rgb '#8a4f7d' lw 1.8 dt 2 pt 10 ps 0.9
plot 40*(32/x)**2/4 with lines ls 9 title 'second order', \
	for [k=1:8] at(word(schemes, k), 1000) using 3:(100*$4) with linespoints ls k title word(schemes, k)
unset multiplot

reset
load '../style.gp'
set style line 6 lc rgb '#b03a2e' lw 1.8 pt 4 ps 0.9
set style line 7 lc rgb '#328cc1' lw 1.8 dt 2 pt 8 ps 0.9
set style line 8 lc rgb '#8a4f7d' lw 1.8 dt 2 pt 10 ps 0.9
set terminal pngcairo size 900,420 font 'Helvetica,10'
set output 'results/cost.png'
set multiplot layout 1,2
set logscale xy
set xlabel 'seconds'; set ylabel 'largest error, % of the lid speed'
set yrange [0.1:50]
set key bottom left
set title 'schemes, Re = 1000, direct solver'
plot for [k=1:8] at(word(schemes, k), 1000) using 5:(100*$4) with linespoints ls k title word(schemes, k)
set title 'solvers of the pressure, quick'
set yrange [0.5:20]
plot for [k=1:4] of(word("direct multigrid cg sor", k), 'results/solvers.txt') using 5:(100*$4) \
	with linespoints ls k title word("direct multigrid cg sor", k)
unset multiplot
