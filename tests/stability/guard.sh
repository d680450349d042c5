#!/bin/bash
# The guard of the time step while a run goes on: what it says, when, and that a run cut in two says the same.
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

echo "$passed passed, $failed failed"
[ $failed = 0 ]
