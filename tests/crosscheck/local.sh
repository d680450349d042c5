#!/bin/bash
# Contacts and VTK files of LIGGGHTS 3.8, an independent program, against tsim's: the columns of compute
# pair/gran/local, and the numbers of .vtk files of dumps custom/vtk and local/gran/vtk.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts
needs /usr/bin/python3 python3

cat >in.contacts <<'END'
units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region b block 0 0.2 0 0.1 0 0.1 units box
create_box 2 b
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6 2.385e7
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.4 0.4 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-6
create_atoms 1 single 0.0101 0.011 0.012
create_atoms 1 single 0.0151 0.011 0.012
create_atoms 1 single 0.0951 0.051 0.052
create_atoms 2 single 0.0991 0.0515 0.0525
create_atoms 1 single 0.1951 0.091 0.092
set atom 1 diameter 0.006 density 2500
set atom 2 diameter 0.005 density 2500
set atom 3 diameter 0.005 density 2300
set atom 4 diameter 0.004 density 2500
set atom 5 diameter 0.007 density 2500
set atom 1 vx 0.5 vy 0.1 omegaz 3.1
set atom 2 vx -0.3 vz 0.2
set atom 3 vy 0.3
set atom 4 vx -0.2 omegax -2.3
set atom 5 vx -0.2
fix i all nve/sphere
compute c all pair/gran/local pos vel id force force_normal force_tangential torque history contactArea delta contactPoint
dump p all custom/vtk 10 p*.vtk id type x y z vx vy vz fx fy fz radius omegax omegay omegaz mass
dump l all local/gran/vtk 10 l*.vtk c
END
for k in $(seq 35); do printf 'c_c[%d] ' "$k"; done >columns
echo "dump t all local 10 t.txt $(cat columns)" >>in.contacts
echo 'run 30' >>in.contacts
mkdir liggghts tsim
(cd liggghts && liggghts -in ../in.contacts -log none -screen none) >err 2>&1
report 'LIGGGHTS runs' $? err
(cd tsim && "$TSIM" -in ../in.contacts -log none -screen none -legacy 2>../err)
report 'tsim runs' $? err
for side in liggghts tsim; do sed 's/ -0 / 0 /g; s/ -0 / 0 /g' $side/t.txt >$side.txt; done
same 'compute pair/gran/local, as text' liggghts.txt tsim.txt

# torque contains that of rolling friction, of pairs and walls
for rolling in cdt epsd epsd2; do
	plate="fix plate all mesh\\/surface file plate.stl type 1\\nfix wall all wall\\/gran model hertz tangential history"
	plate="$plate rolling_friction $rolling mesh n_meshes 1 meshes plate\\ncompute w all wall\\/gran\\/local id torque"
	sed -e "s/^pair_style .*/& rolling_friction $rolling/; s/^compute c .*/compute c all pair\/gran\/local id torque/" \
		-e 's/^pair_coeff.*/&\nfix m5 all property\/global coefficientRollingFriction peratomtypepair 2 0.3 0.2 0.2 0.1\nfix m6 all property\/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.2 0.2 0.1/' \
		-e "s/^fix i .*/&\\n$plate/; /^dump [pl]/d" \
		-e 's/^dump t .*/dump t all local 10 t.txt c_c[1] c_c[2] c_c[3] c_c[4] c_c[5] c_c[6]\ndump w all local 10 w.txt c_w[3] c_w[4] c_w[5] c_w[6]/' \
		in.contacts >in.rolling
	for side in liggghts tsim; do
		printf '%s\n' 'solid a' 'facet normal 0 0 1' 'outer loop' 'vertex 0.005 0.005 0.0091' 'vertex 0.025 0.005 0.0091' 'vertex 0.005 0.025 0.0091' \
			'endloop' 'endfacet' 'endsolid a' >$side/plate.stl
	done
	(cd liggghts && liggghts -in ../in.rolling -log none) >err 2>&1 # without a screen it fails at meshes
	report "LIGGGHTS runs, $rolling" $? err
	(cd tsim && "$TSIM" -in ../in.rolling -log none -screen none -legacy 2>../err)
	report "tsim runs, $rolling" $? err
	for file in t w; do
		paste -d' ' liggghts/$file.txt tsim/$file.txt | awk '
			/e-/ { n++ }
			{ for (k = 1; k <= NF / 2; k++) { a = $k; b = $(k + NF / 2); d = a - b; bad += d * d > 1e-10 * a * a + 1e-30 } }
			END { exit bad || n < 4 }'
		report "torques of $file, $rolling" $? liggghts/$file.txt tsim/$file.txt
	done
done

# Arrays of a legacy file; of LIGGGHTS' three lines for each contact the first.
cat >compare.py <<'END'
import sys

def arrays(path, wanted):
    tokens = open(path).read().split("FIELD FieldData")
    found, words = {}, tokens[1].split()
    at = 1
    for _ in range(int(words[0])):
        name, parts, n = words[at], int(words[at + 1]), int(words[at + 2])
        values = list(map(float, words[at + 4:at + 4 + parts * n]))
        found[name] = [values[k * parts:(k + 1) * parts] for k in range(n)]
        at += 4 + parts * n
    return found

theirs, ours = (arrays(path, None) for path in sys.argv[1:3])
step = int(sys.argv[3])
compared = 0
for name in theirs:
    a, b = theirs[name][::step], ours[name]
    assert len(a) == len(b), (name, len(a), len(b))
    for x, y in zip(a, b):
        largest = max(map(abs, x))
        for u, v in zip(x, y):
            assert abs(u - v) <= 1e-9 * largest + 1e-18, (name, u, v)
            compared += 1
print(compared, "numbers agree")
assert compared > 10
END
for step in 0 10 20 30; do
	/usr/bin/python3 compare.py liggghts/p$step.vtk tsim/p$step.vtk 1 >deviation 2>&1
	report "dump custom/vtk, step $step" $? deviation
	/usr/bin/python3 compare.py liggghts/l$step.vtk tsim/l$step.vtk 3 >deviation 2>&1
	report "dump local/gran/vtk, step $step" $? deviation
done

# particles on a mesh: rows in the order of identities, without the contact point, which LIGGGHTS leaves 0
printf '%s\n' 'solid p' 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0.02' 'vertex 0.2 0 0.02' 'vertex 0.2 0.1 0.02' \
	endloop endfacet 'facet normal 0 0 1' 'outer loop' 'vertex 0 0 0.02' 'vertex 0.2 0.1 0.02' 'vertex 0 0.1 0.02' \
	endloop endfacet 'endsolid p' >plate.stl
{
	sed -n '1,/^timestep/p' in.contacts
	cat <<'END'
create_atoms 1 single 0.0501 0.011 0.0225
create_atoms 1 single 0.1 0.05 0.0221
create_atoms 2 single 0.15 0.0475 0.0178
set atom 1 diameter 0.006 density 2500
set atom 2 diameter 0.005 density 2300
set atom 3 diameter 0.005 density 2500
set atom 1 vx 0.5 vy 0.1 omegaz 1
set atom 2 vx -0.3 vz 0.2
set atom 3 vx 0.1 vz 0.2 omegay 3
fix i all nve/sphere
fix m5 all property/global thermalConductivity peratomtype 100. 50.
fix m6 all property/global thermalCapacity peratomtype 10. 23.85
fix ht all heat/gran initial_temperature 300.
fix cad all mesh/surface file ../plate.stl type 1 temperature 411.
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
compute c all wall/gran/local pos vel id force force_normal force_tangential torque history contactArea delta heatFlux
dump l all local/gran/vtk 10 w*.vtk c
END
	echo "dump t all local 10 w.txt $(sed 's/c_c.34.*//' columns)"
	echo 'run 30'
} >in.walls
(cd liggghts && liggghts -in ../in.walls -log log) >err 2>&1
report 'LIGGGHTS runs with a mesh' $? err
(cd tsim && "$TSIM" -in ../in.walls -log none -screen none -legacy 2>../err)
report 'tsim runs with a mesh' $? err
for side in liggghts tsim; do
	sed 's/ -0 / 0 /g; s/ -0 / 0 /g' $side/w.txt | awk 'NF == 33 { print t, $15, $0 } /TIMESTEP/ { t++ }' | sort -n >$side.txt
done
same 'compute wall/gran/local, as text' liggghts.txt tsim.txt

# the heat of each contact
{
	sed -n '1,/^pair_coeff/p' in.contacts
	echo 'fix m5 all property/global thermalConductivity peratomtype 100. 50.'
	echo 'fix m6 all property/global thermalCapacity peratomtype 10. 23.85'
	sed -n '/^timestep/,/^fix i /p' in.contacts
	cat <<'END'
fix ht all heat/gran initial_temperature 300.
compute c all pair/gran/local id force contactArea delta heatFlux contactPoint
run 0
set atom 1 property/atom Temp 700.
set atom 4 property/atom Temp 200.
dump t all local 10 heat.txt c_c[1] c_c[2] c_c[4] c_c[7] c_c[8] c_c[9] c_c[10] c_c[11] c_c[12]
run 30
END
} >in.heat
(cd liggghts && liggghts -in ../in.heat -log none -screen none) >err 2>&1
report 'LIGGGHTS runs with heat' $? err
(cd tsim && "$TSIM" -in ../in.heat -log none -screen none -legacy 2>../err)
report 'tsim runs with heat' $? err
same 'heat of contacts, as text' liggghts/heat.txt tsim/heat.txt
finish
