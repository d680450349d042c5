#!/bin/bash
# Walls made of triangles: a plate of triangles is a plane, a cube has twelve edges, a run cut by a
# restart file is the whole run; and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

plate 6 0 >plate.stl
cuboid 0.5 0.4 0.3 >cube.stl

scene='units si
atom_style granular
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
fix m1 all property/global youngsModulus peratomtype 5.31e6 7.77e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.73 0.61 0.61 0.53
fix m4 all property/global coefficientFriction peratomtypepair 2 0.37 0.31 0.31 0.41
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.053 0.11 0.11 0.21
neighbor 0.01 bin
pair_style gran model hertz tangential history rolling_friction epsd2
pair_coeff * *
timestep 2e-5
fix down all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
variable law string "model hertz tangential history rolling_friction epsd2"'
ball='create_atoms 1 single ${x} ${y} ${z} units box
set group all diameter 0.1 density 2385
velocity all set ${vx} ${vy} ${vz} units box'

# A ball that bounces, slides and rolls over the edges between flat triangles does as on a plane; its
# contact remembers. f_wall: the force on the wall.
{
	echo "$scene"
	echo 'if "${kind} == mesh" then &
		"fix cad all mesh/surface file plate.stl type 2" &
		"fix wall all wall/gran ${law} mesh n_meshes 1 meshes cad" &
		else "fix wall all wall/gran ${law} primitive type 2 zplane 0"'
	printf '%s\n' 'variable x equal -0.31' 'variable y equal -0.22' 'variable z equal 0.0513' \
		'variable vx equal 1.1' 'variable vy equal 0.77' 'variable vz equal -0.3' "$ball"
	echo 'run 20000
print "$(xcm(all,x):%.13g) $(xcm(all,y):%.13g) $(xcm(all,z):%.13g) $(f_wall[1]:%.6g) $(f_wall[3]:%.6g)" file ${kind}.txt'
} >in.plate
for kind in mesh plane; do
	"$TSIM" -in in.plate -var kind $kind -log none -screen none 2>err
	report "a ball on a $kind" $? err
done
same 'a plate of triangles is a plane' mesh.txt plane.txt

# At rest on an edge and on a corner of a cuboid, at 45 degrees and along the diagonal: the force is that
# of one contact, not of each triangle that meets there. With e = 1 and no friction energy stays.
for at in 'face 0.1 0.1 0.348' 'edge 0.533 0.1 0.337' 'corner 0.527 0.428 0.329'; do
	set -- $at
	prints "$scene
fix cad all mesh/surface file cube.stl type 2
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
variable x equal $2
variable y equal $3
variable z equal $4
variable vx equal 0
variable vy equal 0
variable vz equal 0
$ball
unfix down
variable dx equal xcm(all,x)-0.5
variable dy equal xcm(all,y)-0.4
variable dz equal xcm(all,z)-0.3
variable distance equal \"sqrt((v_dx>0)*v_dx^2+(v_dy>0)*v_dy^2+(v_dz>0)*v_dz^2)\"
variable delta equal 0.05-v_distance
variable young equal 1/((1-0.45^2)/5.31e6+(1-0.31^2)/7.77e6)
variable force equal 4/3*v_young*sqrt(0.05)*v_delta^1.5
compute got all reduce max fz
compute gotx all reduce max fx
compute goty all reduce max fy
run 0
print \"$1: \$(sqrt(c_got^2+c_gotx^2+c_goty^2)/v_force:%.12g)\"" "$1: 1"
done

# A run cut by a restart file; the ball lies on an edge of two flat triangles.
cat >in.cut <<END
$(echo "$scene" | sed '/^create_box/d; /^region/d')
END
sed -i '3a if "${from} == none" then "region box block -1 1 -1 1 -1 1 units box" "create_box 2 box" "create_atoms 1 single -0.3 -0.2 0.0497 units box" "set group all diameter 0.1 density 2385" "velocity all set 1 0.77 -0.3 units box" else "read_restart ${from}"' in.cut
cat >>in.cut <<'END'
fix cad all mesh/surface file plate.stl type 2
fix wall all wall/gran ${law} mesh n_meshes 1 meshes cad
run ${last} upto
write_restart ${out}.restart
END
cut_run() { # OUT LAST FROM
	"$TSIM" -in in.cut -log none -screen none -var out "$1" -var last "$2" -var from "$3" 2>err
	report "cut: $1" $? err
}
cut_run whole 9000 none
cut_run a 3217 none
cut_run b 9000 a.restart
same 'cut in two' whole.restart b.restart

# A box with a periodic face: the ball meets the image of the plate beyond it, and keeps its contact.
prints "$(echo "$scene" | sed 's/boundary f f f/boundary p f f/; s/block -1 1 -1/block -0.5 0.5 -1/')
fix cad all mesh/surface file plate.stl type 2
fix wall all wall/gran \${law} mesh n_meshes 1 meshes cad
variable x equal 0.3
variable y equal 0.1
variable z equal 0.05
variable vx equal 1
variable vy equal 0
variable vz equal 0
$ball
run 20000
print \"fell \$(xcm(all,z)<0.049), crossed \$(xcm(all,x)>0.5)\"" 'fell 0, crossed 1'

# Triangles of a floor that meet only across a periodic face: a ball that rolls over the seam moves as one that does not.
for law in 'hertz tangential history rolling_friction epsd2' 'jkr tangential history'; do
	for x in 0.27 0.77; do
		printf '%s\n' "$(echo "$scene" | sed "s/boundary f f f/boundary p p f/; s/block -1 1 -1 1/block -0.5 0.5 -0.5 0.5/
			s/^pair_style.*/fix m6 all property\/global workOfAdhesion peratomtypepair 2 0.5 0.5 0.5 0.5\npair_style gran model $law/")
fix cad all mesh/surface file plate.stl type 2
fix wall all wall/gran model $law mesh n_meshes 1 meshes cad
create_atoms 1 single $((${x#0.} - 50))e-2 0.4999 0.0999 units box
set group all diameter 0.2 density 2385
velocity all set 1 0.1 0 units box
fix move all nve/sphere
run 25000
print \"rolled \$(xu[1]+0.5-$x:%.8f) \$(z[1]:%.10f) \$(vx[1]:%.8f) \$(omegax[1]:%.7f) \$(omegay[1]:%.7f)\"" >in.seam
		"$TSIM" -in in.seam -log none 2>&1 </dev/null | grep '^rolled' >"seam.$x"
	done
	same "over the seam: $law" seam.0.27 seam.0.77
done

# A ball between an inclined sheet and the periodic image of this sheet touches both: triangles that share a corner are flat
# neighbours only in images that do.
{ echo '0 0 0  1 0 1.7320508  1 1 1.7320508'; echo '0 0 0  1 1 1.7320508  0 1 0'
	echo '1 0 1.7320508  2 0 3.4641016  2 1 3.4641016'; echo '1 0 1.7320508  2 1 3.4641016  1 1 1.7320508'; } | solid >sheet.stl
for law in 'hertz tangential history' 'jkr tangential history'; do
	prints "$(echo "$scene" | sed "s/boundary f f f/boundary p p f/; s/block -1 1 -1 1 -1 1/block 0 1 0 1 -1 5/; /^fix down/d; s/neighbor 0.01/neighbor 0.005/
		s/^pair_style.*/fix m6 all property\/global workOfAdhesion peratomtypepair 2 0.5 0.5 0.5 0.5\npair_style gran model $law/")
fix cad all mesh/surface file sheet.stl type 2
fix wall all wall/gran model $law mesh n_meshes 1 meshes cad
create_atoms 1 single 0.2 0.4 1.21243556 units box
set group all diameter 0.9 density 2385
compute force all reduce sum fx fz
run 0
print \"held \$(abs(c_force[1])<1e-3) \$(abs(c_force[2])<1e-3)\"" 'held 1 1'
done

start='units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box'
rejects "$start
fix cad all mesh/surface file nothing.stl type 1" "nothing.stl"
rejects "$start
fix cad all mesh/surface file cube.stl type 1 rotate axis 0 0 0 angle 3" 'the axis has no length'
rejects "$start
fix cad all mesh/surface file cube.stl type 1 move 0.7 0 0" '2 of 12 triangles have their centre outside the box'
cat cube.stl cube.stl >twice.stl
rejects "$start
fix cad all mesh/surface file twice.stl type 1" 'has the same corners as another'
prints "$start
fix cad all mesh/surface file twice.stl type 1 heal auto_remove_duplicates" '*so do 11 others; left out by `heal`'
rejects "$start
fix cad all mesh/surface file plate.stl type 1 curvature 50" 'curvature_tolerant yes'
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix w all wall/gran model hertz mesh n_meshes 1 meshes cda" "did you mean 'cad'"
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix w all wall/gran model hertz mesh n_meshes 2 meshes cad" 'n_meshes is 2, but 1 meshes are named'
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix w all wall/gran model hertz mesh meshes cad zplane 0" 'a wall is a mesh, a height field or a primitive, one of them'
rejects "$start
fix g all gravity 9.81 vector 0 0 -1
fix w all wall/gran model hertz mesh meshes g" 'fix g is no mesh'
rejects "$start
fix w all wall/gran model hertz primitive zplane 0" 'which `type`?'

# Meshes that move. A ball that nothing moves shows by the force on it where the mesh is: after a full turn,
# or two oscillations, the mesh is where it was.
still="$(echo "$scene" | sed '/^fix move/d; /^fix down/d')
fix cad all mesh/surface file cube.stl type 2
fix wall all wall/gran model hertz mesh meshes cad
create_atoms 1 single 0.1 0.05 0.3483 units box
set group all diameter 0.1 density 2385
compute f all reduce max fz"
turn() { # LINES EXPECTED [LINES]; in the end the mesh is at rest
	prints "$still
run 0
variable first equal \$(c_f)
$1
run 1000
$3
run 1
print \"force \$(c_f/v_first:%.9f)\"" "force $2"
}
turn 'fix m all move/mesh mesh cad rotate origin 0.1 0 0 axis 0.1 0.2 1 period 0.02' 1.000000000 'unfix m'
turn 'fix m all move/mesh mesh cad wiggle amplitude 0.01 0.02 0.0001 period 0.01' 1.000000000 'unfix m'
# 0.02 * 0.05 = 0.001 further up: (0.0027/0.0017)^1.5
turn 'fix m all move/mesh mesh cad linear 0.01 0 0.05' 2.001576826 'unfix m'
turn 'fix m all move/mesh mesh cad linear 0.01 0 0.025
fix n all move/mesh mesh cad linear/superposable 0.01 0 0.025' 2.001576826 'unfix m
unfix n'
# where it was left it stays, at rest, and goes on from there
turn 'fix m all move/mesh mesh cad linear 0.01 0 0.025
run 1000
unfix m
run 10
fix m all move/mesh mesh cad linear 0.01 0 0.025' 2.001576826 'unfix m'
turn 'fix m all move/mesh mesh cad linear 0.01 0 0.025
fix n all move/mesh mesh cad linear 0.01 0 0.025
run 500
unfix n
run 500
unfix m' 1.730118080

# A run with motions cut by restart files is the whole run; movers given again go on.
cat >in.moving <<END
$(sed '/^run/,$d; s/file plate.stl type 2/file cube.stl type 2 scale 0.5/; s/single -0.3 -0.2 0.0497/single 0.1 0.05 0.2/' in.cut)
fix turn all move/mesh mesh cad rotate origin 0 0 0 axis 0.1 0.2 1 period 0.3
fix shake all move/mesh mesh cad wiggle amplitude 0.01 0.02 0.03 period 0.05
run \${last} upto
write_restart \${out}.restart
END
mv in.moving in.cut
cut_run whole 4000 none
cut_run a 1217 none
cut_run b 2981 a.restart
cut_run c 4000 b.restart
same 'moving, cut in three' whole.restart c.restart

rejects "$start
fix cad all mesh/surface file cube.stl type 1 surface_vel 1 0 0
fix m all move/mesh mesh cad linear 1 0 0" 'cannot move'
rejects "$start
fix m all move/mesh mesh cad linear 1 0 0" "there is no mesh 'cad'"
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix m all move/mesh mesh cad rotate origin 0 0 0 axis 0 0 0 period 1" 'the axis has no length'
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix m all move/mesh mesh cad viblin axis 0 0 1 order 2 amplitude 1 phase 0 0 period 1 1" 'amplitude has 1 numbers'
rejects "$start
fix cad all mesh/surface file cube.stl type 1
fix w all wall/gran model hertz mesh meshes cad
fix m all move/mesh mesh cad linear 30 0 0
timestep 0.001
run 100" 'centre outside the box'

# Which triangles are taken.
triangles() { # WORDS EXPECTED
	printf '%s\n' "$start" 'region half block INF 0.6 INF INF -0.5 0 units box' \
		"fix cad all mesh/surface file cube.stl type 1 $1" 'run 0' >in.script
	"$TSIM" -explain -in in.script -log none >out 2>&1 && grep -q "mesh cad  *$2 triangles" out
	report "triangles $1" $? out
}
echo '2 9 9' >list
triangles '' 12
triangles 'element_exclusion_list read list' 10
triangles 'region box' 12
triangles 'region half scale 0.5' 2
rejects "$start
fix cad all mesh/surface file cube.stl type 1 element_exclusion_list keep list" 'expected `read FILE`'
rejects "$start
fix cad all mesh/surface file twice.stl type 1 element_exclusion_list write list" 'the same corners'
prints "$start
fix cad all mesh/surface file twice.stl type 1 element_exclusion_list read list"

# A box whose faces move makes room for the mesh.
prints "$(echo "$start" | sed 's/boundary f f f/boundary m f f/')
fix cad all mesh/surface file cube.stl type 1 move 0.7 0 0
create_atoms 1 single 0 0 0.9 units box
run 0
print \"box to \$(xhi:%.10g)\"" 'box to 1.2002'
finish
