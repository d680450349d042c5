#!/bin/bash
# What LIGGGHTS refuses is refused, with the place and the cause: the table tests/data/refusals.txt. That
# LIGGGHTS does: tests/crosscheck/refusals.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
data=$top_srcdir/tests/data

check() { # WHO TEXT: of in.case
	"$TSIM" -in in.case -log none >out 2>err </dev/null
	local status=$?
	case $1 in
	both | tsim) [ $status = 1 ] && shows "$2" err && grep -q '^in.case:[0-9]*:[0-9]*: error' err ;;
	*) [ $status = 0 ] ;;
	esac
}
cp "$data/triangle.stl" .
while IFS='|' read -r who what edit text; do
	case $who in '' | \#*) continue ;; esac
	sed "$edit" "$data/in.refusals" >in.case
	check "$who" "$text"
	report "$what: refused by $who" $? err
done <"$data/refusals.txt"
finish
