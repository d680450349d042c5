#!/bin/bash
# A mesh whose images are in the periodic box, while it is far away itself: it has moved through the box, or was read there. It is
# touched, passed, counted and kept clear of as if it were in the box.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 2 0 >plate.stl
head='units si
hard_particles yes
atom_style sphere
boundary p p f
region box block -0.5 0.5 -0.5 0.5 -0.5 0.5 units box
create_box 1 box
fix Y all property/global youngsModulus peratomtype ${Y}
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.5
fix mu all property/global coefficientFriction peratomtypepair 1 0
pair_style gran model hertz tangential no_history
pair_coeff * *
create_atoms 1 single 0.03 0.07 0.4
set group all diameter 0.05 density 2000
fix floor all mesh/surface file plate.stl type 1 move ${at} ${at} 0
fix down all gravity 1 vector 0 0 -1
fix move all nve/sphere
timestep 1e-4
thermo_modify lost ignore'

# Without friction a belt does not differ from a floor at rest, wherever it is.
for impact in exact resolved; do
	for belt in '0 0' '0.3 0' '-3.3 0' '0 40' '0.7 -7'; do
		read -r speed at <<<"$belt"
		printf '%s\n' "$head" "fix w all wall/gran model hertz tangential no_history mesh n_meshes 1 meshes floor impact $impact" \
			"fix belt all move/mesh mesh floor linear $speed 0 0" 'run 25000' 'print "fell to $(z[1]:%.7g) at $(vz[1]:%.7g)"' >in.belt
		"$TSIM" -in in.belt -log none -var at "$at" -var Y $([ $impact = exact ] && echo 7e10 || echo 5e6) >out 2>&1 </dev/null
		grep '^fell to' out >"$impact.$speed.$at"
		[ -s "$impact.$speed.$at" ] && cmp -s "$impact.0.0" "$impact.$speed.$at"
		report "impact $impact, belt at $at with speed $speed" $? out
	done
done

# a particle that passes it is counted, once
for at in 0 0.3 0.7 -7; do
	printf '%s\n' "$head" 'fix flow all massflow/mesh mesh floor vec_side 0 0 -1 count once' 'run 12000' \
		'print "passed $(f_flow[2])"' >in.passed
	"$TSIM" -in in.passed -log none -var at $at -var Y 5e6 >out 2>&1 </dev/null
	grep -qx 'passed 1' out
	report "counted with the mesh at $at" $? out
done

# one that would jump through it is an error
for at in 0 0.7 -7; do
	printf '%s\n' "$head" 'velocity all set 0 0 -1000' 'run 10' >in.jump
	refused "a jump through the mesh at $at" 'past mesh floor' -in in.jump -var at $at -var Y 5e6
done

# inserted particles keep clear of it, and are at the same places
for at in 0 -7; do
	printf '%s\n' "$head" 'fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.03' \
		'fix pdd all particledistribution/discrete 15485867 1 pts 1' 'region all block -0.5 0.5 -0.5 0.5 -0.2 0.2 units box' \
		'fix fill all insert/pack seed 32452843 distributiontemplate pdd insert_every once overlapcheck yes maxattempt 500 region all &' \
		'	particles_in_region 200 avoid_meshes floor' 'run 1' "write_dump all custom places.$at id x y z" \
		'variable near atom abs(z)<0.0299' 'compute near all reduce sum v_near' 'run 0' 'print "$(atoms) of them near $(c_near)"' >in.fill
	"$TSIM" -in in.fill -log none -var at $at -var Y 5e6 >out 2>&1 </dev/null
	grep -qx '201 of them near 0' out
	report "inserted beside the mesh at $at" $? out
done
same 'places' places.0 places.-7
finish
