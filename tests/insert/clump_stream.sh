#!/bin/bash
# A stream of clumps: they go straight to the face, whatever pushes them, and leave it as they were asked to; a run cut
# by restart files.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
printf '%s\n' '0.1 -0.3 -0.3 0.1 0.3 -0.3 0.1 0.3 0.3' '0.1 -0.3 -0.3 0.1 0.3 0.3 0.1 -0.3 0.3' | solid >face.stl
start='variable from index none
units si
atom_style granular
boundary f f f
region box block -1 1 -1 1 -1 1 units box
if "${from} == none" then "create_box 2 box" else "read_restart ${from}"
fix face all mesh/surface file face.stl type 2
fix clump all particletemplate/multisphere 15485863 atom_type 1 density constant 2385 nspheres 2 ntry 20000 &
	spheres 0 0 0 0.02  0.03 0 0 0.015 type 1
fix clumps all particledistribution/discrete 32452843 1 clump 1.0
fix down all gravity 9.81 vector 0 0 -1
fix turn all multisphere
timestep 1e-3'
pour='fix pour all insert/stream seed 86028121 distributiontemplate clumps nparticles ${n} vel constant 1.3 0.2 0.5 &
	orientation constant 1 1 0 0 particlerate 100 overlapcheck yes insertion_face face extrude_length 0.2'

# It begins at x0 before the face in step 1, and passes it in step 1 + floor(-x0 / (v dt)). Its spheres lie along x,
# the centre of mass is 0.0089 from the first one.
agree 'one clump' "$start
variable n index 1
$pour omega constant 0 0 0
variable x equal x[1]
variable z equal z[1]
variable vx equal vx[1]
variable vy equal vy[1]
variable vz equal vz[1]
run 1
variable begin equal \$(v_x)
variable height equal \$(v_z)
variable steps equal floor((0.1-v_begin-0.0089)/0.0013)
print 'is straight \${vz} 0'
print 'is ahead \${vx} 1.3'
run \$(v_steps-1)
print 'is place \${x} \$(v_begin+0.0013*(v_steps-1))'
print 'is height \${z} \$(v_height)'
print 'is aside \${vy} 0'
run 1
print 'is speed \${vx} 1.3'
print 'is aside \${vy} 0.2'
print 'is up \${vz} 0.5'
run 1
print 'is pulled \${vz} \$(0.5-9.81e-3)'"
agree 'turning' "$start
compute spin all multisphere/single id 1 property omega
compute mass all multisphere/single id 1 property masstotal
compute none all multisphere/single id 2 property xcm
variable n index 1
$pour omega constant 1.1 2.2 3.3
variable x equal omegax[1]
variable z equal omegaz[1]
variable begin equal x[1]
run 1
variable steps equal \$(floor((0.1-v_begin-0.0089)/0.0013))
run \$(v_steps-1)
print 'is still \${x} 0'
run 1
print 'is turning \${x} 1.1'
print 'is turning \${z} 3.3'
print 'is turning \$(c_spin[2]) 2.2'
print 'is mass \$(c_mass) \$(mass(all))'
print 'is none \$(c_none[1]) 0'"
cat >in.cut <<END
$start
variable n index 60
$pour omega constant 1 2 3
thermo_style custom step atoms ke f_pour[1] f_pour[2]
thermo 10
run \${to} upto
write_restart \${name}.restart
END
cut() { # NAME FROM TO
	"$TSIM" -in in.cut -log "$1.log" -screen none -var name "$1" -var from "$2" -var to "$3" 2>err
	report "$1" $? err
}
cut whole none 500
cut a none 133
cut b a.restart 281
cut c b.restart 500
rows whole.log >whole
rows a.log b.log c.log | grep -vE '^ +(133|281) ' >parts
same 'tables of parts' whole parts
same 'states' whole.restart c.restart
finish
