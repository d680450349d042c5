#!/bin/bash
# `impact exact`: a jet on a plane and on the same plane as a mesh, against resolved contacts in small steps; threads and
# restarts; a particle that comes to rest; walls that move; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

printf '%s\n' '-3e-3 -3e-3 0 3e-3 -3e-3 0 -3e-3 3e-3 0' '3e-3 -3e-3 0 3e-3 3e-3 0 -3e-3 3e-3 0' | solid >plate.stl
cat >in.material <<'END'
units si
hard_particles yes
boundary f f f
newton off
communicate single vel yes
region box block -2e-3 2e-3 -2e-3 2e-3 -1e-3 1e-3 units box
create_box 1 box
neighbor 1e-5 bin
fix Y all property/global youngsModulus peratomtype 7e10
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 ${e}
fix mu all property/global coefficientFriction peratomtypepair 1 0.3
fix V all property/global characteristicVelocity scalar 50
END
cat >in.jet <<'END'
include in.material
region jet block -1e-3 1e-3 -1e-3 1e-3 -1e-3 1e-3 units box
create_atoms 1 random 200 12345 jet
set group all diameter 24.8e-6 density 2900
variable vx atom 90*sin(17*id)
variable vy atom 90*sin(29*id)
variable vz atom -105*abs(sin(37*id))-5
variable z atom 13e-6+1e-6*abs(sin(3*id))
variable wx atom 1e6*sin(11*id)
variable wz atom 1e6*sin(13*id)
set group all vx v_vx vy v_vy vz v_vz z v_z
set group all omegax v_wx omegaz v_wz
fix move all nve/sphere
if "${wall} == 0" then "variable shape string 'primitive type 1 zplane 0.0'" else "fix plate all mesh/surface file plate.stl type 1" "variable shape string 'mesh n_meshes 1 meshes plate'"
fix floor all wall/gran model hertz tangential history ${shape} impact ${impact}
timestep ${h}
variable push equal f_floor[3]*dt
fix sum all ave/time 1 ${n} ${n} v_push
run ${n}
print "pushed $(f_sum*v_n:%.12g)"
dump d all custom 1 ${out} id vx vy vz omegax omegay omegaz
dump_modify d sort id format float %.15g
run 0
END
# jet OUT IMPACT WALL STEP STEPS [ARGUMENT...]
jet() {
	local out=$1 impact=$2 wall=$3 h=$4 n=$5
	shift 5
	"$TSIM" -in in.jet -log none -var e 0.8 -var impact "$impact" -var wall "$wall" -var h "$h" -var n "$n" -var out "$out" "$@" >"$out.log" 2>&1
	report "jet $out" $? "$out.log"
}
# apart FILE FILE: mean of the differences of velocity and spin, over 105 m/s
apart() {
	paste "$1" "$2" | awk '
		NF == 14 && $1 ~ /^[0-9]/ {
			d = 0
			for (k = 2; k <= 7; k++) { x = ($k - $(k + 7)) * (k > 4 ? 12.4e-6 : 1); d += x * x }
			s += sqrt(d) / 105; n++
		}
		END { print n == 200 ? s / n : "nan" }'
}
for wall in 0 1; do
	jet exact.$wall exact $wall 1e-8 40
	jet coarse.$wall resolved $wall 4e-11 10000
	jet fine.$wall resolved $wall 1e-11 40000
	echo "$(apart coarse.$wall exact.$wall) $(apart fine.$wall exact.$wall)" >errors
	awk '{ print "errors " $0; ok = ($2 < 6e-5 && $2 < $1 / 3); exit } END { exit !ok }' errors >said
	report "wall $wall: the error of resolved contacts falls with the step" $? said
	cat said
	# momentum: the wall's mean forces times the time
	grep -h pushed exact.$wall.log fine.$wall.log | awk '
		{ f[NR] = $2; print } END { exit !(NR == 2 && f[1] < 0 && (f[1] / f[2] - 1) ^ 2 < 1e-8) }' >said
	report "wall $wall: impulse on the wall" $? said
done
echo "plane and mesh differ by $(apart exact.0 exact.1)" >said
awk '{ ok = ($NF < 1e-11); exit } END { exit !ok }' said
report 'plane and mesh agree' $? said

# steps of a fraction of a contact, and much longer ones
jet short exact 0 4e-9 100
jet long exact 0 1e-7 4
for other in short long; do
	echo "$other steps differ by $(apart exact.0 $other)" >said
	awk '{ ok = ($NF < 1e-10); exit } END { exit !ok }' said
	report "$other steps" $? said
done
for wall in 0 1; do
	jet threads.$wall exact $wall 1e-8 40 -threads 2 -full threads
	same "threads, wall $wall" exact.$wall threads.$wall
done

# At rest under gravity: the mean force is the weight, and nothing is gained; a step is longer than an impact.
agree 'rest' 'variable e string 0.5
include in.material
create_atoms 1 single 0 0 2e-5 units box
set group all diameter 24.8e-6 density 2900
fix move all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0 impact exact
timestep 1e-6
run 20000
variable f equal f_floor[3]
fix mean all ave/time 1 5000 5000 v_f
run 10000
print "is weight $(abs(f_mean/(mass(all)*9.81)+1)<1e-3) 1"
print "is near $(abs(xcm(all,z)-12.4e-6)<1e-10) 1"
print "is slow $(abs(vcm(all,z))<3e-5) 1"'

# a wall that moves: as with the relative velocity
agree 'moving mesh' 'variable e string 0.7
include in.material
create_atoms 1 single 0 0 2e-5 units box
set group all diameter 24.8e-6 density 2900
set group all vx 30 vz -20
fix move all nve/sphere
fix plate all mesh/surface file plate.stl type 1
fix lift all move/mesh mesh plate linear 10 0 40
fix floor all wall/gran model hertz tangential off mesh n_meshes 1 meshes plate impact exact
timestep 2e-7
run 3
print "is up $(vcm(all,z):%.9g) $(40+0.7*60:%.9g)"
print "is along $(vcm(all,x):%.12g) 30"'
# between two planes and in a tube: the energy stays
agree 'channel and tube' 'variable e string 1
include in.material
create_atoms 1 single 1e-5 0 2e-5 units box
set group all diameter 24.8e-6 density 2900
set group all vx 80 vy 50 vz -100
fix move all nve/sphere
fix floor all wall/gran model hertz tangential off primitive type 1 zplane -1e-4 1e-4 impact exact
fix tube all wall/gran model hertz tangential off primitive type 1 zcylinder 1e-4 0 0 impact exact
timestep 1e-6
run 1000
print "is energy $(ke/mass(all):%.7g) $(0.5*(80^2+50^2+100^2):%.7g)"
print "is inside $(xcm(all,x)^2+xcm(all,y)^2<0.877e-4^2&&abs(xcm(all,z))<0.877e-4) 1"'

# Rigid bodies are resolved by the steps, as without the keyword, beside spheres that are not. Where the steps are too long
# for that there is a warning, and an error where a body would pass the wall.
cat >in.bodies <<'END'
variable e string 0.7
include in.material
fix clump all particletemplate/multisphere 15485863 atom_type 1 density constant 2900 nspheres 2 ntry 20000 spheres 0 0 0 1e-5 1.2e-5 0 0 0.8e-5 type 1 volume_limit 1e-16
fix one all particledistribution/discrete 15485867 1 clump 1.0
region place block -4e-4 4e-4 -4e-4 4e-4 1e-6 2e-4 units box
fix bodies all insert/pack seed 32452843 distributiontemplate one insert_every once overlapcheck yes all_in yes vel constant 5 0 -20 omega constant 2e5 -1e5 3e5 orientation random region place particles_in_region 30
fix solid all multisphere
group single empty
fix move single nve/sphere
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0 impact ${impact}
timestep ${h}
run 1
region row block -8e-4 8e-4 8e-4 9e-4 1.4e-5 1.6e-5 units box
if "${spheres} == 1" then "create_atoms 1 random 20 4321 row" "group single id > 60" "set group single diameter 24.8e-6 density 2900 vx 60 vz -70"
run ${n}
group clumps id <= 60
dump d clumps custom 1 ${out} id x y z vx vy vz omegax omegay omegaz
dump_modify d sort id format float %.17g
run 0
print "$(count(single)) spheres, energy $(ke(single):%.15g)"
END
bodies() {
	local out=$1
	shift
	"$TSIM" -in in.bodies -log none -var out "$out" "$@" >"$out.log" 2>&1
}
for way in 'resolved 0' 'exact 0' 'exact 1'; do
	# shellcheck disable=SC2086
	set -- $way
	bodies "bodies.$1.$2" -var impact "$1" -var spheres "$2" -var h 5e-10 -var n 12000
	report "bodies, $way" $? "bodies.$1.$2.log"
done
same 'bodies beside a wall with exact impacts' bodies.resolved.0 bodies.exact.0
same 'bodies beside spheres' bodies.resolved.0 bodies.exact.1
for h in 2e-8 5e-9; do
	bodies "bodies.$h" -var impact exact -var spheres 1 -var h "$h" -var n "$(awk -v h="$h" 'BEGIN { print 6e-6 / h }')"
	report "bodies, $h" $? "bodies.$h.log"
done
[ "$(grep -h '^20 spheres' bodies.2e-8.log bodies.5e-9.log | cut -c1-36 | uniq | wc -l)" = 1 ]
report 'spheres beside bodies' $? bodies.5e-9.log
grep -q 'is in a rigid body, whose contacts with wall floor are resolved by time steps' bodies.2e-8.log
report 'a warning' $? bodies.2e-8.log
refused bodies 'is in a rigid body, so its contact with wall floor is resolved by time steps; but they approach' \
	-in in.bodies -var out none -var impact exact -var spheres 1 -var h 1e-6 -var n 10
# a wall that would pass a sphere while that touches another one
cat >in.passes <<'END'
variable e string 0.7
include in.material
pair_style gran model hertz tangential history
pair_coeff * *
create_atoms 1 single 0 0 2e-5 units box
create_atoms 1 single 2.7e-5 0 2e-5 units box
set group all diameter 24.8e-6 density 2900
fix move all nve/sphere
set atom 2 vx -5
fix plate all mesh/surface file plate.stl type 1
fix lift all move/mesh mesh plate linear 0 0 40
fix floor all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate impact exact
timestep 1e-6
run 1
END
refused passes 'touches another particle, too, so its contact with wall floor is resolved by time steps; but they approach' -in in.passes

cat >in.refused <<'END'
variable e string 0.7
include in.material
fix r all property/global coefficientRollingFriction peratomtypepair 1 0.1
create_atoms 1 single 0 0 2e-5 units box
set group all diameter 24.8e-6 density 2900
fix move all ${move}
fix floor all wall/gran ${law} impact exact
timestep 1e-9
run 1
END
refused rolling 'no rolling friction' -in in.refused -var move nve/sphere -var law 'model hertz tangential history rolling_friction cdt primitive type 1 zplane 0'
refused euler 'move particles by h v' -in in.refused -var move nve/euler -var law 'model hertz tangential off primitive type 1 zplane 0'
refused pump 'no velocity along its normal' -in in.refused -var move nve/sphere -var law 'model hertz tangential off primitive type 1 zplane 0 velocity 0 0 1'
sed -e 's/^fix floor/fix plate all mesh\/surface file plate.stl type 1\nfix turn all move\/mesh mesh plate ${turn}\n&/' \
	-e 's/^run 1/run 0/' in.refused >in.turns
for turn in 'rotate origin 0 0 0 axis 0 0 1 period 1' 'riggle origin 0 0 0 axis 0 0 1 period 1 amplitude 1'; do
	for check in -check '-log none'; do
		# shellcheck disable=SC2086
		refused "mesh that moves by ${turn%% *}, $check" 'mesh plate rotates' $check -in in.turns -var turn "$turn" \
			-var move nve/sphere -var law 'model hertz tangential off mesh n_meshes 1 meshes plate'
	done
done

# Height fields: a flat one gives the impacts of the plane, a moving one and a rough one the same for any time step.
# Particles cross the periodic faces.
cat >in.field <<'END'
units si
hard_particles yes
boundary p p f
region b block -1e-3 1e-3 -1e-3 1e-3 -1e-3 1e-3 units box
create_box 2 b
fix E all property/global youngsModulus peratomtype 72e9 68.9e9
fix nu all property/global poissonsRatio peratomtype 0.17 0.33
fix e all property/global coefficientRestitution peratomtypepair 2 0.6 0.6 0.6 0.6
fix mu all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
region r block -1e-3 1e-3 -1e-3 1e-3 1e-4 9e-4 units box
create_atoms 1 random 500 777 r
set group all diameter 25e-6 density 2900
variable vx atom 90*sin(17*id)
variable vy atom 90*sin(11*id)
variable vz atom -105*abs(sin(37*id))-5
set group all vx v_vx vy v_vy vz v_vz
include in.surface
fix worn all wear/oka surface s particles sio2 hardness 1e9
fix m all nve/sphere
thermo_modify lost ignore
timestep ${h}
run $(round(1e-4/v_h))
print "worn $(f_worn[3]) $(f_worn:%.15g) $(ke(all):%.15g)"
END
law='wall/gran model hertz tangential history'
field() {
	local name=$1 h=$2
	shift 2
	printf '%s\n' "$@" >in.surface
	"$TSIM" -in in.field -log none -var h "$h" >out.field 2>&1 </dev/null
	grep '^worn ' out.field >"worn.$name"
}
like() {
	paste "worn.$1" "worn.$2" | awk -v within="$3" 'NF == 8 && $2 > 400 && $2 == $6 {
		a = $3 / $7 - 1; b = $4 / $8 - 1; good = a * a < within * within && b * b < within * within } END { exit !good }'
	report "$1 like $2" $? "worn.$1"
}
field plane 1e-6 "fix s all $law primitive type 2 zplane 0 impact exact"
field flat 1e-6 'fix s all surface/voxel constant 0 type 2 cells 37 53' "fix w all $law voxels s impact exact"
like plane flat 1e-12
for h in 1e-6 2.5e-7; do
	field "moving.$h" "$h" 'fix s all surface/voxel constant 0 type 2 cells 37 53 move linear 30 0 0' \
		"fix w all $law voxels s impact exact"
	field "rough.$h" "$h" 'fix s all surface/voxel gaussian deviation 2e-6 correlation 5e-5 5e-5 seed 5 type 2 cells 100 100' \
		"fix w all $law voxels s impact exact"
done
like moving.1e-6 moving.2.5e-7 1e-12
like rough.1e-6 rough.2.5e-7 1e-5

# a slow impact of a grain that slides fast and spins across: the direction of friction follows the slip at a rate that no
# step could resolve. It stays about the same, so friction takes the same momentum as from a grain without spin.
cat >in.grazing <<'END'
variable e index 0.6
include in.material
create_atoms 1 single 0 0 1.262558e-6
set group all diameter 2.525116e-6 density 2900
velocity all set -24.126 29.841 $(-v_n)
set group all omegax $(1.949e6*v_spin) omegay $(1.586e6*v_spin)
fix move all nve/sphere
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0 impact exact
timestep 1e-6
run 5
print "rubbed $(sqrt((vx[1]+24.126)^2+(vy[1]-29.841)^2)/v_n:%.12g) $(vz[1]/v_n:%.12g)"
END
for n in 1 0.042 0.001; do
	for spin in 0 -1 3; do
		"$TSIM" -in in.grazing -log none -var n "$n" -var spin "$spin" 2>&1 </dev/null
	done >out
	awk -v n="$n" '/^rubbed/ { if (!count++) first = $2; d = ($2 - first) / first
		good += d * d < (1e-3 * n) ^ 2 + 1e-14 && $3 > 0.599999 && $3 < 0.600001 } END { exit !(count == 3 && good == 3) }' out
	report "grazing impacts with spin, at $n" $? out
done

finish
