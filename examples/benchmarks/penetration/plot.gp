# penetration.png: the height of the ball, from ball.txt and dosta2024.txt.
set terminal pngcairo size 800,480 font 'Helvetica,10'
set output 'penetration.png'
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e5e5e5' lt 1
set key top right reverse Left samplen 2
set xlabel 'time, ms'; set ylabel 'displacement of the ball, mm'
set xrange [0:100]; set yrange [-150:0]
plot 'dosta2024.txt' using (1e3*$1):(1e3*($2-2*$5)):(1e3*($2+2*$5)) with filledcurves fc rgb '#cfe3f1' title 'two standard deviations over ten beds', \
	'' using (1e3*$1):(1e3*$3):(1e3*$4) with filledcurves fc rgb '#328cc1' title 'means of seven programs', \
	'ball.txt' using (1e3*$1):(1e3*($2-0.06)) with lines lw 2 lc rgb '#d9782d' title 'tsim'
