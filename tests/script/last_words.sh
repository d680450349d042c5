#!/bin/bash
# timer timeout, pair_style none, computes that exist without being defined, compute erotate.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

scene='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.57 0.5 0.5 units box
set group all diameter 0.1 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
thermo_modify norm no
timestep 1e-5'
prints "$scene
fix move all nve
timer full timeout 0 every 7
print \"left \$(timeremain < 0)\"
run 100
print \"at \$(step)\"
run 100
print \"still at \$(step)\"
timer timeout 0:30:00
print \"left \$(timeremain > 1700 && timeremain <= 1800)\"
run 100 upto
print \"then \$(step)\"
timer timeout off
print \"none \$(timeremain)\"" 'Wall time limit reached at step 7' 'at 7' 'still at 7' 'left 1' 'then 100' 'none 0'
rejects 'timer timeout 1:2:3:4' 'timeout takes seconds, m:s, h:m:s'
rejects 'timer timeout -5' 'timeout takes seconds'
rejects 'timer timeout' 'timeout takes seconds'
rejects 'timer every 0' 'every takes a number of steps > 0'
rejects 'timer fast' "found 'fast', expected off, loop"

agree 'thermo_temp and its kin' "$scene
velocity all set 1 2 3 units box
run 0
variable p equal c_thermo_press[1]
print 'is temp \$(c_thermo_temp) \$(temp)'
print 'is press \$(c_thermo_press) \$(press)'
print 'is pxx \${p} \$(pxx)'
print 'is pe \$(c_thermo_pe) \$(0.5*100*0.03^2)'
compute thermo_temp all ke
print 'is own \$(c_thermo_temp) \$(ke)'"
prints "$scene
thermo_style custom step c_thermo_temp c_thermo_press[3]
run 0" '    Step    thermo_temp thermo_press[3] '
agree 'no pair style any more' "$scene
compute n all contacts
run 0
print 'is one \$(c_n) 1'
pair_style none
bond_style none
run 0
print 'is pushed \$(fmax) 0'
print 'is pe \$(pe) 0'"
agree 'rotation' "$scene
set group all omega 0 0 3
fix move all nve/sphere
compute a all erotate
compute b all erotate/sphere
run 0
print 'is a \$(c_a) \$(2*0.5*0.4*mass(all)/2*0.05^2*9)'
print 'is b \$(c_a) \$(c_b)'"
finish
