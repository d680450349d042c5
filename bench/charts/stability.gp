# Largest stable step against damping. Set before: format, file, data (lines `system scheme gamma/omega limit`).
if (format eq 'svg') { set terminal svg size 640,440 font 'Helvetica,13' background rgb 'white' }
if (format eq 'png') { set terminal pngcairo size 640,440 font 'Helvetica,10' }
set encoding utf8
set output file
set style line 1 lc rgb '#0072B2' lw 1.8 pt 7 ps 1.1
set style line 3 lc rgb '#009E73' lw 1.8 pt 9 ps 1.1
set border 3 lc rgb '#444444'
set tics nomirror
set title 'Largest stable time step, measured by bisection'
set xlabel 'damping {/Symbol g}/{/Symbol w}_0'
set ylabel '{/Symbol w}_0 h'
set xrange [-0.02:1]
set yrange [0:2.2]
set key top center reverse Left samplen 2
plot 2*(sqrt(1+x*x)-x) with lines ls 1 title '2(√(1+b^2) - b), b = {/Symbol g}/{/Symbol w}_0', \
     2*x with lines ls 3 title '2b', \
     '< grep " nve " '.data using 3:4 with points ls 1 title 'nve', \
     '< grep nve/symplectic '.data using 3:4 with points pt 6 ps 1.9 lc rgb '#D55E00' title 'nve/symplectic', \
     '< grep nve/euler '.data using 3:4 with points ls 3 title 'nve/euler'
