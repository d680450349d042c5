#!/bin/bash
# What may differ from the script that wrote a restart file, and what may not; files of other versions
# of the format.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
data=$top_srcdir/tests/data

cat >in.part <<END
variable every index 7
variable name index other
variable group index all
include $data/in.older
fix \${name} \${group} vector \${every} ke start 20
write_restart \${out}.restart
END

again() { # OPTIONS...: continues from first.restart
	"$TSIM" -in in.part -log again.log -screen none -var out again -var last 437 \
		-var from first.restart "$@" >out 2>err </dev/null
}
says() { # WHAT TEXT FILE
	shows "$2" "$3"
	report "$1" $? "$3"
}
refused_change() { # WHAT TEXT OPTIONS...
	local what=$1 text=$2
	shift 2
	again "$@"
	[ $? = 1 ]
	report "$what: refused" $? err
	says "$what: says why" "$text" err
	says "$what: says what to do" 'another id to start without that state' err
}

"$TSIM" -in in.part -log none -screen none -var out first -var last 437 2>err
report 'first part' $? err
again
report 'the same again' $? err
! grep -q 'changed since' again.log
report 'nothing is said of changes then' $?
same 'the same file' first.restart again.restart
refused_change 'another interval' \
	"fix other (vector): every is '8' here but '7' in the restart file" -var every 8
says 'the word is shown' 'in.part:5:29: error' err
refused_change 'another group' "fix other (vector): its group is 'chain' here but 'all'" \
	-var name other -var group chain
sed -i.all 's/vector ${every} ke/vector ${every} atoms/' in.part
refused_change 'another value' "values is 'atoms' here but 'ke'"
mv in.part.all in.part
sed -i.all 's/^fix ${name}.*/fix ${name} all ave\/time 1 1 7 ke/' in.part
refused_change 'another style' 'this id is of style vector'
mv in.part.all in.part
again -var name another -var every 8
report 'another id starts afresh' $? err

printf 'read_restart first.restart\npair_style spring/dashpot\nfix g all gravity 9.81 vector 0 0 -1\nrun 0\nrun 0\n' >in.few
"$TSIM" -in in.few -log few.log -screen none 2>err
[ "$(grep -c 'not defined again so far: .*fix other (vector)' few.log)" = 1 ]
report 'what is not used is said once' $? few.log
# Pair and bond styles that are not defined again are those of the file.
cat >in.pair <<'END'
units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 2 single 0.59 0.5 0.5 units box
set group all diameter 0.1 density 1000
set atom 1 vy 0.1
pair_style gran/hertz/history 1e5 NULL 50 NULL 0.5 1
pair_coeff * *
fix go all nve/sphere
timestep 1e-5
run 20
write_restart pair.restart
END
"$TSIM" -in in.pair -log none >out 2>&1
report 'a pair style' $? out
rest='fix go all nve/sphere
run 30
write_dump all custom end.dump id x y z vx vy vz omegax modify format float %.17g'
printf '%s\n' 'read_restart pair.restart' 'pair_style gran/hertz/history 1e5 NULL 50 NULL 0.5 1' "$rest" >in.again
"$TSIM" -in in.again -log none >out 2>&1 && mv end.dump with.dump
report 'it is defined again' $? out
printf '%s\n' 'read_restart pair.restart' "$rest" 'run 0' >in.fewer
"$TSIM" -in in.fewer -log fewer.log -screen none && [ "$(grep -c 'Restoring pair_style gran/hertz/history from the restart file' fewer.log)" = 1 ]
report 'it is not defined again' $? fewer.log
same 'it is that of the file' with.dump end.dump
sed -i 's/^fix go/pair_style none\n&/' in.fewer
"$TSIM" -in in.fewer -log fewer.log -screen none && ! grep 'pair_style.*from the restart file' fewer.log && ! cmp with.dump end.dump >out
report 'pair_style none' $? fewer.log

# what the state does not depend on may change, and the log says so
cat >in.bit <<END
include in.everything
run 20
write_restart \${out}.restart
END
sed 's/^fix bit bit drill.bit 0.05/fix bit bit drill\/bit ${axis}/; s/wob 4.0/wob ${wob}/' \
	"$top_srcdir/tests/decks/in.everything" >in.everything
bit() { # OUT FROM OPTIONS...
	local out=$1 from=$2
	shift 2
	"$TSIM" -in in.bit -log "$out.log" -screen none -var out "$out" -var from "$from" \
		"$@" >out 2>err </dev/null
}
bit bit none -var axis 0.05 -var wob 4.0
report 'first part with a bit' $? err
bit weight bit.restart -var axis 0.05 -var wob 4.5
report 'another weight is allowed' $? err
says 'and noted' 'fix bit (drill/bit), changed since the restart file: wob 4 -> 4.5' weight.log
bit moved bit.restart -var axis 0.051 -var wob 4.0
[ $? = 1 ]
report 'another axis is refused' $? err
says 'and shown' "x is '0.051' here but '0.05' in the restart file" err

# a file of version 1 gives what the program that wrote it would have given
printf 'include %s/in.older\n' "$data" >in.older
"$TSIM" -in in.older -log none -var last 1200 -var from "$data/version1.restart" >out 2>err
report 'version 1' $? err
grep '^RESULT' out | awk -v want="0.0474541945557831 0.0508178721500008 0.000242544910245434 \
0.000246181112057733 0.0507881026835429 0.000491151310745545 2 0 5" '
	{ n = split(want, w, " "); bad = NF != n + 1
	  for (k = 1; k <= n; k++) { d = $(k + 1) - w[k]; bad = bad || d * d > 1e-18 * w[k] * w[k] } }
	END { exit bad || !NR }'
report 'version 1: same results' $? out

# other versions are refused by their numbers, not misread
other_version() { # WHAT TEXT
	printf 'read_restart other\n' >in.read
	refused "$1" "$2" -in in.read
}
LC_ALL=C sed '1s/2/3/' first.restart >other
other_version 'a newer version' "has version 3 of the format, and this program reads versions 1 to 2"
LC_ALL=C sed '1s/2/17/' first.restart >other
other_version 'a much newer version' 'has version 17'
LC_ALL=C sed '1s/2/1/' first.restart >other
other_version 'a new file that says it is old' 'damaged: it has two versions'

# streams of random numbers go on
sed '/^run/,$d' "$data/in.older" >in.begin
cat >in.random <<END
include in.begin
variable push equal 0.01*random(-1,1,8613)
variable kick equal 0.01*normal(0,1,77)
fix push all addforce v_push v_kick 0
run \${then} upto
write_restart \${out}.restart
print "RESULT \$(xcm(all,x):%.17g) \$(xcm(all,y):%.17g) \$(random(0,1,8613):%.17g)"
END
random() {
	local out=$1
	shift
	"$TSIM" -in in.random -log none -var out "$out" "$@" 2>err | grep '^RESULT' >"$out.result"
}
random whole -var then 600
random one -var then 233
random two -var then 600 -var from one.restart
same 'random streams: results' whole.result two.result
same 'random streams: files' whole.restart two.restart

# Files that are written may have other names in the second part, also those of a fix that acts on particles.
sed '/^run/d; s/%20.15g/%.17g/; s/^dump d all custom 100/dump d all custom 10/' "$top_srcdir/tests/rank/scenes/in.sieve" >in.sieve
sieve() { # NAME LINES...
	printf '%s\n' "${@:2}" | cat in.now - >in.sieve_now
	"$TSIM" -in in.sieve_now -log "$1.log" -screen none -var out "$1" 2>err
	report "sieve: $1" $? err
}
for cut in 147 213; do
	cp in.sieve in.now
	sieve whole "run $cut" "run $((400 - cut))"
	sieve front "run $cut" 'write_restart cut.restart'
	grep -Ev '^(units|atom_style|boundary|region|create_|lattice|set|group|velocity)' in.sieve | sed '1i read_restart cut.restart' >in.now
	sieve back "run $((400 - cut))"
	for kind in csv gate dump; do
		{ cat front.$kind && if [ $kind = dump ]; then cat back.dump; else sed 1d back.$kind; fi; } >parts
		same "$kind of a sieve, cut at $cut" whole.$kind parts
	done
	rows whole.log | awk -v cut=$cut 'NF == 18 && $1 > cut' >whole.rows
	rows back.log | awk -v cut=$cut 'NF == 18 && $1 > cut' >back.rows
	same "tables of a sieve, cut at $cut" whole.rows back.rows
done

# Arguments of modes have the same names on each axis: each is compared with its own.
deforms() { # BEFORE NOW: prints the box after the second part
	printf '%s\n' 'units si' 'boundary p p p' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' 'timestep 1e-3' \
		"fix d all deform 1 $1" 'run 100' 'write_restart box.restart' clear 'read_restart box.restart' 'timestep 1e-3' \
		"fix d all deform 1 $2" 'run 100' 'print "box $(lx:%.12g) $(ly:%.12g)"'
}
while read -r sides lx ly; do
	sides=${sides//_/ }
	prints "$(deforms "$sides" "$sides")" "box $lx $ly"
done <<'END'
x_erate_1_y_erate_2 1.2 1.4
x_vel_1_y_vel_2 1.2 1.4
y_vel_2_x_vel_1 1.2 1.4
x_scale_2_y_scale_3 4 9
END
rejects "$(deforms 'x erate 1 y erate 200' 'x erate 1 y erate 1')" "R of y is '1' here but '200'"
shows ':12:38: error' err
report 'the word of that axis is shown' $? err
rejects "$(deforms 'x vel 1 y vel 2' 'x vel 1')" "y is 'not given' here but 'vel'"
rejects "$(deforms 'x vel 1' 'x vel 1 y vel 1')" "y is 'vel' here but 'not given'"
finish
