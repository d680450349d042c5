#!/bin/bash
# Counting what passes a mesh, against LIGGGHTS 3.8: tables and files, byte for byte.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
plate 3 0 >plate.stl
two_materials >in.both
cat >>in.both <<'END2'
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-3
fix a all mesh/surface file plate.stl type 2
create_atoms 1 single 0.1 0.1 0.055 units box
create_atoms 1 single 0.2 0.1 0.065 units box
create_atoms 1 single -0.3 0.1 0.035 units box
create_atoms 1 single 0.53 0.1 0.065 units box
create_atoms 2 single 0.1 0.2 -0.05 units box
create_atoms 2 single 0.7 0.2 0.05 units box
set type 1 diameter 0.1 density 2385
set type 2 diameter 0.12 density 1385
velocity all set 0 0 -1.3
region low block -1 1 -1 1 -1 0 units box
group low region low
velocity low set 0.1 0 1.1
fix g all gravity 9.81 vector 0 0 -1
fix nv all nve/sphere
fix age all property/atom age scalar yes no no 2.385
fix mf all massflow/mesh mesh a ${words}
thermo 10
thermo_style custom step f_mf[1] f_mf[2] f_mf[3] f_mf[4] f_mf[5] f_mf[6] f_mf[${last}]
thermo_modify format float %.10g lost ignore
run 300
END2

agree() {
	for side in theirs ours; do
		rm -rf $side && mkdir $side && cp plate.stl in.both $side
	done
	(cd theirs && liggghts -in in.both -var words "$1" -var last "${2-6}" -log log >out 2>&1)
	report "$1: LIGGGHTS" $? theirs/out
	(cd ours && "$TSIM" -in in.both -var words "$1" -var last "${2-6}" -log log -screen none 2>out)
	report "$1: tsim" $? ours/out
	for side in theirs ours; do
		rows $side/log >$side/table
	done
	same "$1: table" theirs/table ours/table
	same "$1: file" theirs/out.txt ours/out.txt
}
agree 'vec_side 0 0 -1 count once file out.txt'
agree 'vec_side 0.1 0.2 -0.3 count multiple file out.txt writeTime'
agree 'vec_side 0 0 1 append out.txt'
agree 'vec_side 0 0 -1 count once file out.txt delete_atoms yes'
agree 'count once point_at_outlet 0 0 -5 file out.txt'
agree 'count once point_at_outlet 0 0 -5 inside_out file out.txt'
agree 'count once point_at_outlet 0 0 0.03 file out.txt'
agree 'vec_side 0 0 -1 sum_property age file out.txt' 7
finish
