#!/bin/bash
# The examples of flowing grains, each shortened: all RESULT lines are ok; profiles of a film; what cannot flow.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/film" "$top_srcdir/examples/flow" . || exit 99
cd film || exit 99

# results WHAT SCRIPT NUMBER WORDS...: so many RESULT lines, all ok
results() {
	local what=$1 script=$2 number=$3
	shift 3
	"$TSIM" -in "$script" -log none "$@" >out 2>&1 </dev/null &&
		[ "$(grep -c '^RESULT .* ok$' out)" = "$number" ] && ! grep -q '^RESULT .* off$' out
	report "$what" $? out
}

results 'free cooling' in.cooling 1 -var runs 2 -var n 343 -var e 0.7 -var tolerance 0.08
results 'a sheared gas' in.sheared_gas 5 -var box 7 -var nu 0.3 -var e 0.8 -var samples 1200 -var tolerance 0.1
awk '$1 == 0.3 { n++; if ($10 <= $11) bad = 1 } END { exit bad || n != 1 }' post/sheared_gas.txt
report 'fluctuations are larger along the flow' $? post/sheared_gas.txt
results 'dense discs' in.rheology 2 -var n 100 -var strain 3 -var phi 0.74 -var kn 2e5 -var tolerance 0.035
results 'dense spheres' in.rheology 3 -var dim 3 -var n 100 -var strain 3 -var phi 0.55 0.52 -var kn 5e4 -var mu_tolerance 0.08
results 'a film' in.grains 5 -var L 5 -var depth 5 -var relax 8 -var average 12 -var R 0.7
# the lower plate drags the grains, which slip at both; as many as there should be
awk '$1 !~ /^#/ { n++; u[n] = $2; sum += $3; if ($4 <= 0 || $5 <= 0) bad = 1 }
	END { exit bad || n != 10 || u[1] > 0.95 || u[1] < 0.6 || u[10] < 0.05 || u[10] > 0.4 || sum/n < 0.999 || sum/n > 1.001 }' post/profile_dem.txt
report 'its profile' $? post/profile_dem.txt
# stops WHAT TEXT WORDS...: exit status 1 after this text
stops() {
	local what=$1 text=$2
	shift 2
	"$TSIM" -log none "$@" >out 2>&1 </dev/null
	[ $? = 1 ] && grep -q "$text" out
	report "$what" $? out
}
stops 'a film that is too full' 'grains flow up to about 0.6' -in in.grains -var solids 0.63
stops 'bumps that cannot be' 'R is 1.2, expected 0.1 to 1' -in in.grains -var R 1.2
stops 'discs that are packed' 'do not flow' -in in.rheology -var phi 0.9
stops 'spheres that are packed' 'do not flow' -in in.rheology -var dim 3 -var phi 0.63
finish
