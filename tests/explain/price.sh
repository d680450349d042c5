#!/bin/sh
# -explain tells what runs will cost: files as large as they then are, and nothing is left behind.
. "$top_srcdir/tests/lib_cases.sh"

cat >in.price <<'END'
units si
boundary p p p
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 random 500 86028157 b
set type 1 diameter 0.05 density 2385
velocity all create 0.385 49979687
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
fix move all nve
timestep 1e-4
shell mkdir post
dump a all custom 25 post/a*.dump id type x y z vx vy vz fx fy fz radius
dump b all custom 50 post/b.dump id x y z
dump v all custom/vtk 50 post/v*.vtp id type vx vy vz radius
compute e all ke
fix p all print 10 "$(step) $(c_e:%12.6g)" file post/p.txt
fix t all ave/time 10 1 10 c_e ke file post/t.txt
dump c all atom 25 post/c.atom
dump d all xyz 25 post/d.xyz
fix h all ave/histo 10 1 10 -1 1 40 vx file post/h.txt
restart 50 post/a.restart post/b.restart
run 50
run 50
END

"$TSIM" -explain -in in.price >out 2>err
report 'explained' $? err
[ ! -e post ] && [ ! -e log.tsim ]
report 'nothing is written' $?
grep -q '^duration: about .* time per step .* steps measured from the current state' out
report 'steps were tried' $? out
grep -q '^All runs together: about .* of files' out
report 'the whole script has a price' $? out

# without outputs what counts is who touches whom
sed '/^dump/d; /^fix [pt]/d; /^restart/d; s/^run.*/run 100000/' in.price >in.scattered
"$TSIM" -explain -in in.scattered >scattered 2>err
grep -q '^duration: about .* to .*, time per step .* in a dense packing' scattered
report 'scattered particles cost more when they lie together' $? scattered

# files of an earlier run stay as they are
mkdir post && echo kept >post/p.txt && echo kept >post/a0.dump && echo kept >post/b.dump
"$TSIM" -explain -in in.price >out2 2>err
report 'explained once more' $? err
[ "$(cat post/*)" = "$(printf 'kept\nkept\nkept')" ]
report 'files are left alone' $?
rm -r post

"$TSIM" -in in.price -screen none
# near NAME FILES...: the size told for NAME is that of the files, within a factor of 1.5
near() {
	name=$1
	shift
	told=$(awk -v name="$name" '$0 ~ name && / times / {
		unit["bytes"] = 1; unit["kB"] = 1e3; unit["MB"] = 1e6
		sum += $(NF-3) * $(NF-1) * unit[$NF] } END { print sum }' out)
	real=$(cat "$@" | wc -c)
	awk -v told="$told" -v real="$real" 'BEGIN { exit !(told < 1.5 * real && real < 1.5 * told) }'
	report "$name: told $told, found $real" $? out
}
near 'dump a ' post/a*.dump
near 'dump b ' post/b.dump
near 'dump v ' post/v*.vtp
near 'dump c ' post/c.atom
near 'dump d ' post/d.xyz
near 'post/h.txt' post/h.txt
# No frame is counted twice where one run ends and the next one begins.
told=$(awk '/ dump c / && / times / { n += $(NF-3) } END { print n }' out)
[ "$told" = "$(grep -c TIMESTEP post/c.atom)" ]
report "frames: told $told" $? out
# What would happen in the steps that are tried is not told.
sed 's/boundary p p p/boundary f f f/; s/^velocity.*/velocity all set 0 0 1e4/; /^pair_/d; /^dump/d; /^fix [pth]/d; /^restart/d' in.price >in.leaving
"$TSIM" -explain -in in.leaving >leaving 2>&1
grep -q '^duration' leaving && ! grep -q 'left the box' leaving
report 'no warnings of trial steps' $? leaving
near 'post/p.txt' post/p.txt
near 'post/t.txt' post/t.txt
near 'post/a.restart' post/a.restart post/b.restart
finish
