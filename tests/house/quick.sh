#!/bin/bash
# Each name in tests/quick.mk is that of a test, in the list and in the table above it; the crosschecks are found, and
# most other tests are quick.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cd "$top_srcdir/tests" || exit 99

list() { # VARIABLE FILE
	awk -v name="$1" '!/^\t/ { listed = $1 == name } listed && /^\t/ { print $1 }' "$2" | grep -v '^\$' | sort
}
list slow_tests quick.mk >"$work/slow"
{ list shell_tests sources.mk && list unit_tests sources.mk; } | sort >"$work/all"
sed -nE 's,^#  +[0-9]+ +([^ ]+) .*,tests/\1,p' quick.mk | sort >"$work/table"
cd "$work" || exit 99

uniq -d slow >unknown
comm -23 slow all >>unknown
[ -s slow ] && [ ! -s unknown ]
report 'each name is that of a test, and is there once' $? unknown
same 'the table has the names of the list' slow table
[ "$(grep -c "$(sed -n 's/^crosschecks = .*filter \(.*\)%.*/^\1/p' "$top_srcdir/tests/quick.mk")" all)" -gt 20 ]
report 'the crosschecks are found' $? all
# tests named in the third column are there, and quick
sed -nE 's/^#  +[0-9]+ +[^ ]+ +//p' "$top_srcdir/tests/quick.mk" | grep -oE '[a-z_/]*(check_[a-z_]+|[a-z_]+\.sh)' |
	sed 's,^,tests/,' | sort -u >instead
comm -23 instead all >unknown
comm -12 instead slow >>unknown
[ -s instead ] && [ ! -s unknown ]
report 'what is tested instead is a quick test' $? unknown
[ "$(comm -23 all slow | grep -vc '/crosscheck/')" -gt $(($(grep -vc '/crosscheck/' all) * 8 / 10)) ]
report 'most tests but the crosschecks are quick' $? slow
finish
