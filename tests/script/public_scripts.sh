#!/bin/bash
# What public scripts of LIGGGHTS and LAMMPS say and expect: outputs, words without effect, files, -check of what the script writes.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

empty='units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.1 0.1 -0.1 0.1 0 0.2 units box
create_box 2 box
neighbor 0.002 bin
timestep 1e-5'
law='fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
pair_style gran model hertz tangential history
pair_coeff * *'
three="$empty
create_atoms 1 single 0 0 0.05 units box
create_atoms 1 single 0.0199 0 0.05 units box
create_atoms 1 single 0.0398 0 0.05 units box
set group all diameter 0.02 density 2500
fix move all nve/sphere"

agree 'f_ID of fix heat/gran: temperatures of particles, and their content' "$three
$law
fix ftco all property/global thermalConductivity peratomtype 5 5
fix ftca all property/global thermalCapacity peratomtype 10 10
fix warm all heat/gran initial_temperature 300
compute mean all reduce ave f_warm
run 0
set atom 1 property/atom Temp 390
run 0
print \"is mean \$(c_mean) 330\"
print \"is content \$(f_warm/mass(all)/10) 330\""

{ sed 's/^run.*//' "$top_srcdir/tests/decks/in.clumps"; cat <<'END'; } >in.turning
compute all all erotate
compute loose all erotate/sphere
compute part loose erotate
run 700
print "is erotate $(c_all) $(c_turning+c_loose)"
print "is keyword $(erotate) $(c_all)"
print "is part $(c_part) $(c_loose)"
variable spins equal (c_turning>0)*(c_loose>0)
print "is both $(v_spins) 1"
END
agree 'the energy of rotation of clumps and spheres' "variable out index turning
$(cat in.turning)"

count='compute touching all contact/atom
compute near all coord/atom 0.021
compute sums all reduce sum c_touching c_near
run 0
print "is touching $(c_sums[1]) $(v_pairs)"
print "is near $(c_sums[2]) $(v_pairs)"'
agree 'contacts of all' "$three
variable pairs equal 4
$count"
agree 'contacts without excluded pairs' "$three
variable pairs equal 2
group two id 1 2
neigh_modify exclude group two two
$count"
agree 'contacts within a rigid body' "$(sed 's/^fix move.*/group two id 1 2\ngroup one id 3\nfix body two rigid single\nfix move one nve\/sphere/' <<<"$three")
variable pairs equal 2
$count"

prints "$empty
group none empty
fix watch all print 1 \"\$(xcm(all,z)) \$(vcm(none,x)) \$(gyration(all)) \$(inertia(all,xx)) \$(omega(all,y)) \$(angmom(all,z)) \$(bound(all,xmin)) \$(bound(none,zmax))\"
run 1" '0 0 0 0 0 0 1e+20 -1e+20'
[ "$(grep -c 'has no particles' out)" = 1 ]
report 'nobody is warned of once' $? out

prints "$three
run_style verlet
suffix off
suffix hybrid intel omp
restart 2 a.*.restart
restart 3 b.restart c.restart
run 6
restart 0
run 6
print done" done
[ -f a.2.restart ] && [ -f a.4.restart ] && [ -f a.6.restart ] && [ ! -f a.8.restart ] && [ -f b.restart ] && [ -f c.restart ]
report 'both series are written' $? out
rejects "$three
run_style respa 2" 'verlet'

prints "$three
$law
compute pairs all pair/gran/local id
dump d all local 10 label.txt c_pairs[1] c_pairs[2]
dump_modify d label BONDS
run 0" '*Loop time'
printf 'ITEM: NUMBER OF BONDS\nITEM: BONDS c_pairs[1] c_pairs[2] \n' >wanted
grep 'BONDS' label.txt >found
same 'the label of a local dump' wanted found

prints "$(sed "s/block -0.1 0.1/block \$(-1\/7) \$(0.1+1e-9)/" <<<"$three")
dump d all custom 1 box.dump id type x y z radius
run 0
variable wide equal lx
print 'first \${wide}'
clear
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -0.1 0.1 -0.1 0.1 0 0.2 units box
create_box 1 box
read_dump box.dump 0 type x y z radius box yes add yes
variable wide equal lx
print 'again \${wide}'" '*again'
awk '$1 == "first" { first = $2 } $1 == "again" { again = $2 } END { exit !(first == again && first > 0) }' out
report 'bounds of dumps have all digits' $? out

prints "$three
compute sums all reduce sum x y z
fix mean all ave/time 1 2 2 c_sums mode vector
thermo_style custom step f_mean[1] f_mean[3]
thermo_modify format float %.5f
run 2" '       0 0.00000 0.00000 ' '       2 0.05970 0.15000 '

prints "$empty
variable y equal 3
variable s string \"a \${y} \$(v_y+1) b\"
variable y delete
print \"\${s}\"
run 0 every 1 \"print 'after none'\"
run 5 every 2 \"print 'after \$(step)'\"" 'a 3 4 b' 'after none' 'after 2' 'after 4' 'after 5'

# clumps as LAMMPS' scripts define them: by the molecule ids of a data file
printf 'two molecules\n\n4 atoms\n1 atom types\n0 6 xlo xhi\n0 6 ylo yhi\n0 6 zlo zhi\n\nAtoms # hybrid\n\n1 1 1 1 1 1 1 7\n2 1 1.8 1 1 1 1 7\n3 1 1 3 1 1 1 8\n4 1 1.8 3 1 1 1 8\n' >mol.data
molecules='units lj
atom_style hybrid sphere molecular
newton off
comm_modify vel yes cutoff 3
read_data mol.data
pair_style gran/hooke/history 1000 NULL 10 NULL 0.3 0
pair_coeff * *
neigh_modify exclude molecule/intra all
group one molecule 7
velocity one set 0.1 0 0
fix 1 all rigid/small molecule
timestep 0.001
compute mol all property/atom mol
compute most all reduce max c_mol
run 5'
prints "$molecules
print \"\$(c_most) \$(count(one)) \$(vcm(one,x):%g) \$(mol[1])\"
write_data again.data" '8 2 0.1 7'
cp again.data mol.data
prints "$molecules
print \"\$(c_most) \$(count(one)) \$(mol[3])\"" '8 2 8'

for command in 'run 1' 'print "$(count(two))"'; do
	cat >in.script <<END
$three
group two id 1 2
write_restart two.restart
clear
newton off
communicate single vel yes
read_restart two.restart
fix move two nve/sphere
timestep 1e-5
$command
END
	rm -f two.restart
	"$TSIM" -check -in in.script >out 2>&1 && grep -q '^no errors' out
	report "-check: groups of a restart file that the script writes: $command" $? out
done
cat >in.script <<END
$three
$law
print 'solid a' file a.stl
print 'facet normal 0 0 1' append a.stl
print 'outer loop' append a.stl
print 'vertex 0 0 0.01' append a.stl
print 'vertex 0.02 0 0.01' append a.stl
print 'vertex 0 0.02 0.01' append a.stl
print 'endloop' append a.stl
print 'endfacet' append a.stl
print 'endsolid a' append a.stl
fix cad all mesh/surface/stress/servo file a.stl type 1 com 0 0 0.01 ctrlPV force axis 0 0 -1 target_val 1 vel_max 0.1 kp 0.2
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
run 1
fix_modify cad target_val 2
fix_modify cad servo/ctrlParam 0.1 0 0
run 1
print "place \$(f_cad[12]*1e6:%.2f)"
END
"$TSIM" -check -in in.script >out 2>&1 && grep -q '^no errors' out
report '-check: a mesh that print writes' $? out
"$TSIM" -in in.script -log none >out 2>&1
grep -q '^place 9998' out || grep -q '^place 9999' out
report 'words and the place of a servo' $? out
finish
