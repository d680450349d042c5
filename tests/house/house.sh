#!/bin/sh
# Rules of the house that a search can check.
cd "$top_srcdir" || exit 1
status=0

# Reports lines that match, in files read from standard input.
forbid() {
	found=$(xargs grep -nE "$1" /dev/null)
	if [ -n "$found" ]; then
		echo "$2:"
		echo "$found"
		status=1
	fi
}

styles() {
	grep -l '^TS_STYLE(' src/*/*.c | grep -v '^src/script/'
}

sources() {
	find src tests -name '*.[ch]'
}

forbid '\<(strcmp|atoi|atof|strtod|strtol)\(' 'styles declare arguments, they do not read them' <<LIST
$(styles)
LIST
forbid '\<(exit|abort)\(' 'only main.c ends the program' <<LIST
$(find src -name '*.[ch]' ! -path src/main.c)
LIST
forbid '\<(TODO|FIXME|XXX)\>' 'unfinished work' <<LIST
$(sources)
LIST
forbid '\<(malloc|calloc|realloc|free)\(' 'memory comes from base/alloc.h' <<LIST
$(find src -name '*.[ch]' ! -path 'src/base/alloc.*')
LIST

forbid '\<report .*\$\([^(].*" \$\?' '$? is the status of the substitution before it: the case cannot fail' <<LIST
$(find tests examples -name '*.sh')
LIST

blind=$(find tests examples -name '*.sh' -exec grep -nE "awk '[^']*\<exit !\(" {} + | grep -vE '\<(BEGIN|END)\>')
[ -z "$blind" ] || { printf 'awk judges no line, and says yes, if there is none (END { exit !ok }):\n%s\n' "$blind" && status=1; }

# A moving region is where it was when it was last asked, so who asks brings it up to date.
for file in $(grep -lE '\<ts_(region_contains|region_bounds|chosen)\(' src/*/*.c); do
	case $file in src/region/region.c | src/insert/sites.c | src/*/region_*) continue ;; esac
	if ! grep -q 'ts_region_update(' "$file"; then
		echo "$file: asks a region about points without ts_region_update"
		status=1
	fi
done

# The top level holds what its readers look for there, and nothing that a trial left.
top='\.ci|\.clang-format|\.dockerignore|\.editorconfig|\.gitignore|CITATION\.cff|CONTRIBUTING\.md|Dockerfile'
top="$top|LICENSE|Makefile\\.am|NEWS|README|README\\.md|bench|bootstrap|configure\\.ac|debian|doc|editors"
top="$top|examples|potentials|pyproject\\.toml|python|setup|setup\\.py|src|tests"
strays=$(git ls-files 2>/dev/null | sed 's|/.*||' | sort -u | grep -vxE "$top")
if [ -n "$strays" ]; then
	echo "files at the top level that do not belong there: $strays"
	status=1
fi

# A step is defined once: what -explain prices is what runs.
steps=$(grep -lE 'clock\.step\+\+' $(find src -name '*.c'))
if [ "$steps" != src/core/plan_steps.c ]; then
	echo "a step of the simulation is defined in: $steps; only src/core/plan_steps.c should"
	status=1
fi

# shellcheck disable=SC2046
long=$(wc -l $(sources) | awk '$1 > 800 && $2 != "total" { print $2 ": " $1 " lines, at most 800" }')
if [ -n "$long" ]; then
	echo "$long"
	status=1
fi

# Functions begin and end with a brace in the first column.
long=$(awk '/^\{$/ { start = FNR } /^\}$/ && FNR - start > 60 {
		print FILENAME ":" start ": a function of " FNR - start + 1 " lines, at most 60" }' \
	$(sources | grep -v '^src/tsim\.h$'))
if [ -n "$long" ]; then
	echo "$long"
	status=1
fi

# Every header says what it is for; so does a source without a header, unless it is a style.
# shellcheck disable=SC2046
silent=$(awk 'FNR == 1 && !/^\/\*/ { print FILENAME } { nextfile }' \
	$(find src tests -name '*.[ch]'))
for file in $silent; do
	case $file in
	*.c) [ -f "${file%c}h" ] && continue ;;
	esac
	grep -q '^TS_STYLE(' "$file" && continue
	echo "$file: begins without a comment that says what it is for"
	status=1
done

# shellcheck disable=SC2046
found=$(awk 'function told() { if (FNR_of && last != "\"base/banned.h\"")
		print file ": the last include is " last ", not \"base/banned.h\"" }
	FNR == 1 { told(); file = FILENAME; last = ""; FNR_of = 1 }
	/^#include / { last = substr($0, 10) }
	END { told() }' $(find src -name '*.c'))
if [ -n "$found" ]; then
	echo "$found"
	status=1
fi
# A tag names one thing in all of src/.
found=$(grep -rhoE --include='*.[ch]' '^(struct|enum|union) ts_[a-z0-9_]+ \{' src | sort | uniq -d)
if [ -n "$found" ]; then
	echo "defined twice: $found"
	status=1
fi

# So does the name of a file; internal.h, for the files of its folder alone, may be in any.
found=$(find src -name '*.[ch]' ! -name internal.h | sed 's|.*/||' | sort | uniq -d)
if [ -n "$found" ]; then
	echo "in two folders: $found"
	status=1
fi
exit $status
