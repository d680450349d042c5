#!/bin/sh
# The library exports only names that begin with ts_ or tsim_, and has no writable globals but the
# counters of base/alloc.c.
command -v nm >/dev/null || exit 77
library=$top_builddir/libtsim.a
status=0

foreign=$(nm -g --defined-only "$library" 2>/dev/null | awk 'NF == 3 { print $3 }' |
	grep -vE '^(ts_|tsim_|\.|__asan|__odr_asan|__ubsan|_ZTI)' | sort -u)
if [ -n "$foreign" ]; then
	echo "exported without ts_ or tsim_: $foreign"
	status=1
fi

# B, b: zeroed; D, d: initialised writable data (constant tables with pointers may be in d of
# .data.rel.ro, which is read-only when linked).
writable=$(nm -A --format=sysv "$library" 2>/dev/null | awk -F'|' '
	$7 ~ /^ *\.(bss|data)$/ {
		file = $1; sub(/:[^:]*$/, "", file); sub(/.*:/, "", file)
		name = $1; sub(/.*:/, "", name); gsub(/ /, "", name)
		if (file !~ /alloc/ && name !~ /^(__|\.)/) print file ": " name
	}')
if [ -n "$writable" ]; then
	echo "writable data: $writable"
	status=1
fi
exit $status
