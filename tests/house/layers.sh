#!/bin/bash
# The folders of src/ stand on each other as the table of doc/design.md says, by what files include and by what
# objects link to (nm): the library part of a folder uses only the folders named in its line, all of which have
# their own line above it; its styles those and the ones of the last column, and no other style. So there is no circle of folders.
# Within a folder files call each other in circles only as far as the list `circles` of doc/design.md says.
# shellcheck source=tests/lib_objects.sh
. "${top_srcdir:-$(dirname "$0")/../..}/tests/lib_objects.sh" || exit 99

xargs grep -l '^TS_STYLE(' <"$work/sources" | grep -v '^src/script/' | sed 's|^src/|style |' >"$work/styles"

# "FILE FILE how": the first includes a header of, or links to a symbol of, the second
xargs awk '/^[ \t]*#[ \t]*include[ \t]*"/ {
	header = $0
	sub(/^[^"]*"/, "", header)
	sub(/".*/, "", header)
	print "edge", substr(FILENAME, 5), header, "includes"
}' <"$work/sources" >"$work/edges"
xargs nm -A <"$work/objects" | sed "s|^$builddir/src/\\(.*\\)\\.o:|\\1.c |" | awk '
	NF == 3 && $2 ~ /^[Uu]$/ { used[$1 " " $3] = 1 }
	NF == 4 && $3 ~ /^[TDBRVWCi]$/ { by[$4] = $1 }
	END {
		for (u in used) {
			split(u, part, " ")
			if (part[2] in by && by[part[2]] != part[1])
				print "edge", part[1], by[part[2]], "calls:" part[2]
		}
	}' | sort >>"$work/edges"
grep -q calls: "$work/edges" || { echo "no objects in $builddir"; exit 99; }

# the table: | `folder` | what | uses | its styles also use |
awk -F'|' '/^## Folders/ { on = 1 } /^## / && !/^## Folders/ { on = 0 }
	on && $2 ~ /^ *`[a-z]+` *$/ { gsub(/[` ]/, "", $2); print "folder", $2; n = split($4, u, " "); for (k = 1; k <= n; k++) print "uses", $2, u[k]
		n = split($5, u, " "); for (k = 1; k <= n; k++) print "also", $2, u[k] }
	/^circle: / { gsub(/[`,]/, ""); sub(/^circle: /, ""); print "circle", $0 }' doc/design.md >"$work/table"

cat "$work/table" "$work/styles" "$work/edges" | awk '
	function folder(file) { return file ~ /\// ? substr(file, 1, index(file, "/") - 1) : "" }
	function fault(text) { if (!(text in told)) print text; told[text] = 1; bad = 1 }
	$1 == "folder" { line[$2] = ++lines }
	$1 == "uses" {
		uses[$2, $3] = 1
		if (!($3 in line))
			fault("doc/design.md: " $2 " uses " $3 ", which has no line above it")
	}
	$1 == "also" { also[$2, $3] = 1 }
	$1 == "circle" { for (k = 2; k <= NF; k++) circle[$k] = $2 }
	$1 == "style" { style[$2] = 1 }
	$1 == "edge" {
		a = folder($2); b = folder($3)
		if (a == "" || b == "") next
		if (!(a in line)) fault("doc/design.md has no line for the folder " a)
		if ($3 in style) fault($2 " " $4 " of the style " $3)
		else if (a == b) {
			if (!($2 in style) && $4 ~ /^calls:/) near[$2] = near[$2] " " $3
		} else if (($2 in style) && ((a, b) in also)) seen[a, b] = 1
		else if ((a, b) in uses) seen[a, b] = 1
		else fault($2 ($2 in style ? " (style)" : "") " " $4 ($4 == "includes" ? " " : " of ") $3 ": " a " may not use " b)
	}
	# files of a folder that reach each other
	function walk(from, at,    n, next_, k) {
		n = split(near[at], next_, " ")
		for (k = 1; k <= n; k++)
			if (!((from, next_[k]) in reach)) { reach[from, next_[k]] = 1; walk(from, next_[k]) }
	}
	END {
		for (u in uses) if (!(u in seen)) { split(u, p, SUBSEP); fault("doc/design.md: " p[1] " does not use " p[2]) }
		for (u in also) if (!(u in seen)) { split(u, p, SUBSEP); fault("doc/design.md: styles of " p[1] " do not use " p[2]) }
		for (f in near) files[++n] = f
		for (k = 1; k <= n; k++) walk(files[k], files[k])
		for (k = 1; k <= n; k++) {
			f = files[k]
			if (((f, f) in reach) && !(f in circle)) {
				with = ""
				for (j = 1; j <= n; j++)
					if (files[j] != f && ((f, files[j]) in reach) && ((files[j], f) in reach)) with = with " " files[j]
				fault(f " is in a circle of calls with" with)
			}
		}
		exit bad
	}' >"$work/faults"
status=$?
sort "$work/faults"
exit $status
