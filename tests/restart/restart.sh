#!/bin/bash
# A run cut by restart files is the whole run, byte for byte; a run cut in the script too; damaged
# files are refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.part <<END
include $top_srcdir/tests/decks/in.everything
run \${last} upto
if "\${last} == 700" then 'print "slope \$(v_slope:%.17g)"'
write_restart \${out}.restart
END
part() { # NAME LAST FROM
	"$TSIM" -in in.part -log "$1.log" -screen none -var out "$1" -var last "$2" -var from "$3" 2>err
	report "part $1" $? err
}

part whole 700 none
# odd cuts, none of them a multiple of an interval; the second part starts before the averages
part a 1 none
part b 301 a.restart
part c 433 b.restart
part d 700 c.restart
for kind in dump contacts bonds cracks; do
	cat {a,b,c,d}."$kind" >"parts.$kind" 2>missing # where a part wrote no frame
	same "$kind of the parts" "whole.$kind" "parts.$kind"
done
same 'restart files at the end' whole.restart d.restart
grep '^slope' whole.log >whole.slope
grep '^slope' d.log >parts.slope
same 'slope of a series' whole.slope parts.slope
rows whole.log >whole.rows
rows {a,b,c,d}.log | grep -vE '^ +(1|301|433) ' >parts.rows
same 'tables' whole.rows parts.rows
# where a part begins it shows again what the part before showed at its end
for cut in 'a b 1' 'b c 301' 'c d 433'; do
	set -- $cut
	rows "$1.log" | grep -E "^ +$3 " >before
	rows "$2.log" | grep -E "^ +$3 " >after
	same "step $3 seen from both sides" before after
done

# read and written again at once, nothing is lost
sed 's/^run.*/run 0/' in.part >in.again
"$TSIM" -in in.again -log none -screen none -var out again -var last 0 -var from b.restart 2>err
report 'read and written' $? err
same 'read and written gives the same file' b.restart again.restart

# cut in one script
for cut in 'run 200' 'run 100\nrun 100' 'run 200 every 37 NULL' 'run 71\nrun 0\nrun 129'; do
	printf "include $top_srcdir/tests/decks/in.everything\n$cut\nwrite_restart now.restart\n" >in.cuts
	"$TSIM" -in in.cuts -log cuts.log -screen none -var out cuts 2>err
	report "runs: $cut" $? err
	[ -e first.restart ] || mv now.restart first.restart
	[ -e now.restart ] && same "$cut = run 200" first.restart now.restart
	mv cuts.dump now.dump
	[ -e first.dump ] || mv now.dump first.dump
	[ -e now.dump ] && same "dump, $cut = run 200" first.dump now.dump
done

# restart command: the same files, in turn, during the run
sed "s/^run.*/restart 100 turn1 turn2\nrun 300/" in.part >in.turn
"$TSIM" -in in.turn -log none -screen none -var out turn 2>err
report 'restart in turn' $? err
sed 's/^run.*/run 700 upto/' in.part >in.from
"$TSIM" -in in.from -log none -screen none -var out from -var from turn1 2>err
report 'continues from a file written within a run' $? err
same 'from a file written within a run' whole.restart from.restart

# other settings: computed anew, from the same state
sed 's/^run.*/timestep 1.0e-5\nrun 50\ntimestep 3.1e-5/' in.part >in.other
"$TSIM" -in in.other -log none -screen none -var out other -var from b.restart 2>err
report 'another step after a restart' $? err

# damage: every kind is refused with a reason and changes nothing
size=$(stat -c %s b.restart)
refused_file() {
	printf 'read_restart %s\nprint reached\n' "$2" >in.read
	refused "$1" "$3" -in in.read
	! grep -q reached out
	report "$1: stops" $? out
}
for at in 20 60 $((size / 3)) $((size / 2)) $((size - 40)) $((size - 2)); do
	cp b.restart bad
	byte=$(od -An -tu1 -j $at -N 1 bad)
	printf "\\$(printf %o $(((byte + 77) % 256)))" | dd of=bad bs=1 seek=$at conv=notrunc 2>/dev/null
	refused_file "byte $at changed" bad "restart file 'bad'"
done
for length in 0 10 30 $((size / 2)) $((size - 1)); do
	head -c "$length" b.restart >bad
	refused_file "cut to $length bytes" bad "restart file 'bad'"
done
cat b.restart b.restart >bad
refused_file 'twice in one file' bad 'there are data after its end'
cp in.part bad
refused_file 'another file' bad 'not a restart file of tsim'
refused_file 'no file' nowhere 'No such file'
refused_file 'a folder' . 'Is a directory'
printf 'units cgs\nread_restart b.restart\n' >in.read
refused 'other units' 'units si, but the script says units cgs' -in in.read
printf 'region a block 0 1 0 1 0 1\ncreate_box 1 a\nread_restart b.restart\n' >in.read
refused 'box already there' 'before create_box' -in in.read

# an old file stays whole if a new one cannot be written
cp b.restart kept
printf 'read_restart kept\nwrite_restart kept\n' >in.full
(
	ulimit -f 8 # blocks of 1024 bytes
	trap '' XFSZ
	refused 'no room' "'kept" -in in.full
	exit $failed
)
report 'a full disk is an error' $? err
same 'the old file is kept' b.restart kept
[ "$(echo kept*)" = kept ]
report 'nothing half-written is left' $?
# 100 000 variables are found again in the time of as many, not of its square.
awk 'BEGIN { for (k = 0; k < 100000; k++) print "variable v" k " once " k "+0.5" }' >many
printf 'units si\nregion b block 0 1 0 1 0 1 units box\ncreate_box 1 b\ninclude many\nwrite_restart many.restart\n' >in.many
"$TSIM" -in in.many -log none >/dev/null 2>err
sed -i 's/+0.5$/+0.25/; s/^variable v99998 .*/variable v99998 once 99998+0.5/' many
printf 'read_restart many.restart\ninclude many\nprint "is $(v_v99998) $(v_v99999)"\n' >in.again
timeout 12 "$TSIM" -in in.again -log none >out 2>err
grep -qx 'is 99998.5 99999.25' out
report 'many variables after a restart' $? err
finish
