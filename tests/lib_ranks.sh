# For shell tests that start several ranks, after tests/lib_cases.sh.

# Open MPI: ranks of one machine pass messages through shared memory; no network is looked for.
export OMPI_MCA_btl=self,vader

# on_ranks N COMMAND...
on_ranks() {
	local n=$1
	shift
	timeout 300 mpirun --oversubscribe --allow-run-as-root --bind-to none -np "$n" "$@"
}

# numbers_of FIRST TURN: of ranks on which a scene runs: TS_RANKS, if that is set to numbers (2x2: two ranks of two threads);
# otherwise FIRST and, by turns, 3 (a rank between two others), 4 (blocks that meet at an edge) or 7 (blocks that are thinner
# than the reach of contacts, or empty)
numbers_of() {
	local turns=(3 4 7)
	if [ "${TS_RANKS:-turns}" = turns ]; then
		echo "$1 ${turns[$2 % 3]}"
	else
		echo "$TS_RANKS"
	fi
}

# in_turn N FOLDER SCENE...: N ranks (2x2: two ranks of two threads) that are started once run in.SCENE after in.SCENE, each in
# FOLDER/SCENE, with the log file `log`; what they print is in `out`. The start takes more time than many a scene.
in_turn() {
	local n=$1 folder=$2 scene
	shift 2
	for scene in "$@"; do
		rm -rf "${folder:?}/$scene"
		mkdir -p "$folder/$scene"
		printf 'shell cd %s\nlog log\ninclude %s\nclear\n' "$work/$folder/$scene" "$work/in.$scene"
		awk '$1 == "variable" && !deleted[$2]++ { print "variable", $2, "delete" }' "in.$scene"
	done >in.turns
	OMP_NUM_THREADS=$([ "$n" = 2x2 ] && echo 2 || echo 1) \
		on_ranks "${n%x2}" "$TSIM" -in in.turns -log none -screen none -var out x >out 2>&1 </dev/null
}

# same_on_ranks N SCENE...: on N ranks, in folders ranks.N/SCENE, and alone
same_on_ranks() {
	local n=$1 scene
	shift
	in_turn "$n" "ranks.$n" "$@"
	report "$n ranks run $*" $? out
	for scene in "$@"; do
		rows "ranks.$n/$scene/log" >"ranks.$n/$scene/x.rows"
		diff -rq -x log -x out -x '*.restart' -x '*.h5' "alone/$scene" "ranks.$n/$scene" >difference
		report "$scene: the same files on $n ranks" $? difference
		[ ! -f "alone/$scene/x.h5" ] || [ "$(cmp -l "alone/$scene/x.h5" "ranks.$n/$scene/x.h5" 2>&1 | wc -l)" -le 32 ] # times at which objects were made
		report "$scene: the same HDF5 file on $n ranks" $?
	done
}

# same_scenes FIRST SCENE...: in.SCENE, whose files begin with ${out}, writes the same alone, in the folder alone/SCENE, and on the
# numbers of ranks of numbers_of
same_scenes() {
	local first=$1 turn=0 scene n
	local -A scenes_on
	shift
	for scene in "$@"; do
		mkdir -p "alone/$scene"
		(cd "alone/$scene" && timeout 300 "$TSIM" -in "../../in.$scene" -log log -screen none -var out x >out 2>&1 </dev/null)
		report "$scene alone" $? "alone/$scene/out"
		rows "alone/$scene/log" >"alone/$scene/x.rows"
		for n in $(numbers_of "$first" $turn); do scenes_on[$n]+=" $scene"; done
		turn=$((turn + 1))
	done
	for n in "${!scenes_on[@]}"; do
		xargs -n 12 <<<"${scenes_on[$n]}" >"groups.$n" # so few that what ends one of them does not hide many
		while read -r -a group; do same_on_ranks "$n" "${group[@]}"; done <"groups.$n"
	done
}

# Whether mpirun is there, and the program was built with MPI; says what is missing
has_ranks() {
	has mpirun openmpi-bin || return
	if on_ranks 2 "$TSIM" -version 2>&1 </dev/null | grep -q 'built without MPI'; then
		echo 'skipped: needs a tsim built with MPI (configure --with-mpi)'
		return 1
	fi
}

# said FILE: the warnings in `out`, with the lines of the script
said() { sed -n 's/.*\(in[.][a-z]*:[0-9]*: warning: .*\)/\1/p' out >"$1"; }

# told FILE: what the program prints, without times and counts of ranks
told() {
	grep -vE '^(Loop|Nlocal|Nghost|Neigh|Ranks|Of the first)|ns per particle|time \(%\)|^$|acts in each step: all [0-9]* ranks' "$1"
}

# same_on NAME RANKS...: in.NAME, whose variable n is $size and whose files begin with ${out}, tells and writes the same on each of
# these numbers of ranks as on one
same_on() {
	local name=$1 n
	shift
	"$TSIM" -in "in.$name" -log none -progress none -var n "${size:-8}" -var out one >one.out 2>&1
	report "$name runs alone" $? one.out
	told one.out >one.told
	for n in "$@"; do
		rm -f many.*
		on_ranks "$n" "$TSIM" -in "in.$name" -log none -progress none -var n "${size:-8}" -var out many >many.out 2>&1 </dev/null
		report "$name runs on $n ranks" $? many.out
		told many.out >many.told
		for file in told dump text; do
			[ ! -f "one.$file" ] || same "$name: $file on $n ranks" "one.$file" "many.$file"
		done
	done
	rm -f one.*
}

# gathered N...: how often all particles were gathered in each run of the last one of same_on
gathered() {
	grep -o 'all gathered [0-9]* times' many.out | awk '{ print $3 }' | tr '\n' ' ' >gathered
	printf '%s ' "$@" | cmp - gathered
	report "particles gathered in each run: $*" $? gathered
}

# Whether the memory of a process can be measured
measures_memory() {
	[ -x /usr/bin/time ] && ! nm "$TSIM" 2>/dev/null | grep -q __asan_init
}

# most FILE RANKS N: the largest memory of a rank, in kB
most() {
	on_ranks "$2" /usr/bin/time -f %M -a -o kilobytes "$TSIM" -in "$1" -log none -screen none -var n "$3" >out 2>&1 </dev/null
	sort -n kilobytes | tail -1
	rm -f kilobytes
}

# most_bytes RANKS LIMIT SMALL LARGE: bytes of a particle in a rank that has the most, of scenes of 20^3 and 60^3 particles
most_bytes() {
	{ most "$3" "$1" 20; most "$4" "$1" 60; } >measured
	awk -v limit="$2" 'NR == 1 { m = $1 } END { m = ($1 - m) * 1024 / (60^3 - 20^3); print m; exit !(m > 50 && m < limit) }' measured >compared
	report "bytes of a particle on $1 ranks" $? compared
	cat compared
}

# laws: of a script, what follows its grains of about diameter 1
laws() {
	cat <<'E2'
pair_style	gran/hertz/history 1000 NULL 50 NULL 0.5 1
pair_coeff	* *
neighbor	0.3 bin
fix		move all nve/sphere
fix		fall all gravity 0.5 vector 0 0 -1
fix		floor all wall/gran hertz/history 1000 NULL 50 NULL 0.5 1 zplane 0 NULL
timestep	0.005
E2
}
