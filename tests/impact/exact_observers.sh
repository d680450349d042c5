#!/bin/bash
# Observers of contacts with `impact exact`: sliding wear and the load of a mesh are integrals over each impact. Closed forms,
# the same numbers with resolved contacts in small steps, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

printf '%s\n' '-3e-3 -3e-3 0 3e-3 -3e-3 0 -3e-3 3e-3 0' '3e-3 -3e-3 0 3e-3 3e-3 0 -3e-3 3e-3 0' | solid >plate.stl
cat >in.jet <<'END'
units si
hard_particles yes
boundary f f f
newton off
communicate single vel yes
variable L equal ${length}
variable M equal ${mass}
variable p equal v_M/v_L
region box block $(-2e-3*v_L) $(2e-3*v_L) $(-2e-3*v_L) $(2e-3*v_L) $(-1e-3*v_L) $(1e-3*v_L) units box
create_box 2 box
neighbor $(1e-5*v_L) bin
fix Y all property/global youngsModulus peratomtype $(7e10*v_p) $(7e10*v_p)
fix nu all property/global poissonsRatio peratomtype 0.3 0.3
fix e all property/global coefficientRestitution peratomtypepair 2 ${e} ${e} ${e} ${e}
fix mu all property/global coefficientFriction peratomtypepair 2 ${mu} ${mu} ${mu} ${mu}
fix V all property/global characteristicVelocity scalar $(50*v_L)
fix k all property/global k_finnie peratomtypepair 2 1e-9 1e-9 1e-9 1e-9
region jet block $(-1e-3*v_L) $(1e-3*v_L) $(-1e-3*v_L) $(1e-3*v_L) $(-1e-3*v_L) $(1e-3*v_L) units box
create_atoms 1 random 200 12345 jet
set group all diameter $(24.8e-6*v_L) density $(2900*v_M/v_L^3)
variable vx atom 90*sin(17*id)*v_L
variable vy atom 90*sin(29*id)*v_L
variable vz atom (-105*abs(sin(37*id))-5)*v_L
variable z atom (13e-6+1e-6*abs(sin(3*id)))*v_L
variable wx atom 1e6*sin(11*id)*v_spin
variable wz atom 1e6*sin(13*id)*v_spin
set group all vx v_vx vy v_vy vz v_vz z v_z
set group all omegax v_wx omegaz v_wz
group few id 1:100
group none id 500
fix move all nve/sphere
include in.surface
fix floor all wall/gran ${law} ${shape} impact ${impact}
fix a all wear/archard surface ${s} k 1e-4 hardness $(1.2e9*v_p)
fix z all wear/zhao/chang/contact surface ${s} hardness $(1.1e9*v_p) modulus $(7e10/1.82*v_p)
fix i all wear/zhao/chang surface ${s} hardness $(1.1e9*v_p) modulus $(7e10/1.82*v_p)
fix few few wear/archard surface ${s} k 1e-4 hardness $(1.2e9*v_p)
fix none none wear/archard surface ${s} k 1e-4 hardness $(1.2e9*v_p)
timestep ${h}
include in.run
print "worn $(f_a:%.15g) $(f_z:%.15g) $(f_i:%.15g) $(f_few:%.15g) $(f_none) $(f_a[6]:%.15g) $(f_a[3])"
END
hertz='model hertz tangential history'
# jet NAME IMPACT STEP STEPS [ARGUMENT...]: the line `worn` goes to worn.NAME
jet() {
	local name=$1 impact=$2 h=$3 n=$4
	shift 4
	"$TSIM" -in in.jet -log none -var impact "$impact" -var h "$h" -var n "$n" -var e 0.8 -var mu 0.3 -var spin 1 \
		-var length 1 -var mass 1 -var law "$hertz" "$@" >"out.$name" 2>&1
	report "jet $name" $? "out.$name"
	grep '^worn ' "out.$name" >"worn.$name"
}
# like A B PART: the volumes and the work are the same up to this part
like() {
	paste "worn.$1" "worn.$2" | awk -v part="$3" 'NF == 16 && $2 > 0 {
		for (k = 2; k <= 8; k++) bad += ($k - $(k + 8)) ^ 2 > (part * $k) ^ 2
		good = !bad } END { exit !good }'
	report "$1 like $2" $? "worn.$2"
}
primitive() {
	printf '%s\n' 'variable s string floor' "variable shape string 'primitive type 2 zplane 0.0'"
}
# shellcheck disable=SC2016
one_run='run ${n}'
echo "$one_run" >in.run

# Without friction a particle slides at its speed t along the surface, and the elastic impact at the speed n has the impulse
# 2 m n: k F s/H is k 2 m n t/H. Its groove is that of fix wear/zhao/chang.
primitive >in.surface
jet smooth exact 1e-8 40 -var e 1 -var mu 0 -var spin 0
awk 'BEGIN {
		m = 4 / 3 * atan2(0, -1) * 2900 * 12.4e-6 ^ 3
		for (id = 1; id <= 200; id++) {
			x = 90 * sin(17 * id); y = 90 * sin(29 * id); z = 105 * sqrt(sin(37 * id) ^ 2) + 5
			one = 1e-4 * 2 * m * z * sqrt(x * x + y * y) / 1.2e9
			sum += one; few += id <= 100 ? one : 0
		}
	}
	{ a = $2 / sum - 1; b = $3 / $4 - 1; c = $5 / few - 1; print a, b, c
	exit !(NF == 8 && a * a < 1e-12 && b * b < 1e-10 && c * c < 1e-12 && $6 == 0 && $7 ^ 2 < 1e-40 && $8 == 200) }' \
	worn.smooth >said
report 'closed forms' $? said
cat said

# Resolved contacts: their error is proportional to the time step.
jet exact exact 1e-8 40
jet coarse resolved 4e-10 1000
jet fine resolved 1e-10 4000
paste worn.exact worn.coarse worn.fine | awk '
	{ for (k = 2; k <= 7; k++) if (k != 4 && k != 6) {
		c = $(k + 8) / $k - 1; f = $(k + 16) / $k - 1; order = log(c / f) / log(4)
		print k, c, f, order
		bad += !(f * f < 0.01 ^ 2 && order > 0.9 && order < 1.1) } }
	END { exit bad || NR != 1 }' >said
report 'volumes and work of resolved contacts converge to the exact ones with order 1' $? said
cat said
for no in no_history off; do
	jet "$no" exact 1e-8 40 -var law "model hooke tangential $no"
	jet "$no.fine" resolved 1e-10 4000 -var law "model hooke tangential $no"
	like "$no" "$no.fine" 1.5e-2
done

# The step, threads, runs; units, in which rounding changes the steps of the integration.
jet short exact 4e-9 100
jet long exact 1e-7 4
like exact short 1e-9
like exact long 1e-9
jet threads exact 1e-8 40 -threads 3 -full threads
same 'the same with three threads' worn.exact worn.threads
# shellcheck disable=SC2016
printf '%s\n' 'run 20' 'run $(v_n-20)' >in.run
jet parts exact 1e-8 40
same 'two runs' worn.exact worn.parts
echo "$one_run" >in.run
jet micro exact 1e-8 40 -var length 1e6 -var mass 1e9
jet kilo exact 1e-8 40 -var length 1e-3 -var mass 1e3
awk -v CONVFMT=%.17g -v OFMT=%.17g '{ for (k = 2; k <= 6; k++) $k /= 1e18; $7 /= 1e21; print }' worn.micro >worn.from_micro
awk -v CONVFMT=%.17g -v OFMT=%.17g '{ for (k = 2; k <= 6; k++) $k /= 1e-9; $7 /= 1e-3; print }' worn.kilo >worn.from_kilo
like exact from_micro 1e-5
like exact from_kilo 1e-5

# A mesh: force and torque times the step, summed, and its own wear.
cat >in.surface <<'END'
fix plate all mesh/surface/stress file plate.stl type 2 wear finnie reference_point 3e-4 -2e-4 1e-4
variable s string plate
variable shape string 'mesh n_meshes 1 meshes plate'
variable fx equal f_plate[1]*dt
variable fz equal f_plate[3]*dt
variable tx equal f_plate[4]*dt
variable ty equal f_plate[5]*dt
variable tz equal f_plate[6]*dt
compute worn all reduce sum f_plate[6]
END
cat >in.run <<'END'
fix sum all ave/time 1 ${n} ${n} v_fx v_fz v_tx v_ty v_tz
run ${n}
print "load $(f_sum[1]*v_n:%.12g) $(f_sum[2]*v_n:%.12g) $(f_sum[3]*v_n:%.12g) $(f_sum[4]*v_n:%.12g) $(f_sum[5]*v_n:%.12g) $(c_worn:%.12g)"
END
jet mesh exact 1e-8 40
like exact mesh 1e-9
jet mesh.long exact 1e-7 4
jet mesh.fine resolved 1e-10 4000
for name in mesh mesh.long mesh.fine; do
	grep '^load ' "out.$name"
done >said
# the impulses along the surface nearly cancel
awk 'NR == 1 { split($0, first); unit[2] = unit[3] = first[3]; unit[4] = unit[5] = unit[6] = first[4]; unit[7] = first[7] }
	NR > 1 { for (k = 2; k <= 7; k++) bad += ($k - first[k]) ^ 2 > ((NR == 2 ? 1e-9 : k < 7 ? 1e-3 : 1e-2) * unit[k]) ^ 2 }
	END { exit bad || NR != 3 }' said
report 'load and wear of a mesh' $? said
cat said

# A surface that moves, and a height field; the slip is relative to it.
echo "$one_run" >in.run
cat >in.surface <<'END'
fix plate all mesh/surface/stress file plate.stl type 2
fix carry all move/mesh mesh plate linear 37 -11 0
variable s string plate
variable shape string 'mesh n_meshes 1 meshes plate'
END
jet moving exact 1e-8 40
{
	echo 'velocity all set -37 11 0 sum yes units box'
	primitive
} >in.surface
jet still exact 1e-8 40
like moving still 1e-9
cat >in.surface <<'END'
fix field all surface/voxel constant 0 type 2 cells 50 50
variable s string field
variable shape string 'voxels field'
END
jet field exact 1e-8 40
like exact field 1e-9

# The servo reads resolved contacts only.
cat >in.surface <<'END'
fix plate all mesh/surface/stress/servo file plate.stl type 2 com 0 0 0 ctrlPV force axis 0 0 1 target_val -1 vel_max 1 kp 1
variable s string plate
variable shape string 'mesh n_meshes 1 meshes plate'
END
refused servo 'mesh/surface/stress/servo plate reads resolved contacts only' -in in.jet -var impact exact -var h 1e-8 -var n 1 \
	-var e 0.8 -var mu 0.3 -var spin 1 -var length 1 -var mass 1 -var law "$hertz"

finish
