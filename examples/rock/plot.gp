# The curves and cracks of all tests whose files are in post: gnuplot plot.gp (or gnuplot -e "out='folder'" plot.gp)
# post/curves.png: load and broken bonds against strain; post/cracks.png: bonds broken by tension and by shear, seen
# along y, in the outline of the specimen
if (!exists("out")) out = 'post'
tests = system("cd ".out." && for f in *.shape.txt; do [ -e $f ] && printf '%s ' ${f%.shape.txt}; done")
n = words(tests)
if (n == 0) { print "no results in ".out.": run a test first, as tsim -in in.ucs"; exit }
columns = n < 3 ? n : 3
rows = (n + columns - 1)/columns
name(t) = t[1:3] eq 'tri' ? 'triaxial, '.t[10:*].' Pa' : t
load(t) = t eq 'bending' ? 'K (MPa m^{1/2})' : t eq 'brazilian' ? '2F/({/Symbol p}Dt) (MPa)' : 'axial stress (MPa)'
tearing = '#1f4e79'; shearing = '#c55a11'

set terminal pngcairo size 480*columns, 380*rows font 'Helvetica,11'
set output out.'/curves.png'
set multiplot layout rows, columns
set grid lc rgb '#dddddd'
set ytics nomirror
set y2tics
set yrange [0:*]
set y2range [0:1<*]
set key top left Left reverse samplen 1.5
set offsets 0, 0, graph 0.25, 0
set xlabel 'strain (%)'
set y2label 'broken bonds'
do for [t in tests] {
	table = out.'/'.t.'.txt'
	set title name(t)
	set ylabel load(t)
	plot table using 2:4 with lines lw 2 lc rgb 'black' title 'load', \
	     '' using 2:5 axes x1y2 with lines lw 2 lc rgb tearing title 'bonds broken by tension', \
	     '' using 2:6 axes x1y2 with lines lw 2 lc rgb shearing title 'by shear'
}
unset multiplot

set output out.'/cracks.png'
set multiplot layout rows, columns
unset grid; unset offsets; unset y2tics; unset y2label
set key bmargin center horizontal
set bmargin 5
set samples 401
set size ratio -1
set xlabel 'x (mm)'
set ylabel 'z (mm)'
set yrange [*:*]
set parametric
set trange [0:1]
do for [t in tests] {
	shape = system("cat ".out.'/'.t.'.shape.txt')
	W = 1e3*word(shape, 2); H = 1e3*word(shape, 4)
	disc = word(shape, 1) eq 'disc'
	edge(t) = t < 0.25 ? 4*t : t < 0.5 ? 1 : t < 0.75 ? 3 - 4*t : 0
	px(t) = W*(disc ? 0.5 + 0.5*cos(2*pi*t) : edge(t))
	pz(t) = H*(disc ? 0.5 + 0.5*sin(2*pi*t) : edge(t < 0.25 ? t + 0.75 : t - 0.25))
	set title name(t)
	set xtics W > 20 ? 10 : 5
	set xrange [-0.05*W:1.05*W]
	set yrange [-0.05*H:1.05*H]
	mode(m, v) = strcol(10) eq m ? v*1e3 : NaN
	table = out.'/'.t.'.broken.txt'
	plot px(t), pz(t) with lines lc rgb '#888888' notitle, \
	     table using (mode('tension', $6)):($8*1e3) with points pt 7 ps 0.4 lc rgb tearing title 'tension', \
	     '' using (mode('shear', $6)):($8*1e3) with points pt 7 ps 0.4 lc rgb shearing title 'shear'
}
unset multiplot
