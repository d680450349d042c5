#!/bin/bash
# Particles in a fluid in cases whose answer is known, examples/flow at reduced size: their own checks hold.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# flow_lines LINES CASE -var NAME VALUE ...: the example runs, and its RESULT lines that match all hold
flow_lines() {
	local lines=$1 case=$2
	shift 2
	(cd "$top_srcdir/examples/flow/$case" && "$TSIM" -in in.$case -log none "$@") >out 2>&1 &&
		grep "^RESULT $lines" out >found && ! grep -q 'off$' found
	report "$case $*" $? out
}

flow_lines settling settling
flow_lines settling settling -var case added
flow_lines settling settling -var case schiller
flow_lines shear_cell shear_cell -var n 30 -var N 10 -var times 0.7
# beds of 300 spheres are uneven: one is off by 0.2 to 3.2 %
flow_lines filter filter -var n 300 -var side 0.005 -var settle 5000 -var within 0.04
flow_lines filter filter -var n 300 -var side 0.005 -var settle 5000 -var within 0.04 -var law carman
# at rest: the way up to the minimum of fluidisation
flow_lines 'fluidisation[.][0v]' fluidisation -var n 250 -var side 0.0045 -var settle 7000 -var steps 300 -var long 30
finish
