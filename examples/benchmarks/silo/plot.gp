# silo.png: grains above the lip, from large.txt and small.txt and dosta2024.txt.
set terminal pngcairo size 800,480 font 'Helvetica,10'
set output 'silo.png'
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e5e5e5' lt 1
set key bottom left Left reverse samplen 2
set xlabel 'time, s'; set ylabel 'grains above the lip, thousands'
set xrange [0:0.8]; set yrange [78:100]
set datafile missing '-'
plot 'dosta2024.txt' using 1:($2/1e3) with points pt 6 lc rgb '#328cc1' title 'LIGGGHTS, 60 mm', \
	'' using 1:($3/1e3) with points pt 4 lc rgb '#328cc1' title 'MUSEN, 60 mm', \
	'' using 1:($5/1e3) with points pt 5 lc rgb '#5a9e6f' title 'MUSEN, 40 mm', \
	'' using 1:($6/1e3) with points pt 7 lc rgb '#5a9e6f' title 'peclet, 40 mm', \
	'large.txt' using 1:($2/1e3) with lines lw 2 lc rgb '#d9782d' title 'tsim, 60 mm', \
	'small.txt' using 1:($2/1e3) with lines lw 2 lc rgb '#a0522d' title 'tsim, 40 mm'
