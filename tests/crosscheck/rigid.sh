#!/bin/bash
# Rigid bodies against LAMMPS, an independent program: two bodies of spheres fall, turn and collide.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs /usr/bin/python3 python3

cat >in.scene <<'END'
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
region b block -10 10 -10 10 -10 10 units box
create_box 1 b
create_atoms 1 single 0 0 1.3 units box
create_atoms 1 single 0.8 0.1 1.5 units box
create_atoms 1 single 1.1 0.9 1.7 units box
create_atoms 1 single 3.4 0.4 1.2 units box
create_atoms 1 single 3.4 1.3 1.5 units box
set atom 1 diameter 1.1 density 2.385
set atom 2 diameter 0.9 density 1.7
set atom 3 diameter 1.3 density 2.1
set atom 4 diameter 1.0 density 1.9
set atom 5 diameter 1.2 density 1.3
group a id 1 2 3
group c id 4 5
velocity a set 1.3 0.1 -0.2
velocity c ramp vy -0.7 0.4 z 1.1 1.6
pair_style gran/hooke/history 20000 NULL 50 NULL 0.5 1
pair_coeff * *
timestep 0.0005
neigh_modify exclude group a a exclude group c c
neighbor 0.3 bin
fix g all gravity 1.7 vector 0 0.3 -1
thermo_style custom step atoms
thermo 1000
END

agrees() { # WHAT LINES...
	local what=$1
	shift
	{
		echo 'include in.scene'
		printf '%s\n' "$@"
		echo 'dump d all custom 100 ${out}.dump id x y z vx vy vz omegax omegay omegaz'
		echo 'dump_modify d sort id format float %.17g'
		echo 'run 2000'
	} >in.case
	lmp -in in.case -log none -screen none -var out lmp >err 2>&1
	report "$what: LAMMPS" $? err
	"$TSIM" -in in.case -log none -screen none -var out tsim 2>err
	report "$what: tsim" $? err
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump # of other precision
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.dump tsim.dump 1e-11 \
		>deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
}

agrees 'two bodies' 'fix r all rigid group 2 a c'
agrees 'one body' 'fix n c nve/sphere' 'fix r a rigid single'
agrees 'held in some directions' \
	'fix r all rigid group 2 a c force 1 on off on torque 2 off off on'
for style in rigid rigid/small; do
	agrees "molecules: $style" 'fix m all property/atom mol ghost yes' 'set group a mol 7' 'set group c mol 2' \
		"fix r all $style molecule"
done
finish
