#!/bin/bash
# info says what there is; units that are not for grains are refused.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.info <<'END'
info system
units micro
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 random 20 86028157 NULL
fix fall all gravity 9.81 vector 0 0 -1
compute hot all ke
group few id 1:3
group dy dynamic few
info all
info styles
END
"$TSIM" -in in.info -log none >out 2>&1
report 'info' $? out
for line in '  no simulation box' '  units micro, 3 dimensions, step 0, time 0, time step 2' \
	'  box (0 0 0) to (1 1 1), faces pp pp pp' '  20 particles of 2 types, 0 bonds of 0 types, 0 lost' \
	'  few, static, 3 particles' '  dy, dynamic, 3 particles' '  box, block, in.info:3' \
	'  hot, ke, group all, in.info:7' '  fall, gravity, group all, in.info:6' '*  region: block'; do
	says_line "$line" out
	report "says: $line" $? out
done
prints 'variable b index x y z
variable l loop 3
variable k equal 2*l
next l
next b
info variables time configuration styles region accelerator fft' '  b, index, x y z, now y, in.script:1' \
	'  l, loop, 3, now 2, in.script:2' '  k, equal, 2*l, in.script:3' '*  region: block cone'
prints 'print begun file state.txt
info groups out append state.txt fft
info groups out screen' '  all, static, 0 particles'
printf 'begun\nGroups:\n  all, static, 0 particles\nFourier transforms: none\n' >want
same 'info in a file' state.txt want
rejects 'info groups out' 'expected out log, out screen, out append FILE or out overwrite FILE'
echo 'info sistem' >in.bad
refused 'misspelt' "unknown subject 'sistem'; did you mean 'system'?" -in in.bad
for units in real metal electron nano; do
	echo "units $units" >in.bad
	refused "$units" "units $units are for atoms" -in in.bad
done
finish
