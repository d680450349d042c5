#!/bin/bash
# Active particles and the wafer from scripts: the examples, numbers by hand, what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99

cd polishing || exit 99
results 'the example' in.active 5
[ "$(wc -l <post/spread.txt)" = 9 ] && [ "$(wc -l <post/modulus.txt)" = 20 ]
report 'its tables' $? post/modulus.txt
results 'the wafer' in.wafer 2 -var pads 4
# a single pad has no standard error
results 'the example with one pad' in.active 5 -var pads 1
results 'the wafer on one pad' in.wafer 2 -var pads 1
cd ..

# A quarter of the columns is 1 high, the others 0; the plane is pressed 0.1 deep into springs of stiffness 8: p = 0.2
cat >in.blocks <<'END'
units si
boundary p p f
region box block 0 4 0 2 -1 2 units box
create_box 1 box
variable cx internal 0
variable h equal v_cx<1
fix pad all surface/voxel formula v_h x cx type 1 cells 8 4
compute press all surface/contact pad winkler 8 pressure 0.2 hardness 4
timestep 1e-6
END
# near NAME FORMULA VALUE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= 1e-11*abs($3)\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.15g), expected \$($3:%.15g)'\""
}
prints "include in.blocks
compute pml all active/pml press radius 0.01 fraction 0.1
compute pi all active/pi press radius 0.01 deviation 0.004 fraction 0.1 hardness 8
variable n equal 0.1/(4/3*PI*0.01^3)
run 0
$(near 'pml all' 'c_pml[1]' 'v_n*6*0.9')
$(near 'pml eligible' 'c_pml[2]' 'v_n^(2/3)*8')
$(near 'pml active' 'c_pml' 'v_n^(2/3)*2')
$(near 'pi all' 'c_pi[1]' 'v_n*6*0.9')
$(near 'pi eligible' 'c_pi[2]' 'v_n*2*0.75*0.9')
$(near 'pi active' 'c_pi[3]/c_pi[2]' '0.00819753592459')" \
	'pml all ok' 'pml eligible ok' 'pml active ok' 'pi all ok' 'pi eligible ok' 'pi active ok'

# no WHAT TEXT LINE: refused
no() {
	printf '%s\n' 'include in.blocks' "$3" 'run 0' >in.script
	refused "$1" "$2" -in in.script
}
# A wafer on a sliding flat pad, friction 0.5, the joint 0.02 above the face: closed form
cat >in.flat <<'END'
units si
boundary p p f
region box block 0 4 0 2 -1 2 units box
create_box 1 box
fix pad all surface/voxel constant 1 type 1 cells 8 4 move linear 0 0.001 0
timestep 1e-3
thermo 1000
END
prints "include in.flat
fix w all wafer pad settled stiffness 8 pressure 0.2 friction 0.5 arm 0.02
thermo_style custom step f_w[1] f_w[2] f_w[3]
run 0
variable slope equal 0.2*8*0.01/(8*8*2^2/12*(1-1/4^2))
$(near settled 'f_w[1]' '1-0.2/8')
$(near level 'f_w[2]+1' '1')
$(near tilted 'f_w[3]' 'v_slope')
$(near angle 'f_w' 'atan(v_slope)*180/PI')
$(near carried 'f_w[4]' '0.2*8')" 'settled ok' 'level ok' 'tilted ok' 'angle ok' 'carried ok'
# a free oscillation in height: omega^2 = k A/m; the back pressure is doubled at t = 0
prints "include in.flat
variable p equal 0.2*(1+(step>0))
fix d all wafer pad dynamic mass 2 inertia_1 100 inertia_2 100 stiffness 8 pressure v_p
thermo_style custom step f_d[1] f_d
run 1
variable half equal round(PI/sqrt(8*8/2)/dt)
run \${half}
variable low equal f_d[1]
if \"abs(\${low}-(1-0.2/8-2*0.2/8)) < 1e-6\" then \"print 'oscillates'\"" 'oscillates'

no 'no contact' "there is no compute surface/contact 'pres'; did you mean 'press'?" 'compute c all active/pml pres radius 1 fraction 0.1'
no 'another compute' 'expected a compute surface/contact' 'compute ke all ke
compute c all active/pml ke radius 1 fraction 0.1'
no 'more than can be packed' 'fraction' 'compute c all active/pml press radius 1 fraction 0.8'
no 'no radius' 'radius' 'compute c all active/pi press radius 0 deviation 0 fraction 0.1 hardness 1'
nof() {
	printf '%s\n' 'include in.flat' "$3" 'run 1' >in.script
	refused "$1" "$2" -in in.script
}
nof 'a load beyond the hardness' 'the pad can carry at most 0.8 of the load 1.6' 'fix w all wafer pad settled stiffness 8 hardness 0.1 pressure 0.2'
nof 'friction that topples' 'no equilibrium' 'fix w all wafer pad settled stiffness 8 pressure 0.2 friction 1 arm 1.01'
nof 'no pressure' 'the back pressure is 0, must be > 0' 'variable p equal 0
fix w all wafer pad settled stiffness 8 pressure v_p'
nof 'a pressure that pulls' 'pressure is -1, expected a number > 0' 'fix w all wafer pad settled stiffness 8 pressure -1'
refused 'by -check, too' 'pressure is -1, expected a number > 0' -check -in in.script
nof 'an unstable step' 'time step' 'fix w all wafer pad dynamic mass 1e-6 inertia_1 1 inertia_2 1 stiffness 8 pressure 0.2'
# 4 m/c; the first root of 8 - 8 y + 4 y^2 = b y^2 (2 - y), y = c h/(2 m), b = 4 m k A/c^2 = 21.25: 0.4; 2/omega about the joint
shown() { awk "BEGIN { printf \"stability limit %g\", $1 }"; }
wafer='fix w all wafer pad dynamic inertia_1 1e3 inertia_2 1e3 stiffness 8 pressure 0.2'
nof 'much damping' "$(shown 4/1000)" "$wafer mass 1 damping 1e3
timestep 0.00401"
nof 'some damping' "$(shown 0.4)" "$wafer mass \$(64/21.25) damping \$(2*64/21.25)
timestep 0.401"
nof 'a joint beside the middle' "$(shown '2 / sqrt(32 + 64 / sqrt(28/3))')" "${wafer/inertia_1 1e3/inertia_1 \$(14\/3)} mass 2 joint_1 1
timestep 0.276"
nof 'a pad that leaves' 'it would leave the wafer' 'fix q all surface/voxel constant 1 type 1 cells 2 2 origin 1 0.5 size 1 1 move linear 0.1 0 0
fix w all wafer q settled stiffness 8 pressure 0.2'
# A pad that is deleted or defined anew between runs: what reads it says so, or reads the new one.
anew='include in.blocks
compute pml all active/pml press radius 0.1 fraction 0.04
run 0
print "was $(c_pml[1]:%.10g)"
unfix pad'
agree 'a new pad' "$anew
variable h equal 2*(v_cx<1)
fix pad all surface/voxel formula v_h x cx type 1 cells 8 4
compute other all active/pml press radius 0.1 fraction 0.04
print 'is new \$(c_pml[1]) \$(c_other[1])'
run 0
print 'is run \$(c_pml[1]) \$(c_other[1])'"
rejects "$anew
print \"\$(c_pml[1])\"" "there is no height field 'pad'"
for bad in 'compute press all surface/contact pad winkler 8 pressure v_p' 'region pad union 2 r r'; do # read twice with -check
	printf '%s\n' 'units si' 'boundary p p f' 'region box block 0 4 0 2 -1 2 units box' 'create_box 1 box' \
		'region r block 0 1 0 1 0 1 units box' 'variable p equal 0.2' 'fix pad all surface/voxel constant 0 type 1 cells 8 4' \
		"$bad" "variable v equal $([ "${bad%% *}" = region ] && echo 'count(all,pad)' || echo 'c_press[1]')" \
		'run 0' 'unfix pad' 'region r delete' 'run 0' 'print "$(v_v) $(v_v)"' 'print "$(v_v) $(v_v)"' >in.script
	"$TSIM" -check -in in.script >out 2>&1
	[ $? -le 1 ]
	report "-check of ${bad%% *}" $? out
done
finish
