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
[ -s hertz.history ] && [ -s hertz.incremental_history ] && ! cmp -s hertz.history hertz.incremental_history
report 'with k_t that changes they are not' $?

# Grains of the radii 10 and 12 mm and the modulus E_c: k_n = 4 E_c R*, k_t = k_n/1.5, the dashpot of e = 0.61.
properties="$properties
fix k5 all property/global contactModulus peratomtypepair 2 1.1e6 1.1e6 1.1e6 1.1e6
fix k6 all property/global contactStiffnessRatio peratomtypepair 2 1.5 1.5 1.5 1.5"
reduced='(0.010*0.012/0.022)'
masses='(4/3*PI*2385*0.01^3*1900*0.012^3/(2385*0.01^3+1900*0.012^3))'
gamma="sqrt(4*4*1.1e6*$reduced/$masses*ln(0.61)^2/(ln(0.61)^2+PI^2))"
energies 'hooke/modulus' modulus 'pair_style gran model hooke/modulus tangential history' 'pair_coeff * *'
properties=$(echo "$properties" | grep -v '^fix k[1-4]')
energies 'hooke/stiffness with its constants' stiffness \
	"fix k1 all property/global kn peratomtypepair 2 \$(4*1.1e6*$reduced) 1 1 1" \
	"fix k2 all property/global kt peratomtypepair 2 \$(4*1.1e6*$reduced/1.5) 1 1 1" \
	"fix k3 all property/global gamman peratomtypepair 2 \$($gamma) 1 1 1" \
	"fix k4 all property/global gammat peratomtypepair 2 \$($gamma) 1 1 1" \
	'pair_style gran model hooke/stiffness tangential history' 'pair_coeff * *'
alike 'the grains of hooke/modulus are springs in series' 1e-10 modulus stiffness
rejects "$(printf '%s\n' "$(scene 1 2 | grep -v ' k6 ')" 'pair_style gran model hooke/modulus' 'pair_coeff * *' 'run 0')" \
	'contactStiffnessRatio'

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
# Meshes hold as planes do, wherever the contact is. Grain 3 is on a plane, the others on a mesh.
sticky() { # HEIGHT PLACE...
	local height=$1 place
	shift
	scene 1 2
	printf '%s\n' "$undamped" 'pair_style gran model jkr' 'pair_coeff * *' 'unfix move' 'delete_atoms group all' \
		'create_atoms 1 single 0 0 0.00999 units box' 'group plane id 3'
	for place; do echo "create_atoms 1 single $place $height units box"; done
	echo 'set type 1 diameter 0.02 density 2385
group mesh subtract all plane'
}
on_mesh() { # FILE
	echo "fix cad all mesh/surface file $work/$1 type 2
fix floor plane wall/gran model jkr primitive type 2 zplane 0
fix part mesh wall/gran model jkr mesh n_meshes 1 meshes cad"
}
pulled='group last id 8
group still subtract all last
fix away still move linear 0 0 0.01
fix aslant last move linear -0.2 -0.1 0.01
variable pull equal -fz[3]
variable off equal abs(fz[4]-fz[3])+abs(fz[5]-fz[3])+abs(fz[6]-fz[3])+abs(fz[7]-fz[3])+abs(fz[8]-fz[3])
fix pulls all vector 1 v_pull v_off'
plate 4 0 >plate.stl
agree 'a mesh holds as a plane does' "$(sticky 0.00999 '0.08 0.15' '0.125 0.125' '0 0.1' '0 0' '0.001 0.0007'; on_mesh plate.stl)
$pulled
run 1000
write_restart $work/half.restart
run 2000
print \"is pull \$(abs(max(f_pulls[1])/(1.5*PI*4*0.01)-1)<1e-3) 1\"
print \"is off \$(max(f_pulls[2])<1e-15) 1\"
print \"is apart \$(fz[8]) 0\""
# at the restart all hold beyond their touch
agree 'and goes on after a restart' "read_restart $work/half.restart
$properties
$undamped
pair_style gran model jkr
pair_coeff * *
timestep 2e-6
$(on_mesh plate.stl)
$pulled
run 1
print \"is holding \$(v_pull>0.1) 1\"
print \"is off \$(v_off<1e-15) 1\"
run 1999
print \"is apart \$(fz[8]) 0\""

# over a convex edge, and a corner, of a block: grain 3 is as far from the plane at the end
cuboid 0.2 0.2 0.1 >block.stl
agree 'over edges and corners' "$(sticky 0.10999 '0.1999 0.05' '-0.1999 0.05' '0.03 0.1999' '0.03 -0.1999' \
	'0.1999 0.1999' '-0.1999 -0.1999' '0.1999 -0.1999' '-0.1999 0.1999'; on_mesh block.stl)
variable out equal 5e-4/0.012
variable up equal 1e-5/0.012
variable far equal (sqrt(0.01^2+0.0004^2)-0.00999)/0.012
fix m3 plane move linear 0 0 \$(v_far)
group g4 id 4
fix m4 g4 move linear \$(v_out) 0 \$(v_up)
group g5 id 5
fix m5 g5 move linear \$(-v_out) 0 \$(v_up)
group g6 id 6
fix m6 g6 move linear 0 \$(v_out) \$(v_up)
group g7 id 7
fix m7 g7 move linear 0 \$(-v_out) \$(v_up)
group g8 id 8
fix m8 g8 move linear \$(v_out) \$(v_out) \$(v_up)
group g9 id 9
fix m9 g9 move linear \$(-v_out) \$(-v_out) \$(v_up)
group g10 id 10
fix m10 g10 move linear \$(v_out) \$(-v_out) \$(v_up)
group g11 id 11
fix m11 g11 move linear \$(-v_out) \$(v_out) \$(v_up)
variable f atom sqrt(fx^2+fy^2+fz^2)
run 6000
variable edge equal v_f[3]
print \"is pulled \$(fz[3]<-0.1) 1\"
$(for k in 4 5 6 7; do echo "print \"is edge \$(abs(v_f[$k]/v_edge-1)<1e-9) 1\""; done)
unfix m3
fix m3 plane move linear 0 0 \$((sqrt(0.01^2+2*0.0004^2)-z[3])/2e-6)
$(for k in 4 5 6 7 8 9 10 11; do echo "unfix m$k"; done)
fix rest mesh move linear 0 0 0
run 1
$(for k in 8 9 10 11; do echo "print \"is corner \$(abs(v_f[$k]/v_f[3]-1)<1e-9) 1\""; done)"
finish
