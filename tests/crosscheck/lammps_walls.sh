#!/bin/bash
# fix wall/gran in LAMMPS' words, by LAMMPS: its laws, two planes, wiggle, shear.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
if ! command -v lmp >/dev/null || [ ! -x /usr/bin/python3 ]; then
	echo 'skipped: needs lmp and python3 (apt-get install lammps python3)'
	exit 77
fi

agrees() { # FACES SKIN WALL
	set -- "$3" -in "$top_srcdir/tests/crosscheck/in.lammps_walls" -log none -screen none \
		-var faces "$1" -var skin "$2" -var wall "$3"
	local what=$1
	shift
	lmp "$@" -var out lmp >err 2>&1
	report "$what: LAMMPS" $? err
	"$TSIM" "$@" -var out tsim 2>err
	report "$what: tsim" $? err
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump # of other precision
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.dump tsim.dump 1e-11 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(head -n 1 deviation)"
	rm -f ./*.dump
}
planes='p p f'
cylinder='f f f'
hooke='hooke/history 1e5 NULL 50 NULL 0.5 1'
agrees "$planes" 0.01 'hooke 1e5 NULL 50 NULL 0.5 1 zplane 0.0 NULL'
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4"
agrees "$planes" 0.01 "hooke/history 1e5 3e4 50 10 0.5 0 limit_damping zplane NULL 0.4"
agrees "$planes" 0.01 'hertz/history 1e7 NULL 50 NULL 0.5 1 zplane 0.0 0.4'
for skin in 0.001 0.1; do
	agrees "$planes" $skin "$hooke zplane 0.0 0.4 wiggle z 0.02 0.07"
done
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4 wiggle x 0.02 0.07"
agrees "$planes" 0.01 "$hooke zplane 0.0 0.4 shear x 0.4"
agrees "$cylinder" 0.01 "$hooke zcylinder 0.5 shear z 0.4"
agrees "$cylinder" 0.01 "$hooke zcylinder 0.5 wiggle z 0.2 0.7"
finish
