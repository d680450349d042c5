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

# rows of triangles: the force on each is that on the mesh; in a dump they are the arrays of LIGGGHTS' words
agree 'rows of triangles' "$start
$heap
compute area all reduce sum f_cad[3] f_cad[4] f_cad[5]
run 237
dump words all mesh/vtk 1 words*.vtk stress wear stresscomponents cad
dump rows all mesh/vtk 1 rows*.vtk f_cad[*] cad
dump corners all mesh/vtk 1 corners*.vtk f_cad[1] output interpolate
run 0
print 'is fx \$(c_area[1]*1.0/32) \$(f_cad[1])'
print 'is fy \$(c_area[2]*1.0/32) \$(f_cad[2])'
print 'is fz \$(c_area[3]*1.0/32) \$(f_cad[3])'"
array() { awk -v name="$1" '$1 == name { for (n = $2 * $3; n > 0; n -= NF) { getline; print } }' "$2"; }
array normal_stress_average words237.vtk >one; array 'f_cad[1]' rows237.vtk >two; same 'normal stress' one two
array shear_stress_average words237.vtk >one; array 'f_cad[2]' rows237.vtk >two; same 'shear stress' one two
array stress words237.vtk | tr -s ' ' '\n' | awk 'NF && ++n % 3 == 0' >one
array 'f_cad[5]' rows237.vtk | tr -s ' ' '\n' | awk NF >two; same 'normal component' one two
array 'f_cad[1]' corners237.vtk | tr -s ' ' '\n' | awk 'NF && ++n % 3 == 1' >two
array normal_stress_average words237.vtk | tr -s ' ' '\n' | awk NF >one; same 'at the corners' one two
other="$start
fix roof all mesh/surface file plate.stl type 2 move 0 0 0.4"
rejects "$other
dump d all mesh/vtk 1 d*.vtk f_cad[1] roof
run 0" "'f_cad[1]' is about a mesh that this dump does not write"
rejects "$other
dump d all mesh/vtk 1 d*.vtk f_g[1]
run 0" 'expected rows of triangles'
rejects "$start
dump d all mesh/vtk 1 d*.vtk f_cad[7]
run 0" '7'

rejects "$start wear finnie
run 0" 'k_finnie'
rejects "${start/fix cad/fix k all property\/global k_finnie peratomtypepair 2 1 2 2 -3
fix cad} wear finnie
run 0" 'k_finnie is -3, expected a number >= 0'
rejects "$start wear archard" 'expected one of off, finnie'
finish
