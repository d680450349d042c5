#!/bin/bash
# The converging gap of examples/polishing by the film and by the full equations: the RESULT lines are ok; the load by the full
# equations exceeds that of the film by the neglected terms, about 4.5 (h/L)^2.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99
cd polishing || exit 99

# results WHAT WORDS...: three RESULT lines, all ok
results() {
	local what=$1
	shift
	"$TSIM" -in in.gap -log none "$@" >out 2>&1 </dev/null && [ "$(grep -c '^RESULT .* ok$' out)" = 3 ] &&
		! grep -q '^RESULT .* off$' out
	report "$what" $? out
}

results 'film' -var within 2e-5
results 'film, another slope' -var K 3 -var aspect 100 -var M 400 -var within 2e-5
results 'full equations' -var model cfd -var N 10 -var aspect 8 -var within 0.15
awk '$2 == "gap.cfd.load" { off = ($3/$4 - 1)*8^2; print off; exit !(off > 3 && off < 6) }' out >ratio
report 'terms of second order' $? ratio
finish
