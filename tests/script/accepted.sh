#!/bin/bash
# What scripts of LIGGGHTS have and LIGGGHTS runs: words of no effect here, files and faces that are off by
# rounding, walls across periodic dimensions.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

material='fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *'
box="units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
$material
create_atoms 1 single 0.06 0.5 0.5
create_atoms 1 single 0.94 0.52 0.5
set group all diameter 0.1 density 2500
timestep 1e-5
fix move all nve/sphere"

# A plane wall across a periodic dimension: the numbers of LIGGGHTS 3.8, with a warning. LAMMPS refuses it.
periodic="${box/f f f/p p f}
fix x1 all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix x2 all wall/gran model hertz tangential history primitive type 1 xplane 1.0
velocity all set 0 0.2 0
group a id 1
velocity a set -1.5 0.1 0"
prints "$periodic
run 10000
print \"\$(x[1]:%.9f) \$(vy[1]:%.9f) \$(x[2]:%.6f)\"" '0.084715321 0.070758852 0.940000' \
	'*warning: fix wall/gran: a plane wall across the periodic dimension x'
rejects "${box/f f f/p p f}
fix x1 all wall/gran hooke 1e5 NULL 10 NULL 0.5 0 xplane 0 1" 'a plane wall across the periodic dimension x'

# Words without effect
prints "$box
neigh_modify delay 0 contact_distance_factor 1.2
region a sphere 0.5 0.5 0.5 0.1 seed 300017 units box volume_limit 1e-12
region h sphere 0.5 0.5 0.5 0.1 units box
velocity all set 0.25 0 0
compute sum all reduce update_on_run_end yes sum vx
thermo_style custom step c_sum
run 1
print \"sum \$(c_sum)\"" 'sum 0.5'
rejects "$box
compute sum all reduce update_on_run_end maybe sum vx" 'update_on_run_end takes yes or no'

# A number of steps that is a time divided by the time step: the whole part, as in LIGGGHTS 3.8. The fewest points of
# a volume; the rotations that fix langevin leaves alone; a comment in a command of `if`, also of one not executed.
prints "$box
variable n equal 0.0001007/1e-5
run \${n}
run 20.9 upto
print \"step \$(step)\"" 'step 20' '*warning: run: N is 10.07, no integer: 10 is taken, as in LIGGGHTS'
prints "$box
fix g all check/timestep/gran 10.5 0.1 0.1 warn no
reset_timestep 7.9
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.01
fix pdd all particledistribution/discrete 15485867 1 pts 1.0
region mid sphere 0.5 0.5 0.5 0.2 units box
fix pack all insert/pack seed 32452843 distributiontemplate pdd start 10.3 insert_every 5.7 region mid particles_in_region 4.5
fix tracer all property/atom/tracer region_mark mid mark_step 15.5 check_mark_every 1
fix rain all insert/rate/region seed 32452867 distributiontemplate pdd start 19 nparticles 0.25e1 particlerate 1e6 insert_every 1 region mid
thermo_style custom step atoms f_tracer
thermo 1
run 18
print \"step \$(step) ratio \$(f_g[1]>0) atoms \$(atoms)\"" 'step 25 ratio 1 atoms 8' \
	'*warning: fix check/timestep/gran: N is 10.5, no integer: 10 is taken, as in LIGGGHTS' \
	'*warning: reset_timestep: step is 7.9, no integer: 7 is taken' \
	'*warning: fix insert/pack: start is 10.3, no integer: 10' \
	'*warning: fix insert/pack: insert_every is 5.7, no integer: 5' \
	'*warning: fix insert/pack: particles_in_region is 4.5, no integer: 4' \
	'*warning: fix property/atom/tracer: mark_step is 15.5, no integer: 15' \
	'*warning: fix insert/rate/region: nparticles is 0.25e1, no integer: 2'
rejects "$box
fix g all check/timestep/gran 1e5.5 0.1 0.1" "found '1e5.5', expected N fraction_r"
rejects "$box
dump d all custom 10.5 post.* id" "every is '10.5', expected an integer"
prints "$box
fix l all langevin 0 0 1 4711 angmom no omega no
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.01
fix pdd all particledistribution/discrete 15485867 1 pts 1.0
region mid sphere 0.5 0.5 0.5 0.2 units box
fix ins all insert/rate/region seed 32452843 distributiontemplate pdd nparticles 5 particlerate 1e6 insert_every 100 &
	overlapcheck yes region mid ntry_mc 1000
run 1
print \"atoms \$(atoms)\"" 'atoms 7'
commented="$box
if \"1 > 2\" then &
\"region one sphere 0 0 0 1 units box # walls\" &
else &
\"region two sphere 0 0 0 1 units box # no walls\"
group near region two"
printf '%s\n' "$commented" >in.commented
"$TSIM" -check -in in.commented >out 2>&1
report 'comments in branches' $? out

# The unit of lengths is asked for only where it matters: not for zeros, nor for a region that is made of others.
printf '%s\n' "${box//create_atoms/lattice sc 0.3
create_atoms}" | sed '2,$s/^create_atoms.*/& units box/' >in.units
printf '%s\n' 'region a plane 0 0 0 1 0 0 units box' 'region b plane 1 1 1 -1 0 0 units box' 'region c intersect 2 a b' \
	'velocity all set 0 NULL 0.0' 'run 0' >>in.units
"$TSIM" -in in.units -log none >out 2>&1 && ! grep 'lengths are taken' out
report 'no unit needed' $? out
echo 'velocity all set 0.1 0 0' >>in.units
"$TSIM" -in in.units -log none >out 2>&1 && grep -q 'lengths are taken' out
report 'unit needed' $? out

# A command in quotes, and names of kinds without `per`.
other=${material//peratomtypepair/atomtypepair}
prints "shell \"mkdir -p made/inner second\"
shell 'mv made moved'
${box/"$material"/${other/peratomtype /atomtype }}
run 1
print \"modulus \$(f_m1[1]) restitution \$(f_m3[1]:%g)\"" 'modulus 5000000 restitution 0.3'
[ -d moved/inner ] && [ -d second ]
report 'folders made and moved' $? out
rejects 'shell "rm -rf /etc/hosts"' 'not below'
rejects 'shell "make all"' "shell knows mkdir, mv, rm, rmdir and cd, not 'make all'"

prints "atom_style hybrid granular/omp bond/gran n_bondtypes 1 bonds_per_atom 6
$box
velocity all set 0 0 0
set atom 1 omegaz 3
thermo_style custom step numbond
dump a all custom 1 columns.dump thread angmomz
run 0
print \"bonds \$(numbond)\"" 'bonds 0'
[ "$(tail -n 2 columns.dump)" = "0 0.00392699 
0 0 " ]
report 'angular momentum' $? columns.dump

# The limit of a region is one of insertion into it.
insert="$box
fix t all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.01
fix d all particledistribution/discrete 32452843 1 t 1"
for limit in 0.0079 0.0081; do
	script="$insert
region bed block 0.4 0.6 0.4 0.6 0.4 0.6 units box volume_limit $limit
fix in all insert/pack seed 32452867 distributiontemplate d insert_every once region bed particles_in_region 3
run 1
print \"made \$(count(all))\""
	if [ $limit = 0.0079 ]; then
		prints "$script" 'made 5'
	else
		rejects "$script" 'region bed has a volume of about 0.008, below its volume_limit'
	fi
done

# ---- meshes
facets() { # z: a square
	local a='facet normal 0 0 1\nouter loop' b='endloop\nendfacet'
	printf "$a\nvertex 0 0 $1\nvertex 1000 0 $1\nvertex 1000 1000 $1\n$b\n"
	printf "$a\nvertex 0 0 $1\nvertex 1000 1000 $1\nvertex 0 1000 $1\n$b\n"
}
{
	printf '# made by hand\n\n; of two triangles\nTitle: a solid floor\nsolid floor\n'
	facets 26
	echo 'endsolid floor'
} >floor.stl
sed 1,4d floor.stl >plain.stl
sed 's/facet normal/facet, normal/' floor.stl >torn.stl

# Lines before `solid`; 26 * 0.001 > 0.026
fall="${box/0 1 units/0 0.026 units}
delete_atoms group all
create_atoms 1 single 0.5 0.4 0.02
set group all diameter 0.01 density 2500
velocity all set 0 0 0.5"
for file in plain floor; do
	prints "$fall
fix f all mesh/surface file $file.stl type 1 scale 0.001
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes f
run 2000
print \"speed \$(vz[1]:%.6f)\""
	grep '^speed' out >$file.out
	grep -q '^speed -0.1' $file.out
	report "bounces back from $file.stl" $? out
done
same 'lines before solid' plain.out floor.out
rejects "$fall
fix f all mesh/surface file torn.stl type 1 scale 0.001" "expected 'facet', 'solid' or 'endsolid'"
# a thousandth of the box is no rounding
rejects "$fall
fix f all mesh/surface file floor.stl type 1 scale 0.001 move 0 0 0.000026" 'outside the box'
# What each particle of a stream remembers: rows of LIGGGHTS 3.8, of one on its way and one that is free; the same
# after a restart.
{
	echo 'solid face'
	facets 500 | sed 's/vertex 0 /vertex 300 /; s/vertex 1000 /vertex 700 /; s/ 0 500/ 300 500/; s/ 1000 500/ 700 500/'
	echo 'endsolid face'
} >face.stl
remembered=$(for k in 1 2 3 4 5 6 7 8 9 10 11 12 13 14; do printf 'f_release_fix_insert_stream[%d] ' $k; done)
definitions="$material
timestep 1e-5
fix gravi all gravity 9.81 vector 1 0 0
fix pts1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.03
fix pdd1 all particledistribution/discrete 15485867 1 pts1 1.0
fix face all mesh/surface/planar file face.stl type 1 scale 0.001
fix ins all insert/stream seed 32452843 distributiontemplate pdd1 nparticles 30 particlerate 3000 overlapcheck yes &
	all_in yes vel constant 0 0.1 -2 omega constant 1 2 3 insertion_face face extrude_length 0.2
fix i all nve/sphere
dump d all custom 7000 NAME.dump id $remembered z vz
dump_modify d sort id"
printf '%s\n' "units si
boundary p f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
${definitions/NAME/whole}
run 6000
write_restart half.restart
run 8000" >in.whole
printf '%s\n' "read_restart half.restart
${definitions/NAME/rest}
run 8000" >in.rest
{ "$TSIM" -in in.whole -log none && "$TSIM" -in in.rest -log none; } >out 2>&1 &&
	grep -q '^1 0.46576 0.462028 0.607377 1 5369 -0 -0 -2 0 0.1 -2 1 2 3 0.327397 -2 $' whole.dump &&
	grep -q '^29 0.426232 0.484811 0.659366 1 7969 -0 -0 -2 0 0.1 -2 1 2 3 0.519386 -2 $' whole.dump
report 'streams remember' $? out
sed -n '/^7000$/,$p' whole.dump >expected
sed -n '/^7000$/,$p' rest.dump >found
same 'streams remember after a restart' expected found
rejects "$(sed 's/stream\[14\]/stream[15]/' in.whole)" 'release_fix_insert_stream'

# [k] of one number for each particle is that of the particle k, of several numbers the k-th.
grains='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.2 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.8 0.5 0.5 units box
set group all diameter 0.1 density 1000
fix go all nve/sphere
timestep 1e-5'
agree 'c_ID[k] in formulas for each particle' "$grains
compute one all property/atom x
compute two all property/atom x y
variable k atom c_one[3]+10*c_one
variable col atom c_two[1]
variable other atom c_two[2][1]
variable e equal c_one[3]
compute s all reduce sum v_k v_col v_other
run 0
print \"is one \$(c_s[1]) 17.4\"
print \"is two \$(c_s[2]) 1.5\"
print \"is other \$(c_s[3]) 1.5\"
print \"is equal \$(v_e) 0.8\""
prints 'if "1 == 2" "then" "print no" "elif" "2 == 2" "print yes" "else" "print neither"' yes
# Files are looked for in the folder of the script, however it was named, also when the working folder has changed.
mkdir -p beside/run/deep beside/deep
echo 'print "mine ${k}"' >beside/part.in
printf '%s\n' 'variable k loop 3' 'label again' 'if "${k} == 2" then "shell cd deep"' 'include part.in' 'next k' \
	'jump SELF again' 'print end' >beside/main.in
(cd beside/run && "$TSIM" -in ../main.in -log none) >out 2>&1
[ "$(grep -c '^mine' out)" = 3 ] && grep -q '^end' out
report 'include after shell cd' $? out
printf '%s\n' 'variable k equal 1' 'shell cd deep' 'include part.in' >beside/main.in
(cd beside && "$TSIM" -in main.in -log none) >out 2>&1
grep -q '^mine' out
report 'include after shell cd, of a script in the working folder' $? out
finish
