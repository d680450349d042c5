#!/bin/bash
# A jet from a nozzle: when particles leave, where they are then, how much has come; directions and speeds; what is
# full and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# scene TEMPLATE: a box with particles of this radius, mixed
scene() {
	printf '%s\n' 'variable from index none' 'units si' 'atom_style granular' 'boundary f f f' \
		'region box block -1 1 -1 1 -1 1 units box' \
		'if "${from} == none" then "create_box 1 box" else "read_restart ${from}"' \
		"fix one all particletemplate/sphere 15485863 atom_type 1 density constant 1000 radius $1" \
		'fix mix all particledistribution/discrete 32452843 1 one 1.0' \
		'fix move all nve/sphere' 'timestep 1e-3'
}
jet='fix jet all insert/jet seed 86028121 distributiontemplate mix position 0 0.1 0.9 direction 0 0 -2.385'
point="$jet diameter 0 overlapcheck no speed constant"

# One particle in many steps, many in one step, several steps at once: the k-th leaves after (k - 1/2) / rate, and all fly
# on with their velocity since.
for case in '1 31 100 17 1' '2 2310 0.7 12 3' '3 310 1.3 49 7'; do
	set -- $case
	agree "leaves at its time, case $1" "$(scene 'constant 0.01')
$point $3 nparticles INF particlerate $2 insert_every $5
variable n equal f_jet[1]
variable y equal y[1]
run $4
print 'is number \${n} $(awk -v r="$2" -v n="$4" -v e="$5" 'BEGIN { print int(r * (n - n % e) * 1e-3 + 0.5) }')'
variable z1 equal z[1]
variable z2 equal z[\${n}]
print 'is aside \${y} 0.1'
print 'is first \${z1} \$(0.9-$3*(time-0.5/$2))'
print 'is last \${z2} \$(0.9-$3*(time-(v_n-0.5)/$2))'
variable energy equal f_jet[3]-ke
print 'is energy \${energy} 0 \$(ke)'
variable age equal f_jet[4]
print 'is age \${age} \$(time)'"
done

# With sizes spread over a decade the mass is that of the rate to the largest particle, in every step.
mass=$(scene 'lognormal 0.01 0.375')
prints "$mass
$point 1.3 mass INF massrate 2.385 cone uniform 10
variable off equal abs(f_jet[2]-2.385*time)*1e9
fix most all ave/time 1 1 1 v_off mode scalar file off.txt
variable largest equal 1000*4*PI/3*(0.01*exp(3*0.375))^3
run 500
print \"few \$(f_jet[1]<2.385*0.5/v_largest*30) off \$(abs(f_jet[2]-2.385*time)<=v_largest)\"" 'few 1 off 1'
awk '!/^#/ && $2 > 1e9 * 1000 * 4 * 3.14159265358979 / 3 * (0.01 * exp(3 * 0.375))^3 { bad = 1 } END { exit bad || NR < 400 }' off.txt
report 'mass in every step' $? off.txt

# A change of the rate, and of the step, from one run to the next
agree 'another step' "$(scene 'constant 0.01')
$point 1.3 nparticles INF particlerate 310
run 20
timestep 3.1e-4
run 100
variable n equal f_jet[1]
variable z equal z[\${n}]
print 'is number \${n} $(awk 'BEGIN { print int(310 * 0.051 + 0.5) }')'
print 'is last \${z} \$(0.9-1.3*(0.051-(v_n-0.5)/310))'"

# When it ends: a number, a mass to half a particle, a time; when it begins
m=$(awk 'BEGIN { printf "%.15g", 1000 * 4 * 3.14159265358979324 / 3 * 1e-6 }')
for case in 'nparticles 7 particlerate 310:7' "mass $(awk -v m="$m" 'BEGIN { print 7.4 * m }') particlerate 310:7" \
	"mass $(awk -v m="$m" 'BEGIN { print 7.6 * m }') massrate 1:8" 'time 0.0219 particlerate 310:7' \
	'time 0.5 nparticles 5 particlerate 310:5' 'nparticles INF particlerate 310 start 80:7'; do
	prints "$(scene 'constant 0.01')
$point 1.3 ${case%:*}
run 100
print \"number \$(f_jet[1]) of \$(count(all))\"" "number ${case#*:} of ${case#*:}"
done
# the last particles of a jet that ends within a step flew on since
agree 'closed' "$(scene 'constant 0.01')
$point 0.9 time 0.0105 particlerate 3100 insert_every 20
run 20
variable n equal f_jet[1]
variable z equal z[\${n}]
print 'is number \${n} 33'
print 'is last \${z} \$(0.9-0.9*(time-32.5/3100))'"

# Directions and speeds: bounds, and means to four standard errors. Of a uniform cone the cosine is uniform.
sample() { # CONE SPEED
	scene 'constant 0.001 volume_limit 1e-18'
	echo "$jet diameter 0.2 inner_diameter 0.15 overlapcheck no $1 speed $2 nparticles 20000 particlerate 2e7
compute speed all property/atom vx vy vz
variable v atom sqrt(vx^2+vy^2+vz^2)
variable c atom -vz/v_v
variable t atom acos(-vz/v_v)*180/PI
variable r atom sqrt((x-vx*(time-(id-0.5)/2e7))^2+(y-0.1-vy*(time-(id-0.5)/2e7))^2)
variable r2 atom v_r^2
compute mean all reduce ave v_v v_c v_r2 vx vy
compute least all reduce min v_v v_t v_r
compute most all reduce max v_v v_t v_r
thermo_style custom step c_mean[1] c_least[1] c_most[1]
run 1"
}
prints "$(sample 'cone uniform 25' 'uniform 1 3')
print \"within \$(c_most[2]<=25) wide \$(c_most[2]>24.9) ring \$(c_least[3]>=0.075-1e-12) \$(c_most[3]<=0.1+1e-12)\"
print \"cosine \$(abs(c_mean[2]-(1+cos(25*PI/180))/2)<4*(1-cos(25*PI/180))/sqrt(12*20000))\"
print \"area \$(abs(c_mean[3]-(0.1^2+0.075^2)/2)<4*(0.1^2-0.075^2)/sqrt(12*20000))\"
print \"speed \$(abs(c_mean[1]-2)<4*2/sqrt(12*20000)) \$(c_least[1]>=1) \$(c_most[1]<=3)\"
print \"round \$(abs(c_mean[4])<4*2*0.31/sqrt(20000)) \$(abs(c_mean[5])<4*2*0.31/sqrt(20000))\"" \
	'within 1 wide 1 ring 1 1' 'cosine 1' 'area 1' 'speed 1 1 1' 'round 1 1'
prints "$(sample 'cone gaussian 5' 'gaussian 2 0.2')
print \"within \$(c_most[2]<=15) \$(c_most[2]>14) speed \$(c_least[1]>=1.4) \$(c_most[1]<=2.6)\"
print \"mean \$(abs(c_mean[1]-2)<4*0.2/sqrt(20000))\"" 'within 1 1 speed 1 1' 'mean 1'
prints "$(sample 'cone linear 5' 'constant 2')
variable off atom v_c-1/sqrt(1+(v_r/0.1*tan(5*PI/180))^2)
compute off all reduce max v_off
thermo_style custom step c_off
run 0
print \"linear \$(abs(c_off)<1e-12) \$(c_most[2]<=5+1e-9)\"" 'linear 1 1'

# all_in keeps particles off the edges
prints "$(scene 'constant 0.01')
$jet diameter 0.2 inner_diameter 0.1 all_in yes overlapcheck no speed constant 1 nparticles 500 particlerate 1e6
variable r atom sqrt(x^2+(y-0.1)^2)
compute least all reduce min v_r
compute most all reduce max v_r
thermo_style custom step c_least c_most
run 1
print \"all \$(count(all)) \$(c_least>=0.06-1e-12) \$(c_most<=0.09+1e-12)\"" 'all 500 1 1'

# A dense jet: nothing overlaps, and no mass is lost while particles wait for room.
contact='fix m1 all property/global kn peratomtypepair 1 1e3
fix m2 all property/global kt peratomtypepair 1 1e3
fix m3 all property/global gamman peratomtypepair 1 1
fix m4 all property/global gammat peratomtypepair 1 1
pair_style gran model hooke/stiffness
pair_coeff * *
compute touching all contact/atom
compute sum all reduce sum c_touching
variable touched equal c_sum
fix ever all ave/time 1 100 100 c_sum
thermo_style custom step atoms c_sum'
prints "$(scene 'constant 0.01')
$contact
$jet diameter 0.2 speed constant 3 nparticles INF particlerate 4000
run 100
print \"touching \$(f_ever) number \$(f_jet[1])\"" 'touching 0 number 400'
prints "$(scene 'constant 0.01')
$contact
$jet diameter 0.05 speed constant 3 nparticles INF particlerate 4000 maxattempt 3
run 100
print \"touching \$(f_ever) fewer \$(f_jet[1]<400)\"
unfix jet" 'touching 0 fewer 1' '*no place for a particle in step' '*Particles fill 2.8 of the volume of the jet'

# across a periodic face
prints "$(scene 'constant 0.01' | sed 's/boundary f f f/boundary p p f/')
$contact
fix jet all insert/jet seed 86028121 distributiontemplate mix position 1 -1 0.9 direction 0 0 -1 diameter 0.2 speed &
	constant 3 nparticles INF particlerate 4000
run 100
print \"touching \$(f_ever) number \$(f_jet[1]) of \$(count(all))\"" 'touching 0 number 400 of 400'

# angular velocity and properties; forces act from the first step on
prints "$(scene 'constant 0.01')
fix heat all property/atom heat scalar yes no no 293.5
fix g all gravity 9.81 vector 0 0 -1
$point 1 omega constant 1 2 3 set_property heat 350.25 nparticles 1 particlerate 1000
compute heat all reduce sum f_heat
thermo_style custom step c_heat
run 1
print \"heat \$(c_heat) turns \$(omegay[1]) falls \$(abs(vz[1]+1+0.5e-3*9.81)<1e-15)\"" 'heat 350.25 turns 2 falls 1'

# Clumps: rigid bodies of two spheres, each counted once, with the mass of the template; a cut run goes on as the whole.
clumps="$(scene 'constant 0.01' | grep -v -e 'fix one' -e 'nve/sphere')
fix one all particletemplate/multisphere 15485863 atom_type 1 density constant 2385 nspheres 2 ntry 20000 &
	spheres 0 0 0 0.02  0.03 0 0 0.015 type 1
fix turn all multisphere"
clumps=$(echo "$clumps" | awk '/^fix mix/ { keep = $0; next } { print } END { print keep }')
prints "$clumps
$jet diameter 0.5 speed gaussian 3 0.3 cone uniform 5 orientation random nparticles INF particlerate 300
run 200
print \"clumps \$(f_jet[1]) of \$(count(all)) \$(abs(mass(all)/f_jet[2]-1)<1e-12) \$(abs(ke/f_jet[3]-1)<1e-12)\"" \
	'clumps 60 of 120 1 1'
printf '%s\n' "$clumps" "$jet diameter 0.5 speed gaussian 3 0.3 cone uniform 5 orientation random nparticles INF &
	particlerate 300 insert_every 3" 'run ${steps} upto' 'write_restart ${out}' >in.clumps
"$TSIM" -in in.clumps -var steps 200 -var out whole -log none >out 2>&1 &&
	"$TSIM" -in in.clumps -var steps 101 -var out cut -log none >>out 2>&1 &&
	"$TSIM" -in in.clumps -var from cut -var steps 200 -var out part -log none >>out 2>&1
report 'clumps, cut' $? out
same 'clumps, cut run' whole part

# ---- refusals
with() { # ARGUMENTS... TEXT
	rejects "$(scene 'constant 0.01')
fix jet all insert/jet seed 86028121 distributiontemplate mix $1
run 1" "$2"
}
all='position 0 0.1 0.9 direction 0 0 -1 diameter 0.1 speed constant 1 nparticles 5 particlerate 10'
with "${all/0 0 -1/0 0 0}" 'direction is 0 0 0, expected a vector along the jet'
with "${all/constant 1/constant -1}" 'speed: found -1, expected a number > 0'
with "${all/constant 1/gaussian 1 0.4}" 'three deviations below the mean are -0.2'
with "${all/constant 1/uniform 2 1}" 'expected an ascending range'
with "${all/0.1 speed/0.01 all_in yes speed}" 'has no room for particles, wholly within it, of radius 0.01'
with "$all inner_diameter 0.2" 'inner diameter 0.2 has no room'
with "$all cone round 5" "'round'"
with "$all cone uniform 95" '95'
with "${all/diameter 0.1/diameter 0} cone linear 5" 'a linear cone needs a diameter > 0'
with "$all insert_every once" "insert_every is 'once'"
with "$all massrate 10" 'expected one of particlerate and massrate'
with "${all/nparticles 5/}" 'expected one of nparticles and mass'
with "$all mass 3" 'expected one of nparticles and mass'
with "$all time 0" 'time is 0'
with "${all/0.1 0.9/0.1 1.9}" 'the nozzle is at z = 1.9, outside the box, which reaches from -1 to 1'
finish
