#!/bin/bash
# Each style and command that LIGGGHTS and LAMMPS list is one of tsim's, or refused with the reason: none is unknown.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# names < FILE: kind and name of what the program's -h lists, by headings `* Fix styles` with or without a colon
names() {
	awk '/^\* / { kind = tolower($2); next }
		kind ~ /^(atom|pair|bond|fix|compute|region|dump|command)$/ {
			for (k = 1; k <= NF; k++)
				if ($k !~ /^[A-Z]+(\/[A-Z]+)*$/ && $k !~ /[(:)]/) print kind, $k }' |
		grep -Ev '/(omp|opt|kk|intel|gpu)$' | sort -u
}

line_of() { # kind, name
	local box='region b block 0 1 0 1 0 1 units box
create_box 1 b'
	case $1 in
	atom) echo "atom_style $2" ;;
	pair | bond) printf '%s\n%s_style %s\n' "$box" "$1" "$2" ;;
	fix | compute) printf '%s\n%s a all %s\n' "$box" "$1" "$2" ;;
	dump) printf '%s\ndump a all %s 1 x.y\n' "$box" "$2" ;;
	region) echo "region a $2" ;;
	command) echo "$2" ;;
	esac
}

for program in liggghts lmp; do
	has "$program" "${program/lmp/lammps}" || continue
	"$program" -h 2>&1 | tr -d '\0' | names >list
	: >unknown
	while read -r kind name; do
		line_of "$kind" "$name" >in.one
		"$TSIM" -in in.one -log none >out 2>&1 </dev/null
		grep -E "error: unknown (command|[a-z]+ style) '$name'" out >>unknown
	done <list
	[ "$(wc -l <list)" -gt 150 ]
	report "$program lists its styles" $? list
	[ ! -s unknown ]
	report "names of $program" $? unknown
done
finish
