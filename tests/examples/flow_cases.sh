#!/bin/bash
# The fluid in cases whose answer is known, examples/flow at reduced size: their own checks hold, and errors fall
# with the grid as they should.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# order WHAT LEAST NAME NAME: the value of the first result falls at least by 2^LEAST to that of the second
order() {
	awk -v least="$2" -v a="$3" -v b="$4" '
		$2 == a { coarse = $3 }
		$2 == b { fine = $3 }
		END { print a, coarse, b, fine
		      exit !(fine > 0 && log(coarse / fine) / log(2) >= least) }' all >out
	report "$1: order $2" $? out
}

flow_case 'channel' poiseuille -var N 5 -var within 0.03
flow_case 'channel' poiseuille -var N 10 -var out "$work/channel"
[ "$(grep -vc '^#' channel)" = 101 ]
report 'file of the channel' $? channel
order 'profile of a channel' 1.9 plates.inlet.5.profile plates.inlet.10.profile
# a parabola is exact in the scheme, whatever the grid
flow_case 'channel, pulled along' poiseuille -var N 4 -var drive force -var within 1e-6
flow_case 'channel, driven by pressures' poiseuille -var N 4 -var drive pressure -var within 1e-6
for N in 4 8; do
	flow_case 'channel, driven by pressures' poiseuille -var N $N -var drive pressure -var wall linear -var within 0.1
done
order 'profile driven by pressures' 1.95 plates.pressure.4.profile plates.pressure.8.profile
# a duct has the errors that it has when it is pulled along
for drive in force pressure; do
	flow_case 'duct, driven' poiseuille -var N 5 -var shape duct -var drive $drive -var within 0.05
	awk '/profile/ { printf "%.5f\n", $3 }' lines >profile.$drive
done
same 'duct, driven' profile.force profile.pressure
flow_case 'duct' poiseuille -var N 5 -var shape duct -var within 0.07
flow_case 'duct' poiseuille -var N 10 -var shape duct -var within 0.02
order 'profile of a duct' 1.9 duct.inlet.5.profile duct.inlet.10.profile

for wall in linear quadratic; do
	flow_case 'started plate' plate -var N 10 -var part 0.1 -var within 0.025 -var wall $wall
	flow_case 'started plate' plate -var N 20 -var part 0.1 -var within 0.007 -var wall $wall
done
for t in 0.04 0.16 0.64; do
	order "started plate at $t" 1.9 plate.10.linear.at.$t plate.20.linear.at.$t
done
order "started plate" 1.7 plate.10.quadratic.at.0.04 plate.20.quadratic.at.0.04

flow_case 'vortices' taylor_green -var N 16 -var steps 64
flow_case 'vortices' taylor_green -var N 32 -var steps 256
order 'vortices' 1.9 taylor_green.16.velocity taylor_green.32.velocity

flow_case 'cavity' cavity -var N 16 -var longest 25 -var steady 0
flow_case 'cavity' cavity -var N 32 -var longest 25 -var steady 0 -var within 0.005
flow_case 'cavity, graded' cavity -var N 16 -var tanh 1.2 -var convection quick -var within 0.009 -var out "$work/cavity"
[ "$(grep -vc '^#' cavity.u)" = 130 ] && [ -s cavity.pvd ] && ls cavity*.vtr >/dev/null
report 'files of the cavity' $? out
order 'cavity' 1.8 cavity.100.16.central.fv.u cavity.100.32.central.fv.u

flow_case 'slider bearing' bearing -var N 8 -var aspect 12 -var out "$work/bearing"
[ "$(grep -vc '^#' bearing)" = 49 ]
report 'file of the bearing' $? bearing

# the profiles beside the example are those of the data
for Re in 100 400 1000; do
	awk -F, -v re="$Re" '
		/^s,/ { for (k = 1; k <= NF; k++) { if ($k == "u_Re" re) u = k; if ($k == "v_Re" re) v = k } }
		/^[01]/ { a[++n] = $u + 0; b[n] = $v + 0 }
		END { for (k = n; k; k--) print a[k]
		      for (k = n; k; k--) print b[k] }' "$top_srcdir/tests/data/cavity_profiles_129.csv" |
		sort >csv
	sed '/^#/d; s/.*\[//; s/[],&]/\n/g' "$top_srcdir/examples/flow/cavity/profiles.$Re" |
		grep . | sort >example
	same "profiles at Re = $Re" csv example
done
finish
