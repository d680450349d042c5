#!/bin/bash
# Servo meshes against LIGGGHTS 3.8: place, force and torque in every step.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
plate 2 0 >plate.stl
two_materials >in.both
cat >>in.both <<'END2'
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix a all mesh/surface/stress/servo file plate.stl type 2 move -0.1 -0.05 0 com 0.05 0.06 0.01 ${servo}
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes a
create_atoms 1 single 0.1 0.1 0.0495 units box
create_atoms 1 single -0.2 0.3 ${z} units box
set type 1 diameter 0.1 density 2385
fix nv all ${fix}
thermo 1
thermo_style custom step f_a[1] f_a[2] f_a[3] f_a[4] f_a[5] f_a[6] f_a[7] f_a[8] f_a[9]
thermo_modify format float %.17g
include in.runs
END2

# agree WHAT FIX Z SERVO COMMANDS...: the tables, to 1e-11 of the largest of each column; where a run follows another LIGGGHTS shows forces twice
agree() {
	local what=$1 options=(-in in.both -var fix "$2" -var z "$3" -var servo "$4")
	shift 4
	printf '%s\n' "$@" >in.runs
	liggghts "${options[@]}" -log theirs >out 2>&1
	report "$what: LIGGGHTS" $? out
	"$TSIM" "${options[@]}" -log ours -screen none 2>out
	report "$what: tsim" $? out
	for side in theirs ours; do
		grep -hE '^ +[0-9]+ [-+0-9.e ]+$' $side | awk '!seen[$1]++' >$side.table
	done
	{ /usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" theirs.table ours.table 1e-11 &&
		[ "$(wc -l <ours.table)" -ge 10 ]; } >difference 2>&1
	report "$what" $? difference
}
force='vel_max 0.3 axis 0 0 2 ctrlPV force target_val'
agree 'PID' freeze 0.2 "$force 50 kp 0.01 ki 100 kd 1e-7" 'run 100'
agree 'away' freeze 0.2 "$force -50 kp 0.01 ki 100 kd 1e-7" 'run 100'
agree 'at the limit' freeze 0.2 "$force 50 kp 0.9 ki 30000 kd 3e-7" 'run 200'
agree 'at the other limit' freeze 0.2 'vel_max 0.003 axis 0 0 1 ctrlPV force target_val 9 kp 6 ki 3000' 'run 50'
agree 'loose particles' nve/sphere 0.06 "$force 12 kp 0.9" 'run 500'
agree 'auto' nve/sphere 0.055 "$force 12 mode auto ratio 0.00001" 'run 500'
agree 'auto, far' nve/sphere 0.075 "$force 120 mode auto ratio 0.001" 'run 800'
agree 'torque' nve/sphere 0.0497 'vel_max 0.3 axis 1 0.2 0.1 ctrlPV torque target_val 0.5 kp 0.3 ki 20' 'run 300'
agree 'fix_modify' freeze 0.2 "$force 50 kp 0.01 ki 100 kd 1e-7" 'run 3' 'fix_modify a servo/integrate stop' \
	'run 3' 'fix_modify a servo/integrate start' 'run 3' 'fix_modify a servo/target_val 90' 'run 2' \
	'fix_modify a servo/vel_max 0.03' 'run 2' 'fix_modify a servo/ctrlParam 0.5 3 1e-8' 'run 2'
finish
