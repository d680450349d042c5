#!/bin/bash
# Bridges of liquid by LIGGGHTS 3.8, an independent program: pull, drag and torque in the touch and beyond, where bridges are
# made and break, and what becomes of their liquid; three spheres, one of them between two; a plane, and a mesh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl

columns='id x y z fx fy fz tqx tqy tqz f_surfaceLiquidContent'
# agrees WHAT LAW X V W ANGLES MOST STEPS WALL [LEGACY]
agrees() {
	local what=$1 legacy=${10-}
	echo "$9" >in.wall
	set -- -in "$top_srcdir/tests/crosscheck/in.bridges" -var law "$2" -var x "$3" -var v "$4" -var w "$5" \
		-var angles "$6" -var most "$7" -var steps "$8"
	{
		echo "dump d all custom 50 liggghts.dump $columns"
		echo 'dump_modify d sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"'
	} >in.dump
	liggghts "$@" >err 2>&1
	report "$what: LIGGGHTS" $? err
	{
		echo "dump d all custom 50 tsim.dump $columns"
		echo 'dump_modify d sort id format float %.17g'
	} >in.dump
	"$TSIM" "$@" ${legacy:+-legacy} -log none -screen none 2>err
	report "$what: tsim" $? err
	for file in liggghts.dump tsim.dump; do # bounds are of other precision
		sed '/BOX BOUNDS/,+3d' $file >kept
		mv kept $file
	done
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" liggghts.dump tsim.dump 1e-7 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}

easo='easo/capillary/viscous'
washino='washino/capillary/viscous'
none='variable none equal 0'
for law in $easo $washino; do
	agrees "$law, parting" $law 1.098e-3 0.05 0 '0 0' 1.3 2400 "$none"
	agrees "$law, meeting" $law 1.101e-3 -0.02 30 '0 0' 1.3 900 "$none"
	agrees "$law, the largest distance" $law 1.098e-3 0.05 -20 '0 0' 1.03 1400 "$none"
	agrees "$law, contact angles" $law 1.098e-3 0.05 0 '20 50' 1.3 2800 "$none" legacy
	agrees "$law, friction" "$law tangential_reduce on" 1.09e-3 0 0 '0 0' 1.3 400 "$none"
done
agrees 'share of the liquid' "$washino modifyLbVolume on" 1.098e-3 0.05 0 '0 0' 1.3 2400 "$none"
for most in 1.3 1.05; do
	agrees "a plane, to $most" $easo 1.098e-3 0.02 10 '0 0' $most 3700 \
		"fix w all wall/gran model hertz tangential history cohesion $easo primitive type 2 yplane -4.99e-4"
	agrees "a mesh, to $most" $easo 1.098e-3 0.02 10 '0 0' $most 3700 \
		"fix plate all mesh/surface file plate.stl type 2 scale 0.005 rotate axis 1 0 0 angle 90 move 0 -4.99e-4 0
fix w all wall/gran model hertz tangential history cohesion $easo mesh n_meshes 1 meshes plate"
done
finish
