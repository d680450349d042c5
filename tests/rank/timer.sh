#!/bin/bash
# timer timeout on several ranks: the clock of the first one decides, all end a run after the same step, and go on with the
# numbers of one rank.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1
sed '/^run/d; /^dump /s/ 300 / 50 /' "$top_srcdir/tests/rank/scenes/in.bed" >in.start

# A run that is cut, ones that do nothing, a rest; later ones without a limit.
{
	cat in.start
	# shellcheck disable=SC2016
	printf '%s\n' 'run 20' 'timer timeout 0 every 33' 'print "over $(timeremain < 0)"' 'run 200' 'print "at $(step) $(ke)"' 'run 100' \
		'run 50 every 10 "print here"' 'write_data ${out}.data' 'print "still at $(step)"' 'timer timeout 1:00:00 every 7' 'run 60' \
		'print "then $(step), left $(timeremain > 3000)"' 'timer timeout off' 'run 60'
} >in.cut
"$TSIM" -in in.cut -log log.1 -screen none -var out one >out 2>&1
report 'alone' $? out
told() { grep -E '^(over|at|still|then|here|Wall time|This run)|^ +[0-9]+ +[-+0-9.e ]+$' "$1"; }
told log.1 >told.1
for line in 'Wall time limit reached at step 53' 'over 1' 'still at 53' 'then 113, left 1'; do
	grep -qx "$line" told.1
	report "it tells: $line" $? told.1
done
for n in $(numbers_of '2 7' 1); do
	rm -f many.*
	on_ranks "${n%x2}" "$TSIM" -in in.cut -log "log.$n" -screen none -var out many >out 2>&1 </dev/null
	report "on $n ranks" $? out
	told "log.$n" >"told.$n"
	same "lines of $n ranks" told.1 "told.$n"
	for file in dump mean data; do
		same "$file of $n ranks" one.$file many.$file
	done
done

# A fluid of which each rank has its planes only: all have all of it after the step.
# shellcheck disable=SC2016
sed '/^dump/d; s/^run 40/timer timeout 0 every 5\nrun 40\ntimer timeout off/; s/^run 30/run 9\nprint "at $(flow_ke) $(flow_px)"\nwrite_dump all flow\/vtk ${out}.vtr/' \
	"$top_srcdir/tests/rank/scenes/in.slabs" >in.planes
"$TSIM" -in in.planes -log log.1 -screen none -var out one >out 2>&1
report 'planes: alone' $? out
told log.1 >told.1
for n in 2 3; do
	on_ranks $n "$TSIM" -in in.planes -log "log.$n" -screen none -var out many >out 2>&1 </dev/null
	report "planes: on $n ranks" $? out
	told "log.$n" >"told.$n"
	same "planes: lines of $n ranks" told.1 "told.$n"
	same "planes: fluid of $n ranks" one.vtr many.vtr
done

# Whatever the step is: what the ranks have then is what one rank has after as many steps.
{
	cat in.start
	# shellcheck disable=SC2016
	printf '%s\n' 'timer timeout 0.4 every 1' 'run 100000' 'print "steps $(step)"' 'write_data ${out}.data'
} >in.soon
for n in 2 3; do
	on_ranks $n "$TSIM" -in in.soon -log log.soon -screen none -var out many >out 2>&1 </dev/null
	steps=$(sed -n 's/^steps //p' log.soon)
	[ "${steps:-0}" -gt 0 ] && [ "$steps" -lt 100000 ]
	report "$n ranks end in time" $? out
	sed "/^timer/d; s/^run .*/run ${steps:-1}/" in.soon >in.same
	"$TSIM" -in in.same -log none -screen none -var out one >out 2>&1
	same "after $steps steps on $n ranks" one.data many.data
done
finish
