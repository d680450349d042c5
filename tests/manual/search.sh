#!/bin/bash
# Ten questions, and the page that must be among the first hits of `tsim -help`.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# hits WORDS: the pages found, one a line
hits() {
	# shellcheck disable=SC2086
	"$TSIM" -help $1 | sed -n 's/^  tsim -help \([^ ]* [^ ]*\|[^ ]*\).*/\1/p' | sed 's/ *$//'
}
while IFS='|' read -r words most page; do
	hits "$words" | head -n "$most" >found
	grep -qxF -- "$page" found
	report "$words: $page among the first $most" $? found
done <<'END'
angle of repose|1|compute repose/angle
rotating drum|2|examples/everyday/in.drum
lubrication film|1|flow reynolds
heat conduction between grains|2|fix heat/gran
bonds break|4|fix bond/break
picture of a mesh|1|dump image
wear of a wall|4|fix wear/archard
flow through a hopper|2|examples/everyday/in.hopper
restart file|4|command restart
granular temperature|1|compute temp/granular
wet powder|3|doc/bridges
sandblasting|2|doc/erosion
bond strength|3|doc/bonds
what tsim cannot do|2|doc/cannot
END

# exact names are shown as pages, not as hits; endings and the order of words do not matter
"$TSIM" -help gravity | grep -q '^fix gravity: '
report 'an exact name' $?
[ "$(hits 'rotating drums' | sort)" = "$(hits 'drum rotation' | sort)" ]
report 'endings and order' $?
"$TSIM" -help doc/film | grep -q '^doc/film: ' && "$TSIM" -help examples/everyday/in.heap | grep -q 'angle of repose'
report 'pages of doc/ and examples' $?
while IFS='|' read -r words text; do
	# shellcheck disable=SC2086
	"$TSIM" -help $words >out 2>err
	[ $? = 2 ] && shows "$text" err
	report "-help $words" $? err
done <<'END'
angle of repoze|did you mean 'repose'
of the|no words to search for
gravty|did you mean 'gravity'
END
[ "$(hits hopper | wc -l)" -le 8 ]
report 'eight hits at most' $?
finish
