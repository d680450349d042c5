#!/bin/bash
# seeds.sh TARGET...: makes folders seeds.TARGET here, from decks, examples, manual pages and data files.
decks=("$top_srcdir"/tests/{decks,data}/in.* "$top_srcdir"/examples/*/in.*)
for target in "$@"; do
	case $target in
	script | check | explain) files=("${decks[@]}" "$top_srcdir"/doc/styles/*.md) ;;
	expression) files=("${decks[@]}") ;;
	restart)
		printf 'include %s\nwrite_restart newest.seed\n' "$top_srcdir/tests/data/in.older" |
			"$TSIM" -log none -screen none -var last 437
		files=("$top_srcdir"/tests/data/*.restart newest.seed)
		;;
	data)
		printf 'read_restart %s\nwrite_data data.seed\n' "$top_srcdir/tests/data/version1.restart" |
			"$TSIM" -log none -screen none
		files=(data.seed "$top_srcdir"/tests/data/data.*)
		;;
	mesh) files=() ;; # those of the corpus are enough
	esac
	python3 "$top_srcdir/tests/fuzz/make_seeds.py" "$target" "seeds.$target" "${files[@]}"
done
