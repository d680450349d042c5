#!/bin/sh
# compile.sh CLANG WORDS...: compiles a file for fuzzing. What reads inputs is optimised, and tells libFuzzer the values that it
# compares, so that these are tried; the rest has the same sanitizers and counters of its branches,
# but is compiled without optimisation, in a third of the time, and its comparisons, most of them of loops over particles, are
# not told.
clang=$1
shift
case " $* " in
*/src/base/* | */src/core/* | */src/formula/* | */src/io/* | */src/restart/* | */src/script/* | */src/mesh/mesh_[lrs]*)
	exec "$clang" -O1 -fsanitize=fuzzer-no-link "$@"
	;;
*) exec "$clang" -O0 -fsanitize-coverage=inline-8bit-counters,pc-table "$@" ;;
esac
