#!/bin/bash
# No particle is moved by two fixes: the run is refused, whatever the order. By a fix and with its rigid body: a
# finding of the review, for LIGGGHTS and LAMMPS run it, too.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

start='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.3 0.5 0.15 units box
create_atoms 2 single 0.6 0.5 0.15 units box
set group all diameter 0.2 density 1000
group one type 1
group two type 2
group none empty
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 damping 0
timestep 1e-4'

# twice LINES TEXT: refused by the run and by -check
twice() {
	printf '%s\n' "$start" "$1" 'run 10' >in.script
	refused "twice: $1" "$2" -in in.script
	"$TSIM" -check -in in.script >out 2>&1 </dev/null
	[ $? = 1 ] && shows "$2" out
	report "-check: $1" $? out
}
# once LINES: runs, and passes -check
once() {
	printf '%s\n' "$start" "$1" 'run 10' >in.script
	"$TSIM" -in in.script -log none -screen none >out 2>&1 </dev/null && "$TSIM" -check -in in.script >out 2>&1 </dev/null
	report "once: $1" $? out
}

for pair in 'nve nve/sphere' 'nve/sphere nve' 'nve nve/noforce' 'nve/euler nve/symplectic' \
	'nve/sphere nve/limit|radius_ratio|0.1' 'nve move|linear|0.1|0|0' 'move|linear|0.1|0|0 nve'; do
	read -r first second <<<"$pair"
	twice "fix a all ${first//|/ }
fix b all ${second//|/ }" "fix b (${second%%|*}) moves particle 1 (type 1), which fix a (${first%%|*}, in.script:14) moves, too"
	once "fix a one ${first//|/ }
fix b two ${second//|/ }"
done
twice 'fix a two nve
fix b all nve/sphere' 'moves particle 2 (type 2), which fix a (nve, in.script:14)'
twice 'review error
fix a all rigid single
fix b all nve/sphere' 'fix b (nve/sphere) integrates particle 1, a member of a rigid body'
twice 'review error
fix b two nve
fix a all rigid single' 'fix b (nve) integrates particle 2, a member of a rigid body'
once 'fix a all rigid single
fix b all nve/sphere'
shows 'review: members' out
report 'told by default' $? out
once 'fix a one rigid single
fix b two nve'
once 'fix a all nve
fix b one freeze'
once 'fix a all nve
fix b none nve/sphere'
once 'fix a all nve
run 10
unfix a
fix b all nve/sphere'
once 'fix a all nve
run 10
fix a all nve'

# clumps that come in the run
printf '%s\n' "$start" 'group clumps empty
fix t all particletemplate/multisphere 15485863 atom_type 1 density constant 1000 nspheres 2 ntry 10000 spheres 0 0 0 0.02 0.02 0 0 0.02 type 1
fix d all particledistribution/discrete 15485867 1 t 1.0
region in block 0.1 0.9 0.1 0.9 0.5 0.9 units box
fix ins clumps insert/pack seed 32452843 distributiontemplate d maxattempt 100 insert_every once overlapcheck yes all_in yes particles_in_region 3 region in
fix ms all multisphere' >in.start
{ cat in.start; echo 'fix a all nve/sphere'; echo 'run 10'; } >in.script
"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null && [ "$(grep -c 'review: members' run.log)" = 1 ]
report 'clumps that come in the run: told once' $? out
{ cat in.start; echo 'group singles id 1 2'; echo 'fix a singles nve/sphere'; echo 'run 10'; } >in.script
"$TSIM" -in in.script -log none -screen none >out 2>&1 </dev/null
report 'clumps and single particles' $? out

# a restart in between
printf '%s\n' "$start" 'fix a all nve
run 10
write_restart there.restart' >in.script
"$TSIM" -in in.script -log none -screen none
printf '%s\n' 'read_restart there.restart
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 damping 0
fix a all nve
fix b all nve/sphere
run 10' >in.script
refused 'after a restart' 'moves particle 1 (type 1), which fix a (nve, in.script:4)' -in in.script
finish
