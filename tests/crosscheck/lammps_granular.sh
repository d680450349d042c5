#!/bin/bash
# The granular pair styles of LAMMPS against LAMMPS, an independent program: five uneven spheres, one of them
# frozen, collide obliquely.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
if ! command -v lmp >/dev/null || [ ! -x /usr/bin/python3 ]; then
	echo 'skipped: needs lmp and python3 (apt-get install lammps python3)'
	exit 77
fi
decks=$top_srcdir/tests/crosscheck

agrees() { # STYLE AND NUMBERS
	set -- -in "$decks/in.lammps_granular" -var decks "$decks" -var steps 6000 -var style "$*"
	lmp "$@" -var program lammps -log none -screen none >err 2>&1
	report "${*:8}: LAMMPS" $? err
	"$TSIM" "$@" -var program tsim -log none -screen none 2>err
	report "${*:8}: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" lammps.dump tsim.dump 6000 1e-12 >deviation 2>&1
	report "${*:8}" $? deviation
	echo "${*:8}: $(cat deviation)"
	rm -f ./*.dump
}

for numbers in '2.3e5 1.3e5 53 23 0.31 1' '2.3e5 NULL 53 NULL 0.17 0' '2.3e5 NULL 153 NULL 0.61 1 limit_damping'; do
	for law in hooke hooke/history; do
		agrees "gran/$law $numbers"
	done
	agrees "gran/hertz/history ${numbers/2.3e5/5.31e6}"
done
finish
