#!/bin/bash
# Words whose numbers LAMMPS gives too: velocity temp and bias, degrees of freedom, thermo_modify temp,
# neigh_modify include and exclude, molecules, sections of fix property/atom, energies of fixes.
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps

awk 'BEGIN {
	print "forty\n\n40 atoms\n1 atom types\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n\nAtoms # sphere\n"
	for (i = 1; i <= 40; i++)
		print i, 1, 0.85 + 0.01 * (i % 7), 2.385, 0.4 + 0.8 * ((i * 7) % 5), 0.45 + 0.8 * ((i * 3) % 4) + 0.01 * (i % 3), 0.5 + 0.8 * int((i - 1) / 10)
	print "\nVelocities\n"
	for (i = 1; i <= 40; i++) print i, sin(i), cos(3 * i), sin(2 * i) + 0.5, 0, 0, 0
	print "\nMolecules\n"
	for (i = 1; i <= 40; i++) print i, i % 3
}' >forty.data
cat >in.both <<'END'
units lj
newton off
atom_style sphere
atom_modify map array first low
boundary p p p
comm_modify vel yes
fix m all property/atom mol ghost yes
read_data forty.data fix m NULL Molecules
group low id 1:20
group odd id 1:40:2
group two molecule 2
pair_style gran/hooke 1000 NULL 0 NULL 0 0
pair_coeff * *
neighbor 0.2 bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
fix fall all gravity 0.3 vector 0 0 -1
timestep 1e-4
compute all all temp
compute low low temp
compute drift all temp/com
compute across low temp/partial 0 1 1
region there block INF INF INF INF 0.3 INF units box
compute there all temp/region there
set group low omega 0.7 0.2 3
compute ramp all temp/ramp vx -0.5 1.5 z 1 3 units box
compute profile low temp/profile 1 1 1 xz 2 2
compute layers all temp/profile 0 1 0 y 3
compute spin all temp/sphere
compute turn low temp/sphere dof rotate
variable e equal f_fall
variable n equal count(two)
variable z equal vcm(all,z)
thermo_style custom step temp c_all c_low c_drift c_across c_there c_across[2] c_across[4] c_there[5] c_ramp c_ramp[4] c_profile c_layers c_layers[6] c_spin c_turn c_spin[1] c_spin[5] c_turn[6] fnorm v_e v_n v_z
thermo_modify norm no format float %.15g
run 0
velocity low scale 1.7 temp low
run 0
velocity all scale 2.3 temp drift bias yes
run 0
velocity all scale 1.3 temp drift
run 0
compute_modify all extra/dof 0
compute_modify spin extra/dof 7
compute_modify turn extra/dof 2.5
compute_modify thermo_temp extra/dof 10
run 0
thermo_modify temp low
run 0
fix_modify fall energy yes
run 0
neigh_modify exclude group low odd
run 0
neigh_modify exclude none exclude molecule/intra all
run 0
neigh_modify exclude none exclude molecule/inter odd check yes
run 0
print "at the end"
END
# LAMMPS keeps to exclusions given before `include`: a script of its own
sed -e '/^thermo_style/,$d' in.both >in.include
cat >>in.include <<'END'
neigh_modify include low
thermo_style custom step temp c_all c_low c_drift c_spin c_turn c_spin[1] c_spin[5] c_turn[6] fnorm v_e v_n v_z
thermo_modify norm no format float %.15g
run 0
END
{ lmp -in in.both -log none && lmp -in in.include -log none; } >theirs 2>&1
grep -q '^at the end' theirs
report 'lmp runs' $? theirs
{ "$TSIM" -legacy lammps -in in.both -log none && "$TSIM" -in in.include -log none; } >ours 2>&1
report 'tsim runs' $? ours
for who in theirs ours; do
	grep -E '^ +0 +[-+0-9.e ]+$' $who >$who.rows
done
paste -d' ' theirs.rows ours.rows | awk '
	{ n = NF / 2
	  for (k = 2; k <= n; k++) {
		d = $k - $(k + n)
		size = $k < 0 ? -$k : $k
		if (d < 0) d = -d
		if (!(d <= 1e-12 * size)) { print "row " NR " column " k ": " $k " " $(k + n); bad = 1 }
		count++
	  } }
	END { print count " numbers"; exit bad || count != 10 * 23 + 13 }' >difference
report 'the same numbers' $? difference

# Forces of contacts along the surfaces, by compute pair/local: as magnitudes, since programs name the partners in either order.
# Without dashpots, as LAMMPS computes these forces anew with the velocities at the end of the step.
sed -e '/^compute all all temp/,$d; /^neigh_modify/d' -e 's|^pair_style.*|pair_style gran/hooke/history 1000 NULL 0 0 0.4 0|' in.both >in.local
cat >>in.local <<'END'
velocity all scale 3.0
compute sides all pair/local dist force p1 p2 p3 p4 cutoff radius
compute most all reduce max c_sides[1] c_sides[2] c_sides[6]
compute squares all reduce sumsq c_sides[3] c_sides[4] c_sides[5] c_sides[6]
thermo_style custom step c_most[1] c_most[2] c_most[3] c_squares[1] c_squares[2] c_squares[3] c_squares[4]
thermo_modify norm no format float %.15g
thermo 20
run 140
END
lmp -in in.local -log none >theirs 2>&1
report 'lmp runs in.local' $? theirs
"$TSIM" -legacy lammps -in in.local -log none >ours 2>&1
report 'tsim runs in.local' $? ours
paste -d' ' <(grep -E '^ +[0-9]+ +[-+0-9.e ]+$' theirs) <(grep -E '^ +[0-9]+ +[-+0-9.e ]+$' ours) | awk '
	{ for (k = 2; k <= 8; k++) {
		d = $k - $(k + 8)
		if (d < 0) d = -d
		if (!(d <= 1e-9 * $k + 1e-12)) { print "row " NR " column " k ": " $k " " $(k + 8); bad = 1 }
		if ($k > 0) count++
	  } }
	END { print count " numbers"; exit bad || NF != 16 || count < 50 }' >difference
report 'the same forces along the surfaces' $? difference
finish
