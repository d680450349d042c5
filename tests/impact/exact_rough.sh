#!/bin/bash
# impact exact on a rough height field at 35 degrees, with contacts nearly as long as a time step: without losses and
# friction all spheres keep their energy, so none has got into a column that another one hid.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cat >in.rough <<'LINES'
units si
atom_style granular
boundary p p f
region b block 0 1 0 1 -1 6 units box
create_box 1 b
hard_particles yes
thermo_modify lost ignore
fix kn all property/global kn peratomtypepair 1 1e6
fix kt all property/global kt peratomtypepair 1 0
fix gn all property/global gamman peratomtypepair 1 0
fix gt all property/global gammat peratomtypepair 1 0
fix mu all property/global coefficientFriction peratomtypepair 1 0
fix s all surface/voxel gaussian mean 0 deviation 0.0005 correlation 0.01 seed 17 type 1 cells 80 80
fix w all wall/gran model hooke/stiffness tangential off voxels s impact exact
fix worn all wear/formula surface s volume 0
region seeds block 0 1 0 1 0.05 1.3 units box
create_atoms 1 random 8000 4711 seeds
set group all diameter 0.025 density 1000
velocity all set 7 0.7 -5 units box
fix move all nve/sphere
timestep 1e-3
variable before equal ke
variable e0 equal ${before}
run 380
print "kept $(abs(ke/v_e0-1)<1e-9) impacts $(f_worn[3]>5000) $(ke/v_e0-1)"
LINES
"$TSIM" -in in.rough -log none >out 2>&1 && grep -q '^kept 1 impacts 1 ' out
report 'spheres keep their energy' $? out
finish
