# Plots one run: bit height and friction against time, from post/bit.txt
#   gnuplot plot-run.gp            or  gnuplot -e "dir='elsewhere'" plot-run.gp
if (!exists("dir")) dir = 'post'
set grid lc rgb '#dddddd'
set xlabel 'time t*'
do for [format in "svg png"] {
	if (format eq "svg") { set terminal svg size 900,700 font 'Helvetica,13' background rgb 'white' }
	if (format eq "png") { set terminal pngcairo size 900,700 font 'Helvetica,11' }
	set output dir.'/bit.'.format
	set multiplot layout 2,1
	set ylabel 'bit height z* above the first surface'
	set key top right
	plot dir.'/bit.txt' using 2:3 with lines lw 2 lc rgb '#1f4e79' title 'mean of the four cutters'
	set ylabel 'force on the cutters'
	set key top left
	plot dir.'/bit.txt' using 2:5 with lines lc rgb '#bbbbbb' title 'normal', \
	     '' using 2:4 with lines lc rgb '#c55a11' title 'friction (tangential)'
	unset multiplot
	unset output
}
