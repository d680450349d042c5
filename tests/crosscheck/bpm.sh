#!/bin/bash
# LAMMPS' examples/bpm/impact (a ball hits a plate, both of bonded particles) against the logs that LAMMPS publishes with
# it. LAMMPS only makes the disturbed lattice here, so any of its versions will do.
# shellcheck source=tests/lib_lammps.sh
. "$top_srcdir/tests/lib_lammps.sh" || exit 99

cat >in.lattice <<'END2'
units lj
boundary f f f
atom_style sphere
lattice fcc 1.0
region box block -25 15 -22 22 -22 22
create_box 1 box
region disk cylinder x 0.0 0.0 20.0 -0.5 0.5
create_atoms 1 region disk
region ball sphere 8.0 0.0 0.0 6.0
create_atoms 1 region ball
displace_atoms all random 0.1 0.1 0.1 134598738
write_dump all custom lattice.dump id x y z modify format float %.17g sort id
END2
lmp -in in.lattice -log none >said 2>&1
report 'the lattice of LAMMPS' $? said
{
	printf 'lattice\n\n%d atoms\n1 atom types\n2 bond types\n\n' "$(awk 'NR == 4' lattice.dump)"
	awk 'NR > 5 && NR < 9 { d = substr("xyz", NR - 5, 1); print $0, d "lo", d "hi" }' lattice.dump
	printf '\nAtoms # sphere\n\n'
	awk 'NR > 9 { print $1, 1, 1, 1, $2, $3, $4 }' lattice.dump
} >data.lattice

cat >in.scene <<'END2'
units lj
dimension 3
boundary f f f
atom_style ${style}
special_bonds lj 0.0 1.0 1.0 coul 0.0 1.0 1.0
newton on off
comm_modify vel yes cutoff 2.6
lattice fcc 1.0
atom_style sphere
read_data data.lattice
group plate id <= 7529
group projectile id > 7529
include in.law
create_bonds many plate plate 1 0.0 1.5
create_bonds many projectile projectile 2 0.0 1.5
neighbor 0.3 bin
special_bonds lj 0.0 1.0 1.0 coul 1.0 1.0 1.0
include in.bonds
velocity projectile set -0.05 0.0 0.0 units lattice
compute nbond all nbond/atom
compute tbond all reduce sum c_nbond
variable tbond equal c_tbond/11118
thermo_style custom step ke pxx pyy pzz v_tbond
thermo 100
thermo_modify lost ignore lost/bond ignore format float %14.8g
run ${n}
END2

# as_published WHAT ROWS...: rows of the table that tsim prints
as_published() {
	local what=$1 row
	shift
	rows out | awk '{ $1 = $1; print }' >table
	for row in "$@"; do
		grep -qxF -- "$row" table
		report "$what: $row" $? table
	done
}

# log.24Sep2026.bpm.impact.spring.g++.1, all digits
printf '%s\n' 'mass 1 1.0' 'pair_style bpm/spring' 'pair_coeff 1 1 1.0 1.0 1.0' 'fix 1 all nve' >in.law
printf '%s\n' 'bond_style bpm/spring store/local brkbond 100 time id1 id2' 'bond_coeff 1 1.0 0.04 1.0' \
	'bond_coeff 2 1.0 0.20 1.0' 'timestep 0.1' >in.bonds
"$TSIM" -in in.scene -var style bond -var n 600 -log none >out 2>&1
as_published spring '100 0.0010167873 7.298968e-05 -8.7429897e-20 -8.8470837e-20 10.8703' \
	'300 0.0009951439 9.9273671e-05 8.1569216e-06 8.0922512e-06 10.868142' \
	'500 0.00092272662 8.1708784e-05 -9.7488701e-06 -1.3603634e-05 10.819752' \
	'600 0.00088967612 6.2587266e-05 -5.1954127e-06 -6.781587e-06 10.797985'

# log.4May2022.impact.rotational.g++.4: KinEng, Pxx, bonds per particle. The decomposition of the rotation differs in
# higher orders of the angle.
printf '%s\n' 'pair_style gran/hooke/history 1.0 NULL 0.5 NULL 0.1 1' 'pair_coeff 1 1' 'fix 1 all nve/bpm/sphere' >in.law
printf '%s\n' 'bond_style bpm/rotational store/local brkbond 100 time id1 id2' \
	'bond_coeff 1 1.0 0.2 0.02 0.02 0.05 0.01 0.01 0.01 0.1 0.2 0.002 0.002' \
	'bond_coeff 2 1.0 0.2 0.02 0.02 0.20 0.04 0.04 0.04 0.1 0.2 0.002 0.002' 'timestep 0.05' >in.bonds
"$TSIM" -in in.scene -var style bpm/sphere -var n 600 -log none >out 2>&1
rows out | awk '
	function near(a, b, within) { return a < b * (1 + within) && a > b * (1 - within) }
	$1 == 500 { n += near($2, 0.00053093549, 1e-5) + near($3, 4.0340893e-05, 1e-3) + near($6, 10.8703, 1e-6) }
	$1 == 600 { n += near($2, 0.00051485902, 1e-4) + near($3, 6.6761034e-05, 1e-3) + near($6, 10.869221, 1e-5) }
	END { exit n != 6 }'
report rotational $? out
finish
