#!/bin/bash
# `cohesion bond` of pair_style gran: scripts, refused input, outputs by known answers.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.properties <<'END2'
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m6 all property/global normalBondStiffnessPerUnitArea peratomtypepair 1 1e9
fix m7 all property/global tangentialBondStiffnessPerUnitArea peratomtypepair 1 4e8
fix m8 all property/global maxDistanceBond peratomtypepair 1 0.5
fix m9 all property/global dampingNormalForceBond peratomtypepair 1 0
fix m10 all property/global dampingTangentialForceBond peratomtypepair 1 0
fix m11 all property/global dampingNormalTorqueBond peratomtypepair 1 0
fix m12 all property/global dampingTangentialTorqueBond peratomtypepair 1 0
fix m13 all property/global tsCreateBond scalar 1
fix m14 all property/global createDistanceBond peratomtypepair 1 1.05e-3
END2
cat >in.chain <<'END2'
# as in.chain_bending of LIGGGHTS-INL: five spheres along z, the first held
echo both
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
hard_particles yes
region reg_domain block -0.005 0.005 -0.005 0.005 -0.001 0.008 units box
create_box 1 reg_domain
neighbor 5e-4 bin
neigh_modify delay 0
include in.properties
END2
cat >in.spheres <<'END2'
create_atoms 1 single 0 0 0
create_atoms 1 single 0 0 0.001
create_atoms 1 single 0 0 0.002
create_atoms 1 single 0 0 0.003
create_atoms 1 single 0 0 0.004
set group all density 1000 diameter 0.001
group head id 1
group tip id 5
timestep 2e-7
END2
cat >in.run <<'END2'
fix bound_head head freeze
fix bound_end tip addforce 1e-6 0 0
fix VISC all viscous 2.2e-3
fix turn all viscous/sphere 2.2e-10
fix integrsp all nve/sphere
fix ts all check/timestep/gran 200 0.2 0.2
compute bond_status all bond/counter
compute bond_force all pair/gran/local/bond
variable i_disp equal x[5]
thermo_style custom step atoms ke cpu time f_ts[1] f_ts[2] c_bond_status[3] v_i_disp
thermo 20000
thermo_modify lost ignore norm no
dump dmp1 all custom/vtk 20000 balls*.vtk id type x y z vx vy vz fx fy fz omegax omegay omegaz radius
dump dmp3 all local/gran/vtk 20000 fbnd*.vtk bond_force
END2

# P L^3/(3 E I) (1 - 1/(4 N^2)) + P L/(G A), E = kn l, G = kt l, N = 4
agree 'a cantilever' 'include in.chain
pair_style gran model hertz tangential history cohesion bond
pair_coeff * *
include in.spheres
include in.run
run 60000
variable L equal 4e-3
variable I equal PI*(5e-4)^4/4
variable A equal PI*(5e-4)^2
variable exact equal 1e-6*v_L^3/(3e6*v_I)*(1-1/64)+1e-6*v_L/(4e5*v_A)
print "is deflection $(round(x[5]/v_exact*1e3)) 1e3"
print "is bonds $(c_bond_status[3]) 4"'
grep -q '^CELL_DATA 4' fbnd20000.vtk
report 'bonds in the VTK file' $? fbnd20000.vtk

# the numbers of created and broken bonds since the last output in a run; set-up is none
cat >in.counter <<'END2'
include in.chain
pair_style gran model hertz tangential history cohesion bond stressBreak on
pair_coeff * *
fix m15 all property/global maxSigmaBond peratomtypepair 1 1e3
fix m16 all property/global maxTauBond peratomtypepair 1 1e3
include in.spheres
fix integrsp all nve/sphere
compute n all bond/counter
thermo_style custom step c_n[1] c_n[2] c_n[3] c_n[4]
thermo 10
END2
# counter_rows [LINES]: the thermo output of a run in which bonds form and break; with other readers
counter_rows() {
	printf '%s\n' 'include in.counter' "$@" 'run 10' 'set atom 5 z 0.00401' 'set atom 3 z 0.00199' 'run 20' >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	rows out | awk '{ print $1, $2, $3, $4, $5 }' >found
}
counter_rows
printf '%s\n' '0 0 0 0 0' '10 4 0 4 0' '10 0 3 1 0' '20 0 3 1 0' '30 0 0 1 0' >expected
same 'bond/counter' expected found
# other readers take no counts away, in the steps of thermo output or in others
counter_rows 'fix mean all ave/time 1 5 5 c_n[3]' 'fix said all print 5 "counts $(c_n[1])"'
same 'bond/counter with other readers' expected found
grep '^counts' out | head -n 2 >found
printf '%s\n' 'counts 4' 'counts 4' >expected
same 'bond/counter read by fix print' expected found

# columns of a bond: positions, velocities, IDs, force, torque, area, overlap
agree 'pair/gran/local/bond' 'include in.chain
special_bonds lj 0 1 1 coul 1 1 1
pair_style gran model hertz tangential history cohesion bond
pair_coeff * *
include in.spheres
fix integrsp all nve/sphere
delete_atoms group tip
run 1
set atom 4 z 0.003004
run 0
compute c all pair/gran/local/bond pos id force delta contactPoint
compute s all reduce sum c_c[3] c_c[7] c_c[8] c_c[12] c_c[13] c_c[16]
run 0
print "is z $(c_s[1]:%.12g) 0.003"
print "is id $(c_s[2]) 6"
print "is id $(c_s[3]) 9"
print "is force $(c_s[4]:%.9g) $(1e9*PI*2.5e-7*4e-6:%.9g)"
print "is delta $(c_s[5]*1e12:%.6g) -4000000"
print "is points $(c_s[6]:%.12g) 0.004502"'

rejects() { # SCRIPT TEXT
	printf 'include in.chain\n%s\npair_coeff * *\ninclude in.spheres\nrun 1\n' "$1" >in.script
	refused "rejects: $2" "$2" -in in.script
	refused "rejects, -check: $2" "$2" -check -in in.script
}
gran='pair_style gran model hertz tangential history'
rejects "$gran cohesion bond dissipationBond on" 'dissipationBond on is not supported'
rejects "$gran cohesion bond druckerPrager on" 'druckerPrager on is not supported'
rejects "$gran cohesion bond dampingBondSmooth on" 'dampingBondSmooth on is not supported'
rejects "$gran cohesion bond temperatureBreak on" 'temperatureBreak on is not supported'
rejects "$gran cohesion bond disableNormalWhenBonded on" 'special_bonds lj 0 1 1'
rejects "$gran cohesion bond tangential_reduce on" "'tangential_reduce' belongs to"
rejects "$gran stressBreak on" "'stressBreak' belongs to cohesion bond"
rejects "$gran stressBreak on cohesion bond" "'cohesion' must stand before"
rejects "$gran cohesion bond/nonlinear" 'no description of its law is public'
rejects "$gran cohesion bond
unfix m6" 'needs `fix ID all property/global normalBondStiffnessPerUnitArea'
rejects "$gran cohesion bond stressBreak on" 'property/global maxSigmaBond'
rejects "fix m9 all property/global dampingNormalForceBond peratomtypepair 1 1.2
$gran cohesion bond" 'dampingNormalForceBond is 1.2, expected a number >= 0 and < 1'
rejects "bond_style contact
$gran cohesion bond" 'bond_style contact is in use'
rejects "$gran cohesion bond
bond_style contact
bond_coeff 1 stiffness 1 ultimate 1" 'they were replaced by bond_style contact'
printf '%s\n' 'include in.chain' 'pair_style gran model hertz tangential history cohesion bond' 'bond_style contact' \
	'include in.spheres' 'run 1' >in.script
refused 'replaced bonds, no pair_coeff' 'they were replaced by' -check -in in.script
rejects "$gran
fix w all wall/gran model hertz tangential history cohesion bond primitive type 1 zplane 0" 'bonds with walls are not supported'
rejects "$gran cohesion bond
fix w all wall/gran model hertz tangential history stressBreak on primitive type 1 zplane 0" "belongs to cohesion bond"
finish
