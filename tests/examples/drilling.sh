#!/bin/bash
# The drilling example at reduced size: it runs to the end, its own checks hold, and its numbers do
# not depend on threads nor on whether the rock was made in the same run or read from a file.
set -e
# shellcheck source=tests/lib_text.sh
. "$top_srcdir/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$top_srcdir"/examples/drilling/in.* "$work"
cd "$work"
passed=0 failed=0
check() { # text, condition already evaluated by the caller: 0 holds
	if [ "$2" = 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $1"; fi
}
small="-var depth 700 -var T 45 -var WOB 0.211 -var Fult 0.23 -log none"

"$TSIM" -in in.drilling $small -var out one -threads 1 >one.txt && status=0 || status=$?
check "the run ends well" $status
grep -qE '^STUDY 1 0\.211 0\.23( |$)' one.txt && status=0 || status=1
check "it prints its results" $status
[ "$(grep -c '^RESULT.* ok$' one.txt)" = 3 ] && status=0 || { status=1; grep '^RESULT' one.txt; }
# numbers as a person writes them: six digits
if grep -E '^RESULT.*[0-9.]{11}' one.txt; then status=1; fi
check "its own checks hold" $status

"$TSIM" -in in.drilling -var T 40 -var land 50 -log none >short.txt && status=0 || status=$?
[ "$status" = 1 ] && grep -q 'two time units at least; found: T 40, land 50' short.txt && status=0 || status=1
check "a run without a rate is refused at its start" $status

# grain 1: also short loops are shared, which is not worth it but must not change anything
printf 'package omp 2 grain 1\ninclude in.drilling\n' >in.two
OMP_WAIT_POLICY=passive "$TSIM" -in in.two $small -var out two >two.txt
cmp -s one/bit.txt two/bit.txt && cmp -s one/rock.1.restart two/rock.1.restart && status=0 || status=1
check "two threads give the same bytes" $status

"$TSIM" -in in.drilling $small -var out read -var rock one/rock.1.restart >read.txt
cmp -s one/bit.txt read/bit.txt && status=0 || status=1
check "a rock read from its file drills as one just made" $status

broken=$(grep -vc '^#' one/broken.txt)
counted=$(sed -nE 's/.*bonds broken += ([0-9]+) of.*/\1/p' one.txt)
[ "$broken" = "$counted" ] && [ "$broken" -gt 10 ] && status=0 || status=1
check "every broken bond is listed ($broken listed, $counted counted)" $status

gain=$(awk '!/^#/ { if (!n++) first = $3; last = $3 } END { print (last < first) ? 0 : 1 }' one/bit.txt)
check "the bit goes down" "$gain"

"$TSIM" -in in.drilling $small -explain >plan.txt 2>&1 && status=0 || status=$?
check "-explain ends well" $status
shows 'spring/dashpot' plan.txt && shows '-> ' plan.txt && [ ! -e post ] && status=0 || status=1
check "-explain names the binding limit and writes nothing" $status

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
