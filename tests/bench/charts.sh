#!/bin/bash
# The framework of the charts (bench/charts): a small one from end to end, and the Pareto front of known points.
top=$(cd "$top_srcdir" && pwd)
. "$top/tests/lib_cases.sh"
charts=$top/bench/charts

# front WHAT POINTS WANTED: points `problem method error seconds`, the methods that should be on the front
front() {
	printf '%s\n' "$2" | awk '{ printf "known,%s,%s,1,%s,%s,0\n", $1, $2, $3, $4 }' |
		awk -f "$charts/front.awk" >out
	[ "$(awk -F, '$8 == 1 { printf "%s ", $3 }' out)" = "$3 " ]
	report "$1" $? out
}
front 'dominated points are not on it' 'p a 1e-1 0.1
p b 1e-2 0.23
p c 2e-2 0.3
p d 1e-2 0.25
p e 3e-4 2.385' 'a b e'
front 'equal points are both on it' 'p a 0.5 1
p b 0.5 1
p c 0.6 1' 'a b'
front 'problems have fronts of their own' 'p a 0.5 1
q b 0.7 2
q c 0.8 2' 'a b'
front 'an error of 0 counts, a failed run does not' 'p a nan nan
p b 0 3
p c 1e-5 2
p d 1e-6 4' 'b c'

mkdir defined
cat >defined/tiny.in <<'DECK'
units si
region box block 0 1 0 1 0 1
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 2385
fix fall all gravity 2 vector 0 0 -1
fix move all ${scheme}
timestep $(0.2/v_steps)
run ${steps}
if "${method} == exact" then "print 'ERROR $(abs(z[1]-0.46))'" else "print 'VALUE z $(z[1])'"
if "${scheme} == nve/noforce" then "run none"
DECK
cat >defined/tiny.sh <<'DEFINITION'
title='A stone that falls'
error='height (m)'
reference='exact'
setting='steps'
also='steps'
budget=5
pick='velocity Verlet.'
points() {
	local steps
	for steps in $(levels 10 20 -- 40); do
		problem exact
		point nve/euler $steps -var method exact -var scheme nve/euler -var steps $steps
		problem finest
		finest -var method finest -var scheme nve -var steps 10
		point nve/euler $steps -var method finest -var scheme nve/euler -var steps $steps
	done
	point nve/noforce 10 -var method finest -var scheme nve/noforce -var steps 10
}
DEFINITION
make_charts() {
	CHARTS_FROM=$work/defined OUT=$work/made REPEATS=1 bash "$charts/charts" "$@"
}
make_charts tiny >out 2>&1
report 'the chart is made' $? out
# explicit Euler lags by g t h/2
awk -F, '/^#/ || $1 == "chart" { next }
	{ n++ }
	$2 == "exact" && ($5 < 0.00999 * 0.4 / $4 * 10 || $5 > 0.01001 * 0.4 / $4 * 10) { bad = 1; print "off: " $0 }
	$2 == "finest" && $3 == "nve/euler" && ($5 < 0.0086 * 10 / $4 || $5 > 0.0088 * 10 / $4) { bad = 1; print "off: " $0 }
	$3 == "nve/noforce" && ($5 != "nan" || $8 != 0) { bad = 1; print "off: " $0 }
	END { exit bad || n != 5 }' made/tiny.csv >out 2>&1
report 'errors are those of the scheme' $? out
grep -q '^# took' made/tiny.csv && shows '| exact | 1e-2 | nve/euler |' made/charts.md && shows 'velocity Verlet' made/charts.md
report 'the page has the sentence and the cheapest points' $? made/charts.md
if has gnuplot gnuplot-nox; then
	[ -s made/tiny.svg ] && [ -s made/tiny.png ] && [ -s made/tiny-setting.svg ] && shows '</svg>' made/tiny.svg
	report 'the pictures are drawn' $?
fi
LONG=1 make_charts tiny >out 2>&1 && [ "$(grep -c '^tiny,' made/tiny.csv)" = 7 ]
report 'LONG=1 adds settings' $? out
make_charts nosuch >out 2>&1
[ $? = 1 ] && shows "there is no chart 'nosuch'" out
report 'an unknown name is an error' $? out
# all charts together: 15 minutes
sum=$(sed -n 's/^budget=//p' "$charts"/*.sh | awk '{ s += $1 } END { print s }')
[ "$sum" -gt 0 ] && [ "$sum" -le 900 ]
report "the budgets sum to $sum s, at most 900" $?
finish
