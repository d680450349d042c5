#!/bin/bash
# Regions: volumes by counting lattice points, motion against closed forms, units, and every rejection.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A fine lattice, turned and shifted so that it shares no plane with the regions; each point stands for
# 0.0385^3.
grid='units si
boundary p p p
region box block -1.155 1.155 -1.155 1.155 -1.155 1.155 units box
create_box 2 box
lattice sc 0.0385 origin 0.31 0.53 0.17 orient x 1 2 2 orient y 2 1 -2 orient z -2 2 -1
create_atoms 1 box
variable t equal 0.7
variable q equal 0.31'

# The volume known and the volume counted agree within 1 per cent.
volume() {
	prints "$grid
region r $1 units box
variable off equal abs(count(all,r)*0.0385^3/volume(r)-1)
if \"\${off} < 0.01\" then 'print agree'" agree
}
volume 'block -0.5 0.7 -0.3 1.1 0 1'
volume 'sphere 0.2 0.1 -0.1 0.83'
volume 'sphere 0.2 0.1 -0.1 v_t'
volume 'ellipsoid 0.2 0.1 -0.1 0.83 0.51 0.72'
volume 'ellipsoid 0.2 0.1 -0.1 0.83 0.51 0.72 rotate v_t 0.1 0.2 0.3 1 2 3'
volume 'cylinder x 0.2 0.1 0.61 -0.5 1.07'
volume 'cylinder y 0.2 0.1 0.61 -0.5 1.07 move v_q NULL v_q'
volume 'cylinder z 0.2 0.1 v_t -0.5 EDGE'
volume 'cone x 0.2 0.1 0.31 0.83 -0.5 1.07'
volume 'cone z 0.2 0.1 0.83 0 -0.5 1.07'
volume 'prism -0.5 0.6 -0.3 0.7 -0.6 0.6 0.31 -0.23 0.41'
volume 'prism -0.5 0.6 -0.3 0.7 -0.6 0.6 0.31 -0.23 0.41 rotate v_t 0 0 0 0 1 1'
volume 'wedge axis x center 0.1 0.2 radius 0.83 bounds -0.7 0.9 angle0 20 angle 70'
volume 'wedge axis z center 0.1 0.2 radius 0.83 bounds -0.7 EDGE angle0 200 angle 245'

# Closed form: a ball of radius 0.2 that goes round the origin at 0.5, one turn in 8 steps.
prints "units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0.5 0 0 units box
create_atoms 1 single 0 0.5 0 units box
create_atoms 1 single -0.5 0 0 units box
create_atoms 1 single -0.1 -0.5 0 units box
set group all diameter 0.01
variable angle equal 2*PI*step/8
variable up equal 0.3*step
region ball sphere 0.5 0 0 0.2 units box rotate v_angle 0 0 0 0 0 1
region lift block -1 -0.4 -1 1 -0.5 0.1 units box move NULL NULL v_up
region both intersect 2 ball lift
variable here atom id*rmask(ball)
variable top atom id*rmask(both)
compute who all reduce sum v_here
compute most all reduce sum v_top
fix move all nve
fix say all print 1 'step \$(step) particle \$(c_who) both \$(c_most)' screen yes
timestep 0.1
run 8" '*step 1 particle 0' 'step 2 particle 2 both 0' 'step 4 particle 3 both 0' \
	'*step 6 particle 4' '*step 8 particle 1'
# One that is moved as a whole, and the box around it.
prints "$grid
region a block 0 0.2 0 0.3 0 0.4 units box
region b block 0.2 0.5 0 0.3 0 0.4 units box
variable back equal -0.5
region both union 2 a b side in move v_back v_back NULL
group there region both
group here region a
variable out atom \"id*(x > 0 || y > -0.2)\"
print \"moved \$(bound(there,xmin) > -0.5 && bound(there,xmax) < 0 && bound(there,ymax) < -0.2)\"" 'moved 1'
# lattice units go by dimension; radii by the first of the other two; displacements are lengths
prints "units si
lattice none 1 spacing 0.1 0.2 0.5
boundary f f f
region box block 0 10 0 5 0 2 units lattice
create_box 1 box
region c cylinder y 5 1 2 0 5 units lattice
region s sphere 1 1 1 2 units lattice
print \"sizes \$(volume(c)/PI:%.12g) \$(volume(s)/PI*0.75:%.12g) \$(lx) \$(ly) \$(lz)\"" 'sizes 0.04 0.008 1 1 1'
# EDGE is the face where it was when the region was defined; delete forgets a region
prints "units si
boundary f f f
region box block 0 1 0 2 0 3 units box
create_box 1 box
region e block EDGE 0.5 INF INF EDGE EDGE units box
region f block EDGE EDGE EDGE EDGE EDGE EDGE
change_box all x final -1 4 units box
create_atoms 1 single -0.5 1 1 units box
print \"inside \$(count(all,e))\"
print \"volume \$(volume(f))\"
region f delete
region f block 0 1 0 1 0 0.25
print \"now \$(volume(f))\"" 'inside 0' 'volume 6' 'now 0.25'

# lengths without units: as they are, but in lj units in lattice spacings; never silently
prints 'units si
lattice none 0.5
region box block 0 2 0 2 0 2
print "as it is $(volume(box))"' 'as it is 8' '*as in LIGGGHTS'
prints 'units lj
lattice none 0.5
region box block 0 2 0 2 0 2
print "in spacings $(volume(box))"' 'in spacings 1' '*as in LAMMPS'

rejects 'region r block EDGE 1 0 1 0 1' 'there is no box yet'
rejects 'region r block 1 0 0 1 0 1' 'is above'
rejects 'region r cone z 0 0 1 2 INF 1' 'both ends must be finite'
rejects 'region r prism 0 1 0 1 0 INF 0 0 0' 'all faces must be finite'
rejects 'region r ellipsoid 0 0 0 1 0 1' 'expected a number > 0'
rejects 'variable r equal -1
region r sphere 0 0 0 v_r' 'the radius is -1'
rejects 'region r sphere 0 0 0 v_r' "unknown variable 'r'"
rejects 'region r sphere 0 0 0 1 move v_a NULL NULL' "unknown variable 'a'"
rejects 'variable a equal 1
region r sphere 0 0 0 1 move v_a NULL' 'v_z is missing'
rejects 'variable a equal 1
region r sphere 0 0 0 1 rotate v_a 0 0 0 0 0 0' 'axis of rotate is zero'
rejects 'variable a equal 1
region r sphere 0 0 0 1 rotate v_a 0 0 0 1 0' 'third of three numbers'
rejects 'region r block 0 1 0 1 0 1 open 7' 'expected a face from 1 to 6'
rejects 'region r wedge axis z center 0 0 radius 1 bounds 0 1 angle0 0 angle 0' 'angle is 0'
rejects 'region r wedge axis z center 0 radius 1 bounds 0 1 angle0 0 angle 10' 'c2 is missing'
rejects 'region r wedge axis z radius 1 bounds 0 1 angle0 0 angle 10' 'c1 is missing'
rejects 'region r mesh/tet file a.vtk scale 1' 'cannot open'
rejects 'region r plane 0 0 0 0 0 1
print "$(volume(r))"' 'is not known'
rejects "region r0 sphere 0 0 0 1
$(for k in $(seq 59); do echo "region r$k union 2 r$((k - 1)) r$((k - 1))"; done)" 'consists of 2.1e+06 regions'
finish
