#!/bin/bash
# Laws of pair_style gran that LIGGGHTS 3.8 does not have, against those of pair_style granular, which LAMMPS has, and
# against exact numbers: model jkr, tangential jkr_tan and incremental_history; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"

properties='fix p1 all property/global youngsModulus peratomtype 6e6 8e6
fix p2 all property/global poissonsRatio peratomtype 0.3 0.2
fix p3 all property/global coefficientRestitution peratomtypepair 2 0.61 0.61 0.61 0.61
fix p4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
fix p5 all property/global workOfAdhesion peratomtypepair 2 3 4 4 5
fix p6 all property/global resolutionJKR scalar 1e-4'

# two spheres of types A and B collide obliquely
scene() { # A B
	echo "units si
atom_style granular
newton off
communicate single vel yes
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
create_atoms $1 single 0 0 0 units box
create_atoms $2 single 0.021 0.0031 0.0012 units box
set atom 1 diameter 0.02 density 2385
set atom 2 diameter 0.024 density 1900
velocity all set 0 0 0
set atom 2 vx -0.2 vy 0.1 omegaz 7
neighbor 0.001 bin
fix move all nve/sphere
timestep 2e-6
$properties"
}

# E and nu of one material give Y* and G*; the surface energy is half the work of adhesion
shear='(6e6/(4*(2-0.3)*(1+0.3)))'
effective='(6e6/(2*(1-0.3^2)))'
ends='thermo_style custom step ke erotate pe
thermo_modify format float %.15g
thermo 500
run 4000'
energies() { # WHAT FILE LAW...: rows of the table of the collision
	local what=$1 file=$2
	shift 2
	{ scene 1 1 && printf '%s\n' "$@" "$ends"; } >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "$what" $? out
	rows out >"$file"
}
alike() { # WHAT WITHIN FILE FILE: nine rows of three numbers
	[ "$(wc -l <"$3")" = 9 ] && paste "$3" "$4" | awk -v within="$2" '
		{ for (k = 2; k <= 4; k++) { d = $k - $(k + 4); if (!(d * d <= (within * $k) ^ 2)) { print; bad = 1 } } }
		END { exit bad }' >out 2>&1
	report "$1" $? out
}
# the number whose dashpot by tsuji is sqrt(5) |ln e|/sqrt(ln^2 e + pi^2), e = 0.61
tsuji=$(awk 'BEGIN {
	l = log(0.61); want = sqrt(5) * -l / sqrt(l * l + 4 * atan2(1, 1) * 4 * atan2(1, 1)); lo = 0.1; hi = 1
	for (k = 0; k < 60; k++) {
		e = (lo + hi) / 2
		if (1.2728 - 4.2783*e + 11.087*e^2 - 22.348*e^3 + 27.467*e^4 - 18.022*e^5 + 4.8218*e^6 > want) lo = e; else hi = e
	}
	printf "%.17g", e }')
jkr="pair_coeff * * jkr 6e6 $tsuji 0.3 1.5"
energies 'model jkr runs' gran 'pair_style gran model jkr' 'pair_coeff * *'
energies 'jkr of pair granular runs' granular 'pair_style granular' "$jkr tangential linear_nohistory 0 0 damping tsuji"
alike 'model jkr is jkr of pair granular, whose surface energy is half the work of adhesion' 1e-10 gran granular
# pair granular has the arms of the radii, here they are shorter by half the overlap
energies 'jkr_tan runs' gran 'pair_style gran model jkr tangential jkr_tan' 'pair_coeff * *'
energies 'mindlin runs' granular 'pair_style granular' \
	"$jkr tangential mindlin NULL \$(2*sqrt($shear/$effective)) 0.4 damping tsuji"
alike 'jkr_tan is mindlin but for the arms' 0.04 gran granular

# With a constant stiffness both memories are the same; with Hertz' they are not.
properties="$properties
fix k1 all property/global kn peratomtypepair 2 3e4 3e4 3e4 3e4
fix k2 all property/global kt peratomtypepair 2 2e4 2e4 2e4 2e4
fix k3 all property/global gamman peratomtypepair 2 20 20 20 20
fix k4 all property/global gammat peratomtypepair 2 10 10 10 10"
for memory in history incremental_history; do
	energies "hooke/stiffness, $memory" hooke.$memory \
		"pair_style gran model hooke/stiffness tangential $memory" 'pair_coeff * *'
	energies "hertz, $memory" hertz.$memory "pair_style gran model hertz tangential $memory" 'pair_coeff * *'
done
alike 'a constant k_t: increments of the force are those of the slip' 1e-10 hooke.history hooke.incremental_history
! cmp -s hertz.history hertz.incremental_history
report 'with k_t that changes they are not' $?

# Two spheres of unlike materials are pressed together and pulled apart slowly with a tangential load that sticks; the
# force of incremental_history is the integral of k_t over the slip: after loading at one depth and turning
# back to another it is that of the first depth.
agree 'incremental_history keeps the force when k_t changes' "$(scene 1 2)
pair_style gran model hertz tangential incremental_history tangential_damping off
pair_coeff * *
set atom 1 x 0 y 0 z 0
set atom 2 x 0.0218 y 0 z 0 vx 0 vy 0 omegaz 0
unfix move
group two id 2
fix side two move linear 0 0.001 0
run 200
variable was equal \$(fy[1])
unfix side
fix deeper two move linear -0.05 0 0
run 500
print \"is kept \$(abs(fy[1]/v_was-1)<2e-3) 1\"
print \"is force \$(v_was>0) 1\""

undamped='fix p3 all property/global coefficientRestitution peratomtypepair 2 1 1 1 1'
# surfaces of unlike materials part at 3/2 pi W R*, pulled apart slowly
agree 'a pair parts at 3/2 pi W R*' "$(scene 1 2)
$undamped
pair_style gran model jkr
pair_coeff * *
set atom 1 x 0 y 0 z 0
set atom 2 x 0.02199 y 0 z 0 vx 0 vy 0 omegaz 0
unfix move
group two id 2
fix away two move linear 0.01 0 0
variable pull equal fx[1]
fix pulls all vector 1 v_pull
run 4000
print \"is pull \$(abs(max(f_pulls)/(1.5*PI*4*0.01*0.012/0.022)-1)<1e-3) 1\"
print \"is apart \$(fx[1]) 0\""
agree 'and from a plane' "$(scene 1 2)
$undamped
pair_style gran model jkr
pair_coeff * *
set atom 1 x 0 y 0 z 0
set atom 2 x 0.5
unfix move
fix plane all wall/gran model jkr primitive type 2 xplane -0.00999
fix away all move linear 0.01 0 0
variable pull equal -fx[1]
fix pulls all vector 1 v_pull
run 6000
print \"is pull \$(abs(max(f_pulls)/(1.5*PI*4*0.01)-1)<1e-3) 1\"
print \"is apart \$(fx[1]) 0\""

one() { # LAW: what follows is refused
	printf '%s\n' "$(scene 1 2)" "pair_style gran $1" 'pair_coeff * *' 'run 0'
}
rejects "$(one 'model hertz tangential jkr_tan')" "'jkr_tan' belongs to model jkr"
rejects "$(one 'model jkr tangential history cohesion sjkr')" 'model jkr has its own adhesion'
rejects "$(one 'model jkr limitForce on')" "'limitForce' does not go with model jkr"
rejects "$(one 'model jkr located yes')" "'located' belongs to a normal model without adhesion"
rejects "$(one 'model hertz tangential incremental_history located yes')" 'history or no_history'
plate 2 0 >plate.stl
for law in 'pair_style gran model jkr;pair_coeff * *;fix w all wall/gran model jkr' \
	'pair_style granular;pair_coeff * * jkr 6e6 0.6 0.3 1.5 tangential linear_nohistory 0 0;fix w all wall/gran'; do
	rejects "$(scene 1 2)
fix m all mesh/surface file $work/plate.stl type 1
$(tr ';' '\n' <<<"$law") mesh n_meshes 1 meshes m
run 0" 'contacts with triangles do not follow'
done
finish
