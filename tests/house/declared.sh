#!/bin/bash
# A function that other files use is declared in the header of its file, in that of its family (check.h for check_loop.c) or in
# the internal.h of its folder; and its name says its subject: ts_SUBJECT..., the subject being the folder, a word of the
# file's name, or a struct or enum of the folder. base, the vocabulary of all, is free of the second rule.
# shellcheck source=tests/lib_objects.sh
. "${top_srcdir:-$(dirname "$0")/../..}/tests/lib_objects.sh" || exit 99

xargs nm -A <"$work/objects" | sed -n "s|^$builddir/src/\\(.*\\)\\.o:[^ ]* T \\(ts_[A-Za-z0-9_]*\\).*|function \\1 \\2|p" |
	sort -u >"$work/functions"
[ "$(wc -l <"$work/functions")" -gt 1000 ] || { echo "no objects in $builddir"; exit 99; }
grep '\.h$' "$work/sources" | xargs grep -oE '\bts_[A-Za-z0-9_]+\(' |
	sed 's|^src/\(.*\)\.h:\(.*\)($|declared \2 \1|' | sort -u >"$work/declared"
xargs grep -ohE --with-filename '\b(struct|enum) ts_[A-Za-z0-9_]+ \{' <"$work/sources" |
	sed -E 's,^src/([a-z]+)/[^:]*:(struct|enum) (ts_[A-Za-z0-9_]+).*,tag \1 \3,' | sort -u >"$work/tags"

awk '
	function fault(text) { print text; faults++ }
	# a tag of several things names each of them: ts_bonds, ts_bond_count
	$1 == "tag" { sub(/s$/, "", $3); tags[$2] = tags[$2] " " $3 }
	$1 == "declared" { in_header[$2] = in_header[$2] " " $3 }
	function declared_well(folder, stem, symbol,    n, k, h, part) {
		n = split(in_header[symbol], h, " ")
		for (k = 1; k <= n; k++) {
			split(h[k], part, "/")
			if (part[1] == folder && (part[2] == "internal" || index(stem "_", part[2] "_") == 1))
				return 1
		}
		return 0
	}
	function alike(a, b) { return index(a, substr(b, 1, 4)) == 1 || index(b, a) == 1 }
	function says_subject(folder, stem, symbol,    word, n, k, p, list) {
		if (folder == "base" || symbol ~ /^ts_sim_/)
			return 1
		n = split(tags[folder], list, " ")
		for (k = 1; k <= n; k++)
			if (index(symbol, list[k]) == 1)
				return 1
		split(symbol, p, "_")
		n = split(folder "_" stem, word, "_")
		for (k = 1; k <= n; k++)
			if (alike(p[2], word[k]))
				return 1
		return 0
	}
	$1 == "function" {
		split($2, path, "/")
		if (!declared_well(path[1], path[2], $3))
			fault($2 ".c: " $3 " is declared in" (in_header[$3] ? in_header[$3] ".h" : " no header"))
		if (!says_subject(path[1], path[2], $3))
			fault($2 ".c: the name " $3 " does not say its subject")
	}
	END { exit faults > 0 }' "$work/tags" "$work/declared" "$work/functions"
