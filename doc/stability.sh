#!/bin/sh
# Writes stability.txt beside it anew: every limit of the time step that bisection finds in simulations, beside theory.
# Run in the build folder by `make stability`.
set -e
here=$(cd "$(dirname "$0")" && pwd)
new=$(mktemp)
trap 'rm -f "$new"' EXIT
for test in limits contacts network couplings drag_lag flow_limits relaxation; do
	CK_FORK=no TS_TABLE=$new "tests/stability/check_$test" >/dev/null
	echo >>"$new"
done
# a title once, whatever the number of tests below it
awk -F '\t' '/, theory$/ { if (seen[$0]++) { getline; next } }
	NF == 4 { $0 = sprintf("%-62s %11s %11s %7s", $1, $2, $3, $4) }
	{ print }' "$new" | sed '$d' >"$here/stability.txt"
