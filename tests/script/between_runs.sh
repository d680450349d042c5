#!/bin/bash
# What is read and changed between runs: outputs after particles were deleted, outputs that share a table, members of
# rigid bodies that commands move, fixes that are defined anew.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"

box='units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block 0 2 0 1 0 1 units box
create_box 1 box
neighbor 0.02 bin
timestep 1e-5'
materials='fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *'
grains() { # X,Y,Z...: of diameter 0.1
	local at
	for at; do echo "create_atoms 1 single ${at//,/ } units box"; done
	echo 'set group all diameter 0.1 density 2500'
}

# ---- outputs of one style that share a table
prints "$box
$(grains 0.3,0.5,0.5 0.7,0.5,0.5)
velocity all set 2 1 0
compute t all temp
compute p all pressure t
thermo_modify temp t press p
variable a equal c_t[1]-c_t[2]
variable b equal temp
variable c equal c_t[1]-c_t[2]
fix i all nve/sphere
thermo_style custom step c_t[1] temp c_t[1] v_a v_b v_c c_p[1] press c_p[1]
run 0
print \"the same \$(v_a==v_c) \$(v_a:%.6g)\"" '*the same 1 7.85398' &&
	awk 'NF == 10 && $1 == "0" { n++; bad = $2 != $4 || $2 == $3 || $5 != $7 || $8 != $10 } END { exit bad || !n }' out
report 'vectors beside the scalars that replace temp and press' $? out
prints "$box
$(grains 0.5,0.5,0.5)
fix a all addforce 1 2 3
fix_modify a energy yes
thermo_style custom step f_a[1] pe f_a[3]
run 0"

# ---- contacts after particles were deleted or read
column=$(grains 0.3,0.5,0.5 0.6,0.5,0.0495 0.9,0.5,0.5 1.2,0.5,0.049 1.2,0.5,0.1485)
prints "$box
$materials
$column
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0 contacts
compute l all wall/gran/local id force primitives yes
compute ids all reduce max c_l[3]
compute sum all reduce sum c_l[6]
compute n all coordination walls yes
variable f2 equal f_w[2][4]
variable f4 equal f_w[4][4]
thermo_style custom step c_n[8] c_sum c_ids
run 0
variable all equal v_f2+2*v_f4+3*c_sum+4*c_ids
variable was equal \$(v_all)
write_restart r
region r block -1 0.4 INF INF INF INF units box
delete_atoms region r compress no
print \"after: \$(c_n[8]) the same \$(v_all==v_was)\"" 'after: 2 the same 1'
prints "clear
read_restart r
$materials
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0 contacts
print \"read \$(f_w[2][4]>0) \$(f_w[4][4]>0) \$(f_w[1][4])\"" '*read 1 1 0'
# the list is that of the next run, so nothing is told before
for output in c_k 'c_s'; do
	rejects "$box
$materials
$column
compute k all contacts
compute s all reduce sum c_k
thermo_style custom step c_k c_s
run 0
delete_atoms group all compress no
print \$($output)" 'contacts are known only after a run, and not if particles have been added or deleted since'
done
# -check finds it in a dump, too, which it does not write
printf '%s\n' "$box" "$materials" "$column" 'compute p all pair/gran/local pos id force' 'write_dump all local p.txt c_p[1]' >in.dump
for check in -check '-log none'; do
	# shellcheck disable=SC2086
	refused "contacts in a dump, $check" 'contacts are known only after a run' $check -in in.dump
done
sed -i 's/^write_dump/run 1\n&/' in.dump
"$TSIM" -check -in in.dump >out 2>&1 && "$TSIM" -in in.dump -log none >out 2>&1
report 'contacts in a dump behind a run' $? out
prints 'units si
atom_style sphere
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box bond/types 1
create_atoms 1 single 0.2 0.5 0.5
create_atoms 1 single 0.21 0.5 0.5
create_atoms 1 single 0.22 0.5 0.5
set group all diameter 0.01 density 1000
bond_style contact
bond_coeff 1 stiffness 10 ultimate 1
create_bonds many all all 1 0.009 0.011
compute b all bonds
timestep 1e-4
fix i all nve
run 0
print "before $(c_b)"
group last id 3
delete_atoms group last compress no
print "after $(c_b)"' 'before 2' 'after 1'
prints 'units si
atom_style sphere
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box bond/types 1
create_atoms 1 single 0.2 0.5 0.5
create_atoms 1 single 0.21 0.5 0.5
set group all diameter 0.01 density 1000
bond_style contact
bond_coeff 1 stiffness 10 ultimate 0.01
create_bonds many all all 1 0.009 0.011
velocity all ramp vx 0 1 x 0.2 0.21
timestep 1e-4
fix i all nve
fix s all bond/store/local 10 id1 id2 time
compute r all reduce sum f_s[3] inputs local
thermo_style custom step brokenbonds c_r
thermo 1
run 20
reset_timestep 11
run 0
print "broken $(brokenbonds) listed $(c_r)"' 'broken 1 listed 0'

# ---- what a new run notices: forces are recomputed if what they depend on has changed
pair="$box
$materials
$(grains 0.5,0.5,0.5 0.599,0.5,0.5)
timestep 1e-6
fix i all nve/sphere"
for change in 'fix m1 all property/global youngsModulus peratomtype 2e7' \
	'unfix m1
fix other all property/global youngsModulus peratomtype 2e7'; do
	prints "$pair
run 0
variable f equal \$(fx[2])
$change
run 0
print \"ratio \$(fx[2]/v_f:%.12g)\"" 'ratio 4'
done
prints "$pair
run 10
variable a equal \$(vx[2])
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
run 10
variable b equal \$(vx[2])
clear
$pair
run 20
print \"the same number again changes nothing \$(vx[2]==v_b)\"" '*the same number again changes nothing 1'
prints "$box
$(grains 0.5,0.5,0.5)
variable k equal 1
variable a atom type*v_k
fix f all addforce v_a 0 0
run 0
print \"first \$(fx[1])\"
variable k equal 3
run 0
print \"then \$(fx[1])\"
variable a atom type*5
run 0
print \"last \$(fx[1])\"" 'first 1' 'then 3' 'last 5'

# ---- rigid bodies follow their members
body="$box
$(grains 0.5,0.5,0.5 0.55,0.5,0.5)
timestep 1e-3
fix r all rigid single"
prints "$body
velocity all set 1 0 0
run 100
print \"at \$(x[1]:%.12g) \$(x[2]:%.12g)\"
displace_atoms all move 0 0 0.1 units box
set atom 1 vz 1
set atom 2 vz 1
run 100
print \"at \$(x[1]:%.12g) \$(z[1]:%.12g)\"" 'at 0.6 0.65' 'at 0.7 0.7'
prints "$body
set atom 1 vy -0.05
set atom 2 vy 0.05
run 0
variable w equal 0.025*0.05/(0.025^2+0.4*0.05^2)
print \"turns \$(omegaz[1]/v_w:%.12g) \$((vy[2]-vy[1])/0.05/v_w:%.12g)\"" 'turns 1 1'
prints "$body
displace_atoms all rotate 0.525 0.5 0.5 0 0 1 90 units box
run 100
print \"at \$(x[1]:%.10g) \$(y[2]:%.10g)\"" 'at 0.525 0.525'
prints "$body
change_box all x final 0 4 remap units box
run 1
print \"at \$(0.5*(x[1]+x[2]):%.10g) \$(x[2]-x[1]:%.10g)\"" 'at 1.05 0.05'
rejects "$body
replicate 2 1 1" 'belongs to a rigid body, which is not copied'
prints "$box
replicate 1000000 100000 1" '*0 atoms'

# ---- fixes that are defined anew under their own name
plate 2 0 >cut.stl
prints "$box
$(grains 0.5,0.45,0.6)
timestep 1e-4
fix i all nve/sphere
fix cut all mesh/surface/planar file $work/cut.stl type 1 move 0.5 0.5 0.5
fix f all massflow/mesh mesh cut vec_side 0 0 -1 count once
velocity all set 0 0 -1 units box
run 2000
print \"passed \$(f_f[2])\"
velocity all set 0 0 1 units box
run 2000
velocity all set 0 0 -1 units box
fix f all massflow/mesh mesh cut vec_side 0 0 -1 count once
run 2000
print \"again \$(f_f[2])\"" 'passed 1' 'again 1'
prints "$box
$materials
$(grains 0.5,0.5,0.5 0.599,0.5,0.5)
pair_style gran model hertz tangential history surface multicontact
pair_coeff * *
fix c all multicontact/halfspace
run 1
fix c all multicontact/halfspace geometric_prefactor 1.2
run 1
fix c all multicontact/halfspace
run 1"
rejects "$box
$materials
fix c all multicontact/halfspace
fix d all multicontact/halfspace" 'there is one already, fix c'
prints "$box
fix m all multisphere
fix m all multisphere"

# ---- words that are named like keywords
rejects "$box
fix m all massflow/mesh count once file mesh" "keyword 'mesh' is missing"
rejects "$box
region type block 0 2 0 1 0 1 units box
fix m all mesh/surface file $work/cut.stl region type" "keyword 'type' is missing"
prints "$box
region move block 0 2 0 1 0 1 units box
fix m all mesh/surface file $work/cut.stl type 1 region move"
# ---- a stream whose particles are on their way when the time step changes
printf '0 0 0 0.02\n0.02 0 0 0.02\n' >two.txt
stream() { # TEMPLATE MOVER: speed 1 towards the face at z = 0.5
	printf '%s\n' "$box" "$materials" "$1" 'fix pdd all particledistribution/discrete 15485867 1 pts 1.0' \
		"fix face all mesh/surface/planar file $work/cut.stl type 1 move 0.5 0.5 0.5" "fix i all $2" \
		'timestep 1e-4' 'fix ins all insert/stream seed 32452843 distributiontemplate pdd nparticles 1 vel constant 0 0 -1 particlerate 10 insertion_face face extrude_length 0.4' \
		'fix g all gravity 9.81 vector 0 0 -1
compute z all reduce max z
run 1001
variable z equal $(c_z)
timestep 5e-5
run 1
print "moved $((v_z-c_z)/5e-5:%.9g)"
variable n equal floor((c_z-0.501)/5e-5)
run ${n}
compute v all reduce min vz
run 0
print "held $(c_v:%.12g)"
run 200
print "free $(c_v<-1.05)"'
}
spheres='fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.02'
clumps="fix pts all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 2 ntry 10000 spheres file $work/two.txt scale 1.0 type 1"
prints "$(stream "$spheres" nve/sphere)" 'moved 1' 'held -1' 'free 1'
prints "$(stream "$clumps" multisphere)" 'moved 1' 'held -1' 'free 1'

# ---- outputs that read what has been deleted or replaced since the last run
two="$box
$materials
$(grains 0.5,0.5,0.5 0.599,0.5,0.5)
run 0"
for style in 'pair_style gran model hertz tangential history' 'pair_style gran model hooke'; do
	rejects "$two
$style
print \$(pe)" '`run 0` finds them'
done
prints "$two
variable p equal \$(pe)
pair_style gran model hertz tangential history
pair_coeff * *
write_restart r
run 0
print \"the same \$(pe==v_p)\"" 'the same 1'
prints "$two
fix mark all property/atom mark scalar yes no no 3
compute most all reduce max f_mark
run 0
unfix mark
print \"kept \$(c_most)\"" 'kept 3'
bonds='units si
atom_style sphere
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box bond/types 1
create_atoms 1 single 0.2 0.5 0.5
create_atoms 1 single 0.21 0.5 0.5
set group all diameter 0.01 density 1000
bond_style parallel
bond_coeff 1 kn 1e9 ks 4e8
create_bonds many all all 1 0.009 0.011
fix i all nve/sphere
timestep 1e-7'
rejects "$bonds
print \$(press)" '`run 0` finds them'
rejects "$bonds
compute b all bond/local shear
compute s all reduce max c_b inputs local
run 0
bond_style none
print \$(c_s)" 'no bond style'
prints "$bonds
fix l all energy/ledger
run 1
bond_style none
run 1"
pad='units si
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
fix pad all surface/voxel constant 0.1 type 1 cells 8 8'
rejects "$pad
compute s all surface/contact pad pressure 1e3 E 1e9
run 0
unfix pad
print \$(c_s)" 'pad'
rejects "$pad
dump restart all custom 1 f.dump id
restart 10 r" "there is a dump with the ID 'restart'"

# ---- dumps after reset_timestep, and of one frame
few="$box
$(grains 0.5,0.5,0.5)
fix i all nve/sphere"
prints "$few
dump d all custom 10 o.*.dump id x
dump_modify d maxfiles 2 units yes
run 10
reset_timestep 0
run 10" && [ -s o.0.dump ] && [ -s o.10.dump ] && grep -q UNITS o.10.dump
report 'the file just written is not the oldest one' $?
prints "$few
dump d all custom/vtk 10 o.*.vtp id x
run 10
reset_timestep 0
run 10" && [ "$(grep -c 'o.0.vtp' o.pvd)" = 1 ]
report 'a file is once in its collection' $?
prints "$few
write_dump all custom a.dump id x modify delay 1000
write_dump all custom b.dump id x modify every 7
run 5
write_dump all custom c.dump id x modify every 7" && [ -s a.dump ] && [ -s b.dump ] && [ -s c.dump ]
report 'write_dump writes, whatever its interval' $?
prints "$box
$(grains 0.5,0.5,0.9 0.6,0.5,0.7 0.7,0.5,0.8)
variable v atom id
dump d all custom/vtk 1 s.*.vtk id x y z v_v vx
dump_modify d sort 4
run 0" && tr '\n' ' ' <s.0.vtk | grep -q 'POINTS 3 [a-z]* 0.6 0.5 0.7 0.7 0.5 0.8 0.5 0.5 0.9'
report 'rows in the order of the column as it is written in the script' $?
prints "units si
atom_style sphere
boundary p f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 1000 vx 1
fix i all nve
timestep 0.01
dump d all custom 100 u.dump id xu y z vx vy vz
compute m all msd
thermo_style custom step c_m[4]
run 300
clear
units si
atom_style sphere
boundary p f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 1000
compute m all msd
thermo 100
thermo_style custom step c_m[4]
rerun u.dump dump x y z
print 'at \$(xcm(all,x):%.12g)'" 'at 3.5'
# ---- templates that are defined anew: mean masses, and the particle that waits for room
sphere() { echo "fix $1 all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant $2"; }
prints "$box
$materials
$(sphere a 0.01)
$(sphere b 0.01)
fix d all particledistribution/discrete 32452843 2 a 0.5 b 0.5
fix ins all insert/rate/region seed 49979687 distributiontemplate d nparticles 100000 massrate 50 insert_every 100 region box
fix i all nve/sphere
run 200
variable before equal \$(f_ins[2])
delete_atoms group all
$(sphere b 0.02)
run 1000
print \"rate \$(round((f_ins[2]-v_before)/0.05)/10)\"" 'rate 1'
prints "$box
$materials
$(sphere a 0.02)
fix d all particledistribution/discrete 32452843 1 a 1
fix ins all insert/jet seed 49979687 distributiontemplate d position 0.5 0.5 0.9 direction 0 0 -1 diameter 0.1 speed constant 1 particlerate 91000 time 1 all_in yes
fix i all nve/sphere
run 20
delete_atoms group all
$(sphere a 0.01)
run 1
compute r all reduce max radius
run 0
print \"largest \$(c_r:%.6g)\"" 'largest 0.01'
# a particle half a skin beyond a periodic face is in the region on the other side
prints "units si
atom_style sphere
boundary p p p
neighbor 0.2 bin
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.99 0.5 0.5
create_atoms 1 single 0.5 0.5 0.5
set group all diameter 0.1 density 1000
set atom 1 vx 1
region all block 0 1 0 1 0 1 units box
compute l all leave all
compute s all stress/region all ke
compute m all mixing lacey type 1 cell 0.5
fix i all nve
timestep 0.01
thermo_style custom step c_l[1] c_s[1] c_m[3]
run 5
variable now equal \$(c_s[1])
variable samples equal \$(c_m[3])
neighbor 0.21 bin
run 0
print \"left \$(c_l[1]) the same \$(c_s[1]==v_now&&v_now!=0) \$(c_m[3]==v_samples)\"" 'left 0 the same 1 1'

# ---- restart files: fixes that stand before read_restart, bodies whose fix is missing, what was there before
cut="write_restart cut.restart
run 10
print \"end \$(x[1]:%.17g) \$(z[2]:%.17g) \$(ke:%.17g)\" file whole.txt screen no"
# same_end WHAT FIRST SECOND: the second script goes on from the file as the first one does
same_end() {
	printf '%s\n%s\n' "$2" "$cut" >in.first
	printf '%s\nrun 10\nprint "end $(x[1]:%%.17g) $(z[2]:%%.17g) $(ke:%%.17g)" file part.txt screen no\n' "$3" >in.second
	rm -f whole.txt part.txt
	"$TSIM" -in in.first -log none >out 2>&1 && "$TSIM" -in in.second -log none >out 2>&1 && cmp whole.txt part.txt >>out
	report "$1" $? out
}
atoms='units si
atom_modify map array
boundary f f f
region b block -0.05 0.05 -0.05 0.05 0 0.1 units box'
two='create_box 2 b
create_atoms 1 single 0 0.001 0.00499 units box
create_atoms 2 single 0.001 0 0.01489 units box
set group all diameter 0.01 density 2500
velocity all set 0.05 0 -0.1'
motion='pair_style gran/hooke/history 5000 NULL 500 NULL 0.5 1
pair_coeff * *
fix move all nve/sphere
fix fall all gravity 9.81 vector 0 0 -1
fix floor all wall/gran hooke/history 5000 NULL 500 NULL 0.5 1 zplane 0 NULL
timestep 2e-5'
same_end 'a column whose fix is gone' "$atoms
$two
$motion
fix count all property/atom d_q
run 5
unfix count
run 10" "units si
atom_modify map array
read_restart cut.restart
$motion"
same_end 'exclusions that were removed' "$atoms
$two
$motion
group few id 2
neigh_modify exclude type 1 2
neigh_modify exclude none
neigh_modify exclude group few few
run 10" "units si
atom_modify map array
read_restart cut.restart
$motion
neigh_modify exclude type 1 2
neigh_modify exclude none
neigh_modify exclude group few few"
printf '%s\n' "$atoms" 'fix pm all property/atom mol d_q' "$two" 'set atom 1 mol 7' 'set group all d_q 3.5' "$motion" 'run 3' 'write_restart mol.restart' >in.mol
"$TSIM" -in in.mol -log none >out 2>&1
report 'molecules before the box' $? out
prints "units si
fix pm all property/atom mol d_q
read_restart mol.restart
$motion
compute m all property/atom mol d_q
compute s all reduce sum c_m[1] c_m[2]
run 1
print \"sums \$(c_s[1]) \$(c_s[2])\"" 'sums 7 7'
# numbers that were stored, and drawn, before
drawn='variable q equal random(0,1,4711)
variable r atom v_q+0*x
fix st all store/state 0 v_r'
printf '%s\n' "$atoms" "$two" "$drawn" "$motion" 'run 3' 'write_restart drawn.restart' 'run 3' 'print "next $(v_q:%.12g)" file next.whole screen no' >in.drawn
printf '%s\n' 'units si' 'read_restart drawn.restart' "$drawn" "$motion" 'run 3' 'print "next $(v_q:%.12g)" file next.part screen no' >in.again
"$TSIM" -in in.drawn -log none >out 2>&1 && "$TSIM" -in in.again -log none >out 2>&1 && cmp next.whole next.part >>out
report 'random numbers of fix store/state' $? out
# bodies
printf '%s\n' "$atoms" "$two" "$motion" 'unfix move' 'fix body all rigid single' 'run 3' 'write_restart body.restart' >in.body
"$TSIM" -in in.body -log none >out 2>&1
report 'a body' $? out
prints "units si
read_restart body.restart
$motion
run 1" '*rigid bodies of the restart file are dissolved (1)'
prints "units si
read_restart body.restart
$motion
unfix move
fix body all rigid single
run 1"
! grep -q dissolved out
report 'a body whose fix is defined again' $? out

# a body cannot lose a particle
rejects "$atoms
$two
$motion
unfix move
fix body all rigid single
region in block INF INF INF INF INF INF units box
fix x all evaporate 2 1 in 49892
run 3" 'belongs to a rigid body, which cannot lose particles'

# ---- a wall that is replaced by one like it has not had the contacts: its forces are those of a set-up
prints "$atoms
$two
$motion
thermo_style custom step f_floor[3]
run 20
variable before equal \$(f_floor[3])
unfix floor
fix floor all wall/gran hooke/history 5000 NULL 500 NULL 0.5 1 zplane 0 NULL
run 0
print \"pushed \$(f_floor[3]<0)\"" 'pushed 1'

# ---- a box that a command changes while fix deform is active
prints "units lj
boundary p p p
lattice sc 1.0
region box block 0 5 0 5 0 5 units box
create_box 1 box
create_atoms 1 region box
set group all diameter 0.9 density 1
fix 1 all nve/sphere
fix d1 all deform 1 x erate -0.5
timestep 0.001
run 5
replicate 2 1 1
run 5
variable first equal \$(lx)
change_box all x scale 0.9 remap units box
run 5
print \"lengths \$(v_first:%.8g) \$(lx:%.8g)\"" "lengths $(awk 'BEGIN { a = 5 * (1 - 0.0025) * 2 * (1 - 0.0025); printf "%.8g %.8g", a, a * 0.9 * (1 - 0.0025) }')"
finish
