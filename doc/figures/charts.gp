# Charts of doc/accuracy.md; run by charts.sh in doc/figures.
set style line 1 lc rgb '#0b3c5d' lw 1.8 pt 7 ps 0.6
set style line 2 lc rgb '#328cc1' lw 1.8 pt 5 ps 0.6
set style line 3 lc rgb '#d9782d' lw 1.8 pt 9 ps 0.7
set style line 4 lc rgb '#7a5195' lw 1.8 pt 13 ps 0.7
set style line 5 lc rgb '#2f8f4e' lw 1.8 pt 11 ps 0.7
set style line 9 lc rgb '#999999' lw 1 dt 2
set border 3 lc rgb '#444444'
set tics nomirror
array name[3] = ["fix nve", "fix nve/symplectic", "fix nve/euler"]
array e[5] = ["1", "0.8", "0.6", "0.4", "0.2"]

do for [format in "svg png"] {
	if (format eq "svg") { set terminal svg size 1080,420 font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 1080,420 font 'Helvetica,10' }

	set output 'restitution.'.format
	set multiplot layout 1,3
	set logscale xy
	set xrange [12:17000]
	set yrange [1e-9:3]
	set format y '10^{%T}'
	set format x '10^{%T}'
	set grid lc rgb '#e5e5e5' lt 1
	set xlabel 'steps per contact'
	do for [s=1:3] {
		set title name[s]
		if (s == 1) { set ylabel 'relative error of the coefficient of restitution' } else { unset ylabel }
		if (s == 3) { set key at graph 0.04, graph 0.42 left reverse Left samplen 2 } else { set key off }
		plot for [k=1:5] 'restitution.dat' index (s-1)*5+k-1 using 3:4 with linespoints ls k \
			title 'e = '.e[k], 4/x with lines ls 9 title 'first order (4/n)'
	}
	unset multiplot

	if (format eq "svg") { set terminal svg size 640,440 font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 640,440 font 'Helvetica,10' }
	set output 'stability.'.format
	unset logscale
	unset grid
	set format '%g'
	set title 'Largest stable time step, measured by bisection'
	set xlabel 'damping {/Symbol g}/{/Symbol w}_0'
	set ylabel '{/Symbol w}_0 h'
	set xrange [-0.02:1]
	set yrange [0:2.2]
	set key top center reverse Left samplen 2
	plot 2*(sqrt(1+x*x)-x) with lines ls 1 title '2({/Symbol \326}(1+b^2) - b), b = {/Symbol g}/{/Symbol w}_0', \
	     2*x with lines ls 3 title '2b', \
	     '< grep -E " nve " stability.dat' using 3:4 with points ls 1 ps 1.1 title 'nve', \
	     '< grep nve/symplectic stability.dat' using 3:4 with points pt 6 ps 1.9 lc rgb '#328cc1' title 'nve/symplectic', \
	     '< grep nve/euler stability.dat' using 3:4 with points ls 3 ps 1.1 title 'nve/euler'
	unset output
}
