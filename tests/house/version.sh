#!/bin/bash
# The version is defined once, in configure.ac; every file that repeats it says the same.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
version=$(sed -n 's/^AC_INIT(\[tsim\], \[\([0-9.]*\)\]).*/\1/p' "$top_srcdir/configure.ac")
[ -n "$version" ]
report 'configure.ac has a version' $?

# says FILE PROGRAM: sed's program prints the version that the file, or standard input, has
says() {
	local found
	case $1 in
	-) found=$(sed -n "$2") ;;
	*) found=$(sed -n "$2" "$1") ;;
	esac
	[ "$found" = "$version" ]
	report "${3-${1#"$top_srcdir/"}}: '$found' instead of '$version'" $?
}
says - 's/^tsim \([0-9.]*\)$/\1/p' 'tsim -version' < <("$TSIM" -version)
says "$top_builddir/tsim.pc" 's/^Version: //p' tsim.pc
says "$top_srcdir/NEWS" '1s/^tsim //p'
says "$top_srcdir/CITATION.cff" 's/^version: //p'
says "$top_srcdir/doc/tsim.1" '1s/.*"tsim \([0-9.]*\)".*/\1/p'
says "$top_srcdir/editors/vscode/package.json" 's/^  "version": "\(.*\)",$/\1/p'
says "$top_srcdir/debian/changelog" '1s/^tsim (\(.*\)-[0-9]*) .*/\1/p'
[ -z "$SHARED" ] || says - 's/.*tsim_version: //p' 'tsim_version of the shared library' < <(
	printf '#include "tsim.h"\nint main(void) { printf("tsim_version: %%s\\n", tsim_version()); return 0; }\n' >v.c
	# shellcheck disable=SC2086
	${CC:-gcc} $CFLAGS -I"$top_srcdir/src" v.c -o v "$top_builddir/$SHARED" $TSIM_LIBS 2>err &&
		ln -s "$top_builddir/$SHARED" libtsim.so.0 && LD_LIBRARY_PATH=. ./v
)
# nowhere else: a number like this one in the files of the build
grep -lF "$version" "$top_srcdir"/{Makefile.am,setup,tests/Makefile.inc,src/Makefile.inc,src/tsim.pc.in,src/tsim.h,setup.py,pyproject.toml,python/tsim/__init__.py} >found
[ ! -s found ]
report 'derived from configure.ac' $? found
finish
