#!/bin/bash
# Results do not depend on the number of threads, bit for bit: dumps with 17 digits, tables, restart
# files of a scene with all that acts.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

printf 'package omp ${threads} grain 1\ninclude %s/tests/decks/in.everything\nrun ${last}\nwrite_restart ${out}.restart\n' \
	"$top_srcdir" >in.all
export OMP_WAIT_POLICY=passive # there may be fewer cores than threads
for t in 1 2 4; do
	"$TSIM" -in in.all -log "log.$t" -screen none -var threads $t -var out "t$t" -var last 560 2>err
	report "runs on $t threads" $? err
done
# The scene is worth it: bonds have broken, contacts and fast particles are there.
awk '/^ +560 / { ok = $6 > 20 && $7 > 200 && $5 > 500 } END { exit !ok }' log.1
report 'the scene is lively' $? log.1
rows log.1 >rows.1
for t in 2 4; do
	for kind in dump contacts bonds cracks restart; do
		same "$kind on $t threads" "t1.$kind" "t$t.$kind"
	done
	rows "log.$t" >"rows.$t"
	same "tables on $t threads" rows.1 "rows.$t"
done
finish
