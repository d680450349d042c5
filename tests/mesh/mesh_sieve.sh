#!/bin/bash
# A mesh as a sieve: the probability to pass, the force on what is held, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"
plate 4 0 >plate.stl
start='units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block -0.5 0.5 -0.5 0.5 -0.1 0.1 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.1
pair_style gran model hertz tangential history
pair_coeff * *
fix deck all mesh/surface file plate.stl type 1'
words='point_at_outlet 0 0 -1 count once sieveSize 2e-3'

# Ten thousand grains of 1 mm fall on openings of 2 mm at distances of 2.5 and 3.5 mm.
rain="$start
timestep 1e-5
lattice sc 0.0099
region above block -0.495 0.494 -0.495 0.494 0.001 0.01
create_atoms 1 region above
set group all diameter 1e-3 density 1000
velocity all set 0 0 -1 units box
fix screen all massflow/mesh/sieve mesh deck $words sieveSpacing \${spacing} sieveStiffness 30
fix move all nve/sphere
thermo_style custom step atoms f_screen[1] f_screen[2] ke
variable spacing index 2.5e-3
run 2000
print \"passed \$(f_screen[2]) of \$(atoms)\""

# binomial FILE SPACING: whether the number that has passed is within four standard deviations of its mean
binomial() {
	awk -v spacing="$2" '$1 == "passed" && NF == 4 && $2 ~ /^[0-9]/ { k = $2; n = $4 }
		END { p = atan2(1, 1) * (1e-3 / spacing)^2
			sigma = sqrt(n * p * (1 - p))
			print k, "of", n, "expected", n * p, "+-", sigma
			exit !(n > 9000 && (k - n * p)^2 < 16 * sigma^2) }' "$1" >passed
}
printf '%s\n' "$rain" | sed 's/^variable spacing.*//; s/^units si/variable spacing index 2.5e-3\n&/' >in.rain
for spacing in 2.5e-3 3.5e-3; do
	"$TSIM" -in in.rain -var spacing $spacing -log none >out 2>&1 && binomial out $spacing
	report "openings at $spacing" $? passed
done
if has liggghts; then
	liggghts -in in.rain -var spacing 3.5e-3 -log none >theirs 2>&1 && binomial theirs 3.5e-3
	report 'openings at 3.5e-3 in LIGGGHTS' $? passed
fi

# Grains too large, one from below, a member of a body, and one of another group: held by spring and dashpot, which leave
# exp(-g pi/w) of the velocity, g = c/2m, w^2 = k/m - g^2; the last one falls through. The dashpot begins up to a step late, which
# changes the velocity by 2 g dt at most.
held="$start
create_atoms 1 single 0.1 0.1 0.002 units box
create_atoms 1 single 0.2 0.1 -0.002 units box
create_atoms 1 single 0.3 0.1 0.002 units box
create_atoms 1 single 0.4 0.1 0.002 units box
create_atoms 1 single 0.41 0.1 0.002 units box
set group all diameter 2.5e-3 density 1000
set atom 4*5 diameter 1e-3
group free id 1:3
group meshed id 1 2 4 5
group pair id 4 5
velocity all set 0 0 -1 units box
set atom 2 vz 1
fix screen meshed massflow/mesh/sieve mesh deck $words sieveSpacing 1e-3 sieveStiffness 1e3 sieveDamping 0.05
fix move free nve/sphere
fix body pair rigid single
variable g equal 0.05/2/mass(free)*3
variable w equal sqrt(1e3/mass(free)*3-v_g^2)
variable e equal exp(-v_g*PI/v_w)
thermo 1000000"
agree 'held' "$held
timestep 1e-8
run 200000
variable v atom vz
print 'is above \$(v_v[1]) \$(v_e) 1e9'
print 'is below \$(v_v[2]) \$(-v_e) 1e9'
print 'is other \$(v_v[3]) -1'
print 'is sieve \$(f_sieve_screen[3]+f_sieve_screen[1]) 0'
print 'is passed \$(f_screen[2]) 0'"
for dt in 8e-7 2e-7 5e-8; do
	printf '%s\n' "$held" "timestep $dt" 'run_time 2e-3' 'variable v atom vz' \
		'print "off $(v_v[1]-v_e) $(2*v_g*dt)"' >in.script
	"$TSIM" -in in.script -log none 2>&1 | awk '$1 == "off" && $2 ~ /^[-0-9]/'
done | awk '{ print; bad = bad || !($2 ^ 2 < $3 ^ 2) } END { exit bad || NR != 3 }' >order
report 'first order' $? order
agree 'a body is held' "$held
timestep 1e-7
run 20000
print 'is up \$(f_body[1][3]>4e-4) 1'
print 'is body \$(f_sieve_screen[4]+f_sieve_screen[5]) 2'"

# What passes feels nothing; a sieve that moves gives a grain at rest (1 + e) of its velocity.
agree 'passing' "$start
timestep 1e-5
create_atoms 1 single 0.1 0.1 0.002 units box
set group all diameter 1e-4 density 1000
velocity all set 0.1 0 -1 units box
fix screen all massflow/mesh mesh deck $words sieveSpacing 1e-3 sieveStiffness 30
fix move all nve/sphere
variable v atom vz
run 198
print 'is passing \$(f_sieve_screen[1]) 2'
run 100
print 'is through \$(f_screen[2]) 1'
print 'is clear \$(f_sieve_screen[1]) 0'
print 'is v \$(v_v[1]) -1'"
agree 'moving' "$start
timestep 1e-7
create_atoms 1 single 0.1 0.1 0.002 units box
set group all diameter 2.5e-3 density 1000
fix lift all move/mesh mesh deck linear 0 0 1
fix screen all massflow/mesh/sieve mesh deck $words sieveSpacing 1e-3 sieveStiffness 1e3 sieveDamping 0
fix move all nve/sphere
variable v atom vz
run 20000
print 'is v \$(v_v[1]) 2 1e9'"

prints "$start
timestep 1e-6
create_atoms 1 single 0.1 0.1 0.002 units box
set group all diameter 2.5e-3 density 1000
velocity all set 0 0 -1 units box
fix screen all massflow/mesh/sieve mesh deck $words sieveSpacing 1e-3 sieveStiffness 1
fix move all nve/sphere
run 6000" '*particle 1 has got through the sieve that held it: it needs a higher sieveStiffness'

# A run cut by a restart file while grains are held and pass, and on three threads; beyond a periodic face.
bed="$(printf '%s\n' "$start" | sed 's/boundary f f f/boundary p p f/')
timestep 1e-5"
whole="$bed
lattice sc 0.05
region above block -0.5 0.49 -0.5 0.49 0.001 0.01 units box
create_atoms 1 region above
set group all diameter 1e-3 density 1000
velocity all set 20 0 -1 units box"
rest="fix screen all massflow/mesh/sieve mesh deck $words sieveSpacing 1.5e-3 sieveStiffness 30 sieveDamping 0.001
fix move all nve/sphere
fix fall all gravity 9.81 vector 0 0 -1
compute v all reduce sum vz z f_sieve_screen
thermo_style custom step f_screen[1] f_screen[2] c_v[1] c_v[2] c_v[3]
thermo_modify format float %.17g
thermo 200"
printf '%s\n' "$whole" "$rest" 'run 51' 'write_restart half.restart' 'run 2149' >in.whole
printf '%s\n' 'read_restart half.restart' "$(printf '%s\n' "$bed" | sed '/^units\|^atom\|^boundary\|^newton\|^region\|^create_box/d')" \
	"$rest" 'run 2149' >in.again
resumes 'cut' rows 10

base="$start
timestep 1e-5"
rejects "$base
fix s all massflow/mesh/sieve mesh deck $words" 'a sieve needs sieveSpacing, too'
rejects "$base
fix s all massflow/mesh/sieve mesh deck $words sieveSpacing 3e-3" 'a sieve needs sieveStiffness, too'
rejects "$base
fix s all massflow/mesh mesh deck vec_side 0 0 1 sieveDamping 1" 'needs the diameter of its openings, sieveSize'
rejects "$base
fix s all massflow/mesh/sieve mesh deck $words sieveSpacing 3e-3 sieveStiffness 1 sieveMultiSphereCanPass" 'could be stuck'
rejects "$base
fix s all massflow/mesh/sieve mesh deck $words sieveSpacing 0 sieveStiffness 1" 'expected a number > 0'
finish
