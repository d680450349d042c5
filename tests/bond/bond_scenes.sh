#!/bin/bash
# Bonds with what else a scene has: a box that changes, types and bonds that come in a run, other commands.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# scene BOUNDARY: bonds of two types of particles
scene() {
	echo "units si
boundary $1
region box block 0 1 0 1 0 1 units box
create_box 2 box bond/types 2
neighbor 0.01 bin"
}

# A periodic chain that is stretched homogeneously: the dashpot of the bond across the face is that of the others.
# chain STYLE COEFFICIENTS
chain() {
	echo "$(scene 'p p p')
$(for k in 0 1 2 3 4 5 6 7 8 9; do echo "create_atoms 1 single 0.${k}5 0.5 0.5 units box"; done)
set group all diameter 0.05 density 2500
bond_style $1
bond_coeff 1 $2
bond_coeff 2 $2
create_bonds many all all 1 0 0.11
fix stretch all deform 1 x erate 0.5 remap v
velocity all ramp vx -0.25 0.25 x 0 1 units box
fix move all nve/sphere
timestep 1e-5
compute b all bond/local force
compute least all reduce min c_b
compute most all reduce max c_b
run 0
print \"\$(bonds) bonds, difference \$(1e-12*round(1e12*(c_most-c_least)/c_most)), force \$(c_most:%.6g)\""
}
prints "$(chain contact 'stiffness 1000 ultimate 1e9 damping 50')" '10 bonds, difference 0, force -2.5'
prints "$(chain bpm/spring '1000 1 50')" '10 bonds, difference 0, force -2.5'
prints "$(chain parallel 'kn 1e6 ks 1e6 damping 0.3')" '10 bonds, difference 0, force -0.380229'
prints "$(chain bpm/rotational '1e6 1e5 1 1 1e9 1e9 1e9 1e9 50 5 0.1 0.1')
print \"same \$(abs(c_most-c_least)<1e-9*abs(c_most))\"" 'same 1'

# A type that particles get in a run has contact laws, although none had it before.
materials='fix m1 all property/global youngsModulus peratomtype 1e7 4e7
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5'
# F = 4/3 E* sqrt(R*) overlap^(3/2), E* = Y/(2 (1 - nu^2))
prints "$(scene 'f f f')
create_atoms 1 single 0.4 0.5 0.5 units box
create_atoms 1 single 0.499 0.5 0.5 units box
set group all diameter 0.1 density 2500
$materials
pair_style gran model hertz tangential history
pair_coeff * *
bond_style contact
bond_coeff 1*2 stiffness 1e4 ultimate 1e9
fix join all bond/create 7 1 1 0.11 1 iparam 1 2 jparam 1 2
fix move all nve/sphere
timestep 1e-9
run 8
variable expected equal -4/3*4e7/(2*(1-0.09))*sqrt(0.025)*0.001^1.5
print \"type \$(type[1]) force \$(fx[1]/v_expected:%.3f)\"" 'type 2 force 1.000'

# Bonds that a run makes need coefficients, temperatures, partners that turn, and the right special_bonds.
pair="$(scene 'f f f')
create_atoms 1 single 0.4 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2500
fix move all nve/sphere
timestep 1e-5
fix join all bond/create 10 1 1 0.105 2"
rejects "$pair
bond_style contact
bond_coeff 1 stiffness 1000 ultimate 1e9
run 20" 'fix bond/create makes bonds of type 2, but there is no'
rejects "$pair
bond_style gran
bond_coeff 1*2 1 0 1e6 1e6 0 0 2 1e9 1e9 350
run 20" 'break style 2 needs the temperatures'
rejects "$pair
bond_style bpm/spring overlay/pair yes
bond_coeff 1*2 500 0.1 1
pair_style gran/hooke 1e3 NULL 1 NULL 0.5 0
pair_coeff * *
special_bonds lj 0 1 1 coul 1 1 1
run 20" 'overlay/pair yes contradicts special_bonds'
rejects "$(grep -v nve/sphere <<<"$pair")
create_atoms 1 single 0.6 0.5 0.5 units box
set atom 3 diameter 0.1 density 2500
group body id 2 3
group one id 1
fix body body rigid single
fix one one nve/sphere
bond_style parallel
bond_coeff 1*2 kn 1e3 ks 1e3
run 20" 'belongs to a rigid body'

# Which image of its partner a bond holds is ambiguous at half the box.
for style in 'contact stiffness 1000 ultimate 1e9' 'harmonic 500 0.1' 'bpm/spring 1000 100 0' 'parallel kn 1e3 ks 1e3'; do
	rejects "$(scene 'p p p')
create_atoms 1 single 0.2 0.5 0.5 units box
create_atoms 1 single 0.3 0.5 0.5 units box
set group all diameter 0.05 density 2500
bond_style ${style%% *}
bond_coeff 1*2 ${style#* }
create_bonds single/bond 1 1 2
group a id 1
group b id 2
fix a a move linear 0 0 0
fix b b move linear 1 0 0
timestep 1e-3
run 500" 'about half the periodic box of 1'
done

# Spheres side by side touch wherever they are.
prints "$(scene 'f f f')
$(for k in 0 1 2 3 4 5 6 7 8; do echo "create_atoms 1 single \$(0.003+0.1*$k) 0.5 0.5 units box"; done)
set group all diameter 0.1 density 2500
bond_style contact
bond_coeff 1*2 stiffness 1 ultimate 1e9
create_bonds gap all all 1 0
print \"\$(bonds) bonds\"" '8 bonds'

# Dumps have no orientations.
prints "$(scene 'f f f')
create_atoms 1 single 0.4 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2500
bond_style parallel
bond_coeff 1*2 kn 1e3 ks 1e3
create_bonds single/bond 1 1 2
fix move all nve/sphere
timestep 1e-5
dump d all custom 10 d.dump id type x y z
run 10
undump d
unfix move
rerun d.dump dump x y z" '*dumps have no orientations'

# Bonds of cohesion that are made in one step, which reset_timestep makes come again.
prints "$(scene 'f f f')
create_atoms 1 single 0.2 0.5 0.5 units box
create_atoms 1 single 0.4 0.5 0.5 units box
set group all diameter 0.1 density 2500
group b id 2
$materials
fix k1 all property/global normalBondStiffnessPerUnitArea peratomtypepair 2 1e8 1e8 1e8 1e8
fix k2 all property/global tangentialBondStiffnessPerUnitArea peratomtypepair 2 4e7 4e7 4e7 4e7
fix k3 all property/global maxSigmaBond peratomtypepair 2 1e9 1e9 1e9 1e9
fix k4 all property/global maxTauBond peratomtypepair 2 1e9 1e9 1e9 1e9
fix k5 all property/global tsCreateBond scalar 1
fix k6 all property/global createDistanceBond peratomtypepair 2 0.11 0.11 0.11 0.11
pair_style gran model hertz tangential history cohesion bond stressBreak on dampingBond off
pair_coeff * *
fix move all nve/sphere
timestep 1e-6
run 1
reset_timestep 0
displace_atoms b move -0.095 0 0 units box
run 2
print \"\$(bonds) bonds\"" '1 bonds'
finish
