#!/bin/bash
# Meshes that are given otherwise than before: misspelled words, words of other walls, another velocity or file in a script that
# continues from a restart file, meshes defined anew behind their movers; and surfaces that are too finely divided.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

material='fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.6 0.6 0.6 0.6
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
pair_style gran model hertz tangential history
pair_coeff * *
neighbor 0.02 bin
timestep 2e-5'
head='units si
atom_style granular
boundary f f f'
box="$head
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
$material
create_atoms 1 single 0.1 0.2 0.8 units box
set group all diameter 0.1 density 2500
fix nve all nve/sphere"
plate='mesh/surface/stress primitive plate length 1 width 1 type 2'
wall='fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad'

# ---- words that have no effect are refused
for words in 'scale 0.5 mov 0 0 -0.3' 'move 0 0 0 rotat axis 1 0 0 angle 90'; do
	rejects "$box
fix cad all $plate $words" 'did you mean'
done
rejects "$box
fix cad all $plate scale 1 2 3" "unknown keyword '2'"
rejects "$box
fix cad all $plate rotate axis 0 0 1 angle 90 90" "unknown keyword '90'"
prints "$box
fix cad all $plate scale 2 move 0 0 0.1 scale 0.5 rotate axis 0 0 1 angle 90 move 0.1 0 0
dump d all mesh/stl 1 cad_*.stl
run 0
print ready" ready
for words in 'velocity 1 0 0' 'shear x 1' 'wiggle z 0.01 0.1' 'temperature 400'; do
	rejects "$box
fix cad all $plate
$wall $words" 'is for planes and cylinders'
done
servo='fix cad all mesh/surface/stress/servo primitive plate length 1 width 1 type 2 com 0 0 0 ctrlPV force axis 0 0 -1 target_val 10 vel_max 0.1 kp 0.5'
rejects "$box
$servo surface_vel 0.2 0 0" 'a servo moves'
rejects "$box
$servo reference_point 0.1 0 0" 'about `com`'
rejects "$box
fix cad all $plate
${wall/1 meshes cad/2 meshes cad cad}" 'named twice'
rejects "$box
fix cad all $plate
$wall
thermo_style custom f_cad[9] f_cad[10]" 'the last is'
rejects "$box
fix cad all $plate
$wall
dump d all mesh/vtk 1 x_*.vtk f_cad[9] cad" 'the last is [6]'

prints "$box
fix cad all $plate surface_vel 0 0 1
print ready" '*its surface does not move' ready

# ---- a mesh goes on from where it is with another velocity or period, in a continuation as in one script
mover() {
	echo "fix cad all $plate reference_point 0.1 0 0
fix mv all move/mesh mesh cad $1"
}
where='print "at $(f_cad[7]:%.9f) $(f_cad[8]:%.9f) $(f_cad[9]:%.9f)"'
turned=$(awk 'BEGIN { a = 2 * atan2(0, -1) * (0.02 + 0.0004); printf "at %.9f %.9f 0.000000000", 0.1 * cos(a), 0.1 * sin(a) }')
for case in "linear 0 0 0.2:linear 0 0 0.4:at 0.100000000 0.000000000 0.004080000" \
	"rotate origin 0 0 0 axis 0 0 1 period 1:rotate origin 0 0 0 axis 0 0 1 period 0.5:$turned"; do
	IFS=: read -r before after at <<<"$case"
	prints "$box
$(mover "$before")
$wall
run 1000
write_restart moved.restart
clear
$head
read_restart moved.restart
$material
$(mover "$after")
$wall
fix nve all nve/sphere
run 6
write_restart again.restart
run 4
$where
clear
$head
read_restart again.restart
$material
$(mover "$after")
$wall
fix nve all nve/sphere
run 4
$where" "$at"
	[ "$(grep -c "^$at" out)" = 2 ]
	report "$after: the same behind a further restart" $? out
done

# ---- what a mesh that has moved cannot change behind a restart file
continues() { # LINE OF THE MESH, AND OF ITS MOVER
	echo "$head
read_restart moved.restart
$material
fix cad all $1
fix mv all move/mesh mesh cad ${2-rotate origin 0 0 0 axis 0 0 1 period 1}
$wall
fix nve all nve/sphere
run 1"
}
rejects "$(continues "$plate reference_point 0.1 0 0 move 0 0 0.1")" 'move'
rejects "$(continues "${plate/length 1/length 1.1} reference_point 0.1 0 0")" "primitive is"
rejects "$(continues "$plate reference_point 0.2 0 0")" 'reference_point was another one'
rejects "$(continues "$plate reference_point 0.1 0 0 surface_vel 1 0 0")" 'a mesh that moves has no surface_vel'
rejects "$(continues "$plate reference_point 0.1 0 0" 'rotate origin 0.1 0 0 axis 0 0 1 period 1')" 'origin is'
rejects "$(continues "$plate reference_point 0.1 0 0" 'linear 0 0 1')" 'style is'
printf '%s\n' "$box
mesh_primitive cad.stl plate length 1 width 1
fix cad all mesh/surface/stress file cad.stl type 2
fix mv all move/mesh mesh cad linear 0 0 1
$wall
run 10
write_restart moved.restart" >in.file
"$TSIM" -in in.file -log none >out 2>&1
report 'a mesh of a file moves' $? out
again="$(continues 'mesh/surface/stress file cad.stl type 2' 'linear 0 0 1')"
prints "$again
print ready" ready
for other in 'length 1 width 1.1' 'length 1 width 1 size 0.3'; do
	printf 'mesh_primitive cad.stl plate %s\n' "$other" >in.other
	"$TSIM" -in in.other -log none >out 2>&1
	rejects "$again" 'its triangles were others'
done

# ---- a mesh that is defined anew behind its mover
rejects "$box
fix cad all $plate
fix mv all move/mesh mesh cad linear 0 0 1
$wall
run 10
fix cad all $plate
run 0" 'has been defined anew since'
refused '-check of it' 'has been defined anew since' -check -in in.script
prints "$box
fix cad all $plate
fix mv all move/mesh mesh cad linear 0 0 1
$wall
run 10
fix cad all $plate
fix mv all move/mesh mesh cad linear 0 0 1
run 0
$where" 'at 0.000000000 0.000000000 0.000000000'

# ---- binary files that have been joined
python3 - <<'P'
import struct
def stl(n, extra=b''):
    one = struct.pack('<12fH', 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    return b' ' * 80 + struct.pack('<I', n) + one * n + extra
two = struct.pack('<12fH', 0, 0, 1, 1, 1, 0, 1, 0, 0, 0, 1, 0, 0)
open('joined.stl', 'wb').write(stl(1) + stl(1))
open('more.stl', 'wb').write(stl(1) + two)
open('own.stl', 'wb').write(stl(1, b'some words of a program'))
P
for file in joined more; do
	rejects "$box
fix cad all mesh/surface file $file.stl type 2" 'further ones follow'
done
prints "$box
fix cad all mesh/surface file own.stl type 2
print ready" ready

# ---- a face of a stream that moves
for order in 0 1; do
	lines=('fix mv all move/mesh mesh face linear 0 0 -1'
		'fix ins all insert/stream seed 49979687 distributiontemplate pdd nparticles 5 particlerate 1000 vel constant 0 0 -1 insertion_face face extrude_length 0.2 verbose no')
	rejects "$box
fix face all mesh/surface/planar primitive plate length 0.6 width 0.6 type 2
fix pt all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.01
fix pdd all particledistribution/discrete 15485867 1 pt 1.0
${lines[$order]}
${lines[1 - order]}
run 1" 'the face of a stream must stay'
done

# ---- a grain inside a drum whose triangles are smaller than its contact area: a warning, and its remedy
drum() {
	echo "$head
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
$material
fix cad all mesh/surface primitive cylinder radius 0.3 length 1 base 0 0 -0.5 open both segments $1 type 2 $2
$wall
create_atoms 1 single $3 0 0 units box
set group all diameter 0.1 density 2500
velocity all set 0.5 0 0 units box
fix nve all nve/sphere
run 2500
print \"rebound \$(-vx[1]/0.5:%.2f)\""
}
prints "$(drum 500 '' 0.24)" '*within one contact area'
prints "$(drum 500 'curvature 3' 0.24)" 'rebound 0.60'
grep -q 'contact area' out
report 'no warning with a larger curvature' $((!$?)) out
prints "$(drum 48 '' 0.24)" '*rebound'
grep -q 'contact area' out
report 'no warning of large triangles' $((!$?)) out
finish
