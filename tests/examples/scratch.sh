#!/bin/bash
# Rock that is cut: a small scratch test, and the drilling example on a block of such rock; what is no cut is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir"/examples/rock "$top_srcdir"/examples/drilling .
cd rock || exit 99
small="-var width 8 -var length 7 -var across 4 -var cut_depth 1.5 -var cut_length 2 -log none"

# number WORD FILE: the number after WORD and = in the lines of the results
number() {
	sed -nE "s/^ .*$1 += (-?[0-9.]+).*/\1/p" "$2"
}
"$TSIM" -in in.scratch $small -var locked 4e6 -var speed 20 >made 2>&1
report 'a scratch' $? made
mkdir again && cp post/*.restart again
"$TSIM" -in in.scratch $small -var locked 4e6 -var speed 20 -var out again -threads 2 >second 2>&1
same 'the same on two threads, of a specimen made before' post/scratch.txt again/scratch.txt
[ "$(grep -c '^RESULT' made)" = 2 ] && grep -q '^RESULT swept_but_left .* ok$' made
report 'the cutter takes out what it sweeps' $? made
[ "$(grep -vc '^#' post/scratch.broken.txt)" = "$(number 'broken bonds' made)" ]
report 'each broken bond is listed' $? made
# columns of scratch.dump: id type x y z radius fragment size; those of one grain that were not loose before
awk -v alone="$(number 'of 10 and more' made)" -v largest="$(number 'largest chip' made)" '
	FNR > 9 { n[$7]++; size[$7] = $8; all++ }
	END { for (f in n) { if (n[f] != size[f]) off++; if (n[f] < 0.5 * all && n[f] > most) most = n[f] }
	      exit !(!off && most == largest && alone > 5) }' post/scratch.dump
report 'fragments have the sizes that are listed, the largest chip is the one reported' $? made

# bonds that soften by tension and shear: the same cut needs more energy
"$TSIM" -in in.scratch $small -var locked 4e6 -var speed 20 -var out again -var soften 0.1 -var soften_by both >tough 2>&1
report 'a scratch of tough rock' $? tough
awk '$1 == "SCRATCH" { e[FILENAME] = $5 } END { exit !(e["tough"] > 1.5 * e["made"]) }' made tough
report 'it needs more energy' $? tough
# 175e6^2 (1 + 1/0.1) 1.5e-3/(2 62e9)
[ "$(number 'energy of bonds    G.d' tough | cut -c1-4)" = 2.71 ]
report 'the energy of its bonds' $? tough

# four times the stiffness and strength, twice the speed: all stresses are four times as large. Seen where the force
# first rises: later the rounding of broken bonds has grown.
"$TSIM" -in in.scratch $small -var Ec 248e9 -var Ebond 248e9 -var strength 700e6 -var locked 16e6 -var speed 40 \
	-var out four >four.txt 2>&1
awk '/^#/ { next } FNR == NR { if (!row && $3 > 5) { row = FNR; force = $3 } next }
	FNR == row { good = $3 > 3.99 * force && $3 < 4.01 * force }
	END { exit !good }' post/scratch.txt four/scratch.txt
report 'forces are proportional to stiffness and strength at the same ratio of the speed to that of sound' $? four.txt

# refused WHAT TEXT WORDS...: a scratch that is refused with this text
refused() {
	local what=$1 text=$2
	shift 2
	"$TSIM" -in in.scratch $small "$@" >out 2>&1 </dev/null
	[ $? = 1 ] && shows "$text" out
	report "$what" $? out
}
small="-log none"
refused 'no depth' 'must be positive' -var cut_depth 0
refused 'a depth beyond the block' 'at most a third of the height' -var cut_depth 20
refused 'a path beyond the block' 'stops before its held end' -var cut_length 30
refused 'a cutter wider than the block' 'within the block' -var across 30
refused 'a cutter that does not move' 'positive speed' -var speed 0
refused 'a cutter whose heel would rub' 'back rake angle from' -var rake 40
for script in in.scratch in.block; do
	"$TSIM" -check -in $script >out 2>&1
	report "-check accepts $script" $? out
done

# ---- drilling of such a block
"$TSIM" -in in.block -log none -var locked 4e6 -var width 8 -var length 7 >block 2>&1
report 'a block of rock with its law' $? block
cd ../drilling || exit 99
granite="-log none -var rock ../rock/post/block.restart -var vtk no"
"$TSIM" -in in.drilling $granite -var WOB 1000 -var rpm 200000 -var turns 1 -var land 0.3 >one 2>&1
report 'it is drilled in newtons and revolutions per minute' $? one
# one turn is short: the bit has landed, and it bounces
[ "$(number 'mean force on the bit' one | cut -d. -f1)" -gt 100 ] && grep -q '^RESULT bonds.* ok$' one
report 'the rock carries the bit, each bond is accounted for' $? one
# Teale: the energy is that of the weight and of the torque over the volume of the hole, here of 4.5 mm radius
awk '/^MSE/ { A = 3.14159265 * 4.5 ^ 2
	e = $3 / A + 2 * 3.14159265 * $7 * 1e3 / (A * $5); ok = (e > 0.999 * $9 && e < 1.001 * $9); exit } END { exit !ok }' one
report 'specific energy of weight, torque and depth per turn' $? one
cp post/bit.txt first
"$TSIM" -check -in in.drilling $granite >out 2>&1
report '-check accepts it' $? out
"$TSIM" -in in.drilling $granite -var WOB 1000 -var rpm 200000 -var turns 1 -var land 0.3 -threads 2 >two 2>&1
same 'the same on two threads' first post/bit.txt

"$TSIM" -in in.drilling $granite -var WOB 0 >out 2>&1
[ $? = 1 ] && shows 'weight on bit and a speed above 0' out
report 'no weight' $? out
"$TSIM" -in in.drilling $granite -var bit 4 -var cutter 6 >out 2>&1
[ $? = 1 ] && shows 'stay within the rock' out
report 'a bit wider than the rock' $? out
"$TSIM" -in in.drilling -log none -var rock nowhere.restart >out 2>&1
[ $? = 1 ] && shows 'nowhere.restart' out
report 'no such rock' $? out
loose=$(ls ../rock/post/block.1*.restart | head -n 1)
"$TSIM" -in in.drilling -log none -var rock "$loose" >out 2>&1
[ $? = 1 ] && shows 'no bonds' out
report 'grains without bonds' $? out
cp "$loose" loose.restart
cp ../rock/post/block.restart.law loose.restart.law
"$TSIM" -in in.drilling -log none -var rock loose.restart >out 2>&1
[ $? = 1 ] && shows 'no bonds' out
report 'grains without bonds, with a law' $? out
"$TSIM" -in in.drilling -log none -var law glue >out 2>&1
[ $? = 1 ] && shows 'contact or parallel' out
report 'a law that does not exist' $? out
finish
