#!/bin/bash
# Chunks, averages and histograms by LAMMPS, an independent program: the files must be the same byte for
# byte, but for the precision and blanks in the head and tail of lines of a dump.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
script=$top_srcdir/tests/crosscheck/in.averages
lmp -in "$script" -var program lammps -log none -screen none >err 2>&1
report 'LAMMPS' $? err
"$TSIM" -in "$script" -var program tsim -log none -screen none 2>err
report 'tsim' $? err
for file in a1 a2 a3 a4 h1 h2 h3 t1 t2 t3 t4 t5 t6 t7 t8 t9 s1; do
	# what is 0 but for rounding
	for program in lammps tsim; do
		sed -E ':a;s/ -?[0-9.]+e-(1[6-9]|[23][0-9])( |$)/ 0\2/;ta' $program.$file >$program.$file.rounded
	done
	same "$file" lammps.$file.rounded tsim.$file.rounded
done
for program in lammps tsim; do
	sed -n '/^ITEM: ATOMS/,/^ITEM: TIMESTEP/p' $program.d | sed 's/ $//' >$program.chunks
done
same 'chunks' lammps.chunks tsim.chunks
finish
