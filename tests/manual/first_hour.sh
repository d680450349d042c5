#!/bin/bash
# The scripts of doc/first-hour.md, taken from its text, run and give what the page says.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
page=$top_srcdir/doc/first-hour.md
# the command of the page itself
sed -n "/^    awk /,/first-hour.md\$/p" "$page" | sed "s|doc/first-hour.md|$page|" >extract
bash extract
for name in heap drum hopper bed; do
	[ -s in.$name ]
	report "the page has in.$name" $?
done

# first NAME TEXT LOW HIGH: the script prints the text with a number in this range, and makes its picture
first() {
	"$TSIM" -in in.$1 -log none >out 2>&1 </dev/null &&
		awk -v text="$2" -v low="$3" -v high="$4" '
			index($0, text) == 1 { n++; v = substr($0, length(text) + 1) + 0; ok = v >= low && v <= high }
			END { exit !(n == 1 && ok) }' out && [ -s $1.png ]
	report "in.$1" $? out
}
first heap 'angle of repose: ' 12 25
first drum 'angle of the bed: ' 15 45
first hopper 'flow rate: ' 40 80
first bed 'mean temperature: ' 294 310
awk '/^mean temperature/ { ok = ($6 > $3 + 5); exit } END { exit !ok }' out
report 'the bed gets warmer' $? out
for name in heap drum hopper bed; do
	"$TSIM" -check -in in.$name >out 2>&1
	report "-check of in.$name" $? out
done

awk '/^`drill.sh`:$/ { on = 1 } on && /^```$/ { if (inside) exit; inside = 1; next } inside' "$page" |
	sed "s|EXAMPLES|$top_srcdir/examples|; s|^tsim|'$TSIM' -log none|" >drill.sh
[ "$(wc -l <drill.sh)" = 3 ] && bash -e drill.sh >out 2>&1 && grep -q '^  rate of penetration' out && ! grep -q '^RESULT.*off$' out
report drilling $? out
finish
