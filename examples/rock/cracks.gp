# The cracks of all tests whose files are in post: gnuplot cracks.gp (or gnuplot -e "out='folder'" cracks.gp)
# post/cracks.png: bonds broken by tension and by shear, seen along y, in the outline of the specimen. ./plot draws the curves
if (!exists("out")) out = 'post'
tests = system("cd ".out." && for f in *.shape.txt; do [ -e $f ] && printf '%s ' ${f%.shape.txt}; done")
n = words(tests)
if (n == 0) { print "no results in ".out.": run a test first, as tsim -in in.ucs"; exit }
columns = n < 3 ? n : 3
rows = (n + columns - 1)/columns
name(t) = t[1:3] eq 'tri' ? 'triaxial, '.t[10:*].' Pa' : t
tearing = '#1f4e79'; shearing = '#c55a11'

set terminal pngcairo size 480*columns, 380*rows font 'Helvetica,11'
set output out.'/cracks.png'
set multiplot layout rows, columns
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
