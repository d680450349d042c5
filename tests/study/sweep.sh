#!/bin/bash
# tsim -sweep: combinations, means, failures, interruption and resumption, and what it refuses. The results of the scripts are
# formulas.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.power <<'SCRIPT'
variable	a index 1
variable	b index 1
variable	seed index 1
variable	out index post
variable	slow index 0
shell		mkdir ${out}
variable	pole equal 1/(v_a-13)
print		"pole ${pole}"
if "${a} == 14" then "print 'a is 14' " "quit 5"
print		"${a}" file ${out}/a.txt
variable	s equal 1+0.03*(v_seed-2)
variable	y equal v_a^2*v_b*v_s
print		"RESULT y ${y:%.12g} 4 1 $(ternary(v_a < 3, 1, 0):%.0f)"
print		"STUDY z=$(v_a+v_b:%.12g) 7"
print		"RESULT twice 1 1 0 ok"
print		"RESULT twice 2 1 0 off"
SCRIPT

# cell ROW-PATTERN COLUMN FILE
cell() {
	awk -F, -v pattern="$1" -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) if ($k == name) c = k; next }
		$0 ~ pattern { print $c }' "$3"
}
sweep() {
	"$TSIM" -sweep "$@" >out 2>err </dev/null
}

sweep 'a=1:3:3 seed=1,2,3' b=2:8:3:log -in in.power -j 2
report 'a sweep' $? err
[ "$(wc -l <results/runs.csv)" = 28 ] && [ "$(wc -l <results/summary.csv)" = 10 ]
report 'rows of both tables' $? results/runs.csv
# mean of 0.97, 1 and 1.03 times a^2 b; standard error 0.03/3^0.5 of it, printed with 3 digits
awk -F, 'NR > 1 { n++; y = $1^2 * $2; e = 0.03 / sqrt(3) * y
	if ($3 < y * (1 - 1e-8) || $3 > y * (1 + 1e-8) || $4 < 0.99 * e || $4 > 1.01 * e || $5 != 3) bad = 1; b[$2] = 1 }
	END { exit bad || n != 9 || !(2 in b) || !(4 in b) || !(8 in b) }' results/summary.csv
report 'means and standard errors' $? results/summary.csv
[ "$(cell ',2,3,4,0,' z results/runs.csv)" = 6 ] && [ "$(cell ',2,3,4,0,' STUDY_2 results/runs.csv)" = 7 ] &&
	[ "$(cell ',2,3,4,0,' twice_2 results/runs.csv)" = 2 ] && [ "$(cell ',2,3,4,0,' off results/runs.csv)" = 1 ]
report 'the columns of a run' $? results/runs.csv
mkdir names && (cd names && printf 'variable mu index 0.1\nprint "STUDY mu=$(2*v_mu) off=3"\n' >in.names &&
	"$TSIM" -sweep mu=0.25,0.5 -in in.names -j 1 >out 2>&1)
[ "$(cell ',0.25,0,' mu_2 names/results/runs.csv) $(cell ',0.25,0,' off_2 names/results/runs.csv)" = '0.5 3' ]
report 'results that have the name of another column' $? names/results/runs.csv
[ "$(cat "results/$(cell ',2,3,4,0,' run results/runs.csv)/a.txt")" = 2 ] && [ -s results/1/log ] && [ ! -e post ]
report 'each run has a folder' $?
[ "$(grep -c '<text[^>]*>b [248]</text>' results/summary.svg)" = 15 ] && grep -q '>in.power<' results/summary.svg &&
	[ "$(grep -c ' bar"' results/summary.svg)" = 3 ] && [ -s results/summary.png ]
report 'a chart: a curve for each b, five results, the errors of one' $? results/summary.csv
cp results/runs.csv before
sweep 'a=1:3:3 seed=1,2,3' b=2:8:3:log -in in.power -j 2 && shows '0 of them now' out
report 'nothing is run twice' $? out
same 'nor is its row changed' before results/runs.csv
sweep 'a=1:4:4 seed=1,2,3' b=2:8:3:log -in in.power -j 2 && shows '36 runs, 9 of them now' out
report 'a larger sweep runs what is new' $? out
sed -i 's/^variable	a index 1/&  # a comment/' in.power
sweep 'a=1:3:3 seed=1,2,3' b=2:8:3:log -in in.power && shows '0 of them now' out
report 'a comment does not make another script' $? err
rm -r results

# one variable: a chart; a tied one; -replicate
sweep 'b=1,2,4 a=b*0.5' -replicate seed=1,2 -in in.power -log none && [ "$(cell '^4,2,' y results/summary.csv)" = 15.76 ] &&
	[ ! -e results/1/log ] && [ ! -e results/plot.gp ] && grep -q ">b<" results/summary.svg && ! grep -q ">a " results/summary.svg
report 'a tied variable, another replicate, no log' $? out
rm -r results
sweep 'b=1,2,4' -in in.power && shows 'column(3)' results/plot.gp && grep -q '>b<' results/summary.svg && [ "$(cell '^2,' y_runs results/summary.csv)" = 1 ]
report 'a chart' $? out
rm -r results

# runs that fail are in the table with their message; the others are run
sweep 'a=12,13,14,15' -in in.power
[ $? = 1 ] && shows "division of 1 by zero" out && says_line "run 3 failed (a=14), exit status 5: a is 14" out && shows '4 runs, 4 of them now, 2 failed' out &&
	[ "$(wc -l <results/runs.csv)" = 5 ] && [ "$(cell '^.*,15,' status results/runs.csv)" = 0 ]
report 'failures' $? out
sweep 'a=12,13,14,15' -in in.power
[ $? = 1 ] && shows '4 runs, 0 of them now, 2 failed' out
report 'and are not repeated' $? out
rm -r results

# interrupted: the runs under way are ended and have no row; the same command goes on
awk '/RESULT y/ { print "if \"${slow} == 0\" then \"jump SELF on\""; print "label wait"
	print "if \"$(is_file(go)) == 0\" then \"jump SELF wait\""; print "label on" } { print }' in.power >in.wait
"$TSIM" -sweep 'slow=0,1 a=1,2' -in in.wait -j 1 >out 2>err </dev/null &
child=$!
has_rows() { [ -s results/runs.csv ] && [ "$(wc -l <results/runs.csv)" = 3 ] && [ -e results/3/screen ]; }
wait_for has_rows
report 'two runs have ended' $? out
waiting=$(pgrep -P "$child")
kill -INT "$child"
wait "$child"
[ $? = 130 ] && shows 'the same command goes on' err && [ "$(wc -l <results/runs.csv)" = 3 ] && [ -n "$waiting" ] &&
	! kill -0 "$waiting" 2>/dev/null
report 'an interruption' $? err
touch go
sweep 'slow=0,1 a=1,2' -in in.wait -j 2 && shows '4 runs, 2 of them now, 0 failed' out
report 'and resumption' $? out
# a study that is killed takes its runs with it; while it runs no other one has the folder
rm -r go results
if [ "$(uname)" = Linux ]; then
	"$TSIM" -sweep 'slow=0,1 a=1,2' -in in.wait -j 1 >out 2>err </dev/null &
	child=$!
	wait_for has_rows
	"$TSIM" -sweep 'slow=0,1 a=1,2' -in in.wait -j 1 >second 2>&1 </dev/null
	[ $? = 1 ] && shows 'another study is running' second
	report 'two studies in one folder' $? second
	waiting=$(pgrep -P "$child")
	kill -KILL "$child"
	wait "$child" 2>/dev/null
	gone() { ! kill -0 "$waiting"; }
	[ -n "$waiting" ] && wait_for gone
	report 'a killed study' $?
fi
touch go
sweep 'slow=0,1 a=1,2' -in in.wait -j 2 && shows '4 runs, 2 of them now, 0 failed' out
report 'and its resumption' $? out
# a run that a signal has ended is run again
sed -i '2s/^\(.*\),0,\([0-9.]*\),\([0-9]*\),,/\1,137,\2,\3,,/' results/runs.csv
sweep 'slow=0,1 a=1,2' -in in.wait -j 2 && shows '1 of them now, 0 failed' out
report 'a killed run is repeated' $? out
rm -r results

# a mean tells of how many of its runs it is
printf '%s\n' 'variable a index 1' 'variable seed index 1' 'variable p string ${a}' \
	'if "${seed} == 3" then "variable p string nan"' 'print "RESULT p ${p}"' >in.gaps
sweep 'a=1,2 seed=1,2,3' -in in.gaps && [ "$(grep -c ' +- 0 (2)' out)" = 2 ]
report 'runs without a number' $? out
rm -r results

# a script that ends early with the first values
printf '%s\n' 'variable a index 1' 'if "${a} == 0" then quit' 'print "RESULT u $(v_b*v_a) $x"' >in.early
sweep 'a=0,1 x=2,3 b=4' -in in.early && [ "$(cell '^1,3,4,' u results/summary.csv)" = 4 ] && [ "$(wc -l <results/runs.csv)" = 5 ]
report 'a script that ends early' $? err
rm -r results

# two scripts: a run of one that does not use the variable is not repeated
printf 'variable c index 1\nprint "RESULT u $(v_c) 1 1 ok"\n' >in.other
sweep 'a=1,2,3 c=5' -in in.power -in in.other && [ "$(wc -l <results/runs.csv)" = 5 ] && [ "$(cell '^3,5,' u results/summary.csv)" = 5 ] &&
	[ "$(cell '^3,5,' y results/summary.csv)" = 8.73 ]
report 'two scripts' $? out
rm -r results
printf 'variable c index 1\nprint "RESULT y $(v_c) 1 1 ok"\n' >in.other

# off WHAT STATUS TEXT WORDS...: one message
off() {
	local what=$1 status=$2 text=$3
	shift 3
	"$TSIM" "$@" >out 2>err </dev/null
	[ $? = "$status" ] && shows "$text" err && [ "$(grep -c 'error:' err)" -le 1 ]
	report "refused: $what" $? err
	rm -rf results
}
off 'two scripts with the same result' 1 "both in.power and in.other print the result 'y'" -sweep 'a=1 c=2' -in in.power -in in.other
off 'an unknown variable' 2 "does not use the variable 'sed'; did you mean 'seed'?" -sweep 'sed=1,2' -in in.power
off 'an unknown variable of -var' 2 "does not use the variable 'bb'; did you mean 'b'?" -sweep 'a=1,2' -var bb 3 -in in.power
off 'no script' 2 '-sweep needs a script' -sweep 'a=1'
off 'a script that is not there' 1 "'in.none'" -sweep 'a=1' -in in.none
echo 'foo $a' >in.bad
off 'a script with errors' 1 'in.bad does not pass -check: in.bad:1:1: error: unknown command' -sweep 'a=1' -in in.bad
off 'the same script twice' 2 "'in.power' is given twice" -sweep 'a=1' -in in.power -in in.power
off 'the same variable twice' 2 "the variable 'a' is given twice" -sweep 'a=1 a=2' -in in.power
off 'the same variable in -var' 2 "the variable 'a' is given twice" -sweep 'a=1' -var a 2 -in in.power
off 'the same value twice' 2 "the value 2 of 'a' is given twice" -sweep 'a=2,1:3:3' -in in.power
off 'no values' 2 "expected NAME=VALUE, found 'a='" -sweep 'a=' -in in.power
off 'a range' 2 "expected LO:HI:N or LO:HI:N:log with N from 2 to 100000 for 'a', found '1:2:1'" -sweep 'a=1:2:1' -in in.power
off 'a logarithmic range' 2 'one sign' -sweep 'a=0:2:3:log' -in in.power
off 'a comma' 2 "a value of 'a' is missing beside a comma" -sweep 'a=1,,2' -in in.power
off 'too many' 2 'more than 10000 combinations' -sweep 'a=1:1000:1000 b=1:1000:1000' -in in.power
off 'two replicates' 2 '-replicate takes one variable' -sweep 'a=1 seed=1,2' -replicate 'b=1,2 slow=0,1' -in in.power
off 'jobs' 2 'expected a number from 1 to 1024 after -j' -sweep 'a=1' -in in.power -j 0
off 'options without a study' 2 'belong to -sweep or -calibrate' -in in.power -j 2
off 'two scripts without a study' 2 "'in.power' and 'in.other'" -in in.power -in in.other
off 'a study in the sandbox' 2 '-sweep and -sandbox cannot be given together' -sweep 'a=1' -in in.power -sandbox
off 'a study that is checked' 2 '-sweep and -check cannot be given together' -sweep 'a=1' -in in.power -check
off 'both studies' 2 '-sweep and -calibrate cannot be given together' -sweep 'a=1' -calibrate 'y=1' -in in.power

# tables of something else
sweep 'a=1,2' -in in.power
cp -r results kept
off 'another study in the folder' 1 'other variables' -sweep 'b=1,2' -in in.power
cp -r kept results
echo 'print "more"' >>in.power
off 'another version of the script' 1 'as it was before it was changed' -sweep 'a=1,2' -in in.power
mkdir results && echo 'x,y' >results/runs.csv
off 'another file' 1 'this is no table of runs' -sweep 'a=1,2' -in in.power
cp -r kept results && echo '3,4' >>results/runs.csv
off 'a damaged table' 1 'results/runs.csv:4: error: expected' -sweep 'a=1,2' -in in.power
touch results
off 'a file in the place of the folder' 1 "cannot create the folder 'results'" -sweep 'a=1,2' -in in.power
# Runs write the same files unless a variable `out` keeps them apart.
printf 'variable a index 1\nvariable out index .\nprint "x" file ${out}/y.txt\nprint "STUDY y=$(v_a)"\n' >in.apart
sed '/out index/d; s,.{out}/,,' in.apart >in.same
"$TSIM" -sweep a=1,2 -in in.same -results same >out 2>&1 && grep -q "in.same has no variable .out., so that all runs write the same files" out
report 'the same files' $? out
"$TSIM" -sweep a=1,2 -in in.apart -results apart >out 2>&1 && ! grep -q 'has no variable' out && [ -f apart/1/y.txt ]
report 'files of each run' $? out
finish
