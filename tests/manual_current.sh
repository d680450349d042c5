#!/bin/sh
# The committed manual pages are those the program writes.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$TSIM" -doc "$work" || exit 1
if ! diff -r "$top_srcdir/doc/styles" "$work"; then
	echo "doc/styles is stale: run make manual and commit the result"
	exit 1
fi
