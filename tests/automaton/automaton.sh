#!/bin/bash
# automaton_style granular in scripts: refusals, other units, a change of the time step, restart, pictures, the example.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# scene WORDS...: a lattice of 40 x 8 cells of 0.1; later words of the style after the usual ones
scene() {
	cat <<END
units si
dimension ${dimension-2}
boundary ${boundary-p f p}
region box block 0 ${length-4} 0 ${height-0.8} -0.5 0.5 units box
create_box 1 box
region all block -1 9 -1 9 -1 1 units box
region one block 0 0.19 0 0.1 -1 1 units box
timestep ${dt-0.05}
automaton_style granular cell ${cell-0.1} fill ${fill-0.7} restitution ${ep-0.85} wall_restitution ${ew-0.65} roughness ${R-0.5} lower ${U-2} seed ${seed-3} $*
END
}
refuses() { # TEXT SCRIPT
	rejects "$2" "$1"
	refused "-check: $1" "$1" -check -in in.script
}
refuses 'fill 1.2 would be 384 granules in 320 cells, which hold one each' "$(fill=1.2 scene)"
refuses "fill 0.001 of 320 cells is not one granule" "$(fill=0.001 scene)"
refuses 'fill is -0.5, expected a number > 0' "$(fill=-0.5 scene)"
refuses 'restitution is 1.2, expected a number from 0 to 1' "$(ep=1.2 scene)"
refuses 'wall_restitution is -0.1, expected a number from 0 to 1' "$(ew=-0.1 scene)"
refuses 'roughness is 2, expected a number from 0 to 1' "$(R=2 scene)"
refuses 'seed is -3, expected a number > 0' "$(seed=-3 scene)"
refuses 'the box has 1 cell along y; expected at least 2' "$(height=0.1 scene)"
refuses 'the box has 8.5 cells along y; expected a whole number' "$(height=0.85 scene)"
refuses 'the box has 2 cells along x; expected at least 3' "$(length=0.2 scene)"
refuses 'the obstacles fill all cells' "$(scene obstacles all)"
refuses "expected \`dimension 2\`" "$(dimension=3 scene)"
refuses "expected \`boundary p f p\`" "$(boundary='f f p' scene)"
refuses "order blocks\` needs 16 cells along x, the box has 4" "$(length=0.4 scene order blocks)"
refuses "cells are too many" "$(cell=1e-5 scene)"
refuses 'the speed 2 is 2 cells a step; granules move by at most one: expected a timestep of at most 0.05' "$(dt=0.1 scene)
run 1"
refuses 'less than the smallest one, 1/8192' "$(scene start 1e-6)
run 1"
refuses 'all granules are at rest' "$(scene start 0)
run 1"
refuses 'all granules are at rest' "$(U=0 scene)
run 1"
refuses 'needs an automaton: use automaton_style before it' "$(scene | sed '$d')
compute p all automaton/profile"
refuses 'must end in .png' "$(scene)
dump d all automaton/png 1 frame*.jpg"
refuses 'must end in .vti' "$(scene)
dump d all automaton/vtk 1 frame*.vtk"
refuses "unknown automaton style 'granula'" "$(scene | sed 's/granular/granula/')"
refuses 'the box has changed from 40 x 8 to 50 x 8 cells' "$(scene)
change_box all x final 0 5
run 1"

refuses 'the lattice of the automaton (automaton_style, line 9) does not change with the box' "$(scene)
fix f all deform 1 x erate 0.1
run 1"

# results of the same scene in units a million times as large or small are the same
small() {
	prints "$(scene)
compute p all automaton/profile
run 200
print \"is \$(c_p[1]:%.9f) \$(c_p[3][2]:%.9f) \$(c_p[8][5]:%.9f) \$(c_p)\"" "$(grep '^is' known)"
}
printf '%s\n' "$(scene)" 'compute p all automaton/profile' 'run 200' \
	'print "is $(c_p[1]:%.9f) $(c_p[3][2]:%.9f) $(c_p[8][5]:%.9f) $(c_p)"' >in.known
"$TSIM" -in in.known -log none >known 2>&1
report 'a scene' $? known
[ "$(awk '/^is/ { print $5 }' known)" = 224 ]
report 'granules' $? known
length=4e6 height=0.8e6 cell=1e5 U=2 dt=0.05e6 small
length=4e-6 height=0.8e-6 cell=1e-7 U=2 dt=0.05e-6 small

# a style that begins anew, and one that ends
prints "$(scene)
run 10
$(scene | tail -n 1)
compute p all automaton/profile
run 0
print \"granules \$(c_p), moved \$(c_p[4])\"" 'granules 224, moved 0'
prints "$(scene)
run 3
automaton_style none
run 3
print done" done

# averages of rows are read before the first sample
prints "$(scene)
compute p all automaton/profile
fix a all ave/time 1 10 10 c_p[*] mode vector
thermo_style custom step f_a[8][1]
run 5
print \"row \$(c_p[8][1]) \$(f_a[8][1])\"
run 5
print \"row \$(f_a[8][1])\"" 'row 0.75 0' 'row 0.75'
# half the time step: velocities are the same at once
prints "$(scene)
compute p all automaton/profile
run 100
variable u once c_p[1]
timestep 0.025
run 1
print \"step \$(abs(c_p[1]-v_u)<0.3)\"" 'step 1'

# whole, and in two parts with a restart file; the second part with threads
for order in exact blocks; do
	{
		scene order $order obstacles one
		echo 'compute p all automaton/profile'
	} >in.scene
	finish_it='variable y loop 8
label next
print "row $(c_p[v_y][2]:%.17g) $(c_p[v_y][3]:%.17g) $(c_p[v_y][4]:%.17g) $(c_p[v_y][5]:%.17g)"
next y
jump SELF next
print "row $(c_p[3]:%.17g) $(c_p[4]:%.17g) $(c_p[5]:%.17g) $(c_p[6]:%.17g)"'
	printf '%s\n' 'include in.scene' 'run 97' "$finish_it" >in.whole
	printf '%s\n' 'include in.scene' 'run 41' 'write_restart part.restart' >in.one
	{
		printf 'package omp 3 grain 1\nread_restart part.restart\n'
		sed '/^create_box/d; /^units/d; /^dimension/d; /^boundary/d; /^region box/d; /^timestep/d' in.scene
		printf '%s\n' 'run 56' "$finish_it"
	} >in.two
	for part in whole one two; do
		"$TSIM" -in in.$part -log none >$part.out 2>&1
		report "$order: $part" $? $part.out
		grep '^row' $part.out >$part.rows
	done
	same "$order: continued" whole.rows two.rows
	# the obstacles of the restart file stay, whatever the script has
	prints "read_restart part.restart
$(scene order $order | tail -n 1)
compute p all automaton/profile
run 20
variable n equal 38*c_p[1][4]
print \"granules \$(c_p), cells \$(abs(v_n-round(v_n))<1e-9)\"" 'granules 223, cells 1'
done

# an automaton has no id to change: the refusal names what can be done
scene order blocks | sed '/^units/d; /^dimension/d; /^boundary/d; /^region box/d; /^create_box/d; /^timestep/d' >changed
refuses_text() {
	printf 'read_restart part.restart\n%s\nrun 1\n' "$(sed 's/cell 0.1/cell 0.2/' changed)" >in.changed
	"$TSIM" -in in.changed -log none >out 2>&1
	grep -q 'or start without a restart file' out && ! grep -q 'another id' out
}
refuses_text
report 'a changed argument: what to do' $? out

# a picture, read back: size, and the colours of wall, empty cell and granule
if has python3; then
	printf '%s\n' "$(scene)" 'dump d all automaton/png 5 frame*.png scale 3' 'dump v all automaton/vtk 5 frame*.vti' \
		'run 5' >in.pictures
	"$TSIM" -log none -in in.pictures >out 2>&1
	report 'pictures' $? out
	python3 - frame5.png >read 2>&1 <<'END'
import struct, sys, zlib
data = open(sys.argv[1], 'rb').read()
assert data[:8] == b'\x89PNG\r\n\x1a\n'
at, parts = 8, {}
while at < len(data):
    n, = struct.unpack('>I', data[at:at + 4])
    kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + n]
    assert struct.unpack('>I', data[at + 8 + n:at + 12 + n])[0] == zlib.crc32(kind + body), kind
    parts[kind] = body
    at += 12 + n
width, height = struct.unpack('>II', parts[b'IHDR'][:8])
assert (width, height) == (120, 30) and b'IEND' in parts
packed = zlib.decompress(parts[b'IDAT'])

def predict(kind, a, b, c):
    p = a + b - c
    return [0, a, b, (a + b) // 2, min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]][kind]

rows, above = [], [0] * 363
for y in range(height):
    kind, row = packed[361 * y], [0] * 3
    for k in range(360):
        row.append((packed[361 * y + 1 + k] + predict(kind, row[k], above[3 + k], above[k])) % 256)
    rows.append(row)
    above = row
pixel = lambda x, y: tuple(rows[y][3 + 3 * x:6 + 3 * x])
assert pixel(1, 1) == pixel(1, 28) == (90, 90, 90)
cells = [pixel(3 * i + 1, 3 * j + 1) for i in range(40) for j in range(1, 9)]
assert sum(c != (255, 255, 255) for c in cells) == 224
END
	report 'a picture' $? read
	[ -s frame5.vti ] && grep -q 'WholeExtent="0 40 0 8 0 1"' frame5.vti
	report 'a VTK file' $? out
fi

# a movie: a script stands for ffmpeg and keeps the pixels, 120 x 30 of each frame
mkdir bin && cat >bin/ffmpeg <<'END'
#!/bin/sh
for file; do :; done
cat >"${file#file:}"
[ ! -e full ] || { echo No space left on device >&2; exit 1; }
END
chmod +x bin/ffmpeg
filmed="$(scene)
dump d all automaton/png 5 movie/f*.png scale 3 movie movie/film.mkv
run 20"
with_ffmpeg() { PATH=$PWD/bin:$PATH "$TSIM" "$@" >out 2>&1; }
has_files() { [ "$(find movie -type f | wc -l)" = "$1" ]; }
printf '%s\n' "$filmed" >in.movie
with_ffmpeg -log none -in in.movie && [ "$(wc -c <movie/film.mkv)" = $((5 * 3 * 120 * 30)) ] && has_files 6
report 'a movie' $? out
rm -r movie
with_ffmpeg -log none -explain -in in.movie && [ ! -e movie ] && ! grep -q 'warning: dump' out
report 'a movie: -explain' $? out
printf '%s\n' "$filmed" 'undump d' 'shell mv movie/film.mkv movie/one.mkv' 'run 1' >in.undump
with_ffmpeg -log none -in in.undump && [ -s movie/one.mkv ]
report 'a movie: complete after undump' $? out
touch full
rm -r movie
with_ffmpeg -log none -in in.movie
[ $? = 1 ] && grep -q "film.mkv': ffmpeg failed after 5 frames with exit status 1: No space left" out && has_files 5
report 'a movie: the disk is full' $? out
printf '%s\n' "$filmed" 'clear' 'print never' >in.clear
with_ffmpeg -log none -in in.clear
[ $? = 1 ] && grep -q '^in.clear:10:.*ffmpeg failed after 5' out && ! grep -q '^never' out
report 'a movie: the disk is full at clear' $? out
rm -r movie full
(PATH=$PWD/none && "$TSIM" -log none -in in.movie) >out 2>&1
[ $? = 0 ] && grep -q 'there will be frames, but no movie .*not on the PATH' out && has_files 5
report 'a movie: no ffmpeg' $? out
if command -v ffmpeg >/dev/null; then
	"$TSIM" -log none -in in.movie >out 2>&1 &&
		ffmpeg -v error -i movie/film.mkv -f rawvideo -pix_fmt rgb24 - >pixels 2>>out </dev/null &&
		[ "$(wc -c <pixels)" = $((5 * 3 * 120 * 30)) ] &&
		[ "$(od -An -tu1 -N 3 pixels | awk '{ print ($1 > 75 && $1 < 105) }')" = 1 ]
	report 'a movie by ffmpeg itself, read back' $? out
fi
refuses "movie 'f.txt': expected a name that ends in .mp4" "$(scene)
dump d all automaton/png 5 f*.png movie f.txt"

# -explain says what it is, and what it costs
printf '%s\n' "$(scene)" 'run 1000' >in.explain
"$TSIM" -log none -explain -in in.explain >out 2>&1
shows '40 x 8 cells, 224 granules, fastest 1 cells a step, order exact' out && shows 'left out by its rules' out && shows 'duration: about' out
report '-explain' $? out

cp -r "$top_srcdir/examples/film" . && cd film || exit 99
"$TSIM" -check -log none -in in.film >out 2>&1
report 'example: -check' $? out
"$TSIM" -in in.film -log none -var seeds 3 -var steps 4000 >out 2>&1 && [ "$(grep -c '^RESULT .* ok$' out)" = 3 ]
report 'example: results' $? out
awk '!/^#/ { n++; if ($1 != (n - 0.5)/10 || !($5 > 0)) bad = 1 } END { exit bad || n != 10 }' post/profile_automaton.txt
report 'example: profile' $? post/profile_automaton.txt
"$TSIM" -in in.automaton -log none -var seeds 2 -var steps 2000 >out 2>&1 && [ "$(grep -c '^RESULT .* ok$' out)" = 6 ]
report 'example: slip falls as the roughness grows' $? out
finish
