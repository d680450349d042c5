#!/bin/bash
# Scripts as users write them, run by LIGGGHTS (those in lammps/ by LAMMPS) and tsim with -crosscheck. The first
# line of each says what is demanded, `# crosscheck: tolerance 1e-10`; together they use all that is
# used much. Words after the name of this test choose some of them.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -R "$top_srcdir/tests/crosscheck/scripts/." .
compare() { # PROGRAM WANTED
	for script in in.*; do
		[ -z "$2" ] || case " $2 " in *" ${script#in.} "*) ;; *) continue ;; esac
		demand=$(sed -n '1s/^# crosscheck: *//p' "$script")
		# shellcheck disable=SC2086
		"$TSIM" -crosscheck "$1" $demand -in "$script" >said 2>&1
		report "$script" $? said
		echo "$1 $script: $(tail -n 1 said)"
	done
}
has liggghts && compare liggghts "$*"
has lmp lammps && cd lammps && compare lammps "$*"
cd "$work" || exit 99
finish
