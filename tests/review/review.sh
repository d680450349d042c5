#!/bin/bash
# The review of the scene before a run: each mistake is told once, with numbers and place, and sound scenes have none.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

start='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 2 box'
law='pair_style gran model hooke/stiffness tangential history
pair_coeff * *
fix m1 all property/global kn peratomtypepair 2 1e4 1e4 1e4 1e4
fix m2 all property/global kt peratomtypepair 2 3e3 3e3 3e3 3e3
fix m3 all property/global gamman peratomtypepair 2 1 1 1 1
fix m4 all property/global gammat peratomtypepair 2 1 1 1 1
fix m5 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4'
two="create_atoms 1 single 0.3 0.5 0.15 units box
create_atoms 1 single 0.6 0.5 0.15 units box
set group all diameter 0.2 density 1000"
rest='timestep 1e-4
run 10'

# found WHAT CHECK SCRIPT [TEXT ...]: the run and -check find this once, with the texts, and nothing else; with `review
# error` it is refused, with `review off` silent
found() {
	local what=$1 check=$2 ok=0 mode
	printf '%s\n' "$3" >in.script
	shift 3
	"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null || ok=1
	grep '(review: ' run.log >told
	"$TSIM" -check -in in.script 2>&1 </dev/null | grep '(review: ' >told.check
	for told in told told.check; do
		[ "$(grep -c . $told)" = 1 ] && grep -qE "^in\.script:[0-9]+: warning: .*\(review: $check\)$" $told || ok=1
		for text in "$@"; do
			shows "$text" $told || { ok=1; echo "missing: $text" >>told; }
		done
	done
	for mode in error off; do
		sed "1i review $mode $check" in.script >in.$mode
	done
	"$TSIM" -in in.error -log none -screen none >out 2>&1 </dev/null && ok=1
	grep -qE "^in\.error:[0-9]+:[0-9]+: error: .*\(review: $check\)$" out || ok=1
	"$TSIM" -check -in in.error >out 2>&1 </dev/null && ok=1
	"$TSIM" -in in.off -log off.log -screen none >out 2>&1 </dev/null || ok=1
	grep -q 'review:' off.log && ok=1
	echo "$check" >>provoked
	report "$what" $ok told
}

# sound WHAT SCRIPT: neither the run nor -check finds anything
sound() {
	printf '%s\n' "$2" >in.script
	"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null && ! grep '(review: ' run.log >told &&
		! "$TSIM" -check -in in.script 2>&1 </dev/null | grep '(review: ' >told
	report "$1" $? told
}

whole="$start
$two
$law
fix move all nve/sphere"
sound 'a sound scene' "$whole
$rest"

# ---- integrator ----
found 'no integrator' integrator "$start
$two
$law
$rest" '2 of 2 particles are not integrated by any fix' 'particle 1 (type 1)' 'fix ID GROUP nve/sphere'
found 'no integrator for some, in a loop of runs' integrator "$start
$two
$law
group some id 1
fix move some nve/sphere
timestep 1e-4
label again
variable k loop 3
run 10
next k
jump SELF again
run 10" '1 of 2 particles' 'particle 2'
sound 'frozen particles' "$start
$two
$law
group some id 1
group rest id 2
fix move some nve/sphere
fix hold rest freeze
$rest"
sound 'prescribed motion' "$start
$two
$law
group some id 1
group rest id 2
fix move some nve/sphere
fix pull rest move linear 0.1 0 0
$rest"
sound 'rigid bodies' "$start
$two
$law
fix body all rigid single
$rest"
sound 'a run that only sets up' "$start
$two
$law
run 0
run 1
fix move all nve/sphere
$rest"
sound 'particles that come in the run' "$start
$law
fix t all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.02
fix d all particledistribution/discrete 15485867 1 t 1.0
region in block 0.1 0.9 0.1 0.9 0.1 0.9 units box
fix ins all insert/pack seed 32452843 distributiontemplate d maxattempt 100 insert_every once overlapcheck yes all_in yes particles_in_region 20 region in
timestep 1e-4
run 1
fix move all nve/sphere
run 10"

# ---- groups ----
found 'a force on a group of a type that nobody has' group "$whole
group water type 2
fix down water gravity 9.81 vector 0 0 -1
$rest" 'fix down (gravity) acts on nothing' "its group 'water' has no particle"
pours="$start
$law
fix move all nve/sphere
fix ball all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.1
fix mix all particledistribution/discrete 15485867 1 ball 1
region high block 0.2 0.8 0.2 0.8 0.5 0.9 units box"
found 'a wall for those of a type that are inserted later' group "$pours
group poured type 1
fix floor poured wall/gran primitive type 1 zplane 0
fix rain all insert/pack seed 15485917 distributiontemplate mix insert_every once particles_in_region 3 region high
$rest" 'fix floor (wall/gran) acts on nothing' "its group 'poured'"
sound 'they are inserted into the group' "$pours
group poured empty
fix floor poured wall/gran primitive type 1 zplane 0
fix rain poured insert/pack seed 15485917 distributiontemplate mix insert_every once particles_in_region 3 region high
$rest"
sound 'so is their template' "$pours
group poured empty
fix floor poured wall/gran primitive type 1 zplane 0
fix small poured particletemplate/sphere 15485863 atom_type 2 density constant 1000 radius constant 0.1
fix both all particledistribution/discrete 15485867 2 ball 0.5 small 0.5
fix rain all insert/pack seed 15485917 distributiontemplate both insert_every once particles_in_region 3 region high
$rest"
sound 'groups that particles join, outputs, and meshes' "$whole
variable quick atom vx>3
group fast dynamic all var quick every 10
group none empty
fix brake fast viscous 0.1
compute ke none ke
fix mean none ave/time 1 10 10 c_ke
$rest"

# ---- rotation ----
found 'nve with friction' rotation "$start
$two
$law
fix move all nve
$rest" 'fix nve' 'coefficient 0.4' 'fix move all nve/sphere'
sound 'nve without friction' "$start
$two
pair_style spring/dashpot
pair_coeff * * stiffness 1e4 damping 0
fix move all nve
$rest"
sound 'nve with a coefficient of 0' "$start
$two
${law/0.4 0.4 0.4 0.4/0 0 0 0}
fix move all nve
$rest"

# ---- units ----
found 'no units: gravity' units "${whole/units si/# no units}
fix g all gravity 9.81 vector 0 0 -1
thermo_modify norm no
$rest" 'gravity is 9.81' 'units si'
sound 'units lj are meant' "${whole/units si/units lj}
fix g all gravity 9.81 vector 0 0 -1
$rest"
sound 'no units, and no sign of others' "${whole/units si/# no units}
fix g all gravity 1 vector 0 0 -1
$rest"

# ---- diameter ----
found 'diameter never set' diameter "${start/0 1 0 1 0 1/-5 5 -5 5 -5 5}
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 2 0 0 units box
set type 2 diameter 0.2 density 1000
$law
fix move all nve/sphere
timestep 1e-6
run 10" '1 of 2 particles' 'particle 1 (type 1)' 'set type 1 diameter D density RHO'
sound 'diameter 1 in units lj' "units lj
region box block -5 5 -5 5 -5 5 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
pair_style spring/dashpot
pair_coeff * * stiffness 1e2 damping 0
fix move all nve
timestep 1e-3
run 10"

# ---- overlap: k/2 delta^2 = 5000 0.04^2 = 8, m* = 1000 pi/6 0.2^3/2 = 2.0944, sqrt(2 8/2.0944) = 2.76395 ----
found 'overlap at the start' overlap "${whole/0.6 0.5 0.15/0.46 0.5 0.15}
$rest" ': 1; the largest overlap is 0.04 (40 %)' 'particles 1 and 2 at (0.3 0.5 0.15)' 'elastic energy is 8,' 'separation speed of this pair 2.76395'
across=${whole/0.3 0.5 0.15/0.02 0.5 0.15}
across=${across/boundary f f f/boundary p f f}
found 'overlap across a periodic face' overlap "${across/0.6 0.5 0.15/0.86 0.5 0.15}
$rest" ': 1; the largest overlap is 0.04 (40 %)'
sound 'a small overlap' "${whole/0.6 0.5 0.15/0.496 0.5 0.15}
$rest"
sound 'overlaps that fix nve/limit takes out' "${whole/0.6 0.5 0.15/0.46 0.5 0.15}
unfix move
fix move all nve/limit radius_ratio 0.01
$rest"
sound 'an overlap that came in a run' "$whole
velocity all set 0.6 0 0
set atom 2 vx -0.6
run 0
timestep 1e-3
run 110
timestep 1e-4
run 10"
prints "$whole
run 0
timestep 1e-4
run 10
set group all diameter 0.4
$rest" '*5 % of a radius at the start: 1; the largest overlap is 0.1 (50 %)'
sound 'spheres that have been made smaller between runs' "$whole
run 0
timestep 1e-4
run 10
set group all diameter 0.19
$rest"
sound 'bonded on purpose' "${whole/0.6 0.5 0.15/0.46 0.5 0.15}
bond_style contact
bond_coeff 1 stiffness 1e4 ultimate 1e9
create_bonds many all all 1 0.1 0.2
$rest"
printf '%s\n' "${whole/0.6 0.5 0.15/0.46 0.5 0.15}" 'write_restart start.restart' >in.write
"$TSIM" -in in.write -log none -screen none
found 'overlap from a restart file written before the first step' overlap "read_restart start.restart
$law
fix move all nve/sphere
$rest" ': 1; the largest overlap is 0.04'

# ---- held_contacts: a row of four, three of them held ----
row="$start
create_atoms 1 single 0.2 0.5 0.5 units box
create_atoms 1 single 0.399 0.5 0.5 units box
create_atoms 1 single 0.598 0.5 0.5 units box
create_atoms 1 single 0.797 0.5 0.5 units box
set group all diameter 0.2 density 1000
$law
group held id 1 2 3
fix move all nve/sphere
fix hold held freeze"
found 'contacts of held particles in a pressure' held_contacts "$row
thermo_style custom step press
$rest" ': 2, one of them of particles 2 and 3 at (0.399 0.5 0.5)' 'LIGGGHTS and LAMMPS count them'
sound 'contacts of held particles that nothing reads' "$row
$rest"
sound 'excluded contacts of held particles' "$row
neigh_modify exclude group held held
thermo_style custom step press
$rest"

# ---- wall_overlap ----
found 'in a plane wall' wall_overlap "$whole
fix floor all wall/gran primitive type 1 zplane 0.1
$rest" ': 2; the largest overlap is 0.05 (50 %)' 'particle 1 at (0.3 0.5 0.15)' 'elastic energy is 25,'
cat >plate.stl <<'STL'
solid plate
facet normal 0 0 1
outer loop
vertex 0.1 0.1 0.09
vertex 0.9 0.1 0.09
vertex 0.9 0.9 0.09
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0.1 0.1 0.09
vertex 0.9 0.9 0.09
vertex 0.1 0.9 0.09
endloop
endfacet
endsolid
STL
found 'in a mesh' wall_overlap "$whole
fix plate all mesh/surface file plate.stl type 1
fix floor all wall/gran mesh n_meshes 1 meshes plate
$rest" ': 2; the largest overlap is 0.04 (40 %)'
found 'in the surface of a region' wall_overlap "$whole
region cup block 0 1 0 1 0.1 1 units box
fix floor all wall/gran/region type 1 region cup
$rest" ': 2; the largest overlap is 0.05 (50 %)' 'particle 1 at (0.3 0.5 0.15)' 'elastic energy is 25,'
found 'around a region' wall_overlap "$whole
region ball sphere 0.3 0.5 0.3 0.1 side out units box
fix ball all wall/gran/region type 1 region ball
$rest" ': 1; the largest overlap is 0.05 (50 %)'
sound 'on the other side of the surface of a region' "$whole
region cup block 0 1 0 1 0.2 1 units box
fix floor all wall/gran/region type 1 region cup
$rest"
sound 'on the surface of a region' "$whole
region cup block 0 1 0 1 0.05 1 units box
fix floor all wall/gran/region type 1 region cup
$rest"
sound 'on a wall' "$whole
fix floor all wall/gran primitive type 1 zplane 0.05
$rest"

# during the run: particles that are inserted where a wall is, once for each wall; -check does not insert
pour="$start
$law
fix t all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius constant 0.05
fix d all particledistribution/discrete 15485867 1 t 1.0
region low block 0.2 0.8 0.2 0.8 0 0.3 units box
fix move all nve/sphere
timestep 1e-4"
poured='fix pour all insert/pack seed 32452843 distributiontemplate d insert_every 5 particles_in_region 30 region low'
inserted() { # WHAT, lines of the wall
	printf '%s\n' "$pour" "$2" "$poured" 'run 1' \
		'variable deep atom 0.05-abs(z-0.02)' 'compute most all reduce max v_deep' \
		'print "deep $(c_most:%.6g) $(100*c_most/0.05:%.3g)"' 'run 14' >in.inserted
	"$TSIM" -in in.inserted -log none >out 2>&1
	[ "$(grep -c '(review: wall_overlap)' out)" = 1 ] &&
		[ "$(sed -nE 's/.*were inserted in step 1 .* largest overlap is ([^ ]+) \(([^ ]+) %\).*/\1 \2/p' out)" = \
			"$(sed -n 's/^deep //p' out)" ]
	report "inserted $1" $? out
	sed '1i review error wall_overlap' in.inserted >in.error
	refused "inserted $1, as an error" 'review: wall_overlap' -in in.error
	sed '1i review off wall_overlap' in.inserted >in.off
	"$TSIM" -in in.off -log none 2>&1 | grep 'review:' >out
	[ ! -s out ]
	report "inserted $1, silent" $? out
}
inserted 'in a plane' 'fix w all wall/gran model hooke/stiffness primitive type 1 zplane 0.02'
inserted 'in the surface of a region' 'region on block INF INF INF INF 0.02 INF units box
fix w all wall/gran/region type 1 region on'
sound 'inserted a radius from a plane' "$pour
fix w all wall/gran model hooke/stiffness primitive type 1 zplane 0.0
$poured all_in yes
run 14"

# ---- density ----
found 'g/cm3' density "${whole/density 1000/density 2.65}
fix g all gravity 9.81 vector 0 0 -1
$rest" '2 of 2 particles' 'with 2.65 kg/m3' 'set type 1 density RHO'
sound 'other gravity' "${whole/density 1000/density 2.65}
fix g all gravity 1 vector 0 0 -1
$rest"

# ---- bonds ----
# grains on a lattice of 5 x 5 in the plane z = 0.5, or 4 x 4 x 4, bonded up to a distance
bonded() {
	printf '%s\n' "$1" 'units si' 'boundary f f f' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' \
		'lattice sc 0.1' "region some block $2 units box" 'create_atoms 1 region some' \
		'set type 1 diameter 0.1 density 1000' 'pair_style spring/dashpot' 'pair_coeff * * stiffness 1e4 damping 0' \
		'bond_style contact' 'bond_coeff 1 stiffness 1e4 ultimate 1e9' "create_bonds many all all 1 0.01 $3" \
		'fix move all nve' "${4-# all free}" 'timestep 1e-4' 'run 10'
}
plate='0.29 0.71 0.29 0.71 0.49 0.51'
cube='0.29 0.61 0.29 0.61 0.29 0.61'
row='0.09 0.91 0.49 0.51 0.49 0.51'
# a square lattice: 2 5 4 = 40 bonds; with diagonals 72. In a plane 2 25 - 3 = 47 are needed, in space 3 25 - 6 = 69
found 'a square lattice in a plane' bonds "$(bonded 'dimension 2' "${plate/0.49 0.51/-0.1 0.1}" 0.11 | sed 's/boundary f f f/boundary f f p/; s/0 1 units box/-0.5 0.5 units box/; s/lattice sc/lattice sq/')" \
	': 1; the largest has 25 particles (among them particle 1) and 40 bonds, but rigidity requires 47'
sound 'with diagonals' "$(bonded 'dimension 2' "${plate/0.49 0.51/-0.1 0.1}" 0.145 | sed 's/boundary f f f/boundary f f p/; s/0 1 units box/-0.5 0.5 units box/; s/lattice sc/lattice sq/')"
found 'a square lattice in space' bonds "$(bonded '' "$plate" 0.11)" '40 bonds, but rigidity requires 69'
# a cubic lattice: 3 4 4 3 = 144 bonds of 3 64 - 6 = 186; with diagonals of its faces 360
found 'a cubic lattice' bonds "$(bonded '' "$cube" 0.11)" 'has 64 particles' '144 bonds, but rigidity requires 186'
sound 'a cubic lattice with diagonals' "$(bonded '' "$cube" 0.145)"
# 16 are held: 144 - 24 bonds of the free ones, 3 48 = 144 needed
found 'a cubic lattice that stands on a plate' bonds "$(bonded '' "$cube" 0.11 'region foot block 0 1 0 1 0 0.35 units box
group foot region foot
fix hold foot freeze')" '120 bonds, but rigidity requires 144'
sound 'a chain' "$(bonded '' "$row" 0.11)"
sound 'a rock of which bonds have broken' "$(bonded '' "$cube" 0.145 'velocity all ramp vx 0 3 x 0.3 0.6 units box
bond_coeff 1 stiffness 1e4 ultimate 1')
run 100
timestep 2e-4
print \"bonds \$(bonds)\"
run 10"
awk '/^bonds/ { n++; bad = !($2 > 64 && $2 < 186) } END { exit bad || n != 1 }' run.log
report 'so that fewer are left than the structure needs' $? run.log

# ---- modulus ----
hertz() {
	printf '%s\n' "$start" "$two" 'fix m1 all property/global youngsModulus peratomtype '"$1 $1" \
		'fix m2 all property/global poissonsRatio peratomtype 0.3 0.3' \
		'fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5' \
		'fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5' \
		'pair_style gran model hertz tangential history' 'pair_coeff * *' 'fix move all nve/sphere' \
		"timestep $2" 'run 10'
}
found 'GPa' modulus "soft_particles yes
$(hertz 200 1e-4)" 'contacts of types 1 and 1 have the modulus E* = 109.89 Pa'
found 'a thousand times too hard' modulus "hard_particles yes
$(hertz 2e14 1e-10)" 'E* = 1.0989e+14 Pa'
sound 'soft grains' "soft_particles yes
$(hertz 2e4 1e-4)"
sound 'steel' "hard_particles yes
$(hertz 2e11 1e-8)"
found 'a law of LAMMPS' modulus "$start
$two
pair_style granular
pair_coeff * * hertz/material 70 0.5 0.3 tangential mindlin NULL 1.0 0.5 damping tsuji
fix move all nve/sphere
$rest" 'modulus E*'
found 'the law of a wall' modulus "$start
$two
pair_style granular
pair_coeff * * hertz/material 7e6 0.5 0.3 tangential mindlin NULL 1.0 0.5 damping tsuji
fix floor all wall/gran granular hertz/material 70 0.5 0.3 tangential mindlin NULL 1.0 0.5 damping tsuji zplane 0 NULL
fix move all nve/sphere
$rest" 'contacts of type 1 with wall floor'

# ---- reach ----
found 'a plane in millimetres' reach "$whole
fix side all wall/gran primitive type 1 xplane 1000
$rest" 'this wall is at distance 999 from the box (0 0 0) to (1 1 1)'
found 'a cylinder that is too large' reach "$whole
fix side all wall/gran primitive type 1 zcylinder 100 0.5 0.5
$rest" 'this wall is at distance 99.2929'
sound 'walls at and just outside of the faces' "$whole
fix low all wall/gran primitive type 1 xplane 0
fix high all wall/gran primitive type 1 xplane 1.05
fix tube all wall/gran primitive type 1 zcylinder 0.75 0.5 0.5
$rest"

# ---- floor: 0.15 m take 0.17 s ----
found 'no floor' floor "$whole
fix g all gravity 9.81 vector 0 0 -1
timestep 1e-4
run 2000" 'fixed face zlo' '2 of 2 particles' 'zplane 0'
sound 'a short fall' "$whole
fix g all gravity 9.81 vector 0 0 -1
timestep 1e-4
run 1500"
sound 'a floor' "$whole
fix g all gravity 9.81 vector 0 0 -1
fix floor all wall/gran primitive type 1 zplane 0
timestep 1e-4
run 2000"
fall='fix g all gravity 9.81 vector 0 0 -1
timestep 1e-4
run 2000'
found 'a lid is no floor' floor "$whole
fix lid all wall/gran primitive type 1 zplane 0.8
$fall" '2 of 2 particles'
found 'a mesh above the particles is no floor' floor "$whole
fix plate all mesh/surface file plate.stl type 1 move 0 0 0.3
fix floor all wall/gran mesh n_meshes 1 meshes plate
$fall" '2 of 2 particles'
found 'a mesh beside them is none' floor "$whole
fix plate all mesh/surface file plate.stl type 1 scale 0.2 move 0.75 0.75 0
fix floor all wall/gran mesh n_meshes 1 meshes plate
$fall" '2 of 2 particles'
sound 'a mesh below one of them may be a hopper' "$whole
fix plate all mesh/surface file plate.stl type 1 scale 0.2 move 0.55 0.4 0
fix floor all wall/gran mesh n_meshes 1 meshes plate
$fall"
sound 'a mesh that moves may come' "$whole
fix plate all mesh/surface file plate.stl type 1 move 0 0 0.3
fix lift all move/mesh mesh plate linear 0 0 -0.01
fix floor all wall/gran mesh n_meshes 1 meshes plate
$fall"
sound 'losses are meant' "$whole
fix g all gravity 9.81 vector 0 0 -1
thermo_modify lost ignore
timestep 1e-4
run 2000"

# ---- meshes ----
found 'a mesh in metres' mesh_size "$whole
fix plate all mesh/surface file plate.stl type 1 scale 0.001 move 0.5 0.5 0.5
fix floor all wall/gran mesh n_meshes 1 meshes plate
$rest" 'mesh plate has the length 0.0008' 'particle diameter 0.2'
leaving="$whole
fix plate all mesh/surface file plate.stl type 1 move 0 0 0.6
fix push all move/mesh mesh plate linear 0 0 1
fix floor all wall/gran mesh n_meshes 1 meshes plate
timestep 1e-3"
sound 'a mesh that stays' "$leaving
run 300"
printf '%s\n' "$leaving" 'run 320' >in.script
"$TSIM" -check -in in.script 2>&1 </dev/null | grep '(review: ' >told
grep -qE 'mesh plate leaves the box in a time of 0.31, after 310 of the 320 steps .*mesh_leaves' told && [ "$(grep -c . told)" = 1 ]
report 'a mesh that leaves' $? told
echo mesh_leaves >>provoked

# ---- servo ----
servo="${start/0 1 0 1 0 1/0 1 0 1 -0.5 1}
create_atoms 1 single 0.3 0.5 0.05 units box
set group all diameter 0.1 density 1000
${law/kn peratomtypepair 2 1e4 1e4 1e4 1e4/kn peratomtypepair 2 1e5 1e5 1e5 1e5}
fix move all nve/sphere
fix g all gravity 9.81 vector 0 0 -1
fix floor all wall/gran primitive type 1 zplane 0
neighbor 0.02 bin
fix lid all mesh/surface/stress/servo file plate.stl type 1 move 0 0 0.015 com 0.5 0.5 0.105 ctrlPV force axis 0 0 -1 target_val 20"
press='fix press all wall/gran mesh n_meshes 1 meshes lid
timestep 1e-5
run 5000'
found 'a servo beyond its limit' servo "$servo vel_max 1 kp 1000
$press" 'mesh lid is unstable: with 1 contact' 'stiffness 1e+05' 'reduce kp below '
sound 'one far below it' "$servo vel_max 1 kp 0.1
$press"
found 'the automatic mode beyond its limit' servo "$servo vel_max 1 mode auto ratio 0.5
$press" 'reduce the ratio below '
found 'the gain of LIGGGHTS where it is too large' servo "legacy yes
${servo/target_val 20/target_val 0.001} vel_max 1
$press" 'reduce kp below '
# a held particle and a dashpot of 5 m = 2.618: kp_max = 2 20/(1 (1e5 1e-5 + 2 2.618)) = 6.414
held="${servo//gamman peratomtypepair 2 1 1 1 1/gamman peratomtypepair 2 5 5 5 5}"
held="${held/diameter 0.1 density 1000/diameter 0.1 density 1000
fix hold all freeze}"
held="${held/fix move all nve\/sphere/}"
held="${held/move 0 0 0.015 com/move 0 0 0.0095 com}"
sound 'just below the limit' "${held} vel_max 1 kp 6.3
$press
print \"force \$(f_lid[3]:%.9g)\""
grep -q '^force 20$' run.log
report 'the servo is at rest there' $? run.log
found 'just beyond the limit' servo "${held} vel_max 1 kp 6.6
$press" 'limit is 0.972 times' 'reduce kp below 6.41'
# four held particles that the lid does not touch yet: known only when it does
four="$held vel_max 1 kp 3.3"
four="${four/create_atoms/create_atoms 1 single 0.7 0.5 0.05 units box
create_atoms 1 single 0.5 0.3 0.05 units box
create_atoms 1 single 0.5 0.7 0.05 units box
create_atoms}"
printf '%s\n' "${four/move 0 0 0.0095 com/move 0 0 0.0102 com}" "$press" >in.script
"$TSIM" -check -in in.script 2>&1 </dev/null | grep '(review: ' >told
[ ! -s told ]
report 'a servo before its contacts' $? told
"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null
grep '(review: ' run.log >told
[ "$(grep -c . told)" = 1 ] && grep -qE 'servo of mesh lid oscillated .*now 3\.3[^0-9].*review: servo' told
report 'a servo that flips' $? run.log
# without gains: with kp 0.01 the force went from -2 to 4
printf '%s\n' "${held/target_val 20/target_val 0.02} vel_max 1" "$press" \
	'variable off equal abs(abs(f_lid[3])/0.02-1)' 'print "off ${off}"' >in.script
"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null
awk '/^off/ { n++; if ($2 > 1e-6) exit bad = 1 } END { exit bad || n != 1 }' run.log && ! grep -q 'review:' run.log &&
	grep -q '^fix lid: kp is 0.0006414, 0.1 of the largest that is stable with 1 contacts' run.log
report 'a servo without gains comes to rest' $? run.log

# ---- momentum of particles and fluid ----
suspension='units si
boundary p p p
newton off
communicate single vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 random 20 17 box
set group all diameter 0.05 density 2000
fix m all nve/sphere
flow_style projection cells 4 4 4 viscosity 1 density 1000
fix e all void_fraction
fix d all drag/stokes
fix p all flow/pressure_gradient'
found 'momentum that is not kept' momentum "$suspension
$rest" 'the box is periodic in all directions' 'form conservative'
found 'nor so' momentum "${suspension/density 1000/density 1000 form conservative} interpolation linear
$rest" 'the default `interpolation` of this fix'
sound 'momentum that is kept' "${suspension/density 1000/density 1000 form conservative}
$rest"
sound 'a channel' "${suspension/boundary p p p/boundary p p f}
$rest"

# ---- flow_resolution: more of it in flow_resolution.sh ----
echo flow_resolution >>provoked

# ---- members of rigid bodies: more of it in integrators.sh ----
printf '%s\n' "$start" 'create_atoms 1 single 0.3 0.5 0.3 units box' 'set group all diameter 0.1 density 1000' "$law" \
	'fix body all rigid single' 'fix move all nve/sphere' 'timestep 1e-5' 'run 10' >in.script
"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null
grep '(review: ' run.log >told
[ "$(grep -c . told)" = 1 ] && grep -qE 'fix move .nve/sphere. integrates particle 1, a member of a rigid body.*review: members' told
report 'members of rigid bodies' $? run.log
echo members >>provoked

# ---- the command ----
rejects "$start
review off overlpa" "unknown check 'overlpa'; did you mean 'overlap'?"
rejects "$start
review silent" "answer is 'silent'"

# ---- once per scene: two runs, a loop of scenes that one line clears, and another scene ----
near="$start
create_atoms 1 single 0.3 0.5 0.15 units box
create_atoms 1 single 0.4 0.5 0.15 units box
set group all diameter 0.2 density 1000
$law
fix move all nve/sphere
$rest"
printf '%s\n' 'variable k loop 2' 'label scene' clear "$near" 'velocity all set 0 0 0' 'run 10' 'next k' 'jump SELF scene' clear "$near" >in.script
"$TSIM" -in in.script -log run.log -screen none >out 2>&1 </dev/null
report 'scenes: runs' $? out
[ "$(grep -c '(review: overlap)' run.log)" = 2 ]
report 'a finding is told once per scene' $? run.log

# ---- every check is provoked here, and told in doc/review.md ----
sed -n 's/^\t{ "\([a-z_]*\)",.*/\1/p' "$top_srcdir/src/review/table.c" | sort >checks
sort -u provoked >here
same 'every check is provoked' checks here
sed -n 's/^### `\([a-z_]*\)`.*/\1/p' "$top_srcdir/doc/review.md" | sort >told
same 'every check is in doc/review.md' checks told
find "$top_srcdir/src" -name '*.c' -exec cat {} + | tr '\n\t' '  ' | grep -oE 'ts_review_report\( *sim, *"[a-z_]*"' |
	sed 's/.*"\(.*\)"/\1/' | sort -u >used
same 'every finding has a check' checks used

# ---- sound scenes, all but one, whose grains begin in its walls ----
for script in "$top_srcdir"/tests/decks/in.* "$top_srcdir"/examples/drilling/in.drilling "$top_srcdir"/examples/materials/in.*; do
	[ "${script##*/}" = in.region_walls ] && continue
	(cd "${script%/*}" && "$TSIM" -check -in "$script") 2>&1 </dev/null | grep '(review: ' >told
	[ ! -s told ]
	report "no finding in ${script##*/}" $? told
done
finish
