#!/bin/bash
# Links of the pages lead to files and headings that exist, each page is in the contents of the book, and what the pages say
# about `tsim -help` is so.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cd "$top_srcdir" || exit 99

# links FILE: the targets of its links and pictures, outside of code
links() {
	awk '/^ *```/ { block = !block; next } !block && !/^    /' "$1" | sed 's/``[^`]*``//g; s/`[^`]*`//g' |
		grep -oE '\]\([^) ]+\)|(href|src)="[^"]+"' | sed -E 's/^\]\(//; s/\)$//; s/^(href|src)="//; s/"$//'
}
# headings FILE: what follows # in a link to them
headings() {
	awk '/^```/ { block = !block } !block && /^#+ /' "$1" | sed 's/^#* //' | tr 'A-Z ' 'a-z-' | tr -d '`().,:;/^*+!?'"'"
}
for page in README.md CONTRIBUTING.md doc/*.md doc/styles/*.md; do
	links "$page" | while read -r link; do
		case $link in
		http*) continue ;;
		esac
		file=${link%%#*}
		path=$page
		[ -n "$file" ] && path=$(dirname "$page")/$file
		[ -e "$path" ] || { echo "$page: no file $link"; continue; }
		[ "$link" = "$file" ] || headings "$path" | grep -qxF -- "${link#*#}" || echo "$page: no heading $link"
	done
	# pages that are named without a link
	grep -oE '\bdoc/[a-z0-9-]+\.md' "$page" | sort -u | while read -r name; do
		[ -e "$name" ] || echo "$page: no file $name"
	done
done >"$work/dead"
[ ! -s "$work/dead" ]
report 'all links' $? "$work/dead"

for page in doc/*.md; do
	[ "$page" = doc/index.md ] || grep -qF "](${page#doc/})" doc/index.md
	report "$page is in doc/index.md" $?
done

# styles that the new pages name exist
for page in first-hour how-to theory cannot for-liggghts-users for-lammps-users glossary; do
	tr '\n' ' ' <doc/$page.md | grep -oE '\b(fix|pair|bond|compute|dump|flow|pressure) [a-z0-9]+(/[a-z_0-9]+)+' | sort -u |
		while read -r kind name; do
			"$TSIM" -help $kind "$name" >/dev/null 2>&1 || echo "$page: $kind $name"
		done
done >"$work/unknown"
[ ! -s "$work/unknown" ]
report 'all styles that pages name' $? "$work/unknown"
grep -hoE '^    tsim -help [^#]*' doc/*.md | sort -u | while read -r _ _ words; do
	# shellcheck disable=SC2086
	case $words in
	*[A-Z]*) ;;
	*) "$TSIM" -help $words >/dev/null 2>&1 || echo "tsim -help $words" ;;
	esac
done >"$work/silent"
[ ! -s "$work/silent" ]
report 'all searches that pages name' $? "$work/silent"
finish
