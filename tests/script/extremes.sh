#!/bin/bash
# Numbers at the ends of what there is: nothing crashes, hangs or goes on with nonsense; what cannot be is
# refused in words.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box'
ball="$box
create_atoms 1 single 0.5 0.5 0.5 units box
set type 1 diameter 0.1 density 1000"
ready="$ball
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
fix move all nve
timestep 1e-4"

# says WHAT TEXT SCRIPT: an error with the text, within ten seconds
says() {
	printf '%s\n' "$3" >in.script
	timeout 10 "$TSIM" -in in.script -log none >out 2>err </dev/null
	[ $? = 1 ] && grep -qE -- "$2" err && ! grep -q 'out of memory' err
	report "$1" $? err
}
# runs WHAT SCRIPT TEXT: ends well and prints the text
runs() {
	printf '%s\n' "$2" >in.script
	timeout 10 "$TSIM" -in in.script -log none >out 2>err </dev/null
	[ $? = 0 ] && grep -qE -- "${3:-.}" out
	report "$1" $? err
}

# time
says 'dt 0' 'timestep: .* (> 0|positive)' "$ready
timestep 0"
says 'dt < 0' 'timestep: .* (> 0|positive)' "$ready
timestep -1e-4"
says 'dt infinite' "'1e999'" "$ready
timestep 1e999"
says 'dt not a number' "'nan'" "$ready
timestep nan"
says 'dt huge' 'timestep: .*1e' "$ready
timestep 1e300
run 1"
says 'steps beyond counting' 'run' "$ready
run 99999999999999999999"
says 'more steps than the counter holds' '(beyond|more than|too (many|large)|out of range|largest)' "$ready
run 1
run 9223372036854775807"
says 'a step count with an exponent' 'expected an integer' "$ready
run 1e1"
says 'a fraction of more steps than the counter holds' 'expected an integer' "$ready
run 99999999999999999999.5"

# places
says 'a box of no length' 'would reach from z = 0 to 0' 'region b block 0 1 0 1 0 0 units box
create_box 1 b'
says 'an infinite box' 'would reach from x = -inf to inf' 'region b block INF INF 0 1 0 1 units box
create_box 1 b'
says 'a box of 1e308' '.' "region b block -1e308 1e308 0 1 0 1 units box
boundary p p p
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5 units box
fix m all nve
run 1
bogus"
says 'a particle at 1e300' '(nowhere|outside|box)' "$ready
set type 1 x 1e300
run 1"
says 'a particle a million boxes away is put back' 'bogus' "$ready
set type 1 x 1e6
run 1
bogus"
says 'images that cannot be counted' 'invalid position' "$ready
set type 1 x 1e14
run 1"
says 'a velocity of 1e300' '(not a number|moves more)' "$ready
velocity all set 1e300 0 0
run 1"
says 'a velocity of 1e300, no pair' '(not a number|moves more|nowhere)' "$ball
fix move all nve
velocity all set 1e300 0 0
run 1"
says 'a diameter of 0' '(> 0|positive)' "$ball
set type 1 diameter 0"
says 'a diameter of 1e300' '(mass|volume|finite|infinite|large|long)' "$ready
set type 1 diameter 1e300
run 1"
says 'a force that is not a number' 'sqrt is not a real number, for x = -0.5' "$ready
variable f equal sqrt(0.5-step)
fix f all addforce v_f 0 0
run 3"
says 'a force of 1e308' '(not a number|moves more)' "$ready
fix f all addforce 1e308 1e308 0
run 3"

# numbers of things
runs 'no particles' "$box
pair_style spring/dashpot
pair_coeff * * stiffness 100 restitution 0.5
fix move all nve
compute k all ke
compute c all com
compute m all reduce max x
dump d all custom 1 none.dump id x
thermo_style custom step atoms ke c_k c_c[1] density
timestep 1e-4
run 5
write_restart none.restart
print 'done'" '^done'
runs 'no particles, read again' 'read_restart none.restart
fix move all nve
run 5
print "atoms $(atoms)"' '^atoms 0'
runs 'a group of nobody' "$ready
group none region box
group none clear
fix f none addforce 1 0 0
compute k none ke
compute r none reduce sum x
compute c none com
thermo_style custom step c_k c_r c_c[1]
run 3
print 'done'" '^done'
says '1e18 particles' '(too many|at most|memory|1000000000000000000)' "$box
create_atoms 1 random 1000000000000000000 7 box"
says 'a lattice of 1e18 particles' 'the lattice has more than 1e9 cells' "$box
lattice sc 1e-6
create_atoms 1 box"
says '1e18 types' 'create_box' 'region b block 0 1 0 1 0 1
create_box 1000000000000000000 b'
says 'type 1e18' '(type|whole number)' "$box
create_atoms 1000000000000000000 single 0.5 0.5 0.5"
says 'an average of 1e15 samples' '.' "$ready
compute k all ke
fix a all ave/time 1 1000000 1000000 c_k ave window 1000000000000000000"
says 'a loop of 1e18' 'bogus' "variable i loop 1000000000000000000
print \$i
bogus"
says 'a loop of 1e30' 'variable|whole number|loop' 'variable i loop 1000000000000000000000000000000'
says 'an expression too deep' '.' "print \$($(printf '(%.0s' {1..100000})1)"
says 'a line of a megabyte' '.' "bogus $(head -c 1000000 /dev/zero | tr '\0' x)"
says 'a thermo interval of 0' '.' "$ready
thermo -1"

# memory: told before it is taken; where it ends, at which line
many='create_atoms 1 random 1000000000 12345 box'
printf '%s\n' "$box" "$many" >in.script
timeout 10 "$TSIM" -in in.script -log none >out 2>err </dev/null
[ $? = 1 ] && shows "in.script:5:1: error: create_atoms: out of memory: 1000000000 particles take " err
report "more particles than memory" $? err
timeout 10 "$TSIM" -check -in in.script -log none >out 2>&1 </dev/null
[ $? = 1 ] && shows 'create_atoms: out of memory: 1000000000 particles take ' out
report "more particles than memory, -check" $? out
printf '%s\n' "$box" \
	'fix one all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.05' \
	'fix mix all particledistribution/discrete 32452843 1 one 1' \
	'fix many all insert/pack seed 86028157 distributiontemplate mix insert_every once region box particles_in_region 1000000000' \
	'run 1' >in.script
timeout 10 "$TSIM" -in in.script -log none >out 2>err </dev/null
[ $? = 1 ] && shows "error: fix insert/pack: out of memory: 1000000000 particles take " err
report "insertion of more particles than memory" $? err
if ! nm "$TSIM" 2>/dev/null | grep -q __asan_init; then
	printf '%s\n' "$box" 'lattice sc 0.0025' 'create_atoms 1 box' >in.script
	(ulimit -v 600000 && exec timeout 60 "$TSIM" -in in.script -log none) >out 2>err </dev/null
	[ $? = 1 ] && grep -q 'in.script:6:.*out of memory' err
	report "out of memory names the line" $? err
fi
finish
