#!/bin/bash
# Makes doc/words.md: which commands, styles and keywords of LIGGGHTS scripts tsim supports. Sources are
# tests/data/words.txt (words of 480 public scripts with the number of scripts that use them), the messages of
# tsim for a line with each style, and its manual pages.
#	TSIM=./tsim sh doc/words.sh >doc/words.md
cd "$(dirname "$0")/.." || exit 1
tsim=${TSIM:-tsim}
words=tests/data/words.txt
pages=doc/styles
tab=$(printf '\t')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Styles and commands: yes (supported), no, or known (refused with a reason).
{
	awk -F'\t' '$1 == "atom_style" { print $1, $2 }' $words
	printf 'region b block 0 1 0 1 0 1 units box\ncreate_box 1 b\n'
	# commands last, because `jump` and others leave the script
	{ grep -v '^#' $words | grep -v '^command'; grep '^command' $words; } | awk -F'\t' '
		$1 == "fix" || $1 == "compute" { print $1, "x" NR, "all", $2; next }
		$1 == "dump" { print $1, "x" NR, "all", $2, "1 f"; next }
		$1 == "region" { print $1, "x" NR, $2; next }
		$1 == "pair" || $1 == "bond" { print $1 "_style", $2; next }
		$1 == "model" { print "pair_style gran model", $2; next }
		$1 == "cohesion" || $1 == "rolling_friction" || $1 == "surface" || $1 == "tangential" {
			print "pair_style gran model hertz", $1, $2
			next
		}
		$1 == "pair gran" { print "pair_style gran model hertz", $2; next }
		$1 == "wall/gran" { print "fix x" NR, "all wall/gran model hertz", $2; next }
		$1 == "set" { print "set group all", $2, 1; next }
		$1 == "dump column" { print "dump x" NR, "all custom 1 f", $2; next }
		$1 == "command" { print $2 }'
} >"$work/in"
$tsim -check -in "$work/in" >/dev/null 2>"$work/errors" </dev/null
style() {
	if grep -qE "$1 (style )?'$(printf %s "$2" | sed 's/[*]/\\*/g')' is known from" "$work/errors"; then
		echo known
	elif grep -qE "unknown ($1 style|command) '$(printf %s "$2" | sed 's/[*]/\\*/g')'" "$work/errors"; then
		echo no
	else
		echo yes
	fi
}

# The reason in the message of tsim.
reason() {
	local said="$1 (style )?'$2' is known from .*|$1 is '$2', expected.* is known, .*|$1 $2 is known, but .*"

	case $1 in
	'dump column') said="quantity '$2' is known, .*" ;;
	'pair gran' | wall/gran | set) said="keyword '$2' is known, .*" ;;
	esac
	case $1:$2 in
	material:*Bondnonlinear | material:stiffnessPerUnitArea*)
		echo 'it belongs to cohesion bond/nonlinear, which is refused'
		return
		;;
	esac
	grep -hoE -- "$said" "$work/errors" | sed 's/.*but tsim does not have it: //' | head -n 1
}

# Other words: found on one of the manual pages, or refused with a reason.
# shellcheck disable=SC2048,SC2086
page() {
	local word=$1
	shift
	if [ -n "$(reason "$kind" "$word")" ]; then
		echo known
	elif (cd $pages && cat $* 2>/dev/null) | grep -qE "(^|[^A-Za-z0-9_/])$word([^A-Za-z0-9_/]|\$)"; then
		echo yes
	else
		echo no
	fi
}

judge() {
	case $1 in
	fix | compute | dump | region | pair | bond | command) style "$1" "$2" ;;
	atom_style | set) page "$2" "command_$1.md" ;;
	boundary | create_atoms | dump_modify | group | lattice | neigh_modify | run | thermo_modify | units | \
		velocity) page "$2" "command_$1.md" ;;
	cohesion | model | rolling_friction | surface | tangential | 'pair gran') page "$2" pair_gran.md ;;
	'dump column') page "$2" quantities.md dump_custom.md ;;
	function) page "$2" functions.md ;;
	gravity) page "$2" fix_gravity.md ;;
	insert) page "$2" fix_insert_pack.md fix_insert_stream.md fix_insert_rate_region.md ;;
	material) page "$2" pair_gran.md bond_cohesion.md fix_*.md ;;
	mesh) page "$2" fix_mesh_surface*.md ;;
	move/mesh) page "$2" fix_move_mesh.md ;;
	property) page "$2" fix_property_*.md ;;
	'region word') page "$2" region_*.md ;;
	template) page "$2" fix_particletemplate_sphere.md ;;
	thermo_style) page "$2" keywords.md ;;
	variable) page "$2" variables.md ;;
	wall/gran) page "$2" fix_wall_gran.md ;;
	*) echo "no rule for $1" >&2 ;;
	esac
}

grep -v '^#' $words | while IFS=$tab read -r kind word scripts; do
	printf '%s\t%s\t%s\t%s\n' "$kind" "$word" "$scripts" "$(judge "$kind" "$word")"
done >"$work/judged"

cat <<'END'
# Supported LIGGGHTS commands and keywords

This page lists which commands, styles and keywords of LIGGGHTS scripts tsim supports. The words of 480 public LIGGGHTS
scripts from 21 repositories were counted, with the number of scripts that use each. A word is *supported* if it is a
style or command of tsim, or is described on its manual page. A word is *refused* if tsim knows it and gives a reason;
the reasons are listed below. Most refused words belong to methods that tsim does not have (smoothed particles, other
shapes, reactions), or to editions of LIGGGHTS other than 3.8. Other words are *missing*. In the last column each word
is weighted by the number of scripts that use it. The page is made by `doc/words.sh`.

| kind | words | supported | refused | missing | supported, weighted by use |
|---|---|---|---|---|---|
END
awk -F'\t' '
	!($1 in n) { order[++kinds] = $1 }
	{ n[$1]++; use[$1] += $3; N++; U += $3 }
	$4 == "yes" { yes[$1]++; used[$1] += $3; Y++; V += $3 }
	$4 == "known" { known[$1]++; K++ }
	$4 == "no" { no[$1]++; L++ }
	END {
		for (k = 1; k <= kinds; k++) {
			w = order[k]
			printf "| %s | %d | %d | %d | %d | %.1f %% |\n", w, n[w], yes[w], known[w], no[w], 100 * used[w] / use[w]
		}
		printf "| **all** | %d | %d | %d | %d | %.1f %% |\n", N, Y, K, L, 100 * V / U
	}' "$work/judged"
echo
echo '## Missing, by number of scripts'
echo
sort -t "$tab" -k3,3nr -s "$work/judged" | awk -F'\t' '$4 == "no" { printf "%s%s %s (%d)", n++ ? ", " : "", $1, $2, $3 } END { print "" }' | fold -s -w 110 | sed 's/ *$//'
echo
echo '## Refused, with the reason'
echo
awk -F'\t' '$4 == "known"' "$work/judged" | sort -t "$tab" -k3,3nr -s | while IFS=$tab read -r kind word scripts _; do
	printf '%s\n' "- $kind $word ($scripts): $(reason "$kind" "$word")" | fold -s -w 110 | sed 's/ *$//; 2,$s/^/  /'
done
