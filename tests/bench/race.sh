#!/bin/bash
# The scenes of bench/race, tiny: tsim runs them by the words of LIGGGHTS and of LAMMPS, threads change no digit.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs /usr/bin/time time
for scene in "$top_srcdir"/bench/scenes/*/scene; do
	name=$(basename "$(dirname "$scene")")
	"$top_srcdir/bench/race" tiny "$name" -programs 'tsim1 tsim2' >out 2>&1 && grep -q "^$name: " out
	report "$name" $? out
done
"$top_srcdir/bench/laws" tiny >out 2>&1 && [ "$(grep -c '^| LIGGGHTS: \|^| LAMMPS: ' out)" -gt 25 ]
report 'bench/laws' $? out
"$top_srcdir/bench/features" tiny >out 2>&1 && [ "$(grep -c '^| .* | [0-9]' out)" -gt 35 ]
report 'bench/features' $? out
"$top_srcdir/bench/race" no-such-scene >out 2>&1
[ $? = 2 ] && shows "no scene 'no-such-scene'" out
report 'a scene that is none' $? out
finish
