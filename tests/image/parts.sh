#!/bin/bash
# dump image: slices of a fluid, arrows, force chains, cuts, transparent particles: which colour is at which pixel, and
# what is refused.
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_pictures.sh" || exit 99

# Seen from above a unit is 20 pixels at zoom 2: the box has the edges 0..10, the picture 200 x 200 pixels. Light from all
# sides only, so that colours are exact.
above='view 0 0 up 0 1 0 zoom 2 size 200 200 box no shiny 0'
flat='lights 1 0 0 0'

# Plane Couette flow, u = y/10: all that is shown is linear, so that pixels have exact numbers.
couette='units lj
atom_style sphere
boundary p f p
newton off
communicate single vel yes
region box block 0 10 0 10 0 10
create_box 1 box
flow_style projection cells 8 10 4 viscosity 1 density 1
flow_boundary yhi wall velocity 1 0 0
variable yy internal 0
variable u equal v_yy/10
flow_set velocity v_u 0 0 set y yy
region rod cylinder z 4 5 2 INF INF units box
timestep 1e-3'
prints "$couette
write_dump all image a.ppm type type $above slice z 5 vx modify $flat gmap 0 1 gray
write_dump all image b.ppm type type $above slice z 5 speed trans 0.5 modify lights 0 0 1 0 backcolor red gmap 0.2 0.7 gray
write_dump all image c.ppm type type view 90 90 up 0 0 1 zoom 2 size 200 200 box no slice y 3 vx modify gmap 0 1 gray
write_dump all image d.ppm type type $above slice z 5 wz modify $flat gmap -0.2 0 gray
write_dump all image e.ppm type type $above slice z 5 none arrows 2 length 1.5 width 0.3 color lime modify $flat
write_dump all image f.ppm type type $above slice z 5 none arrows 2 factor 1 width 0.3 color lime modify $flat
write_dump all image g.ppm type type $above slice z v_yy vx modify $flat gmap 0 1 gray"
prints "$couette
write_dump all image h.ppm type type view 90 90 up 0 0 1 zoom 2 size 200 200 box no slice y 5 vx slice y 1 vx slice y 0 vx legend yes modify gmap min max gray"
near 'the range of all slices' h.ppm 100 100 '255 255 255'
near 'u at y = 2.525' a.ppm 60 149 '64 64 64'
near 'u at y = 7.575' a.ppm 120 48 '193 193 193'
near 'u beside the wall' a.ppm 10 0 '254 254 254'
near 'half of red behind a value below the range' b.ppm 100 180 '128 0 0'
near 'half of red behind a value above the range' b.ppm 100 20 '255 128 128'
near 'a plane seen from its side is not lit' c.ppm 100 100 '77 77 77'
near 'vorticity -0.1' d.ppm 100 100 '128 128 128'
# Arrows at 1, 3, 5, 7, 9: that at y = 9 ends at pixel 50, that at y = 3 at 30. Heads are half of them, 3.75 and 1.25 pixels in
# radius; shafts are a third of that. Pixels of the tip are half a pixel beside its axis.
is 'begin of the largest arrow' e.ppm 21 19 '0 255 0'
is 'its end' e.ppm 47 19 '0 255 0'
is 'beyond its end' e.ppm 48 19 '0 0 0'
is 'head beside the shaft' e.ppm 37 22 '0 255 0'
is 'beside the head' e.ppm 37 23 '0 0 0'
is 'beside the shaft' e.ppm 33 22 '0 0 0'
is 'arrow at y = 3' e.ppm 26 139 '0 255 0'
is 'beyond it' e.ppm 30 139 '0 0 0'
is 'factor: end of 0.9' f.ppm 35 19 '0 255 0'
is 'factor: beyond its end' f.ppm 38 19 '0 0 0'
near 'a variable place' g.ppm 60 149 '64 64 64'

prints "$couette
write_dump all image a.ppm type type $above slice z 5 none streams 2 color lime width 0.2 modify $flat
write_dump all image b.ppm type type $above slice z 5 none streams 0.5 color lime modify $flat"
is 'a streamline' a.ppm 150 19 '0 255 0'
is 'the next one' a.ppm 150 59 '0 255 0'
is 'nothing between' a.ppm 150 39 '0 0 0'
is 'its head' a.ppm 22 21 '0 255 0'
rejects "$couette
write_dump all image a.png type type slice z 5 none streams 1e-4" 'streamlines 0.0001 apart'

# a body: its colour inside, with a sharp edge, or nothing; no arrows in it; at a periodic face both parts
prints "${couette/cylinder z 4 5 2/cylinder z 9 5 2}
fix rod all immersed/boundary region rod velocity 0.5 0 0 min_cells 3
run 0
write_dump all image a.ppm type type $above slice z 5 vx body blue modify $flat gmap 0 1 gray
write_dump all image b.ppm type type $above slice z 5 vx body none arrows 1 color red modify $flat gmap 0 1 gray"
is 'inside of the body' a.ppm 180 99 '0 0 255'
is 'its edge, inside' a.ppm 143 99 '0 0 255'
near 'its edge, outside' a.ppm 136 99 '128 128 128'
is 'no body' b.ppm 180 99 '0 0 0'

# a scalar, and the default map from the least to the largest value
prints "$couette
fix T all flow/scalar initial 3 conductivity 0.1
run 0
write_dump all image a.ppm type type $above slice z 5 f_T modify $flat gmap 1 5 gray
write_dump all image b.ppm type type $above slice z 5 vx legend yes modify $flat backcolor white"
near 'scalar' a.ppm 100 100 '128 128 128'
near 'least' b.ppm 100 199 '0 0 255'
near 'legend' b.ppm 150 159 '0 0 255'

rejects "$couette
write_dump all image a.png type type slice z 11 vx" "outside of the fluid's grid, which goes from 0 to 10"
rejects "$couette
write_dump all image a.png type type slice z 5 sped" "did you mean 'speed'"
rejects "$couette
write_dump all image a.png type type slice w 5 vx" "'w'"
rejects "$couette
write_dump all image a.png type type slice z 5 vx arrows 1e-4" 'choose a larger distance'
rejects "$couette
write_dump all image a.png type type slice z 5 vx arrows 1 length 1 factor 1" 'not both'
rejects "$couette
write_dump all image a.png type type slice z 5 f_T" 'T'
prints "$couette
variable out equal 11+step
write_dump all image a.ppm type type $above slice z v_out vx" '*no slice at step 0: z = 11'

base='units lj
atom_style sphere
boundary p p p
region box block 0 10 0 10 0 10
create_box 3 box
create_atoms 1 single 2.5 2.5 5 units box
create_atoms 2 single 7.5 2.5 5 units box
create_atoms 3 single 7.5 7.5 5 units box
set type * diameter 2 density 1'
rejects "$base
write_dump all image a.png type type slice z 5 vx" 'fluid'

# arrows of particles
prints "$base
set type 1 vx 2
set type 2 vy -1
variable one atom 1
variable nought atom 0
write_dump all image a.ppm type diameter $above arrow vx vy vz length 4 width 0.4 modify $flat
write_dump all image b.ppm type diameter $above atom no arrow v_one v_nought v_nought factor 2 width 0.4 color white modify $flat"
is 'end of the longest' a.ppm 127 149 '255 0 0'
is 'beyond it, where no particle is yet' a.ppm 128 149 '0 0 0'
is 'the other, half as long, downwards' a.ppm 150 187 '34 139 34'
is 'beyond it' a.ppm 150 193 '0 0 0'
is 'no arrow of a particle at rest' a.ppm 180 50 '0 0 0'
is 'without the particle' b.ppm 186 50 '255 255 255'
is 'beyond it' b.ppm 193 50 '0 0 0'
rejects "$base
write_dump all image a.png type type arrow vx vy" 'Vz'
rejects "$base
write_dump all image a.png type type arrow vx vy vq" 'vq'

# contacts: the width is that of the force; across a periodic face two halves
contacts="$base
set type 1 x 0.9
set type 2 x 9.0
set type 3 x 5 y 7.5
create_atoms 3 single 6.8 7.5 5 units box
set type * diameter 2 density 1
fix m1 all property/global youngsModulus peratomtype 1e3 1e3 1e3
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 3 .5 .5 .5 .5 .5 .5 .5 .5 .5
fix m4 all property/global coefficientFriction peratomtypepair 3 .5 .5 .5 .5 .5 .5 .5 .5 .5
pair_style gran model hertz
pair_coeff * *
fix 1 all nve/sphere
compute c all pair/gran/local pos force
compute p all pair/gran/local id force
timestep 1e-6
run 0"
prints "$contacts
write_dump all image a.ppm type diameter $above atom no contact c width 1 color white modify $flat
write_dump all image b.ppm type diameter $above atom no contact c_c modify $flat
write_dump all image c.ppm type diameter $above atom no contact c factor 1e-9 modify $flat"
is 'the largest force' a.ppm 118 41 '255 255 255'
is 'beside it' a.ppm 118 38 '0 0 0'
is 'half at the left face' a.ppm 5 149 '255 255 255'
is 'half at the right face' a.ppm 195 149 '255 255 255'
is 'nothing between' a.ppm 100 149 '0 0 0'
# overlaps 0.2 and 0.1: forces by Hertz as 2^1.5 to 1, so the rod has the radius 3.54 pixels
is 'the lesser force, inside' a.ppm 5 152 '255 255 255'
is 'the lesser force, outside' a.ppm 5 154 '0 0 0'
is 'colour of the largest' b.ppm 118 49 '255 0 0'
is 'colour of the least' b.ppm 195 149 '0 0 255'
is 'too thin' c.ppm 118 49 '0 0 0'
# several keywords have one range and one width
prints "$contacts
group one id 1 2
compute d one pair/gran/local pos force
write_dump all image a.ppm type diameter $above atom no contact d width 1 contact c width 1 modify $flat"
is 'inside of the lesser force' a.ppm 5 152 '0 0 255'
is 'outside of it' a.ppm 5 154 '0 0 0'
rejects "$contacts
write_dump all image a.png type type contact p" 'has no pos'
rejects "$contacts
compute ke all ke
write_dump all image a.png type type contact ke" 'pair/gran/local'
rejects "$contacts
write_dump all image a.png type type contact d" "'d'"

# cuts: a flat face in front, half a disc from the side; box, slices and arrows are not cut
prints "$base
variable at equal 2.5
write_dump all image a.ppm type diameter $above clip x v_at below modify $flat
write_dump all image b.ppm type diameter $above clip z 4.2 below clip y 7.5 above modify $flat
write_dump all image c.ppm type diameter $above clip z 5 above modify lights 0 0 1 0
write_dump all image d.ppm type diameter ${above/box no/box yes 0.1} clip z 4.2 above modify $flat"
is 'left of the plane' a.ppm 45 149 '0 0 0'
is 'right of it' a.ppm 55 149 '255 0 0'
is 'beyond the plane' a.ppm 150 50 '0 0 255'
is 'above y = 7.5' b.ppm 150 45 '0 0 0'
is 'below y = 7.5' b.ppm 150 55 '0 0 255'
is 'a face, lit at 30 degrees' c.ppm 50 149 '221 0 0'
is 'all of it' c.ppm 62 149 '221 0 0'
is 'a smaller face: z 0.8 below the middle, radius 0.6' d.ppm 63 149 '0 0 0'
is 'within it' d.ppm 60 149 '255 0 0'
is 'the box' d.ppm 100 0 '255 215 0'
rejects "$base
write_dump all image a.png type type clip x 5 beyond" 'above'
rejects "$base
write_dump all image a.png type type $(for k in 1 2 3 4 5 6 7; do echo "clip x $k above"; done | xargs)" 'more than 6'

# regions: a ball and a block that is larger than the box, one that moves, one that is outside
prints "$base
region ball sphere 5 5 5 2 units box
region right block 8 20 8 20 8 20 units box
region both union 2 ball right
region far block 20 30 20 30 20 30 units box
variable up equal 2
region up sphere 5 5 5 1 units box move NULL v_up NULL
write_dump all image a.ppm type type $above atom no region both blue filled region far red filled modify $flat
write_dump all image b.ppm type type $above atom no region ball red transparent 0.5 region up lime filled modify $flat"
is 'a ball' a.ppm 138 99 '0 0 255'
is 'outside of it' a.ppm 142 99 '0 0 0'
is 'a block' a.ppm 162 38 '0 0 255'
is 'outside of it' a.ppm 157 43 '0 0 0'
is 'front and rear, half of each' b.ppm 100 110 '191 0 0'
is 'a ball that has moved' b.ppm 100 43 '0 255 0'
is 'beyond it' b.ppm 100 38 '0 0 0'
rejects "$base
write_dump all image a.png type type region bal red filled" 'bal'
rejects "$base
region ball sphere 5 5 5 2 units box
write_dump all image a.png type type region ball red frame 0.1" 'filled'

# words of LAMMPS that are not here
for word in 'grid c_1 2' 'line type 0.1' 'body type 0 1' 'compute c type 1'; do
	rejects "$base
write_dump all image a.png type type $word" 'tsim does not have it'
done
rejects "$base
write_dump all image a.png type type shyny 0.5" "did you mean 'shiny'"

# transparent particles
prints "$base
set type 2 x 2.5 z 7
write_dump all image a.ppm type diameter $above modify $flat atrans 2 0.25 atrans 3 0"
is 'a quarter of forestgreen over red' a.ppm 50 149 '200 35 9'
is 'invisible' a.ppm 150 50 '0 0 0'
rejects "$base
write_dump all image a.png type type modify atrans 1 2" 'from 0, invisible'

# maps by name
prints "$base
write_dump all image a.ppm x diameter $above modify $flat amap 2.5 7.5 viridis
write_dump all image b.ppm x diameter $above modify $flat amap 0 5 coolwarm"
is 'viridis, least' a.ppm 50 149 '68 1 84'
is 'viridis, largest' a.ppm 150 149 '253 231 37'
is 'coolwarm, middle' b.ppm 50 149 '221 221 221'
rejects "$base
write_dump all image a.png x type modify amap min max viridi" 'viridis'

# The film of a slider: the gap falls from 0.2 to 0.1 along x, so its gray is known at each pixel
film='units si
boundary f p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
variable xx internal 0
variable wafer equal 0.2-0.1*v_xx'
reynolds='flow_style reynolds cells 10 10 lower 0 lower_velocity 1 0 0 upper v_wafer set x xx viscosity 1 density 1 update run'
view='view 0 0 up 0 1 0 zoom 2 size 200 200 box no'
cat >in.film <<E
$film
$reynolds
write_dump all image before.ppm type type $view film p legend yes
run 0
write_dump all image a.ppm type type $view film gap modify gmap 0.1 0.2 gray
write_dump all image b.ppm type type $view film gap height 0.3 relief -1 trans 0.5 modify gmap 0.1 0.2 gray backcolor black
write_dump all image c.ppm type type view 45 -90 up 0 0 1 zoom 2 size 200 200 box no film gap relief 2 modify gmap 0.1 0.2 gray backcolor lime
write_dump all image d.ppm type type $view film p legend yes modify gmap min max gray
E
for threads in 1 3; do
	"$TSIM" -in in.film -log none -threads $threads >out 2>&1
	report 'pictures of a film' $? out
	mkdir film.$threads && mv before.ppm [a-d].ppm film.$threads
done
diff -r film.1 film.3 >difference
report 'three threads' $? difference
near 'the first cell' film.1/a.ppm 10 100 '242 242 242'
near 'the middle of a cell' film.1/a.ppm 110 100 '115 115 115'
near 'the last cell' film.1/a.ppm 195 100 '13 13 13'
# z = 0.4 at the left, 0.2 at the right: the far edge is at the rows 43 and 70, the near one at 185 and below the picture
is 'above the relief' film.1/c.ppm 100 30 '0 255 0'
is 'right, above it' film.1/c.ppm 195 55 '0 255 0'
is 'left, below it' film.1/c.ppm 4 190 '0 255 0'
pixel film.1/c.ppm 4 55 && [ "$pixel" != '0 255 0' ] && pixel film.1/c.ppm 195 190 && [ "$pixel" != '0 255 0' ]
report 'the relief falls' $?
grep -q 'it has not been computed yet' out
report 'a film before its run' $? out
rejects "$film
$reynolds
write_dump all image a.png type type film q" 'expected one of p, gap, void'
rejects "$film
write_dump all image a.png type type film p" 'use flow_style reynolds before it'

finish
