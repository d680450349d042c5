#!/bin/bash
# examples/polishing/in.load: a load curve in one run of each model; its RESULT lines are ok, area rises and gap falls.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99
cd polishing || exit 99

"$TSIM" -in in.load -log none -var cells 128 >out 2>&1 </dev/null &&
	[ "$(grep -c '^RESULT .* ok$' out)" = 3 ] && ! grep -q '^RESULT .* off$' out
report 'the RESULT lines' $? out
for model in winkler halfspace; do
	awk '$1 !~ /^#/ { n++; if ($1 <= p || $2 <= area || n > 1 && $4 >= gap) bad = 1; p = $1; area = $2; gap = $4 }
		END { exit bad || n != 18 || p != 1 || area < 0.9 }' post/load.$model
	report "$model: 18 pressures, area rises, gap falls" $? post/load.$model
done
finish
