#!/bin/bash
# Regions made of tetrahedra and hexahedra.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
head='# vtk DataFile Version 2.0
cells
ASCII
DATASET UNSTRUCTURED_GRID'
cat >tet.vtk <<END2
$head
POINTS 6 float
0 0 0
1 0 0
0 1.1 0
0 0 0.9
1 1 1
-0.5 0.2 0.3
CELLS 5 21
1 0
3 0 1 2
4 0 1 2 3
4 1 2 3 4
4 0 2 3 5
CELL_TYPES 5
1
5
10
10
10
END2
cat >hex.vtk <<END2
$head
POINTS 8 float
0 0 0 1 0 0.2 1 1 0.2 0 1 0 0 0 1 1 0 1.2 1 1 1.2 0 1 1
CELLS 1 9
8 0 1 2 3 4 5 6 7
CELL_TYPES 1
12
END2
start='units si
boundary f f f
atom_style granular
atom_modify map array sort 0 0
newton off
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
lattice sc 0.0917'

# 6 V of a tetrahedron is the product of its edges from a corner; a sheared cube keeps its volume
agree 'volumes' "$start
region t mesh/tet file tet.vtk scale 0.7 move 0.1 0.2 -0.3 rotate 20 30 40 units box
region h mesh/hex file hex.vtk scale 0.7 move 0.1 0.2 -0.3 rotate 20 30 40 units box
region o mesh/hex file hex.vtk side out units box
print 'is tetrahedra \$(volume(t)) \$(0.343*(0.99+0.5*1.1*0.9+1.1*0.9+0.9+1.1-0.99)/6)'
print 'is hexahedron \$(volume(h)) 0.343'
create_atoms 1 region h
variable n equal count(all)
variable m equal count(all,h)
variable no equal count(all,o)+0
print 'is inside \$(v_m) \$(v_n)'"

rejects "$start
region t mesh/tet file hex.vtk units box" 'cell 1 of '"'hex.vtk'"' is of type 12, expected tetrahedra (10) only'
rejects "$start
region t mesh/hex file none.vtk units box" 'none.vtk'
rejects "$start
region t mesh/tet file tet.vtk scale 0 units box" 'scale'

# all_in yes: no sphere of diameter d reaches beyond the sheared cube, whose faces are x, y = 0, 1 and z - 0.2 x = 0, 1; above the
# face that two of them share there are some
sed -e 's/POINTS 8/POINTS 12/' -e 's/1 1 1.2 0 1 1$/& 0 0 2 1 0 2.2 1 1 2.2 0 1 2/' -e 's/CELLS 1 9/CELLS 2 18/' \
	-e 's/^8 0.*/&\n8 4 5 6 7 8 9 10 11/' -e 's/CELL_TYPES 1/CELL_TYPES 2/' -e 's/^12$/&\n12/' hex.vtk >two.vtk
agree 'all_in' "$(sed 's/-2 2 -2 2 -2 2/-1 2 -1 2 -1 3/' <<<"$start")
neighbor 0.01 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-6
region h mesh/hex file two.vtk scale 1 move 0 0 0 rotate 0 0 0 units box
fix t all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.1
fix p all particledistribution/discrete 15485867 1 t 1
fix i all insert/pack seed 32452843 distributiontemplate p insert_every once overlapcheck yes all_in yes particles_in_region 60 region h
run 1
variable in atom \"(abs(x-0.5)<=0.4)*(abs(y-0.5)<=0.4)*(abs(z-0.2*x-1)<=1-0.1*sqrt(1.04))\"
variable near atom \"abs(z-0.2*x-1)<0.1\"
compute in all reduce sum v_in
compute near all reduce sum v_near
thermo_style custom step c_in c_near
run 0
print 'is inside \$(c_in) 60'
print 'is shared \$(c_near>3) 1'"

if has liggghts; then
	cat >in.both <<END2
$start
neighbor 0.01 bin
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
region m mesh/tet file tet.vtk \${words} units box
create_atoms 1 region m
set group all diameter 0.0001 density 1000
timestep 1e-7
dump d all custom 1 \${out} id x y z
dump_modify d sort id
run 0
END2
	for words in 'scale 1.0 move 0 0 0 rotate 0 0 0' 'scale 1.1 move 0.1 0.2 -0.3 rotate 20 30 40'; do
		liggghts -in in.both -var words "$words" -var out theirs -log none >out 2>&1
		report 'LIGGGHTS' $? out
		"$TSIM" -in in.both -var words "$words" -var out ours -log none -screen none 2>out
		report 'tsim' $? out
		sed -i 1,9d theirs ours
		same "$words" theirs ours
	done
fi
finish
