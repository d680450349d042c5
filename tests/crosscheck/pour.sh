#!/bin/bash
# fix pour, by LAMMPS: the same particles at the same places in the same steps.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs /usr/bin/python3 python3

agrees() { # DIMENSION REGION STEPS WORDS
	local what="$1d: $4" flat='p p f' depth='-9 2' down='vector 0 0 -1'
	[ "$1" = 2 ] && { flat='p f p' depth='-0.1 0.1' down='vector 0 -1 0'; }
	set -- -in "$top_srcdir/tests/crosscheck/in.pour" -log none -var dim "$1" -var region "$2" \
		-var steps "$3" -var words "$4" -var faces "$flat" -var depth "$depth" -var down "$down"
	lmp "$@" -var out lmp >said.lmp 2>&1
	report "$what: LAMMPS" $? said.lmp
	"$TSIM" "$@" -var out tsim >said.tsim 2>&1
	report "$what: tsim" $? said.tsim
	grep -h '^Particle insertion' said.lmp | head -n 1 >plan.lmp
	grep -h '^Particle insertion' said.tsim >plan.tsim
	same "$what: the plan" plan.lmp plan.tsim
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump # of other precision
	[ "$flat" = 'p f p' ] && sed -i 's/ [^ ]* *$//' lmp.dump tsim.dump # masses of balls, masses of discs
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.dump tsim.dump 1e-12 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(head -n 1 deviation)"
	rm -f ./*.dump
}

thick='block -0.5 0.5 -0.9 0.6 1.2 1.8'
thin='block -0.5 0.5 -0.3 0.4 1.2 1.8'
agrees 3 "$thin" 4000 '300 2 4711 diam one 0.1 dens 2385 2385'
agrees 3 "$thick" 7500 '700 1 300719 diam range 0.08 0.12 vol 0.13 50 dens 1931 2385'
agrees 3 'cylinder z 0.1 0.2 0.5 1.2 1.8' 5000 '400 2 29494 diam poly 3 0.09 0.31 0.12 0.52 0.11 0.17 vel -0.3 0.2 0.1 0.1 -1.3 vol 0.2 70 id next'
agrees 3 "$thick" 4500 '250 1 19985583 diam range 0.11 0.12 dens 3000 3000 vol 0.6 2 rate 0.03 vel 0 0 0 0 -2 ignore'
agrees 2 'block -0.7 0.6 0.1 0.8 -0.1 0.1' 2500 '60 1 4767548 diam range 0.05 0.1 vol 0.3 20 vel -0.1 0.3 -1.1'
finish
