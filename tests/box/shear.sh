#!/bin/bash
# Sheared periodic boxes (fix deform xy, xz, yz remap v). Homogeneous shear is the same everywhere: what happens at the
# sheared faces equals what happens in the middle, moved by s with the velocity of the flow there; two grains with friction,
# of which one is an image that slides past the box many times during the contact, and a gas.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# The velocities after a collision: in the middle, then at the sheared faces.
cat >in.pair <<'END'
units si
atom_style granular
boundary p p p
region b block 0 0.01 0 0.01 0 0.01 units box
create_box 1 b
variable rate equal 8e4
soft_particles yes
fix m1 all property/global youngsModulus peratomtype 5e4
fix m2 all property/global poissonsRatio peratomtype 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hertz tangential history
pair_coeff * *
# grains at 3 mm and 3.3 mm along the flow, 4.5 mm and 5.55 mm along the gradient, both moved by $s
variable low equal 4.5e-3+$s
variable high equal 5.55e-3+$s-0.01*(5.55e-3+$s>=0.01)
variable ul equal 0.1+v_rate*v_low
variable uh equal -0.1+v_rate*v_high
include in.$f$g
set group all diameter 1e-3 density 2385
fix i all nve/sphere
fix shear all deform 1 $f$g erate ${rate} remap v
timestep 5e-7
run 800
END
for plane in 'x y z' 'x z y' 'y z x'; do
	read -r f g h <<<"$plane"
	{
		for k in 1 2; do
			level=low u=ul start=3e-3 w=0.5 out=0
			[ $k = 2 ] && level=high u=uh start=3.3e-3 w=-0.5 out=0.05
			declare -A at=([$f]=$start [$g]="\${$level}" [$h]=5e-3) v=([$f]="\${$u}" [$g]=$w [$h]=$out)
			echo "create_atoms 1 single ${at[x]} ${at[y]} ${at[z]} units box"
			echo "set atom $k vx ${v[x]} vy ${v[y]} vz ${v[z]}"
		done
	} >"in.$f$g"
	agree "collision across the faces, $f$g" "variable f string $f
variable g string $g
variable s equal 0
include in.pair
variable a equal \$(v$f[1])
variable b equal \$(v$g[1])
variable c equal \$(v$h[1])
variable o equal \$(omegaz[1])
variable p equal \$(omegax[2])
variable q equal \$(omegay[2])
print 'is rubbed \$(abs(v_o)+abs(v_p)+abs(v_q)>10) 1'
clear
variable s delete
variable s equal 5e-3
include in.pair
# velocities of 800 m/s are exact to 1e-13 m/s, so the others to about 1e-9
print 'is u \$(v$f[1]-v_rate*5e-3) \${a} 2e3'
print 'is v \$(v$g[1]) \${b} 1e3'
print 'is w \$(v$h[1]) \${c} 1e3'
print 'is oz \$(omegaz[1]) \${o} 1e6'
print 'is ox \$(omegax[2]) \${p} 1e6'
print 'is oy \$(omegay[2]) \${q} 1e6'"
done

# A gas of inelastic grains: stress and momentum, moved by a third of the box.
cat >in.gas <<'END'
units si
atom_style granular
boundary p p p
region b block 0 0.01 0 0.01 0 0.01 units box
create_box 1 b
lattice sc 0.00125
create_atoms 1 box
lattice none 1
set group all diameter 1e-3 density 2385
variable ux atom 0.2*sin(2.385*id*id)
variable uy atom 0.2*sin(1.931*id*id)
variable uz atom 0.2*sin(3.217*id*id)
velocity all set v_ux v_uy v_uz
variable g equal 100
displace_atoms all move 0 $s 0 units box
variable shear atom v_g*y
velocity all set v_shear NULL NULL sum yes
pair_style spring/dashpot
pair_coeff 1 1 stiffness 2e3 restitution 0.9
timestep 4e-6
fix i all nve
fix shear all deform 1 xy erate $g remap v
compute p all pressure NULL virial
compute near all coord/atom cutoff 1.9e-3
compute coord all reduce sum c_near
compute rdf all rdf 5 cutoff 2.5e-3
END
agree 'a gas, moved' 'variable s equal 0
include in.gas
variable vy equal $(vcm(all,y))
run 700
variable pxy equal $(c_p[4])
variable pyy equal $(c_p[2])
variable u equal $(vz[17])
variable coord equal $(c_coord)
variable rdf equal $(c_rdf[4][2])
print "is some $(v_coord>2000) 1"
print "is momentum $(vcm(all,y)) ${vy} 1"
print "is pushed $(abs(v_pxy)>0.1) 1"
clear
variable s delete
variable s equal 0.01/3
include in.gas
run 700
print "is pxy $(c_p[4]) ${pxy} 1e6"
print "is pyy $(c_p[2]) ${pyy} 1e6"
print "is u $(vz[17]) ${u} 1e4"
print "is coord $(c_coord) ${coord}"
print "is rdf $(c_rdf[4][2]) ${rdf}"'

# One particle through the upper face: y falls by the length of the box, x by the displacement 0.007 - 0.003 of the
# images, vx by their velocity; the unwrapped position does not change.
agree 'crossing' 'units si
boundary p p p
region b block 0 0.01 0 0.01 0 0.01 units box
create_box 1 b
create_atoms 1 single 0.002 0.0095 0.005 units box
set group all diameter 1e-3 density 2385
set atom 1 vy 1 vx 3
fix i all nve
fix shear all deform 1 xy vel 7 remap v
timestep 1e-5
run 100
run 0
print "is y $(y[1]) 0.0005"
print "is vx $(vx[1]) -4"
variable xu atom xu
print "is xy $(xy) -0.003"
print "is wrapped $(abs(x[1])<0.01) 1"
unfix shear
velocity all set 0 0 0
variable before equal $(x[1])
run 10
print "is held $(x[1]) ${before}"'

for threads in 1 3; do
	{
		printf 'package omp %s grain 1\nvariable s equal 0\ninclude in.gas\n' $threads
		echo 'run 300'
		echo 'print "T $(ke:%.17g) $(c_p[4]:%.17g) $(vx[33]:%.17g)"'
	} >in.threads
	"$TSIM" -in in.threads -log none | grep '^T ' >threads.$threads
	same "bit for bit with $threads threads" threads.1 threads.$threads
done

# Two spheres that fly through the sheared faces: the unwrapped position is that of uniform motion.
agree 'centres of mass are unwrapped from the sheared box' '
units si
atom_style sphere
boundary p p p
region b block 0 1 0 1 0 1
create_box 1 b
create_atoms 1 single 0.2 0.9 0.5
create_atoms 1 single 0.7 0.95 0.5
set group all diameter 0.01 density 1000
velocity all set 0 1 0
fix s all deform 1 xy erate 0.7 remap v
fix n all nve/sphere
compute com all com
compute type all chunk/atom type
compute chunk all com/chunk type
timestep 1e-3
run 500
print "is centre $(xcm(all,x):%.17g) 0.45"
print "is centre $(xcm(all,y):%.17g) 1.425"
print "is centre $(c_com[1]:%.17g) 0.45"
print "is centre $(c_chunk[1][1]:%.17g) 0.45"'

box='units si
boundary p p f
region b block 0 0.01 0 0.01 0 0.01 units box
create_box 1 b
create_atoms 1 single 0.005 0.0095 0.005 units box
set group all diameter 1e-3 density 2385
fix i all nve
timestep 1e-5'
rejects "$box
fix s all deform 1 xy erate 1
run 0" 'cannot be used with remap x or none (say `remap v`)'
rejects "$box
fix s all deform 2 xy erate 1 remap v
run 0" 'cannot be used with N other than 1'
rejects "$box
fix s all deform 1 xy erate 1 xz erate 1 remap v
run 0" 'cannot be used with another of xy, xz, yz'
rejects "$box
fix s all deform 1 xy erate 1 x erate 1 remap v
run 0" 'cannot be used with x, y or z'
rejects "$box
fix s all deform 1 xz erate 1 remap v
run 0" 'xz needs a box that is periodic in x and z'
rejects "$box
fix s all deform 1 xy erate 1 remap v
fix g all move linear 0 0 1
run 0" 'cannot be used with fix move'
rejects "$box
fix s all deform 1 xy erate 1 remap v
run 1
write_data out" 'the box has been sheared by fix deform'
rejects "$box
pair_style spring/dashpot
pair_coeff 1 1 stiffness 2e3 restitution 0.9
set group all diameter 4.5e-3
fix s all deform 1 xy erate 1 remap v
run 1" 'less than twice the reach'
finish
