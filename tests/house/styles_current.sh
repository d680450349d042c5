#!/bin/sh
# The committed generated lists are those the sources give.
set -e
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sh "$top_srcdir/src/build/gen-styles.sh" "$work"
for file in src/library/style_table.c src/sources.mk tests/sources.mk; do
	if ! diff -u "$top_srcdir/$file" "$work/$file"; then
		echo "$file is stale: run sh src/build/gen-styles.sh and commit the result"
		exit 1
	fi
done
