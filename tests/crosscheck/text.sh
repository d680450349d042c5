#!/bin/bash
# The text that other programs read, byte for byte as LIGGGHTS writes it: rows and titles of the table
# of the log, blocks of `line multi`, frames of dump custom.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs liggghts

cat >start.data <<'END'
two of three types

3 atoms
2 atom types
-0.5 1.3173 xlo xhi
0 1 ylo yhi
0 2.385 zlo zhi

Atoms

2 1 0.1 2500 0.25 0.5 0.5 1 0 -2
7 2 0.12 2385 0.75 0.5 0.5 0 0 0
3 1 0.11 1000 1.3 0.25 2.3 0 0 0

Velocities

2 1 0 0 0 0 2
7 0 1.25 0 0 -3 0
3 30 0 1e-7 1 2 3
END
cat >in.both <<'END'
units si
atom_style granular
boundary p p p
newton off
communicate single vel yes
read_data start.data
include in.law.${name}
neighbor 0.01 bin
neigh_modify delay 0
fix 1 all nve/sphere
timestep 1e-4
compute spin all erotate/sphere
compute spinning all erotate/sphere
variable twice equal 2*ke
thermo 7
thermo_style custom step elapsed elaplong atoms ke erotate time dt vol density lx yhi zlo xy cella cellgamma part fmax c_spin c_spinning v_twice
dump d all custom 5 ${name}.dump id type x y z xs ys zs xu yu zu ix iy iz vx vy vz fx omegax omegay omegaz tqx radius diameter mass density
dump_modify d sort id label fast
dump e all custom 10 ${name}.*.dump id x
dump_modify e pad 6 sort id
run 23
thermo_style custom step ke c_spin atoms vol
thermo_modify line multi
run 2
END
echo '# nothing touches' >in.law.tsim
cat >in.law.liggghts <<'END'
fix a all property/global kn peratomtypepair 2 1 1 1 1
fix b all property/global kt peratomtypepair 2 1 1 1 1
fix c all property/global gamman peratomtypepair 2 0 0 0 0
fix e all property/global gammat peratomtypepair 2 0 0 0 0
pair_style gran model hooke/stiffness tangential off
pair_coeff * *
END
liggghts -in in.both -var name liggghts -log none >liggghts.out 2>&1
report 'LIGGGHTS' $? liggghts.out
"$TSIM" -in in.both -var name tsim -log none >tsim.out 2>&1
report 'tsim' $? tsim.out
for name in liggghts tsim; do
	grep -E '^ +Step |^ +[0-9]+ +[0-9]+ ' $name.out >$name.table
	grep -E '^(Step|Volume) +=' $name.out >$name.blocks
	cat $name.0*.dump >$name.frames
done
same 'the table' liggghts.table tsim.table
same 'the blocks' liggghts.blocks tsim.blocks
same 'dump custom' liggghts.dump tsim.dump
same 'a file for each frame' liggghts.frames tsim.frames
finish
