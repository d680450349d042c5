#!/bin/bash
# A rim made of the outer edges of a plane mesh: its triangles, a ball that it keeps in, a run cut by a restart
# file, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 2 0 >plate.stl
cuboid 0.2 0.15 0.1 >cube.stl
start='units si
atom_style granular
boundary f f f
region box block -1 1 -1 1 -1 1 units box
if "${from} == none" then "create_box 2 box" "create_atoms 1 single 0.1 0.05 -0.2 units box" &
	"set type 1 diameter 0.1 density 2385" "velocity all set 1.3 0.7 0 units box" else "read_restart ${from}"
fix m1 all property/global youngsModulus peratomtype 5.31e6 7.77e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
fix m4 all property/global coefficientFriction peratomtypepair 2 0 0 0 0
pair_style gran model hertz tangential history
pair_coeff * *
timestep 2e-5
neighbor 0.02 bin
neigh_modify delay 0
fix lid all mesh/surface file plate.stl type 2 extrude_planar 0.385'
start="variable from index none
$start"

# eight outer edges of 0.5: the side walls of a box 1 x 1 x 0.385
prints "$start
fix rim all mesh/surface fix lid type 2
dump rim all mesh/vtk 1 rim*.vtk area rim
run 0" '*Step'
[ "$(sed -n '/^area/,$p' rim0.vtk | grep -o '0\.09625' | wc -l)" = 16 ]
report 'areas' $? rim0.vtk
[ "$(sed -n 's/^POINTS \([0-9]*\) .*/\1/p' rim0.vtk)" = 48 ]
report 'sixteen triangles' $? rim0.vtk

# a ball without friction goes to and fro between the walls, 0.45 from the middle at most
cat >in.ball <<END
$start
fix rim all mesh/surface fix lid type 2
fix wall all wall/gran model hertz tangential history mesh n_meshes 2 meshes lid rim
fix turn all move/mesh mesh rim rotate origin 0 0 0 axis 0 0 1 period 0.7
fix nv all nve/sphere
thermo 1000
thermo_style custom step ke f_rim
run \${to} upto
write_restart \${name}.restart
variable x equal x[1]
variable y equal y[1]
variable speed equal vcm(all,x)^2+vcm(all,y)^2
END
sed -i 's/ f_rim//' in.ball
agree 'a ball in the rim' "variable to index 40000
variable name index ball
$(grep -v 'move/mesh' in.ball)
print 'is speed \$(floor(1e6*v_speed+0.5)) \$(1e6*(1.3^2+0.7^2))'
print 'is inside \$(floor(abs(v_x)/0.451)) 0'
print 'is inside \$(floor(abs(v_y)/0.451)) 0'"
cut() { # NAME FROM TO
	"$TSIM" -in in.ball -log "$1.log" -screen none -var name "$1" -var from "$2" -var to "$3" 2>err
	report "$1" $? err
}
cut whole none 9000
cut a none 3717
cut b a.restart 9000
same 'states' whole.restart b.restart

rejects "$start
fix rim all mesh/surface fix lib type 2" "did you mean 'lid'"
rejects "$start
fix cube all mesh/surface file cube.stl type 2 extrude_planar 0.1" 'mesh cube is not planar'
rejects "$start
fix cube all mesh/surface file cube.stl type 2
fix rim all mesh/surface fix cube type 2" 'mesh cube has no extrude_planar'
rejects "$start
fix rim all mesh/surface fix lid file cube.stl type 2" 'found both'
rejects "$start
fix rim all mesh/surface type 2" 'found none'
rejects "$start
fix rim all mesh/surface fix m1 type 2" 'm1'
finish
