# penetration.png: the height of the ball, from ball*.txt, a file for each bed, dense*.txt for beds that settled with
# less friction, and dosta2024.txt. Where a file ends before 0.1 s the ball flies freely.
set terminal pngcairo size 800,480 font 'Helvetica,10'
set output 'penetration.png'
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e5e5e5' lt 1
set key top right reverse Left samplen 2
set xlabel 'time, ms'; set ylabel 'displacement of the ball, mm'
set xrange [0:100]; set yrange [-150:0]
beds = system('ls ball*.txt')
dense = system('ls dense*.txt 2>/dev/null')
flight(file) = "< awk '{ print $1, $2 } END { z = $2; v = $3; for (t = 0.001; $1 + t < 0.1005; t += 0.001) ". \
	"print $1 + t, z + v * t - 4.905 * t * t }' ".file
plot 'dosta2024.txt' using (1e3*$1):(1e3*($2-2*$5)):(1e3*($2+2*$5)) with filledcurves fc rgb '#cfe3f1' title 'two standard deviations over ten beds', \
	'' using (1e3*$1):(1e3*$3):(1e3*$4) with filledcurves fc rgb '#328cc1' title 'means of seven programs', \
	for [k = 1:words(beds)] flight(word(beds, k)) using (1e3*$1):(1e3*($2-0.06)) with lines lw 1.5 lc rgb '#d9782d' \
		title k == 1 ? 'tsim, '.words(beds).' beds' : '', \
	for [k = 1:words(dense)] flight(word(dense, k)) using (1e3*$1):(1e3*($2-0.06)) with lines lw 1.5 dt 2 lc rgb '#7a4a9e' \
		title k == 1 ? 'tsim, denser beds' : ''
