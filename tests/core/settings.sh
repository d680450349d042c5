#!/bin/sh
# The log tells what was left to its default; at the end the script is told of names it does not use.
. "$top_srcdir/tests/lib_cases.sh"

cat >in.a <<'END'
units si
region b block 0 1 0 1 0 1 units box
region spare block 0 1 0 1 0 1 units box	# region spare
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.1 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 238.5 restitution 0.3
group alone type 1
group used type 1
compute k used ke
compute q all ke
variable x equal c_k*2.385
variable y equal 5
variable in_branch equal 7
variable name string k
variable z index 1 2
fix move all nve
fix down all viscous 0.1
timestep 1e-4
run 2
run 2
timestep 2e-4
run 2
print "$(v_x)"
if "$(step) < 0" then "print ${in_branch}"
next z
jump SELF rest
label rest
variable late equal c_${name}
print "${late}"
END
"$TSIM" -in in.a -log log.a >out 2>err
report 'runs' $? err
unused() {
	grep -qxF "$1" out
	report "$1" $? out
}
unused "in.a:3: warning: region 'spare' is never used"
unused "in.a:9: warning: group 'alone' is never used"
unused "in.a:12: warning: compute 'q' is never used"
unused "in.a:14: warning: variable 'y' is never used"
[ "$(grep -c 'never used' out)" = 4 ]
report 'no other name' $? out
grep -qx '# region block: xlo 0 xhi 1 ylo 0 yhi 1 zlo 0 zhi 1 units box; by default: side in volume_limit 0' log.a
report 'defaults of a region' $? log.a
[ "$(grep -c '^# settings:' log.a)" = 2 ]
report 'settings only where they have changed' $? log.a
grep -q '^# settings: units si dimension 3 (default) timestep 0.0001 ' log.a
report 'settings of the simulation' $? log.a
grep -qx '# run: N 2; by default: pre yes post yes unsafe no' log.a
report 'defaults of a run' $? log.a
# What only other scripts that include the same one use is not warned of.
printf 'units si\nvariable spare equal 1\nvariable shared equal 2\n' >in.parts
printf 'variable ownn equal 3\ninclude in.parts\nprint "${shared}"\n' >in.whole
"$TSIM" -in in.whole -log none >out 2>&1
[ "$(grep -c 'never used' out)" = 1 ] && grep -q "in.whole:1: warning: variable 'ownn' is never used" out
report 'names of included scripts' $? out
# c2$k is a use of each name that begins with c2, and ${k}_late of each that ends so.
cat >in.composed <<'END'
units si
region b block 0 1 0 1 0 1
create_box 1 b
compute c21 all ke
compute c22 all ke
compute d21 all ke
variable 1_late equal 5
variable k loop 2
variable x equal c_c2$k
variable y equal v_${k}_late
print "$(v_x) $(v_y)"
END
"$TSIM" -in in.composed -log none >out 2>&1
[ "$(grep -c 'never used' out)" = 1 ] && grep -q "in.composed:6: warning: compute 'd21' is never used" out
report 'names that are composed by substitution' $? out
printf 'echo none\nunits si\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nrun 0\n' >in.b
"$TSIM" -in in.b -log log.b >out 2>err
! grep -q '^#' log.b
report 'silent with echo none' $? log.b

cp "$top_srcdir"/examples/drilling/in.* .
"$TSIM" -check -in in.drilling >out 2>err
! grep 'never used' out
report 'the example uses all its names' $? out
# `clear` returns to what the program was started with.
printf '%s\n' 'region b block 0 1 0 1 0 1' 'create_box 1 b' 'variable lengthened equal 1' 'thermo_style custom step v_lengthened' 'run 0' >in.rest
(echo 'legacy yes' && cat in.rest) >in.legacy
(printf 'legacy yes\nclear\n' && cat in.rest) >in.cleared
(printf 'legacy no\nclear\n' && cat in.rest) >in.asked
for script in rest legacy cleared; do "$TSIM" -in in.$script -log none | grep ' Step ' >head.$script; done
"$TSIM" -in in.asked -log none -legacy | grep ' Step ' >head.asked
! cmp -s head.rest head.legacy && cmp head.rest head.cleared && cmp head.legacy head.asked
report 'legacy after clear' $?
finish
