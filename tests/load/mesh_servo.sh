#!/bin/bash
# Servo and planar meshes: what is refused, and that the servo meets its target.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 2 0 >plate.stl
cuboid 0.2 0.15 0.1 >cube.stl
start='units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.6 0.6 -0.6 0.6 -0.5 0.5 units box
create_box 1 box
neighbor 0.01 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
'
lid='fix lid all mesh/surface/stress/servo file plate.stl type 1 com 0 0 0 ctrlPV force axis 0 0 1'

# a lid is pressed against a particle that is held until the force is 23.85
agree 'the target is met' "$start
$lid target_val 23.85 vel_max 0.1 kp 0.1 ki 2000
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes lid
create_atoms 1 single 0.1 0.1 0.0501 units box
set group all diameter 0.1 density 2385
fix hold all freeze
run 20000
print 'is force \$(-f_lid[3]) 23.85'"

# the force by a variable: it is met before and after it changes
held="$start
variable load equal 23.85-6*(step>20000)
$lid target_val v_load vel_max 0.1 kp 0.1 ki 2000
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes lid
create_atoms 1 single 0.1 0.1 0.0501 units box
set group all diameter 0.1 density 2385
fix hold all freeze"
prints "$held
run 20000
print 'force \$(-f_lid[3]:%.6f)'
run 20000
print 'then \$(-f_lid[3]:%.6f)'" 'force 23.850000' 'then 17.850000'
rejects "$held
fix_modify lid servo/target_val v_nothing
run 1" 'nothing'
rejects "${held/23.85-6*(step>20000)/5-step}
run 10" 'target_val must not be 0'

rejects "$start $lid target_val 0 vel_max 0.1
run 0" 'target_val must not be 0'
rejects "$start $lid target_val 1 vel_max 600
run 0" 'must be below skin/(2 dt) = 500'
rejects "$start $lid target_val 1 vel_max 1 mode auto
run 0" 'needs `ratio`'
rejects "$start fix lid all mesh/surface/stress/servo file plate.stl type 1 com 0 0 0 ctrlPV force axis 0 0 0 \
	target_val 1 vel_max 1" 'the axis has no length'
rejects "$start $lid target_val 1 vel_max 1
fix move all move/mesh mesh lid linear 1 0 0
run 0" 'a servo moves by itself'
rejects "$start $lid target_val 1 vel_max 1
fix_modify lid servo/integrate halt" 'expected one of start, stop'
rejects "$start $lid target_val 1 vel_max 1
fix_modify lid servo/ctrlParam 1 2" 'kd'
rejects "$start fix cad all mesh/surface/planar file cube.stl type 1" 'mesh cad is not planar: it bends at the edge'
prints "$start fix cad all mesh/surface/planar file plate.stl type 1
print fine" fine
finish
