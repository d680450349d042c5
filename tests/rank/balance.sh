#!/bin/bash
# Command and fix balance: imbalances that are known, files of the blocks, and results that do not depend on them.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
export OMP_NUM_THREADS=1
halves=$top_srcdir/tests/rank/scenes/in.halves

# scene LINE...: 2000 points on a lattice in the left half of a box, with these lines
scene() {
	printf '%s\n' 'units lj' 'dimension 3' 'boundary f p f' "$grid" 'region box block 0 20 0 10 0 20' 'create_box 2 box' \
		'lattice sc 1.0' 'region left block 0 9.5 0 9.5 0 19.5' 'create_atoms 1 region left' \
		'region low block INF INF INF INF INF 3.5' 'group low region low' 'mass * 1' "$@"
}
grid='processors 2 1 1'

# wrong TEXT LINE: one process and several refuse the line, with this message
wrong() {
	scene "$2" >in.wrong
	"$TSIM" -in in.wrong -log none >out 2>&1
	[ $? != 0 ] && grep -q "in.wrong:13:[0-9]*: error: .*$1" out
	report "refused: $2" $? out
}
wrong 'balance: expected one way of balancing' 'balance 1.1'
wrong 'balance: expected one way of balancing' 'balance 1.1 rcb x uniform'
wrong 'in ascending order' 'balance 1.1 x 0.5 0.4'
wrong 'in ascending order' 'balance 1.1 y 0.5 1'
wrong 'letters x, y and z, each at most once' 'balance 1.1 shift xx 10 1.1'
wrong 'a number of bisections > 0' 'balance 1.1 shift x 0 1.1'
wrong 'shift is followed by' 'balance 1.1 shift x 10'
wrong 'an imbalance >= 1' 'balance 1.1 shift x 10 0.5'
wrong 'group, neigh, time, var or store' 'balance 1.1 rcb weight mass'
wrong "there is no group 'high'" 'balance 1.1 rcb weight group 1 high 2'
wrong 'a factor > 0' 'balance 1.1 rcb weight group 1 low 0'
wrong 'a factor > 0' 'balance 1.1 rcb weight neigh -1'
wrong "unknown variable 'none'" 'balance 1.1 rcb weight var none'
wrong 'there is no property d_none' 'balance 1.1 rcb weight store none'
wrong "unknown keyword 'x'" 'fix b all balance 10 1.1 x uniform'
scene 'variable w atom x-5' 'balance 1.1 rcb weight var w' >in.wrong
refused 'a weight that is not positive' 'the weight of particle 1 is -5, expected a number > 0' -in in.wrong -log none
scene 'balance 1.1 x 0.2 0.6 y uniform' 'fix b all balance 10 1.1 shift xz 5 1.1 weight neigh 0.8 out blocks' 'fix 1 all nve/noforce' \
	'thermo_style custom step f_b f_b[1] f_b[2] f_b[3]' 'run 10' >in.alone
"$TSIM" -in in.alone -log none >out 2>&1 && grep -Eq '^ +10 +1 +2000 +0 +1 *$' out
report 'one process is balanced' $? out

has_ranks || finish
ranks() {
	local n=$1
	shift
	on_ranks "$n" "$TSIM" -log none "$@" >out 2>&1 </dev/null
}
# told TEXT: the log of the command has this line
told() {
	grep -qx "Balance of $1" out
	report "$1" $? out
}

# What -explain tells of the particles of ranks is what a run has.
grid='processors 4 1 1'
for line in '' 'balance 0.9 x uniform' 'balance 1.1 rcb' 'balance 0.9 x 0.1 0.15 0.2' 'fix b all balance 10 0.9 rcb'; do
	scene "$line" 'fix 1 all nve/noforce' 'run 1' >in.planned
	ranks 4 -in in.planned
	has=$(sed -n 's/^Ranks: .*, [0-9]* to \([0-9]*\) particles each.*/\1/p' out)
	"$TSIM" -in in.planned -explain -ranks 4 -log none >out 2>&1
	[ -n "$has" ] && [ "$has" = "$(awk '/blocks/ && /now:$/ { t = 1 } t && $1 == "particles" { print $4 }' out)" ]
	report "planned: ${line:-without balance}" $? out
done
grid='processors 2 1 1'

# Without the command both ranks have 1000; with equal blocks one has all.
scene 'balance 1.0 x uniform' 'balance 0.9 x uniform' 'balance 1.1 shift x 20 1.0' 'balance 1.1 x uniform' 'balance 0.9 x 0.175' >in.two
ranks 2 -in in.two
told '2 ranks: imbalance 1, before 1; the largest load is 1000; 0 iterations'
told '2 ranks: imbalance 2, before 1; the largest load is 2000; 0 iterations'
grep -Eq '^Balance of 2 ranks: imbalance 1, before 2; the largest load is 1000; [0-9]+ iterations' out
report 'shift finds the middle' $? out
told '2 ranks: imbalance 1.2, before 1; the largest load is 1200; 0 iterations' # 4 of 10 layers on the first one

# 400 of 2000 points have the weight 4: 3200 in all, in layers of 400 and 100.
grid='processors * * *'
scene 'balance 0.9 rcb weight group 1 low 4 out blocks' >in.weights
ranks 4 -in in.weights
grep -Eq '^Balance of 4 ranks: imbalance 1, before [12].*; the largest load is 800; 1 iterations' out
report 'weights of groups' $? out
awk '/^ITEM: NODES/ { on = 1; next } /^ITEM/ { on = 0 } on { if ($1 % 8 == 1) split($0, a); if ($1 % 8 == 7) v += ($3 - a[3]) * ($4 - a[4]) * ($5 - a[5]) }
	END { exit !(v == 20 * 10 * 20) }' blocks && grep -qx '4 1 25 26 27 28 29 30 31 32' blocks
report 'the blocks fill the box' $? blocks
scene 'balance 0.9 x uniform' >in.grid
sed -i 's/^processors.*/processors 2 2 1/' in.grid
ranks 3 -in in.grid
[ $? != 0 ] && grep -q 'in.grid:4:[0-9]*: error: processors: ' out
report 'a grid that does not fit' $? out
sed -i 's/^processors.*/processors 3 1 1/; s/x uniform/x 0.1 0.2 0.3/' in.grid
ranks 3 -in in.grid
[ $? != 0 ] && [ "$(grep -c 'in.grid:13:15: error: balance: expected uniform or 2 numbers, since there are 3 blocks along x' out)" = 1 ]
report 'a number of cuts that does not fit' $? out

# The fix: a column that collapses into the other half. The imbalance stays small, and results are those of one process.
"$TSIM" -in "$halves" -log none -screen none -var out one >out 2>&1
report 'one process' $? out
for how in rcb 'shift xz 15 1.01'; do
	for n in 2 5; do
		ranks $n -in "$halves" -var out many -var how "$how" -screen none
		report "$how on $n ranks" $? out
		same "$how on $n ranks: the same bytes" one.dump many.dump
	done
done
sed -E '/^balance/d; /^(dump|variable high|fix weight)/d; s/^fix share.*/fix share all balance 100 1.05 rcb out blocks/
	s/^(thermo_style.*) ke.*/\1 f_share f_share[1] f_share[2] f_share[3]/; s/^run 300//' "$halves" >in.share
for n in 3 4; do
	ranks $n -in in.share
	awk -v n=$n '/^ +[0-9]+ +490 / { rows++; if ($3 > 1.05 || $3 < 1 || $3 * 490 / n - $4 > 0.1 || $4 - $3 * 490 / n > 0.1) bad = 1; changed += $5 }
		END { exit !(rows > 4 && !bad && changed) }' out
	report "the imbalance of $n ranks stays below 1.05" $? out
	grep -q "Ranks: $n as blocks of a recursive bisection, 1[0-9]* to 1[0-9]* particles each, imbalance 1.[0-9]*$" out
	report "the log tells the blocks of $n ranks" $? out
	[ "$(grep -c 'NUMBER OF CUBES' blocks)" -ge 2 ]
	report "$n ranks: the blocks after each change are in the file" $? blocks
done
finish
