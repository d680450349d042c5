# gnuplot plot.gp: profiles of in.erosion, in post/
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
