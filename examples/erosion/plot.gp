# gnuplot plot.gp: profiles of in.erosion, and in.angles, in post/
set terminal pngcairo size 900,600 font "sans,11"
newest(m, a) = system("ls -t post/".m.".".a.".*.txt | head -n 1")
set output "post/profile.png"
set xrange [-8:8]
set xlabel "x (mm), downstream"
set yrange [*:*]
set ylabel "depth (nm)"
set title "Depth of the scar in steel along the jet, mean over 1 mm across"
mean(f) = sprintf("< awk 'FNR > 9 && $2 * $2 < 0.25e-6 { s[$1] += $3; n[$1]++ } END { for (x in s) print x, s[x] / n[x] }' %s | sort -g", f)
plot mean(newest("steel", "90")) using (1e3*$1):(1e9*$2) with lines lw 2 title "90 degrees", \
	mean(newest("steel", "30")) using (1e3*$1):(1e9*$2) with lines lw 2 title "30 degrees"

set output "post/angles.png"
set xrange [0:90]
set yrange [0:*]
set xlabel "impact angle (degrees)"
set ylabel "volume removed per mass of grains (mm^3/kg)"
set title "Silica of 24.89 um on 6061-T6 at 105 m/s"
set key top left
plot "post/angles.txt" using 1:($2/4) with lines lw 2 title "Finnie, divided by 4", "" using 1:3 with lines lw 2 title "Oka", \
	"" using 1:4 with lines lw 2 title "Neilson and Gilchrist", "" using 1:5 with lines lw 2 title "Zhao and Chang", \
	"" using 1:6 with lines lw 2 dt 2 title "deformation alone (brittle)"
