#!/bin/bash
# The granular pair styles of LAMMPS, and bonds between spheres, against LAMMPS, an independent program: five uneven spheres, one of them
# frozen, collide obliquely.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs /usr/bin/python3 python3
decks=$top_srcdir/tests/crosscheck

agrees() { # PAIR STYLE [COEFFICIENTS OF PAIR_COEFF...]
	local what="$*"
	echo "pair_style $1" >laws
	shift
	printf 'pair_coeff %s\n' "${@:-* *}" >>laws
	set -- -in "$decks/in.lammps_granular" -var decks "$decks" -var steps 6000
	lmp "$@" -var program lammps -log none -screen none >err 2>&1
	report "$what: LAMMPS" $? err
	"$TSIM" "$@" -var program tsim -log none -screen none 2>err
	report "$what: tsim" $? err
	/usr/bin/python3 "$decks/compare.py" lammps.dump tsim.dump 6000 1e-12 >deviation 2>&1
	report "$what" $? deviation
	echo "$what: $(cat deviation)"
	rm -f ./*.dump
}

for numbers in '2.3e5 1.3e5 53 23 0.31 1' '2.3e5 NULL 53 NULL 0.17 0' '2.3e5 NULL 153 NULL 0.61 1 limit_damping'; do
	for law in hooke hooke/history; do
		agrees "gran/$law $numbers"
	done
	agrees "gran/hertz/history ${numbers/2.3e5/5.31e6}"
done

history='tangential linear_history 1.3e5 0.4 0.31' sds='rolling sds 3e4 3 0.13'
material='hertz/material 5.3e6 0.7 0.3' mindlin='tangential mindlin NULL 0.4 0.31' tsuji='damping tsuji'
laws=(
	'* * hooke 2.3e5 53 tangential linear_nohistory 0.4 0.31 damping mass_velocity'
	"* * hooke 2.3e5 23 $history damping velocity $sds"
	"* * hooke 2.3e5 0.7 $history $tsuji twisting sds 40 0.02 0.003 limit_damping"
	"* * hertz 5.3e6 2e3 $history"
	"* * hertz 5.3e6 300 tangential mindlin 4e6 0.4 0.31 twisting marshall"
	"* * $material $mindlin $tsuji $sds twisting marshall"
	"* * $material ${mindlin/ NULL/_rescale NULL} $tsuji"
	"* * $material ${mindlin/ NULL//force NULL} $tsuji $sds"
	"* * $material ${mindlin/ NULL/_rescale/force NULL} $tsuji twisting sds 40 0.02 0.003"
	"* * dmt 5.3e6 0.7 0.3 5 ${mindlin/ 0.31/ 0} $tsuji"
	"* * jkr 5.3e6 0.7 0.3 5 $mindlin $tsuji"
	"* * jkr 5.3e6 900 0.3 5 tangential mindlin_rescale 3e6 0.4 0.31 $sds twisting marshall"
)
for words in "${laws[@]}"; do
	agrees granular "$words"
done
lmp -in "$decks/in.lammps_harmonic" -var out lammps -log none -screen none >err 2>&1
report 'bonds: LAMMPS' $? err
"$TSIM" -in "$decks/in.lammps_harmonic" -var out tsim -log none -screen none 2>err
report 'bonds: tsim' $? err
/usr/bin/python3 "$decks/compare.py" lammps.dump tsim.dump 2500 1e-10 >deviation 2>&1
report 'bond harmonic' $? deviation
rm -f ./*.dump

agrees granular "1 * jkr 5.3e6 900 0.3 3 ${mindlin/ NULL/_rescale NULL} $sds twisting marshall" \
	"2 2 hertz 7.3e6 200 $history rolling sds 4e4 2 0.23 damping mass_velocity"
# the first law has no rolling friction, or no friction at all
agrees granular "1 1 hertz 5.3e6 2e3 $history" "* 2 $material $mindlin $tsuji $sds twisting marshall"
agrees granular '1 1 hooke 2.3e5 53 tangential linear_nohistory 0 0' "* 2 hooke 2.3e5 23 $history $sds"
finish
