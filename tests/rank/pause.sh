#!/bin/bash
# Runs that follow each other on several ranks go on with the lists that each rank has; a command or a formula that may read more
# gets all particles and contacts. Output and files are those of one rank.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1
grep -v '^run' "$top_srcdir/tests/rank/scenes/in.bed" >in.start

# told FILE: what the program prints, without times and counts of ranks
told() {
	grep -vE '^(Loop|Nlocal|Nghost|Neigh|Ranks|Of the first|Estimated duration)|ns per particle|time \(%\)|^$' "$1"
}

# same_on NAME RANKS...: in.NAME tells and writes the same on each of these numbers of ranks as on one
same_on() {
	local name=$1 n
	shift
	"$TSIM" -in "in.$name" -log none -progress none -var out one >one.out 2>&1
	report "$name runs alone" $? one.out
	told one.out >one.told
	for n in "$@"; do
		rm -f many.*
		on_ranks "$n" "$TSIM" -in "in.$name" -log none -progress none -var out many >many.out 2>&1 </dev/null
		report "$name runs on $n ranks" $? many.out
		told many.out >many.told
		for file in told dump mean forces; do
			[ ! -f "one.$file" ] || same "$name: $file on $n ranks" "one.$file" "many.$file"
		done
	done
	rm -f one.*
}

# listed N...: how often the contacts of all particles were gathered in each run
listed() {
	grep -o 'times, [0-9]* of them with contacts' many.out | awk '{ print $2 }' | tr '\n' ' ' >listed
	printf '%s ' "$@" | cmp - listed
	report "contacts gathered in each run: $*" $? listed
}

# Lines that read no particles come between runs, also in a loop, as pieces of one run, and without set-up.
{
	cat in.start
	cat <<'END'
variable i loop 3
label again
run 40
print "step $(step) time $(time) i $i"
next i
jump SELF again
variable far equal step>150
if "${far} == 0" then "run 5" else "run 7"
run 20 every 10 "print 'at $(step) ke $(ke) mass $(mass(low))'"
run 30 pre no
include in.more
run 200 upto
END
} >in.lines
echo 'log none append
run 3' >in.more
same_on lines 2 3 7
listed 0 0 0 0 0 0 0 0 0

# Each of these lines reads or changes particles, contacts or settings; the runs behind it go on as on one rank.
between() {
	cat in.start
	echo "run 40"
	for line in "$@"; do
		printf '%s\nrun 15\nrun 15\n' "$line"
	done
}
between 'print "$(ke) $(count(all)) $(press)"' 'print "$(c_er) $(vx[17])"' 'variable top equal bound(all,zmax)' 'print "${top}"' \
	'set type 1 density 2600' 'velocity low set 0 0 0 units box' 'timestep 1.9e-5' 'run 0' >in.reads
same_on reads 2 3
between 'delete_atoms group low' 'unfix mean
reset_timestep 0 time $(time)' 'neighbor 0.0012 bin' 'fix w5 all wall/gran model hertz tangential history primitive type 1 zplane 0.05' 'unfix drag' \
	'compute late all pair/local force
compute n all reduce sum c_late
print "late $(c_n)"' 'dump f all local 10 ${out}.forces c_late' 'undump f' 'uncompute n' 'uncompute late' >in.changes
same_on changes 2 3

# A restart file between two runs, and files that are read again.
{ between 'write_restart ${out}.restart' 'write_data ${out}.data'; printf 'print "$(press)"\n'; } >in.writes
same_on writes 2 3
on_ranks 2 "$TSIM" -in in.writes -log none -screen none -var out two >out 2>&1 </dev/null
{ sed '/^units/!d' in.start; printf 'read_restart ${out}.restart\n'; sed -n '/^fix m1/,$p' in.start; echo 'run 60'; } >in.again
"$TSIM" -in in.again -log none -screen none -var out two >out 2>&1
report 'the restart file of two ranks between two runs is read by one' $? out
mv two.dump again.two
"$TSIM" -in in.writes -log none -screen none -var out one >out 2>&1 && "$TSIM" -in in.again -log none -screen none -var out one >out 2>&1
report 'that of one, too' $? out
same 'both go on alike' one.dump again.two
rm -f one.*

{ cat in.start; printf 'run 10\nclear\n'; sed 's/^dump/#/' in.start; printf 'run 10\nrun 10\n'; } >in.cleared
same_on cleared 2

# All ranks read a restart file in pieces: one that is cut off or changed is refused as by one rank, and a pipe is read once.
printf 'units si\nread_restart ${file}\nprint "$(ke) $(atoms)"\n' >in.pieces
head -c 30000 two.restart >cut.restart
cp two.restart changed.restart
printf 'zzzz' | dd of=changed.restart bs=1 seek=60000 conv=notrunc 2>dd.err
"$TSIM" -in in.pieces -log none -var file two.restart 2>&1 | tail -1 >whole.told
for file in cut changed; do
	"$TSIM" -in in.pieces -log none -var file "$file.restart" 2>&1 | grep '^in.pieces.*error' >one.told
	on_ranks 2 "$TSIM" -in in.pieces -log none -var file "$file.restart" 2>&1 </dev/null | grep '^in.pieces.*error' >many.told
	[ -s one.told ] && cmp one.told many.told
	report "two ranks refuse a $file restart file as one does" $? many.told
done
mkfifo pipe.restart
cat two.restart >pipe.restart &
on_ranks 2 "$TSIM" -in in.pieces -log none -var file pipe.restart </dev/null 2>&1 | tail -1 >many.told
wait
same 'two ranks read a restart file from a pipe' whole.told many.told
rm -f one.* many.*

# Errors behind a run, and a run that is the last line.
{ cat in.start; printf 'run 10\nrun 10 start 99\n'; } >in.wrong
on_ranks 2 "$TSIM" -in in.wrong -log none -var out many >out 2>&1 </dev/null
[ $? -ne 0 ] && grep -q '^in.wrong:.*error: run: start must not be after' out
report 'an error after a run' $? out
finish
