#!/bin/bash
# legacy yes and lammps: a run in two is not the run in one, and the command and the option are the same. That the numbers
# are those of LIGGGHTS and LAMMPS: tests/crosscheck/legacy.sh, scripts.sh (lammps/in.runs).
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.bounce <<'END'
units si
boundary f f f
legacy ${legacy}
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0 0 0.0513 units box
create_atoms 1 single 0.002 0.003 0.1513 units box
set group all diameter 0.1 density 2385
group low id 1
group high id 2
neighbor ${skin} bin
velocity high set -0.02 0 -0.9
set group high omegax -1.3 omegay 4.1
fix m1 all property/global kn peratomtypepair 1 2.385e5
fix m2 all property/global kt peratomtypepair 1 1.385e5
fix m3 all property/global gamman peratomtypepair 1 53
fix m4 all property/global gammat peratomtypepair 1 23
fix m5 all property/global coefficientFriction peratomtypepair 1 0.31
pair_style gran model hooke/stiffness tangential history
pair_coeff * *
fix pull high gravity 59.81 vector 0 0.1 -1
fix move high nve/sphere
timestep 1e-5
run ${first}
run 6000 upto
print "at $(x[2]) $(y[2]) $(z[2]) $(omegay[2])" screen no file ${out}
END
bounce() { # OUT LEGACY SKIN FIRST [OPTION]
	"$TSIM" -in in.bounce -log none -screen none -var out "$1" -var legacy "$2" -var skin "$3" -var first "$4" \
		${5-} 2>err
	report "$*" $? err
}
differs() {
	[ -s "$1" ] && [ -s "$2" ] && ! cmp -s "$1" "$2"
	report "$1 differs from $2" $? "$1"
}
bounce now no 0.2 200
bounce one no 0.003 6000
same 'in one or in two, whatever the skin' now one
bounce yes yes 0.2 200
differs now yes
bounce rebuilt yes 0.003 200
differs yes rebuilt
sed -i '/^legacy/d' in.bounce
bounce option no 0.2 200 -legacy
same 'the option is the command' yes option
# As LAMMPS: the forces of each run are computed anew, but the history ends with the contact.
bounce option no 0.2 200 '-legacy lammps'
sed -i '2a legacy ${legacy}' in.bounce
bounce lammps lammps 0.2 200
same 'the option -legacy lammps is the command' lammps option
bounce built lammps 0.003 200
same 'with legacy lammps results do not depend on the skin' lammps built
differs now lammps
differs yes lammps
"$TSIM" -legacy liggghts -in in.bounce >out 2>&1
[ $? = 2 ] && grep -q "expected lammps or nothing after -legacy, found 'liggghts'" out
report 'another word after -legacy' $? out
finish
