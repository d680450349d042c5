#!/bin/bash
# A fluid continued from a restart file, with all that is put out of it, is the fluid that went on: byte for byte.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >scene <<'END'
units si
boundary p f f
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
END
# rest TIME CONVECTION PRESSURE
rest() {
	cat <<END
variable pull equal sin(40*time)
variable lid equal 0.3+time
flow_style projection cells 4 6 5 viscosity 0.1 density 2.385 body_force v_pull 0 0.1 time $1 convection $2
flow_boundary yhi wall velocity v_lid 0 0
pressure_style $3
dump i all flow/vtk 10 s*.vti
compute top all flow/force yhi
variable ke equal flow_ke
fix m all ave/time 1 10 10 v_ke c_top[1]
thermo 10
thermo_style custom step flow_ke flow_div flow_cfl flow_res flow_time flow_steps f_m[1] f_m[2]
thermo_modify format float %.17g
timestep 5e-3
END
}
while read -r time convection pressure; do
	rm -rf whole again
	mkdir whole again
	{ cat scene; rest $time $convection $pressure; printf 'run 45\nwrite_restart ../restart\nrun 35\n'; } >whole/in
	{ echo 'read_restart ../restart'; rest $time $convection $pressure; echo 'run 35'; } >again/in
	(cd whole && "$TSIM" -in in -log none) >whole/out 2>&1 && (cd again && "$TSIM" -in in -log none) >again/out 2>&1
	report "$time $convection $pressure runs" $? whole/out
	rows whole/out | tail -n 4 >whole/rows
	rows again/out | tail -n 4 >again/rows
	same "$time $convection $pressure: the log" whole/rows again/rows
	for file in s.pvd s80.vti; do
		same "$time $convection $pressure: $file" whole/$file again/$file
	done
done <<'END'
euler central direct
ab2 quick cg
rk2 donor cg
rk3 cubista direct
END
# The grid that the lines after read_restart make is that of the file, or it is said: a flow or a scalar in other cells is another.
couette='flow_style projection cells 4 8 2 viscosity 0.1 density 1
flow_grid y geometric 6
flow_boundary yhi wall velocity 1 0 0
fix T all flow/scalar conductivity 0.1 yhi value 1
timestep 0.002
thermo_style custom step flow_ke f_T[1]'
prints "units si
boundary f f p
region box block 0 1 0 1 0 1 units box
create_box 1 box
$couette
run 50
write_restart graded.restart
print saved" saved
while read -r what edit found; do
	prints "read_restart graded.restart
$(sed "$edit" <<<"$couette")
run 0
print \"$what\"" "$what"
	report "$what grid: told $found times" $(($(grep -c 'the grid has changed' out) != found)) out
done <<'END'
same p 0
other s/6$/5/ 2
forgotten /flow_grid/d 2
END
# the scalar is that of the file, wherever flow_grid stands
prints "read_restart graded.restart
$(sed '2{h;d};4G' <<<"$couette")
run 0
print \"heat \$(f_T[1] > 0.01)\"" 'heat 1'
grep -q 'the grid has changed' out
report 'the grid is that of the file' $((!$?)) out
# An inlet by pressure and an outlet beside periodic faces, across which the fluid turns at these steps.
pad=$top_srcdir/tests/decks/in.rough_pad
"$TSIM" -in "$pad" -log none >whole.out 2>&1
rows whole.out | tail -n 3 >whole.rows
for cut in 10 11 12; do
	sed "s/^run .*/run $cut\nwrite_restart restart/" "$pad" >in.first
	{ echo 'read_restart restart'; sed "/^units/d; /^boundary/d; /^region box/d; /^create_box/d; s/^run .*/run $((24 - cut))/" "$pad"; } >in.again
	"$TSIM" -in in.first -log none >first.out 2>&1 && "$TSIM" -in in.again -log none >again.out 2>&1
	report "the pad cut at step $cut runs" $? again.out
	rows again.out | tail -n 3 >again.rows
	same "the pad cut at step $cut" whole.rows again.rows
done
# An open face beside an inlet, where the sign of the velocity at their edge decides; open faces with a pressure of their own,
# which a body covers: in one run, in two, and from a file.
rm -rf whole again
while read -r what cut faces; do
	cat >in.corner <<END
$(sed 's/ p f f/ f f f/' scene)
region rod cylinder z 0.5 0.3 0.15 INF INF units box
END
	cat >in.rest <<END
flow_style projection cells 6 5 4 viscosity 0.02 density 2.385
$(tr '|' '\n' <<<"$faces")
timestep 5e-3
thermo_style custom step flow_ke flow_px flow_py flow_pz
thermo_modify format float %.17g
END
	{ cat in.corner in.rest; echo 'run 7'; } >in.through
	{ cat in.corner in.rest; echo "run $cut"; echo 'write_restart restart'; echo "run $((7 - cut))"; } >in.whole
	{ echo 'read_restart restart'; grep '^region rod' in.corner; cat in.rest; echo "run $((7 - cut))"; } >in.again
	resumes "$what" rows 1
	"$TSIM" -in in.through -log none >through 2>&1
	rows through | tail -n 1 >rows.through
	same "$what: in one run" rows.whole rows.through
done <<'END'
edge 1 flow_boundary xlo inlet pressure 10|flow_boundary yhi inlet velocity 0 -0.1 0
covered 2 flow_boundary zhi inlet pressure 1.2|flow_boundary ylo outlet|fix rod all immersed/boundary region rod min_cells 0
END
finish
