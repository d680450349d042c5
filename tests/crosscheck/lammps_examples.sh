#!/bin/bash
# Inputs that come with LAMMPS, as they are but for the length: the same particles as LAMMPS has, in the same places.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
examples=/usr/share/lammps/examples
[ -d $examples ] || examples=/usr/share/doc/lammps-examples/examples
if ! command -v lmp >/dev/null || [ ! -x /usr/bin/python3 ] || [ ! -f $examples/pour/in.pour ]; then
	echo 'skipped: needs lmp, python3 and the examples of LAMMPS (apt-get install lammps lammps-examples python3)'
	exit 77
fi

agrees() { # FILE STEPS
	local steps=$2
	awk -v n="$steps" '/^run/ {
		print "dump d all custom " n/2 " ${out}.dump id type x y z vx vy vz"
		print "dump_modify d sort id format float %.15g"
		print "run " n
		exit
	} { print }' "$examples/$1" >in.short
	lmp -in in.short -var out lmp -log none -screen none >err 2>&1
	report "$1: LAMMPS" $? err
	"$TSIM" -legacy -in in.short -var out tsim -log none -screen none 2>err
	report "$1: tsim" $? err
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.dump tsim.dump 1e-10 >deviation 2>&1
	report "$1" $? deviation
	echo "$1, $steps steps, $(tail -n +4 tsim.dump | grep -c '^[1-9][0-9]* [12] ') rows: $(head -n 1 deviation)"
	rm -f ./*.dump
}
agrees pour/in.pour 600
agrees granregion/in.granregion.funnel 400
agrees granregion/in.granregion.mixer 400
agrees granular/in.pour.flatwall 400
agrees granular/in.pour.drum 40
finish
