#!/bin/bash
# Contacts that end and begin again, before the next rebuild of neighbours or after, and a run in two: with -legacy the
# numbers of LIGGGHTS 3.8, without it other ones.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck

compare() { # [-legacy]
	"$TSIM" "${script[@]}" -var program tsim -log none -screen none "$@" 2>err
	report "$what: tsim $*" $? err
	/usr/bin/python3 "$decks/compare.py" liggghts.dump tsim.dump 8000 1e-12 >deviation 2>&1
}

for skin in 0.2 0.003; do
	for model in 'model hooke tangential history' \
		'model hertz tangential history rolling_friction epsd2' \
		'model hooke/hysteresis tangential history rolling_friction epsd'; do
		what="$model, skin $skin"
		script=(-in "$decks/in.legacy" -var decks "$decks" -var steps 7487 -var skin $skin -var model "$model")
		liggghts "${script[@]}" -var program liggghts -log none -screen none >err 2>&1
		report "$what: LIGGGHTS" $? err
		compare -legacy
		report "$what" $? deviation
		echo "$what: $(cat deviation)"
		if [ $skin = 0.2 ]; then
			compare
			shows deviates deviation
			report "$what: differs without it" $? deviation
		fi
		rm -f ./*.dump
	done
done
finish
