#!/bin/bash
# A step beyond the limit: the message names the step, the limit and the line that set it.
# shellcheck source=tests/lib_text.sh
. "$top_srcdir/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0

# Two spheres of mass 2.25e-3: m* = 1.125e-3, 2 sqrt(m*/k) = 3e-4 for k = 5e4.
cat >in.stiff <<'END'
units si
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0.0 0.0 0.0
create_atoms 1 single 0.3 0.0 0.0
set group all diameter 0.02 mass 2.25e-3
pair_style spring/dashpot
pair_coeff * * stiffness 5.0e4 damping 0
fix move all nve
variable h index 1e-6
variable u index no
timestep ${h}
run 10 unsafe ${u}
print "got to the end"
END

check() { # what, expected exit status, step, unsafe, texts ...
	local name=$1 expected=$2 ok=1 status
	"$TSIM" -in in.stiff -log none -var h "$3" -var u "$4" >out 2>&1
	status=$?
	shift 4
	[ "$status" = "$expected" ] || ok=0
	for text in "$@"; do
		shows "$text" out || { ok=0; echo "missing: $text"; }
	done
	if [ $ok = 1 ]; then
		passed=$((passed + 1))
	else
		failed=$((failed + 1))
		echo "off: $name (exit status $status)"
		cat out
	fi
}

"$TSIM" -in in.stiff -log none -var h 3.1e-4 >/dev/null 2>&1
refused=$?
[ $refused != 0 ] || { echo 'a step beyond the limit is accepted'; exit 1; }

check 'below the limit' 0 2.99e-4 no 'got to the end'
check 'beyond the limit' $refused 3.1e-4 no 'in.stiff:7' 'pair_style spring/dashpot' \
	'time step 0.00031' 'limit 0.0003 ' 'a contact of types 1 and 1'
check 'beyond the limit, wanted' 0 3.1e-4 yes 'in.stiff:7' 'warning' 'time step 0.00031' \
	'limit 0.0003 ' 'got to the end'

echo "$passed passed, $failed failed"
[ $failed = 0 ]
