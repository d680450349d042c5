#!/bin/bash
# Walls of triangles against LIGGGHTS 3.8, an independent program: faces, edges, corners, flat edges that
# are slid over, conveyors, motions of meshes.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck
plate 8 0 >plate.stl
cuboid 0.5 0.4 0.3 >cube.stl
funnel 12 >funnel.stl
echo '-0.5 -0.5 0 0.5 -0.5 0 0 0.5 0' | solid >one.stl

# agrees WHAT STEPS MESHES PLACE VELOCITY [LINES OF THE SCRIPT...]
agrees() {
	local what=$1 steps=$2 meshes=$3 place=$4 velocity=$5
	shift 5
	{
		printf '%s\n' "$@"
		echo "fix wall all wall/gran model hertz tangential history rolling_friction epsd2 mesh" \
			"n_meshes $(echo "$meshes" | wc -w) meshes $meshes"
		[ -n "$place" ] && echo "create_atoms 1 single $place units box
			set group all diameter 0.1 density 2385
			velocity all set $velocity units box"
	} >in.case
	set -- -in "$decks/in.mesh" -var decks "$decks" -var steps "$steps" -var faces "${faces:-f f f}" \
		-var side "${side:-1}"
	# (without a log LIGGGHTS crashes where it reads a mesh)
	liggghts "$@" -var program liggghts -var fixed "" >err 2>&1
	report "$what: LIGGGHTS" $? err
	# positions are wrapped when neighbours are found: at the same steps
	"$TSIM" "$@" -var program tsim -var fixed 'fixed yes' -log none -screen none 2>err
	report "$what: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump "$steps" "${tolerance:-1e-12}" >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}
cad='fix cad all mesh/surface file'

agrees 'over flat edges' 20000 cad '-0.31 -0.22 0.0501' '1 0.77 -0.1' "$cad plate.stl type 2"
agrees 'over the rim' 20000 cad '0.3 0.1 0.0501' '1 0.3 -0.1' "$cad plate.stl type 2"
agrees 'over an edge' 20000 cad '0.3 0.1 0.3501' '1 0.3 -0.1' "$cad cube.stl type 1"
agrees 'at a corner' 10000 cad '0.52 0.41 0.375' '-0.5 -0.3 -0.1' "$cad cube.stl type 2"
agrees 'in a box' 20000 cad '-0.3 0.1 0' '-1.1 0.9 -0.7' "$cad cube.stl type 2"
agrees 'over a triangle' 10000 cad '0 -0.4 0.0501' '0.1 -1.5 -0.1' "$cad one.stl type 2"
agrees 'transformed' 20000 cad '0 0 0.6' '0.5 0.3 -1' "$cad cube.stl type 2 scale 0.8 \
	rotate axis 1 2 3 angle 33 move 0.01 0.02 0.03 scale 1.1 rotate axis 0 0 1 angle -20"
agrees 'conveyor' 10000 cad '0 -0.2 0.0501' '0 0 0' "$cad plate.stl type 2 surface_vel 0.3 0.1 0.2"
agrees 'turntable' 10000 cad '0 -0.2 0.0501' '0 0 0' \
	"$cad plate.stl type 2 surface_ang_vel origin 0.1 0 0 axis 0 0.1 2 omega 3.5"
agrees 'two meshes' 10000 'cad2 cad' '0.36 0 0.0501' '-1 0.2 0' "$cad plate.stl type 2" \
	'fix cad2 all mesh/surface file cube.stl type 1 scale 0.5 rotate axis 0 1 0 angle 10'
agrees 'in a pipe' 20000 cad '0.02 0.03 0.5' '2 1.7 0' "$cad funnel.stl type 2 curvature 31 curvature_tolerant yes"
faces='p p f' side=0.5 agrees 'across periodic faces' 20000 cad '0.3 0.1 0.0499' '1.5 0.7 0' \
	"$cad plate.stl type 2"
agrees 'not of the group' 3000 cad '0 -0.2 0.0501' '0 0 0' 'group nobody id 77' \
	'fix cad nobody mesh/surface file plate.stl type 2'
agrees 'through a funnel' 5000 cad '' '' "$cad funnel.stl type 2" 'lattice sc 0.12' \
	'region heap block -0.25 0.25 -0.25 0.25 -0.1 0.5 units box' 'create_atoms 1 region heap' \
	'set group all diameter 0.097 density 2385' 'set atom 5 diameter 0.073 density 2470' \
	'velocity all set 0.3 0.2 -0.5 units box'

# Posts that move in several ways, each into a ball. LIGGGHTS turns the corners of a mesh by a little more in
# each step, so that rounding adds up in its places.
cuboid 0.05 0.15 0.1 >post.stl
moving() { # WHAT MOTION...: MOTION is a list of movers, separated by `;`, about O, the place of the post
	local what=$1 n=0 k meshes='' lines=() x y motion mover movers
	shift
	for motion in "$@"; do
		n=$((n + 1))
		x=$(awk "BEGIN { print -0.7 + 0.47 * ($n - 1 - 4 * int(($n - 1) / 4)) }")
		y=$([ $n -gt 4 ] && echo 0.5 || echo -0.5)
		lines+=("$cad post.stl type 2 move $x $y 0")
		lines[-1]=${lines[-1]/cad/cad$n}
		IFS=';' read -ra movers <<<"$motion"
		k=0
		for mover in "${movers[@]}"; do
			k=$((k + 1))
			lines+=("fix mover$n$k all move/mesh mesh cad$n ${mover//O/$x $y 0}")
		done
		lines+=("create_atoms 1 single $(awk "BEGIN { print $x + 0.11, $y + 0.07 }") 0.02 units box")
		meshes="$meshes cad$n"
	done
	tolerance=1e-9 agrees "$what" 4000 "$meshes" '' '' 'variable wave equal 1.3*sin(0.0007*step)' \
		'variable rise equal 0.9' 'unfix down' "${lines[@]}" 'set group all diameter 0.1 density 2385'
}
moving 'meshes that move' 'linear 0.9 0.3 -0.2' 'rotate origin O axis 0.2 0.3 1 period 0.5' \
	'wiggle amplitude 0.05 0.02 0.01 period 0.1' \
	'riggle origin O axis 0.1 0.3 1 period 0.2 amplitude 35' \
	'linear/variable v_wave v_rise v_rise' 'rotate/variable origin O axis 0.1 0 1 omega v_wave' \
	'viblin axis 1 0.2 0.1 order 2 amplitude 0.05 0.02 phase 0.3 0.7 period 0.11 0.07' \
	'vibrot origin O axis 0 0.2 1 order 2 amplitude 0.4 0.1 phase 0.3 0.7 period 0.2 0.13'
moving 'motions together' 'linear 0.7 0.1 0.2;rotate origin O axis 0.2 0.3 1 period 0.4' \
	'rotate origin O axis 0.2 0.3 1 period 0.4;linear 0.7 0.1 0.2' \
	'rotate origin O axis 0.2 0.3 1 period 0.4;rotate origin O axis 1 0.3 0.1 period 0.5' \
	'wiggle amplitude 0.05 0.02 0.01 period 0.1;rotate origin O axis 0.2 0.3 1 period 0.4' \
	'linear 0.2 0.1 0;rotate origin O axis 0.2 0.3 1 period 0.4;wiggle amplitude 0.05 0 0 period 0.1'
finish
