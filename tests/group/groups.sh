#!/bin/bash
# Groups and what set, velocity and the delete commands do with them: exact answers, and rejections.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# expect WHAT SCRIPT LINES...: success, and each line in the output
expect() {
	local what=$1 ok=0
	printf '%s\n' "$2" >in.script
	shift 2
	"$TSIM" -in in.script -log none >out 2>&1 || ok=1
	for line in "$@"; do
		says_line "$line" out || { ok=1; echo "missing: $line"; }
	done
	report "$what" $ok out
}
# reject WHAT SCRIPT TEXT
reject() {
	printf '%s\n' "$2" >in.script
	refused "$1" "$3" -in in.script
}

# eight particles on the corners of a cube of 0.5, identity 1 at the origin, x fastest
cube='units si
boundary p p p
lattice sc 0.5
region box block 0 1 0 1 0 1 units box
create_box 3 box
create_atoms 1 box
set group all diameter 0.3 density 2385
neighbor 0.05 bin'

expect 'ranges and comparisons of identities' "$cube
group a id 1:8:3
group b id <> 3 5
group c id >= 7
group d id 2 4:5
group n id < 1
group n initialize
group u union a b
group i intersect b d
group s subtract all a b
group none subtract a b a" \
	'3 atoms in group a' '3 atoms in group b' '2 atoms in group c' '3 atoms in group d' \
	'0 atoms in group n' '5 atoms in group u' '2 atoms in group i' '3 atoms in group s' '0 atoms in group none'
expect 'a group adds up, clear empties it' "$cube
group a id 1
group a id 2
group a empty
group a clear" '1 atoms in group a' '2 atoms in group a' '0 atoms in group a'
expect 'dynamic groups follow region and variable' "$cube
region low block INF INF INF INF INF 0.25 units box
variable left atom x<0.25
group low dynamic all region low every 5
group lowleft dynamic all region low var left
velocity all set 0 0 6 units box
variable n equal count(low)
variable m equal count(lowleft)
fix move all nve
timestep 0.01
thermo_style custom step v_n v_m
thermo 1
run 7" '4 atoms in group low' '2 atoms in group lowleft' \
	'       0              4              2 ' '       4              4              2 ' \
	'       5              0              0 ' '       6              0              0 '
cat >in.half <<'END'
timestep 0.01
fix move all nve
thermo_style custom step v_n
thermo 1
END
dynamic="region low block INF INF INF INF INF 0.25 units box
variable n equal count(low)"
expect 'whole' "$cube
$dynamic
group low dynamic all region low every 5
velocity all set 0 0 11.3 units box
include in.half
run 18"
rows out >whole
expect 'in two runs and through a restart file' "$cube
$dynamic
group low dynamic all region low every 5
velocity all set 0 0 11.3 units box
include in.half
run 4
run 3
write_restart half.restart
clear
read_restart half.restart
$dynamic
include in.half
run 11"
rows out >parts
same 'dynamic groups: a run in parts is the whole run' whole parts
expect 'static ends it' "$cube
group a dynamic all every 3
group a static
group a clear" '8 atoms in group a' '0 atoms in group a'
reject 'all is protected' "$cube
group all id 1" 'group all always has all particles'
reject 'a dynamic group changes by itself' "$cube
group a dynamic all
group a id 1" "group 'a' is dynamic"
reject 'dynamic of dynamic' "$cube
group a dynamic all
group b dynamic a" 'its parent group a is dynamic too'
reject 'parents stay' "$cube
group a id 1
group b dynamic a
group a delete" "group 'a' is the parent of the dynamic group 'b'"
reject 'molecules' "$cube
group a molecule 3" 'particles belong to no molecules'
reject 'a bad range' "$cube
group a id 3:x" "'3:x' is not a number n or a range"
groups=$(for k in $(seq 1 32); do echo "group g$k id 1"; done)
reject 'too many groups' "$cube
$groups" 'no room for group'

expect 'set from left to right' "$cube
set atom 1 mass 3 diameter 0.2
set atom 2 diameter 0.2 mass 3
set atom 3 density 1000 diameter 0.2
group one id 1
print \"one \$(floor(1e12*abs(mass(one)-8/9)))\"
group one clear
group one id 2
print \"two \$(mass(one))\"
group one clear
group one id 3
print \"three \$(floor(1e12*abs(mass(one)-1000*PI/6*0.008)))\"" 'one 0' 'two 3' 'three 0'
expect 'parts of a group' "$cube
set group all type/ratio 2 0.375 86028157
group two type 2
set group all type/subset 3 5 28157
group three type 3
set group all type/fraction 1 1 86028157
group one type 1
set group all type/fraction 2 0 86028157" \
	'  3 settings made for type/ratio' '3 atoms in group two' '5 atoms in group three' \
	'8 atoms in group one' '  0 settings made for type/fraction'
expect 'images, spins' "$cube
set atom 3*4 image 2 NULL -1 omega 1 2 3
compute i all property/atom ix iy iz omegaz
compute s all reduce sum c_i[1] c_i[2] c_i[3] c_i[4]
print \"images \$(c_s[1]) \$(c_s[2]) \$(c_s[3]) \$(c_s[4])\"" 'images 4 0 -2 6'
expect 'discs' 'dimension 2
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0
set atom 1 diameter 0.2 density/disc 100
print "$(mass(all):%.15g) $(PI:%.15g)"' '3.14159265358979 3.14159265358979'
reject 'discs in space' "$cube
set group all density/disc 3" 'particles are discs only after `dimension 2`'
reject 'unknown property' "$cube
set group all property/atom Temp 300" "no fix keeps a property 'Temp'"
reject 'no such fraction' "$cube
set group all type/fraction 2 1.5 3" "type/fraction is '1.5', expected a fraction"
reject 'too large a subset' "$cube
set group all type/subset 2 9 3" 'wants 9 particles, but only 8 are chosen'
reject 'image in a box that is not periodic' "${cube/p p p/p f p}
set group all image 0 1 0" 'not periodic in y'
reject 'molecules of set' "$cube
set mol 1 vx 2" 'particles belong to no molecules'

expect 'random deletion' "$cube
delete_atoms random count 3 yes all NULL 86028157
delete_atoms random fraction 0.4 yes all NULL 86028157 bond no
delete_atoms porosity NULL 1 28157" \
	'Deleted 3 atoms, new total = 5' 'Deleted 2 atoms, new total = 3' 'Deleted 3 atoms, new total = 0'
expect 'deletion by variable and porosity of a region' "$cube
region low block INF INF INF INF INF 0.25 units box
variable v atom id==5
delete_atoms variable v
delete_atoms porosity all low 1 28157 compress no" \
	'Deleted 1 atoms, new total = 7' 'Deleted 4 atoms, new total = 3'
reject 'more than there are' "$cube
delete_atoms random count 9 yes all NULL 3" '9 are to go, but there are only 8'
reject 'a seed of 0' "$cube
delete_atoms porosity NULL 0.5 0" "'0' is not a seed"
expect 'bonds of a type' "$cube
bond_style contact
bond_coeff 1*2 stiffness 20 ultimate 3
create_bonds single/bond 1 1 2
create_bonds single/bond 1 3 4
create_bonds single/bond 1 5 6
group low id 1 2 3
set atom 3*4 bond 2
set atom 1 type 2
delete_bonds all stats
delete_bonds low bond 2
delete_bonds low bond 2 any remove
delete_bonds all atom 2
delete_bonds all" '  1 settings made for bond' '3 bonds of 2 types' 'Deleted 0 bonds, total bonds = 3' \
	'Deleted 1 bonds, total bonds = 2' 'Deleted 1 bonds, total bonds = 1' 'Deleted 1 bonds, total bonds = 0'
reject 'undo' "$cube
delete_bonds all undo" 'undo is not possible'
expect 'random velocities without momentum and angular momentum' "$cube
variable k equal 1.380649e-23
velocity all create \$(2.385/v_k) 4928459 rot yes dist gaussian
variable l equal abs(angmom(all,x))+abs(angmom(all,y))+abs(angmom(all,z))
variable p equal abs(vcm(all,x))+abs(vcm(all,y))+abs(vcm(all,z))
variable t equal abs(2*ke(all)/21/2.385-1)
print \"zero \$(floor(1e10*v_l/mass(all))) \$(floor(1e10*v_p)) \$(floor(1e10*v_t))\"
velocity all scale \$(0.385/v_k)
print \"scaled \$(floor(1e10*abs(2*ke(all)/21/0.385-1)))\"
velocity all create 0 1 sum yes
print \"kept \$(floor(1e10*abs(2*ke(all)/21/0.385-1)))\"" 'zero 0 0 0' 'scaled 0' 'kept 0'
# 8 spheres of I = 2/5 m r^2, spinning by 3 about z
expect 'a rigid turn is taken away, and spins' "$cube
variable vx atom -2.385*y
variable vy atom 2.385*x
set group all vx v_vx vy v_vy omegaz 3
velocity all zero linear
velocity all zero angular
compute e all erotate/sphere
print \"rest \$(floor(1e12*ke(all))) spinning \$(c_e:%.12g)\"
velocity all zero angularIndividual
print \"still \$(c_e)\"" 'rest 0 spinning 10.9243543821' 'still 0'
reject 'at rest' "$cube
velocity all scale 3" 'the group is at rest'
reject 'counted steps' "$cube
fix t all ave/time 1 10 10 c_none
reset_timestep 5" 'c_none'
reject 'averages count steps' "$cube
variable a equal ke
fix t all ave/time 1 10 10 v_a
reset_timestep 5" 'fix t (ave/time, in.script:10) counts steps'
reject 'a motion goes on in time' "$cube
fix t all move linear 1 0 0
run 3
reset_timestep 0" 'moves by the time since its definition'
reject 'a wall oscillates on in time' "${cube/p p p/f f f}
fix w all wall/gran hooke/history 200000.0 NULL 50.0 NULL 0.5 1 zplane -5 NULL wiggle z 0.001 0.02
run 3
reset_timestep 0" 'moves by the time since its definition'
finish
