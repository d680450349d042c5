# gnuplot evolving.gp: profiles of the scar of in.evolving as it deepens, in post/evolving.png
set terminal pngcairo size 1200,450 font "sans,11"
set output "post/evolving.png"
set xlabel "x (um), downstream"
set xrange [-600:700]
set ylabel "height (um)"
set title "Profile along the jet, which comes from the left at 30 degrees: mean over 100 um across, after each quarter"
set key bottom left
profile(k) = sprintf("< awk 'FNR > 9 && $2 * $2 < 2.5e-9 { s[$1] += $3; n[$1]++ } END { for (x in s) print x, s[x] / n[x] }' post/evolving.%d.txt | sort -g", k)
plot 0 lc rgb "gray" title "before", for [k = 1:4] profile(k) using (1e6*$1):(1e6*$2) with lines lw 2 title sprintf("%d/4", k)
