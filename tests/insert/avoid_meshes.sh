#!/bin/bash
# avoid_meshes: inserted particles keep clear of meshes and of their periodic images; the others are where they would be
# without it; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
head='units si
atom_style granular
boundary p p p
neighbor 0.01 bin
region box block 0 1 0 1 0 1 units box
create_box 1 box
fix m1 all property/global youngsModulus peratomtype 5.31e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.03
fix pdd all particledistribution/discrete 15485867 1 pts 1
fix corner all mesh/surface primitive sphere radius 0.3 type 1
fix far all mesh/surface primitive plate length 0.01 width 0.01 base 0.5 0.5 0.5 type 1
fix n all nve/sphere
variable r atom sqrt((x-round(x))^2+(y-round(y))^2+(z-round(z))^2)
compute least all reduce min v_r'
fill='fix fill all insert/pack seed 32452843 distributiontemplate pdd insert_every once overlapcheck yes maxattempt 500 &
	check_dist_from_subdomain_border no region box particles_in_region 200'
# the corner of the box is the centre of a ball, of which the box has eight parts; its triangles are 3e-4 inside of it
prints "$head
$fill avoid_meshes corner
run 1
variable skin atom (v_r>0.2695)*(v_r<0.3295)
compute skin all reduce sum v_skin
run 0
print 'clear \$(c_skin) \$(count(all))'
" 'clear 0 200'
prints "$head
$fill
run 1
variable skin atom (v_r>0.2695)*(v_r<0.3295)
compute skin all reduce sum v_skin
run 0
print 'unclear \$(c_skin>5) \$(count(all))'" 'unclear 1 200'
# particles inside of the ball touch nothing
prints "$head
region out sphere 0 0 0 0.3 side out units box
$fill avoid_meshes corner
run 1
print 'inside \$(c_least<0.27)'" 'inside 1'

# a mesh where no particle comes changes nothing
for what in '' 'avoid_meshes far'; do
	prints "${head/base 0.5 0.5 0.5/scale 1e-3 move 0.4 0.4 0.4}
$fill $what
run 1
write_data places${what:+.far}.data" '*Step'
done
same 'the others' places.data places.far.data
prints "$head
fix rain all insert/rate/region seed 32452843 distributiontemplate pdd nparticles 40 particlerate 1e6 insert_every 2 &
	overlapcheck yes maxattempt 500 region box avoid_meshes corner far
run 9
variable skin atom (v_r>0.2695)*(v_r<0.3295)
compute skin all reduce sum v_skin
run 0
print 'rain \$(c_skin) \$(count(all))'" 'rain 0 40'

rejects "$head
$fill avoid_meshes cornr" "did you mean 'corner'"
rejects "$head
${fill/overlapcheck yes/overlapcheck no} avoid_meshes corner" 'needs overlapcheck yes'
rejects "$head
$fill avoid_meshes m1" 'fix m1 is no mesh'
rejects "$head
fix fill all insert/pack seed 32452843 distributiontemplate pdd insert_every 3 region box particles_in_region 20 avoid_meshes far
run 1
unfix far
run 5" "there is no mesh 'far'"
finish
