#!/bin/bash
# Fuzzing with libFuzzer, address and undefined-behaviour sanitizers: FUZZ_SECONDS (60) in all, shared by
# the targets named (all). Works in FUZZ_FOLDER (fuzzing in the build folder), where the corpus grows from
# call to call. Skipped where clang has no libFuzzer (apt-get install clang libclang-rt-14-dev).
cd "${top_builddir:-.}" || exit 99
top_builddir=$PWD
top_srcdir=$(cd "${top_srcdir:-$(dirname "$0")/../..}" && pwd)
here=$top_srcdir/tests/fuzz
folder=${FUZZ_FOLDER:-$top_builddir/fuzzing}
TSIM=${TSIM:-$top_builddir/tsim}
targets=(${*:-script expression restart data})
sanitize=address,undefined,float-cast-overflow  # null + 0 is no fault: pointer-overflow is left out below
clang=${CLANG:-clang}

mkdir -p "$folder" && cd "$folder" || exit 99
echo 'int LLVMFuzzerTestOneInput(const char *d, long n) { return d && n < 0; }' >probe.c
if ! $clang -fsanitize=fuzzer,address probe.c -o probe 2>probe.err; then
	echo 'skipped: no clang with libFuzzer (apt-get install clang libclang-rt-14-dev)'
	exit 77
fi

# the library once more, instrumented; make builds what has changed
flags="-O1 -g -fno-omit-frame-pointer -fsanitize=$sanitize -fno-sanitize-recover=all -fno-sanitize=pointer-overflow"
if ! [ -f Makefile ]; then
	CC="${CCACHE_DIR:+ccache }$clang" CFLAGS="$flags -fsanitize=fuzzer-no-link" \
		"$top_srcdir/configure" -q --disable-openmp >configure.out 2>&1 ||
		{ cat configure.out; exit 1; }
fi
make -s -j"${FUZZ_JOBS:-2}" libtsim.a >make.out 2>&1 || { tail -20 make.out; exit 1; }

# words of the language, from the tables
cat "$top_srcdir"/doc/styles/*.md | grep -oE '[a-z][a-z_/0-9]+' | sort -u | sed 's/.*/"&"/' >words

seeds() {
	case $1 in
	script) set -- "$1" "$top_srcdir"/{tests/decks,examples/*}/in.* "$top_srcdir"/doc/styles/*.md ;;
	expression) set -- "$1" "$top_srcdir"/{tests/decks,examples/*}/in.* ;;
	data)
		printf 'read_restart %s\nwrite_data data.seed\n' "$top_srcdir/tests/data/version1.restart" |
			"$TSIM" -log none -screen none
		set -- data data.seed "$top_srcdir"/tests/data/data.*
		;;
	restart) set -- "$1" "$top_srcdir"/tests/data/*.restart ;;
	esac
	python3 "$here/make_seeds.py" "$1" "seeds.$1" "${@:2}"
}

failed=0
for target in "${targets[@]}"; do
	$clang $flags -fsanitize=fuzzer -D_GNU_SOURCE -I"$top_srcdir/src" "$here/fuzz_$target.c" \
		"$here/sandbox.c" libtsim.a -lgsl -lgslcblas -lz -lm @"$here/wrap.ld" \
		-o "fuzz_$target" || exit 1
	seeds "$target"
	mkdir -p "corpus.$target" "found.$target" "empty.$target"
	(
		cd "empty.$target" || exit 99
		ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1 nice -n 19 \
			"../fuzz_$target" -dict=../words -artifact_prefix="../found.$target/" -timeout=20 \
			-rss_limit_mb=2048 -max_len=8192 -print_final_stats=1 -use_value_profile=1 \
			-max_total_time=$((${FUZZ_SECONDS:-60} / ${#targets[@]})) "../corpus.$target" \
			"../seeds.$target" $(ls -d "$here/corpus/$target" 2>/dev/null) >"../log.$target" 2>&1
	)
	status=$?
	echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "log.$target") executions," \
		"$(sed -n 's/^stat::average_exec_per_sec: *//p' "log.$target") per second," \
		"$(ls "corpus.$target" | wc -l) inputs kept"
	if [ $status != 0 ]; then
		failed=1
		tail -n 60 "log.$target"
	fi
done
exit $failed
