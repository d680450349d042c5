#!/bin/bash
# What -explain says is left out (ts_report_left_out) changes no result: for each name the proof, a scene with it
# (-full PART) and without, or two scenes of which only one can have it; bit for bit, or to the bound stated. A new
# omission without a proof here fails.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# name in the report; how it is proved: full PART SCENE, or pair SCENE SCENE
cat >proofs <<'END'
columns          full columns bed
columns          full columns grains
columns          full columns turning
contact list     full rows free
contact history  full history bed
contact history  full history grains
rebuilds         full rebuilds bed
rebuilds         full rebuilds grains
rebuilds         full rebuilds bonded
rebuilds         full rebuilds pour
looks            full looks bed
looks            full looks grains
looks            full looks bonded
looks            full looks walled
looks            full looks drum
looks            full looks fields
looks            full looks sticky
threads          full threads grains
ghosts           pair walled walled_periodic
fluid solver     bound uniform solved 1e-10
air              pair jet jet_in_air
void fraction    pair fluid fluid_room
END
grep -rhoE 'ts_report_left_out\([a-z]+, "[^"]+"' "$top_srcdir/src" | sed 's/.*"\(.*\)"/\1/' | sort -u >named
cut -c1-17 proofs | sed 's/ *$//' | sort -u >proved
same 'each omission has a proof, and no proof is for nothing' named proved

# ---- the scenes; what they share, by FACES
grains() {
	cat <<END
units si
boundary $1
soft_particles yes
newton off
communicate single vel yes
region box block 0 0.03 0 0.03 0 0.05 units box
create_box 1 box
fix m1 all property/global youngsModulus peratomtype 5.3e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.52
fix m4 all property/global coefficientFriction peratomtypepair 1 0.48
END
}
# ends a scene: what is compared, each number in full
outputs() {
	cat <<END
thermo_style custom step atoms ke vol
thermo_modify format float %.17g
thermo 100
dump d all custom 100 d*.txt id x y z vx vy vz fx fy fz
dump_modify d sort id format float %.17g
run ${1-600}
END
}
seeded() {
	cat <<END
region seed block 0.006 0.024 0.006 0.024 0.006 0.044 units box
create_atoms 1 random 80 387 seed overlap 0.0042
set type 1 diameter 0.0042 density 2385
set atom 1*20 diameter 0.0031
timestep 2e-5
END
}
{
	grains 'f f f'
	cat <<-END
	pair_style gran model hertz
	pair_coeff * *
	fix w1 all wall/gran model hertz primitive type 1 zplane 0.004
	fix w2 all wall/gran model hertz primitive type 1 xplane 0.004
	fix w3 all wall/gran model hertz primitive type 1 xplane 0.026
	fix g all gravity 9.81 vector 0.2 0.05 -1
	fix i all nve
	END
	seeded
	outputs 1500
} >in.bed
{
	grains 'p p f'
	cat <<-END
	pair_style gran model hertz tangential no_history
	pair_coeff * *
	fix w1 all wall/gran model hertz tangential no_history primitive type 1 zplane 0.004
	fix g all gravity 9.81 vector 0.2 0.05 -1
	fix i all nve/sphere
	END
	seeded
	outputs 1500
} >in.grains
# beside the faces, with images behind them, and on the way to each other
walled() {
	grains "$1"
	cat <<-END
	change_box all x final 0.002 0.028 y final 0.002 0.028
	pair_style gran model hertz tangential history
	pair_coeff * *
	END
	cat <<-END
	fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.004
	fix g all gravity 9.81 vector 0 0 -1
	fix i all nve/sphere
	END
	seeded
	echo velocity all ramp vx 0.4 -0.4 x 0.006 0.024
	outputs 900
}
walled 'f f f' >in.walled
walled 'p p f' >in.walled_periodic
# in a drum of ten facets that turns about the y axis, its edges sticking out for the grains
awk 'function p(y, k) { return sprintf("vertex %.12g %.12g %.12g", 0.012 * cos(0.62831853 * k), y, 0.012 * sin(0.62831853 * k)) }
	function triangle(a, b, c) { print "facet normal 0 0 1\nouter loop\n" a "\n" b "\n" c "\nendloop\nendfacet" }
	BEGIN {
		print "solid drum"
		for (k = 0; k < 10; k++) {
			triangle(p(0, k), p(0.03, k), p(0.03, k + 1))
			triangle(p(0, k), p(0.03, k + 1), p(0, k + 1))
		}
		print "endsolid drum"
	}' >drum.stl
{
	grains 'f p f' | sed 's/^region box.*/region box block -0.015 0.015 0 0.03 -0.015 0.015 units box/'
	cat <<-END
	pair_style gran model hertz tangential history
	pair_coeff * *
	fix drum all mesh/surface file $PWD/drum.stl type 1
	fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes drum
	fix turn all move/mesh mesh drum rotate origin 0 0 0 axis 0 1 0 period 0.11
	fix g all gravity 9.81 vector 0 0 -1
	fix i all nve/sphere
	region seed block -0.006 0.006 0 0.03 -0.006 0.006
	create_atoms 1 random 60 387 seed overlap 0.0037
	set type 1 diameter 0.0037 density 2385
	timestep 2e-5
	END
	outputs 1500
} >in.drum
# on a rough height field that moves along and down, beside one that shakes, whose columns stick out; with liquid bridges
fields() {
	grains 'p p f'
	cat <<-END
	$1
	pair_style gran model hertz tangential history $2
	pair_coeff * *
	variable c internal 0
	variable steps equal 0.001*(v_c>0.01)+0.002*(v_c>0.022)
	fix rough all surface/voxel gaussian mean 0.002 deviation 0.0005 correlation 0.003 0.002 seed 29 type 1 cells 60 50 datum 0 merge yes move linear 0.05 0.02 -0.01
	fix steps all surface/voxel formula v_steps x c type 1 cells 15 4 move wiggle 0 0 0.0007 0.031
	fix w1 all wall/gran model hertz tangential history $2 voxels rough
	fix w2 all wall/gran model hertz tangential history $2 voxels steps
	fix g all gravity 9.81 vector 0.1 0.05 -1
	fix i all nve/sphere
	END
	seeded
	echo 'set atom 21*30 diameter 0.0011'
	outputs 1500
}
fields >in.fields '' ''
fields 'fix m5 all property/global surfaceLiquidContentInitial scalar 0.1
fix m6 all property/global surfaceTension scalar 0.073
fix m7 all property/global fluidViscosity scalar 0.001
fix m8 all property/global contactAngle peratomtype 30
fix m9 all property/global minSeparationDistanceRatio scalar 0.01
fix m10 all property/global maxSeparationDistanceRatio scalar 1.3' 'cohesion easo/capillary/viscous' >in.sticky
cat >in.bonded <<END
units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
lattice sc 0.1
region bar block -0.3 0.3 -0.05 0.05 -0.05 0.05 units box
create_atoms 1 region bar
set type 1 diameter 0.1 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 2.1e5 restitution 0.47
bond_style contact
bond_coeff 1 stiffness 3.1e5 ultimate 900
create_bonds many all all 1 0.01 0.11
fix g all gravity 9.81 vector 0 0 -1
fix w all wall/gran primitive type 1 zplane -0.07
velocity all set 0 0 -2.3
fix i all nve
timestep 1e-4
END
outputs 900 >>in.bonded
{
	grains 'f f f'
	cat <<-END
	pair_style gran model hertz tangential history
	pair_coeff * *
	fix w1 all wall/gran model hertz tangential history primitive type 1 zplane 0
	fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.0019
	fix p2 all particledistribution/discrete 15485867 1 p1 1.0
	region fill block 0.003 0.027 0.003 0.027 0.02 0.047 units box
	fix ins all insert/rate/region seed 32452843 distributiontemplate p2 nparticles 60 particlerate 3000 insert_every 200 overlapcheck yes all_in yes vel constant 0 0 -0.4 region fill
	fix g all gravity 9.81 vector 0.2 0.05 -1
	fix i all nve/sphere
	timestep 2e-5
	END
	outputs 1500
} >in.pour
cat >free <<END
units si
boundary p p p
region box block 0 0.02 0 0.02 0 0.02 units box
create_box 1 box
create_atoms 1 random 7 991 box
set type 1 diameter 0.0005 density 2385
fix g all gravity 9.81 vector 0.3 0 -1
fix i all nve
timestep 2e-5
END
{ cat free; outputs; } >in.free
{
	cat free
	echo 'flow_style uniform velocity 0.11 0.02 0 viscosity 1.0e-3'
	echo 'fix drag all drag/stokes'
	outputs
} >in.uniform
# so heavy a fluid that the grains do not move it: they give it 7 grains of 1.6e-7 kg at most at 0.1 m/s
{
	cat free
	echo 'flow_style projection cells 8 8 8 viscosity 1.0e-3 density 1e10'
	echo 'flow_set velocity 0.11 0.02 0'
	echo 'fix drag all drag/stokes'
	outputs
} >in.solved
# without drag, and with the drag of a fluid of no viscosity
jet() {
	sed '/^create_atoms/,/^set/d' free
	cat <<-END
	fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.0002
	fix p2 all particledistribution/discrete 15485867 1 p1 1.0
	fix jet all insert/jet seed 32452843 distributiontemplate p2 nparticles 60 particlerate 6000 position 0.01 0.01 0.019 direction 0.2 0 -1 diameter 0.002 speed gaussian 1.3 0.1 cone gaussian 4 overlapcheck no
	$1
	END
	outputs
}
jet '' >in.jet
jet 'flow_style uniform velocity 0 0 0.2 viscosity 0
fix drag all drag/stokes' >in.jet_in_air
fluid() {
	cat free
	echo 'flow_style projection cells 8 6 4 viscosity 1.1e-3 density 1000'
	echo 'variable u equal 0.1'
	echo 'flow_boundary zhi wall velocity 0.13 0 0'
	echo 'group none empty'
	echo "$1"
	echo 'dump f all flow/vtk 100 f*.vti'
	outputs 300
}
sed -i 's/^boundary p p p/boundary p p f/' free
fluid '' >in.fluid
fluid 'fix room none void_fraction' >in.fluid_room

# a ball in a fluid that is sheared at the rate 1.2: it turns with half of that
{
	sed -e '/^create_atoms/,$d' -e 's/0 0.02 0 0.02 0 0.02/0 1 0 1 0 1/' free
	cat <<-END
	create_atoms 1 single 0.5 0.5 0.5 units box
	set group all diameter 0.31 density 2.385
	flow_style projection cells 12 12 12 viscosity 1.1 density 1.3 viscous implicit
	flow_boundary zlo wall velocity -0.6 0 0
	flow_boundary zhi wall velocity 0.6 0 0
	fix ball all immersed/boundary spheres min_cells 3
	fix i all nve/sphere
	timestep 2e-3
	compute spin all property/atom omegay
	compute most all reduce max c_spin
	END
	outputs 400
	echo 'print "spin $(c_most)"'
} >in.turning

# ---- the proofs
# go SCENE FOLDER OPTIONS...: runs it there
go() {
	local scene=$1 folder=$2 vti
	shift 2
	rm -rf "$folder"
	mkdir "$folder"
	(cd "$folder" && "$TSIM" -log none -in "../in.$scene" "$@" >screen 2>err) ||
		{ report "$scene runs ($*)" 1 "$folder/err"; return 1; }
	grep -E '^ *[0-9]+ ' "$folder/screen" >"$folder/rows"
	[ "$(ls "$folder"/d*.txt | wc -l)" -gt 3 ] || report "$scene writes frames" 1
	rm "$folder/screen" "$folder/err"
	sed -i 's/^ITEM: BOX BOUNDS.*/ITEM: BOX BOUNDS/' "$folder"/d*.txt
	for vti in "$folder"/*.vti; do # the void fraction itself
		[ ! -e "$vti" ] || sed -i '/Name="void"/,+2d' "$vti"
	done
}
# largest difference of numbers in files of the same name, in parts of the largest
differ() {
	local file
	for file in "$1"/d*.txt; do
		paste -d' ' "$file" "$2/${file##*/}"
	done | awk 'NF == 20 { for (k = 2; k <= 7; k++) { d = $k - $(k + 10); d = d < 0 ? -d : d; s = $k < 0 ? -$k : $k
		if (d > most[k]) most[k] = d; if (s > size[k]) size[k] = s } n++ }
		END { for (k in most) if (most[k] / size[k] > all) all = most[k] / size[k]; print n ? all : "none" }'
}
while read -r line; do
	name=$(echo "${line:0:16}" | sed 's/ *$//')
	read -r how a b bound <<<"${line:17}"
	case $how in
	full)
		threads=1
		[ "$a" = threads ] && threads=2
		go "$b" without -threads $threads && go "$b" with -threads $threads -full "$a" &&
			diff -r without with >difference
		report "$name: $b with -full $a, bit for bit" $? difference
		"$TSIM" -explain -threads $threads -in "in.$b" >told 2>&1 &&
			sed -n '/^omitted/,/^memory/p' told | grep -q "^  $name "
		report "$name: is left out of $b" $? told
		;;
	pair)
		go "$a" without && go "$b" with && diff -r without with >difference
		report "$name: $a as $b, bit for bit" $? difference
		;;
	bound)
		go "$a" without && go "$b" with && differ without with >difference &&
			awk -v most="$bound" '{ ok = ($1 <= most); exit } END { exit !ok }' difference
		report "$name: $a as $b to $bound" $? difference
		;;
	esac
done <proofs

# the scenes are what they should be
"$TSIM" -log none -in in.walled_periodic >told 2>&1
grep -q '^Nghost: [1-9]' told && awk 'NF == 10 && $8 != 0 { n++ } END { exit !(n > 8) }' d*.txt
report 'there are images, and grains that touch' $? told

"$TSIM" -log none -in in.turning >told 2>&1 && awk '/^spin/ { ok = ($2 > 0.58 && $2 < 0.62); exit } END { exit !ok }' told
report 'the fluid turns a ball' $? told

# all at once
go pour without -threads 2 && go pour with -threads 2 -full && diff -r without with >difference
report 'all at once' $? difference
"$TSIM" -full columns wings -in in.free >told 2>&1
[ $? = 2 ] && shows "found 'wings'" told
report 'a part that is none' $? told
finish
