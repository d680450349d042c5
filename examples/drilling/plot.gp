# Plots of the four studies: called by ./study
set style line 1 lc rgb '#1f4e79' lw 2 pt 7 ps 0.9
set style line 2 lc rgb '#c55a11' lw 2 pt 5 ps 0.9
set style line 3 lc rgb '#777777' lw 1 dt 2
set grid lc rgb '#dddddd'
set key off
set bars small
do for [format in "svg png"] {
	if (format eq "svg") { set terminal svg size 1000,760 font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 1000,760 font 'Helvetica,11' }
	set output 'results/study.'.format
	set multiplot layout 2,2 title 'Rotary drilling of bonded rock: means over rocks, bars: standard error'
	set yrange [0:*]
	set ylabel 'ROP*'
	set xlabel 'bond strength F_{ult}*'
	set title 'thesis: falls with strength (fig. 7.6)'
	plot 'results/Fult.dat' using 1:3:4 with yerrorlines ls 1
	set xlabel 'weight on bit WOB*'
	set yrange [-0.001:*]
	set title 'thesis: rises with weight above a threshold (7.7, 7.8)'
	plot 'results/WOB.dat' using 1:3:4 with yerrorlines ls 1
	set yrange [0:*]
	set xtics 0.0005
	set xrange [0:*]
	set xlabel 'viscosity {/Symbol h}*'
	set title 'thesis: ROP (7.9) and CER (7.10) rise'
	set ytics nomirror
	set y2tics
	set y2range [0:*]
	set y2label 'CER*'
	set key top left
	plot 'results/eta.dat' using 1:3:4 with yerrorlines ls 1 title 'ROP*', \
	     '' using 1:5:6 axes x1y2 with yerrorlines ls 2 title 'CER*'
	set key off
	set xtics auto
	set logscale x
	set xrange [0.015:2]
	set xlabel 'angular velocity {/Symbol w}*'
	set title 'thesis: rises, then falls as the bit bounces (7.11)'
	set y2label 'bounce*'
	set key bottom center
	plot 'results/omega.dat' using 1:3:4 with yerrorlines ls 1 title 'ROP*', \
	     '' using 1:13:14 axes x1y2 with yerrorlines ls 2 title 'part of the time without contact'
	set key off
	unset logscale x
	set xrange [*:*]
	unset y2tics
	unset y2label
	set ytics mirror
	unset multiplot
	unset output
}
