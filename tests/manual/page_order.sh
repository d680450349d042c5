#!/bin/bash
# A page of a style begins with what it is for, an example, and the few words that everybody needs; the other words
# follow in groups.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Every page has its parts in this order; those in brackets may be missing. No page begins with a long list: an argument that a
# line can do without, and no example shows, comes later.
order='^Example, Syntax(, Arguments)?(, Coefficients)?, Description(, Further arguments)?(, Output)?(, Source)?$'
awk -v order="$order" '
	function tell() {
		if (page)
			print parts ~ order && summary ? "ordered" : "out of order", page, parts "\n" (arguments > 27 ? "long" : "short"), page
	}
	FNR == 1 { tell(); page = FILENAME; sub(/.*\//, "", page); parts = part = ""; block = arguments = 0 }
	FNR == 3 { summary = $0 != "" }
	/^```/ { block = !block }
	/^## / && !block { parts = parts (parts ? ", " : "") substr($0, 4) }
	/^## / { part = $2 }
	part == "Arguments" && /^- / { arguments++ }
	END { tell() }' "$top_srcdir"/doc/styles/*_*.md >pages
while read -r verdict page parts; do
	[ "$verdict" = ordered ] || [ "$verdict" = short ]
	report "$page: $verdict $parts" $?
done <pages
[ "$(wc -l <pages)" -ge 600 ]
report 'there are pages of styles' $?

# the longest one: the words of bonds, heat and output come after the description
"$TSIM" -help fix wall/gran >page
# shows_in_order TEXT...: each of the texts is in the page, after the one before
shows_in_order() {
	local text last=0 line
	for text; do
		line=$(awk -v last=$last -v text="$text" 'NR > last && index($0, text) { print NR; exit }' page)
		[ -n "$line" ] || { echo "not in order: $text"; return 1; }
		last=$line
	done
}
shows_in_order 'Floors, hoppers, drums' Example 'primitive type 1 zplane 0.0' Syntax '[further keywords]' Arguments '[model off|' \
	'[meshes words' Description 'Further arguments' 'Height fields' 'Bonds (cohesion bond)' '[stressBreak' Output >out
report 'the page of fix wall/gran' $? out
[ "$(sed -n '/^Arguments/,/^Description/p' page | grep -cE '^  \[?[a-z]')" -le 15 ]
report 'fix wall/gran begins with at most fifteen words' $? page
# a style with few arguments has no groups
"$TSIM" -help fix gravity >page
! grep -q 'Further' page
report 'the page of fix gravity has no groups' $? page
finish
