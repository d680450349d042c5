#!/bin/bash
# A fluid does not depend on the number of threads, bit for bit: tables and restart files of a cylinder, a sphere, a
# mesh that turns and a bed of spheres, with faces of all kinds and pressure solvers that iterate.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
export OMP_WAIT_POLICY=passive # there may be fewer cores than threads

# threads WHAT SCRIPT: with 1, 2 and 3 threads, every loop shared, the same numbers
threads() {
	printf 'package omp ${threads} grain 1\nunits si\n%s\nwrite_restart t${threads}.restart\n' "$2" >in.threads
	rm -f ./*.restart
	for t in 1 2 3; do
		"$TSIM" -in in.threads -log "log.$t" -screen none -var threads $t 2>err
		report "$1, $t threads" $? err
		rows "log.$t" >"rows.$t"
	done
	for t in 2 3; do
		same "$1: tables on $t threads" rows.1 "rows.$t"
		same "$1: fields on $t threads" t1.restart "t$t.restart"
	done
}

threads 'cylinder' 'dimension 2
boundary f f p
region box block 0 2 0 1 -0.1 0.1 units box
create_box 1 box
flow_style projection cells 40 24 1 viscosity 0.01 density 1 time rk2
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
flow_boundary ylo slip
region round cylinder z 0.61 0.47 0.153 INF INF
fix body all immersed/boundary region round
timestep 0.005
thermo_style custom step f_body[1] f_body[2] f_body[6]
thermo 1
run 5'

threads 'sphere that moves' 'boundary f p p
region box block 0 1.5 0 1 0 1 units box
create_box 1 box
flow_style projection cells 18 13 12 viscosity 0.01 density 1
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
pressure_style cg preconditioner multigrid
variable s equal 0.1*time
region round sphere 0.61 0.47 0.52 0.253 move v_s NULL NULL
fix body all immersed/boundary region round iterations 2
timestep 0.01
thermo_style custom step f_body[1] f_body[2] f_body[6]
thermo 1
run 5'

awk 'BEGIN { # an octahedron
	print "solid o"
	for (k = 0; k < 8; k++) {
		a = k % 2 ? 1 : -1; b = int(k / 2) % 2 ? 1 : -1; c = int(k / 4) ? 1 : -1
		print "facet normal 0 0 0\nouter loop"
		print "vertex", 0.31 * a, 0, 0
		y = "vertex 0 " 0.31 * b " 0"; z = "vertex 0 0 " 0.31 * c
		print (a * b * c > 0 ? y "\n" z : z "\n" y)
		print "endloop\nendfacet"
	}
	print "endsolid o"
}' >octahedron.stl
threads 'mesh that turns' 'atom_style granular
boundary p p p
region box block -0.5 0.5 -0.5 0.5 -0.5 0.5 units box
create_box 1 box
fix octahedron all mesh/surface file octahedron.stl type 1
fix turn all move/mesh mesh octahedron rotate origin 0 0 0 axis 0 0 1 period 0.5
flow_style projection cells 14 13 12 viscosity 0.02 density 1
fix body all immersed/boundary mesh octahedron
timestep 0.01
thermo_style custom step f_body[1] f_body[2] f_body[6]
thermo 1
run 4'

# spheres whose points meet: which of them owns a point
threads 'spheres' 'atom_style granular
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.31 0.42 0.53 units box
create_atoms 1 single 0.68 0.47 0.55 units box
create_atoms 1 single 0.93 0.99 0.02 units box
create_atoms 1 single 0.37 0.81 0.49 units box
set group all diameter 0.38 density 2.385
set group all type 1
velocity all set 0.3 -0.2 0.1
fix move all nve/sphere
pair_style none
flow_style projection cells 15 14 13 viscosity 0.02 density 1
fix body all immersed/boundary spheres
timestep 0.01
thermo_style custom step f_body[1] f_body[2] f_body[6] f_body[7] ke
thermo 1
run 4'

# the weights of faces differ: the choice of the preconditioner looks at them
threads 'bed' 'atom_style granular
boundary p p f
region box block 0 0.02 0 0.02 0 0.03 units box
create_box 1 box
lattice sc 0.0025
region bed block INF INF INF INF 0 0.015 units box
create_atoms 1 region bed
set group all diameter 0.0022 density 2500
velocity all create 1e-20 4711
fix move all nve/sphere
pair_style none
flow_style projection cells 5 4 9 viscosity 1.8e-5 density 1.2
flow_boundary zlo inlet velocity 0 0 0.4
flow_boundary zhi outlet
pressure_style cg
fix room all void_fraction
fix drag all drag/di_felice
timestep 1e-4
thermo_style custom step f_drag[3] f_drag[4] ke
thermo 1
run 5'
finish
