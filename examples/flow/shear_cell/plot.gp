# Called by ./study: results/shear_cell.png
load '../style.gp'
set terminal pngcairo size 520,430 font 'Helvetica,10'
set output 'results/shear_cell.png'
set title 'Spheres of 0.1 mm in a cell with a moving lid'
set xlabel 'velocity of the sphere, of the fluid (lines); U'; set ylabel 'y/H'
set key bottom right
# the plate set in motion
u(y, t) = y + sum [n=1:30] 2/(n*pi)*(-1)**n*sin(n*pi*y)*exp(-n*n*pi*pi*t)
set parametric
set trange [0:1]
plot [t=0:1] [0:1] [0:1] u(t, 0.03), t with lines ls 9 notitle, u(t, 0.1), t with lines ls 9 notitle, \
	t, t with lines ls 9 notitle, \
	for [k=1:3] 'results/cell.'.word("0.03 0.1 1", k).'.txt' using 2:1 every ::9 with points ls k ps 0.6 \
		title 't = '.word("0.03 0.1 1", k).' H^2/{/Symbol n}'
