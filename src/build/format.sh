#!/bin/sh
# Lays out C files: format.sh FILE... String literals that follow each other are joined first, except after a line
# break, so that clang-format fills the lines; those that it leaves too long are broken here.
edit() {
	program=$1
	shift
	for file; do
		awk "$program" "$file" >"$file.new" && cat "$file.new" >"$file" && rm "$file.new" || exit 1
	done
}

# shellcheck disable=SC2016
join='
	NR > 1 && held ~ /"$/ && held !~ /\\n"$/ && held !~ /^#/ && /^[ \t]*"/ {
		sub(/^[ \t]*"/, "")
		held = substr(held, 1, length(held) - 1) $0
		next
	}
	NR > 1 { print held }
	{ held = $0 }
	END { print held }'
# shellcheck disable=SC2016
break='
	# column in which the text ends
	function width(s,    n, k) {
		for (k = 1; k <= length(s); k++) n = substr(s, k, 1) == "\t" ? n - n % 8 + 8 : n + 1
		return n + 0
	}
	function indent(n,    s) {
		for (s = ""; n >= 8; n -= 8) s = s "\t"
		while (n-- > 0) s = s " "
		return s
	}
	{
		while (width($0) > 110 && match($0, /^[^"]*"/)) {
			column = width(substr($0, 1, RLENGTH - 1))
			for (at = RLENGTH + 1; at < length($0) && width(substr($0, 1, at + 1)) <= 110; at++);
			while (at > RLENGTH && substr($0, at, 1) != " ") at--
			if (at <= RLENGTH || substr($0, at + 1) !~ /^([^"\\]|\\.)*"[^"]*$/) break
			print substr($0, 1, at) "\""
			$0 = indent(column) "\"" substr($0, at + 1)
		}
		print
	}'
edit "$join" "$@"
clang-format -i "$@"
edit "$break" "$@"
clang-format -i "$@"
