#!/bin/bash
# The guard of the time step while a run goes on: what it says, when, and that a run cut in two says the same.
# shellcheck source=tests/lib_text.sh
. "$top_srcdir/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0

report() { # name, ok
	if [ "$2" = 1 ]; then
		passed=$((passed + 1))
	else
		failed=$((failed + 1))
		echo "off: $1"
		cat out
	fi
}

# A body force speeds a fluid up: u = t, so that u dt/h is 0.08 t and its limit with rk3, sqrt 3, is reached at t = 21.65.
cat >in.flow <<'END'
units si
dimension 2
boundary p p p
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
neighbor 0.001 bin
flow_style projection cells 8 8 1 viscosity 1e-3 density 1 time rk3 body_force 1.0 0 0 convection central
timestep 0.01
thermo 500
thermo_style custom step stable_fraction
run ${n}
write_restart cut
run ${m} upto
write_restart end.${n}
END

"$TSIM" -in in.flow -log none -var n 700 -var m 2100 >out 2>&1
cut=$(grep warning: out)
ok=1
[ "$(grep -c warning: out)" = 1 ] || ok=0
# warned before it is beyond, of that limit, with its line
step=$(sed -n 's/^in.flow:7: warning: at step \([0-9]*\) the time step 0.01 is .* of the fluid.s Courant number.*/\1/p' out)
[ "${step:-0}" -ge 1732 ] && [ "$step" -lt 2165 ] || ok=0
report 'a limit that comes nearer is warned of once' $ok

ok=1
awk '$1 == 2000 && ($2 - 0.92376) ^ 2 < 1e-8 { found = 1 } END { exit !found }' out || ok=0
report 'stable_fraction' $ok

"$TSIM" -in in.flow -log none -var n 1600 -var m 2100 >out 2>&1
ok=1
[ "$(grep warning: out)" = "$cut" ] || ok=0
cmp -s end.700 end.1600 || ok=0
report 'a run cut elsewhere says the same' $ok

cat >in.on <<'END'
read_restart cut
flow_style projection cells 8 8 1 viscosity 1e-3 density 1 time rk3 body_force 1.0 0 0 convection central
thermo 500
run 2100 upto
END
"$TSIM" -in in.flow -log none -var n 700 -var m 700 >/dev/null 2>&1
"$TSIM" -in in.on -log none >out 2>&1
ok=1
grep -q "warning: at step $step the time step" out || ok=0
report 'so does one from a restart file' $ok

# A grain (k = m = 1) that two others, which move as they are told, come to hold: with one the limit is 2, with both sqrt 2.
cat >in.press <<'END'
units si
atom_style granular
newton off
communicate single vel yes
neighbor 0.01 bin
boundary f f f
region box block -3 3 -3 3 -3 3 units box
create_box 2 box
create_atoms 1 single 0 0 0
create_atoms 2 single 1.01 0 0
create_atoms 2 single -1.01 0 0
set group all diameter 1 mass 1
fix n all property/global kn peratomtypepair 2 1 1 1 1
fix t all property/global kt peratomtypepair 2 0 0 0 0
fix g all property/global gamman_abs peratomtypepair 2 0 0 0 0
fix s all property/global gammat_abs peratomtypepair 2 0 0 0 0
fix f all property/global coefficientFriction peratomtypepair 2 0 0 0 0
fix Y all property/global youngsModulus peratomtype 1e7 1e7
fix P all property/global poissonsRatio peratomtype 0.25 0.25
fix E all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
pair_style gran model hooke/stiffness tangential off absolute_damping on
pair_coeff * *
group right id 2
group left id 3
group free type 1
fix r right move linear -1e-5 0 0
fix l left move linear 1e-5 0 0
fix move free nve/sphere
timestep ${h}
thermo 1000
run ${n}
run 3000 upto unsafe ${u}
END
press() { "$TSIM" -in in.press -log none -var h $1 -var u $2 -var n $3 >out 2>&1; }

press 1.41 no 0
status=$?
ok=1
[ $status = 0 ] && [ "$(grep -c 'warning:.* of the stability limit 1.41421 of all contacts together' out)" = 1 ] || ok=0
report 'near the limit of what has come together: one warning' $ok

ok=1
press 1.5 no 0 && ok=0
for text in 'in.press:21' 'error: at step' 'the time step 1.5 exceeds the stability limit 1.41421 of' \
	'all contacts together, about particle 1 of type 1 (2 contacts) at (0 0 0)' 'timestep 0.14'; do
	shows "$text" out || { ok=0; echo "missing: $text"; }
done
report 'beyond it: stopped, with cause, place and what to do' $ok

stopped=$(grep -E 'warning|error' out)
press 1.5 no 500
ok=1
[ "$(grep -E 'warning|error' out)" = "$stopped" ] || ok=0
report 'at the same step in a run that is cut' $ok

press 1.5 yes 0
status=$?
ok=1
[ $status = 0 ] && grep -q 'warning: at step .* is 106 % of the stability limit 1.41421' out || ok=0
report 'unsafe: warned only' $ok

echo "$passed passed, $failed failed"
[ $failed = 0 ]
