#!/bin/bash
# Impacts on planes and meshes: each counted once, with the speed and the angle of entry; volumes by closed forms.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

# Two triangles that share the diagonal x = y (and the corner 0 0 with two more).
printf '%s\n' '-0.5 -0.5 0 0.5 -0.5 0 0.5 0.5 0' '-0.5 -0.5 0 0.5 0.5 0 -0.5 0.5 0' | solid >flat.stl
printf '%s\n' '0 0 0 0.5 -0.5 0 0.5 0.5 0' '0 0 0 0.5 0.5 0 -0.5 0.5 0' '0 0 0 -0.5 0.5 0 -0.5 -0.5 0' \
	'0 0 0 -0.5 -0.5 0 0.5 -0.5 0' | solid >star.stl
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
timestep 1e-6
END
surface_of() {
	case $1 in
	plane) echo 'fix cad all wall/gran model hooke/stiffness primitive type 2 zplane 0' ;;
	field) printf '%s\n' 'fix cad all surface/voxel constant 0 type 2 cells 40 40' \
		'fix w all wall/gran model hooke/stiffness voxels cad' ;;
	*) printf '%s\n' "fix cad all mesh/surface file $1.stl type 2" \
		'fix w all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad' ;;
	esac
}
grain='set group all diameter 0.1 density 2385'
# shellcheck disable=SC2016
totals='print "volume $(f_worn:%.15g) hits $(f_worn[3]) mass $(f_worn[4]:%.15g) energy $(f_worn[5]:%.15g) m $(mass(all):%.15g)"'

# script WHAT SURFACE FILE: head, surface and the lines of standard input; runs it, output in `out`
script() {
	{
		cat in.head
		surface_of "$2"
		cat
	} >in.one
	"$TSIM" -in in.one -log none >out 2>&1
	report "$1: runs" $? out
}

# finnie T U K: volume over mass for the speeds T along and U towards the surface, p = 1e9, psi = 2
finnie() {
	awk -v t="$1" -v u="$2" -v k="$3" 'BEGIN {
		printf "%.17g", (6 * u > k * t ? k * t * t / 6 : 2 * t * u - 6 / k * u * u) / (1e9 * 2 * k)
	}'
}

# hit WHAT SURFACE X Y U T K: one sphere, with the speeds T along x and U down, touches above X Y
hit() {
	local what=$1 x=$3 y=$4 u=$5 t=$6 k=$7
	{
		echo "fix worn all wear/finnie surface cad flow_stress 1e9 force_ratio $k"
		echo "create_atoms 1 single $(awk -v x="$x" -v t="$t" -v u="$u" 'BEGIN { printf "%.17g", x - t * 1e-4 / u }') $y 0.0501 units box"
		printf '%s\n' "$grain" "velocity all set $t 0 -$u units box" \
			"run $(awk -v u="$u" 'BEGIN { print int(2e-4 / u / 1e-6) + 3700 }')" "$totals"
		echo 'compute all all reduce sum f_worn[1] f_worn[8] f_worn[4]'
		# shellcheck disable=SC2016
		echo 'print "same $(f_worn-c_all[2]) $(f_worn[3]-c_all[1]) $(f_worn[5]-c_all[3])"'
	} | script "$what" "$2"
	awk -v wanted="$(finnie "$t" "$u" "$k")" -v t="$t" -v u="$u" '
		function off(a, b) { return (a - b) ^ 2 > (1e-12 * b) ^ 2 }
		$1 == "volume" {
			seen = 1
			bad = $4 != 1 || off($6, $10) || off($8, $10 * (t * t + u * u) / 2) ||
				($2 - wanted * $10) ^ 2 > (1e-12 * (wanted ? $2 : $8 / 1e9)) ^ 2
		}
		$1 == "same" { bad += $2 != 0 || $3 != 0 || $4 != 0; same = 1 }
		END { exit bad || !seen || !same }' out
	report "$what: one impact with the volume of the closed form, totals are sums" $? out
}
hit 'plane, steep' plane 0.1 0.2 0.8 0.6 2
hit 'plane, shallow' plane 0.1 0.2 0.1 0.7 2
hit 'plane, other K' plane 0.1 0.2 0.3 0.7 4
hit 'plane, normal' plane 0.1 0.2 0.5 0 2
hit 'plane, across the periodic face' plane 0.9995 0.2 0.5 0.6 2
hit 'mesh, a face' flat 0.3 0.1 0.5 0.4 2
hit 'mesh, the shared edge' flat 0.1 0.1 0.5 0.4 2
hit 'mesh, the shared edge, normal' flat 0.1 0.1 0.5 0 2
hit 'mesh, slides across the edge' flat 0.0993 0.1 0.5 0.4 2
hit 'mesh, the shared corner' star 0 0 0.5 0.4 2

script 'resting and grazing' plane <<'LINES'
fix worn all wear/finnie surface cad flow_stress 1e9
create_atoms 1 single 0 0 0.05 units box
create_atoms 1 single 0.3 0 0.0499 units box
create_atoms 1 single -0.3 0 0.05 units box
set group all diameter 0.1 density 2385
set atom 3 vx 0.7
run 4000
print "hits $(f_worn[3]) volume $(f_worn)"
set atom 2 vz -0.5
set atom 2 z 0.0501
run 4200
print "hits $(f_worn[3]) volume $(f_worn)"
LINES
printf 'hits 0 volume 0\nhits 1 volume 0\n' >wanted
grep '^hits' out >got
same 'what touches at the start makes no impact; grazing and a normal impact remove nothing' wanted got

script 'two at once' flat <<'LINES'
fix worn all wear/finnie surface cad flow_stress 1e9
create_atoms 1 single 0.3 -0.1 0.0501 units box
create_atoms 1 single -0.3 0.1 0.0501 units box
set group all diameter 0.1 density 2385
group one id 1
fix part one wear/finnie surface cad flow_stress 1e9
velocity all set 0.4 0 -0.5 units box
compute most all reduce max f_worn[1]
run 4200
print "hits $(f_worn[3]) $(c_most) $(f_part[3]) $((f_worn-2*f_part)/f_worn)"
LINES
grep -qx 'hits 2 1 1 0' out
report 'two at once: one impact each, one of them of the group' $? out

script 'two walls of the same mesh' flat <<'LINES'
fix again all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad
fix worn all wear/finnie surface cad flow_stress 1e9
create_atoms 1 single 0.3 -0.1 0.0501 units box
set group all diameter 0.1 density 2385
velocity all set 0.4 0 -0.5 units box
run 4200
print "hits $(f_worn[3])"
LINES
grep -qx 'hits 2' out
report 'two walls of the same mesh: an impact on each' $? out

script 'deleted' plane <<'LINES'
fix worn all wear/finnie surface cad flow_stress 1e9
create_atoms 1 single 0 0 0.0501 units box
create_atoms 1 single 0.5 0.5 0.06 units box
set group all diameter 0.1 density 2385
set atom 1 vz -0.5 vx 0.4
region low block INF INF INF INF INF 0.055 units box
run 1000
print "hits $(f_worn[3])"
group gone region low
delete_atoms group gone compress no
run 2
print "hits $(f_worn[3])"
LINES
printf 'hits 0\nhits 0\n' >wanted
grep '^hits' out >got
same 'an impact whose particle is deleted between two runs is not counted' wanted got

script 'leaves the box' plane <<'LINES'
change_box all boundary p p f
fix worn all wear/finnie surface cad flow_stress 1e9
create_atoms 1 single 0 0 0.0501 units box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2385
set atom 1 vz -0.5 vx 0.4
run 4200
print "hits $(f_worn[3])"
LINES
grep -qx 'hits 1' out
report 'an impact is counted when it has ended' $? out

# A sphere held on the plane by its weight slides s = v t under F = m g.
script sliding plane <<'LINES'
fix worn all wear/archard surface cad k 1e-3 hardness 1e9
create_atoms 1 single 0 0 0.05 units box
set group all diameter 0.1 density 2385
variable m equal mass(all)
set group all z $(0.05-v_m*9.81/1e6:%.17g)
fix weight all gravity 9.81 vector 0 0 -1
velocity all set 0.7 0 0 units box
run 1000
print "off $(f_worn/(1e-3*v_m*9.81*0.7*1e-3/1e9)-1)"
LINES
awk '$1 == "off" { seen = 1; bad = !($2 * $2 < 1e-18) } END { exit bad || !seen }' out
report 'sliding: k F s/H' $? out

# A frozen sphere that keeps its speed does the same under F = k_n overlap on each sort of surface, one that is buried in it nothing.
for sort in plane flat field; do
	script "frozen on $sort" $sort <<'LINES'
fix worn all wear/archard surface cad k 1e-3 hardness 1e9
create_atoms 1 single 0 0.2 0.0499 units box
create_atoms 1 single 0 -0.4 0 units box
set group all diameter 0.1 density 2385
fix hold all freeze
velocity all set 0.7 0 0 units box
run 1000
print "off $(f_worn/(1e-3*1e6*1e-4*0.7*1e-3/1e9)-1)"
LINES
	awk '$1 == "off" { seen = 1; bad = !($2 * $2 < 1e-18) } END { exit bad || !seen }' out
	report "frozen on $sort: k F s/H" $? out
done

# refused WHAT SURFACE LINE MESSAGE
refused() {
	{
		cat in.head
		surface_of "$2"
		echo "$3"
	} >in.no
	! "$TSIM" -in in.no -log none >out 2>&1 && grep -q "$4" out
	report "$1" $? out
}
refused 'unknown surface' plane 'fix worn all wear/finnie surface cat flow_stress 1' "no surface 'cat'.*cad"
refused 'a wall of meshes' flat 'fix worn all wear/finnie surface w flow_stress 1' "made of meshes; name one of them: 'cad'"
refused 'a fix without elements' flat 'fix worn all wear/finnie surface integrate flow_stress 1' 'has no elements'
refused 'no hardness' flat 'fix worn all wear/archard surface cad k 1' 'hardness'
refused 'negative flow stress' flat 'fix worn all wear/finnie surface cad flow_stress -1' 'flow_stress'
printf '%s\n' '0 0 0 0.5 0 0 0.25 0 0' '0 0 0 0.5 0 0 0.25 0.5 0' | solid >line.stl
refused 'an element of no area' line '' 'area\|faulty\|degenerate\|angle'

# Threads, and cuts in the middle of impacts, give the same bytes.
deck=$top_srcdir/tests/decks/in.wear
for threads in 1 3; do
	printf 'package omp %s grain 1\ninclude %s\nrun 1700\nwrite_restart whole.%s\n' $threads "$deck" $threads >in.run
	"$TSIM" -in in.run -log none >out.$threads 2>&1
	report "$threads threads: runs" $? out.$threads
done
same 'threads' whole.1 whole.3
awk '$1 == 1700 { seen = 1; bad = !($4 > 0 && $5 > 0 && $7 > 10) } END { exit bad || !seen }' out.1
report 'the deck wears' $? out.1
# A surface without a wall; a law of sliding where impacts are not resolved.
{
	cat in.head
	echo 'fix cad all mesh/surface file flat.stl type 2
fix worn all wear/finnie surface cad flow_stress 1e6
run 0'
} >in.unused
"$TSIM" -in in.unused -log none >out 2>&1 && grep -q 'no fix wall/gran is made of the surface cad' out
report 'a surface that no wall is made of' $? out
# impact exact gives the volume of the closed form, on a plane, a mesh and a height field.
for wall in 'primitive type 2 zplane 0' 'mesh n_meshes 1 meshes cad' 'voxels cad'; do
	{
		cat in.head
		case $wall in
		primitive*) surface=hit ;;
		mesh*) surface=cad && echo 'fix cad all mesh/surface file flat.stl type 2' ;;
		*) surface=cad && echo 'fix cad all surface/voxel constant 0 type 2 cells 7 9' ;;
		esac
		cat <<-END
			fix hit all wall/gran model hooke/stiffness $wall impact exact
			fix worn all wear/finnie surface $surface flow_stress 1e6
			create_atoms 1 single 0.1 0.05 0.06 units box
			set group all diameter 0.1 density 2385
			velocity all set 3 0 -1
			timestep 0.01
			run 4
			variable v equal mass(all)*10/(2*2*1e6)*(sin(2*v_a)-3*sin(v_a)^2)
			variable a equal atan(1/3)
			print 'hits \$(f_worn[3]) error \$(abs(f_worn/v_v-1)<1e-12)'
		END
	} >in.exact
	"$TSIM" -in in.exact -log none >out 2>&1 && grep -qx 'hits 1 error 1' out
	report "impact exact, $wall" $? out
done
finish
