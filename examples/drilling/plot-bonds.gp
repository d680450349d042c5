# Plots of the two laws of bonds: called by ./study-bonds
set grid lc rgb '#dddddd'
set bars small
set ylabel 'ROP*'
array name[4] = ['Fult', 'WOB', 'eta', 'omega']
array label[4] = ['bond strength F_{ult}*', 'weight on bit WOB*', 'viscosity {/Symbol h}*', 'angular velocity {/Symbol w}*']
do for [format in "svg png"] {
	if (format eq "svg") { set terminal svg size 1000,700 font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 1000,700 font 'Helvetica,11' }
	set output 'results/bonds.'.format
	set multiplot layout 2,2 title 'Rotary drilling: bonds that only stretch, and bonds that also resist shear, bending and torsion'
	do for [k = 1:4] {
		if (k == 3) { set xtics 0.0005 } else { set xtics auto }
		if (k == 4) { set logscale x; set xrange [0.03:2] } else { unset logscale x; set xrange [*:*] }
		set xlabel label[k]
		plot 'results/bonds.'.name[k].'.contact.dat' using 1:2:3 with yerrorlines lw 2 pt 7 ps 0.9 lc rgb '#1f4e79' title 'contact', \
		     'results/bonds.'.name[k].'.parallel.dat' using 1:2:3 with yerrorlines lw 2 pt 5 ps 0.9 lc rgb '#c55a11' title 'parallel'
	}
	unset multiplot
	unset output
	unset logscale x
	set xrange [*:*]
}
