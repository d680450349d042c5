#!/bin/bash
# Particles, walls and meshes that move more than a radius in a step: refused where something is on their way, and only
# there.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl

# A grain of the radius 0.01 that goes 0.05 along x in each step, from x = 0.1; the box is as long as that 20 times.
fast() {
	cat <<END
units si
boundary ${faces-p p p}
variable l equal ${scale-1}
region box block 0 \$(v_l) 0 \$(v_l) 0 \$(v_l) units box
create_box 2 box
create_atoms 1 single \$(0.1*v_l) \$(0.5*v_l) \$(0.5*v_l) units box
set type 1 diameter \$(0.02*v_l) density 1000
pair_style spring/dashpot
pair_coeff * * stiffness \$(10*v_l^3) damping 0
fix move all nve
velocity all set \$(50*v_l) 0 0
timestep 1e-3
END
}
# other Y [DIAMETER]: a particle in its way, beside the line
other() {
	printf '%s\n' "create_atoms 2 single \$(0.725*v_l) \$($1*v_l) \$(0.5*v_l) units box" \
		"set type 2 diameter \$(${2-0.02}*v_l) density 1000"
}
all_steps='run 100
print "went on at $(x[1]/v_l:%.6f) with $(vx[1]/v_l)"'
goes() {
	prints "$1
$all_steps" 'went on at 0.100000 with 50'
}
stops() {
	rejects "$1
$all_steps" 'particle 1 (type 1) moves more than its radius in one step at step 13 past '"$2"
}

for scale in 1 1e-6; do
	goes "$(fast)"
	goes "$(fast)
$(other 0.5201)"
	goes "$(fast)
$(other 0.4799)"
	stops "$(fast)
$(other 0.5199)" 'particle 2:'
	stops "$(fast)
$(other 0.4801)" 'particle 2:'
	# one that stands there, and a large one
	stops "$(fast)
$(other 0.5)
group other id 2
fix hold other freeze" 'particle 2:'
	stops "$(fast)
$(other 0.545 0.08)" 'particle 2:'
	# pairs that do not touch
	goes "$(fast)
$(other 0.5)
neigh_modify exclude type 1 2"
	# two that go together, and one that is overtaken
	prints "$(fast)
create_atoms 1 single \$(0.125*v_l) \$(0.5*v_l) \$(0.5*v_l) units box
set type 1 diameter \$(0.02*v_l) density 1000
velocity all set \$(50*v_l) 0 0
run 1000
print 'together \$(vx[1]/v_l) \$(vx[2]/v_l)'" 'together 50 50'
	rejects "$(fast)
$(other 0.5)
set atom 2 vx \$(25*v_l)
run 1000" 'moves more than its radius in one step at step 25 past particle 2'
done
# the same among many that are as fast, near the particle and across periodic faces, and a few large ones
crowd() {
	cat <<END
lattice sc \$(0.03*v_l)
region crowd block \$(0.05*v_l) \$(0.16*v_l) 0 \$(v_l) 0 \$(0.3*v_l) units box
create_atoms 1 region crowd
create_atoms 1 single \$(0.3*v_l) \$(0.2*v_l) \$(0.8*v_l) units box
group before id ${1-2}
group crowd subtract all before
set group crowd diameter \$(0.02*v_l) density 1000
set atom \$(atoms) diameter \$(0.06*v_l) density 1000
velocity crowd set \$(50*v_l) 0 0
END
}
for scale in 1 1e-6; do
	goes "$(fast)
$(other 0.5201)
$(crowd 1:2)"
	stops "$(fast)
$(other 0.5199)
$(crowd 1:2)" 'particle 2:'
	stops "$(fast)
$(other 0.545 0.08)
$(crowd 1:2)" 'particle 2:'
	# in the way of a member of the crowd: the 11 th row across the face y = 0
	rejects "$(fast)
create_atoms 2 single \$(0.725*v_l) \$(0.995*v_l) \$(0.09*v_l) units box
set type 2 diameter \$(0.02*v_l) density 1000
$(crowd 1:2)
$all_steps" 'moves more than its radius in one step at step 12 past particle 2:'
	# the large one, across the face x
	rejects "$(fast)
create_atoms 2 single \$(0.07*v_l) \$(0.235*v_l) \$(0.8*v_l) units box
set type 2 diameter \$(0.02*v_l) density 1000
$(crowd 1:2)
$all_steps" 'moves more than its radius in one step at step 16 past particle 2:'
done
unset scale
# across the periodic faces
stops "$(fast | sed 's/0\.1\*v_l) \\*\$(0\.5/0.4*v_l) $(0.5/')
create_atoms 2 single 0.025 0.5 0.5 units box
set type 2 diameter 0.02 density 1000" 'particle 2:'
# so far in a step that images cannot be told apart
rejects "$(fast)
velocity all set 260 0 0
run 1" 'moves more than its radius in one step at step 1:'

# walls: in the way, and as near to it as a hundredth of a radius
law='hooke 10 10 0 0 0 0'
beside() {
	goes "$(fast)
$1"
}
stops "$(fast)
fix w all wall/gran $law primitive zcylinder 0.005 0.725 0.5" 'wall w'
stops "$(fast)
fix w all wall/gran $law primitive zcylinder 0.005 0.725 0.5149" 'wall w'
beside "fix w all wall/gran $law primitive zcylinder 0.005 0.725 0.5153"
beside "fix w all wall/gran $law primitive xcylinder 0.1 0.6103 0.5"
beside "group nobody type 2
fix w nobody wall/gran $law primitive zcylinder 0.005 0.725 0.5"
stops "$(fast)
region s sphere 0.725 0.5 0.5 0.005 side out units box
fix w all wall/gran/region $law region s" 'wall w'
beside "region s sphere 0.725 0.5153 0.5 0.005 side out units box
fix w all wall/gran/region $law region s"
stops "$(fast)
fix gate all mesh/surface file plate.stl type 1 scale 0.2 rotate axis 0 1 0 angle 90 move 0.725 0.5 0.5
fix w all wall/gran $law mesh n_meshes 1 meshes gate" 'mesh gate'
beside "fix gate all mesh/surface file plate.stl type 1 scale 0.2 rotate axis 0 1 0 angle 90 move 0.725 0.6103 0.5
fix w all wall/gran $law mesh n_meshes 1 meshes gate"
# a particle that leaves the box: lost, where that is meant
faces='f f f'
prints "$(fast)
thermo_modify lost ignore
run 30
print 'left \$(count(all))'" 'left 0'
rejects "$(fast)
run 30" 'moves more than its radius in one step at step 18 out of the box'
unset faces

# surfaces: a region that jumps, turns or grows by more than a radius in a step, onto a particle that rests
rests=$(fast | sed 's/^velocity.*/velocity all set 0 0 0/; s/0\.1\*v_l/0.5*v_l/')
jumps() {
	printf '%s\n' "$rests" "$1" "fix w all wall/gran/region $law region s" 'run 14' "print 'went on'"
}
passes='the surface of wall w moves by 0.'
to='variable to equal 0.03*step+0.001'
rejects "$(jumps "$to
region s block 0.05 0.1 0.3 0.7 0.3 0.7 side out units box move v_to NULL NULL")" "${passes}03 in step 12, more than the radius 0.01 of particle 1"
rejects "$(jumps "variable turn equal -0.1*step
region s block 0.1 0.2 0.55 0.75 0.3 0.7 side out units box rotate v_turn 0.15 0.15 0.5 0 0 1")" 'the surface of wall w moves by '
rejects "$(jumps "variable size equal 0.02*step+0.01
region s sphere 0.3 0.5 0.5 v_size side out units box")" "${passes}02 in step "
prints "$(jumps "variable to equal 0.009*step
region s block 0.05 0.1 0.3 0.7 0.3 0.7 side out units box move v_to NULL NULL")" 'went on'
prints "$(jumps "$to
region s block 0.05 0.1 0.6 0.7 0.3 0.7 side out units box move v_to NULL NULL")" 'went on'

# the image of a mesh across a periodic face
rejects "$(fast | sed 's/^velocity.*/velocity all set 0 0 0/; s/0\.1\*v_l/0.98*v_l/')
fix gate all mesh/surface file plate.stl type 1 scale 0.2 rotate axis 0 1 0 angle 90 move 0.05 0.5 0.5
fix push all move/mesh mesh gate linear -50 0 0
fix w all wall/gran $law mesh n_meshes 1 meshes gate
run 2" 'of mesh gate moves by 0.05 in step'
finish
