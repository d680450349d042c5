#!/bin/bash
# fix ave/period: frequency and means of known signals, and its restart; flow_grid around.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.signal <<'END2'
region box block 0 1 0 1 0 1 units box
if "${from} == none" then "create_box 1 box" else "read_restart ${from}"
variable s equal 0.3+sin(2*PI*1.7*time+0.4)
variable c equal 5000+2*cos(2*PI*1.7*time+0.4)
timestep 0.002
fix p all ave/period 2 v_s v_c level 0.3
run 1300
if "${from} == none" then "write_restart restart"
run 1200
print "f_p $(f_p[1]) $(f_p[2]) $(f_p[1][1]) $(f_p[2][1]) $(f_p[2][2]) $(f_p[2][3]) $(f_p[2][4])"
END2
"$TSIM" -in in.signal -log none -var from none >out 2>&1
grep '^f_p' out >whole
awk -v pi=3.14159265358979 'function off(a, b, t) { return a - b > t || b - a > t }
	{ ok = !(off($2, 1.7, 1e-6) || $3 != 7 || off($4, 0.3, 1e-4) || off($5, 5000, 1e-4) || off($6, 4998, 2e-3) ||
	  off($7, 5002, 2e-3) || off($8, sqrt(2), 1e-3)); exit } END { exit !ok }' whole
report 'frequency, mean, extremes, rms' $? out
sed -e '/^run 1300/d' in.signal >in.again
"$TSIM" -in in.again -log none -var from restart >out 2>&1
grep '^f_p' out >again
same 'after a restart' whole again

scene='dimension 2
region box block -2 3 0 1 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 20 8 1 viscosity 1 density 1'
prints "$scene
flow_grid x around 0 1 before 5 inside 10
compute x all flow/line cells x 0.5 0 values x
print \"\$(c_x[6][1]:%.15g) \$(c_x[15][1]:%.6f) first \$(c_x[1][1] < -1.4) last \$(c_x[20][1] > 2.4)\"" \
	'0.05 0.950000 first 1 last 1'
rejects "$scene
flow_grid x around 0 1 before 12 inside 10" 'do not fit'
rejects "$scene
flow_grid x around 0 1 before 0 inside 10" 'cannot fill'
finish
