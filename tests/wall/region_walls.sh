#!/bin/bash
# fix wall/gran/region: distances, curvature, open faces, edges that several faces share, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

at() { # X Z REGION...: a sphere of radius 0.1 beside the walls of region w
	local x=$1 z=$2
	shift 2
	printf '%s\n' "units si
boundary f f f
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
create_atoms 1 single $x 0 $z units box
set type 1 diameter 0.2 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 1 damping 0
timestep 1e-9" "$@" 'fix move all nve/sphere'
}
hooke='fix w all wall/gran/region hooke 1e5 0 0 0 0 0 region w'
hertz='fix w all wall/gran/region hertz/history 1e7 0 0 0 0 0 region w'

# forces of faces: overlaps 0.01 and 0.02 in a corner from within, the edge from without
agree 'block' "$(at 0.91 0.92 'region w block -1 1 -1 1 -1 1 units box' "$hooke")
run 0
print \"is fx \$(fx[1]) \$(-1e5*0.01)\"
print \"is fz \$(fz[1]) \$(-1e5*0.02)\"
print \"is wall \$(f_w[1]) \$(1e5*0.01)\""
agree 'edge' "$(at 1.06 1.06 'region w block -1 1 -1 1 -1 1 side out units box' "$hooke")
run 0
variable d equal 0.1-0.06*sqrt(2)
print \"is fx \$(fx[1]) \$(1e5*v_d/sqrt(2))\"
print \"is fz \$(fz[1]) \$(1e5*v_d/sqrt(2))\""
# who is on the other side feels nothing, but where faces are open
agree 'sides' "$(at 1.06 0.2 'region w block -1 1 -1 1 -1 1 units box' "$hooke")
run 0
print \"is fx \$(fx[1]) 0\""
agree 'open' "$(at 1.06 0.2 'region w block -1 1 -1 1 -1 1 open 5 units box' "$hooke")
run 0
print \"is fx \$(fx[1]) \$(1e5*0.04)\""
agree 'an open face' "$(at 0.2 0.95 'region w block -1 1 -1 1 -1 1 open 6 units box' "$hooke")
run 0
print \"is fz \$(fz[1]) 0\""
# R* = R/(1 + kappa R)
for case in 'sphere 0 0 0 0.5 units box|0.41|-1/0.5|-1' 'sphere 0 0 0 0.5 side out units box|0.59|1/0.5|1' \
	'cylinder z 0 0 0.5 INF INF units box|0.41|-1/1.0|-1' \
	'cone z 0 0 0.5 0.5 -1 1 side out units box|0.59|1/1.0|1'; do
	IFS='|' read -r shape x kappa sign <<<"$case"
	agree "curvature: $shape" "$(at "$x" 0 "region w $shape" "$hertz")
run 0
variable r equal 0.1/(1+0.1*($kappa))
print \"is f \$(fx[1]) \$($sign*1e7*sqrt(v_r*0.01)*0.01)\""
done
# the list of contacts, as LAMMPS has it
agree 'contacts' "$(at 0.91 0.2 'region w block -1 1 -1 1 -1 1 units box' "$hooke contacts")
compute m all reduce sum f_w[1] f_w[2] f_w[5] f_w[7] f_w[8]
thermo_style custom step c_m[1]
run 0
print \"is one \$(c_m[1]) 1\"
print \"is fx \$(c_m[2]) \$(-1e5*0.01)\"
print \"is x \$(c_m[3]) 1\"
print \"is z \$(c_m[4]) 0.2\"
print \"is r \$(c_m[5]) 0.1\""
rejects "$(at 0.91 0.2 'region w block -1 1 -1 1 -1 1 units box' "$hooke")
compute m all reduce sum f_w[1]
run 0" 'f_w'

# faces of one member inside of another are none
for x in 0.11 -0.5; do
	agree "union at $x" "$(at $x 0.09 'region a block -1 0.2 -1 1 0 1 units box' \
		'region b block 0.1 1 -1 1 -0.3 1 units box' 'region w union 2 a b' "$hooke")
run 0
print \"is fx \$(fx[1]) 0\"
print \"is fz \$(fz[1]) \$(1e5*0.01*($x<0))\""
done

# a surface that moves away leaves no force; its velocity counts
agree 'moving' "$(at 0 0.095 'variable z equal -3*time' 'region w plane 0 0 0 0 0 1 move NULL NULL v_z units box' \
	'fix w all wall/gran/region hooke 1e5 0 40 0 0 0 region w')
timestep 1e-6
run 1
run 1
variable d equal 0.1-z[1]-3*2e-6
print \"is f \$(fz[1]:%.9g) \$(1e5*v_d-40*mass(all)*(vz[1]-0.5e-6*fz[1]/mass(all)+3):%.9g)\""

# surfaces that come from far, by steps in which particles need no rebuild: those that meet them are listed in time,
# as where the skin is so large that all are listed from the start
come() { # NAME SKIN MOTION
	cat >in.come <<-END
	units si
	atom_style sphere
	boundary f f f
	region box block -1 1 -1 1 -1 1 units box
	create_box 1 box
	lattice sc 0.2
	region some block -0.9 0.9 -0.1 0.1 -0.9 0.9 units box
	create_atoms 1 region some
	set type 1 diameter 0.1 density 1000
	pair_style spring/dashpot
	pair_coeff * * stiffness 1e3 damping 0
	neighbor $2 bin fixed yes
	$3
	fix w all wall/gran/region hooke/history 1e4 0 10 0 0.5 1 region w
	fix move all nve/sphere
	timestep 1e-4
	dump d all custom 50 $1.dump id x y z vx vy vz
	dump_modify d sort id format float %.17g
	run 500
	END
	"$TSIM" -in in.come -log $1.log -screen none || cat $1.log
}
for way in 'move NULL NULL v_far' 'rotate v_far 0 0 -1 0 1 0' 'move NULL NULL v_jump'; do
	motion="variable far equal 20*time
	variable jump equal 0.07*(step>250)+0.049*(step>251)+0.045*(step>252)
	region w plane 0 0 -1 0 0 1 $way units box"
	come near 0.004 "$motion"
	come all 0.4 "$motion"
	same "a surface that comes: $way" all.dump near.dump
	[ "$(sort -k 7 -g all.dump | tail -n 1 | awk '{ print ($7 > 1) }')" = 1 ]
	report "it meets: $way" $? /dev/null
done

# round ones: about their axis they stay where they are and spheres come, about another they come to spheres at rest
for way in '2 cylinder y 0 0 0.75 -1 1 rotate v_far 0 0 0 0 1 0' '0 cylinder y 0 0 0.75 -1 1 rotate v_far 0.1 0 0 0 1 0' \
	'2 cylinder y 0 0 0.3 -1 1 side out rotate v_far 0 0 0 0 -1 0' '0 cylinder y 0 0 0.75 -1 1 rotate v_far 0 0 0 0.3 1 0.2' \
	'2 cone y 0 0 0.8 0.7 -1 1 rotate v_far 0 0 0 0 1 0' '0 cone y 0 0 0.75 0.75 -1 1 move NULL NULL v_slow rotate v_far 0 0 0 0 1 0'; do
	motion="variable far equal 20*time
	variable slow equal 1.937*time
	velocity all set ${way%% *} 0 0
	region w ${way#* } units box"
	come near 0.004 "$motion"
	come all 0.4 "$motion"
	same "a round surface: $way" all.dump near.dump
	[ "$(sort -k 5 -g all.dump | head -n 1 | awk '{ print ($5 < -0.5) }')" = 1 ]
	report "it is met: $way" $? /dev/null
done

rejects "$(at 0 0 'region w ellipsoid 0 0 0 1 1 1 units box' "$hooke")
run 0" 'whose surface is no wall'
rejects "$(at 0 0 'region w sphere 0 0 0 1 units box')
fix w all wall/gran/region region w" 'which law?'
rejects "$(at 0 0 "$hooke")" "there is no region 'w'"
rejects "$(at 0 0 'variable z equal time' 'region a sphere 0 0 0 1 move NULL NULL v_z units box' \
	'region b sphere 0 0 1 1 units box' 'region w union 2 a b move NULL NULL v_z' "$hooke")" 'a, which it is made of, moves in it'
rejects "$(at 0 0 'region w sphere 0 0 0 1 units box' "${hooke/hooke/hertz/history 1 1 1 1 1 1 hooke}")" 'there is another law'
finish
