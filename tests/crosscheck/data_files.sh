#!/bin/bash
# Data files between programs: what tsim writes LIGGGHTS and LAMMPS read, and the other way round,
# with the same number of particles and the same energies.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.tsim <<'END'
units si
boundary p p f
region box block 0 1.3173 -0.1 1.2385 0 0.7 units box
create_box 2 box
create_atoms 1 random 57 86028157 NULL
variable d atom 0.05+0.002*sin(id)
variable w atom 0.1*id
set group all diameter v_d density 2385 omegax v_w
set atom 20* type 2
velocity all create 1e20 4928459
fix a all property/global youngsModulus peratomtype 1e7 1e7
fix b all property/global poissonsRatio peratomtype 0.3 0.3
fix c all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
pair_style gran model hertz tangential off
pair_coeff * *
write_data tsim.data
pair_style none
thermo_style custom step atoms ke erotate
run 0
END
reading() { # program's lines before, between and after
	printf '%s\n' 'units si' 'atom_style sphere' 'boundary p p f' "$@"
}
numbers() { # the row of step 0, its energies to eight digits
	grep -E '^ +0 +57 ' "$1" >"$2"
	[ -s "$2" ]
}
"$TSIM" -in in.tsim -log none >tsim.out 2>&1 && numbers tsim.out tsim.row
report 'tsim writes' $? tsim.out
again() { # what, file
	printf '%s\n' 'boundary p p f' "read_data $2" 'thermo_style custom step atoms ke erotate' 'run 0' >in.back
	"$TSIM" -in in.back -log none >back.out 2>&1 && numbers back.out back.row && cmp tsim.row back.row
	report "$1" $? back.out
}
again 'tsim reads its own' tsim.data

if has liggghts; then
	reading 'newton off' 'communicate single vel yes' 'read_data tsim.data' \
		'fix a all property/global kn peratomtypepair 2 1 1 1 1' \
		'fix b all property/global kt peratomtypepair 2 1 1 1 1' \
		'fix c all property/global gamman peratomtypepair 2 0 0 0 0' \
		'fix d all property/global gammat peratomtypepair 2 0 0 0 0' \
		'pair_style gran model hooke/stiffness tangential off' 'pair_coeff * *' \
		'neighbor 0.01 bin' 'neigh_modify delay 0' 'fix 1 all nve/sphere' 'timestep 1e-6' \
		'compute r all erotate/sphere' 'thermo_style custom step atoms ke c_r' 'run 0' \
		'write_data liggghts.data' >in.liggghts
	liggghts -in in.liggghts -log none >liggghts.out 2>&1 && numbers liggghts.out liggghts.row
	report 'LIGGGHTS reads it' $? liggghts.out
	same 'LIGGGHTS has the same energies' tsim.row liggghts.row
	again 'tsim reads the file of LIGGGHTS' liggghts.data
fi
if has lmp lammps; then
	reading 'comm_modify vel yes' 'read_data tsim.data' \
		'pair_style gran/hooke 1 NULL 0 NULL 0 0' 'pair_coeff * *' 'fix 1 all nve/sphere' \
		'compute r all erotate/sphere' 'thermo_style custom step atoms ke c_r' \
		'thermo_modify norm no format float %14.8g format int %8d' 'run 0' \
		'write_data lammps.data' >in.lammps
	lmp -in in.lammps -log none >lammps.out 2>&1 && numbers lammps.out lammps.row
	report 'LAMMPS reads it' $? lammps.out
	awk '{ $1 = $1 } 1' tsim.row >tsim.words
	awk '{ $1 = $1 } 1' lammps.row >lammps.words
	same 'LAMMPS has the same energies' tsim.words lammps.words
	again 'tsim reads the file of LAMMPS' lammps.data
fi
finish
