#!/bin/bash
# Two dimensions: discs, their masses, inertia and collisions; what holds them in the plane; rejections.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

plane='units si
dimension 2
boundary p p p
region box block 0 1 0 1 -0.05 0.05 units box
create_box 1 box
create_atoms 1 single 0.4 0.5 0 units box
create_atoms 1 single 0.6 0.5 0 units box
group left id 1
group right id 2
set group all diameter 0.102 density 2385
variable m equal PI*0.051^2*2385'

# mass = density pi R^2; energy of rotation m R^2 omega^2 / 4 of discs, m R^2 omega^2 / 5 of spheres
prints "$plane
set atom 1 omegaz 7.3
fix move all nve/sphere inertia disc
run 0
print \"disc \$(mass(left)/v_m:%.12g) \$(erotate/(0.25*v_m*0.051^2*7.3^2):%.12g) \$(density[1]:%.12g) \$(vol)\"" \
	'disc 1 1 2385 1'
prints "$plane
set atom 1 omegaz 7.3
fix move all nve/sphere inertia sphere
run 0
print \"sphere \$(mass(left)/v_m:%.12g) \$(erotate/(0.2*v_m*0.051^2*7.3^2):%.12g)\"" 'sphere 1 1'
prints "$plane
fix move all nve/sphere
run 0" '*warning: particles rotate as discs'

# A torque T for a time t: omega = T t / (m R^2 / 2), and a torque on a sphere T t / (0.4 m R^2).
turned() { # words, factor
	prints "$plane
fix move all nve/sphere $1
fix twist left addtorque 0 0 0.00385
timestep 0.001
run 400
print \"turned \$(omegaz[1]/(0.00385*0.4/($2*v_m*0.051^2)):%.10g) \$(omegaz[2])\"" 'turned 1 0'
}
"$TSIM" -help fix addtorque >out 2>&1 && {
	turned disc 0.5
	turned 'inertia sphere' 0.4
}

# Discs without damping collide head-on and off-centre: momentum and energy stay, nothing leaves the plane.
prints "$plane
velocity left set 0.7 0.05 0
velocity right set -0.2 0 0
pair_style spring/dashpot
pair_coeff * * stiffness 20000 damping 0
fix move all nve/sphere disc
variable before equal ke
variable energy equal \${before}
timestep 1e-5
run 30000
variable z atom \"abs(z)+abs(vz)+abs(fz)\"
compute out all reduce sum v_z
print \"energy \$(abs(ke/v_energy-1) < 1e-6) momentum \$(vcm(all,x):%.10g) \$(vcm(all,y):%.10g) out \$(c_out)\"
print \"exchanged \$(vx[1] < 0 && vx[2] > 0.4)\"" 'energy 1 momentum 0.25 0.025 out 0' 'exchanged 1'

# Forces and images in the plane only: a disc across the periodic edge, a thin box
prints "$plane
create_atoms 1 single 0.98 0.5 0 units box
create_atoms 1 single 0.06 0.5 0 units box
group rest id 3 4
set group rest diameter 0.102 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 1000 damping 0
fix move all nve/sphere disc
run 0
print \"push \$(fx[3]:%.10g) \$(fx[4]:%.10g)\"" 'push -22 22'
# lattice, random and displaced particles stay in the plane
prints 'units lj
dimension 2
lattice hex 0.9
region box block 0 10 0 10 -0.1 0.1
create_box 1 box
create_atoms 1 box
create_atoms 1 random 50 7919 NULL
displace_atoms all random 0.1 0.1 0 86028157
replicate 2 3 1
variable z atom abs(z)
compute out all reduce max v_z
print "stays $(count(all)) $(c_out)"' 'stays 1500 0'
prints "$plane
set atom 1 z 0.01
fix move all nve
run 0" '*particle 1 is out of the plane'

rejects 'dimension 2
boundary p p f
region box block 0 1 0 1 -1 1
create_box 1 box' 'periodic in z'
rejects 'dimension 2
region box block 0 1 0 1 0.5 1
create_box 1 box' 'must contain the plane z = 0'
rejects 'dimension 2
lattice fcc 1' 'lattice fcc has 3 dimensions, the simulation has 2'
rejects 'dimension 2
lattice custom 1 basis 0 0 0.5' 'have no z'
rejects 'lattice hex 1' 'lattice hex has 2 dimensions'
rejects "$plane
change_box all boundary p p f" 'periodic in z'
rejects "$plane
replicate 1 1 2" 'nz must be 1'
rejects "$plane
displace_atoms all rotate 0 0 0 1 0 0 30" 'the axis is along z'
rejects "$plane
fix a left nve/sphere disc
fix b right nve/sphere inertia sphere" 'has another inertia'
rejects 'region box block 0 1 0 1 0 1
create_box 1 box
fix a all nve/sphere disc' 'discs need `dimension 2`'
rejects 'region box block 0 1 0 1 0 1
create_box 1 box
dimension 2' 'must come before'
finish
