#!/bin/bash
# Results do not depend on the number of ranks, bit for bit; what does not work with several ranks is refused; errors are
# printed once.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1
scenes=$top_srcdir/tests/rank/scenes

# ranks N WORDS...: tsim with N ranks; its output in `out`
ranks() {
	local n=$1
	shift
	on_ranks "$n" "$TSIM" "$@" >out 2>&1 </dev/null
}

played='crossing gas bed outlet pushed burst looks named feed rain'
for scene in ${played% rain}; do cp "$scenes/in.$scene" .; done
# The gas of in.gas, and more grains in every other step.
sed '/^compute pr/d; s/ c_pr\[1\]//; s/press .*//; s/10 5 100/100 1 100/; s/custom 350/custom 50/; s/^run .*/run 150/
	s/^fix 1 .*/&\nfix one all particletemplate\/sphere 15485863 atom_type 2 density constant 2500 radius constant 0.0003 volume_limit 0\nfix mix all particledistribution\/discrete 32452843 1 one 1\nregion all block EDGE EDGE EDGE EDGE EDGE EDGE units box\nfix rain all insert\/rate\/region seed 32452867 distributiontemplate mix nparticles INF particlerate 2e5 insert_every 2 region all verbose no check_dist_from_subdomain_border no ntry_mc 1000/' \
	in.gas >in.rain
# shellcheck disable=SC2086
same_scenes 2 $played
for scene in $played; do
	[ -s "alone/$scene/x.rows" ] && [ -s "alone/$scene/x.dump" ] && [ -s "alone/$scene/x.mean" ]
	report "$scene has a table, a dump and averages" $?
done
# Contact laws of all types are known to a rank that has no particles when a run begins.
cp "$scenes/in.late" .
same_scenes 2 late
ranks 2 -full columns -in in.late -log none -screen none -var out full && same 'all columns: two ranks' alone/late/x.dump full.dump
report 'all columns: two ranks run' $? out
[ -d ranks.2 ] || in_turn 2 ranks.2 looks named burst feed rain # other numbers were asked for
# Outputs of in.looks read particles only, and checks of the time step need none of other ranks: contacts are gathered for the
# end of the run.
gathered() { awk '/all gathered/ { sub(/.*all gathered /, ""); print $1, $3 }' "$1"; }
gathered ranks.2/looks/log | awk '{ ok = ($1 > 100 && $2 == 1); exit } END { exit !ok }'
report 'contacts are gathered at the end, where outputs do not read them' $? ranks.2/looks/log
# Those of in.named do in 19 steps: in multiples of 60, 90, 100, 150 and 210.
gathered ranks.2/named/log | awk '{ ok = ($1 > 300 && $2 == 19); exit } END { exit !ok }'
report 'contacts are gathered where an output that is due reads them' $? ranks.2/named/log
# Particles are inserted while they are divided: only outputs of the first run of in.feed, each 20 or 60 steps, and of in.rain need all.
gathered ranks.2/feed/log | awk 'NR == 1 { ok = ($1 <= 14); exit } END { exit !ok }' && gathered ranks.2/rain/log | awk '{ ok = ($1 <= 4); exit } END { exit !ok }'
report 'nothing is gathered to insert particles' $? ranks.2/feed/log
# The cloud of in.burst leaves the block of one rank: the box is cut again while the particles are divided.
awk '/imbalance/ { most = $NF } / all gathered / { sub(/.*all gathered /, ""); listed = $3 } END { exit !(most < 1.4 && listed <= 1) }' ranks.2/burst/log
report 'uneven blocks are cut again' $? ranks.2/burst/log
# Of the particles of a bed in the lower part of its box each rank has about half.
grep -v '^run' "$scenes/in.bed" >in.even
printf 'region high block INF INF INF INF 0.02 INF units box\ngroup high region high\ndelete_atoms group high\nrun 10\n' >>in.even
ranks 2 -in in.even -log log.even -screen none -var out even
awk '/^Ranks:/ { least = $(NF - 4); most = $(NF - 2) } END { exit !(least > 0.8 * most) }' log.even
report 'ranks have the same number of particles' $? log.even
OMP_NUM_THREADS=2 ranks 2 -in in.bed -log none -screen none -var out many
same 'two ranks of two threads' alone/bed/x.dump many.dump

# resumed SCRIPT FIRST REST WORDS: the run is cut by a restart file of three ranks, which other numbers of ranks read; WORDS: of
# the lines that are given again. It writes the scripts: in.whole.NAME, in.first.NAME and in.second.NAME.
resumed() {
	local name=${1##*in.}
	names+=("$name")
	grep -v '^run' "$1" >part
	printf 'run %d\nrun %d\n' "$2" "$3" | cat part - >"in.whole.$name"
	printf 'run %d\nwrite_restart ../../cut.%s\n' "$2" "$name" | cat part - >"in.first.$name"
	{ echo "read_restart ../../cut.$name" && grep -E "^($4)" "$1" && echo "run $3"; } >"in.second.$name"
}
names=()
lines='newton|neighbor|neigh_modify|communicate|fix|pair|timestep|compute|variable|thermo|dump|print'
resumed "$scenes/in.bed" 400 500 "$lines"
resumed "$scenes/in.drum" 400 400 "$lines"
grep -Ev '^dump (bl|bs|bb|pg)|^compute (bl|bp|pgl)' "$scenes/in.rock" >in.block
resumed in.block 300 300 "$lines|bond_|special_bonds"
resumed "$scenes/in.springs" 301 299 "$lines|bond_"
resumed "$scenes/in.bit" 601 599 "$lines|bond_"
resumed "$scenes/in.bodies" 420 380 "$lines"
# Fix heat/gran and the bonds, which have damping, add their columns of particles in another order after read_restart.
resumed "$scenes/in.warm" 200 200 "$lines|bond_|special_bonds"
resumed "$top_srcdir/tests/decks/in.clumps" 250 350 "$lines|region[[:space:]]+top"
resumed "$scenes/in.mill" 410 390 "$lines"
resumed "$scenes/in.sorted" 420 280 "$lines|region[[:space:]]+(part|lower|middle|ball)"
resumed "$scenes/in.sieve" 213 387 "$lines"
resumed "$scenes/in.waves" 420 280 "$lines|region[[:space:]]+(tray|lump|paddle|low)"
sed 's/boundary f p p/boundary p p f/; s/^flow_boundary.*/flow_boundary zhi outlet pressure 2/; s/time rk2/time ab2 viscous implicit/
	s/17 14 13/17 14 23/; s/^dump.*/variable e atom flow_ke\ndump last all custom 36 ${out}.dump id v_e\ndump_modify last format float %.17g/' \
	"$scenes/in.slabs" >in.planes
resumed in.planes 17 19 "$lines|flow|pressure"
sed 's/density 900/& every 4/; s/custom 60/custom 9/' "$scenes/in.current" >in.strewn
resumed in.strewn 63 27 "$lines|flow"
resumed "$top_srcdir/tests/decks/in.insertion" 400 300 "$lines|region[[:space:]]+(low|tube|egg)"
for name in "${names[@]}"; do
	mkdir -p "whole/$name"
	(cd "whole/$name" && "$TSIM" -in "../../in.whole.$name" -log none -screen none -var out x >out 2>&1)
	report "$name is not cut" $? "whole/$name/out"
done
in_turn 3 first "${names[@]/#/first.}"
report 'three ranks write restart files' $? out
in_turn 2 second.2 "${names[@]/#/second.}"
report 'two ranks read them' $? out
last_frame() { tail -n "$(awk '/ITEM: TIMESTEP/ { n = NR } END { print NR - n }' "$1")" "$1"; }
for name in "${names[@]}"; do
	mkdir -p "second.1/second.$name"
	(cd "second.1/second.$name" && "$TSIM" -in "../../in.second.$name" -log none -screen none -var out x >out 2>&1)
	report "$name: one process reads it" $? "second.1/second.$name/out"
	last_frame "whole/$name"/x*.dump >last.whole
	for n in 2 1; do
		last_frame "second.$n/second.$name"/x*.dump >last.second
		same "$name: $n ranks continue" last.whole last.second
	done
done

# What is said of a fluid with grains is said once: of its cells, of limits, and by the review of a fix.
sed 's/boundary p p f/boundary p p p/; /^flow_boundary/d; /^fix floor/d; s/cells 12 6 30/cells 32 16 64/; s/^run 110/run 3/; s/^run 60/run 2/
	s/all void_fraction/& least 0.7/' "$scenes/in.current" >in.said
"$TSIM" -in in.said -log none -var out said >out 2>&1 && said said.1
ranks 3 -in in.said -log none -var out said && said said.3
same 'warnings of three ranks' said.1 said.3
[ "$(grep -cE 'momentum|void fraction down to|laws of drag hold' said.1)" = 4 ]
report 'four warnings' $? said.1

# So is what the review of a fix finds that reads no particles: this mesh leaves the box.
cat >plate.stl <<'E2'
solid plate
facet normal 0 0 1
outer loop
vertex 0.02 0.01 0
vertex 0.06 0.01 0
vertex 0.02 0.03 0
endloop
endfacet
endsolid plate
E2
{
	grep -Ev '^(run|dump|fix mean|processors)' "$scenes/in.bed" | sed 's/boundary p f f/boundary f f f/'
	printf 'fix plate all mesh/surface file plate.stl type 1 move 0 0 0.058\nfix push all move/mesh mesh plate linear 0 0 10\nrun 15\n'
} >in.leaving
ranks 2 -in in.leaving -log none -var out leaving
[ "$(grep -c 'mesh plate leaves the box in a time of .*mesh_leaves' out)" = 1 ]
report 'a mesh that leaves, on two ranks' $? out

# A fluid that is at rest, and then comes in and leaves by given velocities: no face is open, and the void fraction counts on all.
cat >in.ramp <<'E2'
units si
atom_style sphere
boundary f f f
newton off
communicate single vel yes
processors 1 1 *
region box block 0 0.048 0 0.024 0 0.096 units box
create_box 1 box
neighbor 0.0004 bin
lattice sc 0.004 origin 0.5 0.5 0.5
region mid block 0.012 0.036 0 0.024 0.02 0.07 units box
create_atoms 1 region mid
set group all diameter 0.0015 density 2500
velocity all set 0 0 -0.5 units box
pair_style gran/hooke/history 5000 NULL 5 NULL 0.5 1
pair_coeff * *
timestep 1e-5
flow_style projection cells 12 6 30 viscosity 1e-2 density 900
variable up equal 300*time
flow_boundary xlo inlet velocity v_up 0 0
variable out2 equal 600*time
flow_boundary zhi inlet velocity 0 0 v_out2
fix e all void_fraction
fix drag all drag/di_felice scheme implicit
fix move all nve/sphere
thermo_style custom step ke f_drag[1]
thermo_modify format float %.17g lost ignore
thermo 3
dump grains all custom 3 ${out}.dump id x vx fx fy fz
dump_modify grains format float %.17g sort id
run 6
E2
"$TSIM" -in in.ramp -log none -screen none -var out ramp.1 >out 2>&1
report 'a ramp, alone' $? out
ranks 3 -in in.ramp -log none -screen none -var out ramp.3
same 'a ramp, three ranks' ramp.1.dump ramp.3.dump
# Each grain in one cell: the void fraction, which the table reads anew, needs no neighbours, forces that act back on the fluid do.
cat >in.centre <<'E2'
units si
atom_style sphere
boundary p p p
region box block 0 0.02 0 0.02 0 0.02 units box
create_box 1 box
lattice sc 0.005
create_atoms 1 box
set group all diameter 1e-3 density 2500
timestep 2e-5
flow_style projection cells 6 6 6 viscosity 1e-3 density 1000
flow_set velocity 0.1 0.05 0.2
fix e all void_fraction method centre
fix drag all drag/di_felice
fix move all nve/sphere
dump grains all custom 4 ${out}.dump id x vx fx fy fz
dump_modify grains format float %.17g sort id
thermo_style custom step ke f_e[1] f_drag[3]
run 4
E2
"$TSIM" -in in.centre -log none -screen none -var out centre.1 >out 2>&1
report 'method centre, alone' $? out
ranks 3 -in in.centre -log none -screen none -var out centre.3
same 'method centre, three ranks' centre.1.dump centre.3.dump

# The blocks of `processors`.
sed 's/^processors.*/processors 1 1 2/' "$scenes/in.bed" >in.blocks
ranks 2 -in in.blocks -log log.2 -screen none -var out many
same 'other blocks' alone/bed/x.dump many.dump
grep -q 'Ranks: 2 as 1 x 1 x 2 blocks' log.2
report 'the log tells the blocks' $? log.2
sed 's/^processors.*/processors 3 1 1/' "$scenes/in.bed" >in.blocks
ranks 2 -in in.blocks -log none -var out many
[ $? != 0 ] && [ "$(grep -c 'in.blocks:6:12: error: processors: the product of the numbers is 3' out)" = 1 ]
report 'blocks that do not fit' $? out

# refused WHAT LINE:COLUMN TEXT SCRIPT-LINE...: an error with this place and text, printed once, and no run
refused() {
	local what=$1 place=$2 text=$3
	shift 3
	printf '%s\n' 'units lj' 'region box block 0 10 0 10 0 10' 'create_box 1 box' 'create_atoms 1 single 5 5 5' "$@" 'run 10' \
		>in.refused
	ranks 2 -shell yes -in in.refused -log none
	[ $? != 0 ] && [ "$(grep -c "in.refused:$place: error: .*$text" out)" = 1 ] && ! grep -q 'Loop time' out
	report "$what" $? out
	"$TSIM" -shell yes -in in.refused -log none >out 2>&1
	report "$what: alone it runs" $? out
}
integrate='fix 1 all nve'
refused 'a command' 5:7 'shell with a program does not work with several ranks' 'shell true' "$integrate"

# undivided WHAT LINE:COLUMN VALUE SCRIPT-LINE...: such values act in each step: a warning there, once in two runs, and the same numbers
# as of one rank
undivided() {
	local what=$1 place=$2 value=$3
	shift 3
	printf '%s\n' 'units lj' 'boundary p p p' 'atom_style sphere' 'newton off' 'region box block 0 10 0 10 0 10' 'create_box 1 box' \
		'lattice sc 1' 'create_atoms 1 box' 'velocity all create 1 4711' 'timestep 0.001' "$@" 'fix 1 all nve' 'thermo 5' 'thermo_style custom step ke' \
		'thermo_modify format float %.17g' 'dump d all custom 10 ${out}.dump id x y z fx fy fz' \
		'dump_modify d format float %.17g sort id' 'run 10' 'run 10' >in.undivided
	same_on undivided 3
	[ "$(grep -c "in.undivided:$place: warning: $value depends on all particles.* acts in each step: all 3 ranks" many.out)" = "${warned:-1}" ]
	report "$what: the warning" $? many.out
	awk '/^ITEM: TIMESTEP/ { n = 0 } NF == 7 { if ($5 * $5 + $6 * $6 + $7 * $7 > 0) n++ } END { exit !n }' many.dump
	report "$what: it acts" $? many.dump
}
undivided 'a force by the centre of mass' 12 'v_g of fix addforce' 'variable g equal -0.01*xcm(all,x)' 'fix g all addforce v_g 0 0'
undivided 'a force that draws' 13 'v_f of fix addforce' 'variable g equal 0.01*random(0,1,5)' 'variable f atom 0.01*x+v_g' \
	'fix g all addforce v_f 0 0'
undivided 'a variable that has got another formula' 12 'v_g of fix addforce' 'variable g equal step' \
	'fix g all addforce v_g 0 0' 'variable g equal 1e-3*c_k' 'compute k all ke'
undivided 'a region that moves by a variable of all particles' '[0-9]*' 'the variable by which a region moves or changes' \
	'variable s equal xcm(all,x)' 'region r sphere 5 5 5 3 move v_s NULL NULL' 'fix f all addforce 1 0 0 region r'
undivided 'a dynamic group by an output, in each step' '[0-9]*' 'the variable of a dynamic group' \
	'compute k all ke/atom' 'variable fast atom c_k>0.5' 'group fast dynamic all var fast every 1' 'fix f fast addforce 1 0 0'
warned=0 undivided 'a dynamic group by an output, now and then' '[0-9]*' 'the variable of a dynamic group' \
	'compute k all ke/atom' 'variable fast atom c_k>0.5' 'group fast dynamic all var fast every 25' 'fix f fast addforce 1 0 0'
printf 'run 30\n' >>in.undivided
same_on undivided 2
"$TSIM" -in in.undivided -var out x -explain -ranks 4 -log none >out 2>&1 && grep -q '^4 ranks, .* blocks, now:' out
report 'the plan of such a group' $? out
sed 's/every 25/every 5/' in.undivided >in.often
"$TSIM" -in in.often -var out x -explain -ranks 4 -log none >out 2>&1 &&
	grep -q '^4 ranks: each does all steps with all particles' out
report 'the plan of a group that is assigned often' $? out

# Of particles that are lost in one step the one with the least identity is told, once, with its contacts.
printf '%s\n' 'units lj' 'atom_style sphere' 'boundary f f f' 'newton off' 'processors 1 * 1' 'region box block 0 30 0 25 0 20' 'create_box 1 box' \
	'neighbor 0.5 bin' 'lattice sc 1.0 origin 0.001 0.5 0.5' 'region r block 0 6 1 12 1 6' 'create_atoms 1 region r' \
	'set group all diameter 1.1 density 1.0' 'thermo_modify lost warn' 'velocity all set -1 -1 -1' 'pair_style gran/hooke 2000.0 NULL 50.0 NULL 0.5 1' \
	'pair_coeff * *' 'timestep 0.0001' 'fix 1 all nve/sphere' 'run 40' >in.left
"$TSIM" -in in.left -log none 2>&1 | grep 'left the box' >left.one
grep -q 'last contacts: particle 2, particle 7, particle 67;' left.one
report 'the contacts of a lost particle' $? left.one
for n in 2 3; do
	ranks $n -in in.left -log none
	grep 'left the box' out >left.many
	same "a lost particle is told once by $n ranks" left.one left.many
done

# Frames so large that all ranks compress blocks, and write text of numbers.
printf '%s\n' 'units si' 'atom_style sphere' 'boundary f f f' 'newton off' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' 'neighbor 0.001 bin' \
	'region low block 0 1 0 1 0 0.5 units box' 'lattice sc 0.0222' 'create_atoms 1 region low' 'set group all diameter 0.02 density 2500' \
	'velocity all create 0.1 87287 dist gaussian' 'fix 1 all nve/sphere' 'timestep 0.001' 'dump p all custom/vtk 2 ${out}.p*.vtp id vx vy vz radius' \
	'dump u all custom/vtk 3 ${out}.u*.vtu id vx' 'dump t all custom/vtk 2 ${out}.t*.vtk id type vx vy vz radius' \
	'dump b all custom/vtk 3 ${out}.b*.vtk id vx vy vz' 'dump_modify b binary yes' 'run 3' >in.frames
mkdir -p frames.1
(cd frames.1 && "$TSIM" -in ../in.frames -log none -screen none -var out x) >out 2>&1
report 'frames of one rank' $? out
for n in $(numbers_of 2x2 0); do
	rm -rf frames.n && mkdir frames.n
	(cd frames.n && OMP_NUM_THREADS=$([ "$n" = 2x2 ] && echo 2 || echo 1) on_ranks "${n%x2}" "$TSIM" -in ../in.frames -log none -screen none -var out x) >out 2>&1
	report "frames of $n ranks" $? out
	[ "$(find frames.n -name 'x.*[023].vt?' | wc -l)" = 12 ] && diff -rq frames.1 frames.n >difference
	report "frames: the same files on $n ranks" $? difference
done

# Files that are there are appended to: an incomplete last line is ended, in a table cut off.
printf '%s\n' 'units lj' 'atom_style sphere' 'boundary f f f' 'newton off' 'region box block 0 9 0 9 0 9' 'create_box 1 box' 'lattice sc 1.1' \
	'create_atoms 1 box' 'set group all diameter 1.0 density 1.0' 'velocity all set 1 0 0' 'fix 1 all nve/sphere' 'timestep 0.0001' 'variable t equal step' \
	'compute s all reduce sum vx' 'fix a all ave/time 1 1 10 c_s append x.mean' 'fix p all print 10 "at $t" append x.print screen no' \
	'dump d all custom 10 x.dump id x' 'dump_modify d append yes' 'dump c all custom 10 x.csv id x' 'dump_modify c append yes' \
	'dump z all custom 10 x.dump.gz id x' 'dump_modify z append yes' 'run 20' >in.append
rm -rf appended.*
for n in 1 2 3; do
	mkdir appended.$n
	for file in mean print dump csv; do
		printf cut >appended.$n/x.$file
	done
	for again in 1 2; do
		(cd appended.$n && on_ranks $n "$TSIM" -in ../in.append -log none >../out 2>&1 </dev/null)
		report "appending to files, time $again, $n ranks" $? out
	done
	diff -r appended.1 appended.$n >out
	report "files that were appended to by $n ranks" $? out
done
[ "$(grep -c '^at ' appended.3/x.print)" = 4 ]
report 'both runs have appended' $? appended.3/x.print

# Pressure and numbers of bonds are summed before all ranks look at the particles: no contacts are gathered for them.
gathers='s/.*all gathered \([0-9]*\) times, \([0-9]*\) of them with contacts.*/\1 \2/p'
sed '/^dump/d; s/^thermo 100/thermo 20/; s/^run 600/run 200/; /^run 300/d' "$scenes/in.bed" >in.look
{
	sed '/^dump/d; /^thermo_style/d; /^variable/d; /^fix mean/d; /^print/d; /^run/d; /^compute/d; /^fix .* ave/d' "$scenes/in.rock"
	printf '%s\n' 'compute b all bonds' 'variable both atom c_b+x' 'compute c all pressure NULL virial' 'thermo_style custom step c_b c_c press pxy' 'thermo 20' \
		"dump v all custom 40 \${out}.dump id v_both" 'fix w all ave/time 5 4 20 c_b c_c[1] file ${out}.mean' 'run 100'
} >in.glued
for scene in look glued; do
	"$TSIM" -in in.$scene -log log.one -screen none -var out one >out 2>&1
	report "$scene: one process" $? out
	for n in 2 3; do
		ranks $n -in in.$scene -log log.many -screen none -var out many
		report "$scene: $n ranks" $? out
		rows log.one >rows.one
		rows log.many >rows.many
		same "$scene: rows of $n ranks" rows.one rows.many
		same "$scene: means of $n ranks" one.mean many.mean
		read -r all lists <<<"$(sed -n "$gathers" log.many)"
		[ "$all" -ge 10 ] && [ "$lists" -le 3 ]
		report "$scene: $n ranks gather no contacts" $? log.many
	done
done
same 'bonds of particles' one.dump many.dump

# Bonds that have just broken keep their particles apart until the next list: also where the list is made for outputs.
sed '/^dump/d; /^thermo/d; /^run/d; s/^velocity all create.*/velocity all create 0.6 87287 dist gaussian/' "$scenes/in.beams" >in.torn
printf '%s\n' 'fix near all check/timestep/bond 2 0.9 warn no' 'thermo_style custom step brokenbonds f_near[3]' 'thermo 2' 'run 30' >>in.torn
"$TSIM" -in in.torn -log log.one -screen none >out 2>&1
report 'torn bonds: one process' $? out
ranks 2 -in in.torn -log log.many -screen none
rows log.one >rows.one
rows log.many >rows.many
same 'torn bonds: limits of the time step' rows.one rows.many

# The main example: seeding, settling, bonds, a bit in a fluid that carries cuttings out.
drilling() {
	"$@" "$TSIM" -in "$top_srcdir/examples/drilling/in.drilling" -log drilling.log -screen none -var out "$folder" \
		-var depth 60 -var T 8 -var land 1 >out 2>&1 </dev/null
	report "drilling: $folder" $? out
	grep '^STUDY' drilling.log >"$folder/study"
}
folder=drill.one
drilling timeout 300
for n in 2 4; do
	folder=drill.many
	rm -rf "$folder"
	drilling on_ranks $n
	[ -s drill.many/study ] && diff -rq -x '*.restart' drill.one drill.many >out
	report "drilling: the same files on $n ranks" $? out
done

# Formulas of the fluid that read particles: all ranks do all steps with all particles.
# reads_all WHAT VARIABLE FORMULA CAUSE: the duct with such a variable
reads_all() {
	sed "s/^variable $2.*/variable $2 equal $3/; s/^run .*/run 30/" "$scenes/in.duct" >in.reads
	same_on reads 3
	[ "$(grep -c "in.reads:[0-9:]*: warning: $4 depends on all particles" many.out)" = 1 ]
	report "$1: the warning" $? many.out
}
reads_all 'a moving wall whose speed depends on particles' speed '0.02+ke(all)' 'a variable of flow_boundary'
reads_all 'a body force that depends on particles' pull '20+count(all)' 'v_pull of flow projection'

# Errors: in the script, and of one rank in a step.
printf 'units lj\nnonsense 1\n' >in.wrong
ranks 3 -in in.wrong -log none
[ $? != 0 ] && [ "$(grep -c 'in.wrong:2:1: error: ' out)" = 1 ]
report 'an error in the script is printed once' $? out
on_ranks 3 "$TSIM" -lgo none >out 2>&1
[ "$(grep -c "^tsim: unknown option '-lgo'" out)" = 1 ]
report 'an error in the options is printed once' $? out
sed -e 's/^thermo_modify.*/thermo_modify lost error/' "$scenes/in.outlet" >in.lost
begin=$SECONDS
ranks 4 -in in.lost -log none -var out many
[ $? != 0 ] && [ "$(grep -c 'left the box through its fixed face' out)" = 1 ] && [ $((SECONDS - begin)) -lt 60 ]
report 'an error of one rank ends all' $? out
# A particle that moves more than its radius in a step: y is that of another one in its way, on another rank.
fast() {
	cat <<END
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.02 0.5 0.5 units box
create_atoms 1 single 0.725 $1 0.5 units box
create_atoms 1 single 0.3 0.1 0.5 units box
set group all diameter 0.02 density 1000
group one id 1
pair_style spring/dashpot
pair_coeff * * stiffness 10 damping 0
fix move all nve
processors * 1 1
velocity one set 51 0 0
timestep 1e-3
dump all all custom 5 \${out}.dump id x y z vx vy vz
dump_modify all format float %.17g sort id
run 100
END
}
for n in 2 4; do
	fast 0.53 >in.fast
	"$TSIM" -in in.fast -log none -var out alone >out 2>&1 && ranks $n -in in.fast -log none -var out many &&
		cmp alone.dump many.dump >>out
	report "a fast particle that meets nothing, on $n ranks" $? out
	fast 0.515 >in.fast
	"$TSIM" -in in.fast -log none -var out alone >alone.out 2>&1
	ranks $n -in in.fast -log none -var out many
	grep -q 'particle 1 .* past particle 2:' alone.out && [ "$(grep 'error:' out)" = "$(grep 'error:' alone.out)" ]
	report "a fast particle that meets one of another rank, on $n ranks" $? out
done
# A jet of which several particles have met a wall before they are inserted: the same one is told.
printf '%s\n' 'units si' 'atom_style sphere' 'boundary f f f' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' \
	'pair_style gran/hertz/history 2e6 NULL 50.0 NULL 0.5 1' 'pair_coeff * *' 'fix move all nve/sphere' \
	'fix one all particletemplate/sphere 15485863 density constant 2500 radius gaussian number 0.01 0.003' \
	'fix mix all particledistribution/discrete 32452843 1 one 1' 'fix floor all wall/gran hertz/history 2e6 NULL 50.0 NULL 0.5 1 zplane 0.4 NULL' \
	'fix jet all insert/jet seed 49979687 distributiontemplate mix position 0.3 0.5 0.7 direction 1 0 -1 diameter 0.3 speed constant 60 particlerate 3000 nparticles 1000 insert_every 9' \
	'timestep 1e-3' 'run 50' >in.met
"$TSIM" -in in.met -log none >alone.out 2>&1
for n in 2 3; do
	ranks $n -in in.met -log none
	grep -q 'insert/jet jet: particle [0-9]* has left the nozzle' alone.out && [ "$(grep 'error:' out)" = "$(grep 'error:' alone.out)" ]
	report "a particle that has met a wall on its way, on $n ranks" $? out
done
for policy in active passive; do
	printf 'print "read $(2*21)"\n' | OMP_WAIT_POLICY=$policy on_ranks 3 "$TSIM" -log none >out 2>&1
	[ "$(grep -c 'read 42' out)" = 1 ]
	report "a script from the standard input, ranks wait: $policy" $? out
done
finish
