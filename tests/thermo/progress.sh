#!/bin/bash
# The progress line of a terminal: where it is shown, its width, that nothing is left of it; estimated durations.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

scene='units si
atom_style granular
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 mass 2.385
velocity all set 0.001 0 0 units box
fix move all nve/sphere
timestep 1e-9
fix enough all halt 100 tlimit > 1.4 message no
'
printf '%s\n' "$scene" 'run 1000000000' >in.long
printf '%s\n' "$scene" 'unfix enough' 'run 2000000' >in.short
grep -v '^fix enough' in.long >in.endless

# what is in files and pipes
"$TSIM" -in in.long -log log -progress 0 >out
report 'to a file' $? out
! grep -q "$(printf '[\r\033]')\|steps/s, .* left" out log
report 'a file has no progress line' $? out
grep -q '^Estimated duration of this run: .*[0-9] steps/s$' out && grep -q '^Estimated duration' log
report 'a long run tells its duration' $? out
"$TSIM" -in in.short -log none >out
! grep -q Estimated out
report 'a short one does not' $? out

for wrong in soon -1 ''; do
	"$TSIM" -progress "$wrong" 2>err
	[ $? = 2 ] && grep -q 'needs SECONDS\|expected seconds >= 0 or none after -progress' err
	report "refused: -progress $wrong" $? err
done

has python3 || finish
terminal() { # COLUMNS interrupt|wait ARGUMENTS: what the terminal gets in `out`, progress lines in `lines`
	python3 "$top_srcdir/tests/terminal.py" "$1" "$2" "$TSIM" -log none "${@:3}" >out
	status=$?
	tr '\r' '\n' <out | sed 's/\x1b\[K//g' >lines
}
PROGRESS='^[0-9.]+ %.*, [0-9.]+( [kMG])? steps/s, [0-9.]+( [kMG])? particle-steps/s, [^,]* left$'

terminal 100 wait -in in.long -progress 0
[ $status = 0 ] && [ "$(grep -cE "$PROGRESS" lines)" -ge 2 ]
report 'on a terminal' $? lines
grep -q 'of 1000000000, ' lines
report 'the step and the last one' $? lines
# each line but the erasure of the last is followed by CR and the code that clears the line
! grep -aE 'steps/s' out | tr '\r' '\n' | grep -aE '^[0-9.]+ %.*left.+'
report 'erased before other output' $? out
sed -n '/^Loop time/,$p' out | grep -q '%' && ! sed -n '/^Loop time/,$p' out | grep -q 'left'
report 'nothing after the run' $? out

terminal 40 wait -in in.long -progress 0
[ "$(grep -c '%.* left$' lines)" -ge 2 ] && ! grep -E ' left$' lines | grep -qE '.{40}|particle'
report 'as wide as the terminal' $? lines
for silence in '-progress none' '-progress 30' '' '-screen none'; do
	# shellcheck disable=SC2086
	terminal 100 wait -in in.long $silence
	[ $status = 0 ] && ! grep -q ' left$' lines
	report "silent: $silence" $? lines
done

terminal 100 interrupt -in in.endless -progress 0 -restart-on-signal none
[ $status = 130 ] && grep -q 'stopped on request' lines && ! grep -q 'left.*stopped' out
report 'Ctrl-C' $? lines

# a run in parts is one
{
	sed '/^fix enough/d' <<<"$scene"
	echo 'run 2000000 post no every 10000 "variable a equal step"'
} >in.parts
terminal 100 wait -in in.parts -progress 0
[ $status = 0 ] && grep -q 'of 2000000, .* left$' lines && ! grep -q ' of [0-9]\{1,6\}, ' lines
report 'run every' $? lines

# without particles, and frames of unknown number
printf '%s\n' 'units si' 'region b block 0 1 0 1 0 1 units box' 'create_box 1 b' 'timestep 1e-3' \
	'fluid' 'run 1000' >in.flow
sed -i 's|^fluid$|flow_style projection cells 12 12 12 viscosity 0.1 density 1000|' in.flow
terminal 100 wait -in in.flow -progress 0
[ $status = 0 ] && grep -q '^[0-9.]* %, step .* steps/s, .* left$' lines && ! grep -q particle-steps lines
report 'a flow alone' $? lines
printf '%s\n' "$scene" 'dump d all atom 1 frames' 'run 4000' 'undump d' 'rerun frames dump x y z' \
	'print "after the rerun"' >in.rerun
terminal 100 wait -in in.rerun -progress 0
[ $status = 0 ] && sed -n '/^Loop/,$p' lines | grep -q '^step [0-9]*, .*steps/s'
report 'rerun' $? lines
finish
