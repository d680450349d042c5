#!/bin/bash
# Heights of fields: text, images, formulas, random surfaces, datum and base; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A box of 4 x 3 x 5, and heights as `dump voxel/vtk` writes them
cat >in.box <<'END'
units si
boundary f f f
region box block 0 4 0 3 0 5 units box
create_box 1 box
variable cx internal 0
variable cy internal 0
variable cz internal 0
END
# heights FIELD...: writes the heights to `heights`
heights() {
	rm -f top.*.vtk
	printf '%s\n' 'include in.box' "${before-}" "fix s all surface/voxel $1" 'dump d all voxel/vtk 1 top.*.vtk s' \
		'timestep 1e-6' 'run 0' >in.script
	"$TSIM" -in in.script -log none >out 2>&1
	report "$1" $? out
	sed '1,/^height 1/d' top.0.vtk >heights
}
# gives FIELD HEIGHTS...: in the order of columns
gives() {
	local field=$1
	shift
	heights "$field"
	printf '%s\n' "$@" >expected
	same "$field" expected heights
}
gives 'constant 1.5 type 1 cells 2 3' 1.5 1.5 1.5 1.5 1.5 1.5
before='variable h equal v_cx+100*v_cy'
gives 'formula v_h x cx y cy type 1 cells 2 3' 51 53 151 153 251 253
gives 'formula v_h x cx y cy type 1 cells 2 3 datum 152' 152 152 152 153 251 253
gives 'formula v_h x cx y cy type 1 cells 2 3 datum 152 base 152' 153 251 253
gives 'formula v_h x cx y cy type 1 cells 2 1 origin 10 20 size 2 4' 2210.5 2211.5
before='variable h equal v_cy+100*v_cz'
gives 'formula v_h y cy z cz type 1 cells 2 1 normal x' 250.75 252.25
before='variable a equal v_cx+1
variable h equal v_a*v_a+100*v_cy'
gives 'formula v_h x cx y cy type 1 cells 2 3' 54 66 154 166 254 266
# formulas that are evaluated row by row: the coordinate is an index; random numbers
before='variable l vector [10,20,30,40]
variable h equal v_l[round(v_cx)]+v_cy'
gives 'formula v_h x cx y cy type 1 cells 2 1' 11.5 31.5
before='variable h equal random(0,1,7)'
heights 'formula v_h type 1 cells 40 30'
[ "$(sort -u heights | wc -l)" = 1200 ]
report 'a random number for each column' $?
before='variable h equal v_cx+100*v_cy'
heights 'formula v_h x cx y cy type 1 cells 64 48'
awk 'BEGIN { for (k = 0; k < 3072; k++) print (k % 64 + 0.5)/16 + 100*(int(k/64) + 0.5)/16 }' | awk '{ print $1 + 0 }' >expected
awk '{ print $1 + 0 }' heights | diff - expected >difference
report 'many columns' $? difference
before='variable h equal 2'
gives 'formula v_h type 1 cells 1 1' 2
gives 'formula 7 type 1 cells 1 1' 7
before=
awk '/^POLYGONS/ { exit } on { print } /^POINTS 4 double/ { on = 1 }' top.0.vtk >points
printf '%s\n' '0 0 7' '4 0 7' '4 3 7' '0 3 7' >expected
same 'the corners of a column' expected points

# Text: the first line is the row of the largest y
printf '# heights\n5 6.5\n\n3 4 # middle\n1 2e1\n' >matrix
gives 'file matrix type 1' 1 20 3 4 5 6.5
gives 'file matrix type 1 cells 2 3 scale 2 datum 5' 5 40 6 8 10 13
gzip -k matrix
gives 'file matrix.gz type 1' 1 20 3 4 5 6.5

# The same image, 2 x 3, in all forms
printf 'P2 # grey\n# made by hand\n2 3\n250\n0 250\n25 50\n100 125' >plain.pgm
image='black -1 white 9 type 1'
set -- 3 4 0 1 -1 9
gives "image plain.pgm $image" "$@"
gives "image plain.pgm $image cells 2 3" "$@"
{ printf 'P5\n2 3\n250\n'; printf '\000\372\031\062\144\175'; } >raw.pgm
gives "image raw.pgm $image" "$@"
{ printf 'P5 2 3 25000\n'; printf '\000\000\141\250\011\304\023\210\047\020\060\324'; } >wide.pgm
gives "image wide.pgm $image" "$@"
if has python3 && "$TSIM" -help fix surface/voxel >/dev/null; then
	python3 - <<'END'
import struct, zlib

def png(name, kind, depth, rows, interlace=0, cut=0):
    def chunk(tag, data):
        return struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))
    width = {0: 2, 2: 2, 4: 2}[kind]
    head = struct.pack(">IIBBBBB", width, len(rows), depth, kind, 0, 0, interlace)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + \
        chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))) + chunk(b"IEND", b"")
    open(name, "wb").write(data[:len(data) - cut])

grey = [(0, 255), (51, 102), (153, 204)]
png("grey.png", 0, 8, [bytes(row) for row in grey])
png("wide.png", 0, 16, [struct.pack(">HH", *(257 * v for v in row)) for row in grey])
png("alpha.png", 4, 8, [bytes((a, 7, b, 9)) for a, b in grey])
png("bits.png", 0, 1, [b"\x40", b"\x80", b"\xc0"])
png("colour.png", 2, 8, [bytes((a, a, a, b, b, b)) for a, b in grey])
png("short.png", 0, 8, [bytes(row) for row in grey], cut=20)
damaged = bytearray(open("grey.png", "rb").read())
damaged[45] ^= 255
open("damaged.png", "wb").write(damaged)
huge = bytearray(open("grey.png", "rb").read())
huge[16:24] = struct.pack(">II", 40000, 40000)
huge[29:33] = struct.pack(">I", zlib.crc32(bytes(huge[12:29])))
open("huge.png", "wb").write(huge)
END
	printf '%s\n' 'include in.box' "fix s all surface/voxel image grey.png $image" >in.script
	if "$TSIM" -in in.script -log none >out 2>&1; then
		set -- 153 204 51 102 0 255
		gives "image grey.png black 0 white 255 type 1" "$@"
		gives "image wide.png black 0 white 255 type 1" "$@"
		gives "image alpha.png black 0 white 255 type 1" "$@"
		gives "image bits.png $image" 9 9 9 -1 -1 9
		for wrong in 'colour.png|is a colour image; expected a grey one' 'short.png|is damaged: the file ends early' \
			'damaged.png|is damaged: ' 'huge.png|bytes for 40000 x 40000 pixels'; do
			rejects "include in.box
fix s all surface/voxel image ${wrong%%|*} $image" "${wrong#*|}"
		done
	else
		shows 'built without libpng' out
		report 'PNG images are refused without libpng' $? out
	fi
fi

# Random surfaces are functions of the seed
gauss='gaussian deviation 0.25 correlation 0.5 type 1 cells 24 18 mean 2 seed'
heights "$gauss 11"
cp heights first
heights "$gauss 11"
same 'the same seed' first heights
heights "$gauss 12"
cmp -s first heights
[ $? = 1 ]
report 'another seed' $?
awk '{ s += $1; q += $1 * $1 } END { s /= NR; q = sqrt(q / NR - s * s)
	exit NR != 432 || (s - 2) ^ 2 > 1e-24 || (q - 0.25) ^ 2 > 1e-24 }' first
report 'mean and deviation' $? first
heights "$gauss 11 datum 2"
awk '{ print($1 > 2 ? $1 : 2) }' first >expected
same 'truncated with a datum' expected heights
heights 'gaussian deviation 0.25 correlation 0.9 0 type 1 cells 24 18 seed 5 exact no'
heights 'gaussian deviation 0 correlation 0.9 type 1 cells 5 3 seed 5 mean 1'
[ "$(sort -u heights)" = 1 ]
report 'a deviation of 0' $? heights

# ---- what is refused
field() {
	rejects "include in.box
${before-}
fix s all surface/voxel $1" "$2"
}
field 'constant 1 type 1' 'how many columns? `cells 100 100`'
field 'constant 1 type 1 cells 3' 'fix surface/voxel: cells'
field 'constant 1 type 1 cells 3 0' 'fix surface/voxel: cells'
field 'constant 1 type 1 cells 100000 100000' 'are too many'
field 'constant nan type 1 cells 1 1' 'height'
field 'constant 1 type 1 cells 3 3 size 1 -1' 'fix surface/voxel: size'
field 'constant 1 type 1 cells 1000 1 origin 1e14 0' 'neighbours have the same coordinate, rounded'
field 'constant 1 type 1 cells 3 3 move round 1 2 3' 'one of linear, wiggle'
field 'constant 1 type 1 cells 3 3 move wiggle 1 2 3 0' 'period'
field 'file nothing type 1' "cannot open 'nothing'"
field 'file matrix type 1 cells 3 2' "'matrix' has 2 x 3 heights, but cells are 3 x 2"
printf '1 2\n3\n' >ragged
field 'file ragged type 1' '1 heights, but the first row has 2'
printf '1 2\n3 nan\n' >nan
field 'file nan type 1' "a height is 'nan', expected a number"
printf '1 2\n3 x\n' >letter
field 'file letter type 1' 'a height'
printf '# nothing\n' >blank
field 'file blank type 1' "'blank' has no heights"
before='variable h equal 1/(v_cx-2)'
field 'formula v_h x cx type 1 cells 1 1' 'division of 1 by zero'
before='variable h equal 1/(v_cx-3)'
field 'formula v_h x cx type 1 cells 2 1' 'division of 1 by zero'
before='variable h equal sum(v_cx)'
field 'formula v_h x cx type 1 cells 2 1' 'expected a list'
before='variable h equal 1'
field 'formula v_h x nobody type 1 cells 1 1' 'nobody'
field 'formula v_nobody type 1 cells 1 1' 'nobody'
before=
field "image matrix $image" 'is no image that can be read: expected PGM (P2, P5) or PNG'
field "image nothing.pgm $image" "cannot open 'nothing.pgm'"
field 'image plain.pgm black 0 type 1' 'white'
printf 'P6\n1 1\n255\n123' >colour.ppm
field "image colour.ppm $image" 'is a colour image (P6); expected a grey one'
printf 'P5\n20 30\n255\n123' >short.pgm
field "image short.pgm $image" 'ends early'
printf 'P2\n2 3\n255\n1 2 3 4' >short.pgm
field "image short.pgm $image" 'a grey value'
printf 'P2\n2 1\n255\n1 256' >bright.pgm
field "image bright.pgm $image" 'a grey value'
printf 'P5\n2 1\n70000\n1 256' >deep.pgm
field "image deep.pgm $image" 'the largest grey value'
printf 'P5\n2000000000 2000000000\n255\n' >huge.pgm
field "image huge.pgm $image" 'ends early'
field 'gaussian deviation 1 correlation 1 1.6 type 1 cells 10 10 seed 1' 'the correlation length 1.6 is more than half of the size 3'
field 'gaussian deviation 1 correlation 1 1 1 type 1 cells 10 10 seed 1' 'correlation'
field 'gaussian deviation 1 correlation 1 type 1 cells 1 1 seed 1' 'one column has no standard deviation'
field 'gaussian deviation -1 correlation 1 type 1 cells 9 9 seed 1' 'deviation'
sed -i 's/f f f/p p p/' in.box
field 'constant 1 type 1 cells 3 3' 'the box is periodic along z, the axis of the heights, and the columns have no bottom'
field 'constant 1 type 1 cells 3 3 base 0 size 5 3' 'longer than the periodic box'
field 'constant 1 type 1 cells 3 3 base -99' 'the highest column is longer than the periodic box along z, 100 and'
finish
