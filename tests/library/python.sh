#!/bin/bash
# The Python module, with NumPy (Debian's python3-numpy) and without; its manual, whose examples are
# run; its example and its notebook.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
[ -n "$SHARED" ] || { echo 'skipped: built without the shared library'; exit 77; }
if nm -D "$top_builddir/$SHARED" 2>/dev/null | grep -q __asan_init; then
	echo 'skipped: a sanitizer must be loaded before Python'
	exit 77
fi

python=
for candidate in python3 /usr/bin/python3; do
	"$candidate" -c 'import ctypes' 2>/dev/null || continue
	python=${python:-$candidate}
	"$candidate" -c 'import numpy' 2>/dev/null && python=$candidate && break
done
needs "${python:-python3}" python3
export TSIM_LIBRARY=$top_builddir/$SHARED PYTHONPATH=$top_srcdir/python PYTHONDONTWRITEBYTECODE=1

# tested WHAT COMMAND...: adds the counts of the last line it prints
tested() {
	local what=$1 counts
	shift
	"$@" >out 2>&1
	counts=$(sed -nE '$s/^([0-9]+) passed, ([0-9]+) failed$/\1 \2/p' out)
	[ -n "$counts" ] || counts="0 1"
	passed=$((passed + ${counts% *}))
	failed=$((failed + ${counts#* }))
	[ "${counts#* }" = 0 ] || { echo "off: $what"; tail -n 40 out; }
}

tested 'without NumPy' env WITHOUT_NUMPY=1 "$python" "$top_srcdir/tests/python_test.py"
if python_with numpy python3-numpy; then
	tested 'with NumPy' "$python" "$top_srcdir/tests/python_test.py"
	"$python" -m doctest "$top_srcdir/doc/python.md" >out 2>&1
	report 'the examples of doc/python.md' $? out
fi
if python_with 'numpy, pandas' 'python3-numpy python3-pandas'; then
	tested 'the notebook' "$python" "$top_srcdir/tests/run_notebook.py" "$top_srcdir/examples/library/tutorial.ipynb"
fi
"$python" "$top_srcdir/examples/library/bounce.py" >out 2>&1
report 'examples/library/bounce.py' $? out
TSIM_LIBRARY=/nowhere/libtsim.so "$python" -c 'import tsim' >out 2>&1
shows 'TSIM_LIBRARY' out
report 'a missing library is told' $? out
finish
