#!/bin/bash
# A gas of spinning spheres that meet each other and walls obliquely: from table to table its energy - of
# motion, of rotation, stored in contacts - does not grow, with any contact law. The laws by themselves:
# tests/energy/check_energy.c.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.gas <<'END'
units si
boundary f f f
newton off
region b block 0 0.1 0 0.1 0 0.1 units box
create_box 2 b
lattice sc 0.0231
region inner block 0.01 0.09 0.01 0.09 0.01 0.09 units box
create_atoms 1 region inner
set group all diameter 0.0097 density 2385
set group all type/fraction 2 0.4 20233
variable wx atom 300*sin(17*id)
variable wy atom 300*sin(23*id)
variable vx atom sin(31*id)
variable vz atom sin(37*id)
set group all omegax v_wx omegay v_wy vx v_vx vz v_vz
fix m1 all property/global youngsModulus peratomtype 5.31e7 7.77e7
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.73 0.61 0.61 0.53
fix m4 all property/global coefficientFriction peratomtypepair 2 0.17 0.31 0.31 0.41
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.053 0.11 0.11 0.21
fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.051 0.12 0.12 0.23
fix m7 all property/global characteristicVelocity scalar 1.37
fix m8 all property/global rollingStiffness scalar 1.7
pair_style ${pair}
pair_coeff * *
fix w1 all wall/gran ${law} primitive type 2 xplane 0
fix w2 all wall/gran ${law} primitive type 2 xplane 0.1
fix w3 all wall/gran ${law} primitive type 2 yplane 0
fix w4 all wall/gran ${law} primitive type 2 yplane 0.1
fix w5 all wall/gran ${law} primitive type 2 zplane 0
fix w6 all wall/gran ${law} primitive type 2 zplane 0.1
fix move all nve/sphere
timestep 2e-6
thermo_style custom step atoms ke erotate pe
thermo_modify format float %.17g norm no
thermo 1500
run 60000
END
energies() { # LAW [PAIR]: the law of walls, and of pairs if that is another
	"$TSIM" -in in.gas -log gas.log -screen none -var law "$1" -var pair "${2:-gran $1}" 2>err
	report "$1 ${2-}" $? err
	rows gas.log | awk '{ e = $3 + $4 + $5; n++
		if (n == 1) first = e
		if (n > 1 && e > last + 1e-3 * first) { print "grows at step", $1, "from", last, "to", e; bad = 1 }
		last = e }
		END { print "from", first, "to", last; exit bad || !(last < 0.8 * first) || !(last > 0) }' >grown
	report "${2:-$1}: never grows, falls" $? grown
}
for law in 'model hertz tangential history' 'model hertz tangential no_history rolling_friction cdt' \
	'model hooke tangential history rolling_friction epsd' 'model hooke tangential history rolling_friction epsd3' \
	'model hertz tangential history rolling_friction epsd2'; do
	energies "$law"
done
energies 'model hertz tangential history' 'gran/hertz/history 5e7 NULL 3e7 NULL 0.4 1'
energies 'model hertz tangential history' 'gran/hooke/history 1e5 NULL 3e3 NULL 0.4 1'
finish
