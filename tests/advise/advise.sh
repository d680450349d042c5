#!/bin/bash
# tsim -advise: what trials cost and change, what is advised, what is refused; nothing of the user's is touched.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

mkdir case tmp
export TMPDIR=$work/tmp
cd case || exit 99

# advise STATUS WORDS... of in.scene
advise() {
	local status=$1
	shift
	"$TSIM" -advise "$@" -in in.scene >../out 2>../err
	[ $? = "$status" ]
}
# row LABEL: the changes of a setting, without times and marks
row() {
	sed -nE "s/^..  ?$1 +[0-9.e+-]+ +[0-9.]+ +//p" ../out
}
# what is not measured
untimed() {
	sed -E 's/^(.{33}).{17}/\1/; s/^[*> ]*//; /^s.time: /,$d; /^all advised settings/d' ../out
}

# An oscillator: velocity Verlet is of second order, so against dt/4 the phase of dt is off by 1 - 1/16 where that
# of dt/2 is off by 1/4 - 1/16: five times as much.
cat >in.scene <<'END'
units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
set atom 1 diameter 0.1 density 2385
fix s all spring/self 493
velocity all set 0.831 0 0
fix i all nve
variable x equal xcm(all,x)
fix slow all ave/time 1 10 10 v_x
thermo_style custom step time ke v_x f_slow cpu
thermo 10
timestep 2.5e-3
dump d all custom 10 d*.txt id x
print "hello" file note.txt
run 240
write_restart there.restart
END
echo mine >note.txt
touch ../before
advise 0 20 at 0 steps 240
report 'a scene is tried' $? ../err
awk '{ sub(/^[*> ]*/, "") } /^present:/ { a = $(NF - 3) } /^timestep 0.00125 / { b = $(NF - 3) }
	END { print "ratio", a / b; exit !(a / b > 4.8 && a / b < 5.2) }' ../out >../ratio
report 'the change of the step is of second order' $? ../ratio
[ "$(row 'timestep 0.000625')" = reference ]
report 'the finest step is the reference' $? ../out
grep -qE '^#: value of a fix with intervals in steps' ../out && grep -qE ' #slow( |$)' ../out
report 'averages over steps are marked' $? ../out
! grep -qE '(Step|Time|CPU)( |$)' ../out
report 'clocks are no columns' $? ../out
[ "$(cat note.txt)" = mine ] && [ "$(find . ../tmp -newer ../before ! -type d)" = '' ]
report 'nothing is written where the user is, nothing left elsewhere' $?
grep -q '^To repeat: -advise at 0 steps 240$' ../out
report 'it says how to repeat it' $? ../out

# grains on a floor: what is exact changes nothing
cat >in.scene <<'END'
units si
boundary p p f
soft_particles yes
newton off
communicate single vel yes
region box block 0 0.03 0 0.03 0 0.05 units box
create_box 1 box
neighbor 0.001 bin
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.52
fix m4 all property/global coefficientFriction peratomtypepair 1 0.48
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix g all gravity 9.81 vector 0.2 0 -1
region seed block 0.003 0.027 0.003 0.027 0.003 0.045 units box
create_atoms 1 random 60 387 seed overlap 0.0052
set type 1 diameter 0.0052 density 2385
fix i all nve/sphere
compute rot all erotate/sphere
thermo_style custom step atoms ke c_rot
thermo 500
timestep ${step}
run 500
run 1500
END
advise 0 20 at 1001 steps 160 -var step 2e-5
report 'grains are tried in the middle of a run' $? ../err
shows 'at step 1001, time 0.02002, in.scene:26: run of 1500 steps, with 60 particles' ../out
report 'where they start is told' $? ../out
here=$(row 'present: 2e-05, 1 thread')
[ -n "$here" ] && [ "$(row 'neighbor 0.0005 bin')" = "$here" ] && [ "$(row 'neighbor 0.002 bin')" = "$here" ]
report 'the skin changes nothing' $? ../out
[ "$(getconf _NPROCESSORS_ONLN)" = 1 ] || [ "$(row '-threads 2')" = "$here" ]
report 'nor do threads' $? ../out
[ -n "$(row 'tangential no_history')" ] && [ "$(row 'tangential no_history')" != "$here" ]
report 'the law does' $? ../out
[ -n "$(row 'model hooke')" ]
report 'a velocity that hooke needs is made up' $? ../out
untimed >../first
advise 0 20 at 1001 steps 160 -var step 2e-5
untimed >../second
same 'the same again, but for the times' ../first ../second
advise 0 2 -var step 2e-5
shows 'in.scene:26: run of 1500 steps' ../out
report 'a short script is tried where most is done' $? ../out

# nothing touches: no advice about laws of contacts, whatever the times
sed -e 's/^create_atoms.*/create_atoms 1 single 0.01 0.01 0.04 units box\ncreate_atoms 1 single 0.02 0.02 0.04 units box/; s/${step}/2e-5/' \
	-e '/^run/d; /^fix g /d' in.scene >in.apart
mv in.scene in.kept
{ cat in.apart; echo 'run 2000'; } >in.scene
advise 0 5 at 0 steps 160
grep -q '^contact laws: not decided, no contacts' ../out && ! grep -qE '^(model|tangential|rolling_friction).*: cost ' ../out
report 'laws of contacts without contacts are not decided' $? ../out
! grep -qE '^  ?>' ../out
report 'nothing is advised from trials of milliseconds' $? ../out
mv in.kept in.scene

# what the script counts in steps stands for the same time with another step
cp in.scene in.grains
sed -e '/^create_atoms/d; /^set type/d; /^run/d; /^variable/d' -e 's/${step}/2e-5/' in.grains >in.scene
cat >>in.scene <<'END'
fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.0014
fix p2 all particledistribution/discrete 15485867 1 p1 1.0
fix ins all insert/rate/region seed 32452843 distributiontemplate p2 nparticles 900 particlerate 4000 insert_every 120 overlapcheck yes all_in yes vel constant 0 0 -1.4 region seed
run 2400
END
advise 0 20 at 300 steps 960
report 'particles come in during the trials' $? ../err
[ "$(row 'timestep 1e-05' | awk '{ print $1 }')" = 0 ] && [ "$(row 'timestep 4e-05' | awk '{ print $1 }')" = 0 ]
report 'as many with each step' $? ../out
grep -q '^intervals in steps, .*: ins insert_every$' ../out
report 'it says what was changed' $? ../out
mv in.grains in.scene

# refusals
"$TSIM" -advise >../out 2>../err
[ $? = 2 ] && shows '-advise needs a script: -in FILE' ../err
report 'no script' $? ../err
advise 2 twenty && shows twenty ../err
report 'a wrong time' $? ../err
advise 2 60 tolerence 0.1 && shows "did you mean 'tolerance'" ../err
report 'a wrong word' $? ../err
advise 1 at 7777 -var step 2e-5 && shows 'no run that continues after step 7777' ../err
report 'a step that does not come' $? ../err
advise 1 -var step 2e-5x && grep -q '^in.scene:24:10: error: ' ../err && [ ! -s ../out ]
report 'an error of the scene' $? ../err
sed -i '/^run/d' in.scene
advise 1 -var step 2e-5 && shows 'runs no time steps' ../err
report 'a scene that runs nothing' $? ../err
# columns that do not change say nothing
cat >in.scene <<'END'
units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 6 6 6 viscosity 1 density 1 body_force 1 0 0
thermo_style custom step ${column}
timestep 1e-4
run 200
END
for column in atoms flow_px; do
	advise 0 2 -var column $column
	shows 'No column changes in the trials' ../out
	[ $? = "$([ $column = atoms ] && echo 0 || echo 1)" ]
	report "columns that do not change: $column" $? ../out
done
finish
