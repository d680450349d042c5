#!/bin/bash
# Rows of contacts, as they are in tables, and laws of unequal partners do not depend on which particle comes first in memory,
# which is another one on several ranks. Nor does the particle that a message names.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_ranks.sh
. "$top_srcdir/tests/lib_ranks.sh" || exit 99
has_ranks || exit 77
export OMP_NUM_THREADS=1

# Grains of two sizes, out of order in space, that collide with each other and with a plate.
cat >in.grains <<'END'
units si
boundary p p f
region box block 0 0.06 0 0.03 0 0.03 units box
create_box 2 box
fix m1 all property/global youngsModulus peratomtype 7e6 8.3e6
fix m2 all property/global poissonsRatio peratomtype 0.25 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.48 0.52 0.52 0.43
fix m4 all property/global coefficientFriction peratomtypepair 2 0.35 0.4 0.4 0.37
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.086 0.09 0.09 0.092
fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.29 0.35 0.35 0.31
fix m7 all property/global rollingStiffness scalar 2.3
pair_style gran model hertz tangential history rolling_friction ROLLING
pair_coeff * *
timestep 1e-5
create_atoms 1 random 200 4711 box overlap 0.0041 maxtry 500
set group all diameter 0.004 density 2500
set group all type/fraction 2 0.4 1103515
set type 2 diameter 0.0023
variable v atom sin(7*id)
variable w atom cos(5*id*id)
set group all vx v_v vy v_w omegax v_v
group odd id 1:1000000:2
fix plate all mesh/surface primitive plate length 0.06 width 0.03 move 0.03 0.015 0.002 type 1
fix plates all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
fix m all nve/sphere
compute pairs all pair/gran/local pos id force
compute c all pair/local dist
compute n all property/local natom1 natom2
compute walls all wall/gran/local id force
dump d all local 100 ${out}.pairs c_pairs[7] c_pairs[8] c_pairs[10] c_c
dump_modify d sort off
dump n all local 100 ${out}.near c_n[1] c_n[2]
dump_modify n sort off
dump w all local 100 ${out}.walls c_walls[3] c_walls[4]
dump_modify w sort off
dump chains all local/gran/vtk 100 ${out}.chains*.vtk pairs
dump end all custom 300 ${out}.dump id type x y z vx vy vz omegax omegay omegaz fx fy fz
dump_modify end format float %.17g
thermo_style custom step atoms ke
thermo 200
run 600
END
for rolling in epsd epsd2 epsd3; do sed "s/ROLLING/$rolling/" in.grains >"in.$rolling"; done
same_scenes 2 epsd epsd2 epsd3
[ "$(awk 'NF == 4 && $1 > 0' alone/epsd/x.pairs | wc -l)" -gt 50 ] && [ "$(awk 'NF == 2 && $1 > 0' alone/epsd/x.walls | wc -l)" -gt 5 ]
report 'there are contacts with grains and with the plate' $?
awk '/^ITEM/ { a = b = 0 } NF == 4 && $1 + 0 > 0 { n++; if ($1 < a || $1 == a && $2 <= b) wrong++; a = $1; b = $2 }
	END { exit !(n && !wrong) }' alone/epsd/x.pairs
report 'pairs are in the order of their identities' $?

{
	sed '/^dump/d; /^run/d' in.epsd
	printf '%s\n' 'run 300' 'unfix m' 'fix m odd nve/sphere' 'run 10'
} >in.idle
for n in 1 3; do
	on_ranks $n "$TSIM" -in in.idle -log none >out 2>&1 </dev/null
	grep -q 'not integrated by any fix; the first is particle 2 ' out
	report "the first particle that is not integrated, $n ranks" $? out
done
finish
