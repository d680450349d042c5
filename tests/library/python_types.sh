#!/bin/bash
# The type hints of the Python module by mypy, in its strict form.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs mypy
cp "$top_srcdir/pyproject.toml" .
cp -r "$top_srcdir/python" .
mypy >out 2>&1
report 'mypy --strict' $? out
finish
