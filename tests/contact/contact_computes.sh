#!/bin/bash
# Computes of contacts, bonds, clusters and of pairs in general, against numbers known beforehand.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
atom_style granular
boundary p f f
region box block 0 1 0 1.1 0 1.2 units box
create_box 2 box
neighbor 0.05 bin
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0
timestep 1e-4'
# 1-2 and 2-3 touch, 4-5 touch across the face, 6 is alone
six="$box
create_atoms 1 single 0.31 0.2 0.3 units box
create_atoms 2 single 0.50 0.22 0.31 units box
create_atoms 1 single 0.70 0.22 0.31 units box
create_atoms 1 single 0.97 0.8 0.8 units box
create_atoms 1 single 0.07 0.8 0.8 units box
create_atoms 2 single 0.5 0.5 1.0 units box
set type 1 diameter 0.2 density 1000
set type 2 diameter 0.24 density 2385
group low id 1 2 3
group one type 1
group two type 2"

agree 'numbers of contacts' "$six
compute z all contact/atom
compute z1 all contact/atom one
compute z2 two contact/atom
compute n all reduce sum c_z c_z1 c_z2
compute most all reduce max c_z
print \"is all \$(c_n[1]) 6\"
print \"is with_one \$(c_n[2]) 4\"
print \"is of_two \$(c_n[3]) 2\"
print \"is most \$(c_most) 2\""
agree 'coordination numbers' "$six
compute a all coord/atom 0.25
compute b all coord/atom cutoff 0.25 1 2 *
compute m all coord/atom 0.25 mix yes
compute g all coord/atom cutoff 0.25 group two
compute far one coord/atom 1.0
compute n all reduce sum c_a c_b[1] c_b[2] c_b[3] c_m c_g c_far
print \"is all \$(c_n[1]) 6\"
print \"is type_1 \$(c_n[2]) 4\"
print \"is type_2 \$(c_n[3]) 2\"
print \"is any \$(c_n[4]) 6\"
print \"is same \$(c_n[5]) 2\"
print \"is group \$(c_n[6]) 2\""
agree 'images of a particle are neighbours too' "boundary p p p
units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.3 0.3 0.3 units box
compute a all coord/atom 1.001
compute b all coord/atom 1.415
compute c all coord/atom 2.001
compute n all reduce sum c_a c_b c_c
print \"is faces \$(c_n[1]) 6\"
print \"is edges \$(c_n[2]) 18\"
print \"is further \$(c_n[3]) 32\""
agree 'clusters' "$six
compute c all cluster/atom 0.25
compute l low cluster/atom 0.25
compute far all cluster/atom 5
compute n all reduce sum c_c c_l c_far
print \"is sum \$(c_n[1]) \$(3*1+2*4+6)\"
print \"is group \$(c_n[2]) 3\"
print \"is one \$(c_n[3]) 6\""
agree 'fragments, aggregates, bonds of each' "$six
bond_style contact
bond_coeff * stiffness 1931 ultimate 1000
group tied id 2 4 6
create_bonds many tied tied 1 0.0 0.8
compute b all nbond/atom
compute b1 all nbond/atom bond/type 2
compute f all fragment/atom
compute fs all fragment/atom single yes
compute a all aggregate/atom 0.25
compute n all reduce sum c_b c_b1 c_f c_fs c_a
variable bonds equal bound(all,xmax)
print \"is bonds \$(c_n[1]) 4\"
print \"is none \$(c_n[2]) 0\"
print \"is fragments \$(c_n[3]) 6\"
print \"is single \$(c_n[4]) \$(6+1+3+5)\"
print \"is aggregates \$(c_n[5]) 6\""
# a bond to a particle outside the group: a fragment of one, unlike a particle without bonds
agree 'fragments of a group' "$six
bond_style contact
bond_coeff * stiffness 1931 ultimate 1000
create_bonds single/bond 1 2 4
group some id 1 4 5
compute f some fragment/atom
compute fs some fragment/atom single yes
compute n all reduce sum c_f c_fs
print \"is fragments \$(c_n[1]) 4\"
print \"is single \$(c_n[2]) \$(1+4+5)\""
agree 'pairs: partners, distances, forces' "$six
velocity all set 0.5 0 0
set atom 1 vy 0.2
compute who all property/local patom1 patom2 ptype1 ptype2
compute near all property/local natom1
compute how all pair/local dist force fx fy fz dx dy dz cutoff radius
compute few low pair/local dist
compute held all pair/local eng p1 p2 p3 p4
compute holds all reduce sum c_held[1] c_held[5]
compute who1 all reduce sum c_who[1] c_who[2] c_who[3] c_who[4]
compute sum all reduce sum c_how[1] c_how[2] c_how[3] c_how[5] c_how[6] c_how[8] inputs local
compute min all reduce min c_how[6] c_who[1] c_how[2] replace 2 1 replace 3 1
compute n all reduce sumsq c_few
variable r equal sqrt(0.19^2+0.02^2+0.01^2)
variable f equal 2385*(0.22-v_r)
run 0
print \"is first \$(c_who1[1]) \$(1+2+4)\"
print \"is second \$(c_who1[2]) \$(2+3+5)\"
print \"is types \$(c_who1[3]) \$(1+2+1)\"
print \"is types \$(c_who1[4]) \$(2+1+1)\"
print \"is dist \$(c_sum[1]) \$(v_r+0.2+0.1)\"
print \"is force \$(c_sum[2]) \$(v_f+2385*(0.02+0.1))\"
print \"is fx \$(c_sum[3]) \$(-0.19/v_r*v_f-2385*0.02-2385*0.1)\"
print \"is fz \$(c_sum[4]) \$(-0.01/v_r*v_f)\"
print \"is dx \$(c_sum[5]) -0.49\"
print \"is dz \$(c_sum[6]) -0.01\"
print \"is least \$(c_min[1]) -0.2\"
print \"is of \$(c_min[2]) 2\"
print \"is its_force \$(c_min[3]) \$(2385*0.02)\"
print \"is in_group \$(c_n) \$(v_r^2+0.04)\"
print \"is energy \$(c_holds[1]) \$(2385/2*((0.22-v_r)^2+0.02^2+0.1^2))\"
print \"is without_friction \$(c_holds[2]<1e-12) 1\""
agree 'pairs as LIGGGHTS lists them' "$six
set atom 1 vy 0.2
set atom 5 vz 0.7
compute c all pair/gran/local id contactPoint delta contactArea force_tangential force_normal pos vel force
compute d all pair/gran/local
compute s all reduce sum c_c[1] c_c[4] c_c[8] c_c[12] c_c[15] c_c[16] c_c[19] c_c[22] c_c[25] c_c[26] c_c[27]
compute t all reduce sum c_d[19]
compute abs all reduce maxabs c_c[22] c_c[23] c_c[24]
variable r equal sqrt(0.19^2+0.02^2+0.01^2)
variable f equal 2385*(0.22-v_r)
variable area equal PI/4*(4*0.01*v_r^2-(v_r^2+0.01-0.0144)^2)/v_r^2
run 0
print \"is x1 \$(c_s[1]) \$(0.31+0.5+0.97)\"
print \"is x2 \$(c_s[2]) \$(0.5+0.7+0.07)\"
print \"is vy1 \$(c_s[3]) 0.2\"
print \"is vz2 \$(c_s[4]) 0.7\"
print \"is images \$(c_s[5]) 1\"
print \"is fx \$(c_s[6]) \$(-0.19/v_r*v_f-2385*0.02-2385*0.1)\"
print \"is normal \$(c_s[7]) \$(c_s[6])\"
print \"is tangential \$(c_abs[1]+c_abs[2]+c_abs[3]) 0 \$(v_f)\"
print \"is area \$(c_s[9]) \$(v_area+PI/4*(4*0.01*0.04-(0.04+0.01-0.0144)^2)/0.04+PI*(0.01-0.0025))\"
print \"is delta \$(c_s[10]) \$(0.22-v_r+0.02+0.1)\"
print \"is point \$(c_s[11]) \$(0.31+0.19*0.1/0.22+0.5+0.2*0.12/0.22+1.02)\"
print \"is usual \$(c_t) \$(c_s[9])\""
agree 'bonds: partners, lengths, forces' "$six
bond_style contact
bond_coeff * stiffness 1931 ultimate 1000
group tied id 4 5 6
create_bonds many tied tied 1 0.0 0.2
set atom 4 x 0.94
compute who all property/local batom1 batom2 btype
compute how all bond/local dist rest force fx dx
compute w all reduce sum c_who[1] c_who[2] c_who[3]
compute h all reduce sum c_how[1] c_how[2] c_how[3] c_how[4] c_how[5]
run 0
print \"is one \$(c_w[1]) 4\"
print \"is two \$(c_w[2]) 5\"
print \"is type \$(c_w[3]) 1\"
print \"is dist \$(c_h[1]) 0.13\"
print \"is rest \$(c_h[2]) 0.1\"
print \"is force \$(c_h[3]) \$(-1931*0.03)\"
print \"is fx \$(c_h[4]) \$(1931*0.03)\"
print \"is dx \$(c_h[5]) -0.13\""
agree 'force between groups' "$six
bond_style contact
bond_coeff * stiffness 1931 ultimate 1000
create_bonds many two two 1 0.0 0.8
set atom 6 z 1.05
compute a low group/group one
compute b one group/group two
compute c two group/group one
compute s two group/group two bond yes
compute o one group/group two bond yes pair no
variable r equal sqrt(0.19^2+0.02^2+0.01^2)
variable f equal 2385*(0.22-v_r)
run 0
print \"is low \$(c_a[1]) \$(v_f*0.19/v_r-2385*0.02)\"
print \"is opposite \$(c_b[1]+c_c[1]) 0\"
print \"is one \$(c_b[2]) \$(0-v_f*0.02/v_r)\"
print \"is self \$(c_s[1]) 0\"
print \"is nothing \$(c_o[3]) 0\""
agree 'all ways to reduce' "$six
region low block INF INF INF INF INF 0.5 units box
set atom 1 vx -2.5
set atom 2 vx 1.5
set atom 6 vx 4
compute 1 all reduce sum vx
compute 2 all reduce min vx
compute 3 all reduce max vx
compute 4 all reduce ave vx
compute 5 all reduce sumsq vx
compute 6 all reduce avesq vx
compute 7 all reduce sumabs vx
compute 8 all reduce aveabs vx
compute 9 low reduce minabs vx
compute 10 all reduce maxabs vx
compute 11 all reduce/region low max vx id x replace 2 1 replace 3 1
compute 12 one reduce/region low ave vx
print \"is sum \$(c_1) 3\"
print \"is min \$(c_2) -2.5\"
print \"is max \$(c_3) 4\"
print \"is ave \$(c_4) 0.5\"
print \"is sumsq \$(c_5) 24.5\"
print \"is avesq \$(c_6) \$(24.5/6)\"
print \"is sumabs \$(c_7) 8\"
print \"is aveabs \$(c_8) \$(8/6)\"
print \"is minabs \$(c_9) 0\"
print \"is maxabs \$(c_10) 4\"
print \"is region \$(c_11[1]) 1.5\"
print \"is who \$(c_11[2]) 2\"
print \"is where \$(c_11[3]) 0.5\"
print \"is mean \$(c_12) -1.25\""

agree 'radial distribution of a cubic lattice' "units si
boundary p p p
lattice sc 0.25
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 box
set type 1 diameter 0.1
compute g all rdf 8 cutoff 0.8
compute s all slice 3 7 2 c_g[3] c_g[1]
fix mean all ave/time 1 1 1 c_g[2] c_g[3] mode vector
variable v2 equal 4*PI/3*(0.3^3-0.2^3)
variable v5 equal 4*PI/3*(0.6^3-0.5^3)
run 0
print \"is middle \$(c_g[3][1]) 0.25\"
print \"is g \$(c_g[3][2]) \$(6/v_v2/63)\"
print \"is empty \$(c_g[2][2]) 0\"
print \"is coord \$(c_g[3][3]) 6\"
print \"is second \$(c_g[4][3]) 18\"
print \"is third \$(c_g[5][3]) 26\"
print \"is fourth \$(c_g[6][2]) \$((6+24)/v_v5/63)\"
print \"is within_6 \$(c_g[6][3]) 56\"
print \"is within_8 \$(c_g[8][3]) \$(6+12+8+6+24+24+12+30+24)\"
print \"is averaged \$(f_mean[3]) \$(c_g[3][2])\"
print \"is sliced \$(c_s[2]) \$(c_g[5][3])\"
print \"is sliced \$(c_s[3][2]) \$(c_g[7][1])\""
agree 'radial distribution by types' "$six
compute g all rdf 2 1 2 2 * 2 2 cutoff 0.5
variable near equal 4*PI/3*0.25^3/1.32
compute k all count/type atom
compute l low count/type atom
print \"is one_two \$(c_g[1][2]) \$(2/v_near/(4*2))\"
print \"is two_any \$(c_g[1][4]) \$(2/v_near/(2*(6-2/2)))\"
print \"is coord \$(c_g[1][5]) 1\"
print \"is two_two \$(c_g[2][6]) 0\"
print \"is kinds \$(c_k[1]) 4\"
print \"is kinds \$(c_l[2]) 1\""

rejects "$six
compute g all rdf 10 1" "jtype"
rejects "$six
compute g all rdf 10 cutoff -1" "cutoff"
rejects "$six
compute g all rdf 10
compute s all slice 5 4 1 c_g[1]" 'Nstart (5) is larger'
rejects "$six
compute g all rdf 10
compute s all slice 5 14 1 c_g[1]
print \$(c_s[1])" 'has 10 elements'
rejects "$six
compute c all property/local patom1 natom2" "'patom1' and 'natom2' are of different lists"
rejects "$six
compute c all property/local patom3" "did you mean 'patom1'?"
rejects "$six
compute c all pair/local energy" "unknown quantity 'energy'"
rejects "$six
compute c all pair/gran/local heatFlux" 'no heat flows without a fix heat/gran'
rejects "$six
compute c all pair/gran/local id force
dump d all local 1000 l*.txt c_c[7]" 'has no [7], the last is [6]'
rejects "$six
compute c all coord/atom -1" 'expected a cutoff > 0'
rejects "$six
compute c all coord/atom 0.1 3x" 'expected a type'
rejects "$six
compute r all reduce sum vx vy replace 1 2" 'can be used with min and max only'
rejects "$six
compute r all reduce max vx vy replace 1 3" 'the numbers of two of the inputs'
rejects "$six
compute r all reduce max vx vy replace 1 1" 'the numbers of two of the inputs'
rejects "$six
compute r all reduce max vx vy replace 1" 'the numbers of two of the inputs'
rejects "$six
compute c all pair/local dist
compute r all reduce/region box max c_c" 'c_c'
rejects "$six
run 0
delete_atoms group two
compute c all pair/local dist
compute r all reduce max c_c
print \$(c_r)" '`run 0` finds them'

# ---- spheres that just touch: LAMMPS and LIGGGHTS count 288 contacts, 3 x 48 pairs, in this lattice
prints 'units si
boundary f f f
lattice sc 1.0
region box block 0 4 0 4 0 4
create_box 1 box
create_atoms 1 box
set group all diameter 1.0 density 1.0
neighbor 0.2 bin
compute c all contact/atom
compute s all reduce sum c_c
run 0
print "contacts $(c_s)"' 'contacts 288'

# ---- the torque of a contact in the first output after read_restart is that of the last step
hit='fix p1 all property/global kn peratomtypepair 1 4e4
fix p2 all property/global kt peratomtypepair 1 1e4
fix p3 all property/global gamman peratomtypepair 1 40
fix p4 all property/global gammat peratomtypepair 1 20
fix p5 all property/global coefficientFriction peratomtypepair 1 0.5
fix p6 all property/global coefficientRollingFriction peratomtypepair 1 0.2
pair_style gran model hooke/stiffness tangential history rolling_friction epsd2
pair_coeff * *
timestep 1e-5
fix integ all nve/sphere
compute c all pair/gran/local force torque
compute t all reduce sum c_c[4] c_c[5] c_c[6]'
cat >in.hit <<END
units si
atom_style granular
boundary f f f
region box block -0.5 0.5 -0.5 0.5 0 1 units box
create_box 1 box
create_atoms 1 single -0.049 0 0.5
create_atoms 1 single 0.049 0.01 0.5
set type 1 diameter 0.1 density 2500
set atom 1 vx 1 vy 0.5
set atom 2 vx -1 vz 0.5
$hit
run 40
variable x equal \$(c_t[1]:%.17g)
variable y equal \$(c_t[2]:%.17g)
variable z equal \$(c_t[3]:%.17g)
write_restart hit.restart
clear
read_restart hit.restart
$hit
run 0
print "is x \$(c_t[1]:%.17g) \${x}"
print "is y \$(c_t[2]:%.17g) \${y}"
print "is z \$(c_t[3]:%.17g) \${z}"
print "is turned \$(abs(v_y)>0.1) 1"
END
agree 'torque of a contact after read_restart' "$(cat in.hit)"

# compute contact/atom reads the contact list during a run, and searches after it: the same counts, across periodic faces that
# are three diameters apart, too, and where frozen particles, of which the list has no pairs, touch.
cat >in.listed <<END
units si
atom_style granular
boundary p p f
region box block 0 0.3 0 0.3 0 2 units box
create_box 2 box
region low block INF INF INF INF 0 0.35 units box
lattice sc 0.1
create_atoms 1 region low
displace_atoms all move 0 0 0.05
displace_atoms all random 0.003 0.003 0.002 4711
set type 1 diameter 0.1 density 2500
region left block INF 0.12 INF INF INF INF units box
set region left type 2
group left region left
group none empty
fix p1 all property/global youngsModulus peratomtype 5e6 5e6
fix p2 all property/global poissonsRatio peratomtype 0.3 0.3
fix p3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix p4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix g all gravity 9.81 vector 0 0 -1
timestep 1e-4
fix integ all nve/sphere
fix stays \${stays} freeze
compute c all contact/atom
compute d all contact/atom left
compute x all reduce sum c_c c_d
compute y all reduce max c_c c_d
thermo_style custom step c_x[1] c_x[2] c_y[1] c_y[2]
thermo_modify norm no
fix now all ave/time 1 1 400 c_x[1] c_x[2] c_y[1] c_y[2]
run 400
print "is sum \$(c_x[1]) \$(f_now[1])"
print "is sum_left \$(c_x[2]) \$(f_now[2])"
print "is most \$(c_y[1]) \$(f_now[3])"
print "is most_left \$(c_y[2]) \$(f_now[4])"
print "is many \$(c_x[1]>100) 1"
END
agree 'contacts from the list and by search' "$(sed 's/${stays}/none/' in.listed)"
agree 'contacts of frozen particles' "$(sed 's/${stays}/left/' in.listed)"
finish
