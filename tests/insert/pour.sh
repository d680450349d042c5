#!/bin/bash
# fix pour: how many come when and how fast, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary f f f
region box block -1 1 -1 1 0 2 units box
create_box 2 box
timestep 1e-4
fix move all nve/sphere
region sky block -0.5 0.5 -0.9 0.6 1.2 1.8 units box
region tube cylinder z 0.1 0.2 0.5 1.2 1.8 units box
region side cylinder x 0.1 1.5 0.3 -0.5 0.5 units box
region round sphere 0 0 1 0.5 units box
region moon sphere 0 0 1 0.5 side out units box'
down='fix down all gravity 9.81 vector 0 0 -1'
rain='fix rain all pour 300 2 4711 dens 2385 2385'

# V/V_1 = 1.5*0.6*0.1/(4 pi/3 0.06^3) = 99.47; (-1.3 + sqrt(1.3^2 + 2 g 0.6))/g = 0.241465
prints "$box
$down
$rain diam range 0.08 0.12 vol 0.1 50 vel 0.1 0.1 -0.2 -0.2 -1.3 region sky
run 1
print \"first \$(f_rain) \$(count(all)) \$(type[17])\"
variable left equal vz[17]+sqrt(1.3^2+2*9.81*(1.8-z[17]))
print \"left \$(abs(v_left+0.5e-4*9.81)<1e-12) \$(vx[17]:%.15g) \$(vy[17]:%.15g)\"
run 2414
print \"before \$(f_rain)\"
run 1
print \"then \$(f_rain)\"
run 6000
print \"all \$(f_rain)\"" 'Particle insertion: 99 every 2415 steps, 300 by step 7246' 'first 99 99 2' \
	'left 1 0.1 -0.2' 'before 99' 'then 198' 'all 300'
# the interval is that of the step when the fix was defined, as in LAMMPS
prints "$box
$down
timestep 2e-4
$rain diam one 0.1 vol 0.05 50 region tube
timestep 1e-4
run 1749
print \"two \$(f_rain)\"" '*need 3497 steps to leave the region' '*Particle insertion: 45 every 1749 steps' 'two 45'
# no place: told once, made up for later
prints "$box
$down
$rain diam one 0.1 vol 0.7 1 region tube
run 1" '*fewer insertions than requested'
# the region rises
prints "$box
$down
$rain diam one 0.1 vol 0.05 50 rate 2.385 region tube
run 5000
print \"at \$(f_rain)\"" 'at 135'

# in two dimensions along -y, which is what gravity's words for -z say then
for way in 'vector 0 -1 3' 'chute 0' 'spherical 30 -180'; do
	prints "units si
dimension 2
boundary f f p
region box block -1 1 -1 1 -0.1 0.1 units box
create_box 2 box
timestep 1e-4
fix move all nve/sphere
region flat block -0.5 0.5 0.2 0.8 -0.1 0.1 units box
fix down all gravity 9.81 $way
$rain region flat diam one 0.1 vol 0.1 50 vel 0 0.1 -1.3
run 1
print \"\$(count(all)) \$(vy[3]+sqrt(1.3^2+2*9.81*(0.8-y[3]))+0.5e-4*9.81 < 1e-12)\"" '7 1'
done
for way in 'chute 30|0.5|-sqrt(0.75)' 'spherical 40 30|0.5|sqrt(0.75)' 'vector 3 4 12|0.6|0.8'; do
	IFS='|' read -r words gx gy <<<"$way"
	agree "gravity $words in the plane" "units si
dimension 2
boundary f f p
region box block -1 1 -1 1 -0.1 0.1 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
fix down all gravity 9.81 $words
fix move all nve
run 0
print \"is x \$(fx[1]/mass(all)) \$(9.81*($gx))\"
print \"is y \$(fy[1]/mass(all)) \$(9.81*($gy))\""
done

rejects "$box
$rain region sky" 'fix pour needs fix gravity before it'
rejects "$box
fix down all gravity 9.81 vector 0 1 -1
$rain region sky diam one 0.1" 'fix pour needs gravity along -z'
rejects "$box
variable g equal 9.81
fix down all gravity v_g vector 0 0 -1
$rain region sky diam one 0.1" 'fix pour needs a constant fix gravity, found g'
rejects "$box
$down
$rain region sky" 'no particle fits'
rejects "$box
$down
$rain region moon diam one 0.1" 'region moon has side out; expected one that stands still'
for region in round side; do
	rejects "$box
$down
$rain region $region diam one 0.1" 'expected a block or a cylinder along z'
done
rejects "$box
$down
region beyond block 0 1 0 1 1 3 units box
$rain region beyond diam one 0.1" 'reaches from z = 1 to 3, beyond the box from 0 to 2'
rejects "$box
$down
$rain region sky mol object" "'mol' is not supported: molecules are clumps"
rejects "$box
$down
$rain region sky diam poly 2 0.1 0.3 0.2 0.6" 'add up to 0.9, expected 1'
rejects "$box
$down
$rain region sky diam poly 2 0.1 0.3 0.2" 'found 3 words'
rejects "$box
$down
$rain region sky diam poly 2 0.1 0.3 0 0.7" "found '0 0.7'"
rejects "$box
$down
$rain region sky diam range 0.2 0.1" 'goes from 0.2 to 0.1, expected the smaller first'
rejects "$box
$down
${rain/2385 2385/2385 1000} region sky" 'dens goes from 2385 to 1000'
rejects "$box
$down
${rain/2 4711/3 4711} region sky diam one 0.1" 'particle type 3 does not exist, create_box made 2'
rejects "$box
$down
timestep 10
$rain region sky diam one 0.1
run 1" 'particles would leave the region within a step'
# the step is checked for particles that are still to come
rejects "$box
$down
pair_style gran/hooke/history 1e9 NULL 50 NULL 0.5 1
pair_coeff * *
$rain region sky diam one 0.1
run 1" 'exceeds the stability limit'
finish
