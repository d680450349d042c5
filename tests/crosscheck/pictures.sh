#!/bin/bash
# dump image: LAMMPS covers the same pixels, whatever view, zoom and centre are, but for a shift by less than one pixel: the
# number of pixels that differ grows as the perimeter of the spheres.
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps

scene='units lj
atom_style sphere
boundary p p p
region box block 0 10 0 8 0 6
create_box 2 box
create_atoms 1 single 5 5 3
create_atoms 2 single 9 7 1
create_atoms 1 single 1 5 5
set type * diameter 2
set type * density 1'
for words in 'size 300 200' 'view 30 70 zoom 1.6 size 200 300' 'center s 0.3 0.5 0.9 up 0 1 0.2 view 100 -20'; do
	printf '%s\n' "$scene" 'pair_style zero 1.0' 'pair_coeff * *' \
		"write_dump all image lammps*.ppm type diameter box no 0.02 $words" >in.lammps
	lmp -in in.lammps -log none >out 2>&1
	printf '%s\n' "$scene" "write_dump all image tsim.ppm type diameter box no 0.02 $words" >in.tsim
	"$TSIM" -in in.tsim -log none >>out 2>&1
	for by in lammps0 tsim; do od -An -v -w3 -tu1 $by.ppm | awk '{ print ($1 + $2 + $3 > 0) }' >$by.lit; done
	paste lammps0.lit tsim.lit | awk '{ lit += $1; off += $1 != $2 } END { print off + 0, lit; exit !(lit > 900 && off < 4.5 * sqrt(lit)) }' >>out
	report "LAMMPS: $words" $? out
done
finish
