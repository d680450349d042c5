#!/bin/bash
# Bodies in a fluid that are lighter than it, or as heavy: they run with the defaults, and the step does not matter more
# than for others; against potential flow, momentum, several at once, rigid ones and meshes, order of lines, restart
# and threads; what a run says that fails.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh" || exit 99

cat >in.disc <<'END'
units si
dimension 2
atom_style granular
newton off
communicate single vel yes
boundary f f p
region box block -4 4 -4 4 -0.5 0.5 units box
create_box 1 box
neighbor 0.1 bin
create_atoms 1 single 0.013 -0.017 0 units box
variable ratio index 0.1
variable N index 8
variable nu index 0.01
variable dt index 0.01
variable T index 0.2
variable more index " "
variable first index " "
set group all diameter 1 density ${ratio}
flow_style projection cells $(8*v_N) $(8*v_N) 1 viscosity ${nu} density 1 time rk2
flow_boundary all slip
${first}
fix ball all immersed/boundary spheres ${more}
fix g all gravity $(1-1/v_ratio) vector 0 -1 0
fix i all nve/sphere
timestep ${dt}
thermo 100000
run $(round(v_T/v_dt))
print "V $(vcm(all,y):%.17g) $(xcm(all,y):%.17g)"
END
# speed NAME VALUE ...: after the time T
speed() {
	local settings=() k
	for ((k = 1; k < $#; k += 2)); do settings+=(-var "${@:k:1}" "${@:k+1:1}"); done
	"$TSIM" -in in.disc -log none "${settings[@]}" >out 2>&1
	awk '$1 == "V" { print $2 }' out
}

# ---- the error of the step halves with it, for any density
for ratio in 0.1 0.5 0.99 2 10; do
	a=$(speed ratio $ratio dt 0.02) b=$(speed ratio $ratio dt 0.01) c=$(speed ratio $ratio dt 0.005)
	awk -v a="$a" -v b="$b" -v c="$c" 'BEGIN {
		limit = 2 * c - b; da = (a - limit) / limit; db = (b - limit) / limit; dc = (c - limit) / limit
		exit !(a != "" && da^2 < 0.07^2 && db^2 <= (0.6 * da)^2 && dc^2 <= (0.6 * db)^2)
	}'
	report "density $ratio: $a $b $c with steps that halve" $? out
done

# ---- at t -> 0 the acceleration is (rho_p - rho) g/(rho_p + C rho), C = 1 in potential flow; with cells of h the layer
# that the surface holds adds to C, of first order in h
# added RATIO N: C
added() {
	speed ratio "$1" N "$2" nu 1e-3 dt 0.002 T 0.02 | awk -v r="$1" '{ print (1 - r) * 0.02 / $1 - r }'
}
for ratio in 0.1 3; do
	a=$(added $ratio 8) b=$(added $ratio 16)
	awk -v a="$a" -v b="$b" 'BEGIN { c = 2 * b - a; exit !(c > 0.95 && c < 1.1 && a < 1.8) }'
	report "added mass of a cylinder of density $ratio: $a $b with 8 and 16 cells, 1 in potential flow" $? out
done

# ---- as heavy as the fluid it stays where it is, and near to massless it rises and stands
near_zero=$(speed ratio 1 T 2)
[ "$near_zero" = 0 ] || [ "$near_zero" = -0 ]
report "as heavy as the fluid: $near_zero" $? out
speed ratio 0.001 dt 0.02 nu 0.002 T 4 | awk '{ ok = ($1 > 0.5 && $1 < 1.5); exit } END { exit !ok }'
report 'a thousandth of the density' $? out

# ---- the order of lines does not matter
sed 's/^fix ball.*/fix g all gravity $(1-1\/v_ratio) vector 0 -1 0/; t; s/^fix g .*/fix ball all immersed\/boundary spheres ${more}/' \
	in.disc >in.other
"$TSIM" -in in.disc -log none >out 2>&1
"$TSIM" -in in.other -log none >other 2>&1
grep '^V' out >first
grep '^V' other >second
[ -s first ]
report 'gravity after the body' $? out
same 'gravity before and after the body' first second

# ---- nor how deep the box of a flow in the plane is
sed 's/-0.5 0.5 units/-0.03 0.04 units/' in.disc >in.thin
"$TSIM" -in in.thin -log none >out 2>&1
grep '^V' out | awk '{ printf "V %.9g %.9g\n", $2, $3 }' >second
awk '{ printf "V %.9g %.9g\n", $2, $3 }' first >third
same 'depth of the box' second third

# ---- without the virtual mass it fails, and is told why; relax helps
"$TSIM" -in in.disc -log none -var more 'virtual_mass 0' >out 2>&1
[ $? = 1 ] && grep -q 'bodies of fix immersed/boundary ball .*use .relax. below its 1' out && ! grep -q 'Courant' out
report 'a run that fails names relax' $? out
near=$(speed T 0.4) relaxed=$(speed more 'relax 0.2' T 0.4)
awk -v a="$near" -v b="$relaxed" 'BEGIN { d = a / b - 1; exit !(a > 0 && d != 0 && d^2 < 0.05^2) }'
report "relax: $relaxed, without $near" $?

# ---- momentum: a body that is thrown into a periodic fluid at rest and the fluid come to one velocity
cat >in.thrown <<'END'
units si
dimension 2
atom_style granular
newton off
communicate single vel yes
boundary p p p
region box block -1 1 -1 1 -0.5 0.5 units box
create_box 1 box
neighbor 0.1 bin
create_atoms 1 single 0.013 -0.017 0 units box
set group all diameter 1 density ${ratio}
velocity all set 1 0.3 0
flow_style projection cells 20 20 1 viscosity 0.5 density 1
fix ball all immersed/boundary spheres
fix i all nve/sphere
timestep 0.002
thermo 100000
run 1500
variable m equal PI/4*${ratio}
print "U $(vx[1]*(v_m+4-PI/4)/v_m) $(vy[1]*(v_m+4-PI/4)/v_m/0.3)"
END
for ratio in 0.1 0.6 3; do
	"$TSIM" -in in.thrown -log none -var ratio $ratio >out 2>&1
	awk '$1 == "U" { n++; exit !($2 > 0.99 && $2 < 1.01 && $3 > 0.99 && $3 < 1.01) } END { if (!n) exit 1 }' out
	report "momentum of body and fluid, density $ratio" $? out
done

# ---- two at once that touch, a light clump, and a light mesh, in three dimensions; threads and restart bit for bit
cat >in.head <<'END'
units si
atom_style granular
newton off
communicate single vel yes
END
cat >in.made <<'END'
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
create_atoms 1 single 0.27 0.25 0.3 units box
create_atoms 1 single 0.29 0.27 0.66 units box
create_atoms 1 single 0.72 0.7 0.4 units box
create_atoms 1 single 0.82 0.78 0.44 units box
set group all diameter 0.35 density 0.1
set atom 2 density 3
END
awk 'BEGIN { # an octahedron
	for (k = 0; k < 8; k++) {
		a = k % 2 ? -0.22 : 0.22; b = int(k / 2) % 2 ? -0.22 : 0.22; c = k > 3 ? -0.22 : 0.22
		x = a " 0 0"; y = "0 " b " 0"; z = "0 0 " c
		print (a * b * c > 0 ? x " " y : y " " x) " " z
	}
}' | solid >eight.stl
cat >in.rest <<'END'
soft_particles yes
fix m1 all property/global youngsModulus peratomtype 2e4
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix m5 all property/global characteristicVelocity scalar 2
pair_style gran model hooke tangential history
pair_coeff * *
group clump id 3 4
group alone id 1 2
flow_style projection cells 12 12 12 viscosity 0.01 density 1
fix bodies all immersed/boundary spheres
fix clump clump rigid single
fix step alone nve/sphere
fix g all gravity 1 vector 0 0 1
fix s all mesh/surface/stress file eight.stl type 1 move 0.75 0.25 0.65
fix wet all immersed/boundary mesh s
fix free all move/mesh/free mesh s density 0.2
fix walls all wall/gran model hooke tangential history mesh n_meshes 1 meshes s
timestep 2e-3
thermo 5
compute each all reduce sum vx vy vz
variable z1 equal z[1]
variable z3 equal z[3]
thermo_style custom step flow_ke ke v_z1 v_z3 f_free[3] f_free[6] f_free[9] c_each[1] c_each[3] f_bodies[1] f_bodies[6] f_wet[3]
thermo_modify format float %.17g
END
{ cat in.head in.made in.rest; echo 'run 33'; echo 'write_restart restart'; echo 'run 27'
	echo 'print "RISEN $(vz[2]>0.001) $(z[1]>0.3) $(vz[1]!=0 && f_free[6]!=0 && vz[3]!=0) $(abs(vz[1])<0.1 && abs(f_free[6])<0.1 && abs(vz[3])<0.1)"'; } >in.whole
{ cat in.head; echo 'read_restart restart'; cat in.rest; echo 'run 27'; } >in.again
resumes 'two bodies, a clump and a mesh' rows 5
grep -qx 'RISEN 1 1 1 1' whole
report 'they have risen' $? whole
finish
