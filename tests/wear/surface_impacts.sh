#!/bin/bash
# fix surface/impacts: the columns of the fixes wear/LAW, without volumes.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

printf '%s\n' '-0.5 -0.5 0 0.5 -0.5 0 0.5 0.5 0' '-0.5 -0.5 0 0.5 0.5 0 -0.5 0.5 0' | solid >flat.stl
# A frictionless sphere of mass m hits at (1.5, 0, -2) a spring of 1e6: angle atan(4/3), force sqrt(1e6 m) 2.
springs >in.springs
cat >in.head <<'END'
units si
boundary p p f
region b block -1 1 -1 1 -1 1 units box
create_box 2 b
neighbor 0.02 bin
include in.springs
pair_style gran model hooke/stiffness
pair_coeff * *
fix integrate all nve/sphere
create_atoms 1 single 0.3 -0.1 0.0501 units box
create_atoms 1 single -0.3 0.1 0.0501 units box
create_atoms 1 single 0.3 0.2 0.3 units box
set group all diameter 0.1 density 2385
group one id 1
velocity all set 1.5 0 -2 units box
variable m equal 2385*PI*0.1^3/6
timestep 1e-6
END
surface_of() {
	case $1 in
	plane) echo 'fix cad all wall/gran model hooke/stiffness primitive type 2 zplane 0' ;;
	field) printf '%s\n' 'fix cad all surface/voxel constant 0 type 2 cells 2 2' \
		'fix w all wall/gran model hooke/stiffness voxels cad' ;;
	exact) echo 'fix cad all wall/gran model hooke/stiffness primitive type 2 zplane 0 impact exact' ;;
	*) printf '%s\n' "fix cad all mesh/surface file $1.stl type 2" \
		'fix w all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad' ;;
	esac
}
names='hits speed angle energy work impulse force'
for sort in plane flat field exact; do
	cat in.head >in.$sort
	{
		surface_of $sort
		echo 'fix hits all surface/impacts surface cad
fix one one surface/impacts surface cad
fix worn all wear/finnie surface cad flow_stress 1e9
compute all all reduce sum f_hits[1] f_hits[4] f_hits[6]
compute most all reduce max f_hits[2] f_hits[3] f_hits[7]'
		for k in 1 2 3 4 5 6 7; do
			echo "compute d$k all reduce sum f_hits[$k]
compute w$k all reduce sum f_worn[$k]"
		done
		echo 'compute dx all reduce sum f_hits[8] f_hits[9] f_hits[10]
compute wx all reduce sum f_worn[10] f_worn[11] f_worn[12]
run 4500
print "off hits $(f_hits-2) $(c_all[1]-2) $(f_one-1) $(f_hits[1]-2) $(f_one[1]-1)"
print "off mass $(f_hits[2]/(2*v_m)-1)"
print "off energy $(f_hits[3]/(6.25*v_m)-1) $(c_all[2]/(6.25*v_m)-1)"
print "off work $(f_hits[4])"
print "off speed $(c_most[1]/2.5-1)"
print "off angle $(c_most[2]/(180/PI*atan(4/3))-1)"
print "rough impulse $(c_all[3]/(8*v_m)-1)"
print "rough force $(c_most[3]/(2*sqrt(1e6*v_m))-1)"
print "off mine $(c_d1-c_w1) $(c_d2-c_w2) $(c_d3-c_w3) $(c_d4-c_w4) $(c_d5-c_w5) $(c_d6-c_w6) $(c_d7-c_w7)"
print "off centres $(c_dx[1]-c_wx[1]) $(c_dx[2]-c_wx[2]) $(c_dx[3]-c_wx[3])"'
	} >>in.$sort
	"$TSIM" -in in.$sort -log none >out 2>&1
	report "$sort: runs" $? out
	awk '$1 == "off" || $1 == "rough" {
		n++
		for (k = 3; k <= NF; k++) if (!($k ^ 2 < ($1 == "off" ? 1e-24 : 1e-6))) { print "wrong: " $0; bad = 1 }
	} END { exit bad || n != 10 }' out >>out
	report "$sort: $names, those of a fix wear/finnie" $? out
done

rejects "$(cat in.head)
$(surface_of plane)
fix hits all surface/impacts surface cad
compute all all reduce sum f_hits[11]
run 0
print \$(c_all)" 'fix hits (surface/impacts) has no [11], the last is [10]'
rejects "$(cat in.head)
$(surface_of plane)
fix hits all surface/impacts surface cad density 3" "unknown keyword 'density'"
rejects "$(cat in.head)
fix hits all surface/impacts surface cad" "no surface 'cad'"
"$TSIM" -help fix surface/impacts >help 2>&1
! grep -qi 'volume removed\|depth' help && grep -q 'surface/voxel' help
report 'the manual has no volumes' $? help
for law in archard bitter finnie formula neilson/gilchrist oka zhao/chang zhao/chang/contact; do
	"$TSIM" -help fix wear/$law | grep -q 'surface.*fix surface/voxel'
	report "wear/$law: the help of surface names fix surface/voxel" $?
done
# The slip velocity has the lever arm of the contact law: a sphere that rolls without sliding wears nothing, at any overlap, and an
# impact without other losses loses what friction takes.
ball() { # Y RESTITUTION Z VX VZ OMEGA
	echo "units si
atom_style granular
atom_modify map array
newton off
boundary f f f
region box block -0.1 0.5 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
fix m1 all property/global youngsModulus peratomtype $1
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 $2
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix w all wall/gran model hertz tangential history primitive type 1 zplane 0
create_atoms 1 single 0.001 0.001 $3 units box
set atom 1 diameter 0.01 density 2500 vx $4 vz $5 omegay $6
fix i all nve/sphere
fix a all wear/archard surface w k 1 hardness 1e9
fix b all surface/impacts surface w"
}
agree 'rolling' "$(ball 5e6 0.1 0.0049 1 0 200)
fix g all gravity 200 vector 0 0 -1
timestep 2e-6
run 20000
unfix a
fix a all wear/archard surface w k 1 hardness 1e9
variable from equal \$(x[1])
run 20000
print 'is overlap \$(z[1]<0.00492) 1'
print 'is worn \$(f_a/((x[1]-v_from)*mass(all)*200/1e9)) 0 1e8'"
agree 'the work of friction' "$(ball 1e8 1 0.00501 1 -3 0)
timestep 1e-7
compute r all erotate/sphere
run 6000
print 'is work \$(f_b[4]/(5*mass(all)-ke-c_r)) 1 1e11'"
# The area of a cylinder is that within the box, here of length 0.2 along x, y and z: whole; arcs at the four corners; half of it.
# cylinder AXIS R CENTRES X Y Z: wear by a grain of diameter 0.01 at this place that the wall slides past
cylinder() {
	echo "units si
atom_style granular
newton off
boundary f f f
communicate single vel yes
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix w all wall/gran model hertz tangential history primitive type 1 $1cylinder $2 $3 $4 shear $1 1
create_atoms 1 single $5 $6 $7 units box
set atom 1 diameter 0.01 density 2500
fix h all setforce 0 0 0
fix i all nve
fix a all wear/archard surface w k 1e-4 hardness 1e8
timestep 1e-5
run 20
variable depth vector f_a[9]
print 'is area \$(f_a/sum(v_depth)/(0.2*$2)) \$($8)'"
}
agree 'a cylinder in the box' "$(cylinder y 0.08 0.01 -0.015 -0.015 0 0.08501 '2*PI')"
agree 'arcs at the corners' "$(cylinder x 0.12 0 0 0 '$(0.11501/sqrt(2))' '$(-0.11501/sqrt(2))' '2*PI-8*acos(0.1/0.12)')"
agree 'half of a cylinder' "$(cylinder z 0.06 0.1 0.02 0.04499 0.02 0 PI)"
finish
