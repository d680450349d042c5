#!/bin/bash
# Random scenes (tests/rank/random_scene.awk) have the same files on several ranks, and going on from the restart file that
# these have written. TS_SEEDS: the seeds, by default those that always run.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

# files_of FOLDER SCRIPT RANKS: the files of a scene as x.*
files_of() {
	local on=(on_ranks "$3")
	[ "$3" = 1 ] && on=(timeout 300)
	rm -rf "$1"
	mkdir "$1"
	(cd "$1" && "${on[@]}" "$TSIM" -in "../$2" -log log -screen none -var out x -var saved ../grains.restart \
		>out 2>&1 </dev/null) || return
	rows "$1/log" >"$1/x.rows"
	[ -s "$1/x.rows" ] && [ -s "$1/x.dump" ]
}

ran=0
for seed in ${TS_SEEDS:-3 8 20 28 57 60 72 205 217 223 256 308 309}; do
	many=$((2 + seed % 7)) few=$((2 + seed % 3))
	awk -v seed="$seed" -f "$top_srcdir/tests/rank/random_scene.awk" >in.whole
	awk -v seed="$seed" -v again=1 -f "$top_srcdir/tests/rank/random_scene.awk" >in.again
	if ! files_of alone in.whole 1; then # a scene may ask for what is refused, as grains in a wall
		echo "seed $seed: $(grep -m 1 'error:' alone/out)"
		begin=$SECONDS
		! files_of ranks in.whole $many && [ $((SECONDS - begin)) -lt 60 ] &&
			[ "$(grep 'error:' ranks/out)" = "$(grep 'error:' alone/out)" ]
		report "seed $seed: the same error on $many ranks" $? ranks/out
		continue
	fi
	ran=$((ran + 1))
	files_of alone.again in.again 1
	report "seed $seed: goes on alone" $? alone.again/out
	files_of ranks in.whole $many
	report "seed $seed runs on $many ranks" $? ranks/out
	diff -rq -x log -x out alone ranks >difference
	report "seed $seed: the same files on $many ranks" $? difference
	files_of ranks.again in.again $few
	report "seed $seed: goes on on $few ranks" $? ranks.again/out
	diff -rq -x log -x out alone.again ranks.again >difference
	report "seed $seed: the same files from a restart file of $many ranks on $few" $? difference
done
[ $ran -gt 0 ]
report 'scenes ran' $?
finish
