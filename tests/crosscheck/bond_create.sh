#!/bin/bash
# fix bond/create and bond/break beside LAMMPS: the numbers of bonds step by step, and the pairs.
# shellcheck source=tests/lib_lammps.sh
. "$top_srcdir/tests/lib_lammps.sh" || exit 99

awk 'BEGIN {
	print "points\n\n300 atoms\n3 atom types\n1 bond types\n\n0 8 xlo xhi\n0 8 ylo yhi\n0 8 zlo zhi\n"
	print "Masses\n\n1 1\n2 1\n3 1\n\nAtoms # bond\n"
	srand(4711)
	for (i = 1; i <= 300; i++) printf "%d 0 %d %.15g %.15g %.15g\n", i, 1 + i % 2, 8 * rand(), 8 * rand(), 8 * rand()
}' >points.data
cat >in.both <<'END2'
units lj
atom_style bond
boundary p p p
newton off
special_bonds lj 1 1 1 coul 1 1 1
comm_modify cutoff 2.5
include in.${program}
timestep 1e-6
fix move all nve
fix join all bond/create 2 1 2 1.2 1 iparam 3 3 jparam 2 2
thermo 1
thermo_style custom step f_join[1] f_join[2]
run 12
compute pairs all property/local batom1 batom2
dump d all local 1 ${program}.pairs c_pairs[1] c_pairs[2]
unfix join
fix cut all bond/break 3 1 0.9
thermo_style custom step f_cut[1] f_cut[2]
run 12
END2
printf '%s\n' 'read_data points.data extra/bond/per/atom 12 extra/special/per/atom 60' 'neighbor 0.3 bin' 'pair_style zero 1.5' 'pair_coeff * *' \
	'bond_style zero' 'bond_coeff 1 1' >in.lmp
printf '%s\n' 'read_data points.data' 'bond_style contact' 'bond_coeff 1 stiffness 1e-9 ultimate 1e9' >in.tsim
lmp -in in.both -var program lmp -log none >said.lmp 2>&1
report LAMMPS $? said.lmp
"$TSIM" -in in.both -var program tsim -log none >said.tsim 2>&1
report tsim $? said.tsim
for program in lmp tsim; do
	awk '/Step/ { on = 1; next } /^ *[0-9]+ +[0-9]+ +[0-9]+ *$/ { print $1, $2, $3 }' said.$program >rows.$program
	awk '/ENTRIES/ && !/NUMBER/ { on = 1; next } /ITEM/ { on = 0 } on { print ($1 < $2 ? $1 " " $2 : $2 " " $1) }' $program.pairs |
		sort >sorted.$program
done
same 'numbers of bonds' rows.lmp rows.tsim
same 'pairs at all steps' sorted.lmp sorted.tsim
awk '$2 > 10 { n++ } END { exit n < 4 }' rows.tsim
report 'bonds are created and broken' $? rows.tsim
finish
