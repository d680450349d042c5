#!/bin/bash
# The examples that draw: grains in a cylinder with a cut, force chains and arrows; a chute, a scar and a sphere in oil by
# their option `picture`, with few steps.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/pictures" "$top_srcdir/examples/wear" "$top_srcdir/examples/flow" . || exit 99

cd pictures || exit 99
results 'grains in a cylinder' in.silo 1 -var n 300
ls post/falling.png post/cut.png post/chains.png >out 2>&1
report 'three pictures' $? out
cd ../wear || exit 99
results 'a chute' in.chute 1 -var picture chute.png
cd ../flow/settling_sphere || exit 99
"$TSIM" -in in.settling_sphere -log none -var cells 4 -var longest 0.02 -var within 100 -var picture sphere.png >out 2>&1
report 'a sphere' $? out
cd ../cavity || exit 99
"$TSIM" -in in.cavity -log none -var N 16 -var longest 1 -var within 100 -var picture cavity.png >out 2>&1
report 'a cavity' $? out
for file in ../../wear/chute.png ../settling_sphere/sphere.png cavity.png; do
	[ "$(head -c 4 $file | tail -c 3)" = PNG ]
	report "$file" $?
done

finish
