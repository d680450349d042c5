#!/bin/bash
# The memory that -explain tells is that which a run takes: what a particle more takes, estimated and measured. The
# estimate has no pages that are only partly used, and nothing of a search, so it is lower, but by a third at most.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

[ -x /usr/bin/time ] || { echo 'skipped: needs GNU time (apt-get install time)'; exit 77; }
cat >in.grid <<'E2'
units		lj
atom_style	sphere
boundary	f f f
region		box block 0 ${n} 0 ${n} 0 ${n} units box
create_box	1 box
lattice		sc 1.0
create_atoms	1 box
set		group all diameter 1.01 density 1
pair_style	gran/hertz/history 1000 NULL 50 NULL 0.5 1
pair_coeff	* *
neighbor	0.3 bin
fix		move all nve/sphere
timestep	0.001
run		5
E2
# bytes N: estimated and measured
bytes() {
	"$TSIM" -explain -in in.grid -var n "$1" -log none -threads 1 2>&1 | awk '/^memory: about/ { printf "%.0f ", $3 * 1e6 }'
	/usr/bin/time -f %M -o kilobytes "$TSIM" -in in.grid -var n "$1" -log none -screen none -threads 1
	awk 'END { print $1 * 1024 }' kilobytes
}
{ bytes 20; bytes 44; } >measured
awk 'NR == 1 { e = $1; m = $2 } END { e = ($1 - e) / (44^3 - 20^3); m = ($2 - m) / (44^3 - 20^3)
	print e, m; exit !(e > 300 && m > 0.95 * e && m < 1.5 * e) }' measured >compared
report 'estimated and measured bytes a particle' $? compared
cat compared
finish
