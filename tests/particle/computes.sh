#!/bin/bash
# Computes against closed forms. A script prints lines `is WHAT value reference`; they must agree to
# 13 digits.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
atom_style granular
boundary p f f
region box block 0 1 0 1.1 0 1.2 units box
create_box 2 box
neighbor 0.05 bin
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0.5
timestep 1e-4'
three="$box
create_atoms 1 single 0.31 0.2 0.3 units box
create_atoms 1 single 0.5 0.22 0.31 units box
create_atoms 2 single 0.97 0.36 0.317 units box
set type 1 diameter 0.2 density 1000
set type 2 diameter 0.24 density 2385
set atom 1 vx 0.1 vy 0.2 vz -0.3
set atom 2 vx -0.2 vy 0.7
group pair id 1 2
fix move all nve/sphere"

agree 'kinetic energy, each and together' "$three
compute each all ke/atom
compute pair pair ke/atom
compute sum all reduce sum c_each
compute two all reduce sum c_pair
compute rest all reduce max c_pair
run 0
print \"is sum \$(c_sum) \$(ke)\"
print \"is pair \$(c_two) \$(ke(pair))\""
agree 'energy of rotation' "$three
set atom 1 omegax 1.7 omegaz -2.3
set atom 3 omegay 0.385
compute e all erotate/sphere
compute p pair erotate/sphere
compute each all erotate/sphere/atom
compute sum all reduce sum c_each
variable m1 equal mass[1]
variable m3 equal mass[3]
run 0
print \"is all \$(c_e) \$(0.2*v_m1*0.01*(1.7^2+2.3^2)+0.2*v_m3*0.0144*0.385^2)\"
print \"is pair \$(c_p) \$(0.2*v_m1*0.01*(1.7^2+2.3^2))\"
print \"is sum \$(c_sum) \$(c_e)\""
agree 'no rotation' "$box
create_atoms 1 single 0.3 0.3 0.3 units box
set type 1 diameter 0.1
compute e all erotate/sphere
compute each all erotate/sphere/atom
compute sum all reduce sum c_each
run 0
print \"is zero \$(c_e) 0\"
print \"is zero \$(c_sum) 0\""
agree 'gyration of two' "$three
compute g pair gyration
compute none all gyration
print \"is radius \$(c_g) \$(sqrt(0.19^2+0.02^2+0.01^2)/2)\"
print \"is xx \$(c_g[1]) \$(0.19^2/4)\"
print \"is xy \$(c_g[4]) \$(0.19*0.02/4)\"
print \"is yz \$(c_g[6]) \$(0.02*0.01/4)\""
agree 'displacement at constant velocity, across the periodic face' "$box
create_atoms 1 single 0.9 0.2 0.3 units box
create_atoms 1 single 0.2 0.8 0.9 units box
set type 1 diameter 0.1 density 1000
velocity all set 2.385 0.5 0
group one id 1
fix move all nve
compute way all displace/atom
compute m one msd
compute c all msd com yes
compute v all vacf
compute x all reduce max c_way[1]
compute d one reduce max c_way[4]
run 1500
print \"is dx \$(c_x) \$(2.385*0.15)\"
print \"is distance \$(c_d) \$(0.15*sqrt(2.385^2+0.5^2))\"
print \"is msd \$(c_m[4]) \$(0.15^2*(2.385^2+0.5^2))\"
print \"is msd \$(c_m[1]) \$((0.15*2.385)^2)\"
print \"is drift \$(sqrt(c_c[4])) 0 \$(0.15*sqrt(2.385^2+0.5^2))\"
print \"is vacf \$(c_v[4]) \$(2.385^2+0.5^2)\"
uncompute way
compute way all displace/atom
print \"is anew \$(c_x) 0\"
create_atoms 1 single 0.5 0.5 0.5 units box
set atom 3 diameter 0.1 density 1000 vx 1.25
group last id 3
compute last last reduce max c_way[1]
run 100
print \"is later \$(c_last) 0.0125 0.5\""
agree 'mean squared distance from the mean place' "$box
create_atoms 1 single 0.3 0.2 0.3 units box
set type 1 diameter 0.1 density 1000
velocity all set 1 0 0
fix move all nve
compute m all msd average yes
thermo_style custom step c_m[1]
thermo 1000
run 1000
print \"is half \$(c_m[1]) \$(0.1^2*(4/9)) \$(0.1*0.3)\""
agree 'temperature' "units lj
thermo_modify norm no
boundary p p p
region box block 0 9 0 9 0 9
create_box 1 box
create_atoms 1 random 57 2385 NULL
mass 1 1.3
velocity all create 1.7 86028157
velocity all set 0.385 0 0 sum yes
compute t all temp
compute r all temp/com
print \"is relative \$(c_r) 1.7\"
print \"is drift \$(c_t) \$(1.7+1.3*57*0.385^2/(3*56))\"
print \"is trace \$(c_t[1]+c_t[2]+c_t[3]) \$(2*ke)\""
agree 'stress and pressure of one contact' "$box
create_atoms 1 single 0.31 0.2 0.3 units box
create_atoms 2 single 0.5 0.22 0.31 units box
set type 1 diameter 0.2 density 1000
set type 2 diameter 0.24 density 2385
velocity all set 0.3 0.4 0.1
compute s all stress/atom
compute v all stress/atom virial
compute l all stress/atom NULL pair
compute k all stress/atom thermo_temp ke
compute ss all reduce sum c_s[1] c_s[4] c_v[1] c_v[5] c_l[6] c_k[4]
compute each all reduce min c_v[2]
compute p all pressure thermo_temp
compute pv all pressure NULL virial
variable r equal sqrt(0.19^2+0.02^2+0.01^2)
variable f equal 2385*(0.22-v_r)/v_r
variable m equal mass(all)
variable vol equal 1.1*1.2
run 0
print \"is xx \$(c_ss[1]) \$(-v_m*0.09-0.19^2*v_f)\"
print \"is xy \$(c_ss[2]) \$(-v_m*0.12-0.19*0.02*v_f)\"
print \"is virial \$(c_ss[3]) \$(0-0.19^2*v_f)\"
print \"is xz \$(c_ss[4]) \$(-0.19*0.01*v_f)\"
print \"is yz \$(c_ss[5]) \$(-0.02*0.01*v_f)\"
print \"is kinetic \$(c_ss[6]) \$(-v_m*0.12)\"
print \"is half \$(c_each) \$(0-0.02^2*v_f/2)\"
print \"is pressure \$(c_p) \$((v_m*0.26+v_r^2*v_f)/3/v_vol)\"
print \"is pressure \$(c_p[4]) \$(-c_ss[2]/v_vol)\"
print \"is pressure \$(c_pv) \$(v_r^2*v_f/3/v_vol)\""
agree 'pressure across the periodic face, of a bond' "$box
bond_style contact
bond_coeff 1 stiffness 1931 ultimate 1000
create_atoms 1 single 0.03 0.2 0.3 units box
create_atoms 1 single 0.96 0.2 0.3 units box
set type 1 diameter 0.1 density 1000
pair_coeff * * stiffness 2385 damping 0
compute b all pressure NULL bond
compute c all pressure NULL pair
compute s all stress/atom NULL bond
compute sum all reduce sum c_s[1]
group both type 1
create_bonds many both both 1 0.0 0.08
run 0
print \"is nothing \$(c_b[1]) 0\"
print \"is contact \$(c_c[1]) \$(0.07*2385*0.03/1.32)\"
set atom 2 x 0.95
run 0
print \"is bond \$(c_b[1]) \$(-0.08*1931*0.01/1.32)\"
print \"is stress \$(c_sum) \$(0.08*1931*0.01)\""

agree 'what a restart file remembers goes with the particle' "$box
create_atoms 1 single 0.9 0.2 0.3 units box
create_atoms 2 single 0.2 0.8 0.9 units box
set type * diameter 0.1 density 1000
velocity all set 2.385 0.5 0
fix move all nve
compute way all displace/atom
region middle block 0.1 0.6 INF INF INF INF units box
compute out all leave middle
run 1500
write_restart cut.restart
clear
read_restart cut.restart
group gone type 2
delete_atoms group gone
create_atoms 2 single 0.5 0.5 0.5 units box
set type 2 diameter 0.1 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0.5
fix move all nve
compute way all displace/atom
region middle block 0.1 0.6 INF INF INF INF units box
compute out all leave middle
compute x all reduce max c_way[1]
compute n all reduce sum c_way[1]
print \"is dx \$(c_x) \$(2.385*0.15)\"
print \"is others \$(c_n) \$(c_x)\"
run 0
print \"is left \$(c_out[2]) 2\""

rejects "$three
compute p pair pressure thermo_temp" 'its group must be all'
rejects "$three
compute p all pressure NULL" 'use `virial`'
rejects "$three
compute g all gyration
compute p all pressure g" "'g' is not a temperature compute"
rejects "$three
compute s all stress/atom viral" "did you mean 'virial'?"
rejects "$three
compute s all stress/atom
compute m all reduce max c_s[1]
print \$(c_m)" 'run 0'
rejects "$three
compute m all msd com perhaps" 'com'
# In two dimensions particles have no images along z, however thin the box is. Two of three discs touch.
for thick in 0.1 20; do
	prints "units si
dimension 2
boundary f f p
region b block -5 5 -5 5 -$thick $thick units box
create_box 2 b
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 1.0 0 0 units box
create_atoms 1 single 4 4 0 units box
set group all diameter 1.2 density 1000
pair_style gran/hooke 1e4 NULL 50 NULL 0.5 0
pair_coeff * *
fix 1 all nve/sphere
timestep 1e-6
compute c all coord/atom 1.1
compute k all contact/atom
compute z all coordination
compute m all mixing/contact type 1
compute r all rdf 12 cutoff 1.2
thermo_style custom step c_z[1] c_m
run 0
print \"\$(c_c[1]) \$(c_c[3]) \$(c_k[1]) \$(c_k[3]) \$(c_z[1]:%.4f) \$(c_m) \$(c_r[12][3]:%.4f)\"" '1 0 1 0 0.6667 1.5 0.6667'
done
finish
