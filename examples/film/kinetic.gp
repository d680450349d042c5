# Pictures of in.kinetic: gnuplot kinetic.gp
load "../flow/style.gp"
set terminal pngcairo size 1300,760 font ",10"
set output "post/kinetic.png"
profile = "post/profile_kinetic.txt"
slip = "post/slip_kinetic.txt"
film = "post/load_kinetic.txt"
set multiplot layout 2,3
set key off
set ylabel "height by gap"
set xlabel "velocity by speed of the lower wall"
set xrange [0:1]
plot profile u 2:1 w linespoints ls 1
set xlabel "solid fraction by its mean"
set xrange [*:*]
plot profile u 3:1 w linespoints ls 1
set key top right
set xlabel "roughness factor R"
set ylabel "slip by speed, shear stress by load"
set xrange [0:1]
set yrange [0:0.6]
plot slip u 1:2 w linespoints ls 1 t "slip", "" u 1:3 w linespoints ls 2 t "traction coefficient"
set key top left
set xlabel "speed by (pressure/density of a grain)^{1/2}"
set ylabel "gap in diameters"
set xrange [1:25]
set yrange [0:*]
set logscale x
set xtics (1, 2, 5, 10, 20)
plot for [k=0:3] film i k u 2:3 w linespoints ls k+1 t "amount ".word("1.5 2 3 5", k+1)." diameters"
set ylabel "traction coefficient"
set yrange [0.28:0.36]
plot for [k=0:3] film i k u 2:4 w linespoints ls k+1 t "amount ".word("1.5 2 3 5", k+1)." diameters"
set key bottom left
set xlabel "gap in diameters"
set ylabel "load by (density of a grain * speed^2)"
set xrange [2:20]
set ytics format "10^{%T}"
set yrange [1e-4:1]
set logscale y
plot for [k=0:3] film i k u 3:(1/$2**2) w linespoints ls k+1 t "amount ".word("1.5 2 3 5", k+1)." diameters"
unset multiplot
