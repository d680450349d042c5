#!/bin/bash
# Every deck whole is the same deck cut at random steps and continued from a restart file: what it writes,
# its tables and its final state, byte for byte; the second part on two threads. SEED chooses the steps;
# CUTS (2) is how often each deck is cut.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs python3
seed=${SEED:-20231}
echo "SEED=$seed"
RANDOM=$((seed % 32768))
export OMP_WAIT_POLICY=passive

# part FOLDER THREADS: runs its deck there
part() {
	printf 'package omp %s grain 1\ninclude deck\n' "$2" >"$1/in"
	(cd "$1" && "$TSIM" -in in -log log -screen none "${options[@]}" 2>err)
	report "$name: $1" $? "$1/err"
}

compare() { # STEP
	local file
	python3 -IS "$top_srcdir/tests/compare_parts.py" whole one two >compared
	report "$name: compared" $?
	while IFS= read -r file; do
		[[ $file == *': same' ]]
		report "$name: $file" $?
	done <compared
	same "$name: the state at the end" whole/end.restart two/end.restart
	rows whole/log | grep -vE "^ +$1 " >expected
	rows one/log two/log | grep -vE "^ +$1 " >found
	same "$name: tables" expected found
}

# cut_at RUN STEPS: the deck in two
cut_at() {
	rm -rf one two && mkdir one two
	python3 -IS "$top_srcdir/tests/split_deck.py" "$deck" "$1" "$2" one/deck two/deck
	part one 1
	cp one/cut.restart two
	part two 2
	compare "$(sed -n 's/^ *\([0-9]*\) .*/\1/p' one/log | tail -n 1)"
	[ $failed = 0 ] || { echo "$name: cut after $2 steps of run $1"; finish; }
}

# cut DECK OPTIONS...: the deck once whole, and in two CUTS times and where a line `# cut RUN STEPS` of it says
cut() {
	local deck=$1 lengths run steps
	name=$(basename "$deck")
	shift
	options=("$@")
	rm -rf whole && mkdir whole
	python3 -IS "$top_srcdir/tests/split_deck.py" "$deck" 0 0 whole/deck none
	part whole 1
	mapfile -t lengths < <(sed -n 's/^Loop time of .* for \([0-9]*\) steps .*/\1/p' whole/log)
	for ((k = 0; k < ${CUTS:-2}; k++)); do
		run=$((RANDOM % ${#lengths[@]}))
		steps=$((RANDOM % (${lengths[run]} + 1)))
		cut_at $((run + 1)) $steps
	done
	while read -r run steps; do
		cut_at "$run" "$steps"
	done < <(sed -n 's/^# cut //p' "$deck")
}

# The drilling example goes on from the restart file of a shorter run of itself.
drill() { # FOLDER OPTIONS...
	mkdir -p "drilling/$1" && cp "$top_srcdir"/examples/drilling/in.* "drilling/$1"
	(cd "drilling/$1" && "$TSIM" -in in.drilling -var depth 500 -var land 2 -var vtk no -var out . \
		-log none -screen none "${@:2}" 2>err)
	report "drilling: $1" $? "drilling/$1/err"
}
drill whole -var T 12
drill one -var T "$((RANDOM % 8 + 4)).$((RANDOM % 100))"
OMP_NUM_THREADS=2 drill two -var T 12 -var rock ../one/drill.restart
same 'drilling: the state at the end' drilling/whole/drill.restart drilling/two/drill.restart
for file in bit.txt broken.txt; do
	grep -v '^#' drilling/whole/$file >expected
	cat drilling/one/$file drilling/two/$file | grep -v '^#' >found
	same "drilling: $file" expected found
done

for deck in "$top_srcdir"/tests/decks/in.* "$top_srcdir"/tests/data/in.*; do
	cut "$deck" -var out out -var last 700
done

# each style that remembers something is in one of the decks
for file in $(grep -lE '\.(saved|archive) = ' "$top_srcdir"/src/*/{fix,compute,dump}_*.c); do
	style=$(sed -n '/^TS_STYLE/,$s/.*\.name = "\([^"]*\)",.*/\1/p' "$file" | head -n 1)
	[ "$style" = restart ] && continue
	[ "$style" = h5md ] && continue # needs a library: dump/h5md.sh
	[ "$style" = movie ] && continue # goes on in another file, and needs ffmpeg; its pictures are those of dump image
	kind=$(basename "$file")
	kind=${kind%%_*}
	grep -hE "^$kind[[:space:]]" "$top_srcdir"/tests/decks/in.* | awk '{ print $4, $3 }' | grep -qw "$style"
	report "$kind $style is in a deck of tests/decks" $?
done
finish
