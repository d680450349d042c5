#!/bin/bash
# dump voxel/vtk with outputs of fixes: the numbers of the columns that are not empty, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
printf '%s\n' '0 0 2 1 0 2 1 1 2' | solid >cad.stl

# Six columns of 1 x 1, the second one empty; a sphere falls on the third, which wears
springs >in.springs
cat >in.head <<'END'
units si
boundary f f f
region b block 0 3 0 2 0 3 units box
create_box 2 b
neighbor 0.02 bin
include in.springs
fix move all nve/sphere
timestep 1e-6
variable cx internal 0
variable cy internal 0
variable h equal 1-(v_cx==1.5)*(v_cy==0.5)
fix s all surface/voxel formula v_h x cx y cy type 2 cells 3 2 base 0
fix t all surface/voxel constant 0.1 type 2 cells 1 1 origin 1 0 size 1 1
fix w all wall/gran model hooke/stiffness voxels s
fix v all wall/gran model hooke/stiffness voxels t
fix cad all mesh/surface file cad.stl type 2
fix worn all wear/finnie surface s flow_stress 1e9
create_atoms 1 single 2.4 0.6 1.0501 units box
set group all diameter 0.1 density 2385
velocity all set 0.8 0 -0.6 units box
END
# shellcheck disable=SC2016
{
	cat in.head
	printf '%s\n' 'dump one all voxel/vtk 5000 one.*.vtk s f_worn[1] f_worn[8]' \
		'dump all all voxel/vtk 5000 all.*.vtk s f_worn[*]' 'dump other all voxel/vtk 5000 other.*.vtk t' \
		'run 5000' 'print "volume $(f_worn:%.11g)"'
} >in.script
"$TSIM" -in in.script -log none >out 2>&1
report 'runs' $? out
array() { awk -v name="$1" '$1 == name { for (n = $3; n > 0; n--) { getline; print } }' "$2"; }
array 'f_worn[1]' one.5000.vtk >found
printf '%s\n' 0 1 0 0 0 >expected
same 'one impact, on the third column; the second is left out' expected found
array 'f_worn[8]' one.5000.vtk | awk '$1 > 0' >found
sed -n 's/^volume //p' out >expected
same 'its volume is that of the fix' expected found
array 'f_worn[8]' one.5000.vtk >one
array 'f_worn[8]' all.5000.vtk >two
same 'f_worn[*] writes all columns' one two
grep -c '^f_worn' all.5000.vtk >found
sed -n 's/^FIELD FieldData //p' all.5000.vtk | awk '{ print $1 - 2 }' >expected
same 'as many as the title says' expected found
off() {
	rejects "$(cat in.head)
$1
run 0" "$2"
}
off 'dump d all voxel/vtk 1 d.*.vtk t f_worn[1]' "dump voxel/vtk: 'f_worn[1]' is about a voxel surface that this dump does not write: s"
off 'dump d all mesh/vtk 1 d.*.vtk id f_worn[1] cad' "dump mesh/vtk: 'f_worn[1]' is about a voxel surface that this dump does not write: s"
off 'dump d all voxel/vtk 1 d.*.vtk s f_w[1]' 'expected rows of triangles'
off 'dump d all voxel/vtk 1 d.*.vtk s f_worn[99]' 99
off 'dump d all voxel/vtk 1 d.vtk s' 'writes one file per frame'
finish
