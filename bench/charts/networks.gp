# Limits with many contacts. Set before: format, file, data (lines `"name" measured theory reported one-contact`).
if (format eq 'svg') { set terminal svg size 860,560 font 'Helvetica,13' background rgb 'white' }
if (format eq 'png') { set terminal pngcairo size 860,560 font 'Helvetica,10' }
set output file
set border 3 lc rgb '#444444'
set tics nomirror
set grid x lc rgb '#dddddd'
set title 'Largest stable step of what touches together, by the measured one'
set xlabel 'step by the measured limit'
set logscale x
set xrange [0.9:5]
set xtics (0.9, 1, 1.5, 2, 3, 4, 5)
stats data using 2 nooutput
set yrange [STATS_records-0.5:-0.5]
set key bottom right reverse Left samplen 1 opaque
plot data using (1):0:ytic(1) with points pt 7 ps 1.3 lc rgb '#0072B2' title 'measured', \
     data using ($3 > 0 ? $3/$2 : NaN):0 with points pt 2 ps 1.4 lc rgb '#D55E00' title 'theory', \
     data using ($4/$2):0 with points pt 6 ps 1.9 lc rgb '#009E73' title 'reported by tsim', \
     data using ($5 > 0 ? $5/$2 : NaN):0 with points pt 4 ps 1.2 lc rgb '#999999' title 'of one contact alone'
