#!/bin/bash
# Insertion of particles: places known from LIGGGHTS 3.8, counts that follow from the mixture, no overlaps,
# and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

box='units si
boundary f f f
region box block 0 1.0 0 0.8 0 0.9 units box
create_box 2 box
region bed block 0.1 0.9 0.05 0.75 0.1 0.85 units box
timestep 1e-5
fix move all nve/sphere'
scene="$box
fix large all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0485
fix small all particletemplate/sphere 15485867 atom_type 2 density constant 2000 radius constant 0.0385
fix mix all particledistribution/discrete 32452843 2 small 0.3 large 0.7"
pack='fix fill all insert/pack seed 32452867 distributiontemplate mix insert_every once'

# numbers of particles and places printed by LIGGGHTS
prints "$scene
$pack maxattempt 200 all_in yes region bed particles_in_region 50
run 1
group large type 1
print \"\$(count(large)) \$(x[33]:%.17g) \$(y[33]:%.17g) \$(z[17]:%.17g) \$(mass(all)-f_fill[2]:%.3f)\"" \
	'*inserted 50 particle templates (mass 4.181916e+01) at step 1' \
	'25 0.71271314873020786 0.28615437002673483 0.19588987233391492 0.000'

# of 10000 particles the shares of number are (w/m) / sum, to one particle
prints "${scene/constant 0.0485/constant 0.00485}
unfix mix
unfix small
fix small all particletemplate/sphere 15485867 atom_type 2 density constant 2000 radius constant 0.00385
fix mix all particledistribution/discrete 32452843 2 small 0.3 large 0.7
$pack region bed particles_in_region 10000
group large type 1
run 1
group now type 1
variable m1 equal 2500*0.00485^3
variable m2 equal 2000*0.00385^3
variable share equal 0.7/v_m1/(0.7/v_m1+0.3/v_m2)
print \"off \$(abs(count(now)-10000*v_share)<1)\"" 'off 1'

# nothing overlaps, across periodic faces too; all lie in the region wholly
prints "${scene/f f f/p p f}
fix m1 all property/global kn peratomtypepair 2 1e3 1e3 1e3 1e3
fix m2 all property/global kt peratomtypepair 2 1e3 1e3 1e3 1e3
fix m3 all property/global gamman peratomtypepair 2 1 1 1 1
fix m4 all property/global gammat peratomtypepair 2 1 1 1 1
pair_style gran model hooke/stiffness
pair_coeff * *
region whole block 0 1 0 0.8 0 0.9 units box
create_atoms 1 random 40 86028157 whole overlap 0.1
set group all diameter 0.097 density 2500
$pack region whole all_in no check_dist_from_subdomain_border no volumefraction_region 0.2
compute touching all contact/atom
compute sum all reduce sum c_touching
thermo_style custom step atoms c_sum
run 1
print \"touching \$(c_sum)\"" 'touching 0'

# LIGGGHTS sees no place but says so; particles that found none are counted
prints "$scene
$pack maxattempt 2 region bed volumefraction_region 0.4
run 1" '*fewer insertions than requested: 224 of 475 particles found a place at step 1 with 2 tries each'

# a region that two fixes share, one event and many, a start, nothing overlaps the old ones
prints "$scene
region tube cylinder z 0.5 0.4 0.3 0.2 0.85 units box
fix grow all insert/pack seed 67867967 distributiontemplate mix insert_every 10 start 5 region tube mass_in_region 30
run 4
print \"none \$(count(all))\"
run 1
print \"mass \$(abs(f_grow[2]-30)<1.2)\"
set group all type 2
run 30
print \"full \$(f_grow[1]-count(all))\"" 'none 0' 'mass 1' 'full 0'

# Any seed will do: where the first particle comes to be is told by the stream s <- 16807 s mod 2^31 - 1 of the
# seed, that of the region 12 places on, after the numbers of ntry_mc points.
for seed in 5 5330 2147483646; do
	at=$(awk -v s=$seed 'BEGIN {
		s = (s + 12 - 1) % 2147483646 + 1
		for (k = 0; k < 3006; k++) {
			s = (16807 * s) % 2147483647
			x[k % 3] = s / 2147483647
		}
		printf "%.9f %.9f %.9f", x[0], x[1], x[2]
	}')
	prints "${scene/0 1.0 0 0.8 0 0.9/-1 2 -1 2 -1 2}
region unit block 0 1 0 1 0 1 units box
${pack/32452867/$seed} all_in no ntry_mc 1001 region unit particles_in_region 1
run 1
print \"at \$(x[1]:%.9f) \$(y[1]:%.9f) \$(z[1]:%.9f)\"" "at $at"
done

# Two fixes with one seed draw the same numbers: told, once. What LIGGGHTS 3.8 refuses is told with legacy only.
for legacy in no yes; do
	prints "legacy $legacy
${scene//154858[0-9][0-9]/5330}
${pack/32452867/32452843} region bed particles_in_region 3
run 1
print \"made \$(count(all))\"" 'made 3' '*warning: fix insert/pack: the seed 32452843 of fix mix is used twice'
	[ "$(grep -c 'is used twice' out)" = 1 ] &&
		[ "$(grep -c 'LIGGGHTS 3.8 refuses' out)" = "$([ $legacy = yes ] && echo 3 || echo 0)" ]
	report "seeds, legacy $legacy" $? out
done

# a particle feels forces from its first step on, and is integrated with the group of the fix only
prints "$box
group grains empty
group lot empty
fix g grains gravity 9.81 vector 0 0 -1
fix one lot particletemplate/sphere 15485863 atom_type 2 density constant 1000 radius constant 0.01
fix two all particledistribution/discrete 32452843 1 one 1
fix ins grains insert/pack seed 32452867 distributiontemplate two insert_every once region bed particles_in_region 3 vel constant 0 0 0.5
run 1
print \"\$(count(grains)) \$(count(lot)) \$(abs(vz[2]-0.5+0.5e-5*9.81)<1e-15)\"" '3 3 1'

# set_property, and first values of other properties
prints "$scene
fix t all property/atom heat scalar yes no no 293.5
fix c all property/atom colour vector yes no no 1 2.5
$pack set_property heat 350.25 region bed particles_in_region 3
compute m all reduce min f_t f_c[2]
thermo_style custom step c_m[1] c_m[2]
run 1
print \"\$(c_m[1]) \$(c_m[2])\"" '350.25 2.5'

# the step is checked for particles that are still to come
rejects "$scene
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
$pack region bed particles_in_region 3
timestep 1
run 1" 'exceeds the stability limit'

with() { # LINES... TEXT: the scene with these lines is refused
	rejects "$scene
$1" "$2"
}
with "fix x all particletemplate/sphere 15485917 density constant 2500 radius constant 1e-5" \
	'mean volume of 4.18879e-15, below volume_limit 1e-12'
with "fix x all particletemplate/sphere 3147483647 density constant 1 radius constant 1" 'expected 1 to 2147483646'
with "fix x all particletemplate/sphere 0 density constant 1 radius constant 1" 'seed is 0, expected a number > 0'
with "fix x all particletemplate/sphere 15485917 density constant 1 radius constant -1" 'found -1'
with "fix x all particletemplate/sphere 15485917 density constant 1 radius constant" 'numbers is missing'
with "fix x all particletemplate/sphere 15485917 density constant 1 radius uniform number 1 x" \
	"'x' is not a number"
with "fix x all particletemplate/sphere 15485917 density constant 1 radius uniform 2 1" 'ascending'
with "fix x all particletemplate/sphere 15485917 density constant 1 radius gaussian 1 0.4" \
	'three deviations below the mean'
with "fix x all particletemplate/sphere 15485917 density constant 1 radius lognormal 1 -0.4" \
	'the deviation is -0.4'
with "fix x all particletemplate/sphere 15485917 atom_type 3 density constant 1 radius constant 1" \
	'there is no type 3'
with "fix x all particledistribution/discrete 32452883 2 small 0.3" 'expected 2 pairs'
with "fix x all particledistribution/discrete 32452883 2 small 0.3 small 0.7" 'named twice'
with "fix x all particledistribution/discrete 32452883 2 small 0.3 large -1" 'a number >= 0'
with "fix x all particledistribution/discrete 32452883 2 small 0 large 0" 'all weights are 0'
with "fix x all particledistribution/discrete 32452883 1 smal 1" "there is no fix 'smal'"
with "fix x all particledistribution/discrete 32452883 1 move 1" 'expected a particle template'
with "$pack region bed" '0 of particles_in_region'
with "$pack region bed particles_in_region 3 mass_in_region 1" '2 of particles_in_region'
with "${pack/once/never} region bed particles_in_region 3" "insert_every is 'never'"
with "${pack/template mix/template move} region bed particles_in_region 3" \
	'expected a fix particledistribution/discrete'
with "$pack vel uniform 1 2 3 region bed particles_in_region 3" 'fix insert/pack: vel'
with "$pack set_property a region bed particles_in_region 3" 'a name and a number'
with "$pack set_property a 1 region bed particles_in_region 3
run 1" "no fix property/atom gives particles 'a'"
with "$pack compress_tags yes region bed particles_in_region 3" 'not supported'
with "$pack start 0 region bed particles_in_region 3
run 1" 'start 0 is past'
with "region big block -0.1 1 0 0.8 0 0.9
$pack region big particles_in_region 3" 'from x = -0.1 to 1, beyond the fixed faces of the box at 0 and 1'
with "region open block 0 1 0 0.8 INF INF
$pack region open particles_in_region 3" 'region open is unbounded in z'
with "region thin block 0.1 0.15 0.1 0.8 0.1 0.9
$pack all_in yes region thin particles_in_region 3" 'so deep that the largest particle fits'
with "region egg ellipsoid 0.5 0.4 0.4 0.3 0.3 0.2
$pack all_in yes region egg particles_in_region 3" 'all_in yes is not possible'
with "variable s equal 0.1
region goes block 0 0.5 0 0.8 0 0.9 move v_s NULL NULL
$pack region goes particles_in_region 3" 'region goes moves'
rejects "dimension 2
boundary p p p
region box block 0 1 0 1 -0.1 0.1 units box
create_box 1 box
fix a all particletemplate/sphere 15485917 density constant 1 radius constant 0.1
fix b all particledistribution/discrete 32452883 1 a 1
fix c all insert/pack seed 32452867 distributiontemplate b insert_every once region box particles_in_region 3" \
	'works in three dimensions'

# A stream: with the speed v through the face a particle that begins z behind it is free in floor(z / v dt) steps,
# whatever pulls it; then it has the velocity asked for.
obj() { # FILE Z...: a triangle with its corners at these heights
	printf 'v 0.2 0.2 %s\nv 0.8 0.2 %s\nv 0.3 0.7 %s\nf 1 2 3\n' "$2" "$3" "$4" >"$1"
}
obj face.obj 0.6 0.6 0.6
printf 'v 0.8 0.2 0.6\nv 0.3 0.7 0.6\nv 0.8 0.7 0.5\nf 1 2 3\n' >second
cat face.obj second | sed '$s/1 2 3/4 5 6/' >bent.obj
flow="$scene
fix face all mesh/surface file face.obj type 1
fix pull all gravity 9.81 vector 1 0 0
fix pour all insert/stream seed 32452867 distributiontemplate mix insertion_face face"
prints "$flow vel constant 3 4 -20 omega constant 5 6 7 nparticles 30 particlerate 20000 extrude_length 0.2
run 1
variable way equal \$(z[1]:%.17g)-0.6
variable steps equal floor(v_way/(20*1e-5))
variable last equal v_steps-1
run \${last}
print \"on its way \$(vx[1]) \$(vz[1]) \$(omegax[1]) \$(abs(z[1]-0.6-v_way+20*1e-5*v_last)<1e-15)\"
run 1
print \"free \$(vx[1]) \$(vy[1]) \$(vz[1]) \$(omegaz[1]) \$(z[1]-0.6<20*1e-5)\"
run 1
print \"falls \$(abs(vx[1]-3-0.5e-5*9.81)<1e-14)\"
run 3000
print \"all \$(f_pour[1])\"" '*200.000000 particles every 1000 steps' '*30 particles (mass 2.472315e+01) within 0 steps' \
	'on its way -0 -20 0 1' 'free 3 4 -20 7 1' 'falls 1' 'all 30'

pours() { # WORDS TEXT
	rejects "$flow $1
run 2" "$2"
}
v='vel constant 0 0 -20'
pours "$v particlerate 100 extrude_length 0.2" 'one of nparticles and mass'
pours "$v nparticles 10 mass 3 particlerate 100 extrude_length 0.2" 'one of nparticles and mass'
pours "$v nparticles 10 extrude_length 0.2" 'one of particlerate and massrate'
pours "$v nparticles 10 particlerate 100 massrate 1 extrude_length 0.2" 'one of particlerate and massrate'
pours "$v nparticles 0.5 particlerate 100 extrude_length 0.2" "nparticles is '0.5', expected a number >= 1"
pours "$v mass -2 particlerate 100 extrude_length 0.2" "mass is '-2'"
pours "$v nparticles 10 particlerate 100" 'one of insert_every and extrude_length'
pours "$v nparticles 10 particlerate 100 insert_every 1000 extrude_length 0.2" 'one of insert_every and extrude_length'
pours "$v nparticles 10 particlerate 100 insert_every once" "insert_every is 'once'"
pours "$v nparticles 10 particlerate 100 insert_every 1000 duration 1001" 'a part of insert_every'
pours "$v nparticles 10 particlerate 100 insert_every 300" 'expected at least 0.097, two radii'
pours "$v nparticles 10 particlerate 100 extrude_length 0.1" 'expected at least 0.1455, three radii'
pours "$v nparticles 10 particlerate 100 extrude_length 0.7" '57% of the space behind the face'
pours 'vel constant 3 2 0 nparticles 10 particlerate 100 extrude_length 0.2' 'the velocity through the face is 0'
pours 'vel constant 0 0 -30000 nparticles 10 particlerate 100 extrude_length 0.2' 'particles move 0.3 in a step'
pours "${v} nparticles 10 particlerate 100 all_in yes extrude_length 0.2
unfix pour
unfix large
fix large all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.19
unfix mix
fix mix all particledistribution/discrete 32452843 1 large 1
fix pour all insert/stream seed 32452867 distributiontemplate mix insertion_face face vel constant 0 0 20 nparticles 10 particlerate 100000 all_in yes insert_every 2010" \
	'no point of the face is 0.19 from its edge'
flow=${flow/face.obj/bent.obj}
pours "$v nparticles 10 particlerate 100 extrude_length 0.2" 'mesh face is not plane: triangle 2'
flow=${flow/insertion_face face/insertion_face fase}
pours "$v nparticles 10 particlerate 100 extrude_length 0.2" "there is no mesh 'fase'"

# at a rate into a region, until a mass is there
prints "$scene
fix rain all insert/rate/region seed 32452867 distributiontemplate mix region bed mass 20 massrate 40000 insert_every 13
run 200
print \"rain \$(f_rain[1]) \$(abs(f_rain[2]-20)<1.2)\"" '*6.309876 particles every 13 steps' 'rain 24 1'
rejects "$scene
fix rain all insert/rate/region seed 32452867 distributiontemplate mix region bed mass 20 massrate 40000 insert_every once" \
	"insert_every is 'once'"

# Densely: the volume asked for, no overlaps, all of it in the region; what is there stays; in other lengths, too
dense='fix large all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant $(v_L*0.012) volume_limit 1e-40
fix small all particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius constant $(v_L*0.009) volume_limit 1e-40
fix mix all particledistribution/discrete 32452843 2 large 0.6 small 0.4
fix m1 all property/global kn peratomtypepair 1 1e3
fix m2 all property/global kt peratomtypepair 1 1e3
fix m3 all property/global gamman peratomtypepair 1 1
fix m4 all property/global gammat peratomtypepair 1 1
pair_style gran model hooke/stiffness
pair_coeff * *
compute touching all contacts
variable deep atom sqrt(x*x+y*y)+radius
variable high atom z+radius
variable low atom radius-z
compute most all reduce max v_deep v_high v_low
fix move all nve/sphere
timestep $(1e-5*v_L^1.5)'
for L in 1e-6 1 1000; do
	prints "units si
variable L equal $L
boundary f f f
region box block \$(-v_L*0.1) \$(v_L*0.1) \$(-v_L*0.1) \$(v_L*0.1) \$(-v_L*0.1) \$(v_L*0.1) units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
set group all diameter \$(v_L*0.05) density 2500
$dense
region drum cylinder z 0 0 \$(v_L*0.08) \$(-v_L*0.08) \$(v_L*0.08) volume_limit 1e-40 units box
fix fill all insert/pack/dense seed 32452867 distributiontemplate mix region drum volumefraction_region 0.5
run 0
run 1
print 'full \$(abs(mass(all)/2500/(PI*0.08^2*0.16*v_L^3)-0.5)<0.002) touching \$(c_touching) stayed \$(x[1]) \$(y[1])'
print 'inside \$(c_most[1]<=0.08*v_L) \$(c_most[2]<=0.08*v_L) \$(c_most[3]<=0.08*v_L) near \$(c_most[2]>0.0799*v_L)'
run 10
print 'once \$(f_fill[1]-count(all)+1)'" 'full 1 touching 0 stayed 0 0' 'inside 1 1 1 near 1' 'once 0'
done
fill='units si
variable L equal 1
boundary p p p
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 1 box
region whole block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
'"$dense
fix fill all insert/pack/dense seed 32452867 distributiontemplate mix region whole"
prints "$fill volumefraction_region 0.5 vel constant 0 0 2
run 1
print 'full \$(abs(mass(all)/2500/0.008-0.5)<0.002) touching \$(c_touching) \$(vcm(all,z):%.6g)'" 'full 1 touching 0 2'
rejects "$fill" "keyword 'volumefraction_region' is missing"
rejects "$fill volumefraction_region 0.8" 'volumefraction_region is 0.8'
rejects "$fill volumefraction_region 0.66 max_rounds 50
run 1" 'were not moved apart: after 50 rounds'
rejects "$fill volumefraction_region 0.5 all_in no" "unknown keyword 'all_in'"

# Clumps: a rigid one counts once, with the mass of its body, and is turned as asked.
stones="$scene
fix fall all multisphere
fix stone all particletemplate/multisphere 15485917 atom_type 1 density constant 2500 ntry 2000 nspheres 2 type 1 spheres"
clumps='fix clumps all particledistribution/discrete 32452883 1 stone 1
fix fill all insert/pack seed 32452867 distributiontemplate clumps insert_every once region bed particles_in_region 4'
prints "${stones/fix move all nve\/sphere/} 0 0 0 0.05 0.13 0 0 0.05
$clumps orientation constant 1 0 0 1 vel constant 0 0 1
run 1
print \"\$(count(all)) \$(f_fill[1]) \$(abs(mass(all)-f_fill[2])<1e-12) \$(abs(x[1]-x[2])<1e-15) \$(abs(y[2]-y[1]-0.13)<1e-15)\"" \
	'8 4 1 1 1'
printf '# two\n0 0 0 5\n13 0 0 5\n' >two.stone
prints "${stones/fix move all nve\/sphere/} file two.stone scale 0.01 mass 3 inertia_tensor 0.002 0 0 0.012 0 0.012 use_volume tflag off off on fflag on on off
$clumps vel constant 0.1 0 1 omega constant 1 2 3
compute e all erotate/multisphere
thermo_style custom step c_e
run 1
print \"\$(f_fill[2]) \$(z[1]-z[2])\"" '12 0'
rejects "$stones 0 0 0 0.05 0.13 0 0 0.05
fix clumps all particledistribution/discrete 32452883 1 stone 1
fix fill all insert/pack/dense seed 32452867 distributiontemplate clumps region bed volumefraction_region 0.3" 'spheres are packed, only'
stone() { # WORDS TEXT
	rejects "$stones $1" "$2"
}
stone '0 0 0 0.05 0.13 0 0' 'spheres has 7 numbers'
stone '0 0 0 0.05 0.13 0 0 x' "'x' is not a number"
stone '0 0 0 0.05 0.13 0 0 -1' 'the radius of sphere 2 is -1'
stone '0 0 0 0.05 0.13 0 0 0.05 scale 0' "scale is '0'"
stone '0 0 0 0.05 0.13 0 0 0.05 scale' "scale is '', expected a number"
stone '0 0 0 0.05 0.13 0 0 scale 2' 'spheres has 7 numbers'
stone '0 0 0 0.05 0.13 0 0 0.05 0.2' 'spheres has 9 numbers'
stone '0 0 0 0.05 0.13 0 0 0.05 scael 2' "unknown keyword 'scael'; did you mean 'scale'?"
stone 'file two.stone scale 0.01 grow 2' "unknown keyword 'grow'"
# Words of LIGGGHTS and its editions for bonds in a template: no bonds is what tsim does, others are named, with the place.
for words in 'bonded yes' 'bonded yes/explicit nbond_pairs 1 1 2' 'bonded yes/implicit bond_type 1' 'bond_type 1 bonded no' \
	'bonded no nbond_pairs 1 1 2'; do
	stone "file two.stone scale 0.01 $words" 'tsim does not have it: insert the spheres, then make the bonds: bond_style'
done
stone 'file two.stone scale 0.01 bonded yes/explicit' "bonded is 'yes/explicit', expected no; that one is known"
rejects "${stones% spheres} spheres_different_types file two.stone scale 0.01" "keyword 'spheres_different_types' is known"
prints "${stones/fix move all nve\/sphere/} file two.stone scale 0.01 bonded no
$clumps
run 1
print \"\$(count(all))\"" '8'
stone 'file nothing' 'nothing'
printf '0 0 0 5\n' >one.stone
stone 'file one.stone' 'the file ends after 1 spheres'
printf '0 0 0 5\n1 0 0\n' >one.stone
stone 'file one.stone' 'a sphere is a line x y z r'
stone '0 0 0 0.05 0.13 0 0 0.05 mass 3' 'mass and inertia_tensor are given together'
stone '0 0 0 0.05 0.13 0 0 0.05 mass 3 inertia_tensor 1 2 3 use_volume' 'the six numbers'
stone '0 0 0 0.05 0.13 0 0 0.05 mass 3 inertia_tensor 1 0 0 1 0 -1 use_volume' 'a principal moment of inertia is 0'
stone '0 0 0 0.05 0.13 0 0 0.05 fflag on off' 'on or off three times'
rejects "${stones/constant 2500 ntry/uniform 2500 2600 ntry} 0 0 0 0.05 0.13 0 0 0.05" 'expected density constant'
rejects "${stones/fix fall all multisphere/} 0 0 0 0.05 0.13 0 0 0.05
$clumps
run 1" 'need `fix ID all multisphere`'
rejects "$stones 0 0 0 0.05 0.13 0 0 0.05
$clumps orientation constant 1 2 3
run 1" 'four numbers'

# The volume of a region is that of its part in the box: 0.05 of it filled with spheres of the radius 0.02; one percent is three
# deviations of the integral by 100000 points.
unit='units si
boundary BOUNDARY
region box block 0 1 0 1 0 1 units box
create_box 1 box
timestep 1e-5
fix move all nve/sphere
fix one all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.02
fix mix all particledistribution/discrete 32452843 1 one 1
variable fill equal count(all)*4/3*PI*0.02^3'
pack='fix fill all insert/pack seed 32452867 distributiontemplate mix overlapcheck no'
for boundary in 'p p p' 'm m m'; do
	prints "${unit/BOUNDARY/$boundary}
region half block -1 1 0 1 0 1 units box
$pack insert_every once region half volumefraction_region 0.05
run 1
print \"half \$(abs(v_fill/0.05-1)<0.01)\"" 'half 1'
done
rejects "${unit/BOUNDARY/p p p}
region gone block 1.1 2 0 1 0 1 units box
$pack insert_every once region gone volumefraction_region 0.05" 'lies in it and in the simulation box'
# densely, all of it in the region and in the box
prints "${unit/BOUNDARY/p p p}
region half sphere 0 0.5 0.5 0.3 units box
fix fill all insert/pack/dense seed 32452867 distributiontemplate mix region half volumefraction_region 0.4
variable deep atom sqrt(x*x+(y-0.5)^2+(z-0.5)^2)+radius
compute deep all reduce max v_deep
thermo_style custom step c_deep
run 1
print \"dense \$(abs(v_fill/0.4/(2/3*PI*0.3^3)-1)<0.02) \$(bound(all,xmin)>=0.02) \$(c_deep<=0.3)\"" 'dense 1 1 1'

# it is that of the step of the insertion: of a region with a variable, in a box that has changed
prints "${unit/BOUNDARY/f f f}
variable R equal 0.2+0.02*step
region ball sphere 0.5 0.5 0.5 v_R units box
$pack insert_every 10 region ball volumefraction_region 0.1
run 11
print \"grown \$(abs(v_fill/(0.1*4/3*PI*v_R^3)-1)<0.02) \$(v_R:%.2f)\"" 'grown 1 0.42'
box_shrinks="$pack insert_every 10 region cube volumefraction_region 0.05
run 1
print \"first \$(abs(v_fill/0.05-1)<0.01)\"
delete_atoms group all
change_box all z final 0 0.5"
cube='region cube block 0 1 0 1 0 1 units box'
second='run 10
print "second $(abs(v_fill/0.025-1)<0.01) $(count(all)) $(xcm(all,x):%.17g) $(xcm(all,z):%.17g)"'
prints "${unit/BOUNDARY/p p p}
$cube
$box_shrinks
write_restart shrunk.restart
$second" 'first 1' '*second 1'
grep '^second' out >second
prints "read_restart shrunk.restart
${unit#*create_box 1 box}
$cube
$pack insert_every 10 region cube volumefraction_region 0.05
$second" "$(cat second)"
rejects "${unit/BOUNDARY/f f f}
$cube
$box_shrinks
run 10" 'region cube reaches from z = 0 to 1, beyond the fixed faces of the box at 0 and 0.5'
# where nothing more is inserted the region does not matter
prints "${unit/BOUNDARY/f f f}
$cube
${box_shrinks/insert_every 10/insert_every once}
run 10
print 'empty \$(count(all))'" 'empty 0'

# A rigid clump counts once, where the centre of its bounding sphere is, also beyond a periodic face: of four that are asked for one goes, and one
# comes; of more ten. Its volume is that of its spheres together, which nearly coincide: their sum is twice as large.
counts() { # TARGET SPHERES RESULT
	prints "${unit/BOUNDARY/p p p}
unfix move
unfix mix
fix stone all particletemplate/multisphere 15485917 atom_type 1 density constant 2500 ntry 20000 nspheres 2 type 1 spheres 0 0 0 0.03 0.002 0 0 0.03
fix mix all particledistribution/discrete 32452843 1 stone 1
fix clumps all multisphere
$cube
$pack insert_every 10 all_in yes region cube $1
run 1
variable before equal \$(count(all)/2)
displace_atoms all move 0 0 3 units box
run 10
variable same equal \$(count(all)/2-v_before)
group gone id 1:$2
delete_atoms group gone
run 10
print \"clumps $3\"" 'clumps 1 1 1'
}
counts 'particles_in_region 4' 2 '$(v_before==4) $(v_same==0) $(count(all)==8)'
counts 'volumefraction_region 0.005' 20 '$(v_before>=40) $(v_same<=1) $(abs(count(all)/2-v_before)<=1)'
counts 'mass_in_region 10' 20 '$(v_before>=30) $(v_same<=1) $(abs(count(all)/2-v_before)<=1)'

# numbers printed by LIGGGHTS
prints 'units si
boundary f f f
region box block 0 0.1 0 0.1 0 0.2 units box
create_box 1 box
timestep 1e-5
fix pull all gravity 9.81 vector 0 0 -1
fix stone all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 ntry 100000 spheres 0 0 0 0.004 0.005 0 0 0.003 0.002 0.004 0.001 0.003 type 1
fix mix all particledistribution/discrete 32452843 1 stone 1
fix move all multisphere
region sky block 0 0.1 0 0.1 0.1 0.2 units box
fix fill all insert/pack seed 32452867 distributiontemplate mix vel constant 0 0 -5 omega constant 10 20 30 orientation random insert_every 350 all_in yes region sky volumefraction_region 0.02
run 701' '*inserted 45 particle' '*inserted 9 particle' '*inserted 10 particle'

# No overlaps across periodic faces: with a particle that is beyond one until the next exchange, nor of spheres of clumps.
laws='fix m1 all property/global kn peratomtypepair 1 1e3
fix m2 all property/global kt peratomtypepair 1 1e3
fix m3 all property/global gamman peratomtypepair 1 1
fix m4 all property/global gammat peratomtypepair 1 1
pair_style gran model hooke/stiffness
pair_coeff * *
compute touching all contacts'
prints "${unit/BOUNDARY/p p p}
$laws
neighbor 0.08 bin
create_atoms 1 single 0.99 0.5 0.5 units box
set group all diameter 0.04 density 2500
velocity all set 10 0 0 units box
region near block 0.041 0.049 0.499 0.501 0.499 0.501 units box
${pack/overlapcheck no/overlapcheck yes} check_dist_from_subdomain_border no insert_every once start 300 region near particles_in_region 1
run 300
print \"beyond \$(count(all)) \$(abs(x[1]-floor(x[1])-0.02)<1e-9)\"" 'beyond 1 1'
for kind in 'multiplespheres 15485917' 'multisphere 15485917 type 1'; do
	mover=multisphere
	[ "$kind" = 'multiplespheres 15485917' ] && mover=nve/sphere
	prints "${unit/BOUNDARY/p p p}
$laws
unfix mix
unfix move
fix clumps all $mover
fix twin all particletemplate/$kind atom_type 1 density constant 2500 ntry 2000 nspheres 2 spheres 0 0 0 0.04 0.075 0 0 0.03
fix mix all particledistribution/discrete 32452843 1 twin 1
$cube
${pack/overlapcheck no/overlapcheck yes} maxattempt 100 check_dist_from_subdomain_border no orientation random insert_every once region cube particles_in_region 600
run 1
print \"twins \$(f_fill[1]>200) \$(c_touching)\"" 'twins 1 0'
done
finish
