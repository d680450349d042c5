#!/bin/bash
# Bodies that close a channel: refused with the body and the place, at the start and when they get there; pockets into
# which nothing flows are legal. Bodies on outlets work, bodies on inlets too where the velocity is theirs.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# channel FACES BODY [UNIT]: 20 steps of it, a body of the script's own
channel() {
	local m=${3-1}
	cat <<END
units si
boundary f f p
dimension 2
region box block 0 $(awk "BEGIN { print 2 * $m }") 0 $m $(awk "BEGIN { print -0.5 * $m, 0.5 * $m }") units box
create_box 1 box
flow_style projection cells 32 16 1 viscosity $(awk "BEGIN { print 0.01 * $m }") density 1
$1
$2
fix dam all immersed/boundary region dam min_cells 1
timestep $(awk "BEGIN { print 0.005 * $m }")
run 20
print "went"
END
}
through='flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet'

# ---- closed at the start
closed='the body closes off the fluid beside flow_boundary xlo about'
rejects "$(channel "$through" 'region dam block 0.9 1.3 -1 2 INF INF')" "in.script:10:13: error: fix dam (immersed/boundary region dam): $closed (0.9171 0.5 0): through the faces of the grid it flows in there at 1 per time"
rejects "$(channel "$through" 'region dam block 0.9e-6 1.3e-6 -1 2 INF INF' 1e-6)" "$closed (9.171e-07 5e-07 0)"
rejects "$(channel "$through" 'region dam block 900 1300 -1000 2000 INF INF' 1000)" "$closed (917.1 500 0)"
rejects "$(channel "$through" 'region dam block 1.8 2.2 -1 2 INF INF')" "$closed" # the outlet is covered
rejects "$(channel "$through" 'region dam block 0.9 1.3 -1 0.98 INF INF')" "$closed" # a gap that no cell has
rejects "$(channel 'flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi inlet velocity 1 0 0' 'region dam block 0.9 1.3 -1 2 INF INF')" "$closed"
# -check says so, too
channel "$through" 'region dam block 0.9 1.3 -1 2 INF INF' >in.script
refused 'check' "$closed" -in in.script -check
# two bodies together, in any order
for order in '0.5 2|-1 0.5' '-1 0.5|0.5 2'; do
	rejects "$(channel "$through" "region other block 0.9 1.3 ${order%|*} INF INF
region dam block 0.9 1.3 ${order#*|} INF INF
fix other all immersed/boundary region other min_cells 1")" "$closed"
done
# grains side by side
grains='units si
atom_style granular
boundary f p p
region box block 0 2 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.8 0.25 0.25 units box
create_atoms 1 single 0.8 0.75 0.25 units box
create_atoms 1 single 0.8 0.25 0.75 units box
create_atoms 1 single 0.8 0.75 0.75 units box
set group all diameter DIAMETER density 2000
set group all type 1
pair_style none
flow_style projection cells 20 10 10 viscosity 0.05 density 1
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
fix grains all immersed/boundary spheres
timestep 0.002
run 2
print "went"'
rejects "${grains/DIAMETER/0.75}" "fix grains (immersed/boundary spheres): $closed"
prints "${grains/DIAMETER/0.48}" went

# ---- what has a way, or nothing to bring out
for body in 'block 0.9 1.3 -1 0.96' 'cylinder z 1 0.5 0.3'; do
	prints "$(channel "$through" "region dam $body INF INF")" went
done
prints "$(channel "$through" 'region dam cylinder z 1 0.5 0.2 INF INF
region round cylinder z 1 0.5 0.35 INF INF side out
region hole cylinder z 1 0.5 0.45 INF INF
region ring intersect 2 round hole
fix ring all immersed/boundary region ring min_cells 1')" went
prints "$(channel 'flow_boundary xlo inlet pressure 1
flow_boundary xhi outlet' 'region dam block 0.9 1.3 -1 2 INF INF')" went
prints "$(channel 'flow_boundary xhi outlet' 'region dam block 0.9 1.3 -1 2 INF INF')" went
prints "$(channel 'flow_boundary ylo wall velocity 1 0 0' 'region dam block 0.9 1.3 -1 2 INF INF')" went

# ---- closed on the way: a gate that falls, an inlet that opens
gate='variable s equal -time
region dam block 0.9 1.3 0.3 1.9 INF INF move NULL v_s NULL'
channel "$through" "$gate" | sed 's/^run 20/thermo 20\nrun 200/; s/density 1$/density 1 substeps auto/' >in.script
refused 'a gate that falls' "fix dam (immersed/boundary region dam): $closed" -in in.script
awk '/^ +[0-9]+ / { last = $1 } END { exit !(last == 40) }' out # the gap of 0.3 is closed after 60 steps, but for half a cell
report 'a gate that falls, when' $? out
channel 'variable in equal (step>7)*0.3
flow_boundary xlo inlet velocity v_in 0 0
flow_boundary xhi outlet' 'region dam block 0.9 1.3 -1 2 INF INF' | sed 's/^run/thermo 1\nrun/' >in.script
refused 'an inlet that opens' 'it flows in there at 0.3 per time' -in in.script
awk '/^ +[0-9]+ / { last = $1 } END { exit !(last == 7) }' out
report 'an inlet that opens, when' $? out

# ---- bodies that push
piston='variable s equal -0.5*time
region dam block 0.9 1.3 -1 2 INF INF move v_s NULL NULL'
rejects "$(channel 'flow_boundary xhi outlet' "$piston")" 'the body pushes fluid at 0.5 per time that it closes off about (0.9171 0.5 0)'
rejects "$(channel 'flow_boundary xlo outlet' "$piston")" 'the body draws fluid at 0.5 per time'
rejects "$(channel '' "$piston")" 'at 0.5 per time that it closes off about'
prints "$(channel 'flow_boundary xlo outlet
flow_boundary xhi outlet' "$piston")" went
prints "$(channel 'flow_boundary xhi outlet
flow_boundary xlo inlet velocity -0.5 0 0' "$piston")" went
prints "$(channel '' "${piston/-1 2/-1 0.8}")" went
prints "$(channel '' 'variable s equal -0.5*time
region dam cylinder z 1 0.47 0.2 INF INF move v_s NULL NULL')" went

# ---- on an inlet: refused, but where the velocity is that of the body; on an outlet as anywhere
rejects "$(channel "$through" 'region dam cylinder z 0 0.5 0.2 INF INF')" 'the body stands on flow_boundary xlo, at (0 0.3438 0), where fluid is to cross the face with velocity 1 and the body has 0'
half='units si
boundary f f p
dimension 2
region box block 0 2 0 1 -0.5 0.5 units box
create_box 1 box
variable yy internal 0
variable u equal "(v_yy>0.5)*(v_yy-0.5)*(1-v_yy)*16"
flow_style projection cells 24 16 1 viscosity 1 density 1 time rk2
flow_boundary xlo inlet IN
flow_boundary xhi outlet
region dam block -1 3 -1 0.5 INF INF
fix dam all immersed/boundary region dam
timestep 0.0005
run 600
compute b all flow/line cells y 1.99 0 values y vx
variable y vector c_b[1]
variable exact vector (v_y>0.5)*(v_y-0.5)*(1-v_y)*16
variable e vector abs(c_b[2]-v_exact)
print "is $(max(v_e)<0.01) $(f_dam[7]<1e-3)"'
for in in 'velocity v_u 0 0 set y yy update once' 'pressure 64'; do
	prints "${half/IN/$in}" 'is 1 1'
done
rejects "${half/IN/velocity 1 0 0}" 'the body stands on flow_boundary xlo'
finish
