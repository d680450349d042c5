#!/bin/bash
# Dumps: frames byte for byte, which particles, which order, when; and every rejection.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

scene='units si
boundary p p f
region box block 0 2 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.25 0.5 0.5 units box
create_atoms 2 single 1.5 0.5 0.25 units box
create_atoms 1 single 1 0.25 0.75 units box
set group all diameter 0.1 mass 2.385
set atom 1 vx 2 image 1 0 NULL
set atom 3 vz -0.5
fix move all nve/sphere
neighbor 0.01 bin
timestep 0.001
thermo 100
'
wrote() { # WHAT LINES FILE: the file is the same as `want`
	printf '%s\n' "$scene" "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "$1: runs" $? out
	same "$1" want "$3"
	rm -f ./*.dump
}
frame() { # STEP N COLUMNS ROWS...
	local step=$1 n=$2 columns=$3
	shift 3
	printf 'ITEM: TIMESTEP\n%d\n' "$step"
	[ -n "${label-}" ] && printf 'ITEM: LABEL\n%s\n' "$label"
	printf 'ITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS pp pp ff\n0 2\n0 1\n0 1\nITEM: ATOMS %s \n' "$n" "$columns"
	[ $# = 0 ] || printf '%s \n' "$@"
}
frame 0 3 'id type xs ys zs' '1 1 0.125 0.5 0.5' '2 2 0.75 0.5 0.25' '3 1 0.5 0.25 0.75' >want
wrote 'atom' 'write_dump all atom a.dump' a.dump
frame 0 3 'id type x y z ix iy iz' '1 1 0.25 0.5 0.5 1 0 0' '2 2 1.5 0.5 0.25 0 0 0' '3 1 1 0.25 0.75 0 0 0' >want
wrote 'atom as it is' 'write_dump all atom a.dump modify scale no image yes' a.dump
printf '3\nAtoms. Timestep: 0\nC 0.25 0.5 0.5\nbit 1.5 0.5 0.25\nC 1 0.25 0.75\n' >want
wrote 'xyz' 'write_dump all xyz a.dump modify element C bit' a.dump
frame 0 3 'id xu xsu proc element vz' '3 1 0.5 0 1 -0.5' '2 1.5 0.75 0 2 0' '1 2.25 1.125 0 1 0' >want
wrote 'names, sorted downwards' 'write_dump all custom a.dump id xu xsu proc element vz modify sort -1' a.dump
frame 0 3 'element x' '   A 0.25' ' bit 1.50' '   A 1.00' >want
wrote 'a format of names' 'write_dump all custom a.dump element x modify element A bit format line "%4s %4.2f"' a.dump
frame 0 3 'z id' '0.25 2' '0.5 1' '0.75 3' >want
wrote 'sorted by a column' 'write_dump all custom a.dump z id modify sort 1' a.dump
frame 0 1 'id' 1 >want
wrote 'several conditions' 'variable twice atom 2*x
write_dump all custom a.dump id modify thresh z >= 0.5 thresh v_twice != 2' a.dump
frame 0 2 'id' 1 3 >want
wrote 'conditions forgotten, a region' 'region up block INF INF INF INF 0.4 INF units box
write_dump all custom a.dump id modify thresh id > 5 thresh none region up' a.dump
label='of it'
frame 0 3 'id x' '  1 2.50000e-01' '  2 1.50000e+00' '  3 1.00000e+00' >want
label=
wrote 'formats and a label' 'write_dump all custom a.dump id x modify format float %.5e format int %3d label "of it"' a.dump
frame 0 3 'id x' '001 0.25' '002 1.5' '003 1' >want
wrote 'formats of columns and of the line' 'write_dump all custom a.dump id x modify format line "%03d %g" format 2 %.2g' a.dump 2>/dev/null
{ frame 2 3 id 1 2 3; frame 4 3 id 1 2 3; frame 8 3 id 1 2 3; } >want
wrote 'a variable says when' 'variable s equal logfreq(2,1,2)
dump a all custom 5 a.dump id
dump_modify a every v_s
run 9' a.dump
{ frame 5 3 id 1 2 3; frame 10 3 id 1 2 3; } >want
wrote 'the first frame from the delay on' 'dump a all custom 5 a.dump id
dump_modify a first yes delay 4
run 7
run 4' a.dump
printf '%s\n' "$scene" 'dump a all custom 2 f.*.dump id
dump_modify a maxfiles 2 pad 3
run 8' >in.script
"$TSIM" -in in.script -log none >out 2>&1
report 'only the last files stay' "$(ls f.*.dump | tr '\n' ' ' | cmp -s - <(echo -n 'f.006.dump f.008.dump '); echo $?)" out
printf 'ITEM: UNITS\nsi\nITEM: TIME\n0\n' >want
frame 0 3 id 1 2 3 >>want
{ echo 'ITEM: TIME'; echo 0.003; frame 3 3 id 1 2 3; } >>want
wrote 'time and units' 'dump a all custom 3 a.dump id
dump_modify a time yes units yes
run 3' a.dump

wrong() { # WHAT LINE TEXT
	printf '%s\n' "$scene" "dump a all custom 5 a.dump id x" "$2" 'run 1' >in.script
	refused "$1" "$3" -in in.script
}
wrong 'no such column' 'dump_modify a sort 3' "sort is '3', expected id, off, or N or -N with the number of a column from 1 to 2"
wrong 'operator' 'dump_modify a thresh x =< 3' "'=<' is none of"
wrong 'limit' 'dump_modify a thresh x < y' "'y' is no number"
wrong 'half a condition' 'dump_modify a thresh x <' 'thresh takes a quantity'
wrong 'unknown quantity' 'dump_modify a thresh xx < 3' "'xx'"
wrong 'no region' 'dump_modify a region up' "'up'"
wrong 'format' 'dump_modify a format 1 %g' "'%g' is not a format of one integer"
wrong 'files of one file' 'dump_modify a maxfiles 3' 'whose file has a `*`'
wrong 'modify' 'write_dump all atom b.dump modify scales no' "unknown keyword 'scales'"
wrong 'standing still' 'variable s equal 0
dump_modify a every v_s' 'the step of the next frame would be 0'
# one frame in its file: another file takes the place of the old one, but not of a link
printf 'old\n' >target && printf 'old\n' >hard && ln -s target a.dump && ln hard hard.dump && rm -f b.*
printf '%s\nwrite_dump all custom a.dump id\nwrite_dump all custom hard.dump id\nwrite_dump all custom b.*.dump id\n' "$scene" >in.links
"$TSIM" -in in.links -log none -screen none && [ -L a.dump ] && cmp -s target hard && cmp -s target b.0.dump &&
	! grep -q old target && [ "$(echo b.*)" = b.0.dump ]
report 'links are written through, and nothing else is left' $?
finish
