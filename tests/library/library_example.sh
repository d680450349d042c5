#!/bin/bash
# Programs outside: the C example with the static and with the shared library; the header in C++.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
flags="-I$top_srcdir/src $CFLAGS"

# shellcheck disable=SC2086
$CC -std=c11 -Wall -Wextra -Werror -pedantic $flags "$top_srcdir/examples/library/coupled.c" \
	"$top_builddir/libtsim.a" $TSIM_LIBS -o static >out 2>&1 && ./static >static.out 2>&1
report 'coupled.c, static library' $? static.out
if [ -n "$SHARED" ]; then
	# shellcheck disable=SC2086
	$CC $flags "$top_srcdir/examples/library/coupled.c" "$top_builddir/$SHARED" \
		-Wl,-rpath,"$top_builddir" -lm -o shared >out 2>&1 &&
		ln -s "$top_builddir/$SHARED" libtsim.so.0 &&
		LD_LIBRARY_PATH=. ./shared >shared.out 2>&1
	report 'coupled.c, shared library' $? shared.out
	same 'both give the same numbers' static.out shared.out
fi

cat >header.cc <<'END'
#include <tsim.h>
int main()
{
	struct tsim_box box = TSIM_INIT(struct tsim_box);
	struct tsim_view view = TSIM_INIT(struct tsim_view);
	struct tsim *sim = tsim_open();
	tsim_box(sim, &box);
	int bad = box.size != sizeof box || view.data || box.exists || tsim_count(sim);
	tsim_close(sim);
	return bad;
}
END
case $CC in # OpenMP is the compiler's own
*clang*) cxx=clang++ ;;
*) cxx=g++ ;;
esac
if has $cxx g++; then
	# shellcheck disable=SC2086
	$cxx -std=c++11 -Wall -Wextra -Werror -pedantic $flags header.cc "$top_builddir/libtsim.a" \
		$TSIM_LIBS -o header >out 2>&1 && ./header
	report 'tsim.h in C++' $? out
fi
finish
