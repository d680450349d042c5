#!/bin/bash
# What `make install` puts where is enough to build and run the examples; `make uninstall` leaves
# nothing.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
[ -n "$SHARED" ] || { echo 'skipped: built without the shared library'; exit 77; }
needs pkg-config
root=$work/root
unset MAKEFLAGS MAKELEVEL MFLAGS

${MAKE:-make} -C "$top_builddir" install prefix="$root" >out 2>&1
report 'make install' $? out
for file in bin/tsim lib/libtsim.a lib/libtsim.so lib/libtsim.so.0 include/tsim.h lib/pkgconfig/tsim.pc \
	share/man/man1/tsim.1 share/tsim/python/tsim/__init__.py share/bash-completion/completions/tsim share/tsim/potentials/sandstone.spring share/tsim/potentials/glass.material; do
	[ -s "$root/$file" ]
	report "$file is installed" $?
done
"$root/bin/tsim" -version >out 2>&1
report 'the program runs' $? out

export PKG_CONFIG_PATH=$root/lib/pkgconfig
flags=$(pkg-config --define-variable=prefix="$root" --cflags --libs tsim)
# shellcheck disable=SC2086
$CC $CFLAGS "$top_srcdir/examples/library/coupled.c" -o coupled $flags -lm >out 2>&1 &&
	LD_LIBRARY_PATH=$root/lib ./coupled >out 2>&1
report 'the C example builds by pkg-config and runs' $? out

# a sanitizer wants to be loaded before Python
if ! nm -D "$root"/lib/libtsim.so | grep -q __asan_init; then
	cp "$top_srcdir/examples/library/bounce.py" .
	env -u TSIM_LIBRARY PYTHONPATH="$root/share/tsim/python" PYTHONDONTWRITEBYTECODE=1 \
		python3 bounce.py >out 2>&1
	report 'the Python example finds the installed library' $? out
fi

${MAKE:-make} -C "$top_builddir" uninstall prefix="$root" >out 2>&1
[ -z "$(find "$root" -type f -o -type l)" ]
report 'make uninstall' $? out
finish
