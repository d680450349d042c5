#!/bin/bash
# Dumps of meshes: which triangles are written, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >flag.obj <<'END2'
v 0 0 0
v 2.385 0 0
v 2.385 1 0
v 0 1 0
v 0 1 0.7
f 1 2 3 4
f 3 4 5
END2
start='boundary f f f
region box block -1 4 -1 4 -1 4 units box
region left block -1 1 -1 4 -1 4 units box
create_box 1 box
fix flag all mesh/surface file flag.obj type 1 surface_vel 0 2.5 0
'

# has WHAT FILE TEXT...: lines of the file
has() {
	local what=$1 file=$2 ok=0 line
	shift 2
	for line in "$@"; do
		grep -qxF -- "$line" "$file" || { ok=1; echo "missing: $line" >>"$file"; }
	done
	report "$what" $ok "$file"
}

prints "$start
dump d all mesh/stl 1 d*.stl flag
dump half all stl 1 half*.stl region left
dump v all mesh/vtk 1 v*.vtk area nneighs vel
dump_modify d pad 3
run 1
print ready" ready
has 'a facet' d001.stl '  facet normal 0 -0 1' '      vertex 2.385 1 0'
[ "$(grep -c '^  facet' d001.stl) $(grep -c '^  facet' half1.stl)" = '3 2' ]
report 'three triangles, of which two have their centres in the region' $? half1.stl
has 'numbers of triangles' v1.vtk 'area 1 3 double' '1.1925 1.1925 0.83475 ' 'nneighs 1 3 int' '1 2 1 '
# the surface of the third triangle is upright: the velocity is laid down into its plane
has 'velocities' v1.vtk 'v 3 3 double' '0 2.5 0 0 2.5 0 0 0 0 '
# a mesh with a mover has velocities before the first step, and after unfix, as in LIGGGHTS: one array in all frames
prints "$start
fix other all mesh/surface file flag.obj type 1
fix lift all move/mesh mesh other linear 0 0 1.5
dump v all mesh/vtk 1 w*.vtk area vel other
run 1
unfix lift
run 1
print ready" ready
for frame in 0 2; do has "at rest in frame $frame" w$frame.vtk 'v 3 3 double' '0 0 0 0 0 0 0 0 0 '; done
has 'moving' w1.vtk 'v 3 3 double' '0 0 1.5 0 0 1.5 0 0 1.5 '
# all triangles of a warm mesh are warm
prints "$start
fix warm all mesh/surface file flag.obj type 1 temperature 350.5
dump t all mesh/vtk 1 t*.vtk temp liquid warm flag
dump f all mesh/vtk 1 f*.vtk temp area flag
run 0
print ready" ready
has 'temperatures' t0.vtk 'FIELD FieldData 1' 'Temp 1 6 double' '350.5 350.5 350.5 0 0 0 '
has 'no temperature' f0.vtk 'FIELD FieldData 1'

rejects "$start dump d all mesh/stl 1 d.stl" 'needs a `*` for the step'
rejects "$start dump d all mesh/stl 1 d*.stl flog" "there is no mesh 'flog'"
rejects "$start dump d all mesh/stl 1 d*.stl flag region" '`region` needs the id of a region'
rejects "$start dump d all mesh/stl 1 d*.stl flag region nowhere" "'nowhere'"
rejects "$start dump d all mesh/vtk 1 d*.vtk flag" 'say what to write'
rejects "$start dump d all mesh/vtk 1 d*.vtk output facets id" "did you mean 'face'"
rejects "$start dump d all mesh/vtk 1 d*.vtk id output" '`output` must be followed'
rejects "$start dump d all mesh/vtk 1 d*.vtk id stress2" "there is no mesh 'stress2'"
finish
