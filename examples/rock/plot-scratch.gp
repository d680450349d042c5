# Scratch tests: energy and force against depth, the force along the path, and the block cut open, grains coloured by
# fragment. Called by ./study-scratch; after one run of in.scratch, with its files in post:
#   gnuplot -e "run='post'" plot-scratch.gp        draws the lower half only
table = 'post/scratch.txt'
study = !exists("run")
if (study) { run = 'post/scratch.1.2.5'; out = 'post/scratch' } else { out = run.'/scratch' }
d = 1.5e-3
strength = study ? real(system("sed -nE 's/^# strength.*: ([0-9.]+) MPa/\\1/p' ".table)) : 0
set grid lc rgb '#dddddd'
set bars small
do for [format in "svg png"] {
	if (format eq "svg") { set terminal svg size 1000,(study ? 800 : 700) font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 1000,(study ? 800 : 700) font 'Helvetica,11' }
	set output out.'.'.format
	set multiplot
	set key top right spacing 1.1
	if (study) {
		set size 0.5,0.42
		set origin 0,0.58
		set logscale xy
		set xrange [0.4:5]
		set yrange [3:10000]
		set xlabel 'depth of cut (grains)'
		set ylabel 'F_t/(w d) (MPa)'
		plot strength with lines dt 2 lc rgb '#777777' title 'strength: the rule of ductile cutting', \
		     table using ($1 == 5 ? $2 : NaN):4:5 with yerrorbars lw 2 pt 7 ps 0.9 lc rgb '#1f4e79' title 'mean', \
		     table using ($1 == 5 ? $2 : NaN):7 with points pt 6 ps 0.9 lc rgb '#1f4e79' title 'largest', \
		     table using ($1 != 5 ? $2 : NaN):4:5 with yerrorbars lw 2 pt 5 ps 0.9 lc rgb '#c55a11' title 'other speeds', \
		     14/sqrt(x) with lines lc rgb '#c55a11' title 'd^{-1/2}'
		unset logscale
	}
	set size (study ? 0.5 : 1),0.42
	set origin (study ? 0.5 : 0),0.58
	set xrange [0:10]
	set yrange [0:*]
	set xlabel 'path of the cutter (grains)'
	set ylabel 'F/(w d) (MPa)'
	plot run.'/scratch.txt' using 2:3 with lines lw 1.5 lc rgb '#1f4e79' title 'along the cut', \
	     '' using 2:4 with lines lc rgb '#c55a11' title 'normal'
	set size 1,0.57
	set origin 0,0
	set size ratio -1
	set xrange [-6:24]
	set yrange [0:20]
	set xlabel 'along the cut (grains)'
	set ylabel 'above the floor (grains)'
	unset key
	# the middle slice of grains: those of the block are grey, chips have one colour each, single grains are light
	slice = "< awk 'FNR > 9 { n++; y[n] = $4; line[n] = $0; if (n == 1 || $4 < lo) lo = $4; if (n == 1 || $4 > hi) hi = $4; all = n } ".\
		"END { for (k = 1; k <= all; k++) { split(line[k], c); if (c[4] > lo + 0.4*(hi - lo) && c[4] < lo + 0.55*(hi - lo)) ".\
		"print c[5], c[3], c[6], (c[8] > all/2 ? 0 : c[8] == 1 ? 1 : 2 + c[7] % 5) } }' ".run."/scratch.dump"
	colour(k) = k == 0 ? 0xb8b0a0 : k == 1 ? 0xf2d9b0 : k == 2 ? 0xc55a11 : k == 3 ? 0x1f4e79 : k == 4 ? 0x548235 : k == 5 ? 0x7030a0 : 0xbf9000
	plot slice using ($1/d):($2/d):($3/d):(colour($4)) with circles lc rgb variable fill solid noborder
	set size noratio
	unset multiplot
	unset output
}
