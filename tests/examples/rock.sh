#!/bin/bash
# Laboratory tests of small specimens of bonded grains: they fail, their numbers are of the right size, and are the same
# from a specimen that was made before; what cannot be tested is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp "$top_srcdir"/examples/rock/* .
small="-var width 5 -var length 10 -log none"

# number NAME LO HI [FILE]: the RESULT is between
number() {
	awk -v name="$1" -v lo="$2" -v hi="$3" '$1 == "RESULT" && $2 == name { ok = $3 > lo && $3 < hi }
		END { exit !ok }' "${4-out}"
	report "$1 is between $2 and $3" $? "${4-out}"
}

# broken TEST: each broken bond is listed, and counted by mode
broken() {
	local all shear
	all=$(grep -vc '^#' "post/$1.broken.txt")
	shear=$(grep -c ' shear ' "post/$1.broken.txt")
	[ "$all" -gt 0 ] && grep -q " broken bonds  *= $all, $shear of them by shear" out
	report "$1: each broken bond is listed" $? out
}

# ---- uniaxial compression ----
"$TSIM" -in in.ucs $small -var steps 1200 >out 2>&1
report 'in.ucs ends well' $? out
number E_GPa 40 60
number nu 0.2 0.33
number q_u_MPa 160 260
broken ucs
cp post/ucs.txt first.txt
"$TSIM" -in in.ucs $small -var steps 1200 >read 2>&1 && grep -q '^Reading restart' read && ! grep -q '^Specimen' read
report 'the specimen is read again' $? read
same 'with the same curve' first.txt post/ucs.txt
# all is linear: four times the stiffness and strength, four times the stress at the same strain
"$TSIM" -in in.ucs $small -var steps 1200 -var Ec 248e9 -var Ebond 248e9 -var strength 700e6 -var locked 4e6 >four 2>&1
q=$(awk '$2 == "q_u_MPa" { print $3 }' out)
number q_u_MPa "$(awk "BEGIN { print 3.96*$q }")" "$(awk "BEGIN { print 4.04*$q }")" four
# tougher cement, the same elastic rock; loads hardly less than those of brittle bonds
"$TSIM" -in in.ucs $small -var steps 1200 -var soften 0.3 >soft 2>&1
report 'in.ucs ends well with bonds that soften' $? soft
number E_GPa 40 60 soft
number q_u_MPa "$(awk "BEGIN { print 0.98*$q }")" 400 soft
"$TSIM" -in in.ucs $small -var steps 1200 -var soften 0.1 -var soften_by both >soft 2>&1
number q_u_MPa "$(awk "BEGIN { print 1.2*$q }")" 500 soft
"$TSIM" -in in.ucs $small -var steps 1200 -var friction_angle 30 -var shear_ratio 0.7 >rubs 2>&1
"$TSIM" -in in.ucs $small -var steps 1200 -var shear_ratio 0.7 >slides 2>&1
report 'in.ucs ends well with bonds of small shear strength' $? slides
number q_u_MPa "$(awk '$2 == "q_u_MPa" { print 1.02 * $3 }' slides)" 400 rubs
"$TSIM" -in in.ucs -var shape cylinder -var width 6 -var length 10 -var steps 1200 -log none >out 2>&1
report 'a cylinder' $? out
number E_GPa 40 65
number q_u_MPa 160 280

# ---- other tests ----
"$TSIM" -in in.tension $small -var steps 1800 >out 2>&1
report 'in.tension ends well' $? out
number sigma_t_MPa 25 70
broken tension
"$TSIM" -in in.triaxial $small -var steps 1200 >out 2>&1
report 'in.triaxial ends well' $? out
number N_phi 1.5 6
broken triaxial.10e6
"$TSIM" -in in.brazilian -var width 10 -var depth 5 -var steps 1800 -log none >out 2>&1
report 'in.brazilian ends well' $? out
number sigma_B_MPa 20 60
broken brazilian
"$TSIM" -in in.triaxial -var shape cylinder -var width 6 -var length 10 -var confine 2e7 -var steps 1200 -log none \
	>out 2>&1
report 'in.triaxial ends well with a cylinder' $? out
awk '/sigma_1 / { ok = $4 > 200 && $4 < 400 } END { exit !ok }' out
report 'a cylinder is stronger under pressure' $? out
"$TSIM" -in in.bending -var length 6 -var notch 0.3 -var steps 2400 -var settle 1200 -log none >out 2>&1
report 'in.bending ends well' $? out
number K_IC 3 15
broken bending
"$TSIM" -in in.triaxial $small -var steps 200 -var strain 1e-6 -var confine 1e6 >out 2>&1
grep -q ' broken bonds  *= 0, 0 of them' out && grep -q 'has not failed yet' out
report 'a specimen under confining pressure alone is whole' $? out

# ---- figures ----
./plot >plots 2>&1
[ "$(grep -c '^post/.*\.png$' plots)" = "$(find post -name '*.shape.txt' | wc -l)" ] && [ -s post/ucs.png ]
report 'a figure of each test' $? plots
./plot nowhere >plots 2>&1
[ $? = 1 ] && shows 'no results in nowhere' plots
report 'figures of nothing' $? plots

# ---- what is refused ----
# refused WORDS SCRIPT OPTIONS...
refused() {
	local words=$1
	"$TSIM" -log none -in "${@:2}" >out 2>&1 </dev/null
	[ $? = 1 ] && shows "$words" out
	report "refused: ${*:2}" $? out
}
refused 'at least 5' in.ucs -var width 4
refused 'not a disc' in.ucs -var shape disc -var width 5 -var length 5
refused 'block, cylinder or disc' in.ucs -var shape ball
refused 'no other depth' in.ucs -var shape cylinder -var depth 7
refused 'no other length' in.brazilian -var width 10 -var length 12
refused 'not a block' in.brazilian -var shape block
refused 'is negative' in.triaxial -var confine -1e6
refused 'Jaws of 0 degrees' in.brazilian -var arc 0
refused 'less than 1' in.bending -var notch 1.2
refused '3 grains above the notch' in.bending -var length 6
refused 'span of four times' in.bending -var width 30
refused 'cannot be reached' in.ucs -var width 5 -var length 10 -var strain -1e-3
refused 'are equal' in.triaxial $small -var steps 200 -var strain 1e-6 -var squeeze 200 -var confine 1e6 1e6
finish
