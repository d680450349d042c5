#!/bin/bash
# Fuzzing with libFuzzer, address and undefined-behaviour sanitizers: FUZZ_SECONDS in all, shared by the
# targets named (all); without FUZZ_SECONDS, as in make check-full, the same number of the same inputs on any
# machine, half a minute.
# Works in FUZZ_FOLDER (fuzzing in the build folder), where the corpus grows from call to call. Skipped
# where clang has no libFuzzer (apt-get install clang libclang-rt-14-dev).
cd "${top_builddir:-.}" || exit 99
top_builddir=$PWD
top_srcdir=$(cd "${top_srcdir:-$(dirname "$0")/../..}" && pwd)
here=$top_srcdir/tests/fuzz
folder=${FUZZ_FOLDER:-$top_builddir/fuzzing}
export top_srcdir TSIM=${TSIM:-$top_builddir/tsim}
targets=(${*:-script check explain expression restart data mesh})
declare -A runs=([script]=690 [check]=700 [explain]=800 [expression]=8000 [restart]=6000 [data]=8000 [mesh]=10000)
# adding 0 to a null pointer is no fault: pointer-overflow is left out below
sanitize=address,undefined,float-cast-overflow
clang=${CLANG:-clang}

mkdir -p "$folder" && cd "$folder" || exit 99
echo 'int LLVMFuzzerTestOneInput(const char *d, long n) { return d && n < 0; }' >probe.c
if ! $clang -fsanitize=fuzzer,address probe.c -o probe 2>probe.err; then
	echo 'skipped: no clang with libFuzzer (apt-get install clang libclang-rt-14-dev)'
	exit 77
fi

if [ -f "$top_srcdir/config.status" ]; then
	echo 'skipped: the source folder is configured itself; build in another one to fuzz'
	exit 77
fi
command -v python3 >/dev/null || { echo 'skipped: no python3 for the seeds'; exit 77; }

# the library once more, instrumented; UBSan tells lines of the source without debug information;
# for those of ASan, in an empty FUZZ_FOLDER: FUZZ_CFLAGS=-g1. library.sh knows what to compile again: lists of dependencies of
# each file, which take two thirds of the time of configure, are not needed, nor what makes the book.
flags="-w -g0 -fno-omit-frame-pointer -fsanitize=$sanitize -fno-sanitize-recover=all -fno-sanitize=pointer-overflow $FUZZ_CFLAGS"
if ! [ -f Makefile ]; then
	CC=$clang CFLAGS="$flags" ts_cv_book=no \
		"$top_srcdir/configure" -q --disable-openmp --disable-dependency-tracking >configure.out 2>&1 ||
		{ cat configure.out; exit 1; }
fi
libraries=$(sed -nE 's/^(GSL|ZLIB|PNG|HDF5|HYPRE)_LIBS = //p' Makefile | tr '\n' ' ') # those that configure has found
"$here/library.sh" >make.out 2>&1 || { tail -20 make.out; exit 1; }

linker= # lld links in half of the time
command -v ld.lld >probe.err && linker=-fuse-ld=lld

# words of the language, from the tables; scripts are also mutated by lines and words (tokens.c)
export FUZZ_WORDS=$folder/words
cat "$top_srcdir"/doc/styles/*.md | grep -oE '[a-z][a-z_/0-9]+' | sort -u | sed 's/.*/"&"/' >words

"$here/seeds.sh" "${targets[@]}"
failed=0
for target in "${targets[@]}"; do
	parts=("$here/sandbox.c")
	case $target in script | check | explain) parts+=("$here"/{scripts,tokens}.c) ;; esac
	$clang -O1 $flags $linker -fsanitize=fuzzer -D_GNU_SOURCE -I"$top_srcdir/src" "$here/fuzz_$target.c" \
		"${parts[@]}" libtsim.a $libraries -lm @"$here/wrap.ld" \
		-o "fuzz_$target" || exit 1
	# To choose inputs by rare branches (entropic) costs time in each run, for which data files and meshes cover 2 and 10 % more
	# branches, the others no more; to choose those of scripts by values, too, took half of their time and covers no more.
	case $target in
	script | check | explain) effort='-entropic=0 -use_value_profile=0' ;;
	data | mesh) effort='-entropic=1 -use_value_profile=1' ;;
	*) effort='-entropic=0 -use_value_profile=1' ;;
	esac
	effort="-seed=20231 -runs=${runs[$target]} $effort"
	[ -z "$FUZZ_SECONDS" ] ||
		effort="-seed=$RANDOM -max_total_time=$((FUZZ_SECONDS / ${#targets[@]})) -use_value_profile=1"
	mkdir -p "corpus.$target" "found.$target" "empty.$target"
	(
		cd "empty.$target" || exit 99
		ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1:quarantine_size_mb=64 nice -n 19 \
			"../fuzz_$target" -dict=../words -artifact_prefix="../found.$target/" -timeout=120 \
			-rss_limit_mb=2048 -max_len=8192 -print_final_stats=1 \
			$effort "../corpus.$target" \
			"../seeds.$target" "$here/corpus/$target" >"../log.$target" 2>&1
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
