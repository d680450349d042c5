#!/bin/bash
# What particles do to meshes, against LIGGGHTS 3.8: force, torque, stresses and wear.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
plate 3 0 >plate.stl
cuboid 0.2 0.15 0.1 >cube.stl
two_materials >in.both
cat >>in.both <<'END2'
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.15 0.14 0.14 0.3
fix m6 all property/global k_finnie peratomtypepair 2 0.7 1.3 1.3 2.1
pair_style gran model hertz tangential history rolling_friction cdt
pair_coeff * *
timestep 1e-5
fix plate all mesh/surface/stress file plate.stl type 2 move -0.1 -0.05 0 rotate axis 1 1 0.3 angle 12.5 &
	wear finnie reference_point 0.1 0.2 0.3
fix cube all mesh/surface/stress file cube.stl type 1 move 0.3 0.3 0.17 ${cube}
fix w all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 2 meshes plate cube
create_atoms 1 single 0.1 0.1 0.05 units box
create_atoms 2 single 0.0 0.2 0.09 units box
create_atoms 1 single -0.2 -0.3 0.12 units box
create_atoms 2 single 0.3 0.25 0.31 units box
create_atoms 1 single 0.04 0.3 0.17 units box
set type 1 diameter 0.1 density 2385
set type 2 diameter 0.093 density 1385
velocity all set 1.3 0.2 -3.1
fix nv all nve/sphere
thermo 20
thermo_style custom step f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6] &
	f_plate[7] f_plate[8] f_plate[9] f_cube[1] f_cube[2] f_cube[3] f_cube[4] f_cube[5] f_cube[6]
thermo_modify format float %.17g
dump v all mesh/vtk 40 *.vtk stress stresscomponents wear id
dump i all mesh/vtk 200 i*.vtk output interpolate stress stresscomponents wear plate
run 400
END2

# numbers WHAT FILE FILE: the same words, numbers but for rounding
numbers() {
	paste -d '\n' "$2" "$3" | awk '
		function number(w) { return w ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?$/ }
		NR % 2 { n = split($0, a); next }
		{
			lines++
			if (NF != n) bad = 1
			for (k = 1; k <= n; k++) {
				d = a[k] - $k; size = a[k] < 0 ? -a[k] : a[k]
				if (number(a[k]) ? !(d <= 1e-9 * size && -d <= 1e-9 * size) : a[k] != $k) {
					print "line " lines ": " a[k] " and " $k; bad = 1
				}
			}
		}
		END { exit bad || lines < 3 }' >difference
	report "$1" $? difference
}

# agree WHAT CUBE: with these words for the cube
agree() {
	for side in theirs ours; do
		rm -rf $side && mkdir $side && cp ./*.stl in.both $side
	done
	(cd theirs && liggghts -in in.both -var cube "$2" -log log >out 2>&1)
	report "$1: LIGGGHTS" $? theirs/out
	(cd ours && "$TSIM" -in in.both -var cube "$2" -log log -screen none 2>out)
	report "$1: tsim" $? ours/out
	for side in theirs ours; do
		rows $side/log >$side/table
	done
	numbers "$1: force and torque" theirs/table ours/table
	for file in theirs/*.vtk; do
		numbers "$1: $file" "$file" "ours/${file#theirs/}"
	done
}
agree 'both' 'wear finnie'
agree 'without stress' 'stress off wear finnie'
agree 'without wear' 'reference_point -0.3 0.2 0.1'
finish
