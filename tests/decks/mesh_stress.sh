#!/bin/bash
# Force, torque and stresses on meshes: what must hold, whatever the law.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl
start='units si
atom_style granular
boundary p p f
newton off
communicate single vel yes
region box block -0.5 0.5 -0.5 0.5 -0.5 0.5 units box
create_box 2 box
fix m1 all property/global youngsModulus peratomtype 5.e6 6.3e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.4 0.4 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix g all gravity 9.81 vector 0 0 -1
fix cad all mesh/surface/stress file plate.stl type 2 reference_point 0.1 0.2 0.3'
heap='fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
create_atoms 1 single 0.131 0.1 0.0499 units box
create_atoms 2 single -0.131 0.07 0.0499 units box
create_atoms 2 single 0.49 0.31 0.0499 units box
set group all diameter 0.1 density 2385
fix move all nve/sphere
velocity all set 0.31 -0.2 0 units box
timestep 2e-5'

# the opposite of what the particles feel besides their weight, and its torque; z = 0 is the plate
agree 'what particles feel' "$start
$heap
variable x atom x-0.1
variable y atom y-0.2
variable fz atom fz+9.81*mass
variable tx atom -(v_y*v_fz+0.3*fy)
variable ty atom v_x*v_fz+0.3*fx
variable tz atom -(v_x*fy-v_y*fx)
compute sum all reduce sum fx fy v_fz v_tx v_ty v_tz
run 237
print 'is fx \$(f_cad[1]) \$(-c_sum[1])'
print 'is fy \$(f_cad[2]) \$(-c_sum[2])'
print 'is fz \$(f_cad[3]) \$(-c_sum[3])'
print 'is tx \$(f_cad[4]) \$(c_sum[4])'
print 'is ty \$(f_cad[5]) \$(c_sum[5])'
print 'is tz \$(f_cad[6]) \$(c_sum[6])'
print 'is x \$(f_cad[7]) 0.1'
print 'is z \$(f_cad[9]) 0.3'"

# nothing before the first step
agree 'before the first step' "$start
$heap
run 0
print 'is fz \$(f_cad[3]) 0'"

rejects "$start wear finnie
run 0" 'k_finnie'
rejects "$start wear archard" 'expected one of off, finnie'
finish
