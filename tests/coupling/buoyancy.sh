#!/bin/bash
# fix buoyancy: caps of spheres and segments of discs, which way, where, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.pond <<'END'
units si
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
region left block INF 0.2 INF INF INF INF units box
create_box 1 box
create_atoms 1 single 0 0 -0.3 units box
create_atoms 1 single 0.5 0 -0.03 units box
create_atoms 1 single -0.5 0 0.05 units box
create_atoms 1 single -0.5 0.5 0.3 units box
set type 1 diameter 0.2 density 2470
timestep 1e-4
variable cap1 equal 4/3*PI*0.1^3
variable cap2 equal PI*0.14^2*(0.3-0.14)/3
variable cap3 equal PI*0.06^2*(0.3-0.06)/3
END
# pond GRAVITY WORDS V1 V2 V3 V4: of each sphere
pond() {
	agree "buoyancy $2, g $1" "include in.pond
fix g all gravity 0 vector $1
fix lift all buoyancy $2 density 1931
fix g all gravity 9.81 vector $1
fix weight all addforce \$(9.81*mass(all)/4*($3)) \$(9.81*mass(all)/4*($4)) \$(9.81*mass(all)/4*($5))
run 0
variable f1 equal \$(9.81*1931)
print \"is one \$(f$7[1]/1931:%.13g) \$($6*9.81*v_cap1:%.13g)\"
print \"is two \$(f$7[2]/1931:%.13g) \$($6*9.81*($8):%.13g)\"
print \"is three \$(f$7[3]/1931:%.13g) \$($6*9.81*($9):%.13g)\"
print \"is four \$(f$7[4]/1931:%.13g) \$($6*9.81*(${10}):%.13g)\"
print \"is total \$(f_lift[${11}]/1931:%.13g) \$($6*9.81*(v_cap1+$8+$9+${10}):%.13g)\""
}
pond '0 0 -1' 'level 0.01 dim z' 0 0 1 1 z v_cap2 v_cap3 0 3
pond '0 0 -1' 'level 0.01 dim z region left' 0 0 1 1 z 0 v_cap3 0 3
agree 'gravity upwards: the fluid is above' 'include in.pond
fix lift all buoyancy level -0.07 dim z density 1931
fix g all gravity 9.81 vector 0 0 1
run 0
variable f atom (id==1)*(fz-9.81*mass)
compute f all reduce sum v_f
print "is one $(c_f) 0"
variable f2 atom (id==2)*(9.81*mass-fz)
compute f2 all reduce sum v_f2
print "is two $(c_f2/1931:%.13g) $(9.81*v_cap2:%.13g)"'
agree 'discs' 'units si
dimension 2
boundary f f p
newton off
communicate single vel yes
region box block -1 1 -1 1 -0.1 0.1 units box
create_box 1 box
create_atoms 1 single 0 0.05 0 units box
create_atoms 1 single 0.5 -0.5 0 units box
set type 1 diameter 0.2 density/disc 24.7
fix lift all buoyancy dim y density 19.31
fix g all gravity 9.81 vector 0 -1 0
run 0
variable s equal 0.01*acos(0.5)-0.05*sqrt(0.1*0.05*1.5)
print "is one $((fy[1]+9.81*24.7*PI*0.01)/19.31:%.13g) $(9.81*v_s:%.13g)"
print "is two $((fy[2]+9.81*24.7*PI*0.01)/19.31:%.13g) $(9.81*PI*0.01:%.13g)"'

rejects 'include in.pond
fix lift all buoyancy dim z density 1000
run 0' 'needs the weight of one fix gravity, there are 0'
rejects 'include in.pond
fix lift all buoyancy dim z density 1000
fix g all gravity 9.81 vector 0 0 -1
fix h all gravity 9.81 vector 0 0 -1
run 0' 'there are 2'
rejects 'include in.pond
fix lift all buoyancy dim z density 1000
fix g all gravity 9.81 vector 0 0.5 -1
run 0' 'gravity does not point along z'
finish
