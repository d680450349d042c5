#!/bin/bash
# A run that goes wrong says why and leaves whole what was written before; files that cannot be read
# or written are errors.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box'
# two balls roll towards each other over a floor
balls="$box
create_atoms 1 single 0.3 0.5 0.1 units box
create_atoms 1 single 0.7 0.5 0.1 units box
set group all diameter 0.2 density 1000
set atom 1 vx 1.5
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 restitution 0.5
fix move all nve
timestep 1e-4
thermo 100"

# stops WHAT SCRIPT TEXTS...: exit status 1 and a message with all the texts
stops() {
	local what=$1 ok=0
	printf '%s\n' "$2" >in.script
	shift 2
	"$TSIM" -in in.script -log log.tsim >out 2>err </dev/null
	[ $? = 1 ] || ok=1
	for text in "$@"; do
		shows "$text" err || { ok=1; echo "missing: $text"; }
	done
	tail -n 3 log.tsim | grep -qF 'error: ' || ok=1
	report "$what" $ok err
}

# frames FILE N: N whole frames, each with the rows it promises
frames() {
	awk -v want="$2" '
		/^ITEM: TIMESTEP/ { if (left) bad = 1; n++ }
		/^ITEM: NUMBER/ { getline; rows = $1 }
		/^ITEM: ATOMS/ { left = rows; columns = NF - 2; next }
		left && !/^ITEM/ { if (NF != columns) bad = 1; left-- }
		END { exit bad || left || n != want }' "$1"
	report "$1 has $2 whole frames" $? "$1"
}

stops 'a lost particle' "$balls
set atom 2 vx 2.385
set atom 2 vy 0.1
thermo_modify lost error
dump d all custom 50 lost.dump id x y z vx
run 5000" 'particle 2 (type 1) left the box through its fixed face xhi at step 1258' \
	'position (1.00003 ' 'velocity (2.385 ' 'last contacts: none' 'no wall stands at that face'
frames lost.dump 26
grep -qE '^ +1200 ' log.tsim
report 'the table up to there' $?

stops 'an overlap at the start' "$box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.5 0.51 0.5 units box
set group all diameter 0.2 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 1e9 restitution 0.9
fix move all nve
timestep 7e-5
thermo 1
dump d all custom 1 overlap.dump id x y z
run 100" 'moves more than its radius in one step at step ' 'last contacts: particle 2 (force' \
	'the time step is too large for the stiffness, or particles overlapped'
frames overlap.dump "$(awk '/^ITEM: TIMESTEP/ { n++ } END { print n + 0 }' overlap.dump)"
[ -s overlap.dump ]
report 'what came before is there' $?

stops 'a force that is too large' "$balls
variable push equal 1e9*(step>=300)
fix push all addforce v_push 0 0
dump d all custom 100 push.dump id x y z
run 1000" 'moves more than its radius' 'a force or a velocity that was set is too large'
frames push.dump 4

stops 'a number that is none' "$balls
variable push equal ln(300-step)
fix push all addforce v_push 0 0
dump d all custom 100 nan.dump id x y z
run 1000" 'ln is infinite' "needed by in.script:15"
frames nan.dump 3

# refused before anything is written; limit 2/omega0 with k/m* = 1e4/2.0944
stops 'a step beyond the limit' "$balls
pair_coeff * * stiffness 1e4 damping 0
timestep 0.0295
dump d all custom 10 beyond.dump id x y z
run 100" 'a contact of types 1 and 1' '0.0289441'
[ ! -s beyond.dump ] && ! grep -q '^ *Step' log.tsim
report 'nothing is written then' $?
printf '%s\n' "$balls" 'pair_coeff * * stiffness 1e4 damping 0' 'timestep 0.0285' 'run 1' >in.script
"$TSIM" -in in.script -log none >out 2>err
report 'just below the limit it runs' $? err

# files
refused 'no script' 'No such file' -in nowhere
refused 'a folder as script' 'Is a directory' -in .
printf 'include nowhere\n' >in.script
refused 'no included script' "cannot open script 'nowhere'" -in in.script
RANDOM=20231
noise=
for ((k = 0; k < 3000; k++)); do
	printf -v byte '\\x%02x' $((RANDOM & 255))
	noise+=$byte
done
# shellcheck disable=SC2059
printf "$noise" >in.script
"$TSIM" -in in.script -log none >out 2>err
[ $? = 1 ] && shows 'error: ' err
report 'noise as script' $?
printf 'print "no end\n' >in.script
refused 'a quote without end' 'quote' -in in.script
printf 'print a &\n' >in.script
"$TSIM" -in in.script -log none >out 2>err
[ $? -le 1 ]
report 'a line that goes on after the end' $? err
printf 'if 1 == 1 then "print a" else\n' >in.script
"$TSIM" -in in.script -log none >out 2>err
[ $? -le 1 ]
report 'an else without command' $? err

ln -s /dev/full full
ln -s /dev/full full.gz
mkfifo pipe
compute='compute k all ke'
bad_target() { # TARGET REASON
	stops "dump to $1" "$balls
dump d all custom 10 $1 id x y z
run 100" 'in.script:14:' "$2"
	stops "thermo_log to $1" "$balls
thermo_log $1
run 100" 'in.script:14:1' "$2"
	stops "averages to $1" "$balls
$compute
fix a all ave/time 5 2 10 c_k file $1
run 100" 'in.script:15:36' "$2"
	stops "broken bonds to $1" "$balls
bond_style contact
bond_coeff 1 stiffness 1e4 ultimate 1e-9
create_bonds single/bond 1 1 2
fix a all bond/breakage file $1
run 2000" 'in.script:17:30' "$2"
}
bad_target full 'No space left'
bad_target pipe/file "pipe/file'"
bad_target . 'Is a directory'
stops 'gz dump without room' "$balls
dump d all custom 10 full.gz id x y z
run 4000" 'in.script:14'
for target in full in.script/file .; do
	"$TSIM" -in in.script -log $target >out 2>err </dev/null
	[ $? = 1 ] && shows "log file" err
	report "log to $target" $? err
done
# a restart file is renamed into place, which a device or a pipe would not survive
stops 'restart to a pipe' "$balls
run 1
write_restart pipe" 'in.script:15:1' "'pipe': it is not a regular file"
[ -p pipe ]
report 'the pipe is still one' $?
stops 'restart to a folder' "$balls
run 1
write_restart ." 'in.script:15:1' "'.': it is not a regular file"
stops 'restart below a pipe' "$balls
run 1
write_restart pipe/file" 'in.script:15:1' "pipe/file'"
# the temporary file is a new one: a link that lies in wait is not followed
echo precious >precious
cat >in.script <<<"$balls
run 1
write_restart whole.restart"
bash -c 'ln -s precious whole.restart.tmp.$$; exec "$TSIM" -in in.script -log none -screen none' 2>err
[ $? = 0 ] && [ "$(cat precious)" = precious ] && [ -f whole.restart ] && [ ! -L whole.restart ]
report 'a link in the place of the temporary file' $? err
rm -f whole.restart*

# inputs that unfold, and lines, are bounded
{ echo '# title'; head -c 3000000 /dev/zero | tr '\0' '\n'; } | gzip >bomb.gz
{ echo 'ITEM: TIMESTEP'; head -c 30000 /dev/zero | tr '\0' 7; } >long
{ printf 'units si\nprint "'; head -c 30000 /dev/zero | tr '\0' x; echo '"'; } >in.long
printf 'read_data bomb.gz\n' >in.script
refused 'a file that unfolds' "'bomb.gz' unfolds to more than 0.002 GB" -in in.script -input-limit 0.002
printf '%s\n' "$balls" 'read_dump bomb.gz 0 x' >in.script
refused 'a dump that unfolds' "'bomb.gz' unfolds to more than 0.002 GB" -in in.script -input-limit 0.002
printf '%s\n' "$balls" 'fix m all mesh/surface file bomb.stl.gz type 1' >in.script
cp bomb.gz bomb.stl.gz
refused 'a mesh that unfolds' "'bomb.stl.gz' unfolds to more than 0.002 GB" -in in.script -input-limit 0.002
printf '%s\n' "$balls" 'read_dump long 0 x' >in.script
refused 'a long line of a dump' 'the line has more than 20000 bytes' -in in.script -input-limit 0.02
refused 'a long line of a script' 'the line has more than 20000 bytes' -in in.long -input-limit 0.02
printf 'variable f file long\nnext f\n' >in.script
refused 'a long line of a file variable' 'the line has more than 20000 bytes' -in in.script -input-limit 0.02
"$TSIM" -in in.long -log none -screen none -input-limit 0.04 2>err
report 'the limit can be raised' $? err
"$TSIM" -in in.long -input-limit none >out 2>err
[ $? = 2 ] && shows 'number of GB' err
report 'the limit is a number' $? err
stops 'restart during a run' "$balls
dump save all restart 10 pipe
run 100" 'in.script:14:15' 'not a regular file'
"$TSIM" -in in.script -log none >full 2>err </dev/null
[ $? = 1 ]
report 'a full screen' $? err
# two styles, one file
for lines in 'fix a all ave/time 1 1 10 ke file one
fix b all ave/time 1 1 10 ke file ./one' 'dump a all custom 10 one id x
dump b all custom 20 one id y' 'fix a all print 10 "$(ke)" file one screen no
dump b all custom 20 one id y' 'fix a all print 10 "$(ke)" file one screen no
fix b all print 10 "$(step)" append one screen no'; do
	stops 'one file of two styles' "$balls
$lines
run 100" "writes to 'one', and so does"
	refused 'one file of two styles, -check' "writes to 'one', and so does" -check -in in.script
done
# frames of two dumps, one collection
stops 'one collection of two dumps' "$balls
dump a all custom/vtk 10 frames*.vtp id
dump b all custom/vtk 20 ./frames*.vtu id
run 100" "dump b lists its frames 'frames*.vtu' in a collection (.pvd), and dump a"
printf '%s\n' "$balls" 'fix a all print 10 "a $(step)" append one screen no' 'fix b all print 10 "b $(step)" append one screen no' \
	'dump c all custom 10 /dev/null id' 'dump d all custom 10 /dev/null id' 'run 20' >in.shared
rm -f one
"$TSIM" -in in.shared -log none >out 2>&1 && [ "$(grep '^[ab] ' one)" = "$(printf 'a 10\nb 10\na 20\nb 20')" ]
report 'two that append to one file' $? out
if [ "$(id -u)" != 0 ]; then
	mkdir closed && chmod a-w closed
	stops 'a closed folder' "$balls
dump d all custom 10 closed/dump id x y z
run 100" 'Permission denied'
fi
finish
