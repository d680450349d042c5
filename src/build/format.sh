#!/bin/sh
# Lays out C files: format.sh FILE... String literals that follow each other are joined first, except after a line
# break, so that clang-format fills the lines.
for file; do
	awk '
		NR > 1 && held ~ /"$/ && held !~ /\\n"$/ && held !~ /^#/ && /^[ \t]*"/ {
			sub(/^[ \t]*"/, "")
			held = substr(held, 1, length(held) - 1) $0
			next
		}
		NR > 1 { print held }
		{ held = $0 }
		END { print held }' "$file" >"$file.new" && mv "$file.new" "$file" || exit 1
done
clang-format -i "$@"
