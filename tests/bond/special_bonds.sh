#!/bin/bash
# special_bonds: bonded particles touch by default, do not with a first factor of 0, and do again from
# the step after their bond breaks; a run cut in two is the whole.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two spheres of diameter 1 that overlap by 0.1, with a bond that is as long: the force is the contact's.
cat >in.pair <<'END'
units		si
atom_style	sphere
boundary	f f f
region		box block -2 2 -2 2 -2 2 units box
create_box	1 box
create_atoms	1 single 0.0 0.0 0.0 units box
create_atoms	1 single 0.9 0.0 0.0 units box
set		group all diameter 1.0 density 2.385
pair_style	spring/dashpot
pair_coeff	* * stiffness 31.0 damping 0
bond_style	contact
bond_coeff	1 stiffness 7.0 ultimate ${ultimate}
create_bonds	many all all 1 0.0 1.2
special_bonds	${special}
fix		move all nve
velocity	all set ${v} 0 0
velocity	all ramp vx ${v} $(-v_v) x 0.0 0.9 units box
timestep	1e-3
thermo_style	custom step numbonds fmax
thermo_modify	format float %.15g
thermo		1
END
run_pair() { # NAME, script after in.pair, -var ...
	local name=$1
	printf 'include in.pair\n%b\n' "$2" >in.run
	shift 2
	"$TSIM" -in in.run -log "$name.log" -screen none "$@" 2>err
	report "$name runs" $? err
}
force_at() { # LOG STEP
	awk -v step="$2" '$1 == step { f = $3 } END { print f }' "$1"
}
expect() { # WHAT FOUND WANTED
	awk -v a="$2" -v b="$3" 'BEGIN { d = a - b; exit !(a != "" && d * d <= 1e-28 * b * b) }'
	report "$1: found '$2', expected $3" $?
}

run_pair touching 'run 0' -var special 'lj 1 1 1' -var ultimate 9.0 -var v 0
expect 'bonded particles touch' "$(force_at touching.log 0)" 3.1
run_pair apart 'run 0' -var special 'lj 0 1 1' -var ultimate 9.0 -var v 0
expect 'a factor of 0: only the bond acts' "$(force_at apart.log 0)" 0
run_pair both 'run 0' -var special 'lj/coul 0.0 1.0 1.0' -var ultimate 9.0 -var v 0
expect 'lj/coul' "$(force_at both.log 0)" 0

# A box so small that two images of a partner touch: at 0.8, which has the bond, and at 0.9, which has the contact.
sed -e 's/^boundary.*/boundary p f f/' -e 's/block -2 2/block -0.4 1.3/' -e 's/units si/&\nneighbor 0.1 bin/' in.pair >in.images
sed -i 's/^timestep/compute forces all property\/atom fx\nthermo_style custom step numbonds\n&/' in.images
printf '%s\n' 'include in.images' 'run 0' 'print "pull $(fx[1]:%.15g)"' >in.small
for case in '0 -3.1' '1 3.1'; do
	"$TSIM" -in in.small -log none -var special "lj ${case% *} 1 1" -var ultimate 9.0 -var v 0 >out 2>&1
	expect "images of a partner, factor ${case% *}" "$(sed -n 's/^pull //p' out)" "${case#* }"
done

# The bond breaks at an extension of 0.01 (here a compression): pressed together, the contact takes over.
run_pair broken 'run 200' -var special 'lj 0 1 1' -var ultimate 0.07 -var v 0.13
awk '$1 ~ /^[0-9]+$/ && NF == 3 && $2 == 0 { if (++n == 2) { print $3; exit } }' broken.log >after
awk '{ ok = ($1 > 31 * 0.1); exit } END { exit !ok }' after
report 'they touch once the bond is broken' $? after

# Cut at the step of the break, the run is the same.
step=$(awk '$1 ~ /^[0-9]+$/ && NF == 3 && $2 == 0 { print $1; exit }' broken.log)
[ -n "$step" ]
report 'the bond breaks' $? broken.log
for cut in $((step - 1)) "$step" $((step + 1)); do
	set -- -var special 'lj 0 1 1' -var ultimate 0.07 -var v 0.13
	run_pair whole "run 200 upto\nwrite_restart whole.restart" "$@"
	run_pair first "run $cut\nwrite_restart cut.restart" "$@"
	{
		sed -n '/^pair_style/,$p' in.pair | grep -vE '^(create_bonds|velocity)'
		printf 'run 200 upto\nwrite_restart second.restart\n'
	} >in.rest
	sed -i '1i units si\natom_style sphere\nboundary f f f\nread_restart cut.restart' in.rest
	"$TSIM" -in in.rest -log second.log -screen none "$@" 2>err
	report "second part from step $cut" $? err
	same "cut at step $cut" whole.restart second.restart
done

refused 'half a contact' 'must be 0 or 1, found 0.5' -in in.pair -var special 'lj 0.5 1 1' \
	-var ultimate 9.0 -var v 0
refused 'second neighbours' 'must be 1, found 0 and 1' -in in.pair -var special 'lj 0 0 1' \
	-var ultimate 9.0 -var v 0
refused 'no factors' 'expected lj or lj/coul' -in in.pair -var special 'angle yes' \
	-var ultimate 9.0 -var v 0
finish
