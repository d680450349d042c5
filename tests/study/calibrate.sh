#!/bin/bash
# tsim -calibrate on closed forms: exact solutions, targets that cannot be reached, bounds, failing runs, resumption, and what
# it refuses.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# products of powers, with a factor that depends on the seed; `cap` limits q; `fail` lets runs with a larger c fail
cat >in.closed <<'SCRIPT'
variable	a index 1
variable	b index 1
variable	c index 1
variable	cap index 1e9
variable	fail index 1e9
variable	seed index 1
if "${c} > ${fail}" then "print 'c is too large'" "quit 3"
variable	s equal 1+0.02*(v_seed-2)
variable	E  equal 3*v_a^0.9*v_b^0.1*v_s
variable	nu equal 0.25*v_b^0.5/v_a^0.05
variable	q0 equal 40*v_c*v_a^0.2*v_s
variable	q  equal ternary(v_q0<v_cap,v_q0,v_cap)
print		"RESULT E_GPa ${E:%.12g} 1 1 ok"
print		"RESULT nu ${nu:%.12g} 1 1 ok"
print		"STUDY q=${q:%.12g} free=$(v_s:%.12g)"
SCRIPT
calibrate() {
	"$TSIM" -calibrate "$@" >out 2>err </dev/null
}
# found NAME: value in the line of the words -var at the end
found() {
	sed -nE "s/^  -var .*\b$1 ([0-9.e+-]+).*/\1/p;s/^  -var $1 ([0-9.e+-]+).*/\1/p" out | head -n 1
}
# near VALUE REFERENCE TOLERANCE (relative)
near() {
	awk -v x="$1" -v y="$2" -v t="$3" 'BEGIN { d = x / y - 1; exit !(x != "" && d <= t && -d <= t) }'
}

# b^0.5/a^0.05 = 0.26/0.25 and a^0.9 b^0.1 = 23: the mean over the seeds has the factor 1
calibrate 'E_GPa=69 nu=0.26 q=200' -vary 'a=1:1e-2:1e3 b=1 c=1' -replicate seed=1,2,3 -in in.closed -tolerance 1e-5 -j 2
report 'three unknowns' $? out
read -r a b c < <(awk 'BEGIN { u = log(69 / 3); v = log(0.26 / 0.25); a = (u - 0.2 * v) / 0.91; b = (v + 0.05 * a) / 0.5
	print exp(a), exp(b), 5 / exp(0.2 * a) }')
near "$(found a)" "$a" 2e-5 && near "$(found b)" "$b" 2e-5 && near "$(found c)" "$c" 2e-5
report 'the solution' $? out
# a start, three runs for the first matrix, and three longest steps at most
[ "$(wc -l <results/runs.csv)" -le 17 ] && [ "$(grep -c '^RESULT .* ok$' out)" = 3 ] && shows 'All targets are reached' out
report 'number of runs' $? out
awk '$1 == "E_GPa" && NF == 4 { e = $2 == "0.900" && $3 == "0.100" && $4 == "0.000" }
	$1 == "nu" && NF == 4 { n = $2 == "-0.050" && $3 == "0.500" && $4 == "0.000" } END { exit !(e && n) }' out
report 'sensitivities' $? out
shows '67.62' out && shows '70.38' out && shows 'free             1 +- 0.012' out
report 'each replicate, and other results' $? out
cp results/runs.csv before
calibrate 'E_GPa=69 nu=0.26 q=200' -vary 'a=1:1e-2:1e3 b=1 c=1' -replicate seed=1,2,3 -in in.closed -tolerance 1e-5 &&
	shows '0 runs now' out
report 'what is reached is not run again' $? out
same 'nor written again' before results/runs.csv
# another target, from what is known: no first matrix
calibrate 'E_GPa=60:1e-4 nu=0.27:1e-4 q=220:1e-4' -vary 'a=1:1e-2:1e3 b=1 c=1' -replicate seed=1,2,3 -in in.closed &&
	shows '2 points, 3 runs now' out
report 'runs of another calibration are used' $? out
rm -r results

# a table that was cut is completed by the same points
head -n 4 before >cut && mkdir results && cp cut results/runs.csv
calibrate 'E_GPa=69 nu=0.26 q=200' -vary 'a=1:1e-2:1e3 b=1 c=1' -replicate seed=1,2,3 -in in.closed -tolerance 1e-5 &&
	cut -d, -f4-8,12- before | sort >one && cut -d, -f4-8,12- results/runs.csv | sort >two && shows '0' two
report 'resumption' $? out
same 'with the same runs' one two
rm -r results

# a tied variable: E = 3 a, once a and b are the same
calibrate E_GPa=69:1e-6 -vary 'a=1:0.1:100 b=a*2' -in in.closed && near "$(found a)" "$(awk 'BEGIN { print 23 / 0.98 / 2 ^ 0.1 }')" 1e-6 &&
	near "$(found b)" "$(awk 'BEGIN { print 46 / 0.98 / 2 ^ 0.1 }')" 1e-6 && shows '2 times a' out
report 'a tied variable' $? out
rm -r results

# more variables than targets: the shortest step
calibrate q=60:1e-5 -vary 'a=1 c=1' -in in.closed
report 'more variables than targets' $? out
near "$(awk -v a="$(found a)" -v c="$(found c)" 'BEGIN { print log(c) / log(a) }')" 5 1e-3
report 'along the steepest direction' $? out
rm -r results

# what cannot be reached: exit status 3, and why
calibrate 'E_GPa=69 q=200' -vary 'a=1:0.5:10 c=1' -in in.closed
[ $? = 3 ] && shows 'Not all targets can be reached' out && shows 'found at its upper bound' out && shows 'RESULT q 200 200' out &&
	grep -q '^RESULT E_GPa .* off$' out
report 'a bound' $? out
near "$(found a)" 10 1e-9
report 'is kept' $? out
rm -r results
calibrate 'free=2 q=60' -vary 'c=1' -in in.closed
[ $? = 3 ] && shows 'depends on none of the variables' out
report 'a result that no variable changes' $? out
rm -r results
calibrate 'q=60' -vary 'c=1' -var cap 50 -in in.closed
[ $? = 3 ] && shows 'RESULT q 50 60 3 off' out
report 'a limit of the results' $? out
rm -r results
calibrate 'E_GPa=69 nu=1' -vary 'a=1' -in in.closed
[ $? = 3 ] && [ "$(wc -l <results/runs.csv)" -lt 30 ]
report 'fewer variables than targets' $? out
rm -r results

# runs that fail beyond c = 1.6: the way there is found with shorter steps
calibrate 'q=63' -vary 'c=1' -var fail 1.6 -in in.closed -tolerance 0.01 && near "$(found c)" 1.6071 0.02
report 'steps into failure' $? out
rm -r results
calibrate 'q=200:1e-3' -vary 'c=1' -var fail 1 -in in.closed
[ $? = 3 ] && shows 'c is too large' out
report 'failure in all directions' $? out
rm -r results

# two scripts: results by name
sed '/nu/d' in.closed >in.first
sed '/E_GPa/d' in.closed | sed 's/^print.*STUDY.*//' >in.second
calibrate 'E_GPa=69 nu=0.26 q=200' -vary 'a=1:1e-2:1e3 b=1 c=1' -in in.first -in in.second -tolerance 1e-4 -replicate seed=2 &&
	near "$(found a)" "$a" 2e-4 && near "$(found b)" "$b" 2e-4
report 'two scripts' $? out
rm -r results

off() {
	local what=$1 status=$2 text=$3
	shift 3
	"$TSIM" "$@" >out 2>err </dev/null
	[ $? = "$status" ] && shows "$text" err && [ "$(wc -l <err)" -le 3 ]
	report "refused: $what" $? err
	rm -rf results
}
off 'an unknown variable' 2 "does not use the variable 'aa'; did you mean 'a'?" -calibrate q=2 -vary aa=1 -in in.closed
off 'an unknown target' 2 "has the target 'E_GP'; did you mean 'E_GPa'?" -calibrate E_GP=2 -vary a=1 -in in.closed
off 'a tolerance' 2 'expected a number above 0 and below 1 after -tolerance' -calibrate q=2 -vary a=1 -in in.closed -tolerance 0
off 'a tolerance of a target' 2 "expected a tolerance above 0 and below 1 for 'q', found -0.1" -calibrate q=2:-0.1 -vary a=1 -in in.closed
off 'a target 0' 2 "the target of 'q' is 0" -calibrate q=0 -vary a=1 -in in.closed
off 'a target of the other sign' 1 'different signs' -calibrate q=-2 -vary a=1 -in in.closed
off 'no number' 2 "expected VALUE or VALUE:TOLERANCE for 'q', found 'x'" -calibrate q=x -vary a=1 -in in.closed
off 'the same target twice' 2 "the target 'q' is given twice" -calibrate 'q=1 q=2' -vary a=1 -in in.closed
off 'the same variable twice' 2 "the variable 'a' is given twice" -calibrate 'q=1' -vary 'a=1 a=2' -in in.closed
off 'varied and replicate' 2 "the variable 'seed' is given twice" -calibrate 'q=1' -vary 'seed=1' -replicate seed=1,2 -in in.closed
off 'no start' 2 'start and bounds are positive' -calibrate q=2 -vary a=0 -in in.closed
off 'bounds' 2 'expected LO < HI with START between them' -calibrate q=2 -vary a=1:2:3 -in in.closed
off 'no variables' 2 '-calibrate needs variables' -calibrate q=2 -in in.closed
off 'too many variables' 2 '-vary takes at most 8' -calibrate q=2 -vary 'a=1 b=1 c=1 d=1 e=1 f=1 g=1 h=1 i=1' -in in.closed
off 'no script' 2 '-calibrate needs a script' -calibrate q=2 -vary a=1
off 'a script that is not there' 1 "'in.none'" -calibrate q=2 -vary a=1 -in in.none
off 'a start that fails' 1 'failed with exit status 3: c is too large' -calibrate q=2 -vary c=1 -var fail 0.5 -in in.closed
# The sensitivities that are told are those of all runs, the last one, too: y = mu^2 + 1 has 1.007 at 1.00688, and the secants
# from there to the runs before, 0.66 and 0.744.
printf 'variable mu index 0.5\nprint "RESULT y $(v_mu^2+1)"\n' >in.square
calibrate 'y=2' -vary 'mu=0.5:0.1:10' -in in.square -results square
awk '/^d ln/ { getline; getline; ok = $1 == "y" && $2 > 0.65 && $2 < 0.75 } END { exit !ok }' out
report 'sensitivities after the last run' $? out
finish
