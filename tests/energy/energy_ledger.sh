#!/bin/bash
# fix energy/ledger: known energies of simple motions, closure to rounding in whole scenes, the order of the drift,
# runs in pieces.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# near WHAT SCRIPT: it runs, and in every line `near WHAT value reference tolerance` of its output both agree
near() {
	printf '%s\n' "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && awk '
		$1 == "near" {
			n++
			d = $3 - $4
			if (!(d <= $5 && -d <= $5)) { print "differs: " $0; bad = 1 }
		}
		END { exit bad || !n }' out >>out 2>&1
	report "$1" $? out
}

# One ball of 2385 kg/m^3, diameter 0.16
ball='units si
boundary f f f
region box block 0 2 0 2 0 2 units box
create_box 2 box
create_atoms 1 single 1 1 1 units box
set group all diameter 0.16 density 2385
variable m equal mass(all)
fix move all nve/sphere
timestep 1e-4
thermo_modify norm no'
materials='fix m1 all property/global youngsModulus peratomtype 5e6 7e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.7 0.7 0.7 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix m6 all property/global characteristicVelocity scalar 2.
fix m7 all property/global cohesionEnergyDensity peratomtypepair 2 2385 2385 2385 2385'
# closure and drift against the largest turnover
sums='variable sum equal f_books[7]+f_books[8]+f_books[9]-f_books[18]+f_books[19]+f_books[20]
variable closure equal f_books[19]/f_books[21]
variable drift equal f_books[20]/f_books[21]'

near 'free fall: gravity gives m g h' "$ball
velocity all set 0.3 0 1.2
fix g all gravity 9.81 vector 0 0 -1
fix books all energy/ledger
run 2385
$sums
print 'near work \$(f_books[7]) \$(v_m*9.81*(1-xcm(all,z))) 1e-10'
print 'near all \$(f_books[6]) \$(ke) 1e-10'
print 'near sum \$(f_books[6]-0.5*v_m*1.53) \$(v_sum) 1e-10'
print 'near closure \$(v_closure) 0 1e-12'
print 'near drift \$(f_books[20]) 0 0'"

near 'drag in still fluid takes what gravity gives and motion lacks' "$ball
fix g all gravity 9.81 vector 0 0 -1
fix v all viscous 23.85
fix books all energy/ledger
run 3000
$sums
print 'near sum \$(ke) \$(f_books[7]) 1e-11'
print 'near drift \$(f_books[20]) 0 0'"

near 'two balls: (1 - e^2) of the relative energy is lost' "$ball
create_atoms 1 single 1.17 1 1 units box
set group all diameter 0.16 density 2385
group two id 2
velocity two set -1.3 0 0
pair_style spring/dashpot
pair_coeff * * stiffness 1e6 restitution 0.7
fix books all energy/ledger
timestep 2e-6
run 7500
$sums
print 'near lost \$(f_books[10]/(0.51*0.5*mass(two)/2*1.3^2)) 1 1e-3'
print 'near all \$(f_books[18]) \$(f_books[10]) 0'
print 'near closure \$(v_closure) 0 1e-12'
print 'near drift \$(v_drift) 0 1e-5'" 

near 'a ball that bounces obliquely: what is lost is what is missing' "$ball
$materials
set group all z 0.0801
velocity all set 0.7 0.2 -1.3
set group all omegax 11 omegay -7
compute turning all erotate/sphere
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
variable before equal \$(ke+0.5*0.4*v_m*0.0064*170)
fix books all energy/ledger
timestep 4e-6
run 10000
print 'near lost \$(f_books[18]) \$(v_before-ke-c_turning) 1e-6'
print 'near restitution \$(f_books[10]/(0.5*v_m*1.69)) 0.51 0.02'
print 'near stored \$(f_books[4]) 0 1e-12'"

# It rests on the floor when it starts: overlap (m g/k)^(2/3)
near 'a ball that slides loses mu m g a metre, once its spring has been stretched' "$ball
$materials
unfix move
fix move all nve
fix g all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
variable k equal 4/3*5e6/(2*(1-0.45^2))*sqrt(0.08)
set group all z \$(0.08-(v_m*9.81/v_k)^(2/3))
velocity all set 0.9 0 0
fix books all energy/ledger
timestep 2e-5
run 500
variable x equal \$(xcm(all,x))
variable slip equal \$(f_books[12])
run 4500
$sums
print 'near slip \$((f_books[12]-v_slip)/(0.4*v_m*9.81*(xcm(all,x)-v_x))) 1 1e-6'
print 'near springs \$(f_books[13]/f_books[12]) 0 1e-3'
print 'near closure \$(v_closure) 0 1e-12'"

near 'a bond stretched until it breaks: K U^2/2 from who pulls' "$ball
create_atoms 1 single 1.17 1 1 units box
set group all diameter 0.16 density 2385
unfix move
group two id 2
group one id 1
fix hold one freeze
fix pull two move linear 0.1 0 0
bond_style contact
bond_coeff 1 stiffness 2.385e5 ultimate 1e3
create_bonds many all all 1 0.1 0.18
fix books all energy/ledger
timestep 1e-5
run 10000
$sums
print 'near broken \$(f_books[17]/(1e6/2/2.385e5)) 1 1e-3'
print 'near work \$((f_books[9]-f_books[1])/f_books[17]) 1 1e-4'
print 'near closure \$(v_closure) 0 1e-12'
print 'near drift \$(v_drift) 0 1e-4'"

near 'dashpots of bonds' "$ball
create_atoms 1 single 1.17 1 1 units box
set group all diameter 0.16 density 2385
group two id 2
velocity two set 0.5 0 0
bond_style contact
bond_coeff 1 stiffness 2.385e5 ultimate 1e5 damping 300
create_bonds many all all 1 0.1 0.18
fix books all energy/ledger
timestep 1e-5
run 20000
print 'near dashpot \$(f_books[16]/(0.25*mass(two)*0.25)) 1 1e-3'
print 'near drift \$(f_books[20]/f_books[21]) 0 1e-5'"

# A wall of triangles rises slowly below a ball that a spring holds down: its work is in the spring of the contact and
# the force of gravity.
cat >plate.stl <<'S'
solid plate
facet normal 0 0 1
outer loop
vertex 0 0 0.9
vertex 2 0 0.9
vertex 2 2 0.9
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0.9
vertex 2 2 0.9
vertex 0 2 0.9
endloop
endfacet
endsolid plate
S
near 'a rising plate lifts a ball' "$ball
$materials
fix g all gravity 9.81 vector 0 0 -1
fix plate all mesh/surface file plate.stl type 1
fix lift all move/mesh mesh plate linear 0 0 0.4
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
fix books all energy/ledger
timestep 3e-5
run 20000
$sums
print 'near lift \$(f_books[8]) \$(f_books[18]-f_books[7]+f_books[6]) 1e-3'
print 'near motion \$(f_books[1]/(0.5*v_m*0.16)) 1 0.02'
print 'near closure \$(v_closure) 0 1e-11'
print 'near drift \$(v_drift) 0 1e-4'"

# The smooth part of an impact, and an oscillating bond: a quarter of the drift at half the step
halves() { # what, script with \${h} and \${n}
	local f
	for f in 1 2; do
		printf '%s\n' "variable h equal 2e-5/$f" "variable n equal 400*$f" "$2" >in.script
		"$TSIM" -in in.script -log none >out.$f 2>&1
	done
	cat out.1 out.2 >out
	awk '$1 == "residue" { d[n++] = $2 } END { r = d[0] / d[1]; print "ratio", r; exit !(n == 2 && r > 3.9 && r < 4.1) }' \
		out >>out
	report "$1" $? out
}
pair='create_atoms 1 single 1.17 1 1 units box
set group all diameter 0.16 density 2385
group two id 2
velocity two set -1.3 0 0'
halves 'drift of a bond is of second order' "$ball
$pair
bond_style contact
bond_coeff 1 stiffness 2.385e5 ultimate 1e5
create_bonds many all all 1 0.1 0.18
fix books all energy/ledger
timestep \${h}
run \${n}
print 'residue \$(f_books[20])'"
halves 'drift of a contact is of second order' "$ball
$materials
$pair
set group two x 1.158
pair_style gran model hertz tangential history
pair_coeff * *
fix books all energy/ledger
timestep \${h}
run \${n}
print 'residue \$(f_books[20])'"

# Whole scenes
bed='units si
boundary p f f
region box block 0 1 0 1 0 1 units box
create_box 2 box
lattice sc 0.17
region low block 0.1 0.9 0.1 0.95 0.05 0.93 units box
create_atoms 1 region low
set group all diameter 0.16 density 2385
velocity all create 0.5 4928459
fix move all nve/sphere
timestep 1e-4
thermo_modify norm no
fix g all gravity 9.81 vector 0 -1 -1'
walls='primitive type 1 zplane 0.0
fix side all wall/gran model'
closes="$sums
print 'near closure \$(v_closure) 0 1e-11'
print 'near residual \$(f_books) \$(v_closure+v_drift) 1e-15'"
for laws in 'hertz tangential history rolling_friction epsd2' 'hooke tangential history rolling_friction cdt' \
	'hertz tangential no_history cohesion sjkr2'; do
	near "bed of $laws" "$bed
$materials
pair_style gran model $laws
pair_coeff * *
fix floor all wall/gran model $laws primitive type 1 zplane 0.0
fix side all wall/gran model $laws primitive type 1 yplane 0.0
fix other all wall/gran model $laws primitive type 1 yplane 1.0
fix v all viscous 0.3
fix books all energy/ledger
run 2000
$closes
print 'near drift \$(v_drift) 0 1e-3'"
done
near 'laws of LAMMPS' "$bed
pair_style granular
pair_coeff * * jkr 1e6 50 0.3 30 tangential mindlin NULL 1.0 0.5 rolling sds 1e4 10 0.1 twisting marshall
fix floor all wall/gran granular hertz 1e6 50 tangential linear_history 1e5 1.0 0.5 zplane 0 NULL
fix side all wall/gran granular hertz 1e6 50 tangential linear_history 1e5 1.0 0.5 yplane 0 1
fix books all energy/ledger
run 2000
$closes"
near 'contacts that yield' "$bed
$materials
fix h1 all property/global coefficientMaxElasticStiffness peratomtypepair 2 4 4 4 4
fix h2 all property/global coefficientAdhesionStiffness peratomtypepair 2 0.4 0.4 0.4 0.4
fix h3 all property/global coefficientPlasticityDepth peratomtypepair 2 0.02 0.02 0.02 0.02
pair_style gran model hooke/hysteresis tangential history
pair_coeff * *
fix floor all wall/gran model hooke tangential history primitive type 1 zplane 0.0
fix books all energy/ledger
run 2000
$closes
variable yields equal f_books[15]>0
print 'near plastic \${yields} 1 0'"

near 'euler, limits and held particles' "$bed
pair_style spring/dashpot
pair_coeff * * stiffness 1e5 restitution 0.7
unfix move
region deep block 0 1 0 1 0 0.2 units box
region mid block 0 1 0 1 0.2 0.5 units box
group deep region deep
group mid region mid
group high subtract all deep mid
velocity deep set 0.1 0 0
fix d deep move linear 0.1 0 0
fix m mid nve/symplectic
fix h high nve/limit 1e-4
fix books all energy/ledger
run 2000
$closes"

near 'two dimensions' "units si
dimension 2
boundary p f p
region box block 0 1 0 1 -0.1 0.1 units box
create_box 2 box
lattice sq 0.17
region low block 0.1 0.9 0.1 0.95 -0.1 0.1 units box
create_atoms 1 region low
set group all diameter 0.16 density 2385
velocity all set 0.2 -0.5 0
fix move all nve/sphere disc
fix flat all enforce2d
timestep 1e-4
thermo_modify norm no
$materials
pair_style gran model hertz tangential history rolling_friction cdt
pair_coeff * *
fix g all gravity 9.81 vector 0.3 -1 0
fix floor all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix books all energy/ledger
run 3000
$closes
print 'near drift \$(v_drift) 0 1e-3'"

pile="units si
boundary f f f
region box block 0 1 0 1 -0.3 1 units box
create_box 2 box
$materials
pair_style gran model hertz tangential history
pair_coeff * *
fix g all gravity 9.81 vector 0.2 0 -1
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix ring all wall/gran model hertz tangential history primitive type 1 zcylinder 0.45 0.5 0.5
region high block 0.3 0.7 0.3 0.7 0.1 0.9 units box
timestep 1e-4
thermo_modify norm no"
near 'particles come and go' "$pile
fix one all particletemplate/sphere 15485863 atom_type 1 density constant 2385 radius constant 0.05
fix mix all particledistribution/discrete 15485867 1 one 1.0
fix ins all insert/pack seed 32452843 distributiontemplate mix maxattempt 100 insert_every 500 overlapcheck yes vel constant 0 0 -1 region high particles_in_region 40
fix move all nve/sphere
fix out all evaporate 300 3 high 49979687
fix books all energy/ledger
run 2500
$closes
print 'near drift \$(v_drift) 0 1e-3'"
near 'particles shrink' "$pile
create_atoms 1 single 0.5 0.5 0.3 units box
set group all diameter 0.1 density 2385
velocity all set 2 0 1
fix move all nve/sphere
fix less all remove nevery 10 massrate 2.0 style shrink delete_below 0.001 seed 5143
fix books all energy/ledger
run 300
$closes
print 'near moved \$(abs(f_books[9])>0.1) 1 0'"
near 'clumps' "$pile
fix one all particletemplate/multisphere 15485863 atom_type 1 density constant 2385 nspheres 2 ntry 10000 spheres 0 0 0 0.05 0.06 0.01 0 0.04 type 1
fix mix all particledistribution/discrete 15485867 1 one 1.0
fix ins all insert/pack seed 32452843 distributiontemplate mix maxattempt 100 insert_every once overlapcheck yes orientation random vel constant 0 0 -1 region high particles_in_region 20
fix move all multisphere
fix v all viscous 0.2
fix books all energy/ledger
run 1500
$closes
print 'near drift \$(v_drift) 0 1e-3'"

block="$materials
pair_style gran model hertz tangential history rolling_friction epsd2
pair_coeff * *
fix floor all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane 0.0
fix side all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 yplane 0.0
fix other all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 yplane 1.0
fix v all viscous 0.3"
halves 'drift of a falling block is of second order' "$bed
$block
fix books all energy/ledger
timestep \$(5*v_h)
run \$(7.5*v_n)
print 'residue \$(f_books[20])'"

near 'heat' "$pile
fix k all property/global thermalConductivity peratomtype 43.0 23.85
fix c all property/global thermalCapacity peratomtype 4.9 2.385
unfix floor
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0 temperature 400
fix heat all heat/gran initial_temperature 300
lattice sc 0.098
create_atoms 1 region high
set group all diameter 0.1 density 2385
region hot block INF INF INF INF 0.5 INF units box
set region hot property/atom Temp 350
set group all property/atom heatSource 2.385
fix move all nve/sphere
fix books all energy/ledger
run 0
variable first equal \$(f_books[22])
run 1000
set region hot property/atom Temp 310
run 1000
print 'near content \$(f_heat/f_books[22]) 1 1e-14'
print 'near closure \$(f_books[25]/f_books[22]) 0 1e-13'
variable in equal f_books[23]>0
variable moved equal f_books[24]<0
print 'near walls \${in} 1 0'
print 'near moved \${moved} 1 0'
print 'near source \$(f_books[23]-2.385*count(all)*0.2) \$(f_books[22]-f_books[24]-v_first-2.385*count(all)*0.2) 1e-8'"

# Runs in pieces, through a file, and on two threads
scene="$materials
fix move all nve/sphere
fix g all gravity 9.81 vector 0 -1 -1
timestep 1e-4
pair_style gran model hertz tangential history rolling_friction epsd2
pair_coeff * *
fix floor all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 zplane 0.0
fix side all wall/gran model hertz tangential history rolling_friction epsd2 primitive type 1 yplane 0.0
fix v all viscous 0.3
fix books all energy/ledger summary no
thermo 100
thermo_modify norm no
thermo_style custom step f_books f_books[6] f_books[7] f_books[9] f_books[10] f_books[11] f_books[12] f_books[14] f_books[18] f_books[19] f_books[20] f_books[21]"
{ echo "$bed"; echo "$scene"; } >in.start
{ cat in.start; echo 'run 2000'; } >in.whole
{ cat in.start; echo 'run 1300'; echo 'run 700'; } >in.two
{ cat in.start; echo 'run 1300'; echo 'write_restart half.restart'; } >in.first
{ echo 'read_restart half.restart'; echo "$scene"; echo 'run 700'; } >in.second
for part in whole two first second; do
	"$TSIM" -in in.$part -log none >out.$part 2>&1
done
rows out.whole >whole
rows out.two >pieces
rows out.first out.second >through
same 'two runs are one' whole pieces
same 'through a restart file' whole through
OMP_NUM_THREADS=2 "$TSIM" -in in.whole -log none 2>&1 | rows >threads
same 'threads' whole threads

# It only looks
sed 's/^thermo_style.*/thermo_style custom step ke fmax/' in.whole >in.with
grep -v 'fix books' in.with >in.without
for part in without with; do
	"$TSIM" -in in.$part -log none 2>&1 | rows >$part
done
same 'with and without it' without with

# It comes when a run has ended: the forces of the last step are split as far as they can be
near 'begun later' "$bed
$materials
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
run 1000
fix books all energy/ledger
run 1000
$closes
print 'near drift \$(v_drift) 0 1e-3'"
near 'velocities set between runs' "$ball
fix g all gravity 9.81 vector 0 0 -1
fix books all energy/ledger
run 100
velocity all set 0 0.5 0
run 100
$sums
print 'near set \$(f_books[6]-f_books[7]) \$(f_books[9]) 1e-12'
print 'near closure \$(v_closure) 0 1e-12'"
cat >in.script <<S
$ball
$materials
$pair
pair_style gran model hertz tangential history
pair_coeff * *
fix books all energy/ledger every 100 file books.txt tolerance 1e-9
timestep 1e-4
run 1000
S
"$TSIM" -in in.script -log none >out 2>&1 && shows 'mostly in normal springs between particles' out &&
	[ "$(grep -c '^[0-9]' books.txt)" = 11 ] && head -n 1 books.txt | grep -q '^# step time TRANSLATION .* HEAT_CLOSURE BOND_NORMAL .* BOND_TWIST$'
report 'file and warning' $? out

finish
