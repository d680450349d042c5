#!/bin/bash
# Walls that move in their surface, by LIGGGHTS 3.8: planes, cylinders along and about each axis, the force
# on each particle.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3

columns='id x y z vx vy vz omegax omegay omegaz f_force_w[1] f_force_w[2] f_force_w[3]'
agrees() { # X Y Z WALL [OPTIONS OF TSIM]
	local what="$4 $5" options=$5
	set -- -in "$top_srcdir/tests/crosscheck/in.walls" -log none -screen none -var x "$1" -var y "$2" \
		-var z "$3" -var wall "$4 store_force yes"
	{
		echo "dump d all custom 50 liggghts.dump $columns"
		echo "dump_modify d sort id format \"%d$(printf ' %%.17g%.0s' {1..12})\""
	} >in.dump
	liggghts "$@" >err 2>&1
	report "$what: LIGGGHTS" $? err
	{
		echo "dump d all custom 50 tsim.dump $columns"
		echo 'dump_modify d sort id format float %.17g'
	} >in.dump
	# shellcheck disable=SC2086 # no option or one
	"$TSIM" $options "$@" 2>err
	report "$what: tsim" $? err
	sed -i '/BOX BOUNDS/,+3d' liggghts.dump tsim.dump # of other precision
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" liggghts.dump tsim.dump 1e-12 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(head -n 1 deviation)"
	rm -f ./*.dump
}

agrees 0.31 0.07 0.25 'zplane 0.19 shear x 1.3'
agrees 0.31 0.07 0.25 'zplane 0.31 shear y -1.3'
agrees 0.31 0.07 0.25 'xplane 0.25 shear z 1.3'
for turn in x z; do
	agrees 0.25 0.31 0.07 "zcylinder 0.45 0.01 -0.02 shear $turn 1.3"
	agrees 0.07 0.25 0.31 "xcylinder 0.45 0.01 -0.02 shear $turn 1.3"
done
agrees 0.31 0.07 0.25 'ycylinder 0.45 0.01 -0.02 shear y 1.3'
agrees 0.31 0.07 0.25 'ycylinder 0.45 0.01 -0.02 shear x 1.3' -legacy
finish
