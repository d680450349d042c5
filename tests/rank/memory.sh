#!/bin/bash
# A rank that gets all particles has their columns once: what it takes for a particle more. Columns of so many particles are sent in
# several pieces, and each rank writes the text of a part of a dump; dumps are those of one rank.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
[ -x /usr/bin/time ] || { echo 'skipped: needs GNU time (apt-get install time)'; exit 77; }
has_ranks || exit 77
export OMP_NUM_THREADS=1
cat >in.grid <<'E2'
units		lj
atom_style	sphere
boundary	f f f
region		box block 0 ${n} 0 ${n} 0 ${n} units box
create_box	1 box
lattice		sc 1.0 origin 0.5 0.5 0.5
create_atoms	1 box
set		group all diameter 1.01 density 1
velocity	all create 0.1 87287
pair_style	gran/hertz/history 1000 NULL 50 NULL 0.5 1
pair_coeff	* *
neighbor	0.3 bin
fix		move all nve/sphere
timestep	0.001
thermo_modify	lost ignore
E2

# Outputs that read columns only, of which ranks write the text of some rows each or, in another order, the first one alone; and one that
# reads contacts.
{
	cat in.grid
	cat <<'E2'
dump		some all custom 2 ${out}.dump id type x y z vx vy vz fx fy fz omegax omegay omegaz tqx tqy tqz radius mass
dump_modify	some format float %.17g
dump		table all custom 2 ${out}.csv id x y z radius
dump		packed all atom 2 ${out}.atom.gz
dump		names all xyz 2 ${out}.xyz
dump_modify	names element Si
dump		sorted all custom 2 ${out}.sorted id vx vy
dump_modify	sorted sort -2
dump		few all custom 2 ${out}.few id x
dump_modify	few thresh id < 50
run		2
compute		c all pair/local dist fx fy fz
dump		pairs all local 2 ${out}.pairs c_c[*]
dump_modify	pairs format float %.17g
run		2
E2
} >in.dumps
"$TSIM" -in in.dumps -log none -screen none -var n 27 -var out one >out 2>&1
report 'one rank writes dumps' $? out
for n in 2 3 4 7; do
	on_ranks "$n" "$TSIM" -in in.dumps -log none -screen none -var n 27 -var out many >out 2>&1 </dev/null
	report "$n ranks write dumps" $? out
	for file in dump csv atom.gz xyz sorted few pairs; do
		same "$file, $n ranks" "one.$file" "many.$file"
	done
	rm -f many.*
done

# A write that fails, of the first rank, is told once.
{ cat in.grid; printf 'dump full all custom 1 /dev/full id x y z\nrun 1\n'; } >in.full
"$TSIM" -in in.full -log none -screen none -var n 40 2>&1 | grep error >one.told
on_ranks 3 "$TSIM" -in in.full -log none -screen none -var n 40 2>&1 </dev/null | grep 'error: ' >many.told
[ -s one.told ] && cmp one.told many.told
report 'three ranks tell that a dump cannot be written' $? many.told

# most N: the largest memory of a rank, in kB
most() {
	on_ranks 3 /usr/bin/time -f %M -a -o kilobytes "$TSIM" -in in.short -log none -screen none -var n "$1" >out 2>&1 </dev/null
	sort -n kilobytes | tail -1
	rm -f kilobytes
}
{ cat in.grid; echo 'run 1'; } >in.short
{ most 20; most 64; } >measured
nm "$TSIM" 2>/dev/null | grep -q __asan_init && { finish; exit; }
awk 'NR == 1 { m = $1 } END { m = ($1 - m) * 1024 / (64^3 - 20^3); print m; exit !(m > 250 && m < 500) }' measured >compared
report 'bytes of a particle on three ranks' $? compared
cat compared

# fluid SOLVER LEAST MOST [SCRIPT]: bytes of a cell more, of the largest of four ranks: a fluid takes a part of it in each
fluid() {
	for n in 48 96; do
		on_ranks 4 /usr/bin/time -f %M -a -o kilobytes "$TSIM" -in "${4:-in.cavity}" -log none -screen none -var n $n \
			-var solver "$1" >out 2>&1 </dev/null
		report "$1, $n cells, four ranks" $? out
		sort -n kilobytes | tail -1
		rm -f kilobytes
	done >measured
	awk -v least="$2" -v most="$3" '/^[0-9]+$/ { m = b; b = $1 }
		END { m = (b - m) * 1024 / (96^3 - 48^3); print m; exit !(m > least && m < most) }' measured >compared
	report "bytes of a cell on four ranks, $1, ${4:-in.cavity}" $? compared
	cat compared
}
cat >in.cavity <<'E2'
units		si
boundary	f f f
region		box block 0 1 0 1 0 1 units box
create_box	1 box
flow_style	projection cells ${n} ${n} ${n} viscosity 0.01 density 1
flow_boundary	zhi wall velocity 1 0 0
pressure_style	${solver}
timestep	0.0001
thermo_style	custom step flow_cfl
run		2
run		1
E2
# Grains that feel it: also what is near those of the rank. 350 on one rank.
cat >in.grains <<'E2'
units		si
atom_style	sphere
boundary	f f f
newton		off
communicate	single vel yes
processors	1 1 *
region		box block 0 1 0 1 0 1 units box
create_box	1 box
neighbor	0.002 bin
lattice		sc 0.05 origin 0.5 0.5 0.5
create_atoms	1 box
set		group all diameter 0.01 density 2500
velocity	all set 0.1 0 -0.1 units box
pair_style	gran/hooke/history 5000 NULL 5 NULL 0.5 1
pair_coeff	* *
flow_style	projection cells ${n} ${n} ${n} viscosity 0.01 density 1
flow_boundary	zlo inlet velocity 0 0 0.1
flow_boundary	zhi outlet
pressure_style	${solver}
fix		e all void_fraction
fix		drag all drag/di_felice scheme implicit
fix		push all flow/pressure_gradient
fix		move all nve/sphere
timestep	0.00001
thermo_style	custom step flow_cfl
run		2
run		1
E2
# The memory of a grid is taken when it is written: one that is too large is told before.
on_ranks 2 "$TSIM" -in in.cavity -log none -screen none -var n 20000 -var solver direct >out 2>&1 </dev/null
[ $? != 0 ] && [ "$(grep -c 'in.cavity:5:.*out of memory: 20000 x 20000 x 20000 cells need 5.12e+05 GB' out)" = 1 ]
report 'a grid beyond the memory, two ranks' $? out
# one rank: 82, 167 and 190
fluid direct 20 40
fluid 'cg preconditioner diagonal' 35 60
fluid multigrid 40 70
fluid cg 90 170 in.grains
finish
