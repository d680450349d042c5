#!/bin/bash
# The example of erosive wear with a tenth of its dust, and its sweep of angles: all RESULT lines are ok.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/erosion" "$top_srcdir/examples/wear" "$top_srcdir/examples/flow" . || exit 99
cd erosion || exit 99

results 'a jet on three materials at two angles' in.erosion 5 -var dust 2e-7
[ "$(grep -c '^[a-z]* [39]0 4237 ' out)" = 6 ]
report 'the same impacts on all of them' $? out
results 'one material alone' in.erosion 3 -var dust 2e-7 -var material acrylic
"$TSIM" -in in.erosion -var cells 1 -log none >out 2>&1
[ $? = 1 ] && shows 'The moments of a scar need two cells along each side' out
report 'one cell' $? out
"$TSIM" -in in.erosion -var material brass -log none >out 2>&1
[ $? = 1 ] && shows 'The material brass needs -var Hv' out
report 'a material without properties' $? out
head -n 12 post/steel.30.*.txt | grep -q '^ITEM: NUMBER OF ENTRIES' && grep -q '^f_wear\[8\] 1 14400 double' post/steel.30.*.vtk
report 'maps of the wear' $?
results 'angles, speeds and sizes by five laws' in.angles 8
[ "$(wc -l <post/angles.txt)" = 87 ]
report 'all angles' $? post/angles.txt
results 'grains of another size' in.angles 8 -var d 30e-6
results 'a scar that deepens' in.evolving 4 -var impacts 10000 -var grains 144
[ "$(grep -c '^[1-4] ' out)" = 4 ] && [ "$(awk '/ENTRIES$/ { getline; print }' post/evolving.4.txt)" = 16000 ]
report 'its profiles' $? out
./plot >plots 2>&1 && [ -s post/profile.png ] && [ -s post/evolving.png ]
report 'figures' $? plots
cd ../wear || exit 99
results 'a layer that slides down a chute' in.chute 1
ls post/slid.20000.vtk post/chute.20000.vtk >out 2>&1
report 'maps of the chute' $? out

finish
