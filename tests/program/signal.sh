#!/bin/bash
# A run stopped by a signal finishes its step, saves its state, says how to go on; and the run that goes on
# ends as if there had been no signal, byte for byte.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# The run writes 4 kB per step into a pipe, so it is never far ahead of who reads there. Lines have the same length, since the
# shell reads a known number of letters at once, but lines letter by letter.
mkfifo pace
cat >in.part <<END
variable first string 'X'
include $top_srcdir/tests/decks/in.everything
run \${last} upto
write_restart \${out}.restart
END
sed "s|^run|fix pace all print 1 \"\$(step:%04.0f) $(head -c 4000 /dev/zero | tr '\0' x)\" file pace screen no title none\nrun|" \
	in.part >in.paced

# blocked WAY PROCESS...: each reads from an empty pipe, or writes to a full one (a kernel may tell only that they sleep)
blocked() {
	local way=$1 state place
	for process in "${@:2}"; do
		state=$(<"/proc/$process/stat") && place=$(<"/proc/$process/wchan") &&
			[[ ${state##*) } == S* && $place == @(0|*pipe_$way) ]] || return 1
	done
}
# caught PROCESS BIT: it has a handler for the signals of that bit
caught() {
	local mask
	mask=$(sed -n 's/^SigCgt:[[:space:]]*//p' "/proc/$1/status") && ((0x$mask & $2))
}
# taken PROCESS: no signal waits for it
taken() {
	[ "$(grep -cE '^(SigPnd|ShdPnd):[[:space:]]*0*$' "/proc/$1/status")" = 2 ]
}

# gone SIGNAL PROCESS: it has ended. If not, it gets the signal again: one within 0.2 s of the first is the same.
gone() {
	! kill "-$1" "$2"
}

# interrupted SIGNAL STEP OPTIONS...: sends it when the run has come to the step; its exit status
interrupted() {
	local signal=$1 at=$2
	shift 2
	rm -f ./*.interrupted.restart
	# HUP may be ignored by who called this test (nohup).
	env --default-signal=HUP "$TSIM" -in in.paced -log a.log -var out a -var last 700 "$@" >out 2>err &
	local run=$!
	exec 3< <(exec cat pace)
	local reader=$!
	while read -t 60 -r -N 4006 step && ((10#${step:0:4} < at)); do :; done <&3
	[ -n "$step" ] || kill $reader # a run that never opens it must not hang this test
	# who reads is held up for good, since nobody reads on here; then also the run
	[ -z "$again" ] || wait_for blocked write $reader $run || echo "off: $signal: the pipe is never full"
	kill "-$signal" $run
	case $again in
	taken) wait_for taken $run && kill "-$signal" $run ;;
	gone) wait_for gone "$signal" $run ;;
	esac
	cat <&3 >rest
	exec 3<&-
	wait $run
	status=$?
}

"$TSIM" -in in.part -log whole.log -screen none -var out whole -var last 700 2>err
report 'the whole run' $? err

interrupted INT 311
[ $status = 130 ]
report 'INT: exit status' $? err
grep -q 'stopped on request after step 3[0-9][0-9]\>' err
report 'INT: says so' $? err
grep -q '^  read_restart tsim.interrupted.restart' out && grep -q '^  run 700 upto' out
report 'INT: says how to go on' $? out
"$TSIM" -in in.part -log b.log -screen none -var out b -var last 700 \
	-var from tsim.interrupted.restart 2>err
report 'goes on' $? err
for kind in dump contacts bonds cracks; do
	cat {a,b}."$kind" >"parts.$kind"
	same "$kind of both parts" "whole.$kind" "parts.$kind"
done
same 'the state at the end' whole.restart b.restart
rows whole.log >whole.rows
# the parts also show the step between them
rows {a,b}.log | awk 'NR == FNR { shown[$1]; next } $1 in shown && !seen[$1]++' whole.rows - >parts.rows
same 'the tables' whole.rows parts.rows

mkdir logs
interrupted TERM 5 -log logs/log
[ $status = 143 ] && [ -s logs/tsim.interrupted.restart ]
report 'TERM: beside the log' $? err
interrupted HUP 5 -restart-on-signal here
[ $status = 129 ] && [ -s here ] && shows 'read_restart here' out
report 'HUP: in a file of the name given' $? err
interrupted INT 5 -restart-on-signal none
[ $status = 130 ] && ! ls ./*.interrupted.restart 2>/dev/null
report 'no file' $? out
sed -i.all 's/^include/write_restart_on_signal no\n&/' in.paced
interrupted INT 5
[ $status = 130 ] && ! ls ./*.interrupted.restart 2>/dev/null
report 'no file, said in the script' $? out
mv in.paced.all in.paced
interrupted INT 5 -restart-on-signal in.paced/file
[ $status = 130 ] && shows "in.paced/file'" err
report 'a file that cannot be written' $? err
again=gone
interrupted INT 5
[ $status = 130 ] && ! grep -q stopped err && ! ls ./*.interrupted.restart 2>/dev/null
report 'the second signal stops at once' $? err
again=

# USR1: saves and goes on; USR2: saves and stops.
interrupted USR1 311
[ $status = 0 ] && [ -s tsim.interrupted.restart ]
report 'USR1: the run goes on to its end' $? err
grep -q '^Signal USR1: the state at step 3[0-9]* is saved in tsim.interrupted.restart$' out
report 'USR1: says so' $? out
for kind in dump contacts bonds cracks; do
	same "USR1: $kind is that of a run without signal" "whole.$kind" "a.$kind"
done
same 'USR1: so is the state at the end' whole.restart a.restart
"$TSIM" -in in.part -log b.log -screen none -var out b -var last 700 -var from tsim.interrupted.restart 2>err
report 'USR1: the file can be gone on from' $? err
same 'USR1: to the same state' whole.restart b.restart
again=taken
interrupted USR1 5 -restart-on-signal 'step*.restart'
[ $status = 0 ] && [ "$(grep -c '^Signal USR1' out)" = 1 ] && [ "$(echo step[0-9]*.restart | wc -w)" = 1 ]
report 'USR1: two in one step are one; the file is named after the step' $? out
again=
interrupted USR1 5 -restart-on-signal none
[ $status = 0 ] && grep -q '^Signal USR1: nothing is saved\>' out && ! ls ./*.interrupted.restart 2>/dev/null
report 'USR1: no file is named' $? out
interrupted USR1 5 -restart-on-signal in.paced/file
[ $status = 0 ] && grep -q "warning: signal USR1: the state at step [0-9]* is not saved: .*in.paced/file'" out err
report 'USR1: a file that cannot be written is no end' $? out
interrupted USR2 311
[ $status = 140 ] && [ -s tsim.interrupted.restart ] && grep -q '^  run 700 upto' out
report 'USR2: saves and stops' $? out
interrupted USR2 5 -restart-on-signal in.paced/file
[ $status = 1 ] && shows "in.paced/file'" err
report 'USR2: a file that cannot be written' $? err

# Between runs, before there is a box, and with -check.
echo 'kill "-$1" "$(cat pid)"' >send
printf 'shell sh send USR1\nprint early\ninclude in.box\nshell sh send USR1\nshell sh send USR2\nprint late\n' >in.signals
printf 'units si\nregion b block 0 1 0 1 0 1 units box\ncreate_box 1 b\ncreate_atoms 1 single .5 .5 .5 units box\n' >in.box
rm -f tsim.interrupted.restart
sh -c 'echo $$ >pid; exec "$0" -in in.signals -shell yes -log none' "$TSIM" >out 2>err
[ $? = 140 ] && shows 'no simulation box yet' out && shows early out && ! grep -q late out &&
	[ "$(grep -c 'state at step 0 is saved' out)" = 2 ] && [ -s tsim.interrupted.restart ]
report 'between runs' $? out
rm -f tsim.interrupted.restart pid
# it has read the box, and waits for more
ready() {
	[ -s pid ] && caught "$(<pid)" 0x200 && blocked read "$(<pid)"
}
{
	cat in.box
	wait_for ready || touch never
	sh send USR1
	echo 'print "late"'
} | sh -c 'echo $$ >pid; exec "$0" -check -log none' "$TSIM" >out 2>err
[ $? = 0 ] && [ ! -e tsim.interrupted.restart ] && [ ! -e never ]
report '-check goes on and writes nothing' $? err

printf 'label a\njump SELF a\n' >in.loop
timeout -s TERM 0.3 "$TSIM" -in in.loop -log none >out 2>err
shows 'stopped on request' err
report 'a loop of the script without a run' $? err

# soon WHAT MESSAGE: the script on standard input would take for ever, and ends when it is told to
soon() {
	rm -f tsim.interrupted.restart
	cat >in.long
	timeout -k 20 -s INT 0.5 "$TSIM" -in in.long -log none >out 2>err
	[ $? = 124 ] && grep -q "$2" err && [ ! -e tsim.interrupted.restart ]
	report "$1" $? err
}
soon 'a placement that cannot end' 'stopped on request: .* placed, none is made' <<'END'
units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 random 1000000 17 b overlap 0.4 maxtry 1000000000
END
{
	echo 'variable a0 equal random(0,1,17)'
	for k in $(seq 63); do echo "variable a$k equal v_a$((k - 1))+v_a$((k - 1))"; done
	echo 'print "$(v_a63)"'
} >in.formula
soon 'a formula that takes for ever' 'stopped on request in a formula' <in.formula
soon 'an insertion that cannot end' 'fix insert/pack: stopped on request during the search for positions' <<'END'
units si
boundary f f f
region b block 0 1 0 1 0 1 units box
create_box 1 b
region small block 0.2 0.8 0.2 0.8 0.2 0.8 units box
fix one all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.1
fix all all particledistribution/discrete 32452843 1 one 1.0
fix in all insert/pack seed 49979687 distributiontemplate all insert_every once overlapcheck yes &
	maxattempt 1000000 vel constant 0 0 0 region small ntry_mc 2000 volumefraction_region 0.9
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 restitution 0.6
fix i all nve/sphere
timestep 1e-6
run 1
END

# Columns and lists that double 63 times: each variable is evaluated once.
{
	cat <<'END'
units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.25 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.01 density 2500
variable b0 atom x
variable c0 vector [1,2.5]
variable r atom random(0,1,17)
variable same atom v_r-v_r
END
	for k in $(seq 63); do
		echo "variable b$k atom v_b$((k - 1))+v_b$((k - 1))"
		echo "variable c$k vector v_c$((k - 1))+v_c$((k - 1))"
	done
	cat <<'END'
variable v atom v_b63/2^62+v_b62/2^62
velocity all set v_v 0 0
print "is $(vcm(all,x)) $(v_b63[2]/2^62) $(v_c63[2]/2^63) $(v_same[1]!=0)"
END
} >in.columns
timeout -k 5 20 "$TSIM" -in in.columns -log none >out 2>err
grep -qx 'is 1.125 1 2.5 1' out
report 'columns and lists that double 63 times' $? err
soon 'a lattice of many places' 'stopped on request: the lattice' <<'END'
units si
region b block 0 1 0 1 0 1 units box
region far sphere 0.5 0.5 0.5 5 side out units box
region rest intersect 2 b far
lattice sc 0.0012
create_box 1 b
create_atoms 1 region rest
END

# Files without an end: endless WHAT FILE COMMANDS: the lines on standard input, of which the last goes on and on
endless() {
	local file=$2 packed=cat
	cat >head
	case $file in *.gz) packed='gzip -1' ;; esac
	mkfifo "$file"
	{ cat head && yes "$(tail -n 1 head)"; } 2>/dev/null | $packed >"$file" 2>/dev/null &
	soon "$1" "stopped on request while '$file' was read" <<<"$3"
	wait $! 2>/dev/null
}
box='units si
region b block 0 1 0 1 0 1 units box
create_box 1 b'
data='grains

1000000000 atoms
1 atom types
0 1 xlo xhi
0 1 ylo yhi
0 1 zlo zhi

Atoms

1 1 0.01 2500 0.5 0.5 0.5'
endless 'a data file' in.data 'units si
read_data in.data' <<<"$data"
endless 'a compressed data file' data.gz 'units si
read_data data.gz' <<<"$data"
endless 'a mesh' m.stl "$box
fix m all mesh/surface file m.stl type 1" <<<'solid a
facet normal 0 0 1
outer loop
vertex 0 0 0'
frame='ITEM: TIMESTEP
10
ITEM: NUMBER OF ATOMS
1000000000
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ATOMS id type x y z radius
1 1 0.5 0.5 0.5 0.01'
endless 'read_dump' one.dump "$box
read_dump one.dump 10 x y z add yes box no" <<<"$frame"
endless 'rerun' two.dump "$box
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 restitution 0.6
rerun two.dump dump x y z" <<<"$frame"
# a restart file is refused by its first bytes
mkfifo three.restart
yes 'tsim restart' >three.restart 2>/dev/null &
timeout -k 5 20 "$TSIM" -log none <<<'read_restart three.restart' >out 2>&1
grep -q "'three.restart' is not a restart file of tsim" out
report 'an endless restart file' $? out
wait $! 2>/dev/null
finish
