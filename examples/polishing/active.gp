# Pictures of in.active and in.wafer: gnuplot active.gp
set terminal pngcairo size 1000,420 font ",10"
set output "post/active.png"
set multiplot layout 1,2
set key top right
set logscale y
set ylabel "particles per 625 um^2"
set xlabel "standard deviation of the diameters (um)"
set yrange [0.1:2000]
plot "post/spread.txt" u 1:6:7 w yerrorlines pt 7 t "active, PML", \
     "" u 1:12:13 w yerrorlines pt 5 t "active, PI", \
     "" u 1:4 w lines dt 2 t "eligible, PML", "" u 1:10 w lines dt 3 t "eligible, PI"
set logscale x
set xlabel "modulus of the pad (MPa)"
plot "post/modulus.txt" u 1:6:7 w yerrorlines pt 7 t "active, PML", \
     "" u 1:12:13 w yerrorlines pt 5 t "active, PI", \
     "" u 1:4 w lines dt 2 t "eligible, PML", "" u 1:10:11 w yerrorlines pt 4 t "eligible, PI"
unset multiplot
# in.wafer
set output "post/tilt.png"
set terminal pngcairo size 500,400 font ",10"
unset logscale
set autoscale
set key off
set xlabel "coefficient of friction"
set ylabel "mean tilt of the wafer (degrees)"
plot "post/tilt.txt" u 1:2:3 w yerrorlines pt 7
