#!/bin/bash
# A small specimen of bonded grains under uniaxial compression: it fails, its numbers are of the right size, and
# are the same from a specimen that was made before.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp "$top_srcdir"/examples/rock/* .
small="-var width 5 -var length 10 -var steps 2000 -log none"

"$TSIM" -in in.ucs $small >made 2>&1
report 'the run ends well' $? made
cp post/ucs.txt first.txt
"$TSIM" -in in.ucs $small >read 2>&1 && grep -q '^Reading restart' read && ! grep -q '^Specimen' read
report 'the specimen is read again' $? read
same 'with the same curve' first.txt post/ucs.txt

# value WORD: the number after = in the line of the results
value() {
	sed -nE "s/^ .* $1 += ([0-9.]+).*/\1/p" made
}
awk -v E="$(value E)" -v nu="$(value nu)" -v q="$(value q_u)" \
	'BEGIN { exit !(E > 45 && E < 75 && nu > 0.2 && nu < 0.4 && q > 130 && q < 260) }'
report 'modulus, Poisson ratio and strength' $? made
[ "$(grep -vc '^#' post/ucs.broken.txt)" = "$(value 'broken bonds')" ]
report 'each broken bond is listed' $? made
# all are elastic in the same proportion: twice the stiffness and strength, twice the stress at the same strain
"$TSIM" -in in.ucs $small -var Ec 124e9 -var Ebond 124e9 -var strength 350e6 -var locked 1e7 >twice 2>&1
awk -v a="$(value q_u)" '/strength  / { exit !($4 > 1.98 * a && $4 < 2.02 * a) }' twice
report 'strength is proportional to stiffness and strength of the bonds' $? twice

"$TSIM" -in in.ucs -log none -var width 4 >out 2>&1 </dev/null
[ $? = 1 ] && shows 'at least 5' out
report 'too few grains across' $? out
finish
