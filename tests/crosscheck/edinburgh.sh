#!/bin/bash
# Model edinburgh by LIGGGHTS 3.8, an independent program: a sphere that is led into another one and out, several times, at three
# exponents, with friction and rolling; and a cloud of grains that collide and stick.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3

start='units si
atom_style granular
atom_modify map array
newton off
communicate single vel yes'
# script LAW N CHI KAPPA W F0: on standard input the particles; after it the runs
script() {
	local law=$1
	shift
	echo "$start"
	sed '/^run/,$d' scene
	echo "fix m1 all property/global youngsModulus peratomtype 5e6 7e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.2
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.2 0.2 0.4
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix m6 all property/global coefficientAdhesionStiffness peratomtypepair 2 0.5 0.5 0.5 0.5
fix e1 all property/global overlapExponent scalar $1
fix e2 all property/global adhesionExponent scalar $2
fix e3 all property/global UnloadingStiffness peratomtypepair 2 $3 $3 $3 $3
fix e4 all property/global surfaceEnergy peratomtypepair 2 $4 $4 $4 $4
fix e5 all property/global pullOffForce peratomtypepair 2 $5 $5 $5 $5
pair_style gran model edinburgh $law
pair_coeff * *"
	sed -n '/^run/,$p' scene | sed 1d
}
# agrees WHAT MOST LAW N CHI KAPPA W F0
agrees() {
	local what=$1 most=$2
	shift 2
	script "$@" >in.both
	for who in liggghts tsim; do
		if [ $who = tsim ]; then
			"$TSIM" -in in.both -legacy -log none >out 2>&1
		else
			liggghts -in in.both -log none >out 2>&1
		fi
		report "$what: $who" $? out
		sed '/BOX BOUNDS/,+3d' both.dump >$who.dump
		rm -f both.dump
	done
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" liggghts.dump tsim.dump "$most" >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
}
led() { # VY OMEGA
	echo 'boundary f f f
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 2 box
neighbor 0.002 bin
neigh_modify delay 0
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.0090001 0 0 units box
set atom 1 diameter 0.01 density 2500
set atom 2 diameter 0.008 density 2000
group two id 2
run
timestep 1e-6
fix move all nve/noforce
dump d all custom 20 both.dump id x y fx fy fz tqx tqy tqz
dump_modify d sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"'
	for step in '-0.01 1500' '0.01 1000' '-0.01 100' '0.01 300' '-0.01 50' '0.01 50' '-0.01 500' '0.01 1100' '-0.01 1300' '0.01 500' '-0.01 20' \
		'0.01 200' '-0.01 100'; do
		printf 'velocity two set %s %s 0 units box\n' "${step% *}" "$1"
		[ "$2" = 0 ] || printf 'set atom 2 omegaz %s\n' "$2"
		echo "run ${step#* }"
	done
}
led 0 0 >scene
for set in '1.5 1.5 3 1 0' '1.5 1.5 3 10 -1e-4' '1.5 1 3 30 0' '1 1 3 5 1e-4' '1 1.5 3 60 0' '2 1.5 6 0.03 0' '1.5 1.5 1.3 4 0'; do
	# shellcheck disable=SC2086
	agrees "normal, $set" 1e-10 '' $set
done
led 0.02 20 >scene
for law in 'tangential history' 'tangential no_history' 'tangential history cohesion sjkr2' 'tangential history rolling_friction epsd2'; do
	[ "${law/sjkr2/}" = "$law" ] || sed -i 's/^run$/fix m7 all property\/global cohesionEnergyDensity peratomtypepair 2 1e4 1e4 1e4 1e4\nrun/' scene
	agrees "$law" 1e-9 "$law" 1.5 1.5 3 2 0
done
# without a new list, with which contacts of LIGGGHTS get other histories
echo 'boundary p p p
region box block 0 0.012 0 0.012 0 0.012 units box
create_box 2 box
lattice sc 0.002
create_atoms 1 box
set group all diameter 1.9e-3 density 2500
group two id 1:216:3
set group two type 2
set group two diameter 1.8e-3
neighbor 0.003 bin
neigh_modify delay 0
run
timestep 2e-6
fix move all nve/sphere
variable u atom 1.5*sin(1000*x+777000*y*z)
variable v atom 1.5*sin(1300*y+977000*x*z+1)
velocity all set v_u v_v v_u units box
dump d all custom 50 both.dump id x y z vx vy vz omegax omegay omegaz
dump_modify d sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
run 300' >scene
agrees 'a cloud' 1e-8 'tangential history rolling_friction epsd2' 1.5 1.5 3 2 0
finish
