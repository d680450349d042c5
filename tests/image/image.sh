#!/bin/bash
# dump image: pixels at known places, colours, sizes, bonds across periodic faces, words, threads, restart, and what is
# refused.
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_pictures.sh" || exit 99

# Seen from above a unit is 20 pixels at zoom 2: the box has the edges 0..10, the picture 200 x 200 pixels. Light from all
# sides only, so that colours are exact.
base='units lj
atom_style sphere
boundary p p p
region box block 0 10 0 10 0 10
create_box 3 box
create_atoms 1 single 2.5 2.5 5 units box
create_atoms 2 single 7.5 2.5 5 units box
create_atoms 3 single 7.5 7.5 5 units box
set type * diameter 2 density 1'
above='view 0 0 up 0 1 0 zoom 2 size 200 200 box no shiny 0'
flat='lights 1 0 0 0'

prints "$base
write_dump all image a.ppm type diameter $above modify $flat"
is 'type 1 is red' a.ppm 50 149 '255 0 0'
is 'type 2 is forestgreen' a.ppm 150 149 '34 139 34'
is 'type 3 is blue' a.ppm 150 50 '0 0 255'
is 'background' a.ppm 50 50 '0 0 0'
is 'edge of the sphere, inside' a.ppm 31 149 '255 0 0'
is 'edge of the sphere, outside' a.ppm 29 149 '0 0 0'

prints "$base
write_dump all image a.ppm x type $above modify $flat adiam 1 0.5 adiam 2* 4 backcolor white boxcolor red color mud 0.5 0.25 0 &
	amap 2.5 7.5 ca 0 3 min mud 5 lime max blue"
is 'amap: lower end' a.ppm 50 149 '128 64 0'
is 'amap: upper end' a.ppm 150 50 '0 0 255'
is 'adiam 0.5' a.ppm 57 149 '255 255 255'
is 'adiam 4' a.ppm 188 149 '0 0 255'

# a quantity as diameter; thresh, region, group; element
prints "$base
variable d atom 3*(id==2)
region left block 0 5 INF INF INF INF units box
write_dump all image a.ppm type v_d $above modify $flat
write_dump all image b.ppm element diameter $above modify $flat element Fe Cu Fe thresh id > 1
write_dump all image c.ppm type diameter $above modify $flat region left
write_dump all image d.ppm type diameter $above adiam 1 atom no modify $flat
write_dump all image e.ppm type type adiam 1 $above modify $flat acolor * gold/0x102030"
is 'diameter 0 is not drawn' a.ppm 50 149 '0 0 0'
is 'diameter 3' a.ppm 177 149 '34 139 34'
is 'thresh' b.ppm 50 149 '0 0 0'
is 'one colour for an element' b.ppm 150 50 '255 0 0'
is 'within the region' c.ppm 50 149 '255 0 0'
is 'outside of the region' c.ppm 150 149 '0 0 0'
is 'atom no' d.ppm 50 149 '0 0 0'
is 'acolor, the first' e.ppm 50 149 '255 215 0'
is 'acolor, the second' e.ppm 150 149 '16 32 48'

# a bond across a periodic face: one half at each face, nothing between; the box
bonded="${base/create_box 3 box/create_box 3 box bond/types 1 extra/bond/per/atom 2}
set type 3 x 9.5 y 2.5
bond_style contact
bond_coeff 1 stiffness 1 ultimate 1
create_bonds single/bond 1 1 3"
prints "$bonded
write_dump all image a.ppm type diameter $above atom no bond atom 1 modify $flat
write_dump all image b.ppm type diameter $above atom no bond type type modify $flat bcolor 1 cyan bdiam 1 0.5
write_dump all image c.ppm type diameter ${above/box no/box yes 0.1} bond strain atom modify $flat bmap -1 1 ca 0 2 min black max white"
is 'half at the left face' a.ppm 20 149 '255 0 0'
is 'half at the right face' a.ppm 195 149 '0 0 255'
is 'nothing between' a.ppm 100 149 '0 0 0'
is 'bond beside' a.ppm 20 160 '0 0 0'
is 'bcolor' b.ppm 20 149 '0 255 255'
is 'bdiam' b.ppm 20 156 '0 0 0'
is 'box' c.ppm 100 0 '255 215 0'

# a mesh, a height field and a wall, opaque and transparent, colored by a value; light from all sides
cat >plate.stl <<'END'
solid plate
facet normal 0 0 1
outer loop
vertex 0 0 5
vertex 5 0 5
vertex 0 5 5
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 5 0 5
vertex 5 5 5
vertex 0 5 5
endloop
endfacet
endsolid plate
END
surfaces='units lj
atom_style sphere
boundary f f f
region box block 0 10 0 10 0 10
create_box 1 box
fix m1 all property/global youngsModulus peratomtype 1e3
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 .5
fix m4 all property/global coefficientFriction peratomtypepair 1 .5
pair_style gran model hertz
pair_coeff * *
variable xx internal 0
variable h equal v_xx
fix plate all mesh/surface/stress file plate.stl type 1
fix slope all surface/voxel formula v_h x xx cells 10 10 type 1
fix side all wall/gran model hertz primitive type 1 xplane 9
fix lid all wall/gran model hertz primitive type 1 zplane 9'
prints "$surfaces
write_dump all image a.ppm type type $above mesh plate color blue modify $flat
write_dump all image b.ppm type type $above mesh all color 0xff0000 trans 0.5 wall lid color blue trans 0.5 modify $flat
write_dump all image c.ppm type type $above voxel slope value height modify $flat smap 0 10 ca 0 2 min black max white
write_dump all image d.ppm type type $above mesh plate value f_plate[1] modify $flat
write_dump all image e.ppm type type ${above/view 0 0 up 0 1 0/view 90 0 up 0 0 1} wall side color lime modify $flat"
is 'mesh' a.ppm 30 170 '0 0 255'
is 'beside the mesh' a.ppm 130 170 '0 0 0'
is 'half of red behind half of blue' b.ppm 30 170 '64 0 128'
is 'half of blue alone' b.ppm 130 170 '0 0 128'
is 'height 8.5 of 10' c.ppm 170 100 '217 217 217'
is 'height 0.5 of 10' c.ppm 10 100 '13 13 13'
is 'all triangles the same' d.ppm 30 170 '0 0 255'
is 'wall at half of its color' e.ppm 100 100 '0 77 0'
prints "$surfaces
write_dump all image f.ppm type type $above mesh plate value id modify $flat smap 0 2 gray
write_dump all image g.ppm type type $above mesh plate value stresscomponents modify $flat smap 0 1 gray backcolor red"
near 'the second triangle' f.ppm 80 120 '128 128 128'
is 'a mesh without load' g.ppm 20 180 '0 0 0'
rejects "$surfaces
write_dump all image a.png type type mesh plat" 'plat'
rejects "$surfaces
write_dump all image a.png type type wall slope" 'no wall'
rejects "$surfaces
write_dump all image a.png type type voxel slope value f_plate[1]" 'has 2 rows'
rejects "$surfaces
write_dump all image a.png type type mesh plate value wear" 'has no value'
rejects "$surfaces
write_dump all image a.png type type mesh all value f_plate[1]" 'name this in place of all'

# a legend: bar from the least to the largest value, with a frame
prints "$base
write_dump all image a.ppm x diameter $above legend yes modify $flat
write_dump all image b.ppm type diameter $above legend yes modify $flat
write_dump all image c.ppm x diameter $above legend yes 'a long title that does not fit in' modify $flat backcolor white"
is 'upper end' a.ppm 150 40 '255 0 0'
is 'lower end' a.ppm 150 159 '0 0 255'
is 'frame' a.ppm 143 100 '255 255 255'
is 'no legend of types' b.ppm 143 100 '0 0 0'
is 'dark letters on a light ground' c.ppm 143 100 '0 0 0'

# PNG: the same pixels as PPM
if has ffmpeg; then
	prints "$base
write_dump all image same.ppm x diameter size 61 47 fsaa yes modify backcolor white backcolor2 navy
write_dump all image same.png x diameter size 61 47 fsaa yes modify backcolor white backcolor2 navy"
	ffmpeg -loglevel error -y -i same.png -pix_fmt rgb24 -f rawvideo same.raw </dev/null
	tail -c $((3 * 61 * 47)) same.ppm >same.pixels
	same 'PNG and PPM' same.pixels same.raw

	# a movie has all frames; it is there after undump, and at the end of the script
	prints "$base
fix 1 all nve/sphere
timestep 1e-3
dump 1 all movie 2 one.mp4 type diameter size 64 48
dump_modify 1 framerate 10 bitrate 500
dump 2 all movie 5 two.mkv type diameter size 33 21
run 10
undump 1
shell mv one.mp4 moved.mp4
run 10"
	for film in 'moved.mp4 6 64 48' 'two.mkv 5 34 22'; do
		read -r file frames width height <<<"$film"
		ffmpeg -loglevel error -y -i "$file" -pix_fmt rgb24 -f rawvideo -vsync 0 film.raw </dev/null
		bytes=$(wc -c <film.raw)
		[ "$bytes" = $((3 * frames * width * height)) ]
		report "$file has $bytes bytes" $?
	done

	# after a restart the first movie is kept, and the frames that follow are in a second one
	prints "$base
fix 1 all nve/sphere
timestep 1e-3
dump 1 all movie 5 film.mp4 type diameter size 64 48
run 20
write_restart film.restart"
	cp film.mp4 first.mp4
	prints 'read_restart film.restart
fix 1 all nve/sphere
timestep 1e-3
dump 1 all movie 5 film.mp4 type diameter size 64 48
run 10' "*goes on from this restart file in 'film.25.mp4'"
	same 'the first movie' first.mp4 film.mp4
	ffmpeg -loglevel error -y -i film.25.mp4 -pix_fmt rgb24 -f rawvideo -vsync 0 film.raw </dev/null
	bytes=$(wc -c <film.raw)
	[ "$bytes" = $((3 * 2 * 64 * 48)) ]
	report "the second movie has $bytes bytes" $?
fi
rejects "$base
dump 1 all movie 1 film.txt type type" 'must end in .mp4'
printf '%s\n' "$base" 'dump 1 all movie 1 film.mp4 type type' >in.script
PATH=/nowhere "$TSIM" -in in.script -log none >out 2>&1
shows 'dump image writes the frames' out
report 'no ffmpeg' $? out

# frames of a run on one and on three threads, and after a restart
cat >in.whole <<END
$base
pair_style gran model hertz
fix m1 all property/global youngsModulus peratomtype 1e3 1e3 1e3
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 3 .5 .5 .5 .5 .5 .5 .5 .5 .5
fix m4 all property/global coefficientFriction peratomtypepair 3 .5 .5 .5 .5 .5 .5 .5 .5 .5
pair_coeff * *
velocity all set 1 0.3 0.2
fix 1 all nve/sphere
timestep 1e-3
variable turn equal 30+step/10
dump film all image 100 whole.*.png vx diameter view 60 v_turn fsaa yes ssao yes 7 0.5 size 120 90
dump_modify film pad 4 first yes
run 200
write_restart mid.restart
run 200
END
"$TSIM" -in in.whole -log none >out 2>&1
report 'frames' $? out
names=$(echo whole.*.png)
[ "$names" = 'whole.0000.png whole.0100.png whole.0200.png whole.0300.png whole.0400.png' ]
report "names: $names" $?
mkdir whole && mv whole.*.png whole
OMP_NUM_THREADS=3 "$TSIM" -in in.whole -log none >out 2>&1
for step in 0000 0200 0400; do same "three threads, $step" whole.$step.png whole/whole.$step.png; done
rm whole.*.png
{
	echo read_restart mid.restart
	sed -n '/^pair_style/,/^pair_coeff/p; /^fix 1/,/^dump_modify/p' in.whole
	echo run 200
} >in.again
"$TSIM" -in in.again -log none >out 2>&1
report 'after a restart' $? out
for step in 0300 0400; do same "restart, $step" whole.$step.png whole/whole.$step.png; done
"$TSIM" -in in.whole -log none -check >out 2>&1
report '-check' $? out
ls whole.0000.png >/dev/null 2>&1 && report '-check writes nothing' 1

# The scale of a view without variables is that of the box at the definition; others follow the box.
prints "$base
fix 1 all nve/sphere
timestep 1e-3
variable one equal 1
dump 1 all image 1 fixed.*.ppm type type size 80 80 box no
dump 2 all image 1 follows.*.ppm type type zoom v_one size 80 80 box no
run 0
change_box all x delta -5 5 units box
run 1" '*'
same 'a fixed view of a larger box' fixed.0.ppm fixed.1.ppm
cmp -s follows.0.ppm fixed.0.ppm && ! cmp -s follows.0.ppm follows.1.ppm
report 'a view with a variable of a larger box' $?

# a view that variables make impossible leaves out the picture, not the run; a file without `*`
prints "$base
fix 1 all nve/sphere
timestep 1e-3
variable z equal 2-step
dump 1 all image 1 zoom.*.ppm type type zoom v_z size 20 20
dump 2 all image 1 same.ppm type type size 20 20
run 3" '*no picture at step 2' '*each picture replaces the one before'
[ -s zoom.1.ppm ] && [ ! -e zoom.2.ppm ]
report 'zoom 0' $?
prints "$base
fix 1 all nve/sphere
timestep 1e-3
dump 1 all image 1 many.*.ppm type radius size 4 4
variable one equal 1
fix h all halt 1 v_one > 0 error continue
run 200000" '*this run writes 200000 pictures' '*drawn at half of their size'
prints "$base
group none empty
write_dump none image a.png type type size 20 20"

rejects "$base
dump 1 all image 1 a.*.jpg type type" 'name it .png'
rejects "$base
dump 1 all image 1 a.*.bmp type type" 'must end in .png or .ppm'
rejects "$base
dump 1 all image 1 a.*.png tpye type" 'type'
rejects "$base
dump 1 all image 1 a.*.png type type size 0 20" 'width'
rejects "$base
dump 1 all image 1 a.*.png type type size 1000000 20" 'width'
rejects "$base
dump 1 all image 1 a.*.png type type size 16384 16384 fsaa yes" 'choose a smaller size'
rejects "$base
dump 1 all image 1 a.*.png type type zoom 0" 'zoom'
rejects "$base
dump 1 all image 1 a.*.png type type view 190 0" 'from 0 to 180'
rejects "$base
dump 1 all image 1 a.*.png type type view 0 0" 'parallel to the view'
rejects "$base
dump 1 all image 1 a.*.png type type persp 0.5" 'projection is parallel'
rejects "$base
dump 1 all image 1 a.*.png type type zoom v_missing
run 0" 'missing'
rejects "$base
dump 1 all image 1 a.*.png type type bond atom -1" 'length > 0'
rejects "$base
write_dump all image a.png type type modify acolor 1 rde" "did you mean 'red'"
rejects "$base
write_dump all image a.png type type modify acolor 7 red" 'beyond the last type'
rejects "$base
write_dump all image a.png type type modify acolor 1 red blue" "unexpected 'blue'"
rejects "$base
write_dump all image a.png type type modify amap min max cf 0 2 0.1 red max blue" 'begins with min'
rejects "$base
write_dump all image a.png type type modify amap min max cf 0 3 min red max blue" '3 entries of 2 words'
rejects "$base
write_dump all custom a.dump id modify acolor 1 red" 'is for pictures'

# A coarse sphere of triangles, smooth, is shaded as the sphere: the difference is a fraction of that of flat triangles, and a
# cube keeps its edges
cat >in.smooth <<'E'
units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
set group all diameter 1.6 density 1000
mesh_primitive ball.stl sphere radius 0.8 segments 24
mesh_primitive cube.stl box -0.5 0.5 -0.5 0.5 -0.5 0.5
fix b all mesh/surface file ball.stl type 1
fix c all mesh/surface file cube.stl type 1
write_dump all image sphere.ppm type diameter box no size 200 200 zoom 1.5 shiny 0 modify acolor 1 silver
write_dump all image flat.ppm type diameter atom no mesh b color silver box no size 200 200 zoom 1.5 shiny 0
write_dump all image smooth.ppm type diameter atom no mesh b color silver smooth 60 box no size 200 200 zoom 1.5 shiny 0
write_dump all image cube.ppm type diameter atom no mesh c color silver box no size 200 200 zoom 1.5 shiny 0
write_dump all image sharp.ppm type diameter atom no mesh c color silver smooth 60 box no size 200 200 zoom 1.5 shiny 0
write_dump all image round.ppm type diameter atom no mesh c color silver smooth 100 box no size 200 200 zoom 1.5 shiny 0
E
"$TSIM" -in in.smooth -log none >out 2>&1
report 'smooth meshes' $? out
same 'edges of a cube' cube.ppm sharp.ppm
[ -s cube.ppm ] && [ -s round.ppm ] && ! cmp -s cube.ppm round.ppm
report 'edges that are smoothed' $?
for picture in sphere flat smooth; do tail -c +16 $picture.ppm | od -An -v -w3 -tu1 | awk '{ print $1 }' >$picture.red; done
paste sphere.red flat.red smooth.red | awk '$1 > 0 && $2 > 0 && $3 > 0 { n++; flat += ($2 - $1)^2; smooth += ($3 - $1)^2 }
	END { print n, sqrt(flat / n), sqrt(smooth / n); exit !(n > 5000 && smooth < flat / 16) }' >out
report 'shaded as a sphere' $? out
rejects "$(sed '/^write/d' in.smooth)
write_dump all image a.ppm type diameter voxel all smooth 10" 'smooth is for meshes'
finish
