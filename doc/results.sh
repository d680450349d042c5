#!/bin/bash
# Writes doc/results.md: the RESULT lines of examples that run in some seconds each, with the settings given here.
#	TSIM=./tsim bash doc/results.sh
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
tsim=$(realpath "${TSIM:-$root/build/tsim}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TSIM_POTENTIALS=$root/potentials
cp -r "$root/examples" "$root/potentials" "$work/" || exit 1

{
	cat <<'END'
# Results of the examples

Examples judge themselves: `RESULT name value reference tolerance ok|off` compares a number that was simulated with a published
or an exact one. This page has those of the examples that take some seconds, with the settings shown; it is made by
`make results`, and `tests/examples` checks the same lines. The scripts say where each reference comes from, and have finer
settings. Long runs are on the pages of their subject.

| example | settings | result | value | reference | tolerance | |
|---|---|---|---|---|---|---|
END
	while read -r folder script words; do
		[ -n "$folder" ] || continue
		(
			cd "$work/examples/$folder" || exit 1
			# shellcheck disable=SC2086
			"$tsim" -in "$script" -log none $words >out 2>&1 </dev/null
			settings=$(printf '%s' "$words" | sed 's/-var \([^ ]*\) \([^ ]*\)/\1=\2/g')
			awk -v example="$folder/$script" -v settings="$settings" '
				/^RESULT / {
					printf "| `%s` | %s | %s | %s | %s | %s | %s |\n", example, settings, $2, $3, $4, $5, $6
					n++
				}
				END { exit !n }' out || { echo "$folder/$script gives no RESULT line:"; tail -n 5 out; } >&2
		)
	done <<'END'
everyday in.hopper -var grains 2000 -var outlet 6 -var bin 7 -var steps 10000
everyday in.drum -var R 0.03 -var length 0.01 -var small 0.0018 -var rpm 40 -var start 500 -var steps 3000
everyday in.compaction -var grains 600 -var R 0.012 -var steps 32000
everyday in.chute -var steps 6000
everyday in.chute -var slope 60 -var steps 6000
everyday in.tilt -var rolling 0.1 -var speed 8
materials in.rebound
flow/poiseuille in.poiseuille
flow/settling in.settling
flow/taylor_green in.taylor_green
film in.automaton
drilling in.drilling -var depth 700 -var T 80 -var land 20 -var vtk no
END
} >"$work/results.md"
mv "$work/results.md" "$root/doc/results.md"
