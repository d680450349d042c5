#!/bin/bash
# Lines of a fluid in any order and between runs: the grid and the box change before and after initial fields are given, the
# clock is set back, the last particle goes, inputs along an axis of one cell.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary f p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
timestep 1e-4
variable xx internal 0
variable square equal v_xx^2
variable u equal v_xx
flow_style projection cells 10 2 2 viscosity 1e-3 density 1'
scalar='fix T all flow/scalar conductivity 1e-6 initial v_square set x xx'
show="compute l all flow/line cells x 0.5 0.5 values x f_T
variable off vector abs(c_l[2]-c_l[1]^2)
run 0
print \"heat \$(f_T[1]:%.6f) off \$(max(v_off) < 1e-14)\""

# ---- the initial scalar is that of the grid of the first run
prints "$box
$scalar
flow_grid x geometric 10
$show" 'heat 0.331056 off 1'
prints "$box
flow_grid x geometric 10
$scalar
$show" 'heat 0.331056 off 1'
prints "$box
$scalar
change_box all x final 0 2 units box
$show" 'heat 2.660000 off 1'
prints "$box
change_box all x final 0 2 units box
$scalar
print \"at once \$(f_T[1]:%.6f)\"
$show" 'at once 2.660000' 'heat 2.660000 off 1'
prints "$box
$scalar
run 3
flow_grid x geometric 10
run 0
print \"ready\"" '*fix flow/scalar: the grid has changed' 'ready'

# ---- flow_set: the grid of the present box, faces that are known
prints "${box/boundary f/boundary p}
change_box all y final 0 2 units box
flow_set velocity 0 0 v_u set y xx
run 0
print \"momentum \$(flow_pz:%.6f)\"" 'momentum 2.000000'
grep -q 'grid has changed' out
report 'no grid has changed' $((!$?)) out
prints "$box
flow_set velocity 0.5 0 0
flow_boundary xlo inlet pressure 0
flow_boundary xhi outlet
run 0
print \"momentum \$(flow_px)\"" '*put flow_set after flow_boundary' 'momentum 0'
prints "$box
flow_boundary xlo inlet pressure 0
flow_boundary xhi outlet
flow_set velocity 0.5 0 0
run 0
print \"momentum \$(flow_px:%.6f)\"" 'momentum 0.500000'
grep -q 'put flow_set after' out
report 'flow_set is after flow_boundary' $((!$?)) out

# ---- a plug driven by a pressure that grows with time, and again with the clock set back
for clock in 'reset_timestep 0' "reset_timestep 10 time 0"; do
	prints "$box
timestep 0.01
variable push equal 3*time
flow_boundary xlo inlet pressure v_push
flow_boundary xhi outlet
compute p all flow/probe 0.5 0.5 0.5 values vx p
run 10
variable before equal \$(c_p[1])
$clock
run 1
print \"gained \$(c_p[1]-v_before:%.9f)\"" 'gained 0.000150000'
done

# ---- the last outlet is closed after a run: its flow was that of the run; an inlet that then has no outlet is refused
valve='units si
atom_style granular
boundary f p p
region box block 0 2 0 1 0 1 units box
create_box 1 box
timestep 0.01
flow_style projection cells 8 4 4 viscosity 0.1 density 1
flow_boundary xlo outlet
create_atoms 1 single 0.17 0.5 0.5 units box
set group all diameter 0.3 density 2
velocity all set -1 0 0
fix e all void_fraction
fix n all nve/sphere'
prints "$valve
run 2
flow_boundary xlo wall
run 3
print \"ready\"" ready
rejects "$valve
flow_boundary xhi inlet velocity -0.1 0 0
run 2
flow_boundary xlo wall
run 3" 'it flows in at 0.1 per time'

# ---- a flow in a plane: nothing along z
plane='units si
boundary p f p
region box block 0 1 0 1 0 1 units box
create_box 1 box
variable w equal 0.1
variable nothing equal 0
flow_style projection cells 4 4 1 viscosity 1e-3 density 1'
rejects "$plane body_force 0 0 0.1" 'body_force is 0.1 along z, expected 0'
rejects "$plane
flow_boundary yhi wall velocity 1 0 v_w" 'velocity is 0.1 along z, expected 0'
rejects "$plane
flow_set velocity 0 0 1" 'velocity is 1 along z, expected 0'
prints "$plane body_force 0 0 v_nothing
flow_set velocity 1 0 v_nothing
print \"momentum \$(flow_px:%.6f)\"" 'momentum 1.000000'

# ---- the pressure of the last step is no guess for a fluid at rest: 170 against round-off
for solver in cg sor 'cg preconditioner diagonal'; do
	prints "units si
atom_style granular
boundary p p p
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
neighbor 0.001 bin
timestep 1e-4
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000
pressure_style $solver
create_atoms 1 single 0.005 0.005 0.005 units box
set group all diameter 0.0005 density 2500
fix e all void_fraction
fix i all nve/sphere
run 20
delete_atoms group all
run 20
print \"ready\"" ready
done

# ---- a body conducts as the fluid does
prints "$plane
timestep 1e-4
region body cylinder z 0.5 0.5 0.2 INF INF units box
fix T all flow/scalar conductivity 1 ylo value 0 yhi value 1
fix b all immersed/boundary region body min_cells 1.5
run 1
print \"ready\"" '*fix flow/scalar: inside of the bodies of fix b' ready
finish
