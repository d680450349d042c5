#!/bin/bash
# A jet whose particles are inserted where they have flown: a wall on the way from the nozzle is found, of any shape, and
# only there.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

# A nozzle at z = 0.9 L; particles of the radius 0.01 L fly down by 0.001 L in each step. Every 3.2 steps one leaves.
scene() { # WALLS EVERY [LENGTH]
	awk -v l="${3-1}" 'BEGIN { printf "variable l equal %s\n", l }'
	cat <<END
units si
atom_style granular
boundary f f f
region box block \$(-v_l) \$(v_l) \$(-v_l) \$(v_l) \$(-v_l) \$(v_l) units box
create_box 1 box
group some type 1
group none id 100000
fix kn all property/global kn peratomtypepair 1 \$(v_l^3)
fix kt all property/global kt peratomtypepair 1 0
fix gn all property/global gamman peratomtypepair 1 0
fix gt all property/global gammat peratomtypepair 1 0
fix mu all property/global coefficientFriction peratomtypepair 1 0
fix one all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant \$(0.01*v_l) volume_limit 1e-30
fix mix all particledistribution/discrete 32452843 1 one 1.0
fix jet all insert/jet seed 86028121 distributiontemplate mix position 0 0 \$(0.9*v_l) direction 0 0 -1 diameter 0 &
	speed constant \$(v_l) nparticles INF particlerate 310 overlapcheck no insert_every $2
fix move all nve/sphere
timestep 1e-3
END
	echo "$1"
}
model='model hooke/stiffness'
stops() { # WALLS EVERY TEXT [LENGTH]
	rejects "$(scene "$1" "$2" "${4-1}")
run $2" "$3"
}
goes() { # WALLS EVERY STEPS NUMBER
	prints "$(scene "$1" "$2")
run $3
print \"number \$(f_jet[1]) of \$(count(all))\"" "number $4 of $4"
}
printf '%s\n' '-0.5 -0.5 0.85 0.5 -0.5 0.85 0.5 0.5 0.85' '-0.5 -0.5 0.85 0.5 0.5 0.85 -0.5 0.5 0.85' | solid >flat.stl
printf '%s\n' '-0.5 -0.5 -0.5 0.5 -0.5 -0.5 0.5 0.5 -0.5' '-0.5 -0.5 -0.5 0.5 0.5 -0.5 -0.5 0.5 -0.5' | solid >low.stl

# A wall across the jet, whose particles touch it 0.04 from the nozzle. They may be inserted until a step later.
plane="fix w all wall/gran $model primitive type 1 zplane 0.85"
tube="fix w all wall/gran $model primitive type 1 ycylinder 0.15 0.7 0"
mesh="fix cad all mesh/surface file flat.stl type 1
fix w all wall/gran $model mesh n_meshes 1 meshes cad"
field="fix s all surface/voxel constant 0.85 type 1 cells 5 7
fix w all wall/gran $model voxels s"
hull="region hull block -0.5 0.5 -0.5 0.5 0.85 0.95 units box
fix w all wall/gran/region $model region hull type 1"
for wall in "$plane" "$tube" "$mesh" "$field" "$hull"; do
	stops "$wall" 60 'met wall w on its way, at the distance 0.04 from the nozzle, before it was inserted beyond it in step 60; take insert_every 40 or less'
	goes "$wall" 39 39 12
done
stops "$plane" 43 'met wall w' # the first one left 1.6 steps after the start
goes "$plane" 42 42 13
for l in 1e-6 1e3; do
	stops "fix w all wall/gran $model primitive type 1 zplane \$(0.85*v_l)" 60 'take insert_every 40 or less' $l
done

# Walls that are not on the way
far() {
	goes "$1" 60 60 19
}
far "fix w all wall/gran $model primitive type 1 zplane 0.82"
far "fix w all wall/gran $model primitive type 1 zplane 0.9"
far "fix w all wall/gran $model primitive type 1 zplane 0.905"
far "fix w all wall/gran $model primitive type 1 xplane 0.009"
far "fix w none wall/gran $model primitive type 1 zplane 0.85"
far "fix cad none mesh/surface file flat.stl type 1
fix w all wall/gran $model mesh n_meshes 1 meshes cad"
far "${hull/0.85 0.95/0.82 0.95}"
far "${hull/0.85 0.95 units box/0.85 0.95 units box open 5}"
far "${hull/0.85 0.95/0.5 0.87}" # from outside no force acts

# Surfaces that move: the relative motion decides; a mesh that rotates is taken to be at rest
low="fix cad all mesh/surface file low.stl type 1
fix w all wall/gran $model mesh n_meshes 1 meshes cad"
far "$low"
stops "$low
fix lift all move/mesh mesh cad linear 0 0 23" 60 'met wall w on its way'
far "$low
fix turn all move/mesh mesh cad rotate origin 0 0 -0.5 axis 0 0 1 period 1"

# Two at once: that which is met is named
stops "fix other all wall/gran $model primitive type 1 zplane -0.85
$plane" 60 'met wall w on its way'

# `impact exact` cannot take a particle that touches already; forces of a step can
near='fix w all wall/gran model hooke/stiffness primitive type 1 zplane 0.8895'
goes "$near" 1 20 6
stops "$near impact exact" 4 'met wall w on its way, at the distance 0.0005 from the nozzle, before it was inserted beyond it in step 4; take a smaller time step'
finish
