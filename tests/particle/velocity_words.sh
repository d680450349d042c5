#!/bin/bash
# velocity: temperatures of computes, bias; branches of `if` without commands.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

gas='units lj
boundary p p p
region box block 0 10 0 10 0 10 units box
create_box 1 box
create_atoms 1 random 100 86028157 NULL
set group all diameter 0.1 mass 2.385
group low id 1:40
compute all all temp
compute low low temp
compute drift all temp/com
variable kin equal ke(all)
variable drift2 equal 0.5*mass(all)*(vcm(all,x)^2+vcm(all,y)^2+vcm(all,z)^2)'
agree 'create reaches the temperature of the compute' "$gas
velocity all create 1.5 86028157 temp low
print 'is T \$(c_low) 1.5'"
agree 'scale reaches the temperature of the compute' "$gas
velocity all create 1.5 86028157
velocity all scale 0.75 temp low
print 'is T \$(c_low) 0.75'"
agree 'bias keeps the drift' "$gas
velocity all create 1.5 86028157
velocity all set 0.7 NULL NULL sum yes
velocity all scale 3.5 temp drift bias yes
print 'is T \$(c_drift) 3.5'
print 'is drift \$(vcm(all,x)) 0.7'
print 'is energy \$(v_kin) \$(v_drift2+0.5*3*99*3.5)'
velocity all create 0.5 86028157 temp drift bias yes
print 'is T \$(c_drift) 0.5'
print 'is drift \$(vcm(all,x)) 0.7'"
agree 'without bias the drift is scaled too' "$gas
velocity all create 1.5 86028157
velocity all set 0.7 NULL NULL sum yes
velocity all scale 6 temp drift
print 'is T \$(c_drift) 6'
print 'is drift \$(vcm(all,x)) 1.4'"
rejects "$gas
velocity all scale 1.5 bias yes" 'bias yes needs `temp`'
rejects "$gas
velocity all scale 1.5 temp drift temp all" "given twice"
rejects "$gas
velocity all scale 1.5 temp all bias yes" 'temp leaves out nothing'
rejects "$gas
velocity all create 1.5 1 temp dreft" "did you mean 'drift'?"
rejects "$gas
compute e all ke
velocity all scale 1.5 temp e" 'compute e gives no temperature'

# as in LIGGGHTS and LAMMPS an empty else is an error where it is reached
prints 'if "1==1" then "print yes" else
print "and on"' yes 'and on'
rejects 'if "1==2" then "print yes" else' 'expected a command for this branch, found none'
rejects 'if "1==1" then else "print no"' 'expected a command for this branch, found none'
rejects 'if "1==2" then "print yes" elif "1==1"' 'expected a command for this branch, found none'
finish
