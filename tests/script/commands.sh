#!/bin/bash
# The set-up commands: what they print, and every rejection with a place and a reason.
# shellcheck source=tests/lib_text.sh
. "$top_srcdir/tests/lib_text.sh" || exit 99
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0

report() { # what, ok?
	if [ "$2" = 0 ]; then
		passed=$((passed + 1))
	else
		failed=$((failed + 1))
		echo "off: $1"
		cat out
	fi
}

run_script() {
	"$TSIM" -in in.script -log none >out 2>&1
}

# Expects success and each line given after the script in the output.
good() { # name, script, lines ...
	local name=$1 ok=0
	printf '%s\n' "$2" >in.script
	shift 2
	run_script || ok=1
	for line in "$@"; do
		says_line "$line" out || { ok=1; echo "missing: $line"; }
	done
	report "$name" $ok
}

# Expects failure, with a message that contains the text.
bad() { # script, text
	local ok=0
	printf '%s\n' "$1" >in.script
	run_script && ok=1
	shows "$2" out || ok=1
	report "rejects: $1" $ok
}

box='region box block 0 1 0 1 0 1 units box
create_box 2 box'
ball="$box
create_atoms 1 single 0.5 0.5 0.5
create_atoms 2 single 0.25 0.25 0.75"

good 'boxes and lattices' "units si
boundary p p p
lattice sc 0.25
$box
create_atoms 1 box" 'Lattice spacing in x,y,z = 0.25 0.25 0.25' \
	'Created orthogonal box = (0 0 0) to (1 1 1)' 'Created 64 atoms'
good 'fcc has four' "units si
lattice fcc 0.5
$box
create_atoms 1 box" 'Created 32 atoms'
good 'bcc in a region' "units si
boundary f f f
lattice bcc 0.5
$box
region low block INF INF INF INF INF 0.3 units box
create_atoms 2 region low" 'Created 8 atoms'
good 'region lengths in lattice units' "units si
lattice none 0.5
region box block 0 2 0 2 0 2 units lattice
create_box 1 box" 'Created orthogonal box = (0 0 0) to (1 1 1)'
good 'random without overlap' "units si
$box
create_atoms 1 random 200 86028157 NULL overlap 0.1
delete_atoms overlap 0.1 all all" 'Created 200 atoms' 'Deleted 0 atoms, new total = 200'
good 'overlap of a part' "units si
boundary f f f
$box
create_atoms 1 single 0.5 0.5 0.5
create_atoms 2 single 0.52 0.5 0.5
create_atoms 1 single 0.54 0.5 0.5
create_atoms 2 single 0.8 0.5 0.5
create_atoms 2 single 0.81 0.5 0.5
group b type 2
delete_atoms overlap 0.03 all b
group left id 2 4
print 'left \$(count(all)) \$(count(left))'" 'Deleted 3 atoms, new total = 2' 'left 2 2'
good 'too many' "units si
$box
create_atoms 1 random 50 86028157 NULL overlap 0.5 maxtry 100" 'in.script:4: warning: only 6 of 50 particles could be placed, with 100 tries each'
good 'sets, groups, velocities' "variable two equal 2.385
$ball
region top block INF INF INF INF 0.6 INF units box
set atom 1 diameter 0.2 density 1000 vx 1
set type 2 mass 3.5 vx v_two
variable fast atom \"vx > 2\"
group b type 2
group lower id <= 1
group both union b lower
group left subtract both b
group none intersect b left
group upper region top
group fast variable v_fast
print \"mass \$(mass(lower):%.15g) \$(mass(b)) \$(count(left)) \$(vcm(b,x):%.15g)\"
delete_atoms group b
group b delete" '1 atoms in group b' '2 atoms in group both' '1 atoms in group left' \
	'0 atoms in group none' '1 atoms in group upper' '1 atoms in group fast' \
	'mass 4.18879020478639 3.5 1 2.385' 'Deleted 1 atoms, new total = 1'
good 'velocity create is exact and keyed by identity' "units lj
boundary p p p
$box
create_atoms 1 random 100 49979687 NULL
velocity all create 1.5 86028157
variable off equal abs(ke(all)/(1.5*99*1.5)-1)
if \"\${off} < 1e-12\" then 'print exact'" 'Created 100 atoms' 'exact'
good 'runs for a time' "units si
boundary f f f
$ball
timestep 1e-5
run_time 7e-5
print \"step \$(step)\"
run_time 1.004e-3
print \"step \$(step)\"
run_time 2.5e-3 upto
timestep 3e-5
run_time 2.6e-3 upto
run_time 2.6e-3 upto
run_time 0
print \"step \$(step) \$(time:%.10g)\"" 'step 7' 'step 108' 'step 254 0.00262'
good 'accepted' "atom_style granular
atom_modify map array
newton off
communicate single vel yes
processors 1 1 1
$box
neighbor 0.001 bin
neigh_modify delay 0 exclude type 1 2 exclude group all all
compute_modify thermo_temp dynamic yes
mass * 2.0
timestep 1e-4
reset_timestep 5"

bad "boundary f f f
$ball
timestep 1e-5
run_time 1e-4
run_time 8e-5 upto" 'run_time upto 8e-05: the simulation is already at time 0.0001'
bad "boundary f f f
$ball
timestep 1e-5
run_time 1e15" 'steps of 1e-05 are out of range'
bad "$box
run_time" 'run_time: T is missing'
bad 'atom_style hybrid' 'expected styles behind it'
bad 'boundary p f q' "boundary: z is 'q'"
bad 'boundary pf f f' 'both faces must be periodic or none'
bad 'units sj' 'expected one of lj, si, cgs, micro'
bad "$box
units si" 'must come before'
bad "$box
create_box 1 box" 'already'
bad 'create_atoms 1 box' 'needs a simulation box'
bad "$box
create_atoms 1 box" 'use the lattice command first'
bad "$box
create_atoms 3 single 0 0 0" 'types go from 1 to 2'
bad 'region a block 1 0 0 1 0 1' 'is above'
bad 'region a plane 0 0 0 0 0 0' 'normal is zero'
bad 'region a sphere 0 0 0 -1' 'expected a number >= 0'
bad 'region a blok 0 1 0 1 0 1' "did you mean 'block'"
bad 'region a union 2 b' 'expected the names of 2 regions'
bad 'region a block 0 1 0 1 0 1
region a block 0 1 0 1 0 1' "there is a region 'a' already"
bad "$box
region a block 0 1 0 1 0 1
region b union 1 a
region a delete
run 0" "there is no region 'a'"
bad "$box
region b block 0 1 0 1 0 1
compute n all reduce/region b sum x
region b delete
region b block 0 1 0 1 0 1
run 0" 'compute n uses region b'
good 'regions go in any order' "$box
region b block 0 1 0 1 0 1
region c union 1 b
compute n all reduce/region c sum x
region b delete
region c delete
region b block 0 2 0 1 0 1
region c union 1 b
uncompute n
compute n all reduce/region c sum x
run 0"
bad 'region a block INF 1 0 1 0 1
create_box 1 a' 'the box would reach from x = -inf'
bad "$ball
set atom 1 diameter -1" 'expected a number > 0'
bad "$ball
set atom 1 type 7" 'expected a type'
bad "$ball
set grop all diameter 1" "did you mean 'group'"
bad "$ball
group all type 1" 'cannot be changed'
bad "$ball
group g id 1:x" 'is not a number n or a range'
bad "$ball
group g union al" "did you mean 'all'"
bad "$ball
velocity all ramp vx 0 1 z 2 2" 'both ends'
bad "$ball
unfix nothing" "there is no fix 'nothing'"
bad 'lattice sq 1.0' 'has 2 dimensions'
bad 'timestep 0' 'expected a number > 0'
bad "$ball
neigh_modify exclude type 1 9" 'is not a type'
bad "$ball
compute a all property/atom radios" "did you mean 'radius'"

good 'variables inside the quotes of a condition' 'variable d string "two words"
variable e string hello
if "'"'\${d}' == 'two words'"'" then "print same" else "print different"
if "'"'\${d}' == two"'" then "print one" else "print two"
if "'"'\${e}' == hello && \${e} != 'hell'"'" then "print both"' same two both
good 'set omega by variables' "$ball
variable w atom 2*id
variable d equal 0.5
set group all omega v_d 0 0
print \"is \$(omegax[1]) \$(omegay[1]) \$(omegaz[1])\"
set group all omega 1 v_w -3
print \"is \$(omegax[1]) \$(omegay[1]) \$(omegaz[1])\"" 'is 0.5 0 0' 'is 1 2 -3'
bad "$ball
set group all omega 1 v_none 0" 'three numbers or variables'

# `pre no`: the same as with a set-up, where something has changed since the last run and where nothing has
plate='units si
boundary f f f
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
create_atoms 1 single 0 0 0.0079 units box
set group all diameter 0.006 density 2500
set group all vz -0.5
fix plate all mesh/surface primitive plate length 0.05 width 0.05 type 1
fix w all wall/gran model hooke/stiffness tangential no_history mesh n_meshes 1 meshes plate
fix m1 all property/global kn peratomtypepair 1 1e4
fix m2 all property/global kt peratomtypepair 1 1e4
fix m3 all property/global gamman peratomtypepair 1 100
fix m4 all property/global gammat peratomtypepair 1 0
fix m5 all property/global coefficientFriction peratomtypepair 1 0.5
fix move all nve/sphere
timestep 1e-5'
for pre in yes no; do
	printf '%s\n' "$plate" "run 990 pre $pre" "run 100 pre $pre" 'velocity all set 0.1 NULL NULL units box' "run 900 pre $pre" \
		'print "end $(z[1]:%.17g) $(x[1]:%.17g) $(vz[1]:%.17g)"' >in.script
	run_script
	grep '^end' out >"pre.$pre"
done
[ -s pre.yes ] && cmp pre.yes pre.no && awk '{ ok = $4 > 0 } END { exit !ok }' pre.no
report 'pre no' $?
# A film with a content of its own, and a list that is built in the second run.
film="units si
boundary p f f
region box block 0 1 0 0.5 0 0.4 units box
create_box 1 box
create_atoms 1 single 0.05 0.25 0.08 units box
set group all diameter 0.01 density 1500
set group all vx 0.1
neighbor 0.001 bin fixed yes
variable cx internal 0
variable wafer equal 0.2+0.08*sin(2*PI*v_cx)-0.05*time
fix pad all surface/voxel gaussian mean 0.03 deviation 0.01 correlation 0.1 seed 31 type 1 cells 40 20 datum 0 move linear 1.1 0 0
flow_style reynolds cells 40 20 lower_voxel pad upper v_wafer set x cx upper_velocity 0 0 -0.05 upper_stays viscosity 0.1 density 1000 gap stepped &
	cavitation jfo transient yes cavity_pressure 0 pressure_ylo 0.02
fix drag all drag/stokes
fix move all nve
compute film all film
timestep 1e-3"
for pre in yes no; do
	printf '%s\n' "$film" 'run 20' "run 20 pre $pre" 'print "end $(c_film[1]:%.17g) $(c_film[4]:%.17g)"' >in.script
	run_script
	grep '^end' out >"pre.$pre"
done
[ -s pre.yes ] && cmp pre.yes pre.no
report 'pre no: a film' $?

# `quit` among the commands of `every` ends the run there
for quit in '"if '"'"'$(step) >= 4'"'"' then quit"' 'quit' '"include in.quit"'; do
	echo 'quit 3' >in.quit
	printf '%s\n' "$box" 'thermo 0' "run 10 every 2 'print \"at \$(step)\"' $quit" 'print beyond' >in.script
	run_script
	status=$?
	case $quit in
	*if*) [ $status = 0 ] && [ "$(grep '^at\|^beyond' out)" = $'at 2\nat 4' ] ;;
	*include*) [ $status = 3 ] && [ "$(grep '^at\|^beyond' out)" = 'at 2' ] ;;
	*) [ $status = 0 ] && [ "$(grep '^at\|^beyond' out)" = 'at 2' ] ;;
	esac
	report "every: $quit" $?
done

echo "$passed passed, $failed failed"
[ $failed = 0 ]
