# Pictures of in.grains, in.cooling, in.sheared_gas and in.rheology: gnuplot grains.gp [-e 'out="post"']
if (!exists("out")) out = "post"
load "../flow/style.gp"
set terminal pngcairo size 1000,400 font ",10"
file(name) = sprintf("%s/%s", out, name)

# profiles across the film, with those of kinetic theory where in.kinetic has written them
theory = file("profile_kinetic.txt")
known = system(sprintf("test -e %s && echo 1 || echo 0", theory)) + 0
set output file("grains.png")
set multiplot layout 1,3
set ylabel "y/H"
set yrange [0:1]
set key off
set xlabel "u/U"
set xrange [0:1]
plot file("profile_dem.txt") u 2:1:5 w xerrorlines ls 1 t "grains", known ? theory : 1/0 u 2:1 w l ls 2 t "kinetic theory"
set xlabel "nu / mean nu"
set xrange [0:*]
set key bottom left
plot file("profile_dem.txt") u 3:1:6 w xerrorlines ls 1 t "grains", known ? theory : 1/0 u 3:1 w l ls 2 t "kinetic theory"
set key off
set xlabel "T/U^2"
set xtics 0.005
plot file("profile_dem.txt") u 4:1:7 w xerrorlines ls 1 t "grains", known ? theory : 1/0 u 4:1 w l ls 2 t "kinetic theory"
unset multiplot

set xtics autofreq
set output file("rheology.png")
set multiplot layout 1,2
set xrange [0:0.3]
set yrange [0.2:0.65]
set xlabel "inertial number I"
set ylabel "friction coefficient mu"
set key top left
plot file("rheology.txt") u 2:4:3:5 w xyerrorbars ls 1 t "discs", 0.25 + 1.1*x ls 2 t "da Cruz et al. (2005)", \
     0.38 + 0.26/(0.279/x + 1) ls 3 t "Jop et al. (2006), spheres"
set ylabel "solid fraction"
set yrange [0.7:0.82]
set key top right
plot file("rheology.txt") u 2:1:3 w xerrorbars ls 1 t "discs", 0.81 - 0.3*x ls 2 t "da Cruz et al. (2005)"
unset multiplot

# spheres: in.rheology -var dim 3
spheres = file("rheology3.txt")
if (system("test -e ".spheres." && echo 1") eq "1") {
	set output file("rheology3.png")
	set multiplot layout 1,2
	set xrange [0:0.6]
	set yrange [0.3:0.8]
	set xlabel "inertial number I"
	set ylabel "friction coefficient mu"
	set key top left
	plot spheres u 2:4:3:5 w xyerrorbars ls 1 t "spheres", 0.382 + 0.37/((0.32/x)**1.5 + 1) ls 2 t "Chialvo et al. (2012)", \
	     0.38 + 0.26/(0.279/x + 1) ls 3 t "Jop et al. (2006), glass"
	set ylabel "solid fraction"
	set yrange [0.5:0.6]
	set key top right
	plot spheres u 2:1:3 w xerrorbars ls 1 t "spheres", 0.587 ls 2 t "yield, Chialvo et al. (2012)"
	unset multiplot
}
