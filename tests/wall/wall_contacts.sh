#!/bin/bash
# compute wall/gran/local: what it says of contacts with meshes, planes and cylinders, against what the particles
# feel; and after a restart.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

printf '%s\n' 'solid p' 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0.02' 'vertex 0.2 0 0.02' 'vertex 0.2 0.1 0.02' \
	endloop endfacet 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0.02' 'vertex 0.2 0.1 0.02' 'vertex 0 0.1 0.02' \
	endloop endfacet 'endsolid p' >plate.stl
cat >in.begin <<'END'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region b block 0 0.2 0 0.1 0 0.1 units box
if "${from} == none" then "create_box 2 b" "create_atoms 1 single 0.0501 0.011 0.0225" &
	"create_atoms 1 single 0.1 0.05 0.0221" "create_atoms 2 single 0.15 0.0025 0.08" &
	"set atom 1 diameter 0.006 density 2500" "set atom 2 diameter 0.005 density 2300" &
	"set atom 3 diameter 0.0056 density 2500" "set atom 1 vx 0.5 vy 0.1 omegaz 1" "set atom 2 vx -0.3 vz 0.2" &
else "read_restart ${from}"
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6 2.385e7
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.4 0.4 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-6
group one id 1
fix i all nve/sphere
fix cad all mesh/surface file plate.stl type 1
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
fix y all wall/gran model hertz tangential history primitive type 1 yplane 0
compute c all wall/gran/local id force torque delta primitives yes
compute only one wall/gran/local pos id force_normal force_tangential
compute n all reduce sum c_c[4] c_c[5] c_c[6] c_c[8]
compute ids all reduce max c_c[1] c_c[2] c_c[3]
compute lowest all reduce min c_c[1]
compute meshes all wall/gran/local id
compute first all reduce min c_meshes[1]
compute tq all property/atom tqy
compute turning all reduce sum c_tq
compute two all reduce max c_only[3] c_only[5] c_only[12]
END
cat >in.mesh <<'END'
variable from index none
include in.begin
run 10
thermo_style custom step c_n[1] c_n[2] c_n[3] c_n[4] c_ids[1] c_ids[2] c_ids[3] c_lowest c_first c_two[1] c_two[2] c_two[3]
run 0
print "is first $(c_first) 0"
print "is fx $(c_n[1]) $(fx[1]+fx[2]+fx[3])"
print "is fy $(c_n[2]) $(fy[1]+fy[2]+fy[3])"
print "is fz $(c_n[3]) $(fz[1]+fz[2]+fz[3])"
print "is torque $(c_n[4]) $(c_turning)"
print "is mesh $(c_ids[1]) 0"
print "is triangle $(c_ids[2]) 1"
print "is particle $(c_ids[3]) 3"
print "is primitive $(c_lowest) -1"
print "is point $(c_two[1]) 0.02"
print "is normal $(c_two[3]) $(fz[1])"
END
agree 'contacts with walls' "$(cat in.mesh)"

# a mesh may be called as a keyword is: n_meshes says how many names there are
sed 's/^fix cad all/fix mesh all/; s/meshes cad/meshes mesh/' in.begin >in.named
prints 'variable from index none
include in.named
run 1
print "force $(f_w[3]<0)"' 'force 1'

cat >in.cut <<'END'
variable from index none
include in.begin
dump d all local 7 ${out} c_c[1] c_c[2] c_c[3] c_c[4] c_c[5] c_c[6] c_c[7] c_c[10]
dump_modify d format float %.17g
run ${to} upto
write_restart ${out}.restart
END
"$TSIM" -in in.cut -log none -screen none -var out whole -var to 30 2>err
report 'whole' $? err
"$TSIM" -in in.cut -log none -screen none -var out one -var to 14 2>err
report 'first part' $? err
"$TSIM" -in in.cut -log none -screen none -var out two -var to 30 -var from one.restart 2>err
report 'second part' $? err
cat one two >both
same 'reports go on after a restart' whole both
same 'the state at the end' whole.restart two.restart

rejects 'variable from index none
include in.begin
compute bad all wall/gran/local pos ids' "unknown quantity 'ids'"
rejects "variable from index none
$(sed '/^fix cad/,$d; s/tangential history/&/' in.begin)
compute bad all wall/gran/local" 'needs a fix wall/gran before it, with a mesh'
rejects "variable from index none
$(sed '/^fix cad/,$d' in.begin)
compute bad all wall/gran/local primitives yes" 'before it, and there is none'
finish
