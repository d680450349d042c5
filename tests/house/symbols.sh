#!/bin/sh
# The library exports only names that begin with ts_ or tsim_, the shared one only those that tsim.h
# declares, and none has writable data but the counters of base/alloc.c.
command -v nm >/dev/null || { echo 'skipped: needs nm (apt-get install binutils)'; exit 77; }
library=$top_builddir/libtsim.a
status=0

complain() {
	[ -z "$2" ] && return
	echo "$1: $2"
	status=1
}

# Functions and data alike.
complain 'exported without ts_ or tsim_' "$(nm -g --defined-only "$library" 2>/dev/null |
	awk 'NF == 3 { print $3 }' |
	grep -vE '^(ts_|tsim_|\.|__asan|__odr_asan|__ubsan|_ZTI)' | sort -u)"

# Constant tables with pointers are in .data.rel.ro, which is read-only when linked.
writable() {
	nm -A --format=sysv "$1" 2>/dev/null | awk -F'|' '
		$7 ~ /^ *\.(bss|data|tbss|tdata)$/ && $4 ~ /OBJECT/ {
			file = $1; sub(/:[^:]*$/, "", file); sub(/.*:/, "", file)
			name = $1; sub(/.*:/, "", name); gsub(/ /, "", name)
			if (file !~ /alloc/ && name !~ /^(__|\.)/) print file ": " name
		}'
}
complain 'writable data' "$(writable "$library")"

if [ -n "$SHARED" ]; then
	shared=$top_builddir/$SHARED
	found=$(nm -D --defined-only "$shared" | awk '{ print $3 }' | grep -v '^__\(asan\|odr\)\|^\.' | sort)
	declared=$(sed -nE 's/^TSIM_API .*[ *](tsim_[a-z_]+)\(.*/\1/p' "$top_srcdir/src/tsim.h" | sort)
	complain 'exported, but not in tsim.h' "$(printf '%s\n' "$found" | grep -vxF "$declared")"
	complain 'in tsim.h, but not exported' "$(printf '%s\n' "$declared" | grep -vxF "$found")"
	# the counters of base/alloc.c and what the linker adds
	complain 'writable data of the shared library' "$(writable "$shared" |
		grep -vE ': (live_blocks|fail_countdown|completed\.[0-9]+)$')"
fi
exit $status
