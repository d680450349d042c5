#!/bin/bash
# fix check/timestep/bond: its ratios by formula, what it says, what it refuses.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.two <<'END2'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
neighbor 0.01 bin
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 0.22 0 0 units box
create_atoms 1 single 0.5 0 0 units box
set atom 1 diameter 0.2 density 2470
set atom 2 diameter 0.23 density 1830
set atom 3 diameter 0.1 density 1000
set atom 3 vy 0.7
timestep 1e-4
fix n all nve/sphere
group two id 1 2
variable m1 equal 2470*PI*0.2^3/6
variable m2 equal 1830*PI*0.23^3/6
variable m equal v_m1*v_m2/(v_m1+v_m2)
variable I1 equal 0.4*v_m1*0.1^2
variable I2 equal 0.4*v_m2*0.115^2
END2
gran='bond_style gran
bond_coeff 1 1.0 0.0 1.5e6 1.0e6 0 0 1 1e9 1e9
create_bonds single/bond 1 1 2
variable A equal PI*0.1^2
variable k equal 1.5e6*v_A/0.22
variable J equal PI/2*0.1^4
variable kt equal 1.0e6*v_J/0.22
variable kb equal 1.5e6*v_J/2/0.22
variable ks equal 1.0e6*v_A/0.22
variable c equal (0.22+0.1-0.115)/2
variable e equal 0.22-v_c
variable slip equal v_ks*(1/v_m+v_c^2/v_I1+v_e^2/v_I2)
variable bend equal v_kb*(1/v_I1+1/v_I2)
variable cross equal v_ks*v_kb*(v_c/v_I1-v_e/v_I2)^2
variable w2 equal 0.5*(v_slip+v_bend+sqrt((v_slip-v_bend)^2+4*v_cross))'
ratios='print "is bond $(f_ts[1]*1e3:%.10g) $(v_bond:%.10g)"
print "is skin $(f_ts[2]*1e3:%.10g) $(v_skin:%.10g)"
print "is stable $(f_ts[3]*1e3:%.10g) $(v_stable:%.10g)"'

# shear with bending is the fastest motion of this bond: 1.8 times as fast as stretching
agree 'shear and bending' "include in.two
$gran
fix ts all check/timestep/bond 2 0.5
run 1
print \"is before \$(f_ts[1]+f_ts[2]+f_ts[3]) 0\"
run 1
variable bond equal 0.1*sqrt(v_w2)
variable stable equal 0.05*sqrt(v_w2)
variable skin equal 1.4e-4/0.01*1e3
print \"is fast \$(v_w2>1.5*v_k/v_m) 1\"
$ratios"
agree 'legacy: stretching' "include in.two
$gran
fix ts all check/timestep/bond check_every_time 2e-4 0.5 vmax 3 legacy yes
run 2
variable bond equal 0.1*sqrt(v_k/v_m)
variable stable equal 0.05*sqrt(v_w2)
variable skin equal 6e-4/0.01*1e3
$ratios"
agree 'a central spring' "include in.two
bond_style contact
bond_coeff 1 stiffness 4e4 ultimate 1e9
create_bonds single/bond 1 1 2
fix ts two check/timestep/bond 1 0.5
run 1
variable bond equal 0.1*sqrt(4e4/v_m)
variable stable equal v_bond/2
variable skin equal 0
$ratios"
# a chain of three equal masses: w^2 = 3 k/m, that of one bond 2 k/m
agree 'the network' "include in.two
bond_style contact
bond_coeff 1 stiffness 4e4 ultimate 1e9
create_bonds single/bond 1 1 2
create_bonds single/bond 1 2 3
set group all diameter 0.2 density 2470
set atom 3 vy 0
fix ts all check/timestep/bond 1 0.5
run 1
variable bond equal 0.1*sqrt(2*4e4/v_m1)
variable stable equal 0.05*sqrt(3*4e4/v_m1)
variable skin equal 0
$ratios"
agree 'a group without bonds' "include in.two
$gran
group one id 1 3
fix ts one check/timestep/bond 1 0.5
run 1
print \"is none \$(f_ts[1]+f_ts[3]) 0\""
agree 'no bonds at all' "include in.two
fix ts all check/timestep/bond 1 0.5
run 1
print \"is none \$(f_ts[1]+f_ts[3]) 0\""
prints "include in.two
$gran
fix ts all check/timestep/bond 1 0.01
run 3" '*of the time of the bonds at step 1, more than 1 %; it is ' '*of the stability limit'
echo "include in.two
$gran
fix ts all check/timestep/bond 1 0.01 warn no
run 3" >in.script
"$TSIM" -in in.script -log none >out 2>&1 && ! grep -q 'time of the bonds' out
report 'warn no' $? out
rejects "include in.two
$gran
fix ts all check/timestep/bond 1 0.01 error yes
run 3" 'of the time of the bonds at step 1'
rejects "include in.two
fix ts all check/timestep/bond 0 0.01" "found '0', expected N fraction_bond"
rejects "include in.two
fix ts all check/timestep/bond 10" "found '10', expected N fraction_bond"
rejects "include in.two
fix ts all check/timestep/bond 10 0.1 0.1" "found '0.1', expected N fraction_bond"
finish
