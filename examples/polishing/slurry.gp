# Pictures of in.slurry, after the models film, smooth and cfd: gnuplot slurry.gp
set terminal pngcairo size 1740,420 font ",10"
set output "post/slurry.png"
set multiplot layout 1,4
# the median over y and pads of the pressure in the fluid; the mean is governed by some columns that nearly touch
median(part) = "< cat post/cells_".part."_*.txt | awk 'NF == 6 && $4 > 0 { print $2, $5 }' | sort -k1,1g -k2,2g | ".\
	"awk 'function out() { if (n) print x, p[int((n + 1)/2)] } $1 != x { out(); x = $1; n = 0 } { p[++n] = $2 } END { out() }'"
# the mean over y, in the fluid
mean(part) = "< awk 'NF == 6 && $6 == 1 { n[$2]++; p[$2] += $4 } END { for (x in n) print x, p[x]/n[x] }' post/rough_".part.".txt | sort -g"
set key bottom right
set title "film, rough pads: median"
set xlabel "x, direction of sliding of the pad (um)"
set ylabel "pressure over ambient (Pa)"
set xrange [0:50]
set yrange [-300:100]
plot for [part in "16 32 48 64"] median(part) u ($1*1e6):2 w lines lw 2 t "speed ".part, \
     "< awk 'NF == 6' post/smooth.txt" u ($2*1e6):5 smooth unique w lines lw 2 dt 2 lc "black" t "64, smooth pad"
set title "full equations, a rough pad: mean over y"
set ylabel ""
set yrange [*:*]
plot for [part in "16 32 48 64"] mean(part) u ($1*1e6):2 w lines lw 2 t "speed ".part
set title ""
set xlabel "speed of the pad (m/s)"
set ylabel "mean pressure below ambient (Pa)"
set xrange [0:3]
set logscale y
set yrange [1:10000]
plot "post/slurry_cfd.txt" u 1:(-$2) w linespoints pt 7 lw 2 t "a rough pad, full equations", "" u 1:(-$3) w linespoints pt 6 t "the same, film", \
     "post/slurry.txt" u 1:(-$2):3 w yerrorlines pt 5 t "8 rough pads, film that cavitates", \
     "" u 1:(-$7) w lines dt 2 lc "black" t "smooth pad", \
     "post/slurry_smooth.txt" u 1:(-$2) w points pt 2 ps 2 lc "black" t "smooth pad, full equations"
unset logscale y
set title "full equations, speed 64 (Pa); in the pad: white"
set xlabel "x (um)"
set ylabel "y (um)"
set xrange [0:50]
set yrange [0:50]
set cbrange [-12000:12000]
set palette defined (-1 "#2166ac", 0 "#f7f7f7", 1 "#b2182b")
set key off
set size ratio 1
plot "< awk 'NF == 6' post/rough_64.txt" u ($2*1e6):($3*1e6):($6 == 1 ? $4 : NaN) w image
unset multiplot
