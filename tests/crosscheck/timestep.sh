#!/bin/bash
# fix check/timestep/gran with `legacy yes` by LIGGGHTS 3.8: the thermo tables, digit by digit.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts

cat >in.both <<'END'
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
neighbor 0.01 bin
neigh_modify delay 0
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.5 0 0 units box
set type 1 diameter 0.2 density 2470
set type 2 diameter 0.23 density 1830
group one id 1
velocity all set ${v} 0.4 0.1
fix m1 all property/global youngsModulus peratomtype 5.e6 9e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.9 0.8 0.8 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.05 0.06 0.06 0.08
pair_style gran model hertz tangential history
pair_coeff * *
fix g all gravity 9.81 vector 0 0.2 -1
timestep 1e-4
fix n all nve/sphere
fix ts ${who} check/timestep/gran ${words} warn no
thermo_style custom step f_ts[1] f_ts[2] f_ts[3]
thermo 20
run 100
END
agrees() { # GROUP WORDS SPEED
	set -- -in in.both -var who "$1" -var words "$2" -var v "$3" -log none
	liggghts "$@" 2>&1 | rows >liggghts.rows
	"$TSIM" "$@" -legacy 2>&1 | rows >tsim.rows
	same "$*" liggghts.rows tsim.rows
}
agrees all '20 0.1 0.1' 0.3
agrees one '20 0.1 0.1' -2.385
agrees all '20 0.1 0.1 vmax 3.1' 0.3
agrees all 'check_every_time 2e-3 0.1 0.1' 0.3
finish
