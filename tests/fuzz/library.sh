#!/bin/bash
# library.sh: makes libtsim.a of the Makefile here, instrumented. What reads inputs is optimised, and tells libFuzzer the values
# that it compares, so that these are tried. The rest has the same sanitizers and counters of its branches, but is compiled
# without optimisation, and its comparisons, most of them in loops over particles, are not told. Each compiler gets many files:
# to start one for each took a third of the time. Files that have changed are compiled, and all after a header has.
unset MAKEFLAGS MFLAGS MAKELEVEL # of the make that starts the tests: what make prints here is read
src=$top_srcdir/src
here=$top_srcdir/tests/fuzz
make -s page_text.c || exit 1
make -s -f - list >sources <<'END' || exit 1
include Makefile
list:
	@printf '%s\n' $(filter %.c,$(libtsim_a_SOURCES) $(nodist_libtsim_a_SOURCES))
END
[ -z "$(find "$src" "$here"/{library.sh,prefix.h} Makefile -type f ! -name '*.c' -newer libtsim.a 2>&1 | head -n 1)" ] || rm -rf inputs rest

# compiler KIND FLAGS...: the command, without its input and output, of the compiler that the driver would start
compiler() {
	local kind=$1
	shift
	make -s -f - command <<END 2>&1 | sed -n '/-cc1/ { s/"-disable-free"//; s/"-main-file-name" "[^"]*"//; s/"-o" "[^"]*"//; s/"[^"]*probe.c"//; p }'
include Makefile
command:
	@\$(COMPILE) $* -c probe.c -o probe.o '-###'
END
}

# compile KIND FLAGS...: sources of the list on the standard input, in a folder KIND; an #include of each lies beside its object
compile() {
	local kind=$1 source stub objects=()
	shift
	mkdir -p "$kind"
	[ -f "$kind/prefix.pch" ] || eval "$(compiler "$kind" "$@" | sed 's/"-emit-obj"/"-emit-pch"/')" -x c-header \
		"$here/prefix.h" -o "$kind/prefix.pch" || return 1
	while read -r source; do
		stub=$kind/${source//\//-}
		objects+=("${stub%.c}.o")
		[ -f "$source" ] || source=$top_srcdir/$source
		[ "${stub%.c}.o" -nt "$source" ] && continue
		echo "#include \"$(realpath "$source")\"" >"$stub"
		echo "$stub"
	done >"$kind/stubs"
	command=$(compiler "$kind" "$@" -include-pch "$kind/prefix.pch") \
		xargs -r -n 100 -P "${FUZZ_JOBS:-2}" bash -c 'eval "$command \"\$@\""' compiler <"$kind/stubs" || return 1
	printf '%s\n' "${objects[@]}" >"$kind/objects"
}
reads='^src/(base|core|formula|io|restart|script)/|^src/mesh/mesh_[lrs]'
grep -E "$reads" sources | compile inputs -O1 -fsanitize=fuzzer-no-link &&
	grep -Ev "$reads" sources | compile rest -O0 -fsanitize-coverage=inline-8bit-counters,pc-table &&
	rm -f libtsim.a && cat inputs/objects rest/objects | xargs "${AR:-ar}" cr libtsim.a
