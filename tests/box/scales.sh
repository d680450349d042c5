#!/bin/bash
# No length, time or speed is built in: one scene in other units of length L and time T, its moduli and forces such that
# the problem without dimensions is the same, has the same results: by powers of two bit for bit, by others but for
# rounding.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

# a ridge of flat neighbours with edges, corners and rims, and a plate
awk 'function p(x, y, z) { return sprintf("%.17g %.17g %.17g", x, y, z) }
BEGIN {
	for (i = 0; i < 8; i++) {
		x = 0.012 + i * 0.0095; y = x + 0.0095
		a = p(x, 0.041, 0.04); b = p(y, 0.041, 0.04); c = p(x, 0.012, 0.017); d = p(y, 0.012, 0.017)
		e = p(x, 0.07, 0.017); f = p(y, 0.07, 0.017)
		print a, c, d; print a, d, b; print a, b, f; print a, f, e
	}
}' | solid >ridge.stl
awk 'function p(i, j) { return sprintf("%.17g %.17g 0.003", i / 60, j * 0.083 / 6) }
BEGIN {
	for (i = 0; i < 6; i++) for (j = 0; j < 6; j++) {
		a = p(i, j); b = p(i + 1, j); c = p(i + 1, j + 1); d = p(i, j + 1)
		print a, b, c; print a, c, d
	}
}' | solid >plate.stl

# Friction with history, rolling, cohesion, wear, bonds that break, drag, planes, a mesh that moves, a stream. Numbers
# stand in $(...), which keeps all digits.
cat >in.scene <<'END'
units si
atom_style granular
newton off
communicate single vel yes
hard_particles yes
soft_particles yes
boundary p f f
region box block 0 $(0.1*v_L) 0 $(0.083*v_L) $(-0.01*v_L) $(0.15*v_L) units box
region bed block $(0.001*v_L) $(0.099*v_L) $(0.001*v_L) $(0.08*v_L) $(0.05*v_L) $(0.08*v_L) units box
create_box 2 box
neighbor $(0.001*v_L) bin
lattice sc $(0.0093*v_L)
create_atoms 1 region bed
set type 1 diameter $(0.0085*v_L) density 2500
variable u equal v_L/v_T
velocity all set $(0.31*v_u) $(-0.17*v_u) $(-0.7*v_u) units box
fix m1 all property/global youngsModulus peratomtype $(5.3e6*v_u*v_u) $(7.7e6*v_u*v_u)
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.73 0.61 0.61 0.53
fix m4 all property/global coefficientFriction peratomtypepair 2 0.17 0.31 0.31 0.41
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.07 0.11 0.11 0.13
variable c equal 3e3*v_u*v_u
fix m6 all property/global cohesionEnergyDensity peratomtypepair 2 $(v_c) $(v_c) $(v_c) $(v_c)
variable k equal 0.7/v_u/v_u
fix m7 all property/global k_finnie peratomtypepair 2 $(v_k) $(v_k) $(v_k) $(v_k)
pair_style gran model hertz tangential history cohesion sjkr rolling_friction epsd2
pair_coeff * *
bond_style contact
bond_coeff 1 stiffness $(900*v_L^3/v_T^2) ultimate $(0.3*v_L^4/v_T^2)
group some id < 60
create_bonds many some some 1 0.0 $(0.0095*v_L)
fix step all nve/sphere
fix g all gravity $(9.81*v_L/v_T/v_T) vector 0.1 0 -1
fix ridge all mesh/surface/stress file ridge.stl type 2 wear finnie scale $(v_L)
fix floor all mesh/surface file plate.stl type 2 scale $(v_L)
fix shake all move/mesh mesh ridge wiggle amplitude 0 $(0.0002*v_L) $(0.0005*v_L) period $(0.011*v_T)
fix walls all wall/gran model hertz tangential history cohesion sjkr rolling_friction epsd2 mesh n_meshes 2 meshes ridge floor
fix left all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 2 yplane 0.0
fix right all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 2 yplane $(0.083*v_L)
flow_style uniform velocity $(0.3*v_u) 0 $(0.1*v_u) viscosity $(0.003*v_L*v_u) density 1.2
fix drag all drag/schiller_naumann
fix inlet all mesh/surface/planar file plate.stl type 2 move 0 0 0.09 scale 0.6 scale $(v_L) move $(0.02*v_L) $(0.016*v_L) $(0.07*v_L)
fix grain all particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius constant $(0.003*v_L) volume_limit 0
fix grains all particledistribution/discrete 15485863 1 grain 1.0
fix rain all insert/stream seed 32452843 distributiontemplate grains nparticles 10 particlerate $(2e3/v_T) &
	vel constant 0 0 $(-0.9*v_u) insertion_face inlet extrude_length $(0.015*v_L)
timestep $(2e-5*v_T)
thermo 1000
variable nx atom x/v_L
variable ny atom y/v_L
variable nz atom z/v_L
variable nu atom vx/v_u
variable nw atom vz/v_u
variable no atom omegax*v_T
variable nf atom fz/v_L^4*v_T^2
dump d all custom 500 ${out}.dump id v_nx v_ny v_nz v_nu v_nw v_no v_nf
dump_modify d format float %.17g sort id
run 1500
print "$(f_ridge[1]/v_L^4*v_T^2:%.17g) $(f_ridge[3]/v_L^4*v_T^2:%.17g) bonds $(bonds) grains $(count(all))" file ${out}.sums
dump wear all mesh/vtk 1 ${out}.*.vtk wear
dump_modify wear every 1500 first yes
run 0
END

# scene NAME L T
scene() {
	timeout 60 "$TSIM" -in in.scene -log none -var L "$2" -var T "$3" -var out "$1" >"$1.out" 2>&1
	report "scene $1" $? "$1.out"
}

# alike NAME TOLERANCE: the dumps are those of the scene `one`, by parts of the largest number of each column
alike() {
	awk -v tolerance="$2" '
		FNR == 1 { file++ }
		/^ITEM: ATOMS/ { rows = 1; frame[file]++; next }
		/^ITEM/ { rows = 0 }
		rows { for (k = 2; k <= NF; k++) {
			at = frame[file] " " $1 " " k
			n[file]++
			if (file == 1) { v[at] = $k; if ($k > most[k]) most[k] = $k; if (-$k > most[k]) most[k] = -$k; continue }
			d = $k - v[at]
			if (!(at in v) || !(d <= tolerance * most[k] && -d <= tolerance * most[k])) {
				print "frame " frame[file] " particle " $1 " column " k ": " $k " is not " v[at]
				bad = 1
			}
		} }
		END { exit bad || n[1] < 5000 || n[1] != n[2] }' one.dump "$1.dump" >difference
	report "$1 is as one" $? difference
}

# wear NAME L: by triangle, of six digits
wear() {
	awk -v l="$2" '
		FNR == 1 { file++; on = 0 }
		/wear/ { on = 1; getline; next }
		on { for (k = 1; k <= NF; k++) if (file == 1) { v[++n] = $k; if ($k > 0) worn++ } else {
			d = $k / l - v[++m]
			if (!(d <= 2e-5 * v[m] && -d <= 2e-5 * v[m])) bad = 1 } }
		END { exit bad || n != m || worn < 5 }' one.1500.vtk "$1.1500.vtk" >difference
	report "wear of $1" $? "$1.1500.vtk"
}

scene one 1 1
while read -r name l t tolerance; do
	scene "$name" "$l" "$t"
	alike "$name" "$tolerance"
	wear "$name" "$l"
done <<'END'
micrometres	1e-6	1	1e-9
megametres	1e6	1	1e-9
microseconds	1	1e-6	1e-9
megaseconds	1	1e6	1e-9
small		9.5367431640625e-07	1	0
large		1048576	1	0
quick		1	9.5367431640625e-07	0
slow		1	1048576	0
both		9.5367431640625e-07	1048576	0
END
finish
