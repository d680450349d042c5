#!/bin/bash
# Meshes that recede as they wear: account of the volume, restarts, threads, motion, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
needs python3
export OMP_WAIT_POLICY=passive

# head UNIT: a box of side 2 UNIT, with grains whose speed does not depend on the unit
head_of() {
	awk -v u="$1" 'BEGIN {
		printf "variable u equal %g\n", u
	}'
	cat <<'END'
units si
boundary f f f
atom_style granular
newton off
communicate single vel yes
neighbor $(0.01*v_u) bin
region b block $(-v_u) ${u} $(-v_u) ${u} $(-v_u) ${u} units box
create_box 2 b
fix m1 all property/global youngsModulus peratomtype 5e6 7e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.6 0.6 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.2 0.3 0.3 0.4
pair_style gran model hertz tangential history
pair_coeff * *
fix step all nve/sphere
timestep $(1e-5*v_u)
END
}
plate 8 0 >plate.stl

# grains: above the square about the z axis
grains() {
	cat <<'END'
region bed block $(-0.4*v_u) $(0.4*v_u) $(-0.4*v_u) $(0.4*v_u) $(0.02*v_u) $(0.06*v_u) units box
lattice sc $(0.04*v_u)
create_atoms 1 region bed
set type 1 diameter $(0.02*v_u) density 2500
velocity all set 2 -1 -5 units box
END
}
totals() {
	# shellcheck disable=SC2016
	echo 'print "volume $(f_worn:%.17g) taken $(f_worn[9]:%.17g) pending $(f_worn[10]:%.17g) surplus $(f_worn[11]:%.17g) hits $(f_worn[3])"'
}
run_script() {
	"$TSIM" -in in.one -log none >out 2>&1
	report "$1: runs" $? out
}

# While a flat plate recedes once, along its normal, the volume is the mean depth of its triangles, which have equal areas.
# flat WHAT UNIT MOTION
flat() {
	{
		head_of "$2"
		# shellcheck disable=SC2016
		echo 'fix cad all mesh/surface file plate.stl type 2 scale ${u}'
		[ -n "$3" ] && echo "fix turn all move/mesh mesh cad $3"
		echo 'fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad'
		grains
		# shellcheck disable=SC2016
		echo 'fix worn all wear/finnie surface cad flow_stress 3e6 evolve yes evolve_every 1400
compute z all reduce sum f_worn[12]
run 1399
print "before $(c_z)"
run 1
print "swept $(-c_z*v_u^2/128:%.17g)"'
		totals
	} >in.one
	run_script "$1"
	awk 'function off(a, b) { return (a - b) ^ 2 > (1e-9 * b) ^ 2 }
		$1 == "before" { bad += $2 ^ 2 > 1e-30; seen++ }
		$1 == "swept" { swept = $2; seen++ }
		$1 == "volume" { seen++; bad += off(swept, $2) || off($4, $2) || $6 > 1e-12 * $2 || $8 != 0 || $10 < 400 || $2 <= 0 }
		END { exit bad || seen != 3 }' out
	report "$1: the volume worn is that between the surfaces" $? out
}
flat 'a plate' 1 ''
flat 'micrometres' 1e-6 ''
flat 'kilometres' 1e3 ''
flat 'a plate that turns' 1 'rotate origin 0.1 0.2 0 axis 0 0 1 period 0.3'
flat 'a plate that moves' 1 'linear 0.3 0.1 0'

# A closed body that recedes many times: the volume that the files of the mesh enclose, which have 6 digits.
body_volume() {
	awk '$1 == "vertex" { x[n % 3] = $2; y[n % 3] = $3; z[n % 3] = $4; n++
		if (n % 3 == 0) sum += x[0] * (y[1] * z[2] - z[1] * y[2]) + y[0] * (z[1] * x[2] - x[1] * z[2]) + z[0] * (x[1] * y[2] - y[1] * x[2])
	} END { printf "%.17g\n", sum / 6 }' "$1"
}
# shellcheck disable=SC2016
body_script() {
	head_of 1
	echo 'fix cad all mesh/surface file body.stl type 2 move 0 0 -0.3'
	echo 'fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad'
	grains
	echo "fix worn all wear/finnie surface cad flow_stress $1 evolve yes evolve_every 100 $2"
	echo 'dump d all mesh/stl 1400 body*.out cad'
	echo 'run 1400'
	totals
}
cuboid 0.5 0.4 0.3 >body.stl
body_script 1e4 '' >in.one
run_script 'a body'
awk -v before="$(body_volume body0.out)" -v after="$(body_volume body1400.out)" '
	$1 == "volume" { seen = 1; change = before - after; bad = ($2 - change) ^ 2 > (1e-2 * change) ^ 2 || $2 < 1e-4 || $4 - $2 > 1e-12 * $2 }
	END { exit bad || !seen }' out
report 'a body: dump mesh/stl writes the body that has lost the volume worn' $? out

# Depth: a triangle gives its area times the thickness, and no more.
body_script 1e4 'thickness 1e-5' >in.one
run_script 'thickness'
awk '$1 == "volume" { seen = 1; bad = !($8 > 0) || ($4 + $6 + $8 - $2) ^ 2 > (1e-12 * $2) ^ 2 || $4 > 1e-5 * 3.76 * (1 + 1e-12) }
	END { exit bad || !seen }' out && grep -q 'worn through' out
report 'thickness: surplus is not taken' $? out

# refused WHAT MESSAGE: the lines of standard input end with an error that has this text
refused() {
	cat >in.one
	! "$TSIM" -in in.one -log none >out 2>&1 && grep -q "$2" out
	report "$1 is refused" $? out
}
body_script 1 '' | refused 'a fold' 'triangle [0-9]* at .*receded by the volume worn'
body_script 1e4 'thickness 1e-5 through error' | refused 'through error' 'is worn through at step'
body_script 1e4 'through open' | refused 'through open' 'needs the .thickness'
body_script 1e4 'layer 1e-5' | refused 'layer' 'for height fields'
body_script 1e4 '' | sed '/^fix cad/s/$/ surface_vel 1 0 0/' | refused 'a belt' 'moves along the mesh'
printf '%s\n' '0 0 0 1 0 0 0 1 0' '0 0 0 1 0 0 0 -1 0' '0 0 0 1 0 0 0 0 1' | solid >fin.stl
body_script 1e4 '' | sed 's/body.stl/fin.stl/' | refused 'a branched surface' 'more than two triangles share'
{
	head_of 1
	echo 'fix cad all mesh/surface file plate.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
create_atoms 1 single 0.1 0 0.011 units box
create_atoms 1 single -0.1 0 -0.011 units box
set type 1 diameter 0.02 density 2500
set atom 1 vz -5 vx 3
set atom 2 vz 5 vx 3
fix worn all wear/finnie surface cad flow_stress 1e6 evolve yes evolve_every 100
run 2000'
} | refused 'wear on both sides of a sheet' 'worn on both sides'

# From below, on triangles of any winding: the plate recedes upwards.
awk '/outer/ { n++ } /vertex/ { k = (k + 1) % 3; if (n % 3 == 0) { if (k == 1) { a = $0; next } if (k == 2) { print; print a; next } } } 1' \
	plate.stl >mixed.stl
{
	head_of 1
	echo 'fix cad all mesh/surface file mixed.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad'
	grains | sed 's/(0.02\*v_u) \$(0.06/(-0.06*v_u) $(-0.02/; s/2 -1 -5/2 -1 5/'
	# shellcheck disable=SC2016
	echo 'fix worn all wear/finnie surface cad flow_stress 3e6 evolve yes evolve_every 1400
compute z all reduce sum f_worn[12]
run 1400
print "swept $(c_z/128:%.17g)"'
	totals
} >in.one
run_script 'from below'
grep -q 'normal opposite' out &&
	awk '$1 == "swept" { swept = $2 } $1 == "volume" { seen = 1; bad = (swept - $2) ^ 2 > (1e-9 * $2) ^ 2 } END { exit bad || !seen || !swept }' out
report 'from below, mixed windings: the volume worn is that between the surfaces' $? out

# A knife edge: contacts have normals against those of the triangles to which the edge belongs.
awk 'function p(k) { return (k % 2 ? 0.5 : -0.5) " " (k > 3 ? 0 : int(k / 2) ? 0.05 : -0.05) " " (k > 3 ? 0 : -0.4) }
	BEGIN {
		n = split("0 3 1 0 2 3 0 1 5 0 5 4 2 4 5 2 5 3 0 4 2 1 3 5", k)
		for (i = 1; i <= n; i += 3) print p(k[i]), p(k[i + 1]), p(k[i + 2])
	}' | solid >body.stl
# shellcheck disable=SC2016
body_script 1e4 '' | sed 's/ move 0 0 -0.3//; s/v_u) \$(-0.4\*v_u) \$(0.4/v_u) $(-0.02*v_u) $(0.02/; s/2 -1 -5/2 0.1 -5/; s/^run/compute b all reduce sum f_worn[8]\nrun/' >in.one
run_script 'a knife'
awk -v before="$(body_volume body0.out)" -v after="$(body_volume body1400.out)" '
	$1 == "volume" { seen = 1; change = before - after; bad = ($2 - change) ^ 2 > (0.05 * change) ^ 2 || $2 <= 0 || $4 - $2 > 1e-12 * $2 }
	END { exit bad || !seen }' out
report 'a knife loses the volume worn' $? out

# Springs of contacts are kept: wear of next to nothing in each step changes next to nothing in the motion of a grain that
# rolls, held by friction, over several triangles.
for evolve in no yes; do
	{
		head_of 1
		echo 'fix cad all mesh/surface file plate.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
create_atoms 1 single -0.11 0.02 0.0299 units box
set type 1 diameter 0.06 density 2500
fix g all gravity 9.81 vector 0 0 -1
velocity all set 2 0.5 0 units box'
		# shellcheck disable=SC2016
		echo "fix worn all wear/archard surface cad k 1e-9 hardness 1e9 evolve $evolve evolve_every 1
run 6000
print \"moved \$(xcm(all,x):%.17g) \$(xcm(all,y):%.17g) \$(vcm(all,x):%.17g) \$(f_worn[9] > 0)\""
	} >in.one
	run_script "rolling, evolve $evolve"
	grep '^moved' out >"rolled.$evolve"
done
cat rolled.no rolled.yes | awk '$1 == "moved" { for (k = 2; k < 5; k++) { if (NR > 1) bad += ($k - x[k]) ^ 2 > (1e-7 * $k) ^ 2; x[k] = $k } on = $5 }
	END { exit bad || NR != 2 || on != 1 || x[2] < 0 }'
report 'springs of contacts are kept' $? out

# A hole: grains in the middle wear triangles through, those after them fall through the hole, and others do not; the plate
# in dumps is without these triangles.
{
	head_of 1
	# shellcheck disable=SC2016
	echo 'fix cad all mesh/surface file plate.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
region drop block -0.06 0.06 -0.06 0.06 0.02 0.3 units box
lattice sc 0.04
create_atoms 1 region drop
create_atoms 1 single 0.3 0.3 0.25 units box
set type 1 diameter 0.02 density 2500
velocity all set 2 0 -8 units box
fix worn all wear/finnie surface cad flow_stress 1e4 evolve yes evolve_every 50 thickness 1e-4 through open
fix f all gravity 9.81 vector 0 0 -1
dump d all mesh/stl 8000 hole*.out cad
dump v all mesh/vtk 8000 hole*.vtk id cad
run 8000
region below block INF INF INF INF INF -0.05 units box
region above block INF INF INF INF 0.05 INF units box
print "below $(count(all,below)) above $(count(all,above)) through $(f_worn[12])"'
	totals
} >in.one
run_script 'a hole'
awk '$1 == "below" { seen = 1; bad += !($2 > 5 && $4 > 5 && $6 >= 2) } $1 == "volume" { seen++; bad += $4 > 1e-4 || ($4 + $8 - $2) ^ 2 > (1e-12 * $2) ^ 2 }
	END { exit bad || seen != 2 }' out &&
	[ "$(grep -c outer hole0.out)" -gt "$(grep -c outer hole8000.out)" ] &&
	[ "$(awk '$1 == "POLYGONS" { print $2 - 1 }' hole8000.vtk)" = "$(grep -c outer hole8000.out)" ]
report 'particles pass where the mesh is worn through' $? out

# No volume: the mesh stays as it is, to the last bit.
for evolve in no yes; do
	{
		head_of 1
		echo 'fix cad all mesh/surface file plate.stl type 2
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad'
		grains | sed 's/2 -1 -5/0 0 -5/'
		# shellcheck disable=SC2016
		echo "fix worn all wear/finnie surface cad flow_stress 3e6 evolve $evolve
run 1400
print \"ke \$(ke:%.17g) x \$(xcm(all,x):%.17g) z \$(xcm(all,z):%.17g)\""
	} >in.one
	run_script "no volume, evolve $evolve"
	grep '^ke' out >"still.$evolve"
done
same 'without tangential speed nothing is worn, and nothing moves' still.no still.yes

# Threads, and a run that is cut anywhere, give the same bytes; two meshes, one of which moves.
deck=$top_srcdir/tests/decks/in.receding
for threads in 1 2 3; do
	printf 'variable out index t%s\npackage omp %s grain 1\ninclude %s\nwrite_restart whole.%s\n' $threads $threads "$deck" $threads >in.run
	"$TSIM" -in in.run -log none >out.$threads 2>&1
	report "$threads threads: runs" $? out.$threads
done
same 'two threads' whole.1 whole.2
same 'three threads' whole.1 whole.3
same 'the mesh in dumps does not depend on threads' t1.2050.stl t3.2050.stl
awk '$1 == 2300 { seen = 1; bad = !($6 > 0 && $7 > 0 && $10 > 0) || ($6 + $7 - $5) ^ 2 > (1e-12 * $5) ^ 2 } END { exit bad || !seen }' out.1
report 'the deck wears both meshes' $? out.1
sed '/^dump/d' "$deck" >deck
for cut in '0 0' '2 203' '2 503' '2 1047'; do
	rm -f ./*.restart
	# shellcheck disable=SC2086
	python3 "$top_srcdir/tests/split_deck.py" deck $cut in.first in.second
	for part in first second; do
		[ "$cut $part" = '0 0 second' ] && continue
		"$TSIM" -var out c -in in.$part -log none >out 2>&1
		report "cut at $cut, $part: runs" $? out
	done
	mv end.restart "end ${cut/ /.}"
done
same 'continued from step 903, before any wear' 'end 0.0' 'end 2.203'
same 'continued from step 1203' 'end 0.0' 'end 2.503'
same 'continued from step 1747' 'end 0.0' 'end 2.1047'
finish
