#!/bin/bash
# flow_style projection and its commands: what is refused and why, a grid in a part of the box, outlets that
# vortices cross, any number of threads.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary f f p
dimension 2
region box block 0 2 0 1 -0.5 0.5 units box
create_box 1 box'
fluid="$box
flow_style projection cells 16 8 1 viscosity 0.01 density 1"
inlet="$fluid
flow_boundary xlo inlet velocity 1 0 0"

# ---- refusals, with the place and the remedy
rejects "$inlet
timestep 0.001
run 1" 'make a face an outlet (flow_boundary xhi outlet)'
rejects "$inlet
flow_boundary xhi inlet velocity 0.9 0 0
timestep 0.001
run 1" 'it flows in at 0.1 per time'
rejects "${fluid/f f p/p f p}
flow_boundary xlo outlet" 'the box is periodic there'
rejects "$box
flow_boundary xlo outlet" 'use flow_style projection before it'
rejects "$box
flow_style uniform velocity 0 0 1 viscosity 0
flow_boundary xlo outlet" 'which flow_style uniform is not'
rejects "$fluid viscous implicit time rk3" 'goes with time ab2 or euler, not rk3'
rejects "${fluid/0.01/0} viscous implicit" 'needs a viscosity above 0'
rejects "${fluid/8 1/8 4}" 'in two dimensions there is one cell along z'
rejects "${fluid/8 1/8}" 'NZ is missing'
rejects "${fluid/16 8/1 8}" 'at least two cells between the boundaries along x'
rejects "$fluid form fd convection cubista" 'form fd has donor and central'
rejects "$fluid substeps 0" "substeps is a number from 1 on, or auto, not '0'"
rejects "$fluid
flow_grid x faces 0 0.1 2" '16 cells along x have 17 faces, and 3 are given'
rejects "${fluid/16 8/2 8}
flow_grid x faces 0 1.7 1.2" 'the faces must increase'
rejects "${fluid/16 8/2 8}
flow_grid x faces 0 1.2 1.7" 'the grid goes from 0 to 2 along x'
rejects "$fluid
flow_grid z tanh 2" 'there is one cell along z'
rejects "${fluid/16 8/15 8}
flow_grid x geometric 3 fine both" 'an even number of cells, not 15'
rejects "$fluid
flow_boundary ylo slip velocity 1 0 0" 'at slip faces no velocity is given'
rejects "$fluid
flow_boundary ylo periodic" "periodic"
rejects "$fluid
flow_boundary ylo inlet" 'an inlet needs a velocity'
rejects "$fluid
region far block 3 4 0 1 -0.5 0.5 units box
flow_style projection cells 4 4 1 viscosity 1 density 1 region far" 'has no part in the box along x'
rejects "$inlet
flow_boundary xhi outlet
timestep 0.2
run 10" "stability limit 0.125 of the fluid's Courant number"
rejects "${fluid/0.01/0.1} viscous explicit
timestep 0.3
run 10" "of the fluid's viscosity and convection"
# what begins stable and leaves the region of stable steps is stopped, not a number is never met
rejects "$fluid convection central
variable faster equal time
flow_boundary yhi wall velocity v_faster 0 0
timestep 0.02
run 1000" 'the Courant number sum |u| dt/h is'

# ---- substeps by themselves: the same case runs
prints "$fluid convection central substeps auto
flow_boundary yhi wall velocity 100 0 0
timestep 0.005
run 20
print \"steps \$(flow_steps>20) time \$(flow_time:%.3f)\"" 'steps 1 time 0.100'

# ---- formulas of faces: in each step, or once in a run
for update in step once; do
	prints "$fluid
variable u equal 0.1*step
flow_boundary yhi wall velocity v_u 0 0 update $update
timestep 0.001
run 7
run 3
compute p all flow/probe 1.0 1.0 0
print \"lid \$(c_p[1]:%.3f)\"" "lid $([ $update = step ] && echo 1.000 || echo 0.700)"
done

# ---- a body force that varies: that of a step is the mean of its ends, exact if it grows evenly, with each scheme
plug='units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
timestep 0.01'
while read -r scheme; do
	agree "body_force that grows, time $scheme" "$plug
variable g equal 2*time
flow_style projection cells 4 4 4 viscosity 0.001 density 1 body_force v_g 0 0 time $scheme
compute u all flow/probe 0.5 0.5 0.5 values vx
run 2
variable first equal \$(c_u[1]-time^2)
run 8
print \"is u \$(c_u[1]-v_first) 0.01\""
done <<'END'
euler
ab2
ab2 substeps 3
ab2 viscous implicit
rk2 every 2
rk3
END
agree 'a fluid at rest under a weight that varies' 'units si
boundary f p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
variable g equal -9.81*(1+0.5*sin(100*time))
flow_style projection cells 6 4 6 viscosity 0.1 density 1 body_force 0 0 v_g time ab2
flow_boundary xhi outlet hydrostatic yes
flow_boundary zhi outlet
timestep 1e-3
run 20
print "is cfl $(flow_cfl) 0 1"'

# ---- `every`: the fluid makes up for the time of the steps for which it waited, whatever their lengths, and after a restart
falls="flow_style projection cells 4 4 4 viscosity 0.1 density 1 every 5 body_force 1 0 0
compute u all flow/probe 0.5 0.5 0.5 values vx"
agree 'every, with a new timestep' "${plug/0.01/0.001}
$falls
run 8
print \"is before \$(flow_time) 0.005\"
timestep 0.01
run 1
write_restart waits
run 1
print \"is after \$(flow_time) 0.028\"
print \"is u \$(c_u[1]) 0.028\""
agree 'every, with a new timestep and a restart' "read_restart waits
$falls
timestep 0.01
run 1
print \"is after \$(flow_time) 0.028\"
print \"is u \$(c_u[1]) 0.028\""

# ---- the field set anew: nothing of the flow before is left
prints "$fluid time ab2 viscous implicit
flow_boundary yhi wall velocity 1 0 0
flow_set velocity 0.3 0.2 0
timestep 0.01
run 7
variable first equal \$(flow_ke)
flow_set velocity 0.3 0.2 0
run 7
print \"same \$(abs(flow_ke-v_first)<1e-14)\"" 'same 1'

# ---- a part of the box: Poiseuille flow in it, between faces of its own
prints "$box
region part block 0.5 1.3 0.2 0.7 INF INF units box
variable yy internal 0
variable u equal \"6*(v_yy-0.2)*(0.7-v_yy)/0.25\"
flow_style projection cells 12 10 1 viscosity 0.05 density 2 region part
flow_boundary xlo inlet velocity v_u 0 0 set y yy
flow_boundary xhi outlet
flow_set velocity v_u 0 0 set y yy
timestep 0.005
run 200
compute p all flow/probe 1.0 0.475 0
print \"u \$(c_p[1]:%.6f) p \$(c_p[4]:%.6f)\"" 'u 1.485000 p 0.720000'

# ---- a vortex leaves through an outlet: nothing grows
prints "$box
variable x internal 0
variable y internal 0
variable r equal \"exp(-((v_x-1.5)^2+(v_y-0.5)^2)/0.02)\"
variable u equal \"1-30*(v_y-0.5)*v_r\"
variable v equal \"30*(v_x-1.5)*v_r\"
flow_style projection cells 64 32 1 viscosity 0.0005 density 1 time rk3
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
flow_boundary ylo slip
flow_boundary yhi slip
flow_set velocity v_u v_v 0 set x x set y y
timestep 0.006
variable before equal \$(flow_ke)
run 150
print \"less \$(flow_ke<v_before) quiet \$(abs(flow_ke-1)<0.02)\"" 'less 1 quiet 1'

# ---- bits do not depend on threads
for threads in 1 2 3; do
	sed "s/^units/package omp $threads grain 1\nunits/" "$top_srcdir/tests/decks/in.flow" >in.threads
	"$TSIM" -in in.threads -log log.$threads -screen none 2>err
	report "$threads threads" $? err
	rows log.$threads >rows.$threads
	same "table on $threads threads" rows.1 rows.$threads
done
finish
