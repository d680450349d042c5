#!/bin/bash
# Particles stay divided among ranks between runs, and when they are read from a restart file, until something needs all of them:
# output and files are those of one rank, and a rank has the memory of its own particles.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

{
	cat <<'E2'
units		lj
atom_style	sphere
boundary	p f f
region		box block 0 ${n} 0 ${n} 0 $(2*v_n) units box
create_box	1 box
region		fill block 0 ${n} 0 ${n} 0 ${n} units box
lattice		sc 1.0 origin 0.5 0.5 0.5
create_atoms	1 region fill
set		group all diameter 1.01 density 1
velocity	all create 0.1 87287
thermo_style	custom step atoms ke erotate fmax fnorm density
thermo_modify	lost ignore
E2
	laws
} >in.start

# The last line of all: a frame of the end.
frame='dump end all custom 1 ${out}.dump id type x y z vx vy vz omegax omegay omegaz fx fy fz ix
dump_modify end format float %.17g
run 3'

# Runs between which no line reads particles: sums of them, definitions, a smaller time step, another law of forces.
{
	cat in.start
	cat <<'E2'
thermo 20
run 40
variable i loop 2
label again
run 30
print "$i $(step) $(atoms) $(ke)"
next i
jump SELF again
timestep 0.004
run 30
fix drag all viscous 0.01
run 30 every 10 "print '$(ke)'"
unfix drag
fix fall all gravity 0.7 vector 0 0.1 -1
run 20 pre no
thermo 0
run 20
E2
	echo "$frame"
} >in.rest
same_on rest 2 3 4
gathered 0 0 0 0 0 0 0 0 0 4

# Insertions from the first step on, which are defined after the particles were created, and change between runs.
{
	cat in.start
	cat <<'E2'
fix small all particletemplate/sphere 15485863 density constant 1 radius uniform number 0.2 0.4
fix twin all particletemplate/multiplespheres 15485917 density constant 1 nspheres 2 ntry 9000 spheres 0 0 0 0.3 0.4 0 0 0.2
fix both all particledistribution/discrete 32452843 2 small 0.6 twin 0.4
region sky block 0 ${n} 1 $(v_n-1) $(v_n+2) $(2*v_n-1) units box
region tube cylinder z 3 3 2 $(v_n+3) $(2*v_n-1) units box
print "v 1 1 $(2*v_n-3)" file face.obj screen no
print "v 5 1 $(2*v_n-3)" append face.obj screen no
print "v 3 5 $(2*v_n-3)" append face.obj screen no
print "f 1 2 3" append face.obj screen no
fix face all mesh/surface/planar file face.obj type 1
fix rain all insert/rate/region seed 32452867 distributiontemplate both nparticles INF particlerate 200 insert_every 9 region sky vel constant 0.5 0 -1
fix fill all insert/pack seed 86028157 distributiontemplate both insert_every 25 region tube particles_in_region 12 orientation random
fix pour all insert/stream seed 15486173 distributiontemplate both nparticles INF particlerate 50 vel uniform 0.1 0 -4 0.2 0.1 0 insertion_face face extrude_length 1.5
fix jet all insert/jet seed 49979687 distributiontemplate both position 1 4 $(v_n+1.5) direction -1 0 0 diameter 1 speed constant 3 particlerate 30 nparticles 40
fix snow all pour 20 1 29494 region tube diam one 0.7 vel -0.2 0.2 -0.1 0.1 -1
run 40
run 30
fix rain all insert/rate/region seed 32452867 distributiontemplate both nparticles INF particlerate 90 insert_every 7 region sky
run 30
unfix jet
print "$(atoms) $(ke)"
run 20
E2
	echo "$frame"
} >in.fed
same_on fed 2 3 4
gathered 0 0 0 0 4

# Rows with sums over groups, but a dynamic one, whose members all ranks choose together: that in the second run.
{
	cat in.start
	cat <<'E2'
region low block INF INF INF INF INF 0.01 units box
group low region low
compute ke low ke
compute spin all erotate/sphere
thermo_style custom step atoms c_ke c_spin
thermo_modify format float %.17g
thermo 20
run 40
group now dynamic all region low every 10
compute moving now ke
thermo_style custom step c_moving c_spin
thermo_modify format float %.17g
run 40
E2
	echo "$frame"
} >in.sums
same_on sums 2 3 4
gathered 0 4 5

# Lines that need all particles, before runs that go on with those of each rank.
{
	cat in.start
	cat <<'E2'
run 40
print "$(mass(all)) $(bound(all,zmax)) $(x[17])"
run 20
print "$(vcm(all,z)) $(press)"
run 20
compute high all reduce max z
run 20
variable top equal c_high
print "${top}"
set type 1 density 1.1
run 20
write_restart ${out}.restart
run 20
print "$(pe)"
E2
	echo "$frame"
} >in.asked
same_on asked 2 3

# Blocks become uneven: they are cut again in a rebuild, and nothing is gathered for it.
{
	cat in.start
	echo 'processors 2 * *'
	echo 'region left block INF $(v_n/2) INF INF INF INF units box'
	echo 'group left region left'
	echo 'velocity left set 4 0 0 units box sum yes'
	echo 'fix push left addforce 2 0 0'
	echo 'fix stop all wall/gran hertz/history 4000 NULL 50 NULL 0.5 1 xplane 0 ${n}'
	echo 'run 400'
	echo "$frame"
} | sed 's/^boundary.*/boundary f p f/' >in.cut
size=16 same_on cut 2 4
sed -n 's/^Ranks: .*imbalance //p' many.out | head -1 >uneven
awk '{ ok = ($1 < 1.3); exit } END { exit !ok }' uneven
report 'blocks are cut again while the particles are divided' $? uneven
grep -o 'all gathered [0-9]* times' many.out | head -1 >gathered
grep -q ' 0 times' gathered
report 'without all particles' $? gathered

# A restart file: continued as it is, with other forces, and with lines that need all particles.
{ cat in.start; echo 'run 150'; echo 'write_restart start.restart'; } >in.file
"$TSIM" -in in.file -log none -screen none -var n 8 >out 2>&1
report 'a restart file is written' $? out
reading() {
	printf 'units lj\natom_style sphere\nboundary p f f\nread_restart start.restart\n'
	printf '%s\n' "$@"
	laws
	echo 'thermo_style custom step atoms ke erotate fmax'
	echo 'thermo 30'
	echo 'run 90'
}
{ reading; echo "$frame"; } >in.continued
same_on continued 2 3 4
gathered 0 4
{ reading; echo "$frame"; } | sed 's/timestep.*/timestep 0.004/' >in.slower
same_on slower 2 3
gathered 0 4
{ reading 'print "$(atoms) $(ke)"'; echo "$frame"; } >in.sums
same_on sums 2
gathered 0 4
{ reading 'print "$(xcm(all,z)) $(mass(all)) $(vx[100])"'; echo "$frame"; } >in.look
same_on look 2 3
{ reading 'thermo_modify lost warn' 'set type 1 density 1.2' 'write_data ${out}.text'; echo "$frame"; } >in.set
same_on set 2 3
{ reading 'group some id 1:100' 'delete_atoms group some'; echo "$frame"; } >in.deleted
same_on deleted 3
{ reading; echo "$frame"; echo 'write_restart ${out}.restart'; } >in.written
same_on written 2
cmp start.restart many.restart >cmp.out 2>&1
[ $? -eq 1 ]
report 'a restart file of the continued run' $? cmp.out

# The fingerprint of particles does not depend on ranks: what two ranks have written one continues, and the other way round.
{ cat in.start; echo 'run 150'; echo 'write_restart two.restart'; } >in.file
on_ranks 2 "$TSIM" -in in.file -log none -screen none -var n 8 >out 2>&1 </dev/null
report 'two ranks write a restart file' $? out
{ reading; echo "$frame"; } | sed 's/start.restart/two.restart/' >in.two
same_on two 3
gathered 0 4

measures_memory || { finish; exit; }
for n in 20 60; do
	{ cat in.start; echo 'run 1'; echo "write_restart step$n.restart"; } >in.file
	"$TSIM" -in in.file -log none -screen none -var n $n >out 2>&1
	{ reading; } | sed "s/start.restart/step$n.restart/; s/^run .*/run 1/" >in.step$n
done
most_bytes 2 540 in.step20 in.step60
most_bytes 4 320 in.step20 in.step60
finish
