#!/bin/bash
# The ladder of models of a jet, and angular grains, with little dust: all RESULT lines are ok; limits in which models agree.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/erosion" "$top_srcdir/examples/flow" . || exit 99
cd erosion || exit 99

# without scatter of speeds and directions the grains give the closed form itself
results 'closed form and grains at 90 degrees' in.ladder 2 -var model closed jet -var dust 5e-8
results 'closed form and grains at 30 degrees' in.ladder 2 -var model closed jet -var dust 5e-8 -var angle 30
results 'one speed and direction: the closed form to 3e-8' in.ladder 2 -var model jet -var dust 5e-9 -var angle 45 -var cone 1e-6 -var spread 1e-7
awk '/^RESULT closed/ { ok = ($5 < 1e-7); exit } END { exit !ok }' out
report 'without scatter the tolerance is small' $? out
results 'the models with air' in.ladder 3 -var model jet air coupled -var dust 5e-9 -var fine 2 -var every 4 -var settle 2e-4
awk '$1 ~ /^(jet|air|coupled)$/ && $2 ~ /^[0-9]/ { e[$1] = $2 } END { exit !(e["air"] < 0.99 * e["jet"] && e["coupled"] < 0.99 * e["jet"]) }' out
report 'air takes something off the volume' $? out
results 'thin air' in.ladder 3 -var model jet air coupled -var dust 5e-9 -var density 1e-9 -var viscosity 1e-14 -var fine 2 -var every 4 -var settle 1e-4
awk '$1 ~ /^(jet|air|coupled)$/ && $2 ~ /^[0-9]/ { n++; e[$2] = 1 } END { for (k in e) m++; exit !(n == 3 && m == 1) }' out
report 'thin air changes nothing' $? out
results 'still air at 30 degrees' in.ladder 2 -var model jet air -var air rest -var angle 30 -var dust 5e-9
awk '$1 ~ /^(jet|air)$/ && $2 ~ /^[0-9]/ { e[$1] = $2 } END { exit !(e["air"] < 0.95 * e["jet"] && e["air"] > 0.8 * e["jet"]) }' out
report 'still air takes a tenth off the volume' $? out
"$TSIM" -in in.ladder -log none -var angle 30 -var model air >out 2>&1 </dev/null
[ $? = 1 ] && shows 'at other angles than 90 degrees the air is at rest' out
report 'the stagnation flow at another angle is refused' $? out
results 'clumps with corners: the factor at 30 degrees' in.shape 6 -var grains 20
[ "$(grep -c '^[39]0 ' post/shape.txt)" = 10 ]
report 'all corners' $? post/shape.txt
results 'one radius of the corners' in.shape 3 -var grains 20 -var corner 0.5
# what -explain says is left out
explained() { # WHAT MODEL PATTERN
	"$TSIM" -explain -in in.ladder -log none -var model "$2" >out 2>&1 </dev/null
	sed -n '/^omitted/,/^memory/p' out | grep -q "$3"
	report "$1" $? out
}
explained 'no search for pairs' jet '^  contact list .*no pair_style'
explained 'no air' jet '^  air .*no flow_style'
explained 'no fluid solver' air '^  fluid solver .*the velocity is imposed, particles do not act on it'

finish
