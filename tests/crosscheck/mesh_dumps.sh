#!/bin/bash
# Dumps of meshes, byte for byte as LIGGGHTS writes them.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts

# a plate of two triangles, and a pyramid of six with a floor inside
cat >plate.stl <<'END2'
solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 0.5 0 0
vertex 0 0.5 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0.5 0 0
vertex 0.5 0.5 0
vertex 0 0.5 0
endloop
endfacet
endsolid plate
END2
python3 - >pyramid.stl <<'END2'
corners = [(0, 0, 0), (0.3, 0, 0), (0.3, 0.2, 0), (0, 0.2, 0)]
top = (0.1, 0.1, 0.2385)
faces = [(corners[k], corners[(k + 1) % 4], top) for k in range(4)]
faces += [(corners[0], corners[2], corners[1]), (corners[0], corners[3], corners[2])]
print("solid pyramid")
for face in faces:
    print("facet normal 0 0 0\nouter loop")
    for corner in face:
        print("vertex %g %g %g" % corner)
    print("endloop\nendfacet")
print("endsolid pyramid")
END2
cat >in.both <<'END2'
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
region reg block -1 1 -1 1 -1 1 units box
region half block 0.2 1 -1 1 -1 1 units box
create_box 1 reg
neighbor 0.01 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-3
fix a all mesh/surface file plate.stl type 1 scale 0.3333 move 0.1 0.1 0.1 rotate axis 1 1 0.3 angle 33.3
fix b all mesh/surface file plate.stl type 1 move -0.3 0 0.2 surface_vel 0.1 0 0.2385
fix c all mesh/surface file pyramid.stl type 1 move -0.33 -0.7 -0.1
fix w all wall/gran model hertz tangential history mesh n_meshes 3 meshes a b c
dump s1 all mesh/stl 1 s1.*.stl
dump s2 all mesh/stl 2 s2.*.stl b a
dump s3 all stl 1 s3.*.stl region half
dump s4 all mesh/stl 2 s4.*.stl local
dump s5 all mesh/stl 2 s5.*.stl a ghost
dump_modify s2 pad 5
dump v1 all mesh/vtk 2 v1.*.vtk vel id nneighs index acorners aedges area owner
dump v2 all mesh/gran/VTK 2 v2.*.vtk id c b
dump v3 all mesh/vtk 2 v3.*.vtk output interpolate a area b vel
dump v4 all mesh/vtk 2 v4.*.vtk output original area a aedges
dump v5 all mesh/vtk 2 v5.*.vtk output interpolate vel id nneighs index acorners aedges area owner
run 2
END2
# the rim of a plate, and a triangle that is warm; LIGGGHTS reads a warm mesh only where there is heat
echo '0.5 0.5 0.1 0.7 0.5 0.1 0.6 0.7 0.2' | solid >one.stl
sed '/^dump/d; /^run/d; /^fix [abcw]/d' in.both >in.rim
cat >>in.rim <<'END2'
fix k1 all property/global thermalConductivity peratomtype 1
fix k2 all property/global thermalCapacity peratomtype 1
fix heat all heat/gran initial_temperature 300
fix warm all mesh/surface file one.stl type 1 temperature 350.5
fix plate all mesh/surface file plate.stl type 1 rotate axis 1 2 0 angle 33 extrude_planar 0.2385
run 0
fix rim all mesh/surface fix plate type 1
fix small all mesh/surface fix plate type 1 scale 0.5 move 0.1 0.1 0.1
dump r1 all mesh/stl 1 r1.*.stl rim
dump r2 all mesh/stl 1 r2.*.stl
dump t1 all mesh/vtk 1 t1.*.vtk temp warm area id
dump t2 all mesh/vtk 1 t2.*.vtk temp area rim distaa
dump t3 all mesh/vtk 1 t3.*.vtk output interpolate temp warm
run 1
END2
mkdir theirs ours
for side in theirs ours; do cp ./*.stl in.both in.rim $side; done
for script in in.both in.rim; do
	(cd theirs && liggghts -in $script -log log >out 2>&1)
	report "$script: LIGGGHTS" $? theirs/out
	(cd ours && "$TSIM" -in $script -log none >out 2>&1)
	report "$script: tsim" $? ours/out
done
for file in theirs/*.*.stl theirs/*.vtk; do
	same "$file" "$file" "ours/${file#theirs/}"
done
finish
