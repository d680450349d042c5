# gnuplot shape.gp: picture of in.shape, post/shape.png
set terminal pngcairo size 1100,480 font "sans,10"
set output "post/shape.png"
load "../flow/style.gp"
set multiplot layout 1,2 title "Angular grains of silica on 6061-T6 at 105 m/s"
set xrange [0.9:3.5]
set xlabel "D/d, diameter of the grain over that of its corners"
set ylabel "volume removed, over that of spheres"
set key top left
do for [a in "90 30"] {
	set title a." degrees"
	set yrange [0.5:(a eq "90" ? 6 : 4.5)]
	f = "< awk '$1 == ".a."' post/shape.txt"
	plot f using 2:4 with points ls 1 ps 1.3 title "clumps, law of impacts", \
		f using 2:5 with lines ls 1 title "spheres with the factor (D/d)^{0.75} of the groove", \
		f using 2:6 with points ls 2 ps 1.3 title "clumps, law of contacts", \
		f using 2:7 with lines ls 2 title "spheres with the factor (D/d)^{0.9}"
}
unset multiplot
