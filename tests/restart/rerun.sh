#!/bin/bash
# rerun and read_dump: what a dump says comes back, forces and computes are computed anew.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

scene='units si
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 random 200 86028157 NULL
set group all diameter 0.07 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 1
neighbor 0.01 bin
timestep 1e-4
fix fall all gravity 9.81 vector 0 0 -1
fix floor all wall/gran zplane 0 NULL
fix move all nve
thermo_style custom step elapsed atoms ke fmax fnorm
thermo 20'
scene=${scene/fix floor all wall\/gran zplane 0 NULL
/}
printf '%s\n' "$scene" 'dump d all custom 20 whole.dump id type x y z vx vy vz fx
dump_modify d format float %.17g
dump a all atom 20 scaled.dump
dump_modify a format float %.17g
run 100' >in.whole
"$TSIM" -in in.whole -log none >whole.out 2>&1
report 'the run' $? whole.out
rows whole.out >whole.rows
printf '%s\n' "$scene" 'velocity all set 7 7 7 units box
dump d all custom 20 again.dump id type x y z vx vy vz fx
dump_modify d format float %.17g
rerun whole.dump dump x y z vx vy vz' >in.again
"$TSIM" -in in.again -log none >again.out 2>&1
report 'the rerun' $? again.out
rows again.out >again.rows
same 'the same table of the log' whole.rows again.rows
same 'the same dump' whole.dump again.dump
shows 'Rerun of 6 frames' again.out
report 'all frames' $? again.out

steps() { # WHAT WORDS STEPS...
	local what=$1
	printf '%s\n' "$scene" "rerun whole.dump $2 dump x y z" >in.some
	shift 2
	"$TSIM" -in in.some -log none >some.out 2>&1
	rows some.out | awk '{ print $1 ":" $2 }' | tr '\n' ' ' >some.steps
	echo -n "$* " >want.steps
	same "$what" want.steps some.steps
}
steps 'first and last' 'first 30 last 80' 40:0 60:20 80:40
steps 'every' 'every 40' 0:0 40:40 80:80
steps 'every behind a first frame of another step' 'first 20 every 40' 20:0 40:20 80:60
steps 'skip' 'skip 2 start 0' 0:0 40:40 80:80
steps 'start before the first frame' 'first 40 start 20' 40:20 60:40 80:60 100:80
shows Elapsed some.out
report 'start: the head of the table' $? some.out

# Averages follow the frames, which begin behind the first sample that the fix waits for, or before it, behind a run.
for begin in '' 'run 60'; do
	printf '%s\n' "$scene" "$begin" 'variable e equal ke' 'fix m all ave/time 20 1 20 v_e file mean' \
		'fix c all ave/time 10 2 20 v_e file pairs' "$begin" "rerun whole.dump first 40 dump x y z vx vy vz" >in.mean
	"$TSIM" -in in.mean -log none >mean.out 2>&1
	report "rerun with averages ($begin)" $? mean.out
	awk '!/^#/ && NF == 2' mean | tail -n 4 >mean.rows
	rows mean.out | awk '$1 >= 40 { print $1, $4 }' | tail -n 4 >mean.want
	awk 'NR == FNR { want[$1] = $2; next } { n++; d = $2 / want[$1] - 1; bad += !(d < 1e-5 && -d < 1e-5) } END { exit bad || n != 4 }' \
		mean.want mean.rows
	report "averages of the frames ($begin)" $? mean.rows mean.want
done

printf '%s\n' "$scene" 'read_dump whole.dump 60 x y z vx vy vz
print "step $(step) ke $(ke:%.8g)"
print "ke $(ke)"' >in.read
sed -i 's/:%.8g//' in.read
"$TSIM" -in in.read -log none >read.out 2>&1
report 'read_dump' $? read.out
grep -q '^step 60 ' read.out
report 'the step is that of the frame' $? read.out
printf '%s\n' 'units si
boundary p p f
region box block 0 3 0 3 0 3 units box
create_box 1 box
read_dump scaled.dump 40 x y z purge yes add yes
print "atoms $(count(all)) box $(lx) x $(xcm(all,x))"
read_dump whole.dump 40 x box no replace yes label x vx
print "x $(xcm(all,x))"' >in.add
"$TSIM" -in in.add -log none >add.out 2>&1
report 'read_dump adds' $? add.out
grep -q '^atoms 200 box 1 ' add.out
report 'all of them, and the box' $? add.out

# One file for each frame: the series is read by number, 20 before 100.
printf '%s\n' "$scene" 'dump d all custom 20 one.*.dump id type x y z vx vy vz fx
dump_modify d format float %.17g
run 100' >in.series
"$TSIM" -in in.series -log none >series.out 2>&1
touch one.last.dump one.1x.dump
printf '%s\n' "$scene" 'velocity all set 7 7 7 units box
rerun one.*.dump post no dump x y z vx vy vz' >in.again
"$TSIM" -in in.again -log none >again.out 2>&1
report 'the series' $? again.out
rows again.out >again.rows
same 'the same table from the series' whole.rows again.rows

wrong() { # WHAT FILE-EDIT LINE TEXT
	sed "$2" whole.dump | head -n 30 >bad.dump
	printf '%s\n' "$scene" "$3" >in.bad
	refused "$1" "$4" -in in.bad
}
small='4s/200/2/; 12,$d'
# Cut anywhere, plain and compressed: the whole frames that are there are taken, and what is missing is said.
printf '%s\n' "$scene" 'dump z all custom 20 whole.dump.gz id type x y z vx vy vz fx
dump_modify z format float %.17g
run 100' >in.gz
"$TSIM" -in in.gz -log none >gz.out 2>&1
zcat whole.dump.gz | cmp - whole.dump
report 'the compressed dump is the same' $?
# torn FILE BYTES PLAIN: PLAIN are the bytes of text in that part of it
torn() {
	head -c "$2" "$1" >"torn.$1"
	printf '%s\n' "$scene" 'velocity all set 7 7 7 units box' "rerun torn.$1 dump x y z vx vy vz" >in.torn
	"$TSIM" -in in.torn -log none >torn.out 2>torn.err
	status=$?
	# a last row without its end does not count
	read -r frames rest < <({ head -c "$3" whole.dump; echo '#'; } | awk '$0 != "#" { rest = 1 } /^ITEM: ATOMS/ { n = 200; next }
		n && !/#$/ { if (!--n) { k++; rest = 0 } } END { print k + 0, rest + 0 }')
	rows torn.out >torn.rows
	if [ "$frames" = 0 ]; then
		[ $status = 1 ] && shows 'has no complete frame' torn.err
	else
		[ $status = 0 ] && head -n "$frames" whole.rows | cmp - torn.rows &&
			{ [ "$rest" = 0 ] || grep -q 'is skipped' torn.out; }
	fi
	report "$1 cut at $2 has $frames frames" $? torn.out
}
size=$(stat -c %s whole.dump)
frame=$((size / 6))
for at in 1 10 100 $((frame - 3)) $((frame + 40)) $((2 * frame)) $((size - 200)) $((size - 3)) $((size - 2)) $((size - 1)); do
	torn whole.dump "$at" "$at"
done
size=$(stat -c %s whole.dump.gz)
for k in 1 2 3 4 5 6 7 8 9; do
	at=$((size * k / 10))
	text=$(head -c "$at" whole.dump.gz | zcat 2>/dev/null | wc -c)
	torn whole.dump.gz "$at" "$text"
done
torn whole.dump.gz $((size - 1)) "$(stat -c %s whole.dump)"
# a run that was killed within a frame and goes on with the same file
head -c $((frame + frame / 2)) whole.dump >on.dump
printf '%s\n' "$scene" 'reset_timestep 40
dump d all custom 20 on.dump id type x y z vx vy vz fx
dump_modify d append yes format float %.17g
run 20' >in.on
"$TSIM" -in in.on -log none >on.out 2>&1
report 'a run goes on with a torn dump' $? on.out
printf '%s\n' "$scene" 'rerun on.dump dump x y z' >in.torn
"$TSIM" -in in.torn -log none >torn.out 2>&1
rows torn.out | awk '{ print $1 }' | tr '\n' ' ' >steps
[ "$(cat steps)" = '0 40 60 ' ] && grep -q "the frame of step 20 is incomplete, it has [0-9]* of 200 rows; it is skipped" torn.out
report 'and what was torn is left out' $? torn.out
# nor a number of which the end is missing, even where nothing else is
awk '/TIMESTEP/ { n++ } n <= 2' whole.dump | head -c -3 >on.dump
"$TSIM" -in in.on -log none >on.out 2>&1
"$TSIM" -in in.torn -log none >torn.out 2>&1
rows torn.out | awk '{ print $1 }' | tr '\n' ' ' >steps
[ "$(cat steps)" = '0 40 60 ' ] && shows "the frame of step 20 is incomplete, it has 199 of 200 rows" torn.out
report 'a cut number is no number' $? torn.out
head -c $((size / 2)) whole.dump.gz >on.dump.gz
sed -i 's/on.dump/on.dump.gz/' in.on
refused 'nothing is added to a torn .gz' "cannot append to 'on.dump.gz': its compressed data are cut off" -in in.on
cp whole.dump.gz on.dump.gz
"$TSIM" -in in.on -log none >on.out 2>&1
report 'a whole one is added to' $? on.out
[ "$(zcat on.dump.gz | grep -c TIMESTEP)" = 8 ]
report 'in a new member' $?

wrong 'no such step' "$small" 'read_dump bad.dump 7 x' "has no frame of step 7"
wrong 'no dump' '1s/.*/something/' 'read_dump bad.dump 0 x' 'bad.dump:1:1: error: expected a line `ITEM: ...`'
wrong 'cut short' '' 'read_dump bad.dump 0 x' "'bad.dump' has no complete frame: it ends before the last row of its first one"
wrong 'count no number' '4s/200/many/' 'read_dump bad.dump 0 x' "bad.dump:4:1: error: the number of particles is 'many'"
wrong 'a row too short' "$small; 11s/ [^ ]* *\$//" 'read_dump bad.dump 0 x' 'a row of 8 words, but there are 9 columns'
wrong 'no such column' "$small" 'read_dump bad.dump 0 omegax' "there is no column for 'omegax'"
wrong 'no number' "$small; 11s/^\([^ ]* [^ ]*\) [^ ]*/\1 west/" 'read_dump bad.dump 0 x' "row 2 has no number for 'x'"
wrong 'no identities' "$small; 9s/ id / di /" 'read_dump bad.dump 0 x' 'there is no column id'
wrong 'the same identity twice' "$small; 11s/^2 /1 /" 'read_dump bad.dump 0 x' 'id 1 occurs twice'
wrong 'the same identity twice, added' "$small; 11s/^2 /1 /" 'read_dump bad.dump 0 x purge yes add yes' 'id 1 occurs twice'
wrong 'identity 0' "$small; 10s/^1 /0 /" 'read_dump bad.dump 0 x' 'row 1 has no valid id'
wrong 'field that cannot be' "$small" 'read_dump bad.dump 0 vol' "'vol'"
wrong 'no file' '' 'rerun nowhere.dump dump x y z' "cannot open 'nowhere.dump'"
wrong 'no series' '' 'rerun nowhere.*.dump dump x y z' "no file with a number for the * of 'nowhere.*.dump'"
wrong 'nothing taken' '' 'rerun bad.dump first 3' "keyword 'dump' is missing"
# Unwrapped positions contain the images: read beside them they do not count twice.
printf '%s\n' "$scene" 'unfix fall' 'velocity all set 900 300 0 units box' 'dump d all custom 5 far.dump id type xu yu zu ix iy iz' \
	'dump_modify d format float %.17g' 'compute m all msd' 'run 0' 'print "moved $(c_m[4])"' 'run 20' 'print "moved $(c_m[4])"' >in.far
sed -i 's/^pair_style.*/pair_style none/; /^pair_coeff/d' in.far
"$TSIM" -in in.far -log none >far.out 2>&1
report 'a run far away' $? far.out
for words in 'x y z ix iy iz' 'ix iy iz x y z' 'x y z'; do
	printf '%s\n' "$scene" 'compute m all msd' 'run 0' "read_dump far.dump 20 $words" 'print "moved $(c_m[4])"' |
		sed 's/^pair_style.*/pair_style none/; /^pair_coeff/d' >in.near
	"$TSIM" -in in.near -log none >near.out 2>&1
	grep ^moved far.out | tail -n 1 >far.moved
	grep ^moved near.out >near.moved
	awk 'NR == FNR { far = $2; next } { d = $2 / far - 1; ok = d < 1e-9 && -d < 1e-9 } END { exit !ok }' far.moved near.moved
	report "read_dump $words of unwrapped positions" $? far.moved near.out
done

# Masses are those of the file, in any order of the words; `replace no` leaves what is there.
printf '%s\n' 'ITEM: TIMESTEP' 50 'ITEM: NUMBER OF ATOMS' 2 'ITEM: BOX BOUNDS pp pp ff' '0 1' '0 1' '0 1' \
	'ITEM: ATOMS id type x y z radius mass' '1 1 0.25 0.5 0.5 0.1 7' '3 1 0.75 0.5 0.5 0.1 7' >two.dump
single='units si
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2500'
for words in 'radius mass' 'mass radius'; do
	prints "$single
read_dump two.dump 50 x y z $words
print \"mass \$(mass(all)) radius \$(radius[1])\"" 'mass 7 radius 0.10000000000000000555'
done
prints "$single
read_dump two.dump 50 x y z replace no add yes
print \"\$(count(all)) particles, x \$(x[1]) \$(x[3])\"" '2 particles, x 0.5 0.75'
prints "$single
read_dump two.dump 50 x y z add yes
print \"\$(count(all)) particles, x \$(x[1]) \$(x[3])\"" '2 particles, x 0.25 0.75'
# -check looks for the files, unless the script writes them.
printf '%s\n' "$single" 'rerun none.dump dump x y z' >in.none
"$TSIM" -check -in in.none >out 2>&1
[ $? = 1 ] && grep -q "none.dump" out
report '-check of a file that is missing' $? out
printf '%s\n' "$single" 'pair_style none' 'dump d all custom 5 made.dump id x y z' 'run 10' 'undump d' 'rerun made.dump dump x y z' \
	'rerun made.*.dump dump x y z' >in.made
"$TSIM" -check -in in.made >out 2>&1
report '-check of files that the script writes' $? out
# Nothing is integrated: a fluid would make a step at each frame, whatever the time between them.
for flow in 'projection cells 4 4 4 viscosity 1 density 1 body_force 1 0 0|the fluid of flow projection (in.flow:7)' \
	'reynolds cells 4 4 lower 0 upper 1 upper_velocity 0 0 -1 viscosity 1 density 1 cavitation jfo transient yes|the fluid in the gap of flow reynolds (in.flow:7)'; do
	printf '%s\n' "$single" "flow_style ${flow%%|*}" 'rerun two.dump dump x y z add yes' >in.flow
	refused 'rerun of a fluid' "would make a time step" -in in.flow
	shows "${flow##*|}" err
	report "rerun: ${flow##*|}" $? err
	refused 'rerun of a fluid, -check' "would make a time step" -check -in in.flow
done
for flow in 'uniform velocity 1 0 0 viscosity 1 density 1' \
	'reynolds cells 4 4 lower 0 upper 1 upper_velocity 0 0 -1 viscosity 1 density 1 open xlo xhi'; do
	prints "$single
flow_style $flow
neighbor 0.01 bin
fix d all drag/stokes
rerun two.dump dump x y z radius mass add yes" 'Rerun of 1 frames'
done
finish
