#!/bin/bash
# The film of grains of examples/film by kinetic theory: the RESULT lines of in.kinetic and in.kinetic_sweep are ok, their
# tables complete.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/film" "$top_srcdir/examples/flow" . || exit 99
cd film || exit 99

# results WHAT NUMBER SCRIPT WORDS...: so many RESULT lines, all ok
results() {
	local what=$1 number=$2
	shift 2
	"$TSIM" -log none -in "$@" >out 2>&1 </dev/null && [ "$(grep -c '^RESULT .* ok$' out)" = "$number" ] &&
		! grep -q '^RESULT .* off$' out
	report "$what" $? out
}

results 'reference case' 35 in.kinetic
# kinetic theory by tests/data/granular_couette_profile.csv at a quarter of the gap
awk '$1 == 0.25 { ok = $2 == 0.652701 && $3 > 1.00535 && $3 < 1.00536 && $4 == 0.0111696 } END { exit !(ok && NR == 43) }' \
	post/profile_kinetic.txt
report 'profile' $? post/profile_kinetic.txt
# faster: wider; more grains: wider, too
awk 'NF == 6 && !/^#/ { n++; if ($1 == amount && $3 <= gap) bad = 1; amount = $1; gap = $3; at[$2] = at[$2] < gap ? gap : 1e9 }
	END { for (k in at) if (at[k] > 1e8) bad = 1; exit bad || n != 40 }' post/load_kinetic.txt
report 'load' $? post/load_kinetic.txt
printf '0.79 0.0182 0.0009 0.3122 0.0387 0.27 0.8045 0.3959 -1 -0.7\n' >post/rheology.txt
./plot >out 2>&1 && [ "$(grep -c '^post/[a-z_]*.png$' out)" = 9 ] && [ "$(find post -name '*.png' | wc -l)" = 9 ]
report 'figures' $? out
results 'another theory, another gap' 35 in.kinetic -var theory garzo/dufty -var H 10 -var U 0.3
results 'sweep' 1 in.kinetic_sweep -var e 0.85 -var H 5
awk '!/^#/ { n++; if ($11 != 1 || $9 < 0.9 || $9 > 1.1) bad = 1 } END { exit bad || n != 32 }' post/sweep_kinetic.txt
report 'its table' $? post/sweep_kinetic.txt
finish
