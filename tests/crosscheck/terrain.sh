#!/bin/bash
# Grains that bounce and roll over a rough ground of triangles of all shapes, against LIGGGHTS 3.8: at obtuse corners it
# loses contacts, which tsim follows with -legacy.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
needs /usr/bin/python3 python3
awk -v n=20 'function p() { # numbers that look random
		state = (state * 16807) % 2147483647
		return state / 2147483647
	}
	BEGIN {
		state = 8613
		for (i = 0; i <= n; i++) for (j = 0; j <= n; j++)
			at[i, j] = sprintf("%.9g %.9g %.9g", -0.95 + 1.9 * (i + 0.3 * p()) / n, -0.95 + 1.9 * (j + 0.3 * p()) / n, 0.03 * p())
		for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
			print at[i, j], at[i + 1, j], at[i + 1, j + 1]
			print at[i, j], at[i + 1, j + 1], at[i, j + 1]
		}
	}' | solid >terrain.stl
cp "$top_srcdir/tests/crosscheck/scripts/materials" .
cat >in.terrain <<'END'
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
neighbor ${skin} bin
neigh_modify delay 0
include materials
pair_style gran model hertz tangential history
pair_coeff * *
timestep 2e-5
fix m all mesh/surface file terrain.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes m
fix g all gravity 100 vector 0 0 -1
lattice sc 0.2
region r block -0.7 0.7 -0.7 0.7 -0.001 0.001 units box
create_atoms 1 region r
displace_atoms all move 0.01 0.02 0.08 units box
set group all diameter 0.1 density 2385
velocity all set 0.5 0.17 -0.1
region q1 block 0 2 0 2 -1 1 units box
group q1 region q1
velocity q1 set -1.3 -0.77 -0.3
region q2 block -2 0 0 2 -1 1 units box
group q2 region q2
velocity q2 set 0.3 -0.77 0.0
fix nv all nve/sphere
dump d all custom 100 ${out} id x y z vx vy vz fx fy fz omegax omegay omegaz
dump_modify d sort id format "%d %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g %.15g"
run 3000
END
skin=0.03
# (without a log LIGGGHTS crashes where it reads a mesh)
liggghts -in in.terrain -var out theirs -var skin $skin >err 2>&1
report 'LIGGGHTS' $? err
"$TSIM" -legacy -in in.terrain -var out ours -var skin $skin -log none -screen none 2>err
report 'tsim' $? err
/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" theirs ours 1e-9 >deviation 2>&1
report 'rough ground' $? deviation
echo "rough ground: $(cat deviation)"
# and it does matter
"$TSIM" -in in.terrain -var out ours -var skin $skin -log none -screen none 2>err
report 'without -legacy' $? err
! /usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" theirs ours 1e-3 >deviation 2>&1
report 'without -legacy contacts at obtuse corners stay' $? deviation
finish
