#!/bin/bash
# Links of the pages lead to files and headings that exist, each page is in the contents of the book, and what the pages say
# about `tsim -help` is so.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cd "$top_srcdir" || exit 99

# Links and pictures of the pages, outside of code, "link PAGE TARGET"; their headings, as a link to them says, "heading PAGE NAME";
# pages that are named without a link, "named PAGE FILE".
awk -v quote="'" '
	function find(text, pattern, what, from,   rest) {
		for (rest = text; match(rest, pattern); rest = substr(rest, RSTART + RLENGTH))
			print what, FILENAME, substr(rest, RSTART + from, RLENGTH - from - (what == "link"))
	}
	FNR == 1 { block = 0 }
	{ find(" " $0, "[^A-Za-z0-9_]doc/[a-z0-9-]+[.]md", "named", 1) }
	/^ *```/ { block = !block; next }
	block { next }
	/^#+ / {
		name = tolower($0)
		sub(/^#+ */, "", name)
		gsub(/ /, "-", name)
		gsub("[`().,:;/^*+!?" quote "]", "", name)
		print "heading", FILENAME, name
	}
	!/^    / {
		gsub(/``[^`]*``/, "")
		gsub(/`[^`]*`/, "")
		find($0, "\\]\\([^) ]+\\)", "link", 2)
		find($0, "href=\"[^\"]+\"", "link", 6)
		find($0, "src=\"[^\"]+\"", "link", 5)
	}' README.md CONTRIBUTING.md doc/*.md doc/styles/*.md >"$work/found"
declare -A headings
while read -r what page name; do
	[ "$what" != heading ] || headings[$page#$name]=1
done <"$work/found"
while read -r what page link; do
	case $what:$link in
	link:http*) ;;
	link:*)
		file=${link%%#*}
		path=$page
		[ -z "$file" ] || path=$page/../$file
		while [[ $path =~ ^(.*/)?[^/]+/\.\./(.*)$ ]]; do path=${BASH_REMATCH[1]}${BASH_REMATCH[2]}; done
		[ -e "$path" ] || echo "$page: no file $link"
		[ "$link" = "$file" ] || [ ! -e "$path" ] || [ -n "${headings[$path#${link#*#}]}" ] || echo "$page: no heading $link"
		;;
	named:*) [ -e "$link" ] || echo "$page: no file $link" ;;
	esac
done <"$work/found" >"$work/dead"
[ "$(grep -c ^link "$work/found")" -gt 600 ] && [ ! -s "$work/dead" ]
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
