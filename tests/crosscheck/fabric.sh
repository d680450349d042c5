#!/bin/bash
# compute fabric: the tensors of LAMMPS for the same particles, on both cutoffs and between two types.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps

begin='units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes'
rest='pair_style gran/hooke/history 1e5 2e4 10 5 0.5 1
pair_coeff * *
neighbor 0.1 bin
timestep 1e-5
fix 1 all nve/sphere
compute r all fabric radius contact branch force/normal force/tangential
compute i all fabric type contact branch force/normal type/include 1 2
thermo_style custom step c_r[*] c_i[*]
thermo 20
run 20'
printf '%s\n' "$begin" 'region box block 0 5 0 5 0 5
create_box 2 box
create_atoms 1 random 60 1234 box
create_atoms 2 random 30 4321 box
set type 1 diameter 1.0
set type 2 diameter 1.4
set group all density 1000
velocity all create 1e3 77
write_data data.grains' "$rest" >in.lammps
lmp -in in.lammps -log none >lammps 2>&1
printf '%s\n' "$begin" 'read_data data.grains' "$rest" >in.tsim
"$TSIM" -in in.tsim -log none >tsim 2>&1
# Normal forces at the start, when velocities of whole and half steps are the same; tangential forces grow from zero
for by in lammps tsim; do awk 'shown && $1 == 0 || $1 == 20 && NF > 30 { print } /Step/ { shown = 1 }' $by >rows.$by; done
paste -d ' ' rows.lammps rows.tsim | awk '{ n = NF / 2
	for (k = 2; k <= n; k++) {
		if (k >= 20 && k <= 25 && $1 == 0) continue
		rows++
		d = $k - $(k + n); size = $1 == 0 || k <= 13 ? 2e-6 : 5e-3
		if (!(d < size && -d < size)) { print "step", $1, "column", k, $k, $(k + n); bad = 1 }
	}
	tangential += NR == 2 ? ($20)^2 : 0 }
	END { print rows + 0, tangential; exit bad || rows != 78 || !(tangential > 0) }' >off
report 'tensors of LAMMPS' $? off
finish
