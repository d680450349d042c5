#!/bin/bash
# fix surface/heat: the heat that particles conduct into planes, meshes and height fields; closed forms, and the balance
# with the heat content of the particles.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs python3

# Spheres of radius 0.05 held 0.045 above z = 0: type 1 with k = 43, c = 0.49, the wall of type 2 with k = 17.
springs >in.springs
cat >in.head <<'END'
units si
boundary p p f
region b block -1 1 -1 1 -1 1 units box
create_box 2 b
neighbor 0.02 bin
fix k all property/global thermalConductivity peratomtype 43 17
fix c all property/global thermalCapacity peratomtype 0.49 0.8
include in.springs
pair_style gran model hooke/stiffness
pair_coeff * *
timestep 1e-3
variable kk equal 4*43*17/60
variable h equal v_kk*sqrt(PI*(0.05^2-0.045^2))
variable mc equal 2385*PI*0.1^3/6*0.49
END
# Two coplanar triangles that share the diagonal x = y; a groove whose bottom is the y axis, of slope 45 degrees.
printf '%s\n' '-0.5 -0.5 0 0.5 -0.5 0 0.5 0.5 0' '-0.5 -0.5 0 0.5 0.5 0 -0.5 0.5 0' | solid >flat.stl
printf '%s\n' '0 -0.5 0 0.5 -0.5 0.5 0 0.5 0' '0 -0.5 0 0 0.5 0 -0.5 0.5 0.5' | solid >groove.stl

# surface_of SORT WORDS: a surface `cad` of temperature 300 and its wall, with these words
surface_of() {
	case $1 in
	plane) echo "fix cad all wall/gran model hooke/stiffness primitive type 2 zplane 0 temperature 300 $2" ;;
	field) printf '%s\n' 'fix cad all surface/voxel constant 0 type 2 cells 7 9 temperature 300' \
		"fix w all wall/gran model hooke/stiffness voxels cad $2" ;;
	*) printf '%s\n' "fix cad all mesh/surface file $1.stl type 2 temperature 300" \
		"fix w all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad $2" ;;
	esac
}
# one SORT WORDS SCHEME: head, a sphere of 700, heat and the surface
one() {
	cat in.head
	printf '%s\n' 'create_atoms 1 single 0.1 0.1 0.045 units box' 'set group all diameter 0.1 density 2385' \
		"fix heat all heat/gran initial_temperature 700 scheme $3"
	surface_of "$1" "$2"
	echo 'fix warmed all surface/heat surface cad'
}

# Cooling of one sphere: (1 - h dt/(m c))^n with euler, exp(-n h dt/(m c)) with exact, where the power is the mean one.
# shellcheck disable=SC2016
sums='compute all all reduce sum f_warmed[1] f_warmed[2] f_warmed[3]
compute power all reduce max f_warmed[1]
run 20
print "is energy $(f_warmed:%.17g) $(v_mc*400*(1-v_q^20):%.17g) $(v_mc*700)"
print "is sum $(c_all[2]:%.17g) $(f_warmed:%.17g)"
print "is total $(f_warmed[2]:%.17g) $(f_warmed:%.17g)"
print "is power $(f_warmed[1]:%.17g) $(v_mc*400*v_q^19*(1-v_q)/1e-3:%.17g) $(v_mc*400)"
print "is one $(c_power:%.17g) $(f_warmed[1]:%.17g)"
print "is lost $(f_warmed:%.17g) $(v_mc*700-f_heat:%.17g) $(v_mc*700)"'
for sort in plane flat field; do
	agree "$sort: euler" "$(one $sort '' euler)
variable q equal 1-v_h*1e-3/v_mc
$sums"
	agree "$sort: exact" "$(one $sort '' exact)
variable q equal exp(-v_h*1e-3/v_mc)
$sums"
	agree "$sort: an immobile particle" "$(one $sort '' euler)
fix held all freeze
variable q equal 1-v_h*1e-3/v_mc
$sums"
done
agree 'steps of several time constants' "$(one plane '' exact)
timestep 2
run 9
print \"is energy \$(f_warmed:%.17g) \$(v_mc*400:%.17g)\""

# area WORDS FORMULA: power and flux; the area of the plane is 4
area() {
	agree "contact_area $1" "$(one plane "contact_area $1" euler)
compute flux all reduce sum f_warmed[3]
run 1
print \"is power \$(f_warmed[1]:%.17g) \$(v_kk*sqrt($2)*400:%.17g)\"
print \"is flux \$(c_flux:%.17g) \$(v_kk*sqrt($2)*100:%.17g)\""
}
area overlap 'PI*(0.05^2-0.045^2)'
area 'constant 0.02385' 0.02385
area projection 'PI*0.05^2'

# Of two triangles that are touched at once both conduct in a groove; on coplanar ones, one.
agree 'two triangles of a groove' "$(one groove '' euler)
set atom 1 x 0 z \$(0.045*sqrt(2):%.17g)
compute least all reduce min f_warmed[1]
compute most all reduce max f_warmed[1]
compute z all reduce sum f_warmed[6]
run 1
print \"is power \$(f_warmed[1]/(2*v_h*400):%.11f) 1\"
print \"is least \$(c_least/(v_h*400):%.11f) 1\"
print \"is most \$(c_most/(v_h*400):%.11f) 1\"
print \"is lost \$(f_warmed/(v_mc*700-f_heat):%.11f) 1\"
print \"is z \$(c_z:%.12f) \$(1/3:%.12f)\""
agree 'the common edge of coplanar triangles' "$(one flat '' euler)
compute least all reduce min f_warmed[1]
run 1
print \"is power \$(f_warmed[1]:%.17g) \$(v_h*400:%.17g)\"
print \"is least \$(c_least:%.17g) 0\""

# Particle 1 touches two walls of one mesh and a plane; 2 the same, but keeps its temperature; 3 the other plane.
agree 'two walls of a mesh, two planes, groups' "$(cat in.head)
create_atoms 1 single 0.3 0.1 0.045 units box
create_atoms 1 single -0.3 0.1 0.045 units box
create_atoms 1 single 0.7 0.1 -0.955 units box
set group all diameter 0.1 density 2385
group first id 1
group rest id 2 3
group none empty
fix heat first heat/gran initial_temperature 700
$(surface_of flat '')
fix again all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad
fix ends all wall/gran model hooke/stiffness primitive type 2 zplane -1 0 temperature 300
fix first first surface/heat surface cad
fix rest rest surface/heat surface cad
fix none none surface/heat surface cad
fix end all surface/heat surface ends
compute high all reduce max f_end[6]
compute low all reduce min f_end[6]
run 2
variable q equal 1-3*v_h*1e-3/v_mc
print \"is first \$(f_first:%.17g) \$(v_mc*400*(1-v_q^2)*2/3:%.17g) \$(v_mc*400)\"
print \"is rest \$(f_rest:%.17g) \$(4e-3*v_h*400:%.17g)\"
print \"is none \$(f_none) 0\"
print \"is ends \$(f_end:%.17g) \$(v_mc*400*(1-v_q^2)/3+4e-3*v_h*400:%.17g) \$(v_mc*400)\"
print \"is lost \$(v_mc*2100-f_heat:%.17g) \$(v_mc*400*(1-v_q^2):%.17g) \$(v_mc*2100)\"
print \"is high \$(c_high) 0\"
print \"is low \$(c_low) -1\""
agree 'no contact any more' "$(one plane '' euler)
run 3
set atom 1 z 0.3
run 3
print \"is power \$(f_warmed[1]) 0\"
print \"is energy \$(f_warmed:%.17g) \$(v_mc*400*(1-(1-v_h*1e-3/v_mc)^3):%.17g) \$(v_mc*400)\""
agree 'a surface that is touched exactly' "$(one plane '' euler)
set atom 1 z 0.05
run 3
print \"is energy \$(f_warmed) 0\""

# heatFlux of compute wall/gran/local is that into the particle, at its present temperature.
agree 'compute wall/gran/local' "$(one plane '' euler)
compute c all wall/gran/local heatFlux primitives yes
compute heat all reduce sum c_c[1]
run 4
print \"is heat \$(c_heat:%.17g) \$(-v_h*(f_heat/v_mc-300):%.17g)\""

rejects "$(cat in.head)
$(surface_of plane '')
compute c all wall/gran/local heatFlux primitives yes" 'no heat flows without a fix heat/gran'
rejects "$(cat in.head)
$(surface_of plane '')
fix warmed all surface/heat surface cad" 'needs a fix heat/gran before it, and there is none'
rejects "$(one plane '' euler)
unfix heat
fix heat all heat/gran initial_temperature 300
run 1" 'needs a fix heat/gran before it'
rejects "$(cat in.head)
fix heat all heat/gran initial_temperature 300
fix cad all wall/gran model hooke/stiffness primitive type 2 zplane 0
fix warmed all surface/heat surface cad" "surface 'cad' conducts no heat"
rejects "$(one flat '' euler)
fix other all surface/heat surface w" 'made of meshes; name one of them'
rejects "$(one plane '' euler)
fix other all surface/heat surface cat" "no surface 'cat'"
rejects "$(one flat 'impact exact' euler)
fix move all nve/sphere
run 1" 'heat is conducted in resolved contacts only'
{
	cat in.head
	echo 'fix heat all heat/gran initial_temperature 300
fix cad all mesh/surface file flat.stl type 2 temperature 300
fix warmed all surface/heat surface cad
run 0'
} >in.unused
"$TSIM" -in in.unused -log none >out 2>&1 && grep -q 'no fix wall/gran is made of the surface cad' out
report 'a surface that no wall is made of' $? out

# The deck: what the grains lose is what the surfaces get; threads and a cut give the same bytes.
deck=$top_srcdir/tests/decks/in.surface_heat
mkdir 1 2 3 first second
sed '/^thermo\t/i variable start equal $(f_heat:%.17g)' "$deck" >with_start
for threads in 1 2 3; do
	{
		printf 'package omp %s grain 1\n' $threads
		cat with_start
		# shellcheck disable=SC2016
		echo 'print "balance $(v_start-f_heat:%.17g) $(f_q1+f_q2+f_q3:%.17g) $(f_q1) $(f_q4) $(f_q2) $(f_q3)"'
		echo 'write_restart end.restart'
	} >$threads/in
	(cd $threads && "$TSIM" -in in -log none -var out out >../out.$threads 2>&1)
	report "$threads threads: runs" $? out.$threads
done
python3 "$top_srcdir/tests/split_deck.py" with_start 1 537 first/in second/in
for part in first second; do
	(cd $part && "$TSIM" -in in -log none -var out out >../out 2>&1)
	report "the deck in two parts: the $part" $? out
	[ $part = first ] && cp first/cut.restart second
done
for other in 2 3 second; do
	same "the same state: $other" 1/end.restart $other/end.restart
	same "the same heat of the mesh: $other" 1/out.1000.chute $other/out.1000.chute
	same "the same heat of the height field: $other" 1/out.1000.ground $other/out.1000.ground
done
awk '$1 == "balance" {
	seen = 1
	bad = !(($2 - $3) ^ 2 < (1e-12 * $3) ^ 2 && $4 > 1 && $5 > 0.1 && $6 > $5 && $7 < -0.01)
} END { exit bad || !seen }' out.1
report 'the heat content of the grains is what the surfaces get' $? out.1
finish
