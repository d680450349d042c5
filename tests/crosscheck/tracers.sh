#!/bin/bash
# Marked particles against LIGGGHTS 3.8: tables and dumps, word by word.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs liggghts
two_materials | sed 's/^boundary.*/boundary p f f/' >in.head
cat >>in.head <<'END'
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-3
region mark block -0.6 -0.2 INF INF INF INF units box
region count block 0.2 0.65 INF INF INF INF units box
END
cat >in.drift <<'END'
include in.head
create_atoms 1 single -0.95 0.1 0.1 units box
create_atoms 1 single -0.74 0.3 0.1 units box
create_atoms 1 single -0.53 0.5 0.1 units box
create_atoms 2 single -0.32 0.1 0.3 units box
create_atoms 2 single 0.11 0.1 0.5 units box
create_atoms 1 single 0.53 0.1 0.7 units box
set type 1 diameter 0.05 density 2385
set type 2 diameter 0.07 density 1385
group two type 2
velocity all set 6.385 0 0
fix nv all nve/sphere
fix tr ${group} property/atom/tracer region_mark mark mark_step ${mark}
fix time two property/atom/regiontracer/time add_region mark add_region count check_region_every 5
fix stay all property/atom/regiontracer/time check_region_every 5
compute n ${group} nparticles/tracer/region region_count count tracer tr ${count}
thermo ${every}
thermo_style custom step f_tr c_n[1] c_n[2] c_n[3] c_n[4] f_time[1] f_time[2] f_time[3] f_stay[1]
thermo_modify format float %.10g lost ignore
dump d all custom 50 out.dump id x f_tr f_time[1] f_time[2] f_time[3] f_stay
dump_modify d sort id
run 600
END
cat >in.stream <<'END'
include in.head
fix face all mesh/surface/planar file ../plate.stl type 2 scale 0.4
fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.02
fix grains all particledistribution/discrete 32452843 1 grain 1.0
fix pour all insert/stream seed 86028121 distributiontemplate grains nparticles 60 vel constant 0 0 -1 &
	${start} particlerate 200 overlapcheck yes insertion_face face extrude_length 0.1
fix tr all property/atom/tracer/stream mark_step ${mark} insert_stream pour n_tracer ${number} every ${again}
fix nv all nve/sphere
region all block INF INF INF INF INF INF units box
compute n all nparticles/tracer/region region_count all tracer tr reset_marker no
thermo 10
thermo_style custom step f_tr c_n[1] c_n[2] c_n[3] c_n[4]
thermo_modify format float %.10g lost ignore
dump d all custom 10 out.dump id x y z f_tr
dump_modify d sort id first no
run 700
END
plate 2 0 >plate.stl

# agrees SCRIPT NAME VALUE...: both programs give the same table and dump; but LIGGGHTS writes dumps before the
# row of the table takes marks away
agrees() {
	local script=$1 what="$*"
	shift
	for side in theirs ours; do
		rm -rf $side && mkdir $side && cp in.* $side
	done
	(cd theirs && liggghts -in "$script" "$@" -log log >out 2>&1)
	report "$what: LIGGGHTS" $? theirs/out
	(cd ours && "$TSIM" -legacy -in "$script" "$@" -log log -screen none 2>out)
	report "$what: tsim" $? ours/out
	for side in theirs ours; do
		rows $side/log >$side/table
	done
	case $what in *'reset_marker yes'*) rm theirs/out.dump ours/out.dump ;; esac
	for file in table out.dump; do
		[ -e ours/$file ] || continue
		/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" theirs/$file ours/$file 1e-9 >deviation 2>&1
		report "$what: $file" $? deviation
	done
}
drift() { # GROUP EVERY MARK COUNT
	agrees in.drift -var group "$1" -var every "$2" -var mark "$3" -var count "$4"
}
drift all 10 '20' 'reset_marker no'
drift all 5 '33 marker_style heaviside' 'reset_marker yes'
drift two 10 '15 marker_style heaviside check_mark_every 7' 'periodic x 1 reset_marker yes'
stream() { # START MARK NUMBER AGAIN
	agrees in.stream -var start "$1" -var mark "$2" -var number "$3" -var again "$4"
}
stream 'maxattempt 50' 0 22 once
stream 'maxattempt 50' 60 15 130
stream 'maxattempt 50' 0 4 5
stream 'start 400' 10 2 70
finish
