# Charts of study-paml: gnuplot paml.gp. Columns of the tables: 2 3 N_all, 4 5 N_act, 6 force, 8 9 removal of PAML; 10 N_all, 12
# N_elig, 14 N_act, 16 removal of PML; 18, 20, 22, 24 of PI, each with its error in the next column.
set terminal pngcairo size 1500,1350 font ",11"
set output "results/paml.png"
set multiplot layout 3,3
set key top right samplen 2
set bars small
f(name) = "results/paml_".name.".txt"
pml = "pt 7 lc rgb '#1f77b4'"; pi_ = "pt 5 lc rgb '#ff7f0e'"; paml = "pt 9 lc rgb '#d62728'"

set logscale y
set ylabel "particles per 625 um^2"
set xlabel "standard deviation of the diameters (um)"
set title "in the gap"
set yrange [100:20000]
plot f("spread") u 1:10:11 w yerrorl @pml t "PML, PI", "" u 1:2:3 w yerrorl @paml t "PAML"
set title "eligible"
set yrange [10:3000]
plot f("spread") u 1:12:13 w yerrorl @pml t "PML", "" u 1:20:21 w yerrorl @pi_ t "PI", "" u 1:2:3 w yerrorl @paml t "PAML"
set title "active"
set yrange [0.01:300]
plot f("spread") u 1:14:15 w yerrorl @pml t "PML", "" u 1:22:23 w yerrorl @pi_ t "PI", "" u 1:4:5 w yerrorl @paml t "PAML"

set logscale x
set xlabel "modulus of the pad (MPa)"
set title "eligible"
set yrange [1:5000]
plot f("modulus") u 1:12:13 w yerrorl @pml t "PML", "" u 1:20:21 w yerrorl @pi_ t "PI", "" u 1:2:3 w yerrorl @paml t "PAML"
set title "active"
set yrange [0.01:3000]
plot f("modulus") u 1:14:15 w yerrorl @pml t "PML", "" u 1:22:23 w yerrorl @pi_ t "PI", "" u 1:4:5 w yerrorl @paml t "PAML"

unset logscale x
set title "active"
set xlabel "relative speed (m/s)"
set xrange [0:1]
set yrange [0.01:100]
plot f("speed") u 1:14:15 w yerrorl @pml t "PML", "" u 1:22:23 w yerrorl @pi_ t "PI", "" u 1:4:5 w yerrorl @paml t "PAML", \
     f("dense_speed") u 1:4:5 w yerrorl @paml dt 3 t "PAML, 4 % of the gap"
set autoscale x

set title "removal"
set logscale x
set xlabel "pressure (psi)"
set ylabel "nm/min"
set yrange [1e-3:1e7]
set xrange [1.5:10]
nm = 6e10
plot f("pressure") u 1:(nm*$16):(nm*$17) w yerrorl @pml t "PML", "" u 1:(nm*$24):(nm*$25) w yerrorl @pi_ t "PI", \
     "" u 1:(nm*$8):(nm*$9) w yerrorl @paml t "PAML", f("dense_pressure") u 1:(nm*$8):(nm*$9) w yerrorl @paml dt 3 t "PAML, 4 % of the gap", \
     50*x/6 w l dt 2 lc "grey" t "Preston, in proportion to p"
set autoscale x
unset logscale

set title "how long a run must be"
set xlabel "path of the pad (um)"
set ylabel "active"
set yrange [0:*]
plot f("steady") u 1:2:3 w yerrorl @paml t "PAML"

set title "error of the number of active particles"
set logscale xy
set xlabel "processor seconds"
set ylabel "relative error"
set format x "10^{%L}"
set yrange [0.1:1000]
plot "<grep -w pml results/paml_ladder.txt" u 3:4 w p ps 2 @pml t "PML", "<grep -w pi results/paml_ladder.txt" u 3:4 w p ps 2 @pi_ t "PI", \
     "<grep -w paml results/paml_ladder.txt" u 3:4 w lp ps 2 @paml t "PAML, 1, 2, 4, 8 pads"
unset multiplot
