#!/bin/bash
# The scenes of bench/race, tiny, by LIGGGHTS and LAMMPS, too: who races must do the same work.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs lmp lammps
needs /usr/bin/time time
for scene in "$top_srcdir"/bench/scenes/*/scene; do
	name=$(basename "$(dirname "$scene")")
	"$top_srcdir/bench/race" tiny "$name" -programs 'tsim1 liggghts lammps' >out 2>&1
	report "$name" $? out
	grep 'by its law' out
done
finish
