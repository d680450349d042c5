#!/bin/bash
# Particles that leave the box through a fixed face: when they are taken out.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# past the face after 4.5 steps, half the skin from where neighbours were found after 45.5
scene='units si
boundary f f f
region b block 0 1 0 1 0 1 units box
create_box 1 b
neighbor 0.01 bin
create_atoms 1 single 0.9995 0.5 0.5
create_atoms 1 single 0.2 0.5 0.5
set group all diameter 0.02385 density 2385
set atom 1 vx 1.1
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
fix move all nve
timestep 1e-4
thermo_style custom step atoms
thermo 1'
last_with_two() {
	printf '%s\n%s\n' "$scene" "$1" >in.outflow
	"$TSIM" -in in.outflow -log none >out 2>&1
	[ "$(awk 'NF == 2 && $2 == 2 { last = $1 } END { print last }' out)" = "$2" ] &&
		grep -qx 'Particles lost through fixed faces so far: 1' out
	report "$1" $? out
}
last_with_two 'thermo_modify lost warn
run 60' 4
last_with_two 'thermo_modify lost ignore
run 60' 45
last_with_two 'thermo_modify lost ignore
run 20
run 40' 45
rejects "$scene
thermo_modify lost error
run 60" 'left the box through its fixed face xhi at step 5'
finish
