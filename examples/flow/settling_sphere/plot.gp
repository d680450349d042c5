# Called by ./study: results/settling.png. Horizontal lines: the greatest velocities measured.
load '../style.gp'
set terminal pngcairo size 700,440 font 'Helvetica,10'
set output 'results/settling.png'
set xlabel 't, s'; set ylabel 'velocity, m/s'
set yrange [0:0.15]
set key top right horizontal
Re(k) = word("1.5 4.1 11.6 31.9", k)
most(k) = real(word("0.03599 0.05718 0.08727 0.12224", k))
plot for [k=1:4] most(k) with lines ls 9 notitle, \
	for [k=1:4] 'results/'.Re(k) using 1:3 with lines ls k title 'Re = '.Re(k)
