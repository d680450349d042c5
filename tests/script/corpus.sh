#!/bin/bash
# The fuzzers' inputs, tried once each without libFuzzer: seeds from decks, examples and manual pages, and
# what was found before (tests/fuzz/corpus).
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs python3
fuzz=$top_srcdir/tests/fuzz
# one linker option each: not all linkers know them
echo 'int main(void) { return 0; }' >probe.c
${CC:-gcc} probe.c -Wl,--wrap=fopen -o probe 2>/dev/null || {
	echo 'skipped: the linker does not know --wrap'
	exit 77
}

targets=(script check explain expression restart data mesh)
"$fuzz/seeds.sh" "${targets[@]}"
for target in "${targets[@]}"; do
	scripts=()
	case $target in script | check | explain) scripts=("$fuzz/scripts.c") ;; esac
	# shellcheck disable=SC2086
	${CC:-gcc} ${CFLAGS--g} -D_GNU_SOURCE -I"$top_srcdir/src" "$fuzz/fuzz_$target.c" "${scripts[@]}" "$fuzz/sandbox.c" \
		"$fuzz/replay.c" "$top_builddir/libtsim.a" \
		${TSIM_LIBS--fopenmp -lgsl -lgslcblas -lz -lm} @"$fuzz/wrap.ld" -o "replay_$target" 2>err
	report "$target: compiled" $? err
	mkdir -p empty "seeds.$target" && cd empty || exit 99
	"../replay_$target" ../"seeds.$target" "$fuzz/corpus/$target" >../out 2>../err
	report "$target: all tried" $? ../err
	[ -z "$(ls)" ]
	report "$target: nothing written" $?
	cd ..
	echo "$target: $(cat out)"
done
finish
