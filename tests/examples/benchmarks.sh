#!/bin/bash
# The published benchmarks of examples/benchmarks, at the size that a test can afford.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
examples=$top_srcdir/examples/benchmarks

sh "$examples/impact/run.sh" . >out 2>&1
report 'eight contact tests of Chung and Ooi (2011)' $? results.txt
[ "$(wc -l <results.txt)" = 216 ] && [ "$(wc -l <impact.txt)" = 92 ]
report 'all of them' $? out

# Duration, overlap and force of the straight elastic impacts, as computed by hand from Hertz's theory for
# the materials of tests 1 to 3 (for a rigid plane; here it is only 1000 times stiffer).
while read -r name reference; do
	awk -v name="$name" -v r="$reference" '
		$2 == name && $3 > r * (1 - 6e-4) && $3 < r * (1 + 6e-4) { good = 1 }
		END { exit !good }' results.txt
	report "$name $reference" $?
done <<'END'
1.glass.duration 40.340e-6
1.glass.overlap 274.113e-6
1.glass.force 10696.9
1.limestone.duration 54.202e-6
1.limestone.overlap 368.304e-6
1.limestone.force 7108.24
2.aluminium.duration 731.67e-6
2.aluminium.overlap 49.717e-6
2.aluminium.force 11369.9
2.magnesium.duration 767.08e-6
2.magnesium.overlap 52.123e-6
2.magnesium.force 7232.68
3.oxide.duration 6.1046e-6
3.oxide.force 615.35
3.iron.duration 12.972e-6
3.iron.force 506.76
END

sh "$examples/penetration/run.sh" 0.008 >out 2>&1 && grep -q '^RESULT .* ok$' out
report 'penetration of a bed of large grains, Dosta et al. (2024)' $? out
sh "$examples/silo/run.sh" large 0.014 -var seconds 0.35 >out 2>&1 && grep -q '^RESULT .* ok$' out
report 'discharge of a silo with large grains, Dosta et al. (2024)' $? out
finish
