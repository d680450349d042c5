#!/bin/bash
# What formulas draw and read in a run - random numbers, values from files - and values found once are the same
# in a run that is cut in two: in one script, or through a restart file. Regions that forces depend on are
# noticed when they change.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

seq 1 999 | sed 's/$/.385/' >numbers
for k in $(seq 200); do
	printf '2\n1 0.%03d\n3 -0.%03d\n' $k $k
done >sets
cat >in.begin <<'END'
units si
boundary f f f
region b block -1 1 -1 1 -1 1 units box
variable list file ../numbers
variable each atomfile ../sets
if "${from} == none" then "create_box 1 b" "create_atoms 1 single 0.1 0.2 0.3 units box" &
	"create_atoms 1 single -0.1 0.25 0.31 units box" "create_atoms 1 single 0.15 -0.2 0.2 units box" &
	"set group all diameter 0.1 density 2385" &
else "read_restart ${from}"
variable start once xcm(all,x)+random(0,1,5)
variable push equal 0.01*random(-1,1,8613)
variable seen equal random(0,1,8613)+normal(0,1,77)
variable each2 atom next(each)+random(0,1,8613)
variable value equal next(list)
compute shaken all reduce sum v_each2
fix push all addforce v_push 0 0
fix move all nve
timestep 1e-4
fix say all print 7 "$(step) ${seen} ${value}" file said screen no
fix mean all ave/time 5 3 20 v_seen c_shaken file mean
thermo_style custom step v_seen v_value c_shaken v_start
thermo 10
END
streams() { # FOLDER FROM RUNS...
	mkdir -p "$1" && { cat in.begin && printf '%s\n' "${@:3}" 'write_restart end.restart'; } >"$1/in"
	(cd "$1" && "$TSIM" -in in -log log -screen none -var from "$2" 2>err)
	report "streams: $1" $? "$1/err"
}
compare() { # PARTS...: together they are the whole
	for what in said mean; do
		grep -v '^#' whole/$what >expected
		for part; do cat "$part/$what"; done | grep -v '^#' >found
		same "streams: $what, $*" expected found
	done
	same "streams: state after $*" whole/end.restart "${*: -1}/end.restart"
}
compare_rows() { # CUT PARTS...: but that of the cut, where the second part sees the next line of the file
	rows whole/log | grep -vE "^ +$1 " >expected
	for part in "${@:2}"; do rows "$part/log"; done | grep -vE "^ +$1 " >found
	same "streams: rows, cut at $1" expected found
}
streams whole none 'run 100'
shows 3.385 <(grep '^ *10 ' whole/log)
report 'the print at step 7 took the second number of the file, the row at step 10 the third' $? whole/log
for cut in 40 33 35; do
	streams both none "run $cut" "run $((100 - cut))"
	compare both
	compare_rows $cut both
	streams one none "run $cut"
	streams two ../one/end.restart 'run 100 upto'
	compare one two
	compare_rows $cut one two
done
shows 'Variable start continues with' two/log
report 'the log tells what goes on' $? two/log

# steps that come again draw other numbers
prints 'units si
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2385
timestep 1e-6
fix move all nve
variable r equal random(0,1,8613)
thermo_style custom step v_r
fix keep all ave/time 1 1 1 v_r
variable first once f_keep
run 3
variable a once f_keep
unfix keep
reset_timestep 0
fix keep all ave/time 1 1 1 v_r
run 3
print "again $(abs(f_keep-v_a)<1e-12) range $(f_keep>0) $(f_keep<1)"' 'again 0 range 1 1'

# a file that is shorter now, and one that the script itself steps through
head -n 3 numbers >short && mv short numbers
mkdir short && cp in.begin short && cd short || exit 99
refused 'a file that is shorter now' "'../numbers' has 3 values, but the run saved in the restart file had read number" \
	-in in.begin -var from ../one/end.restart
cd ..
prints 'variable n file numbers
next n
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
write_restart own.restart
clear
next n
read_restart own.restart
print "own ${n}"' 'own 3.385'
prints 'variable a once 2.385*2
variable a once 7
print "once ${a}"' 'once 4.77'

# The region of a fix is another: the forces of the last step no longer hold
pushed() { # LO
	cat <<END
units si
boundary f f f
region b block -1 1 -1 1 -1 1 units box
create_box 1 b
create_atoms 1 single 0.1 0.2 0.3 units box
set group all diameter 0.1 density 2385
region near block 0 1 0 1 0 1 units box
region none block -1 0 -1 0 -1 0 units box
region r union 2 $1 none
fix move all nve
fix push all addforce 2.385 0 0 region r
timestep 1e-3
run 1
unfix push
region r delete
region r union 2 $2 none
fix push all addforce 2.385 0 0 region r
run 1
print "velocity \$(vx[1]/(2.385/mass[1]*1e-3):%.6f)"
END
}
prints "$(pushed near near)" 'velocity 2.000000'
prints "$(pushed near none)" 'velocity 1.000000'
prints "$(pushed none near)" 'velocity 1.000000'
finish
