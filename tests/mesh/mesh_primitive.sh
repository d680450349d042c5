#!/bin/bash
# Meshes by `primitive`: the same as from the file that mesh_primitive writes, with scale, move and rotate, in all mesh
# styles; several shapes in one mesh; a run cut by a restart file; threads; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
head='units si
atom_style granular
boundary f f f
neighbor 0.01 bin
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
fix m1 all property/global youngsModulus peratomtype 5.31e6 7.77e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 5e-5'
drum='drum radius 0.4 length 0.5 lifters 4 height 0.1 width 0.05 base 0 -0.25 0 axis 0 1 0'
joined="$drum primitive box 0.1 0.3 0 0.1 0 0.1 primitive sphere radius 0.1 base -0.1 0 0.05 normals inward"
change='scale 1.5 rotate axis 1 2 3 angle 20 move 0.1 0 0.05'

# the file holds all digits: a mesh from it is the same in all bits
for ending in stl vtk stl.gz; do
	prints "$head
mesh_primitive f.$ending $joined
fix a all mesh/surface primitive $joined type 1 $change
fix b all mesh/surface file f.$ending type 1 $change
dump a all mesh/stl 1 a*.stl a
dump b all mesh/stl 1 b*.stl b
run 0" "*mesh_primitive: f.$ending: 4208 triangles, 2109 corners, area"
	same "file and fix: $ending" a0.stl b0.stl
done
prints "$head
fix a all mesh/surface type 1 scale 1.5 primitive $drum rotate axis 1 2 3 angle 20 primitive box 0.1 0.3 0 0.1 0 0.1 &
	move 0.1 0 0.05 primitive sphere radius 0.1 base -0.1 0 0.05 normals inward
dump a all mesh/stl 1 c*.stl a
run 0" '*Step'
same 'mixed order of words' a0.stl c0.stl

# styles with keywords of their own; `axis` of the servo is not that of the shape
prints "$head
fix a all mesh/surface/stress primitive $drum type 1 stress on
fix b all mesh/surface/planar primitive disk radius 0.2 base 0 0 0.5 type 1
fix c all mesh/surface/stress/servo primitive disk radius 0.3 axis 0 0 1 type 1 com 0 0 0 ctrlPV force axis 0 0 -1 &
	target_val 1 vel_max 1 kp 1
fix d all mesh/surface primitive box -0.3 0.3 -0.3 0.3 -0.3 0.3 open zhi zlo type 2
fix walls all wall/gran model hertz tangential history mesh n_meshes 4 meshes a b c d
run 0" '*Step'

# a turning drum: cut by a restart file and on three threads it gives the same bits
cat >in.turn <<END
variable from index none
${head%create_box*}if "\${from} == none" then "create_box 2 box" else "read_restart \${from}"
${head#*create_box 2 box
}
fix drum all mesh/surface primitive $drum type 2
fix walls all wall/gran model hertz tangential history mesh n_meshes 1 meshes drum
fix turn all move/mesh mesh drum rotate origin 0 0 0 axis 0 1 0 period 1.3
fix g all gravity 9.81 vector 0 0 -1
fix nv all nve/sphere
if "\${from} == none" then "create_atoms 1 single 0.1 0 0 units box" "create_atoms 1 single -0.1 0.1 0 units box" &
	"create_atoms 1 single -0.1 -0.1 0.1 units box" "set type 1 diameter 0.1 density 2385"
thermo 1000
run \${to} upto
write_restart \${name}.restart
END
turn() { # NAME FROM TO
	"$TSIM" -in in.turn -log none -var name "$1" -var from "$2" -var to "$3" >out 2>&1
	report "$1" $? out
}
turn whole none 8000
turn first none 3717
turn second first.restart 8000
same 'cut' whole.restart second.restart
OMP_NUM_THREADS=3 turn three none 8000
same 'three threads' whole.restart three.restart
sed -i 's/lifters 4/lifters 5/' in.turn
refused 'another drum' 'primitive' -in in.turn -var name x -var from first.restart -var to 8000

# -check says what a run says
printf '%s\n' "$head
mesh_primitive checked.stl $drum" >in.check
"$TSIM" -check -in in.check >out 2>&1
report 'check' $? out
[ ! -e checked.stl ]
report 'check writes nothing' $?

rejects "$head
mesh_primitive f.obj $drum" "should end in .stl or .vtk"
rejects "$head
mesh_primitive f.stl druhm radius 1" "did you mean 'drum'"
rejects "$head
mesh_primitive f.stl drum radius 1 length 1 lifters 4 heigth 0.1" "did you mean 'height'"
rejects "$head
fix a all mesh/surface primitive" 'primitive'
rejects "$head
fix a all mesh/surface primitive sphere radius 0.1 tpye 1" "type"
rejects "$head
fix a all mesh/surface primitive sphere radius 0.1 primitive sphere radius 0.1 type 1" 'same corners'
rejects "$head
fix a all mesh/surface/planar primitive sphere radius 0.1 type 1" 'not planar'
rejects "$head
fix a all mesh/surface primitive cylinder radius 1e3 length 1e3 type 1" 'outside the box'

# a file that is not in the folder where tsim starts is looked for beside the script
mkdir -p aside
printf '%s\n' "$head
mesh_primitive aside/only.stl $drum" >in.write
"$TSIM" -log none -in in.write >out 2>&1
printf '%s\n' "$head
fix a all mesh/surface file only.stl type 1" >aside/in.read
"$TSIM" -log none -in aside/in.read >out 2>&1
report 'a mesh beside the script' $? out
(cd aside && "$TSIM" -log none -in in.read) >out 2>&1
report 'and in the folder itself' $? out
rm aside/only.stl
"$TSIM" -log none -in aside/in.read >out 2>&1
[ $? != 0 ] && shows "cannot open 'only.stl': No such file" out
report 'and nowhere' $? out
# a negative period turns the other way round
turns=0
for turn in 'axis 0 0 1 period -0.7' 'axis 0 0 -1 period 0.7'; do
	printf '%s\n' 'units si' 'boundary f f f' 'region box block -1 1 -1 1 -1 1 units box' 'create_box 1 box' 'timestep 0.01' \
		'fix b all mesh/surface type 1 primitive box 0.1 0.3 0 0.1 0 0.1' "fix t all move/mesh mesh b rotate origin 0 0 0 $turn" \
		'dump d all mesh/stl 13 turned*.stl' 'run 13' >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "turns by $turn" $? out
	mv turned13.stl "turned.$((++turns))"
done
same 'a negative period' turned.1 turned.2
rejects "$(sed 's/period .*/period 0/' in.script)" 'the period is 0, must not be'
finish
