#!/bin/bash
# Counting what passes a mesh: known numbers, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl
cuboid 0.2 0.15 0.1 >cube.stl
start='units si
atom_style granular
boundary p p f
region box block -0.5 0.5 -0.5 0.5 -0.5 0.5 units box
create_box 2 box
fix cad all mesh/surface file plate.stl type 2
fix cube all mesh/surface file cube.stl type 2
timestep 1e-3
'
rain='lattice sc 0.1
region above block -0.5 0.49 -0.5 0.49 0.05 0.35 units box
create_atoms 1 region above
set type 1 diameter 0.0385 density 2385
velocity all set 0 0 -1 units box
fix move all nve/sphere
thermo_modify lost ignore
'

# three layers of 100 particles fall through one after the other; at 0.1, 0.2 and 0.3 s
agree 'rain' "$start $rain
fix flow all massflow/mesh mesh cad vec_side 0 0.1 -1 count once
variable m equal mass(all)
variable one equal mass(all)/300
run 50
print 'is none \$(f_flow[2]) 0'
run 100
print 'is first \$(f_flow[2]) 100'
run 100
print 'is mass \$(f_flow[1]) \$(200*v_one)'
print 'is rate \$(f_flow[3]) \$(100*v_one/0.1)'
run 100
print 'is all \$(f_flow[2]) 300'
print 'is rate \$(f_flow[4]) \$(100/0.1)'
print 'is deleted \$(f_flow[5]) 0'"

# who reads the rates does not change them, nor does a restart in between; intervals of their own
rates() { # EXTRA LINES: what the table says
	printf '%s\n' "$start $rain
fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once
thermo 25
thermo_style custom step f_flow[2] f_flow[3] f_flow[4]
thermo_modify lost ignore
$1" >in.script
	"$TSIM" -in in.script -log rates.log -screen none >out 2>&1 </dev/null || cat out
	rows rates.log
}
rates 'run 350' >alone
rates 'fix p all print 7 "$(f_flow[3]) $(f_flow[4])" screen no
fix a all ave/time 1 3 3 f_flow[3]
variable r equal f_flow[4]
run 60
print "$(v_r)"
run 13
print "$(v_r)"
run 277' | awk '$1 % 25 == 0' >read
awk '$1 % 25 == 0' alone >alone.asked
same 'reading changes no rate' read alone.asked
awk '{ if (NR > 1 && ($2 - n) / (($1 - s) * 1e-3) != $4) bad = 1; n = $2; s = $1 } END { exit bad || n != 300 }' alone
report 'rates are those since the row before' $? alone
agree 'intervals' "$start $rain
fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once interval 80
run 80
variable first equal \$(f_flow[2])
run 80
print 'is rate \$(f_flow[4]*0.08) \$(f_flow[2]-v_first)'
print 'is some \$(f_flow[2]-v_first) 100'
run 1
print 'is new \$(f_flow[4]) 0'"

# deleted ones leave; none is forgotten
agree 'deleted' "$start $rain
variable m equal \$(mass(all))
fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once delete_atoms yes
run 420
print 'is deleted \$(f_flow[6]) 300'
print 'is mass \$(f_flow[5]/v_m) 1'
print 'is left \$(atoms) 0'"

prints "$start
create_atoms 1 single 0.1 0.1 0.0505 units box
set type 1 diameter 0.1 density 2385
velocity all set 0 0 -1 units box
fix move all nve/sphere
fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once screen yes writeTime
compute mark all reduce sum f_massflow_flow
run 20
print 'mark \$(c_mark)'
run 60
print 'mark \$(c_mark)'" 'mark 0' 'mark 2' '* 1  0.051   0.1  0.1  0.1 -0.0005'

# the lines in a file, and as a table with all digits
for f in passed.txt passed.csv; do
	printf '%s\n' "$start" 'create_atoms 1 single 0.1 0.1 0.0505 units box' 'set type 1 diameter 0.1 density 2385' \
		'velocity all set 0 0 -1 units box' 'fix move all nve/sphere' \
		"fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once writeTime file $f" 'run 80' >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "a line in $f" $? out
done
awk -F, 'NR == 1 && $0 != "id,time,diameter,x,y,z,vx,vy,vz" { exit 1 }
	NR > 1 { print $1 + 0, $2 + 0, $3 + 0, $4 + 0, $5 + 0, sprintf("%.4g", $6), $7 + 0, $8 + 0, $9 + 0 }' passed.csv >rows
awk '!/^#/ { print $1 + 0, $2 + 0, $3 + 0, $4 + 0, $5 + 0, $6, $7 + 0, $8 + 0, $9 + 0 }' passed.txt >want
same 'the line as a table' want rows

# a clump counts sphere by sphere, and is deleted when all of it has passed; ages are 2 and 3
agree 'clumps' "$start
fix clump all particletemplate/multisphere 15485863 atom_type 1 density constant 2385 nspheres 2 ntry 20000 &
	spheres 0 0 0 0.02  0 0 0.05 0.02 type 1
fix clumps all particledistribution/discrete 15485867 1 clump 1.0
region spot block -0.1 0.1 -0.1 0.1 0.1 0.2 units box
fix fill all insert/pack seed 32452843 distributiontemplate clumps vel constant 0 0 -1 &
	insert_every once overlapcheck yes all_in yes region spot particles_in_region 1
fix move all multisphere
fix age all property/atom age scalar yes no no 2
fix flow all massflow/mesh mesh cad vec_side 0 0 -1 count once sum_property age delete_atoms yes
run 1
variable m equal \$(mass(all))
set atom 2 property/atom age 3
variable lower equal z[1]
variable upper equal z[2]
variable half equal \$(v_lower+0.001*ceil(1000*(v_upper-v_lower)/2))
run \$(ceil(1000*v_half)) upto
print 'is half \$(f_flow[2]) 0.5'
print 'is half \$(f_flow[1]/v_m) 0.5'
print 'is first \$(f_flow[7]) 1'
print 'is there \$(f_flow[6]+atoms) 2'
run 100
print 'is all \$(f_flow[2]) 1'
print 'is sum \$(f_flow[7]) 2.5'
print 'is deleted \$(f_flow[6]) 1'
print 'is deleted \$(f_flow[5]/v_m) 1'
print 'is left \$(atoms) 0'"

for words in \
	"count once|expected one of vec_side, point_at_outlet" \
	"vec_side 0 0 1 point_at_outlet 0 0 1 count once|found both" \
	"point_at_outlet 0 0 1|requires \`count once\`" \
	"vec_side 0 0 1 inside_out|with point_at_outlet only" \
	"vec_side 0 0 1 delete_atoms yes|requires \`count once\`" \
	"vec_side 0 0 0|has no length" \
	"vec_side 1 1 0|does not say which" \
	"vec_side 0 0 1 count twice|expected one of once, multiple" \
	"vec_side 0 0 1 sum_property age|no fix property/atom keeps a number 'age'" \
	"vec_side 0 0 1 file a append b|found both"; do
	rejects "$start fix flow all massflow/mesh mesh cad ${words%|*}" "${words#*|}"
done
rejects "$start fix flow all massflow/mesh mesh cude vec_side 0 0 1" "did you mean 'cube'"
rejects "$start fix two all property/atom two vector yes no no 1 2
fix flow all massflow/mesh mesh cad vec_side 0 0 1 sum_property two" "keeps a number 'two'"
rejects "$start fix flow all massflow/mesh mesh cube vec_side 0 0 1" 'mesh cube is not planar'
finish
