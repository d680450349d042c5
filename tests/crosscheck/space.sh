#!/bin/bash
# The same lattices, regions, boxes and displacements by LAMMPS, and wedges and discs by LIGGGHTS: particles at
# the same places with the same types.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs liggghts
needs /usr/bin/python3 python3

# lammps WHAT DIMENSION BOUNDARY UNITS BOX SCRIPT: a case, in a folder of its own, run by tsim
cases=0
lammps() {
	cases=$((cases + 1))
	mkdir $cases
	echo "$1" >$cases/what
	printf '%s\n' "units $4" "dimension $2" 'atom_style sphere' "boundary $3" "region box block $5 units box" \
		'create_box 3 box' "$6" >in.script
	{
		echo clear
		cat in.script
		echo "write_dump all custom $cases/other.dump id type x y z modify format float %.17g sort id"
	} >>in.other
	{
		cat in.script
		echo "dump d all custom 1 $cases/tsim.dump id type x y z"
		echo 'dump_modify d sort id format line "%d %d %.17g %.17g %.17g"'
		echo 'run 0'
	} >in.tsim
	"$TSIM" -in in.tsim -log none >out 2>&1
	report "$1: tsim" $? out
}

# all cases by one LAMMPS, whose start takes longer than a case: particles of both programs, to 1e-12 of the largest of the column
compare() {
	lmp -in in.other -log none >out 2>&1
	report 'LAMMPS runs all cases' $? out
	/usr/bin/python3 - "$cases" <<'END' >off 2>&1
import sys


def rows(path):
    lines = open(path).read().split('\n')
    lines = lines[[line.startswith('ITEM: ATOMS') for line in lines].index(True) + 1:]
    return sorted(tuple(map(float, line.split())) for line in lines if line)


def difference(case):
    a, b = rows(case + '/other.dump'), rows(case + '/tsim.dump')
    assert len(a) == len(b) > 0, (len(a), len(b))
    size = [max(map(abs, column)) for column in zip(*a)]
    return max((abs(u - v) / s for x, y in zip(a, b) for u, v, s in zip(x, y, size) if u != v), default=0)


for case in map(str, range(1, int(sys.argv[1]) + 1)):
    what = open(case + '/what').read().strip()
    try:
        off = difference(case)
        print('same' if off < 1e-12 else 'off', off, what)
    except (OSError, ValueError, AssertionError) as error:
        print('off', repr(error), what)
END
	[ "$(wc -l <off)" = $cases ] && [ $cases -gt 80 ]
	report 'all cases are compared' $? off
	while read -r verdict rest; do
		[ "$verdict" = same ]
		report "$rest" $?
	done <off
}
box='-1.03 2.11 -0.7 1.9 -0.5 2.3'
plane='0 2 0 2 -0.05 0.05'

for style in sc bcc fcc hcp diamond; do
	lammps "$style" 3 'p p p' si "$box" "lattice $style 0.237
create_atoms 1 box"
	lammps "$style, faces that follow" 3 's m fs' si "$box" "lattice $style 0.1
create_atoms 1 box"
	lammps "$style, reduced" 3 'p p p' lj "$box" "lattice $style 11.3
create_atoms 2 box basis 1 3"
	lammps "$style, turned" 3 'p p p' si "$box" "lattice $style 0.237 orient x 1 1 1 orient y 1 -1 0 orient z 1 1 -2
create_atoms 1 box
create_atoms 2 single 1.1 0.7 0.1 units lattice"
	lammps "$style, shifted" 3 'p p p' si "$box" "lattice $style 0.237 origin 0.5 0.25 0 spacing 1 2 3
region r sphere 3 1 2 3.3 units lattice
create_atoms 1 region r
create_atoms 2 single 1.1 0.7 0.1 units lattice"
done
for style in sq sq2 hex; do
	lammps "$style" 2 'p p p' si "$plane" "lattice $style 0.137 orient x 1 1 0 orient y -1 1 0
create_atoms 1 box"
	lammps "$style, reduced" 2 'p p p' lj '-20 20 -20 20 -0.05 0.05' "lattice $style 0.8 origin 0.1 0.3 0
create_atoms 1 box"
done
lammps 'custom' 3 'p p p' si "$box" 'lattice custom 0.2 a1 1 0 0 a2 0.5 0.9 0 a3 0.1 0.2 1.3 basis 0 0 0 basis &
  0.5 0.5 0.5 basis 0.25 0.1 0.7 origin 0.13 0.17 0.19
create_atoms 1 box basis 2 2 basis 3 3'
lammps 'a formula' 3 'p p p' si "$box" 'lattice sc 0.137
variable xx internal 0
variable yy internal 0
variable v equal "v_xx^2+v_yy^2 < 0.6"
create_atoms 1 box var v set x xx set y yy'
lammps 'wrapped' 3 'p p p' si "$box" 'create_atoms 1 single -5.1 3.7 9.9 remap yes units box'

grid='lattice fcc 0.137 origin 0.11 0.23 0.31 spacing 8 10 7
create_atoms 1 box
variable a equal 0.3
variable b equal -0.2
variable t equal 0.7'
while read -r region; do
	for words in 'units lattice' 'side out units box' 'move v_a NULL v_b units lattice' \
		'side out units box move v_b v_a NULL rotate v_t 0.1 0.2 0.3 1 2 -1.5' \
		'rotate v_t 0.1 0.2 0.3 1 2 -1.5 units lattice'; do
		lammps "$region $words" 3 'p p p' si "$box" "$grid
region r $region $words
group r region r
set group r type 2"
	done
done <<'END'
block -0.5 0.7 -0.3 1.1 0 1
sphere 0.5 0.6 0.7 0.83
sphere 0.5 0.6 0.7 v_t
cylinder x 0.5 0.7 0.61 -0.5 1.3
cylinder y 0.5 0.7 v_t -0.5 1.3
cylinder z 0.5 0.7 0.61 EDGE 1.3
cone x 0.5 0.7 0.61 0.13 -0.5 1.3
cone y 0.5 0.7 0.1 0.93 -0.5 1.3
cone z 0.5 0.7 0.0 0.93 -0.25 1.3
plane 0.5 0.6 0.7 1 2 -3
prism -0.5 0.7 -0.3 1.1 0 1 0.31 -0.23 0.41
END

two='create_atoms 1 single 0.5 1.5 2 units box
create_atoms 2 single 1.9 1.7 2.2 units box
displace_atoms all move 1.3 0.4 0.5 units box'
while read -r line; do
	lammps "$line" 3 'p p p' si "$box" "$two
$line"
done <<'END'
change_box all x scale 2 remap x scale 2 remap units box
change_box all x scale 1.21 y volume z volume remap units box
change_box all x scale 1.1 z volume y scale 1.1 z volume units box
change_box all x delta -0.1 0.2 y volume remap units box
change_box all boundary s m f units box
displace_atoms all ramp x 0 0.7 y 1 2 units box
replicate 2 2 3
END

# before anything is wrapped: LAMMPS turns positions without wrapping, LIGGGHTS and tsim wrapped ones
lammps 'rotate' 3 'p p p' si "$box" 'create_atoms 1 single 0.5 1.5 2 units box
create_atoms 2 single 1.9 1.7 2.2 units box
displace_atoms all rotate 1 1 1 1 2 3 30 units box'

compare

# wedges
for words in 'axis x' 'axis y' 'axis z'; do
	for angles in 'angle0 20 angle 70' 'angle0 -122.5 angle 45' 'angle0 20 angle 270' 'angle0 0 angle 90'; do
		cat >in.wedge <<END
units si
atom_style granular
newton off
boundary p p p
lattice fcc 0.0731 origin 0.11 0.23 0.31
region box block -1.03 2.11 -0.7 1.9 -0.5 2.3 units box
create_box 1 box
create_atoms 1 box
region w wedge $words center 0.3 0.4 radius 0.83 bounds -0.3 1.2 $angles units box
group g region w
END
		liggghts -in in.wedge -log none 2>/dev/null | grep 'in group' >other
		"$TSIM" -in in.wedge -log none 2>/dev/null | grep 'in group' >tsim
		same "wedge $words $angles" other tsim
	done
done
finish
