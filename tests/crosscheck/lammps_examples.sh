#!/bin/bash
# Inputs that come with LAMMPS, as they are but for the length: the same particles as LAMMPS has, in the same places.
# shellcheck source=tests/lib_lammps.sh
. "$top_srcdir/tests/lib_lammps.sh" || exit 99
examples=/usr/share/lammps/examples
[ -d $examples ] || examples=/usr/share/doc/lammps-examples/examples
if [ ! -f $examples/pour/in.pour ]; then
	echo 'skipped: needs the examples of LAMMPS (apt-get install lammps-examples)'
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
	both "$1" -in in.short -log none -screen none
	echo "$1, $steps steps, $(tail -n +4 tsim.dump | grep -c '^[1-9][0-9]* [12] ') rows"
	same_frames "$1" 1e-10
}
agrees pour/in.pour 600
agrees granregion/in.granregion.funnel 400
agrees granregion/in.granregion.box 400
agrees granregion/in.granregion.mixer 400
agrees granular/in.pour.flatwall 400
agrees granular/in.pour.drum 40
finish
