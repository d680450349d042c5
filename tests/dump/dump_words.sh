#!/bin/bash
# dump_modify: thresh with LAST, refresh, header.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

three='units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.25 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.75 0.5 0.5 units box
set group all diameter 0.1 density 1000
fix 1 all nve
timestep 1e-5
variable f atom (id==1)*(step>2)+(id==2)*(step>4&&step<7)'
dumping='dump 1 all custom 1 last.dump id v_f
dump_modify 1 thresh v_f != LAST first yes'
frames() { # FILE: "step: id ..." of each frame
	awk '/TIMESTEP/ { rows = 0; getline; printf "%s%s:", n++ ? " " : "", $1; next }
		/^ITEM: ATOMS/ { rows = 1; next } /^ITEM/ { rows = 0 } rows { printf " %s", $1 }' "$1"
}
# LAMMPS, 29 Sep 2021: nothing in the first frame, then those that have changed since the last one
want='0: 1: 2: 3: 1 4: 5: 2 6: 7: 2 8:'
prints "$three
$dumping
run 4
run 4"
[ "$(frames last.dump)" = "$want" ]
report 'LAST' $? last.dump
sed 's/^run 4$/run 3\nwrite_restart mid.restart/' >in.half <<END
$three
$dumping
run 4
END
"$TSIM" -in in.half -log none >out 2>&1
report 'first half' $? out
prints "read_restart mid.restart
fix 1 all nve
timestep 1e-5
${three##*1e-5
}
$dumping append yes
run 5"
[ "$(frames last.dump)" = "$want" ]
report 'LAST over a restart' $? last.dump
prints "$three
$dumping thresh id < 2
dump 2 all custom 1 two.dump id
dump_modify 2 thresh none thresh v_f > LAST thresh v_f |^ LAST
run 8"
[ "$(frames last.dump)" = '0: 1: 2: 3: 1 4: 5: 6: 7: 8:' ]
report 'LAST and a number' $? last.dump
[ "$(frames two.dump)" = '0: 1: 2: 3: 1 4: 5: 2 6: 7: 8:' ]
report 'two with LAST' $? two.dump
rejects "$three
$dumping thresh id < FIRST" "'FIRST' is no number, nor LAST"

# Displacements since the last frame: v = 1.5, a frame every 2 of 0.01 s.
prints "$three
velocity all set 1.5 0 0
velocity all set NULL NULL NULL
variable two atom id<3
compute way all displace/atom refresh v_two
compute all all displace/atom
timestep 0.01
dump 1 all custom 2 way.dump id c_way[1]
dump_modify 1 refresh c_way header no format float %.10g
dump 2 all custom 2 all.dump c_all[1]
dump_modify 2 refresh all header no format float %.10g first no
run 4"
printf '%s \n' '1 0' '2 0' '3 0' '1 0.03' '2 0.03' '3 0.03' '1 0.03' '2 0.03' '3 0.06' >want
same 'refresh of some' way.dump want
printf '%s \n' 0 0 0 0.03 0.03 0.03 0.03 0.03 0.03 >want
same 'refresh of all' all.dump want
rejects "$three
dump 1 all custom 2 way.dump id
compute e all ke/atom
dump_modify 1 refresh c_e" 'has no reference state to refresh'
rejects "$three
compute way all displace/atom refresh v_to" "no such variable 'to'"
# A number of the whole scene is no column, as in LAMMPS.
rejects "$three
variable s equal step
dump 1 all custom 1 all.dump id v_s" "'v_s' is a single number, expected numbers of particles"
rejects "$three
compute e all ke
dump 1 all custom 1 all.dump id c_e
run 1" "'c_e' is a single number, expected numbers of particles"
# A sequence of steps ends: the run goes on, and its last frame is written. No frame is before `delay`.
prints 'units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single .5 .5 .5 units box
set atom 1 diameter 0.1 density 1000
fix m all nve
timestep 1e-4
variable next equal stride(0,20,10)
dump f all custom 25 stride.dump id x
dump_modify f every v_next
dump d all custom 10 delay.dump id x
dump_modify d first yes delay 25
thermo v_next
run 50
print "at $(step)"' 'at 50'
frames() { awk '/TIMESTEP/ { getline; printf "%s ", $1 }' "$1"; }
[ "$(frames stride.dump)" = '10 20 ' ]
report 'frames of a sequence' $? stride.dump
[ "$(frames delay.dump)" = '30 40 50 ' ]
report 'no frame before delay' $? delay.dump
[ "$(awk '/^ +[0-9]+ +[0-9]/ { printf "%s ", $1 }' out)" = '0 10 20 50 ' ]
report 'rows of a sequence' $? out
finish
