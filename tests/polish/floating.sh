#!/bin/bash
# The wafer on a film from scripts: the examples, lines in other orders, what -check and -explain say.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99

cd polishing || exit 99
mkdir -p post
"$TSIM" -in in.stribeck -log none >out 2>&1 && [ "$(grep -c '^RESULT .* ok$' out)" = 5 ] && ! grep -q '^RESULT .* off$' out
report 'the curve of Stribeck' $? out
[ "$(wc -l <post/stribeck.txt)" = 32 ]
report 'its table' $? post/stribeck.txt
"$TSIM" -in in.wafer -log none -var film yes -var pads 2 -var steps 4 >out 2>&1 &&
	[ "$(grep -c '^RESULT .* ok$' out)" = 2 ] && ! grep -q '^RESULT .* off$' out
report 'the wafer on a film' $? out
cd ..

cat >in.scene <<'END'
units si
boundary f f f
region box block 0 1 0 0.5 -1 1 units box
create_box 1 box
fix pad all surface/voxel constant -0.5 type 1 cells 4 4
timestep 1e-3
END
wafer='fix w all wafer pad settled stiffness 1e3 pressure 300 joint_1 0.07'
film='flow_style reynolds cells 20 1 lower 0 lower_velocity 6 0 0 upper_wafer w viscosity 1 density 1 closed ylo yhi'
# of NAME TEXT LINES...: refused with the text
of() {
	local name=$1 text=$2
	shift 2
	printf '%s\n' 'include in.scene' "$@" >in.script
	refused "$name" "$text" -in in.script
	"$TSIM" -check -in in.script >out 2>&1
	[ $? = 1 ] && grep -qF "$text" out
	report "$name: -check" $? out
}
# a wafer that only squeezes the film: nothing drives it before the first step
printf '%s\n' 'include in.scene' 'fix w all wafer pad dynamic mass 1 inertia_1 1 inertia_2 1 stiffness 1e3 pressure 300 start 0.5' \
	'flow_style reynolds cells 8 4 lower 0 upper_wafer w viscosity 1 density 1' 'run 1' >in.script
"$TSIM" -in in.script -log none >out 2>&1 && ! grep -q 'the fluid is at rest' out
report 'no word about a fluid at rest under a wafer' $? out
of 'the film first' "in.script:2:73: error: flow_style reynolds: there is no fix 'w'" "$film" "$wafer" 'run 1'
of 'no wafer any more' "there is no fix 'w'" "$wafer" "$film" 'run 1' 'unfix w' 'run 1'
of 'no pad any more' "there is no height field 'pad'" "$wafer" "$film" 'run 1' 'unfix pad' 'run 1'
of 'two wafers on one film' 'upper_wafer' "$wafer" "${wafer/ w / v }" "$film upper_wafer v" 'run 1'
of 'a wafer and a height' 'is given twice' "$wafer" "$film upper 1" 'run 1'
of 'viscosity' 'viscosity' "$wafer" "${film/viscosity 1/viscosity -1}" 'run 1'
of 'no mass' 'mass' "${wafer/settled/dynamic mass 0 inertia_1 1 inertia_2 1}" "$film" 'run 1'

# NAME LINES...: f_w[1] is that of the usual script
as_usual() {
	local name=$1
	shift
	printf '%s\n' 'include in.scene' "$@" 'variable z equal $(f_w[1])' 'print "z ${z}"' >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && grep '^z ' out >z && [ -s z ] && { [ -e usual ] || cp z usual; } && cmp z usual >>out
	report "$name" $? out
	"$TSIM" -check -in in.script >out 2>&1
	report "$name: -check" $? out
}
thermo='thermo_style custom step f_w[1]'
as_usual 'usual' "$wafer" "$film" "$thermo" 'run 1'
as_usual 'two runs' "$wafer" "$film" "$thermo" 'run 0' 'run 1'
as_usual 'another wafer without film' "$wafer" 'fix v all wafer pad settled stiffness 1e3 pressure 300' "$film" "$thermo" 'run 1'
as_usual 'the film anew' "$wafer" "$film" "$thermo" 'run 1' 'flow_style none' "$film" 'run 1'
as_usual 'springs before' "$wafer" "$thermo" 'run 1' "$film" 'unfix w' "$wafer" 'run 1'
as_usual 'a joint below the face' "$wafer arm -0.0" "$film" "$thermo" 'run 1'

# a pad that slides alone
sed 's/boundary f/boundary p/; s/type 1 cells 4 4/& move linear 2 0 0/' in.scene >in.slides
printf '%s\n' 'include in.slides' "$wafer" "$film open xlo xhi" 'run 0' >in.script
"$TSIM" -in in.script -log none >out 2>&1 && grep -q 'the pad pad slides with 2 0, the lower surface of the film with 6 0; expected the same' out
report 'a warning of two speeds' $? out
printf '%s\n' 'include in.scene' "${wafer/settled/dynamic mass 1 inertia_1 1 inertia_2 1}" "$film" 'run 1' >in.script
"$TSIM" -explain -in in.script >out 2>&1 && grep -q 'fix w floats on the film, moved by an implicit method of second order' out
report 'explain' $? out
printf '%s\n' 'include in.scene' "${wafer/joint_1 0.07/start 0.1}" "${film/velocity 6/velocity 0}" 'run 1' >in.script
! "$TSIM" -in in.script -log none >out 2>&1 && grep -q 'no place above the film where forces balance' out
report 'nothing slides, nothing carries' $? out
# a pad that has moved farther than numbers resolve
printf '%s\n' 'units si' 'boundary p p f' 'region box block 0 5e-5 0 5e-5 0 6e-5 units box' 'create_box 1 box' 'timestep 1e-6' \
	'fix pad all surface/voxel gaussian mean 5e-6 deviation 4e-6 correlation 2e-6 seed 5 type 1 cells 31 31 datum 1e-9 move linear 1e30 0 0' \
	'fix w all wafer pad settled stiffness 4e12 pressure 1e5' 'run 50' 'print "height $(f_w)"' >in.far
"$TSIM" -in in.far -log none >out 2>&1 && grep -q '^height [0-9]' out
report 'a pad that has moved far' $? out
finish
