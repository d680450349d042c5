#!/bin/bash
# Particles that commands make before the first run are divided among ranks at once: identities, output and files are those of
# one rank, and a rank never has the memory of all.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

box() {
	cat <<'E'
units		lj
atom_style	sphere
boundary	p f f
region		box block 0 ${n} 0 ${n} 0 $(2*v_n) units box
create_box	3 box
region		fill block 0 ${n} 0 ${n} 0 ${n} units box
lattice		sc 1.0 origin 0.5 0.5 0.5
thermo_style	custom step atoms ke erotate fmax fnorm density
thermo_modify	lost ignore
E
}
frame='dump end all custom 1 ${out}.dump id type mass radius x y z vx vy vz omegax omegay omegaz fx fy fz ix
dump_modify end format float %.17g
run 3'

# Commands that act on each particle alone: nothing is gathered before the first run.
{
	box
	cat <<'E'
mass		3 2.5
create_atoms	1 region fill basis 1 2
create_atoms	2 single 6.5 3.5 $(v_n+0.6) units box
region		top block INF INF INF INF $(v_n+2) $(2*v_n-2) units box
create_atoms	3 region top
region		crown block INF INF INF INF $(2*v_n-0.9) INF units box
create_atoms	1 random 4 9281 crown
set		group all diameter 1.01
set		type 1*2 density 1.5
set		atom 3*90 vx 0.25 vy -0.5
region		half block INF $(v_n/2) INF INF INF INF units box
set		region half omega 0 1 2
set		group all type/fraction 2 0.3 3729
group		left region half
group		two type 2
group		some id 5:200:3
group		both intersect left two
group		rest subtract all left some
delete_atoms	region half
velocity	rest create 0.1 87287 mom yes rot yes dist gaussian
velocity	some set 0.1 NULL v_speed sum yes
velocity	all ramp vx 0 0.3 z 0 ${n} sum yes units box
velocity	two zero linear
print		"$(atoms) $(ke)"
mass		2 0.75
group		rest clear
group		some delete
E
	laws
	echo 'run 30'
	echo "$frame"
} | sed 's/^mass.*3 2.5/variable speed atom 0.1*x\n&/' >in.alone
same_on alone 2 3 4 7
gathered 0 4

# Commands that read others, between them; each ends the division.
n=0
while read -r line; do
	n=$((n + 1))
	{
		box
		echo 'region top block INF INF INF INF $(v_n+1) $(2*v_n-1) units box'
		echo 'variable heavy atom "mass>0.5"'
		echo 'variable far atom "x > xcm(all,x)"'
		echo 'create_atoms 1 region fill'
		echo 'set group all diameter 1.01'
		echo "$line"
		echo 'velocity all create 0.1 87287'
		laws
		echo 'run 10'
		echo "$frame"
	} >in.line
	size=6 same_on line $((n % 3 + 2))
done <<'E'
create_atoms 2 random 50 777 NULL overlap 1.1 maxtry 100
create_atoms 2 region top subset 30 4711
create_atoms 2 region top ratio 0.1 4711
group far variable far
set group all type/subset 2 40 1234
set group all type/ratio 2 0.2 1234
set group all vx v_far
delete_atoms random count 20 yes all NULL 1234
delete_atoms overlap 1.5 all all
delete_atoms variable heavy
displace_atoms all random 0.01 0.01 0.01 4711
print "$(bound(all,xmax)) $(x[17])"
write_data ${out}.text
run 0
E

# No particle, one, and more made after a run.
{
	box
	echo 'region none sphere 0 0 0 0.1 units box'
	echo 'create_atoms 1 region none'
	echo 'group all2 type 1'
	echo 'create_atoms 1 single 1 1 1 units box'
	laws
	echo 'run 5'
	echo 'create_atoms 2 region fill'
	echo 'set type 2 diameter 1.01'
	echo 'run 10'
	echo "$frame"
} >in.late
size=5 same_on late 2 4

# balance and processors before particles are made.
{
	box
	echo 'processors 1 1 *'
	echo 'create_atoms 1 region fill'
	laws
	echo 'run 5'
	echo "$frame"
} >in.grid
same_on grid 2 3
gathered 0 4

# A value that a particle cannot have is told once, of the particle of the least identity.
{
	box
	echo 'create_atoms 1 region fill'
	echo 'variable size atom "1 - (id > 100)"'
	echo 'set group all diameter v_size'
} >in.bad
"$TSIM" -in in.bad -log none -var n 8 >one 2>&1
[ $? -ne 0 ] && grep -q 'diameter of particle 101 would be 0' one
report 'an impossible diameter' $? one
on_ranks 3 "$TSIM" -in in.bad -log none -var n 8 >many 2>&1 </dev/null
[ $? -ne 0 ] && [ "$(grep -c 'diameter of particle 101 would be 0' many)" = 1 ]
report 'an impossible diameter on 3 ranks' $? many

# The memory of a rank that makes its particles and does a step.
measures_memory || { finish; exit; }
{
	box
	cat <<'E'
create_atoms	1 region fill
set		group all diameter 1.01 density 1
group		low id < 1000
velocity	all create 0.1 87287
E
	laws
	echo 'run 1'
} >in.step
most_bytes 2 520 in.step in.step
most_bytes 4 300 in.step in.step
finish
