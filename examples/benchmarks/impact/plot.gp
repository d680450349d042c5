# The eight contact tests: impact.png, from impact.txt (made by run.sh) and kharaz2001.txt.
# test material e vn vt spin restitution vt' spin' duration overlap force
set terminal pngcairo size 1100,780 font 'Helvetica,10'
set output 'impact.png'
set style line 1 lc rgb '#0b3c5d' lw 1.8 pt 7 ps 0.5
set style line 2 lc rgb '#328cc1' lw 1.8 pt 5 ps 0.5
set style line 3 lc rgb '#d9782d' lw 1.8 pt 9 ps 0.8
set style line 9 lc rgb '#999999' lw 1 dt 2
set border 3 lc rgb '#444444'
set tics nomirror
set grid lc rgb '#e5e5e5' lt 1
set key bottom right reverse Left samplen 2
deg = 180/pi
of(n, m) = sprintf('< awk ''$1 == %d && $2 == "%s"'' impact.txt', n, m)
set multiplot layout 2,3

set title '3: damping'
set xlabel 'e given'; set ylabel 'e found'
plot x with lines ls 9 title 'exact', \
	of(3, 'oxide') using 3:($7) with points ls 1 title 'aluminium oxide', \
	of(3, 'iron') using 3:($7) with points ls 3 title 'cast iron'

set title '4: oblique'
set xrange [0:90]; set yrange [0.5:1.05]
set xlabel 'angle of impact, degrees'; set ylabel 'tangential restitution'
mu = 0.092; e = 0.98
plot x > 30 ? 1-mu*(1+e)/tan(x/deg) : 1/0 with lines ls 9 title 'sliding', \
	of(4, 'oxide') using (atan2($5,$4)*deg):($8/$5) with lines ls 1 title 'aluminium oxide', \
	of(4, 'alloy') using (atan2($5,$4)*deg):($8/$5) with lines ls 2 title 'aluminium alloy', \
	'kharaz2001.txt' index 0 with points ls 3 title 'measured (oxide)'

set yrange [0:750]
set ylabel 'spin, 1/s'
plot x > 30 ? 2.5*mu*(1+e)*3.9*cos(x/deg)/0.0025 : 1/0 with lines ls 9 title 'sliding', \
	of(4, 'oxide') using (atan2($5,$4)*deg):($9) with lines ls 1 title 'aluminium oxide', \
	of(4, 'alloy') using (atan2($5,$4)*deg):($9) with lines ls 2 title 'aluminium alloy', \
	'kharaz2001.txt' index 1 with points ls 3 title 'measured (oxide)'

set yrange [0:90]
set ylabel 'angle of rebound, degrees'
plot of(4, 'oxide') using (atan2($5,$4)*deg):(atan2($8,$7*$4)*deg) with lines ls 1 title 'aluminium oxide', \
	of(4, 'alloy') using (atan2($5,$4)*deg):(atan2($8,$7*$4)*deg) with lines ls 2 title 'aluminium alloy', \
	'kharaz2001.txt' index 2 with points ls 3 title 'measured (oxide)'

set title '5: oblique, elastic'
set xrange [0:14]; set yrange [-4:8]
set xlabel 'v_t / ({/Symbol m} v_n)'; set ylabel 'v_s after / ({/Symbol m} v_n)'
plot x > 7 ? x-7 : 1/0 with lines ls 9 title 'sliding', \
	of(5, 'steel') using ($5/(0.3*$4)):(($8-$9*1e-5)/(0.3*$4)) with linespoints ls 1 title 'steel', \
	of(5, 'polyethylene') using ($5/(0.3*$4)):(($8-$9*1e-5)/(0.3*$4)) with linespoints ls 3 title 'polyethylene'

set key top right
set title '6 to 8: spin'
set xrange [0:12]; set yrange [-0.16:0.02]
set xlabel 'spin before, 1/s'; set ylabel 'tangential velocity after, m/s'
plot of(6, 'aluminium') using (-$6):($8) with linespoints ls 1 title '6: on a plane, aluminium', \
	of(6, 'copper') using (-$6):($8) with linespoints ls 2 title '6: copper', \
	of(7, 'aluminium') using (-$6):($8) with points pt 6 lc rgb '#d9782d' title '7: two spheres', \
	of(8, 'aluminium') using (-$6):($8) with points pt 8 lc rgb '#2f8f4e' title '8: on a larger sphere'
unset multiplot
