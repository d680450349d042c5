#!/bin/bash
# Marked particles: known numbers, runs cut by restart files, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 2 0 >plate.stl

# a row of grains, one in each 0.1, that moves by 0.002385 in a step; marked in 0.2 .. 0.4, counted in 0.6 .. 0.8
start='units si
atom_style granular
boundary p f f
region box block 0 1 -1 1 -1 1 units box
region mark block 0.2 0.4 INF INF INF INF units box
region count block 0.6 0.8 INF INF INF INF units box
if "${from} == none" then "create_box 2 box" "lattice sc 0.1" "region row block 0 0.99 0 0 0 0 units box" &
	"create_atoms 1 region row" "displace_atoms all move 0.05 0 0 units box" &
	"set type 1 diameter 0.0385 density 2385" "velocity all set 2.385 0 0 units box" &
	"set atom 1*5 density 1385" else "read_restart ${from}"
fix nv all nve
timestep 1e-3
variable light equal 1385*PI/6*0.0385^3
variable heavy equal 2385*PI/6*0.0385^3
'
start="variable from index none
$start"
# at step 20 grains 2 and 3 (0.1977 no, 0.2977, 0.3977) have come to 0.2 .. 0.4: 3 and 4; they are in 0.6 .. 0.8 by
# step 170 (0.65545, 0.75545), together with no other
agree 'pulse' "$start
fix tr all property/atom/tracer region_mark mark mark_step 20
fix later all property/atom/tracer region_mark mark mark_step 21 check_mark_every 1
compute n all nparticles/tracer/region region_count count tracer tr
compute same all nparticles/tracer/region region_count count tracer later reset_marker no
compute kept all reduce sum f_later
compute lost all reduce sum f_tr
run 20
print 'is marked \$(f_tr) 2'
print 'is asked \$(f_tr) 0'
print 'is later \$(f_later) 0'
run 150
print 'is later \$(f_later) 2'
variable n equal c_n[1]
variable m equal c_n[3]
print 'is number \${n} 2'
print 'is mass \${m} \$(2*v_light)'
print 'is counted \$(c_n[2]) 0'
print 'is same \$(c_same[2]) 1'
print 'is again \$(c_same[4]) \$(v_light)'
print 'is kept \$(c_kept) 2'
print 'is lost \$(c_lost) 0'"
agree 'in a run all who ask hear the same' "$start
fix tr all property/atom/tracer region_mark mark mark_step 20
compute n all nparticles/tracer/region region_count count tracer tr
variable counted equal c_n[2]+c_n[2]
fix seen all ave/time 10 1 10 v_counted c_n[2] ave running
variable sum equal f_seen[2]*21
fix once all print 10 '\$(f_tr) \$(f_tr)' screen no file marked
thermo 10
thermo_style custom step c_n[2] f_tr
run 200
print 'is counted \${sum} 2'
print 'is twice \$(f_seen[1]*21) 4'"
grep -q '^2 2$' marked
report 'both hear of two' $? marked
# who comes by is marked: all ten in the end; through the periodic face, only in the box after it
agree 'flow' "$start
fix tr all property/atom/tracer region_mark mark mark_step 0 marker_style heaviside
compute n all nparticles/tracer/region region_count count tracer tr periodic x 1 reset_marker no
compute all all nparticles/tracer/region region_count count tracer tr periodic x all reset_marker no
run 300
print 'is all \$(f_tr) 9'
print 'is image \$(c_n[1]+c_all[1]) 3'
run 200
print 'is rest \$(f_tr) 1'"
# 0.2 long at 2.385 m/s: 84 steps, seen every 7
agree 'times' "$start
fix stay all property/atom/regiontracer/time add_region mark add_region count check_region_every 7
fix box all property/atom/regiontracer/time
run 400
print 'is box \$(f_stay[1]) 0.4'
print 'is alone \$(f_box[1]) 0.4'
print 'is mark \$(f_stay[1][2]) 0.084'
print 'is count \$(f_stay[4][3]) 0.084'"

stream="$start
fix face all mesh/surface file plate.stl type 2 scale 0.4 rotate axis 0 1 0 angle 90 move 0.5 0 0.5
fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.02
fix grains all particledistribution/discrete 32452843 1 grain 1.0
fix pour all insert/stream seed 86028121 distributiontemplate grains nparticles 60 vel constant 1 0 0 &
	particlerate 200 overlapcheck yes insertion_face face extrude_length 0.1"
agree 'stream' "$stream
fix tr all property/atom/tracer/stream mark_step 60 insert_stream pour n_tracer 7 every 130
fix one all property/atom/tracer/stream mark_step 0 insert_stream pour n_tracer 25 every once
run 1
print 'is first \$(f_tr) 7'
print 'is once \$(f_one) 20'
run 200
print 'is second \$(f_tr) 7'
print 'is rest \$(f_one) 5'"

# cut by restart files at odd steps, also where requests of a stream are open
cat >in.cut <<END
$stream
fix tr all property/atom/tracer region_mark mark mark_step 33 marker_style heaviside
fix few all property/atom/tracer/stream mark_step 60 insert_stream pour n_tracer 18 every 50
fix stay all property/atom/regiontracer/time add_region mark add_region count
compute n all nparticles/tracer/region region_count count tracer tr
thermo_style custom step f_tr f_few c_n[1] c_n[2] c_n[4] f_stay[1] f_stay[2]
thermo 10
run \${to} upto
write_restart \${name}.restart
END
cut() { # NAME FROM TO
	"$TSIM" -in in.cut -log "$1.log" -screen none -var name "$1" -var from "$2" -var to "$3" 2>err
	report "$1" $? err
}
cut whole none 300
cut a none 93
cut b a.restart 157
cut c b.restart 300
rows whole.log >whole
rows a.log b.log c.log | grep -vE '^ +(93|157) ' >parts
same 'tables of parts' whole parts
same 'states' whole.restart c.restart

for words in \
	"fix t all property/atom/tracer mark_step 3|'region_mark'" \
	"fix t all property/atom/tracer region_mark mark mark_step -1|mark_step" \
	"fix t all property/atom/tracer region_mark mark mark_step 1 marker_style step|expected one of dirac, heaviside" \
	"fix t all property/atom/timetracer|property/atom/regiontracer/time" \
	"fix t all property/atom/regiontracer/time add_region marc|did you mean 'mark'" \
	"compute c all nparticles/tracer/region region_count count tracer nv|is of style nve" \
	"compute c all nparticles/tracer/region region_count count tracer move|'move'"; do
	rejects "$start ${words%|*}" "${words#*|}"
done
fixed="$start
fix tr all property/atom/tracer region_mark mark mark_step 1
compute c all nparticles/tracer/region region_count count tracer tr"
rejects "$fixed periodic w 1" 'expected periodic x|y|z IMAGE'
rejects "$fixed periodic y 1" 'the box is not periodic in y'
rejects "$fixed periodic x 1.5" 'expected a whole number or all'
rejects "$stream
fix s all property/atom/tracer/stream mark_step 3 insert_stream grain n_tracer 3 every once" 'expected a fix insert/stream'
rejects "$stream
fix s all property/atom/tracer/stream mark_step 3 insert_stream pour n_tracer 3 every now" 'expected once or a number'
rejects "$stream
fix s all property/atom/tracer/stream mark_step 3 insert_stream pour n_tracer 0 every 3" 'n_tracer'
finish
