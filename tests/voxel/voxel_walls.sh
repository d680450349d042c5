#!/bin/bash
# Walls made of height fields: a field of one height is a plane bit for bit, a side face as well; edges and corners,
# contacts that slide from column to column, many contacts of one particle, periodic images, motion, heat, what is
# refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Spheres of three sizes that bounce, slide and roll across the borders of columns. WALL is a plane or a field.
cat >in.scene <<'END'
units si
boundary ${faces}
atom_style granular
newton off
communicate single vel yes
neighbor 0.02 bin
region box block -1 1 -1.1 1.1 -0.5 2 units box
create_box 1 box
region seeds block -0.9 0.9 -0.9 0.9 0.1 0.7 units box
lattice sc 0.3
create_atoms 1 region seeds
set group all diameter 0.2 density 2385
set atom 3 diameter 0.28
set atom 5 diameter 0.11
# on a border, and where four columns meet, for all numbers of columns used
create_atoms 1 single 0 0 1.1 units box
create_atoms 1 single -1 -1.1 1.3 units box
velocity all set 0.9 -0.7 -1.7 units box
velocity all ramp vx 0.2 1.1 z 0.1 1.0 units box
fix Y all property/global youngsModulus peratomtype 5e6
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.7
fix mu all property/global coefficientFriction peratomtypepair 1 0.4
fix mr all property/global coefficientRollingFriction peratomtypepair 1 0.05
fix we all property/global workOfAdhesion peratomtypepair 1 5
fix cv all property/global characteristicVelocity scalar 2
fix ce all property/global cohesionEnergyDensity peratomtypepair 1 3000
pair_style gran model hertz tangential history rolling_friction epsd2
pair_coeff * *
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 1e-4
include wall
dump d all custom 500 out id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy
dump_modify d format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g" sort id
thermo_style custom step atoms ke f_w[1] f_w[2] f_w[3]
thermo_modify format float %.17g lost ignore
thermo 250
run 4000
END
# scene NAME WALL [OPTIONS...]
scene() {
	local name=$1
	printf '%s\n' "$2" >wall
	shift 2
	"$TSIM" -in in.scene -var faces "$faces" -log log.$name "$@" >messages 2>&1
	report "runs: $name" $? messages
	{ cat out; rows log.$name; } >result.$name
}
# equals NAME LAW SHAPE MOTION FIELD...: each field is the same wall as the plane
equals() {
	local name=$1 law=$2 shape=$3 motion=$4
	shift 4
	scene plane "fix w all wall/gran model $law primitive type 1 $shape $motion"
	[ "$(wc -l <result.plane)" -gt 200 ]
	report "$name: particles stay" $? result.plane
	for field; do
		scene field "fix s all surface/voxel $field
fix w all wall/gran model $law voxels s"
		same "$name: $field" result.plane result.field
	done
}
history='hertz tangential history rolling_friction epsd2'
faces='p p f'
equals periodic "$history" 'zplane 0.013' '' 'constant 0.013 type 1 cells 1 1' 'constant 0.013 type 1 cells 7 9' \
	'constant 0.013 type 1 cells 64 50 base -0.4' 'constant 0.013 type 1 cells 2000 3'
scene threads "fix s all surface/voxel constant 0.013 type 1 cells 64 50
fix w all wall/gran model $history voxels s" -threads 3
same 'three threads' result.field result.threads
equals 'a moving surface' "$history" 'zplane 0.013' 'velocity 1.3 0.4 0' \
	'constant 0.013 type 1 cells 20 31 move linear 1.3 0.4 0'
equals 'no history' 'hooke tangential no_history' 'zplane 0.013' '' 'constant 0.013 type 1 cells 64 50'
equals cohesion 'hertz tangential history cohesion sjkr' 'zplane 0.013' '' 'constant 0.013 type 1 cells 64 50'
equals adhesion 'jkr tangential history' 'zplane 0.013' '' 'constant 0.013 type 1 cells 64 50'
faces='f f f'
equals 'a larger field' "$history" 'zplane 0.013' '' \
	'constant 0.013 type 1 cells 70 90 origin -1.5 -1.7 size 4 3.1 base -0.1'

# Laws that reach beyond the touch, or depend on other contacts or on the time within the step: the decks of these,
# with a field in place of their plane
# deck NAME FIX TYPE HEIGHT
deck() {
	local side file options=(-var out o -var last 400 -var located yes -var law 'hertz tangential history')
	rm -rf plane field
	mkdir plane field
	cp "$top_srcdir/tests/decks/in.$1" plane/in
	sed "s/^\\(fix[[:space:]]*$2[[:space:]].*\\)primitive type $3 zplane $4/fix f all surface\\/voxel constant $4 type $3 cells 31 17\\n\\1voxels f/" \
		plane/in >field/in
	for side in plane field; do
		(cd $side && "$TSIM" -in in "${options[@]}" -log log -screen none 2>err)
		report "$1: $side" $? $side/err
		rows $side/log >$side/rows
	done
	cmp -s plane/in field/in
	[ $? = 1 ]
	report "$1: the field is there" $?
	for file in rows o.dump wet100.txt; do
		[ ! -e plane/$file ] || same "$1: $file" plane/$file field/$file
	done
}
deck multicontact floor 2 0.005
deck located w 1 0.0
deck bridges floor 1 0.0

# Grooves along y: the contacts with tops, sides and edges slide along them, from column to column or in one.
faces='p p f'
grooves='variable cx internal 0
variable h equal 0.1*sin(7*PI*v_cx)
fix s all surface/voxel formula v_h x cx type 1'
for n in 1 37 800; do
	scene $n "$grooves cells 40 $n
fix w all wall/gran model $history voxels s"
done
same 'grooves of 37 columns' result.1 result.37
same 'grooves of 800 columns' result.1 result.800

# The side of a step is a plane, too; heights along x and y.
sed -i 's/vector 0 0 -1/vector -1 0 0/; s/velocity all set .*/velocity all set -1.7 0.2 0.1 units box/; /ramp/d' in.scene
sed -i 's/^create_atoms 1 single .*//; s/block -0.9 0.9 -0.9 0.9 0.1 0.7/block -0.8 0.7 -0.9 0.9 0.1 0.7/' in.scene
faces='f p f'
step='
variable cx internal 0
variable h equal "v_cx < -0.9 ? 5 : -3"'
step='variable cx internal 0
variable h equal 5*(v_cx<-0.9)-3*(v_cx>-0.9)'
scene plane "fix w all wall/gran model $history primitive type 1 xplane -0.9"
scene field "$step
fix s all surface/voxel formula v_h x cx type 1 cells 20 3
fix w all wall/gran model $history voxels s"
same 'the side of a step' result.plane result.field
scene field "fix s all surface/voxel constant -0.9 normal x type 1 cells 20 31
fix w all wall/gran model $history voxels s"
same 'heights along x' result.plane result.field

# One sphere of radius 0.1 that touches a step of height 0 for x < 0 and -0.06 beyond: where, and how deep
cat >in.sphere <<'END'
units si
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single $(v_x) $(v_y) $(v_z) units box
set type 1 diameter 0.2 density 1000
fix kn all property/global kn peratomtypepair 1 1000
fix kt all property/global kt peratomtypepair 1 1e-13
fix gn all property/global gamman peratomtypepair 1 1e-13
fix gt all property/global gammat peratomtypepair 1 1e-13
fix mu all property/global coefficientFriction peratomtypepair 1 0
variable cx internal 0
variable cy internal 0
variable law string "model hooke/stiffness tangential no_history"
timestep 1e-6
END
# sphere WHAT X Y Z HEIGHT FX FY FZ N: force/1000 and number of contacts
sphere() {
	agree "$1" "variable x equal $2
variable y equal $3
variable z equal $4
include in.sphere
variable h equal $5
fix s all surface/voxel formula v_h x cx y cy type 1 cells ${cells-20 20} ${merge-}
fix w all wall/gran \${law} voxels s
compute c all wall/gran/local id force
compute n all reduce max c_c[1]
run 0
print \"is fx \$(fx[1]/1000:%.15g) \$($6:%.15g) 0.1\"
print \"is fy \$(fy[1]/1000:%.15g) \$($7:%.15g) 0.1\"
print \"is fz \$(fz[1]/1000:%.15g) \$($8:%.15g) 0.1\"
print \"is sum \$(f_w[3]/1000:%.15g) \$(-($8):%.15g) 0.1\""
}
step='-0.06*(v_cx>0)'
sphere 'on the upper step' -0.05 0.03 0.09 "$step" 0 0 0.01
sphere 'on the border, above the edge' 0 0.03 0.09 "$step" 0 0 0.01
sphere 'beside a step of the size of rounding' -0.01 0.03 0.09 '1e-12*(v_cx>0)' 0 0 0.01
sphere 'beyond the edge' 0.03 0.03 0.08 "$step" '(0.1/sqrt(0.03^2+0.08^2)-1)*0.03' 0 '(0.1/sqrt(0.03^2+0.08^2)-1)*0.08'
# deep overlaps, whose contact areas would reach each other; each edge beside a low step a contact, or none
merge='merge no'
sphere 'the side of the step and the floor' 0.08 0.03 -0.00 "$step" 0.02 0 0.04
sphere 'the centre at the height of the step' 0.08 0.03 0 "$step-0.3*(v_cx>0)" 0.02 0 0
sphere 'the centre below the height of the step' 0.08 0.03 -0.1 "$step-0.3*(v_cx>0)" 0.02 0 0
sphere 'a corner' 0.03 0.04 0.06 '-3*(1-(v_cx<0)*(v_cy<0))' '(0.1/sqrt(0.0061)-1)*0.03' '(0.1/sqrt(0.0061)-1)*0.04' \
	'(0.1/sqrt(0.0061)-1)*0.06'
sphere 'a corner of three faces' 0.08 0.07 0.09 '1-(v_cx>0)*(v_cy>0)' 0.02 0.03 0.01
sphere 'a low step, edges apart' -0.01 0.03 0.09 '1e-4*(v_cx>0)' '-0.01*(0.1/sqrt(0.01^2+0.0899^2)-1)' 0 \
	'0.01+0.0899*(0.1/sqrt(0.01^2+0.0899^2)-1)'
sphere 'the axis of a pit' 0.05 0.05 -0.5 '0.9*(1-(abs(v_cx-0.05)<0.06)*(abs(v_cy-0.05)<0.06))-0.58' 0 0 0.02
unset merge
sphere 'a low step' -0.01 0.03 0.09 '1e-4*(v_cx>0)' 0 0 0.01
sphere 'a low step that is nearer' -0.001 0.03 0.09 '1e-4*(v_cx>0)' '-0.001*(0.1/sqrt(0.001^2+0.0899^2)-1)' 0 \
	'0.0899*(0.1/sqrt(0.001^2+0.0899^2)-1)'
sphere 'low steps on four sides' -0.05 0.05 0.09 '1e-4*((v_cx>0)+(v_cx<-0.1)+(v_cy>0.1)+(v_cy<0))' 0 0 0.01
cells='1 1'
sphere 'the outer side of the field' 0.03 0.03 0.95 0.9 0 0 0.05
cells='2000 2000'
sphere 'columns much smaller than the sphere' 0.0317 0.0211 0.095 0 0 0 0.005

# A field that does not span a periodic box ends with faces, and has images.
agree images 'variable x equal 0.97
variable y equal 0
variable z equal -0.3
include in.sphere
fix s all surface/voxel constant 0 type 1 cells 3 3 origin -0.97 -1 size 1.1 2
fix w all wall/gran ${law} voxels s
run 0
print "is alone $(fx[1]) 0"
change_box all boundary p f f
run 0
print "is image $(fx[1]/1000:%.14g) $(-0.1+0.06) 0.1"'

# Many contacts of one particle: more than the slots it begins with
cat >in.rough <<'END'
units si
boundary p p f
atom_style granular
newton off
communicate single vel yes
neighbor 0.02 bin
region box block -1 1 -1 1 -0.5 2 units box
create_box 1 box
create_atoms 1 single 0.1 0.2 0.4 units box
create_atoms 1 single -0.45 -0.3 0.3 units box
create_atoms 1 single -0.45 0.6 0.15 units box
set atom 1 diameter 0.7
set atom 2 diameter 0.5
set atom 3 diameter 0.05
set group all density 2385
velocity all set 0.7 0.3 -1 units box
fix Y all property/global youngsModulus peratomtype 5e6
fix nu all property/global poissonsRatio peratomtype 0.3
fix e all property/global coefficientRestitution peratomtypepair 1 0.5
fix mu all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hertz tangential history
pair_coeff * *
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 1e-4
fix s all surface/voxel gaussian mean 0 deviation 0.01 correlation 0.02 seed 7 type 1 cells 200 200 merge no
fix w all wall/gran model hertz tangential history voxels s
compute c all wall/gran/local id force
compute m all reduce sum c_c[4] c_c[5] c_c[6]
compute k all reduce ave c_c[3]
thermo_style custom step ke f_w[1] f_w[2] f_w[3] c_m[1] c_m[2] c_m[3]
thermo_modify format float %.17g
thermo 50
dump c all local 50 contacts c_c[3]
END
cp in.rough in.whole
echo 'run 3000
write_restart end.restart' >>in.whole
"$TSIM" -in in.whole -log log.one >messages 2>&1
report 'a rough field' $? messages
mv end.restart one.restart
awk '/^ITEM: ENTRIES/ { split("", n); on = 1; next } /^ITEM/ { on = 0 } on && ++n[$1] > most { most = n[$1] }
	END { print "contacts of one particle: " most; exit most < 9 }' contacts
report 'a particle has more contacts than slots' $?
rows log.one | awk 'function far(a, b) { return a + b > 1e-9 || a + b < -1e-9 }
	{ moved += $5 != 0; if (far($3, $6) || far($4, $7) || far($5, $8)) bad = 1 } END { exit bad || moved < 5 }'
report 'the force on the wall is that of all contacts' $? log.one
"$TSIM" -in in.whole -threads 3 -log log.three >messages 2>&1
report 'three threads' $? messages
same 'three threads: the state' one.restart end.restart
for at in 400 733 1500; do
	{ cat in.rough; echo "run $at
write_restart cut.restart"; } >in.first
	{ sed -n '1,/^communicate/p' in.rough | grep -v boundary; echo 'read_restart cut.restart'
		sed '1,/^set group all density/d; /^velocity/d' in.rough; echo "run $((3000 - at))
write_restart end.restart"; } >in.second
	"$TSIM" -in in.first -log none >messages 2>&1 && "$TSIM" -in in.second -log none >messages 2>&1
	report "cut at $at" $? messages
	same "cut at $at: the state" one.restart end.restart
done

# Heat: the touching part of a warm field, as of a warm plane
for wall in 'primitive type 1 zplane 0 temperature 400' 'voxels s'; do
	printf '%s\n' "variable x equal 0.03
variable y equal 0.05
variable z equal 0.09
include in.sphere
fix heat all heat/gran initial_temperature 300
fix k all property/global thermalConductivity peratomtype 50
fix c all property/global thermalCapacity peratomtype 10
fix s all surface/voxel constant 0 type 1 cells 30 40 temperature 400
fix w all wall/gran \${law} $wall
pair_style gran model hooke/stiffness tangential no_history
pair_coeff * *
fix move all nve/sphere
run 20
print \"\$(f_Temp[1]:%.17g)\"" >in.heat
	"$TSIM" -in in.heat -log none 2>messages | grep '^300' >>temperatures
	report "warm: $wall" "${PIPESTATUS[0]}" messages
done
[ "$(wc -l <temperatures)" = 2 ] && [ "$(uniq temperatures)" = 300.00036888615762 ]
report 'heat from a field' $? temperatures

# A field that moves upwards: a sphere without gravity is thrown with v + 2 (V - v)
agree 'a rising field' "variable x equal 0.03
variable y equal 0.05
variable z equal 0.1001
include in.sphere
fix s all surface/voxel constant 0 type 1 cells 30 40 move linear 0 0 0.7
fix w all wall/gran \${law} voxels s
fix move all nve
velocity all set 0.2 0 -0.3
timestep 2e-5
run 20000
print \"is vz \$(vz[1]:%.5f) 1.7\"
print \"is vx \$(vx[1]) 0.2\"
dump d all voxel/vtk 1 top.*.vtk s
run 0"
awk '/^POINTS/ { on = 1; next } /^POLYGONS/ { exit } on && $3 != 0.28 { bad = 1 } END { exit bad || !on }' top.20000.vtk
report 'where it is written' $? top.20000.vtk

# An oscillating field in micrometres: the same in units of length by a power of two
for scale in 0 20; do
	sed "s/SCALE/2^-$scale/" <<'END' >in.scaled
units si
atom_style granular
newton off
communicate single vel yes
hard_particles yes
soft_particles yes
variable L equal SCALE
boundary p p f
region box block 0 $(v_L) 0 $(v_L) $(-0.5*v_L) $(2*v_L) units box
create_box 1 box
neighbor $(0.03125*v_L) bin
lattice sc $(0.25*v_L)
region seeds block $(0.1*v_L) $(0.9*v_L) $(0.1*v_L) $(0.9*v_L) $(0.3*v_L) $(0.8*v_L) units box
create_atoms 1 region seeds
set type 1 diameter $(0.2*v_L) density 2500
velocity all set $(v_L) $(0.3*v_L) $(-2*v_L) units box
fix m1 all property/global youngsModulus peratomtype $(5e6*v_L^2)
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hertz tangential history
pair_coeff * *
fix g all gravity $(9.81*v_L) vector 0 0 -1
fix move all nve/sphere
fix s all surface/voxel gaussian mean $(0.01*v_L) deviation $(0.05*v_L) correlation $(0.2*v_L) $(0.11*v_L) seed 3 type 1 cells 40 50 datum 0 move wiggle $(0.01*v_L) 0 $(0.02*v_L) 0.05
fix w all wall/gran model hertz tangential history voxels s
timestep 1e-4
run 3000
variable x atom x/v_L
variable z atom z/v_L
compute s all reduce sum v_x v_z
print "moved $(c_s[1]:%.17g) $(c_s[2]:%.17g)"
END
	"$TSIM" -in in.scaled -log none 2>messages | grep '^moved' >scaled.$scale
	report "in units of 2^-$scale" "${PIPESTATUS[0]}" messages
done
same micrometres scaled.0 scaled.20

# ---- what is refused
base='variable x equal 0.03
variable y equal 0.05
variable z equal 0.3
include in.sphere'
field='fix s all surface/voxel constant 0 type 1 cells 3 3'
rejects "$base
fix w all wall/gran \${law} voxels s" "there is no height field 's'"
rejects "$base
fix s all gravity 9.81 vector 0 0 -1
fix w all wall/gran \${law} voxels s" 'fix s is no height field, but of style gravity'
rejects "$base
$field
fix w all wall/gran \${law} voxels s primitive type 1 zplane 0" 'a wall is a mesh, a height field or a primitive, one of them'
rejects "$base
$field
fix w all wall/gran \${law} voxels s type 1" 'a height field has the type that its fix says'
rejects "$base
fix s all surface/voxel constant 0 type 2 cells 3 3
fix w all wall/gran \${law} voxels s" 'the wall is of type 2, but create_box made 1'
rejects "$base
fix s all surface/voxel constant 0.4 type 1 cells 3 3
fix w all wall/gran \${law} voxels s
run 0" 'the centre of particle 1 (type 1) at (0.03 0.05 0.3) lies in the solid of wall w, column 2 2 of surface s: it is inside'
refused '-check foresees it' 'lies in the solid of wall w' -check -in in.script
rejects "$base
fix s all surface/voxel constant 0.3 type 1 cells 3 3
fix w all wall/gran \${law} voxels s
run 0" 'lies in the solid of wall w'
rejects "$base
fix s all surface/voxel constant 0 type 1 cells 3 3 move linear 0 0 1e6
fix w all wall/gran \${law} voxels s
run 1" 'surface s'
# too fast: 1 in a step, through the upper step; beside it there is room
fast="fix s all surface/voxel formula v_h x cx y cy type 1 cells 10 10
fix w all wall/gran \${law} voxels s
fix move all nve
timestep 1e-5
set atom 1 vz -6e4
run 1"
rejects "variable h equal 0.8*(v_cx<0.2)-0.9
$base
$fast" 'past wall w'
prints "variable h equal 0.8*(v_cx>0.2)-0.9
$base
$fast
print \"passed \$(z[1]:%.3f)\"" 'passed -0.300'
prints "$base
$field
group none empty
fix w none wall/gran \${law} voxels s
run 10
print \"force \$(f_w[3])\"" 'force 0'
printf '%s\n' "$base
$field
fix w all wall/gran \${law} voxels s
run 10" >in.script
"$TSIM" -in in.script -explain -log none >out 2>&1 && shows '3 x 3 columns of 0.666667 x 0.666667, heights 0 to 0' out
report 'explained' $? out
finish
