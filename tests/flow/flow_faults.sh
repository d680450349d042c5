#!/bin/bash
# What is wrong with a fluid is said, with its cause and its place: faces that do not fit, cells, numbers, variables,
# steps that are too large; NaN never travels.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >box <<'END'
units si
boundary f f f
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
END
cat >fluid <<'END'
include box
flow_style projection cells 8 6 5 viscosity 0.1 density 2
timestep 1e-4
END

# steps: what limits them is named
rejects 'include fluid
fix T all flow/scalar conductivity 1e9 capacity 1 initial 310 xlo value 320
run 1' 'substeps, 1e+06 at most'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 1e30 density 2 substeps auto
run 1' 'it is to make, limited by its viscosity'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 1e-30 density 2 substeps auto time rk3
flow_boundary yhi wall velocity 1e30 0 0
run 1' 'it is to make, limited by its velocity'

# scalars
plane='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 8 1 viscosity 0.1 density 2
timestep 1e-4'
rejects "$plane
fix T all flow/scalar zlo value 500
run 1" 'zlo: with one cell along z nothing varies there'
rejects "$plane
fix T all flow/scalar xhi value 3 zlo none zhi flux 7
run 1" 'zhi: with one cell along z nothing varies there'
rejects 'include fluid
variable yy internal 0
fix T all flow/scalar initial 3 set y yy
run 1' 'set y: `initial` is the number 3, which does not depend on coordinates'

# faces
rejects 'include fluid
flow_boundary xlo inlet velocity 1 0 0
run 1' 'the fluid cannot leave: through all faces together it flows in at 0.125 per time'
rejects 'include fluid
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi inlet velocity 2 0 0
run 1' 'the fluid cannot come in: through all faces together it flows out at 0.125'
rejects 'include fluid
flow_boundary ylo wall velocity 0 1 0
run 1' 'the fluid cannot leave'
rejects 'include fluid
flow_boundary xlo slip velocity 1 0 0' 'at slip faces no velocity is given'
rejects 'include fluid
flow_boundary xlo wal' "did you mean 'wall'?"
rejects 'include fluid
flow_boundary xl wall' 'expected one of'
rejects 'include fluid
flow_boundary xlo wall velocity 1 0' 'velocity: z is missing'
rejects 'units si
boundary p p p
region box block 0 1 0 0.5 0 0.25 units box
create_box 1 box
flow_style projection cells 8 6 5 viscosity 0.1 density 2
flow_boundary xlo outlet
run 1' 'flow_boundary xlo: the box is periodic there'
# the line that says so: not another face, nor flow_style
rejects 'include fluid
flow_boundary xlo inlet velocity 0 0 0
flow_boundary ylo wall velocity 0 1 0
flow_boundary xhi inlet velocity 0 1 0
run 1' ':3:1: error: the fluid cannot leave'
rejects 'include fluid
flow_boundary xlo inlet velocity -1 0 0
flow_boundary xhi inlet velocity -3 0 0
run 1' ':3:1: error: the fluid cannot leave'
# coordinates that nothing would use, or two in one variable
rejects 'include fluid
variable yy internal 0
flow_boundary xlo inlet velocity 1 0 0 set y yy' 'all values of the face are numbers'
rejects 'include fluid
variable yy internal 0
variable u equal v_yy
flow_boundary xlo inlet velocity v_u 0 0 set y yy set z yy' 'this variable has another coordinate already'
rejects 'include fluid
variable yy internal 0
variable zz internal 0
variable u equal v_yy
flow_boundary xlo inlet velocity v_u 0 0 set y yy set y zz' 'this coordinate has one already'
# what flows in flows out again
prints 'include fluid
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi inlet velocity 1 0 0
compute in all flow/flux xlo
compute out all flow/flux xhi
run 3
print "flux $(c_in:%g) $(c_out:%g)"' 'flux 0.125 0.125'

# order of commands
rejects 'flow_style projection cells 8 6 5 viscosity 0.1 density 2' 'there is no simulation box yet'
rejects 'include box
flow_boundary xlo outlet' 'flow_boundary needs a fluid: use flow_style projection before it'
rejects 'include box
flow_set velocity 1 0 0' 'flow_set needs a fluid: use flow_style projection before it'

# cells and numbers
rejects 'include box
flow_style projection cells 8 6 viscosity 1 density 2' 'cells: NZ is missing'
rejects 'include box
flow_style projection cells 8 0 5 viscosity 1 density 2' 'cells: NY is 0'
rejects 'include box
flow_style projection cells 8 6.5 5 viscosity 1 density 2' "cells: NY is '6.5'"
rejects 'include box
flow_style projection cells 80000 60000 50000 viscosity 1 density 2' \
	':2:29: error: flow_style projection: out of memory: 80000 x 60000 x 50000 cells need 1.54e+07 GB'
rejects 'include box
flow_style projection cells 8 6 5 viscosity -1 density 2' 'viscosity is -1, expected a number >= 0'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 0 density 2 viscous implicit
run 1' 'viscous implicit needs a viscosity above 0'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 0 density 2 viscous backward
run 1' 'viscous backward needs a viscosity above 0; use viscous explicit'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 1 density 0' 'density is 0, expected a number > 0'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 1 density 2 region bix' "no region 'bix'; did you mean 'box'?"
rejects 'include fluid
flow_set velocity nan 0 0' "x is 'nan'"

# walls hold a fluid without viscosity: that is said, once; slip is not wrong
warns() { # COUNT SCRIPT
	printf '%s\n' "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 </dev/null && [ "$(grep -c 'viscosity 0 does not stick' out)" = "$1" ]
	report "$2" $? out
}
inviscid='include box
flow_style projection cells 8 6 5 viscosity 0 density 2
timestep 1e-4'
warns 1 "$inviscid
run 1
run 1"
warns 0 "$inviscid
flow_boundary all slip
run 1"
warns 1 "$inviscid
flow_boundary all slip
region ball sphere 0.5 0.25 0.125 0.07
fix body all immersed/boundary region ball min_cells 0
run 1"
warns 0 'include fluid
run 1'

# variables
rejects 'include fluid
flow_boundary xlo inlet velocity v_none 0 0' "unknown variable 'none'"
rejects 'include fluid
flow_set velocity 0 v_none 0' "unknown variable 'none'"
rejects 'include box
flow_style projection cells 8 6 5 viscosity 0.1 density 2 body_force v_none 0 0
run 1' "unknown variable 'none'"
rejects 'include fluid
variable yy internal 0
variable p equal v_yy
flow_boundary xlo inlet velocity v_p 0 0 set y zz
flow_boundary xhi outlet
run 1' "unknown variable 'zz'"
rejects 'include fluid
variable a atom x
flow_boundary xlo inlet velocity v_a 0 0
flow_boundary xhi outlet
run 1' 'one number is needed here'

# NaN and infinities stop where they come up, in the run too
rejects 'include fluid
variable a equal 1/(step-3)
flow_boundary xlo inlet velocity v_a 0 0
flow_boundary xhi outlet
run 5' "division of 1 by zero (variable 'a'"
rejects 'include fluid
variable a equal sqrt(-step)
flow_boundary xlo inlet velocity v_a 0 0
flow_boundary xhi outlet
run 5' 'sqrt is not a real number'
rejects 'include box
variable a equal exp(step)^80
flow_style projection cells 8 6 5 viscosity 0.1 density 2 body_force v_a 0 0
timestep 1e-4
run 500' 'error:'

# steps
rejects 'include fluid
flow_boundary yhi wall velocity 1 0 0
timestep 1
run 5' 'exceeds the stability limit'
rejects 'include box
flow_style projection cells 8 6 5 viscosity 0.0001 density 2
flow_boundary yhi wall velocity 1 0 0
timestep 0.5
run 500' "stability limit 0.125 of the fluid's Courant number"
rejects 'include box
variable faster equal time
flow_style projection cells 8 6 5 viscosity 0.0001 density 2
flow_boundary yhi wall velocity v_faster 0 0
timestep 0.1
run 500' 'the fluid left the region of stable steps at time'
finish
