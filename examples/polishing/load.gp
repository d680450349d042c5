# Picture of in.load: gnuplot load.gp
set terminal pngcairo size 1000,420 font ",10"
set output "post/load.png"
set multiplot layout 1,2
set logscale x
set format x "10^{%L}"
set xlabel "mean pressure/(E* g)"
set xrange [0.001:1]
set key bottom right
set logscale y
set ylabel "part of the area in contact"
set yrange [0.001:1]
plot sqrt(8/pi)*x w lines dt 2 lc "gray40" t "Persson, small pressures", \
     sqrt(2*pi)*x w lines dt 3 lc "gray40" t "Bush, Gibson, Thomas", \
     "post/load.halfspace" u 1:2 w linespoints pt 7 lc "#0072b2" t "half-space", \
     "post/load.winkler" u 1:2 w linespoints pt 5 lc "#d55e00" t "springs"
unset logscale y
set key top right
set ylabel "mean gap/standard deviation of the heights"
set yrange [0:3]
plot "post/load.halfspace" u 1:4 w linespoints pt 7 lc "#0072b2" t "half-space", \
     "post/load.winkler" u 1:4 w linespoints pt 5 lc "#d55e00" t "springs"
unset multiplot
