# Stress and broken bonds against strain: gnuplot plot.gp (after tsim -in in.ucs)
if (!exists("out")) out = 'post'
table = out.'/ucs.txt'
stats table using 5 nooutput
set terminal pngcairo size 800,560 font 'Helvetica,12'
set output out.'/ucs.png'
set grid lc rgb '#dddddd'
set key top left
set xlabel 'strain (%): axial to the right, lateral to the left'
set ylabel 'axial stress (MPa)'
set y2label 'broken bonds'
set ytics nomirror
set y2tics
set yrange [0:*]
set y2range [0:*]
plot table using 2:4 with lines lw 2 lc rgb '#1f4e79' title 'axial', \
     '' using (-$3):4 with lines lw 2 lc rgb '#5b9bd5' title 'lateral', \
     '' using 2:(STATS_max-$5) axes x1y2 with lines lw 2 lc rgb '#c55a11' title 'broken bonds'
