#!/bin/bash
# The example of erosive wear with a tenth of its dust, and its sweep of angles: all RESULT lines are ok.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/erosion" "$top_srcdir/examples/wear" "$top_srcdir/examples/flow" . || exit 99
cd erosion || exit 99

# results WHAT SCRIPT NUMBER WORDS...: so many RESULT lines, all ok
results() {
	local what=$1 script=$2 number=$3
	shift 3
	"$TSIM" -in "$script" -log none "$@" >out 2>&1 </dev/null &&
		[ "$(grep -c '^RESULT .* ok$' out)" = "$number" ] && ! grep -q '^RESULT .* off$' out
	report "$what" $? out
}

results 'a jet on three materials at two angles' in.erosion 5 -var dust 2e-7
[ "$(grep -c '^[a-z]* [39]0 4237 ' out)" = 6 ]
report 'the same impacts on all of them' $? out
head -n 12 post/steel.30.*.txt | grep -q '^ITEM: NUMBER OF ENTRIES' && grep -q '^f_wear\[8\] 1 14400 double' post/steel.30.*.vtk
report 'maps of the wear' $?
results 'angles, speeds and sizes by five laws' in.angles 8
[ "$(wc -l <post/angles.txt)" = 87 ]
report 'all angles' $? post/angles.txt

# the ladder of models; without scatter of speeds and directions the grains give the closed form itself
results 'closed form and grains at 90 degrees' in.ladder 2 -var model closed jet -var dust 5e-8
results 'closed form and grains at 30 degrees' in.ladder 2 -var model closed jet -var dust 5e-8 -var angle 30
results 'one speed and direction: the closed form to 3e-8' in.ladder 2 -var model jet -var dust 5e-9 -var angle 45 -var cone 1e-6 -var spread 1e-7
awk '/^RESULT closed/ { exit !($5 < 1e-7) }' out
report 'without scatter the tolerance is small' $? out
results 'the models with air' in.ladder 3 -var model jet air coupled -var dust 5e-9 -var fine 3 -var every 4 -var settle 2e-4
awk '$1 ~ /^(jet|air|coupled)$/ && $2 ~ /^[0-9]/ { e[$1] = $2 } END { exit !(e["air"] < 0.99 * e["jet"] && e["coupled"] < 0.99 * e["jet"]) }' out
report 'air takes something off the volume' $? out
results 'thin air' in.ladder 3 -var model jet air coupled -var dust 5e-9 -var density 1e-9 -var viscosity 1e-14 -var fine 3 -var every 4 -var settle 1e-4
awk '$1 ~ /^(jet|air|coupled)$/ && $2 ~ /^[0-9]/ { n++; e[$2] = 1 } END { for (k in e) m++; exit !(n == 3 && m == 1) }' out
report 'thin air changes nothing' $? out
"$TSIM" -in in.ladder -log none -var angle 30 -var model air >out 2>&1 </dev/null
[ $? = 1 ] && shows 'the models with air are those of a jet at 90 degrees' out
report 'air at another angle is refused' $? out
# what -explain says is left out
explained() { # WHAT MODEL PATTERN
	"$TSIM" -explain -in in.ladder -log none -var model "$2" >out 2>&1 </dev/null
	sed -n '/^omitted/,/^memory/p' out | grep -q "$3"
	report "$1" $? out
}
explained 'no search for pairs' jet '^  contact list .*no pair_style'
explained 'no air' jet '^  air .*no flow_style'
explained 'no fluid solver' air '^  fluid solver .*the velocity is imposed, particles do not act on it'
cd ../wear || exit 99
results 'a layer that slides down a chute' in.chute 1
ls post/slid.20000.vtk post/chute.20000.vtk >out 2>&1
report 'maps of the chute' $? out

finish
