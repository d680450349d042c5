# Pictures of in.slurry, after both models: gnuplot slurry.gp
set terminal pngcairo size 1300,420 font ",10"
set output "post/slurry.png"
set multiplot layout 1,3
# the median over y and pads of the pressure in the fluid; the mean is governed by some columns that nearly touch
median(part) = "< cat post/cells_".part."_*.txt | awk 'NF == 6 && $4 > 0 { print $2, $5 }' | sort -k1,1g -k2,2g | ".\
	"awk 'function out() { if (n) print x, p[int((n + 1)/2)] } $1 != x { out(); x = $1; n = 0 } { p[++n] = $2 } END { out() }'"
set key top center
set xlabel "x, direction of sliding of the pad (um)"
set ylabel "median of the pressure over ambient (Pa)"
set xrange [0:50]
set yrange [-300:100]
plot for [part in "16 32 48 64"] median(part) u ($1*1e6):2 w lines lw 2 t "speed ".part, \
     "< awk 'NF == 6' post/smooth.txt" u ($2*1e6):5 smooth unique w lines lw 2 dt 2 lc "black" t "64, smooth pad"
set key bottom left
set xlabel "speed of the pad (m/s)"
set ylabel "mean pressure over ambient (Pa)"
set xrange [0:3]
set yrange [:0]
plot "post/slurry.txt" u 1:2:3 w yerrorlines pt 7 t "rough pads", "" u 1:7 w linespoints pt 6 dt 2 t "smooth pad", \
     "post/slurry_cfd.txt" u 1:2 w points pt 2 ps 2 t "smooth pad, full equations"
set title "pressure (Pa), pad 1, speed 64; touching: white"
set xlabel "x (um)"
set ylabel "y (um)"
set xrange [0:50]
set yrange [0:50]
set cbrange [-1200:1200]
set palette defined (-1 "#2166ac", 0 "#f7f7f7", 1 "#b2182b")
set key off
set size ratio 1
plot "< awk 'NF == 6' post/cells_64_1.txt" u ($2*1e6):($3*1e6):($4 > 0 ? $5 : NaN) w image
unset multiplot
