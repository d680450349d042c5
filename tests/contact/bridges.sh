#!/bin/bash
# Bridges of liquid, cohesion easo/capillary/viscous and washino/capillary/viscous, against exact numbers: pull, drag, where they
# are made and break, where their liquid goes; what is refused. The numbers of LIGGGHTS: tests/crosscheck/bridges.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"

easo=easo/capillary/viscous
washino=washino/capillary/viscous
law="pair_style gran model hertz tangential history cohesion $easo"
mu=0.3
first=0.01
liquid() { # the properties
	echo "fix l1 all property/global surfaceLiquidContentInitial scalar $first
fix l2 all property/global surfaceTension scalar 0.07
fix l3 all property/global fluidViscosity scalar $mu
fix l4 all property/global contactAngle peratomtype 20 50
fix l5 all property/global minSeparationDistanceRatio scalar 0.05
fix l6 all property/global maxSeparationDistanceRatio scalar 1.3"
}
# two spheres with the gap d; the second one moves
scene() { # D
	echo "units si
atom_style granular
newton off
communicate single vel yes
boundary f f f
region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single \$(1.1e-3+$1) 0 0 units box
set atom 1 diameter 1e-3 density 2500
set atom 2 diameter 1.2e-3 density 2000
neighbor 0.0005 bin
fix p1 all property/global youngsModulus peratomtype 5e6 7e6
fix p2 all property/global poissonsRatio peratomtype 0.3 0.2
fix p3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix p4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
$(liquid)
$law
pair_coeff * *
group two id 2
timestep 1e-6
thermo 10000
variable l atom f_surfaceLiquidContent
variable flux atom f_liquidFlux"
}
# exact numbers: caps, bridge of easo, its pull at the gap v_d; bridge of washino, its pull; drag
exact='variable a equal 5e-4
variable b equal 6e-4
variable th equal 35*PI/180
variable r equal v_a*v_b/(v_a+v_b)
variable d equal x[2]-x[1]-1.1e-3
variable Va equal 4/3*PI*v_a^3*0.01
variable Vb equal 4/3*PI*v_b^3*0.01
variable capa equal 0.5*(1-sqrt(1-(6/11)^2))
variable capb equal 0.5*(1-sqrt(1-(5/11)^2))
variable V equal v_Va*v_capa+v_Vb*v_capb
variable v equal v_V/v_b^3
variable A equal -1.1*v_v^(-0.53)
variable B equal (-0.148*ln(v_v)-0.96)*v_th^2-0.0082*ln(v_v)+0.48
variable C equal 0.0018*ln(v_v)+0.078
variable pull equal PI*0.07*sqrt(v_a*v_b)*(exp(v_A*v_d/v_b+v_B)+v_C)
variable W equal 0.05*(v_Va+v_Vb)
variable p equal sqrt(1+2*v_W/(PI*v_r*v_d^2))-1
variable al equal sqrt(v_d*v_p/v_r)
variable wpull equal 2*PI*v_r*0.07*(cos(v_th)*v_p/(1+v_p)+sin(v_al)*sin(v_al+v_th))
variable ndrag equal 6*PI*0.3*v_r*v_r/v_d
variable tdrag equal 6*PI*0.3*v_r*(8/15*ln(v_r/v_d)+0.9588)
variable water equal 4/3*PI*(v_a^3*v_l[1]+v_b^3*v_l[2])'

agree 'easo: pull and drag' "$(scene -1e-9)
fix side two move linear 0.05 0.02 0
run 0
unfix side
fix away two move linear 0.05 0 0
run 400
$exact
print \"is gap \$(v_d/(400*5e-8-1e-9)) 1\"
print \"is force \$(fx[1]/(v_pull+0.05*v_ndrag)) 1\"
unfix away
set atom 2 vx 0 vy 0.02 omegaz 0
run 0
print \"is pull \$(fx[1]/v_pull) 1\"
print \"is across \$(fy[1]/(0.02*v_tdrag)) 1\"
print \"is torque \$(tqz[1]/(v_a*fy[1])) 1\"
print \"is torque \$(tqz[2]/(v_b*fy[1])) 1\"
set atom 2 vy 0 omegaz 10
run 0
print \"is turning \$(fy[1]/(-0.006*v_tdrag)) 1\""
agree 'easo: the pull of surfaces that touch is that at the touch, also where nothing rolls or slips' "$(scene -2e-6)
$law
pair_coeff * *
run 0
variable wet equal \$(fx[1])
variable near equal 0
pair_style gran model hertz tangential history
pair_coeff * *
run 0
$exact
variable d equal 0
print \"is pull \$((v_wet-fx[1])/v_pull) 1\"
pair_style gran model hertz cohesion $easo
pair_coeff * *
set atom 2 vy 0.02
run 0
print \"is pull \$((fx[1]-v_wet)) 0\"
print \"is across \$(fy[1]/(0.02*6*PI*0.3*v_r*(8/15*ln(20)+0.9588))) 1\""
agree 'easo: no bridge before they touch' "$(scene 1e-9)
run 10
print \"is pull \$(fx[1]) 0\""

# where it breaks, what both have then; steps of 1e-9 m
breaks() { # WHERE: the gap by the exact formula
	echo "$exact
variable was equal \$(v_water)
variable gap equal $1
fix go two nve/noforce
set atom 2 x \$(1.1e-3-3e-9) vx 0.001
run 1
set atom 2 x \$(1.1e-3+v_gap-5.5e-9)
run 5
print \"is holds \$(fx[1]>0) 1\"
print \"is contents \$(v_l[1]) 0.01\"
run 1
print \"is broken \$(fx[1]) 0\"
print \"is flux \$(1e-6*v_flux[1]) \$(v_V/(4/3*PI*(v_a^3+v_b^3))-0.01*v_capa)\"
run 1
print \"is flux \$(v_flux[1]) 0\"
print \"is first \$(v_l[1]) \$(0.01+v_V/(4/3*PI*(v_a^3+v_b^3))-0.01*v_capa)\"
print \"is second \$(v_l[2]) \$(0.01+v_V/(4/3*PI*(v_a^3+v_b^3))-0.01*v_capb)\"
print \"is water \$(v_water/v_was) 1\""
}
agree 'easo: breaks at (1 + theta/2) V^(1/3)' "$(scene -1e-9)
$(breaks '(1+v_th/2)*v_V^(1/3)')"
agree 'easo: breaks at the largest distance' "$(scene -1e-9)
fix l6 all property/global maxSeparationDistanceRatio scalar 1.05
$(breaks '0.05*1.1e-3')"
agree 'legacy: half the product of the angles' "legacy yes
$(scene -1e-9)
$(breaks '(1+v_th/2)*v_V^(1/3)' | sed 's#^variable th .*#variable th equal 0.5*20*50*(PI/180)^2#')"
law="pair_style gran model hertz tangential history cohesion $washino"
agree 'washino: made and broken by the gap, pull' "$(scene 3e-5)
$exact
run 0
print \"is pull \$(fx[1]/v_wpull) 1\"
set atom 2 x \$(1.1e-3+(1+v_th/2)*v_W^(1/3)*1.0001)
run 0
print \"is none \$(fx[1]) 0\"
set atom 2 x \$(1.1e-3+(1+v_th/2)*v_W^(1/3)*0.9999)
run 0
print \"is pull \$(fx[1]/v_wpull) 1\"
variable wet equal 0
set atom 2 x \$(1.1e-3-2e-6)
run 0
variable wet equal \$(fx[1])
pair_style gran model hertz
pair_coeff * *
run 0
print \"is touching \$((v_wet-fx[1])/(2*PI*v_r*0.07*cos(v_th)*(1+2e-6/sqrt(2*v_W/(PI*v_r))))) 1\""
agree 'washino: the share of the liquid' "$(scene 3e-5)
fix share all property/global lbVolumeFraction scalar 0.02
$law modifyLbVolume on
pair_coeff * *
$exact
variable W equal 0.02*(v_Va+v_Vb)
run 0
print \"is pull \$(fx[1]/v_wpull) 1\""
law="pair_style gran model hertz tangential history cohesion $easo"

# a plane; a grain alone
wall="fix floor all wall/gran model hertz tangential history cohesion $easo primitive type 1 xplane"
agree 'easo: at a plane' "$(scene 0.005)
$wall -5e-4
set atom 1 x -1e-9
variable V equal 0.5*4/3*PI*5e-4^3*0.01
variable v equal v_V/5e-4^3
variable th equal 20*PI/180
variable pull equal PI*0.07*5e-4*(exp(-1.1*v_v^(-0.53)*x[1]/5e-4+(-0.148*ln(v_v)-0.96)*v_th^2-0.0082*ln(v_v)+0.48)+0.0018*ln(v_v)+0.078)
run 1
set atom 1 x 2e-5 vx 0.001
run 0
print \"is drag \$((-fx[1]-v_pull)/(6*PI*0.3*2.5e-4^2/2e-5*0.001)) 1\"
set atom 1 vx 0
run 0
print \"is pull \$(-fx[1]/v_pull) 1\"
set atom 1 x \$((1+v_th/2)*v_V^(1/3)*0.999)
run 0
print \"is holds \$(fx[1]<0) 1\"
set atom 1 x \$((1+v_th/2)*v_V^(1/3)*1.001)
run 1
print \"is broken \$(fx[1]) 0\"
print \"is water \$(v_l[1]) 0.01\""

# across a periodic face, there and back; the liquid arrives, and is set and comes
agree 'across a periodic face' "$(scene 0 | sed 's/boundary f f f/boundary p f f/; s/^create_atoms 1.*/create_atoms 1 single -0.0097 0 0 units box/
s/^create_atoms 2.*/create_atoms 2 single 0.0092000001 0 0 units box/; s/^group two.*/&\nset atom 2 property\/atom surfaceLiquidContent 0.03/')
$exact
fix away two move linear -0.1 0 0
variable was equal \$(v_water)
run 1000
run 1000
print \"is broken \$(fx[1]) 0\"
print \"is changed \$(abs(v_l[1]-0.01)>1e-5) 1\"
print \"is water \$(v_water/v_was) 1\""
agree 'liquid is set and comes; properties may stand behind the pair style' "$(scene 1e-3 | grep -v '^fix l')
dump d all custom 1 dump.wet id f_surfaceLiquidContent f_liquidFlux
$(liquid)
set atom 1 property/atom surfaceLiquidContent 0.02
set atom 2 property/atom liquidSource 100
run 50
create_atoms 1 single 0.005 0.005 0 units box
print \"is set \$(v_l[1]) 0.02\"
print \"is came \$(v_l[2]) 0.015\"
print \"is new \$(v_l[3]) 0.01\""
first=0
agree 'dry: nothing' "$(scene -1e-9)
set atom 2 x 1.1000001e-3
set atom 2 vx 0.1 vy 0.1
run 2
print \"is none \$(fx[1]) 0\"
print \"is none \$(fy[1]) 0\""
first=0.01

# many bridges: the same on any number of threads, and the liquid stays
for n in 1 2 4; do
	rm -f wet*.txt
	"$TSIM" -in "$top_srcdir/tests/decks/in.bridges" -log none -threads $n >out 2>&1
	report "bed on $n threads" $? out
	{ rows out; cat wet*.txt; } >bed.$n
	same "bed: 1 and $n threads" bed.1 bed.$n
done
awk 'NR > 9 && $2 != 0.01 { n++ } END { exit n < 20 }' wet300.txt
report 'bed: bridges break' $?
rows out | awk 'NR == 1 { was = $4 } NR < 8 { d = $4/was - 1; if (!(d*d < 1e-26)) { print; bad = 1 } } END { exit bad || NR < 12 }' >kept
report 'bed: the liquid stays' $? kept

# Meshes, and height fields: bridges beyond the touch, from triangle to triangle, as at a plane; a run cut while there are some.
plate 7 0 >plate.stl
sed 's/boundary.*/boundary f f f/; s/box block.*/box block -0.02 0.032 -0.02 0.032 -0.001 0.03 units box/
	s/^dump.*/dump wet all custom 100 wet*.txt id x y z f_surfaceLiquidContent fx fy fz tqx\ndump_modify wet sort id format float %.10g/' \
	"$top_srcdir/tests/decks/in.bridges" >in.plane
sed 's/primitive type 1 zplane 0.0/mesh n_meshes 1 meshes plate/
	s/^fix.*floor.*/fix plate all mesh\/surface file plate.stl type 1 scale 0.05 move 0.006 0.006 0\n&/' in.plane >in.mesh
sed 's/primitive type 1 zplane 0.0/voxels heights/
	s/^fix.*floor.*/fix heights all surface\/voxel constant 0 type 1 cells 11 13\n&/' in.plane >in.field
for floor in plane mesh field; do
	rm -f wet*.txt
	"$TSIM" -in in.$floor -log none >out 2>&1
	report "bed on a $floor" $? out
	cat wet?00.txt >bed.$floor
done
same 'bed on a mesh' bed.plane bed.mesh
same 'bed on a height field' bed.plane bed.field
sed 's/^run.*//' in.mesh >in.both
{ cat in.both; printf '%s\n' 'run 130' 'write_restart half.restart' 'run 170'; } >in.whole
{ echo 'read_restart half.restart'; sed '/^units\|^atom_style\|^boundary\|^newton\|^region.*box\|^create\|^lattice\|^set\|^displace\|^velocity/d' in.both; echo 'run 170'; } >in.again
resumes 'bed on a mesh' rows 4
# Over the corner of a step of two triangles: a wet grain is drawn by both faces, each as by a plane.
printf '%s\n' '-1 -1 0 1 -1 0 0 1 0' '0 -1 0 0 1 0 0 0 1' | solid >corner.stl
corner() { # WALLS
	sed '/^fix.*floor/d; /^create_atoms/d; /^run/d; /^displace/d; /^velocity/d; /^set.*region/d; /^fix.*g all/d; /^dump/d' in.plane
	printf '%s\n' 'create_atoms 1 single 0.00095 0.0001 0.00095 units box' 'set group all diameter 1.9e-3 density 2500' "$@" \
		'set atom 1 x 0.000949 z 0.000949' 'run 1' 'set atom 1 x 0.00097 z 0.00096 vx 0 vy 0 vz 0' 'run 0' \
		'print "corner $(fx[1]:%.10g) $(fy[1]:%.5g) $(fz[1]:%.10g)"'
}
corner 'fix w all wall/gran model hertz tangential history cohesion easo/capillary/viscous primitive type 1 zplane 0' \
	'fix v all wall/gran model hertz tangential history cohesion easo/capillary/viscous primitive type 1 xplane 0' >in.script
"$TSIM" -in in.script -log none 2>&1 | grep '^corner [-0-9]' >planes
corner 'fix corner all mesh/surface file corner.stl type 1 scale 0.01' \
	'fix w all wall/gran model hertz tangential history cohesion easo/capillary/viscous mesh n_meshes 1 meshes corner' >in.script
"$TSIM" -in in.script -log none 2>&1 | grep '^corner [-0-9]' >meshes
same 'a corner' planes meshes
awk '$2 < -1e-5 && $4 < -1e-5 { n++ } END { exit n != 1 }' meshes
report 'both faces draw' $? meshes

# what is refused
one() { # LINES...
	scene 1e-5
	printf '%s\n' "$@"
	echo 'run 0'
}
plate 1 0 >plate.stl
rejects "$(one 'fix l6 all property/global maxSeparationDistanceRatio scalar 0.9')" \
	'property/global maxSeparationDistanceRatio is 0.9, expected a number >= 1'
rejects "$(one 'fix l5 all property/global minSeparationDistanceRatio scalar 7')" 'expected a number > 0 and <= 6'
rejects "$(one 'fix l4 all property/global contactAngle peratomtype 20 181')" 'contactAngle is 181'
rejects "$(one 'fix l1 all property/global surfaceLiquidContentInitial scalar -0.01')" 'expected a number >= 0'
rejects "$(one 'unfix l2')" 'surfaceTension'
rejects "$(one 'unfix l1')" 'surfaceLiquidContentInitial'
rejects "$(one "${wall/$easo/$washino} -5e-4")" 'washino/capillary/viscous is for particles alone'
rejects "$(one 'pair_style gran model hertz' 'pair_coeff * *' "$wall -5e-4")" 'particles are dry'
for before in 'run 0' ''; do # a dry mesh beside wet particles: the law of the particles is known after a run
	prints "$(one 'fix plate all mesh/surface file plate.stl type 1 scale 0.005 move 0 0 -0.002' "$before" \
		'fix plates all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate')
print 'dry plate'" 'dry plate'
done
rejects "$(one 'thermo_style custom step pe')" 'liquid bridges have no potential energy'
rejects "$(one 'fix books all energy/ledger')" 'liquid bridges (cohesion) have no potential energy'
rejects "$(one "pair_style gran model hertz tangential history cohesion $easo located yes" 'pair_coeff * *')" \
	"'located' belongs to"
rejects "$(one "pair_style gran model jkr cohesion $easo" 'pair_coeff * *')" 'model jkr has its own adhesion'
rejects "$(one "pair_style gran model hertz cohesion $easo modifyLbVolume on" 'pair_coeff * *')" \
	"'modifyLbVolume' belongs to cohesion washino/capillary/viscous"
rejects "$(one "pair_style gran model hertz cohesion $washino limitLiquidContent on" 'pair_coeff * *')" \
	'limitLiquidContent on is not supported'
finish
