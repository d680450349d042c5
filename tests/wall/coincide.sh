#!/bin/bash
# Centres at the same place or in the surface of a wall, and surfaces that pass through particles in one step: contacts
# have no direction there, and the run is refused instead of going on without a force.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl

# scene UNITS X Y Z: one grain there, with all lengths in metres or micrometres
scene() {
	cat <<END
units si
boundary ${faces-f f f}
variable l equal ${scale-1}
region b block 0 \$(v_l) 0 \$(v_l) 0 \$(v_l) units box
create_box 2 b
create_atoms 1 single \$($1*v_l) \$($2*v_l) \$($3*v_l) units box
set type 1 diameter \$(0.1*v_l) density 2385
pair_style spring/dashpot
pair_coeff * * stiffness \$(100*v_l^3) restitution 0.5
bond_style contact
bond_coeff 1 stiffness \$(10*v_l^3) ultimate \$(20*v_l^4)
fix m all nve
timestep 1e-6
END
}
# foreseen TEXT: what the run has refused -check refuses, with the same words
foreseen() {
	refused "-check: $(tail -n 3 in.script | head -n 1)" "$1" -check -in in.script
}
second='create_atoms 1 single $(0.5*v_l) $(0.5*v_l) $(0.1*v_l) units box
set type 1 diameter $(0.1*v_l) density 2385'
together='particles 1 and 2 are at the same place'
inside='the centre of particle 1 (type 1)'

for scale in 1 1e-6 1e6; do
	base=$(scene 0.5 0.5 0.1)

	# grains, where they are created or moved to, and one of 1e-14 of a radius apart
	rejects "$base
$second
run 0" "$together"
	foreseen "$together"
	rejects "$base
$second
set atom 2 x \$(0.6*v_l)
run 1
set atom 2 x \$(0.5*v_l)
run 1" "at step 1 $together"
	rejects "$base
$second
set atom 2 z \$(0.1*v_l*(1+1e-15))
run 1" "$together"
	rejects "$base
$second
create_atoms 1 single \$(0.5*v_l) \$(0.5*v_l) \$(0.1*v_l) units box
set type 1 diameter \$(0.1*v_l) density 2385
run 1" 'and so are others'
	# across a periodic face
	rejects "$(faces='p p p' scene 0 0.5 0.1)
$second
set atom 2 x \$(v_l)
run 1" "$together"

	# walls: plane, cylinder, region, triangle, an edge
	for wall in 'wall/gran primitive type 1 zplane $(0.1*v_l)' \
		'wall/gran primitive type 1 zcylinder $(0.03*v_l) $(0.53*v_l) $(0.5*v_l)' \
		'wall/gran/region type 1 region slot' 'wall/gran mesh n_meshes 1 meshes cad'; do
		rejects "$base
region slot block \$(0.4*v_l) \$(0.6*v_l) \$(0.4*v_l) \$(0.6*v_l) \$(0.1*v_l) \$(0.5*v_l) units box
fix cad all mesh/surface file plate.stl type 1 move 0.5 0.5 0.1 scale \$(v_l)
fix w all $wall
run 1" "$inside"
		foreseen "$inside"
	done
	rejects "$base
fix cad all mesh/surface file plate.stl type 1 move 0.5 0.5 0.1 scale \$(v_l)
fix w all wall/gran mesh n_meshes 1 meshes cad
set atom 1 x \$(0.55*v_l)
run 1" 'of mesh cad'
	foreseen 'of mesh cad'

	# bonds
	rejects "$base
$second
create_bonds many all all 1 0 \$(0.1*v_l)" "$together"
	rejects "$base
$second
create_bonds single/bond 1 2 1" "$together"
	rejects "$base
$second
set atom 2 x \$(0.6*v_l)
create_bonds single/bond 1 2 1
special_bonds lj 0 1 1
set atom 2 x \$(0.5*v_l)
run 1" "$together"

	# what may be: on the axis of a cylinder there is no force; a sphere of the same body, held ones, excluded ones
	# and those that do not meet are no contacts; apart by more than rounding there is a direction
	prints "$base
fix w all wall/gran primitive type 1 zcylinder \$(0.04*v_l) \$(0.5*v_l) \$(0.5*v_l)
run 1
print 'force \$(fx[1]) \$(fy[1]) \$(fz[1])'" 'force 0 0 0'
	prints "$base
$second
fix hold all freeze
run 1
print 'went on'" 'went on'
	prints "$base
$second
set atom 2 type 2
neigh_modify exclude type 1 2
run 1
print 'went on'" 'went on'
	prints "$base
$second
set atom 2 z \$(0.1*v_l*(1+1e-9))
run 1
print 'pushed \$(fz[2]>9*v_l^4)'" 'pushed 1'
	prints "$base
$second
delete_atoms overlap \$(0.01*v_l) all all
run 1
print 'went on \$(count(all))'" 'went on 1'
done
unset scale

# while it runs: a grain that comes to rest in a plane, which appears there; what was written stays
rejects "$(scene 0.5 0.5 0.1)
thermo 1
dump d all custom 1 kept id z
run 3
fix w all wall/gran primitive type 1 zplane 0.1
run 3" 'at step 3 the centre'
[ "$(grep -c ITEM:.ATOMS kept)" = 4 ]
report 'frames before are kept' $?
# prescribed motion may cross a plane exactly
prints "$(scene 0.5 0.5 0.1)
unfix m
fix m all move linear 0 0 -0.1
fix w all wall/gran primitive type 1 zplane 0.0
timestep 0.1
run 20
print 'went on'" 'went on'
"$TSIM" -check -in in.script >out 2>&1
report '-check takes what runs' $? out

# surfaces that pass through a particle in one step, of five radii and of 1.5; those that are slow or far away may
moves() {
	printf '%s\n' "$(scene 0.5 0.5 0.5)" 'fix cad all mesh/surface file plate.stl type 1 move 0.5 0.5 0.8' "$1" \
		'fix w all wall/gran mesh n_meshes 1 meshes cad' "timestep $2" 'run 1'
}
rejects "$(moves 'fix mv all move/mesh mesh cad linear 0 0 -250' 1e-3)" 'moves by 0.25 in step 1, more than the radius 0.05 of particle 1'
rejects "$(moves 'fix mv all move/mesh mesh cad linear 0 0 -250' 1e-3)" 'use `timestep 0.00018`'
rejects "$(moves 'set atom 1 y 0.03 z 0.74
fix mv all move/mesh mesh cad rotate origin 0.5 0.5 0.8 axis 1 0 0 period 0.05' 1e-3)" 'of mesh cad moves by 0.0628 in step 1'
for going in 'linear 0 0 -250 1.8e-4' 'linear 0 0 250 3e-4' 'linear 0 0 -70 1e-3'; do
	prints "$(moves "fix mv all move/mesh mesh cad ${going% *}" "${going##* }")
print 'went on'" 'went on'
done
rejects "$(scene 0.5 0.5 0.1)
fix w all wall/gran primitive type 1 zplane 0.0 wiggle z 0.1 0.01
timestep 2.5e-3
run 3" 'the wall w moves by 0.1 in step 1'

# why a particle has left: the wall that it was behind, or did not belong to
lost() {
	rejects "$(scene 0.5 0.5 0.01)
thermo_modify lost error
velocity all set 0 0 -1
timestep 1e-4
group others type 2
$1
run 300" "$2"
}
lost '' 'no wall stands at that face'
lost 'fix w others wall/gran primitive type 1 zplane 0.0' 'wall w at z = 0 acts on group others only'
lost 'fix w all wall/gran primitive type 1 zplane 0.02' 'its centre was beyond wall w at z = 0.02'
lost 'fix w all wall/gran primitive type 1 xplane 0.1' 'no wall stands at that face'
lost 'fix w all wall/gran primitive type 1 zcylinder 0.9 0.5 0.5' 'no plane wall stands at that face'
finish
