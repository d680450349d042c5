#!/bin/bash
# Bonds of bond_style harmonic: an oscillation, which the integrator solves exactly; their length is the one given.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

two='units lj
atom_style hybrid sphere bond
boundary f f f
newton off
comm_modify vel yes
region box block -3 3 -3 3 -3 3 units box
create_box 1 box bond/types 2
neighbor 0.3 bin
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 1.3 0 0 units box
set group all diameter 1 density 2
bond_style harmonic'
# Mass 1/w^2 of the reduced mass: x_n = a cos(n theta), cos theta = 1 - (w dt)^2/2 (velocity Verlet from rest).
motion='thermo_modify norm no
fix 1 all nve/sphere
timestep 0.004
compute b all bond/local dist rest engpot force
compute s all reduce sum c_b[1] c_b[2] c_b[3] c_b[4]
run 100
variable m equal PI/6*2/2
variable a equal 0.2*cos(100*acos(1-0.004^2*100/v_m/2))
print "is length $(c_s[1]) $(1.1+v_a)"
print "is rest $(c_s[2]) 1.1"
print "is energy $(c_s[3]) $(50*v_a^2) 2"
print "is pe $(pe) $(50*v_a^2) 2"
print "is force $(c_s[4]) $(-100*v_a) 20"'
agree 'an oscillation' "$two
bond_coeff 1 50 1.1
create_bonds single/bond 1 1 2
$motion"
agree 'coefficients behind the bond' "$two
create_bonds single/bond 1 1 2
bond_coeff * 7 0.3
bond_coeff 1 50 1.1
$motion"
agree 'after another length' "$two
bond_coeff 1 20 0.4
create_bonds single/bond 1 1 2
fix hold all move linear 0 0 0
timestep 0.004
run 3
unfix hold
bond_coeff 1 50 1.1
$motion"
agree 'after a restart' "$two
bond_coeff 1 50 1.1
create_bonds single/bond 1 1 2
write_restart two.restart
clear
newton off
comm_modify vel yes
atom_style hybrid sphere bond
read_restart two.restart
bond_style harmonic
neighbor 0.3 bin
$motion"
# Its force acts in the second half of the first step only.
agree 'a bond made within a run' "$two
bond_coeff 1 50 1.1
fix make all bond/create 1 1 1 1.4 1
$(sed 's/^run 100/run 1\nunfix make\nrun 99/; s/cos(100\*\(.*\))$/cos(99.5*\1)\/cos(0.5*\1)/' <<<"$motion")"
# Another style: the rest length is the distance when the bond was created, also after a restart and in copies.
lengths='compute b all bond/local rest
compute s all reduce max c_b
thermo_style custom step c_s
run 0'
agree 'a style without given lengths' "$two
bond_coeff 1 50 1.1
create_bonds single/bond 1 1 2
fix 1 all nve/sphere
$lengths
print \"is given \$(c_s) 1.1\"
write_restart two.restart
bond_style contact
bond_coeff 1 stiffness 50 ultimate 1e9
run 0
print \"is made \$(c_s) 1.3\"
bond_style harmonic
bond_coeff 1 50 1.2
run 0
print \"is given \$(c_s) 1.2\"
clear
newton off
atom_style hybrid sphere bond
read_restart two.restart
bond_style contact
bond_coeff 1 stiffness 50 ultimate 1e9
neighbor 0.3 bin
fix 1 all nve/sphere
$lengths
print \"is restored \$(c_s) 1.3\""
rejects "$two
bond_coeff 1 0 1" 'K'
rejects "$two
bond_coeff 1 50" 'r0'
rejects "$two
bond_coeff 1 50 -1" 'r0'
finish
