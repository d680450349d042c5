#!/bin/bash
# pressure_style: all solvers give the same flow; what is chosen without one; limits and refusals.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cavity='units si
dimension 2
boundary f f p
region box block 0 1 0 1 -0.05 0.05 units box
create_box 1 box
flow_style projection cells 17 12 1 viscosity 0.0385 density 2.385
flow_boundary yhi wall velocity 0.73 0 0
flow_boundary xhi outlet
timestep 0.013
thermo 1000'
told='print "energy $(flow_ke:%.7g)"'
energy=$(printf '%s\n' "$cavity" 'run 30' "$told" | "$TSIM" -log none 2>err | grep '^energy')
[ -n "$energy" ]
report 'a cavity' $? err

for style in direct 'cg tolerance 1e-10' 'cg preconditioner diagonal tolerance 1e-10' \
	'cg preconditioner multigrid tolerance 1e-10' 'multigrid tolerance 1e-10' 'sor tolerance 1e-10' \
	'sor relaxation 1.3 tolerance 1e-10' auto; do
	prints "$cavity
pressure_style $style
run 30
$told" "$energy"
done

# The choice: by conditions and void fraction; for later runs anew.
prints "$cavity
pressure_style sor
run 1
print \"iterations \$(flow_iter>4)\"
pressure_style auto
run 1
print \"iterations then \$(flow_iter)\"
pressure_style cg preconditioner diagonal
run 1
print \"iterations last \$(flow_iter>4)\"" 'iterations 1' 'iterations then 0' 'iterations last 1'

printf '%s\n' "$cavity" 'run 30' >in.script
"$TSIM" -explain -in in.script >out 2>&1
grep -q 'pressure .*direct .*the cheapest here' out
report '-explain names the direct solver' $? out
printf '%s\n' "$cavity" 'pressure_style multigrid' 'run 30' >in.script
"$TSIM" -explain -in in.script >out 2>&1
grep -q 'pressure .*multigrid .*chosen by the script' out
report '-explain names the one of the script' $? out
bed="$cavity
create_atoms 1 single 0.52 0.31 0 units box
set type 1 diameter 0.0385 density 2500
fix room all void_fraction"
printf '%s\n' "$bed" 'run 1' >in.script
"$TSIM" -explain -in in.script >out 2>&1
grep -q 'pressure .*cg .*void fractions' out
report '-explain: conjugate gradients with void fractions' $? out

rejects "$bed
pressure_style direct
run 1" 'pressure_style direct cannot be used here: it solves only where the void fraction is 1 everywhere'
for factor in 2.01 2 0 -0.3; do
	rejects "$cavity
pressure_style sor relaxation $factor" "relaxation $factor: successive over-relaxation converges only between 0 and 2"
done
rejects "$cavity
pressure_style sor iterations 3
run 1" 'pressure_style sor: after 3 iterations the residual is'
rejects "$cavity
pressure_style cg preconditioner diagonal iterations 4
run 1" 'pressure_style cg: after 4 iterations the residual is'
prints "$cavity
pressure_style sor iterations 3 unfinished warn
run 5" '*warning: pressure_style sor: after 3 iterations the residual is'
[ "$(grep -c 'warning: pressure_style' out)" = 1 ]
report 'one warning only' $? out
for style in cg multigrid sor; do
	rejects "$cavity
pressure_style $style tolerance 0.00101" 'tolerance'
	prints "$cavity
pressure_style $style tolerance 0.001
run 1
print went" went
done
"$TSIM" -help pressure hypre >/dev/null 2>&1 && {
	printf '%s\n' "$cavity" 'pressure_style hypre' 'run 1' >in.script
	"$TSIM" -in in.script -log none >out 2>err || grep -q 'built without hypre: configure it with --with-hypre' err
	report 'hypre, or how to get it' $? err
}
finish
