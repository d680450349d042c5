#!/bin/bash
# The ladder of the film of grains in examples/film: in.film by its three models, shortened: RESULT lines are ok, the solid fraction
# means the same, numbers of theory; trust makes its tables.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/film" "$top_srcdir/examples/flow" . || exit 99
cd film || exit 99
short='-var L 5 -var depth 5 -var relax 5 -var average 10'

# film MODEL NUMBER WORDS...: so many RESULT lines, all ok
film() {
	local model=$1 number=$2
	shift 2
	"$TSIM" -in in.film -log none -var model "$model" "$@" >out 2>&1 </dev/null && ! grep -q warning out &&
		[ "$(grep -c '^RESULT .* ok$' out)" = "$number" ] && ! grep -q '^RESULT .* off$' out
	report "$model $*" $? out
}

# numbers MODEL CONDITION: of OUT/film_MODEL.txt: words of both lines as $1 ... $14
numbers() {
	awk '!/^#/' "post/film_$1.txt" | tr '\n' ' ' | awk "function near(a, b, t) { return a - b < t && b - a < t } { exit !($2) }"
	report "$1: $2" $? "post/film_$1.txt"
}

film automaton 3 -var seeds 3 -var steps 2000 -var solids 0.325 -var L 50
numbers automaton '$1 == 0.325 && NF == 9 && $5 > $7 && $9 > 0.5'
"$TSIM" -explain -in in.film -log none -var solids 0.325 >out 2>&1
grep -q ' 500 granules' out
report 'a solid fraction of half that of closest packing is half of the cells' $? out

# tests/data/granular_couette.csv, nu 0.40, R 0.65
film kinetic 10 -var solids 0.4 -var H 5.0825921219822
numbers kinetic 'NF == 14 && near($5, 0.18416, 2e-5) && near($7, $5, 1e-5) && near($10, 0.036510, 1e-6) && near($12, 0.011519, 1e-6) && near($14, $12/$10, 1e-4)'

# so short that layers of grains may be denser than the middle
# shellcheck disable=SC2086
"$TSIM" -in in.film -log none -var model dem -var solids 0.3 -var H 5 $short >out 2>&1 </dev/null && ! grep -q warning out &&
	[ "$(grep -c '^RESULT ' out)" = 8 ] && [ "$(grep '^RESULT ' out | grep -v inside | grep -c ' ok$')" = 6 ]
report 'grains' $? out
numbers dem '$1 == 0.3 && NF == 14 && $5 > 0.05 && $5 < 0.3 && near($14, $12/$10, 1e-4)'

for model in automaton kinetic dem; do
	"$TSIM" -check -in in.film -log none -var model $model >out 2>&1 && ! grep -q 'warning' out
	report "-check $model" $? out
done
"$TSIM" -explain -in in.film -log none -var model kinetic >out 2>&1 && [ "$(grep -c 'left out by kinetic theory' out)" = 1 ]
report '-explain kinetic' $? out

# a table of one film; the grains are nearer to the theory than to the automaton
grains=$short TSIM=$TSIM ./trust map '0.3 0.85 0.65 5' >out 2>&1
[ "$(grep -c '^| 0.3 ' out)" = 1 ] &&
	awk '!/^#/ { n++; if (NF != 16 || ($7 - $5)^2 > ($8 - $5)^2 || $12 / $10 < 0.4 || $12 / $10 > 2) bad = 1 } END { exit bad || n != 1 }' map/trust.txt
report 'trust' $? out
finish
