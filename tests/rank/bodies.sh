#!/bin/bash
# Bodies in a fluid that ranks divide: what all find is told once, regions that a body closes off are refused, and a rank has a part of
# the grid. That results are those of one rank: tests/rank/contract.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

cp "$top_srcdir/tests/rank/scenes/in.sluice" .
"$TSIM" -in in.sluice -log none -var out one >out 2>&1
report 'a gate and balls, one rank' $? out
said one.said
[ "$(grep -c 'overlap with different velocities, at [0-9]* points' one.said)" = 1 ] && [ "$(grep -c 'covers a part of the wall' one.said)" = 2 ]
report 'it warns of what bodies cover' $? one.said
for n in 2 5; do
	on_ranks $n "$TSIM" -in in.sluice -log none -var out many >out 2>&1 </dev/null
	report "a gate and balls, $n ranks" $? out
	said many.said
	same "warnings of $n ranks" one.said many.said
done

# A plate that goes down closes off the fluid below it, at once or when it has slid across.
plate() { # WORDS AFTER BLOCK
	cat <<-END
		units si
		boundary f f f
		region box block 0 0.04 0 0.04 0 0.06 units box
		create_box 1 box
		timestep 5e-4
		flow_style projection cells 20 20 30 viscosity 1e-2 density 1000
		flow_boundary zhi outlet
		flow_boundary xlo slip
		flow_boundary xhi slip
		flow_boundary ylo slip
		flow_boundary yhi slip
		variable slide equal -0.008+2*time
		region plate block INF INF $1 units box
		fix plate all immersed/boundary region plate velocity 0 0 -0.02
		run 40
	END
}
plate '-0.01 0.05 0.026 0.034' >in.shut
plate '-0.01 0.036 0.026 0.034 move NULL v_slide NULL' >in.slides
for scene in shut slides; do
	for n in 1 3; do
		on_ranks $n "$TSIM" -in in.$scene -log none >out 2>&1 </dev/null
		[ $? != 0 ] && [ "$(grep -c "in.$scene:14:[0-9]*: error: .* the body pushes fluid at .* that it closes off about" out)" = 1 ]
		report "$scene: refused by $n ranks" $? out
		grep -o 'error: .*' out >"error.$n"
		[ $scene = shut ] || grep -q '^ *0  *' out
		report "$scene: when, $n ranks" $? out
	done
	same "$scene: the message of three ranks" error.1 error.3
done

# Of a rank, in a grid of 32 x 32 x 96 cells with a ball: planes of its own and four on each side.
{
	plate '-0.01 0.05 0.026 0.034' | sed '/^variable/,$d; s/cells 20 20 30/cells 32 32 96/'
	printf '%s\n' 'region ball sphere 0.02 0.02 0.031 0.01 units box' 'fix ball all immersed/boundary region ball' 'run 1'
} >in.ball
"$TSIM" -in in.ball -explain -ranks 4 -log none >out 2>&1
grep -q "^  fluid's planes  *each rank has up to 32 of 100 in memory" out
report 'planes of a rank' $? out

# What is told by several ranks in the rows of a log and the end of a dump: clumps of a stream of which ranks share bodies, the pressure
# in a box that is mapped, forces on a mesh in the first row of a run.
# rectangle XLO XHI YLO YHI Z
rectangle() {
	awk -v a="$1" -v b="$2" -v c="$3" -v d="$4" -v z="$5" 'function facet(p, q, r) {
		print " facet normal 0 0 1\n  outer loop\n   vertex", p, z "\n   vertex", q, z "\n   vertex", r, z "\n  endloop\n endfacet"
	}
	BEGIN { print "solid face"; facet(a " " c, b " " c, b " " d); facet(a " " c, b " " d, a " " d); print "endsolid face" }'
}
rectangle -0.02 0.02 -0.02 0.02 0.15 >face.stl
rectangle 0.001 0.039 0.001 0.029 0.02 >floor.stl
rectangle 0 0.04 0 0.03 0.049 >lid.stl
cat >in.rain <<'END'
units si
region r block -0.06 0.06 -0.06 0.06 0 0.25 units box
create_box 2 r
pair_style gran/hooke 1000 NULL 10 NULL 0 0
pair_coeff * *
timestep 1e-5
fix pair all particletemplate/multisphere 15485867 atom_type 2 density constant 1500 nspheres 2 ntry 10000 spheres 0 0 0 0.002 0.003 0 0 0.002 type 2
fix mix all particledistribution/discrete 32452843 1 pair 1.0
fix face all mesh/surface/planar file face.stl type 1
fix rain all insert/stream seed 86028121 distributiontemplate mix nparticles 60 particlerate 3000 overlapcheck yes all_in no vel constant 0 0 -2 insertion_face face extrude_length 0.03
fix ms all multisphere
fix fall all gravity 9.81 vector 0 0 -1
thermo_style custom step atoms ke
run 300
write_dump all custom ${out}.dump id type x y z vx vy vz modify sort id format float %.17g
END
cat >in.squeezed <<'END'
units si
boundary p f f
region b block 0 0.0396 0 0.03 -0.002 0.05 units box
create_box 1 b
lattice sc 0.00495 origin 0.5 0.5 0.52
region fill block 0 0.0396 0.002 0.028 0.002 0.0125 units box
create_atoms 1 region fill
set group all diameter 0.005 density 2500
timestep 2e-5
pair_style gran/hooke/history 3000 NULL 20 NULL 0.5 1
pair_coeff * *
fix move all nve/sphere
fix x all deform 3 x erate -1 remap x
compute p all pressure NULL pair
fix mean all ave/time 3 1 3 c_p[1] file ${out}.text format %.17g
thermo_style custom step pxx press
thermo_modify format float %.17g
thermo 3
run 12
END
cat >in.again <<'END'
units si
boundary p f f
region b block 0 0.04 0 0.03 -0.002 0.05 units box
create_box 1 b
lattice sc 0.0055 origin 0 0 0.1
region fill block 0.001 0.038 0.002 0.028 0.0221 0.04 units box
create_atoms 1 region fill
set group all diameter 0.005 density 2500
velocity all set 0.2 0.1 -0.3 units box
timestep 2e-5
pair_style gran/hooke/history 300 NULL 2 NULL 0.5 1
pair_coeff * *
fix move all nve/sphere
fix fall all gravity 9.81 vector 0.1 0 -1
fix m all mesh/surface/stress file floor.stl type 1
fix w all wall/gran hooke/history 300 NULL 2 NULL 0.5 1 mesh n_meshes 1 meshes m
thermo_style custom step ke f_m[1] f_m[2] f_m[3] f_w[1] f_w[2] f_w[3]
thermo_modify format float %.17g
thermo 40
run 240
unfix w
fix m2 all mesh/surface/stress file lid.stl type 1
fix w all wall/gran hooke/history 300 NULL 2 NULL 0.5 1 mesh n_meshes 2 meshes m m2
run 40
END
for scene in rain squeezed again; do same_on $scene 2 3; done
finish
