#!/bin/bash
# Walls: motion of their surfaces, temperature, the force on each particle, two planes, what is refused, cuts by
# restart files.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A sphere at rest that touches a wall with dashpots only: its force is - gamma_n v_n n - gamma_t v_t, times its
# mass, of the velocity against the surface.
cat >in.sphere <<'END'
units si
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0.31 0.25 0.07 units box
set type 1 diameter 0.2 density 1000
variable m equal mass(all)
fix kn all property/global kn peratomtypepair 1 1e-13
fix kt all property/global kt peratomtypepair 1 1e-13
fix gn all property/global gamman peratomtypepair 1 50
fix gt all property/global gammat peratomtypepair 1 20
fix mu all property/global coefficientFriction peratomtypepair 1 1e22
variable law string "model hooke/stiffness tangential no_history primitive type 1"
timestep 1e-6
END
# moves WALL FX FY FZ: by mass and 20, to the precision of a speed of 1.3
moves() {
	agree "$1" "include in.sphere
fix w all wall/gran $1
run 0
print \"is fx \$(fx[1]/v_m/20) \$($2) 1.3\"
print \"is fy \$(fy[1]/v_m/20) \$($3) 1.3\"
print \"is fz \$(fz[1]/v_m/20) \$($4) 1.3\""
}
law='model hooke/stiffness tangential no_history primitive type 1'
moves "$law zplane 0.0 shear x 1.3" 1.3 0 0
moves "$law zplane 0.1 shear y -1.3" 0 -1.3 0
moves "$law zplane 0.0 velocity 1.3 0.7 0" 1.3 0.7 0
# turning about z and about y: 1.3 a x d
moves "$law zcylinder 0.45 0.0 0.0 shear x 1.3" -1.3*0.25 1.3*0.31 0
moves "$law zcylinder 0.45 0.01 -0.02 shear y 1.3" -1.3*0.27 1.3*0.3 0
moves "$law zcylinder 0.45 0.0 0.0 shear z 1.3" 0 0 1.3
moves "$law ycylinder 0.3 0.0 0.0 shear x 1.3" '1.3*0.07' 0 '-1.3*0.31'
# LAMMPS' laws, gamma_t 20: the speed is 1.3, with the clock
v='sqrt(0.25^2+0.31^2)'
moves 'hooke 1 NULL 50 20 10000 1 zcylinder 0.45 shear x 1.3' \
	"1.3*0.25/$v-($v-0.35)*0.31/$v/20/v_m" "-1.3*0.31/$v-($v-0.35)*0.25/$v/20/v_m" 0

# wiggle: A (1 - cos wt) from the definition on; also where the wall alone makes the contact
agree wiggle 'include in.sphere
set atom 1 vx 0 vy 0 vz 0
fix hold all setforce NULL NULL NULL
unfix kn
fix kn all property/global kn peratomtypepair 1 1000
unfix gn
fix gn all property/global gamman peratomtypepair 1 0
neighbor 0.001 bin
timestep 0.001
fix early all wall/gran model hooke/stiffness tangential no_history primitive type 1 zplane -0.05 wiggle z 0.04 0.02
run 5
print "is half $(fz[1]:%.13g) $(1000*(0.1-0.07-0.05+0.04):%.13g)"
run 5
print "is top $(fz[1]:%.13g) $(1000*(0.1-0.07-0.05+0.08):%.13g)"
run 10
print "is back $(fz[1]) 0"'

agree 'two planes, either may be absent' 'include in.sphere
unfix kn
fix kn all property/global kn peratomtypepair 1 1000
fix w all wall/gran ${law} zplane 0.0 0.15
run 0
print "is both $(fz[1]:%.13g) $(1000*(0.03-0.02):%.13g)"
fix w all wall/gran ${law} zplane NULL 0.15
run 0
print "is upper $(fz[1]:%.13g) -20"
fix w all wall/gran ${law} zplane 0.0 NULL
run 0
print "is lower $(fz[1]:%.13g) 30"
fix w all wall/gran ${law} zplane NULL NULL
run 0
print "is none $(fz[1]) 0"'

agree 'the force on each particle' 'include in.sphere
unfix kn
fix kn all property/global kn peratomtypepair 1 1000
create_atoms 1 single -0.31 0.25 0.08 units box
create_atoms 1 single -0.31 -0.25 0.18 units box
set type 1 diameter 0.2 density 1000
set atom 2 vx 0.1
fix w all wall/gran ${law} zplane 0.0 store_force yes
fix g all gravity 9.81 vector 0 0 -1
run 0
variable z1 atom (id==1)*f_force_w[3]
variable x2 atom (id==2)*f_force_w[1]
compute s all reduce sum v_z1 v_x2 f_force_w[3]
print "is z1 $(c_s[1]:%.13g) 30"
print "is x2 $(c_s[2]:%.13g) $(-20*0.1*v_m/3:%.13g)"
print "is all $(c_s[3]:%.13g) $(30+20:%.13g)"
print "is wall $(-f_w[3]:%.13g) 50"'

# heat: h = 4 k k_w/(k + k_w) sqrt(A)
# warms WORDS AREA
warms() {
	agree "temperature: $1" "include in.sphere
fix k all property/global thermalConductivity peratomtype 43 17
fix c all property/global thermalCapacity peratomtype 490 800
create_atoms 1 single -0.31 0.25 0.08 units box
set type 1 diameter 0.2 density 1000
group held id 2
fix w all wall/gran hooke 1 NULL 50 20 0.5 1 type 2 zplane 0.0 temperature 400 $1
fix hold held freeze
fix heat all heat/gran initial_temperature 300 store_contact_data yes
timestep 0.1
run 1 unsafe yes
compute q all reduce sum f_wallHeatFlux
compute T all reduce max f_Temp
variable h1 equal 4*43*17/60*sqrt($2)
variable h2 equal 4*43*17/60*sqrt($3)
print \"is q \$(c_q/1e3:%.15g) \$((v_h1+v_h2)/10:%.15g)\"
print \"is T \$(c_T:%.15g) \$(300+100*v_h1*0.1/(v_m/2)/490:%.15g)\""
}
warms '' 'PI*(0.1^2-0.07^2)' 'PI*(0.1^2-0.08^2)'
warms 'contact_area constant 0.002385' 0.002385 0.002385
warms 'contact_area projection' 'PI*0.1^2' 'PI*0.1^2'
prints 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 temperature 300
run 0' '*the temperature has no effect without fix heat/gran'
printf '%s\n' 'include in.sphere' 'fix w all wall/gran ${law} zplane 0.0 temperature 300' 'run 2' >in.once
"$TSIM" -in in.once -log none >out 2>&1
[ "$(grep -c 'the temperature has no effect' out)" = 1 ]
report 'it warns of the temperature once in a run' $? out
prints 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 shear z 1
run 0' '*a shear along the normal moves no plane'

rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 shear w 1' "shear is along 'w', expected x, y or z"
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 shear x' 'shear takes a dimension and a velocity'
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 shear x fast' "found 'fast'"
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 wiggle z NULL 0.1' "found 'NULL'"
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 wiggle z' "found 'z'"
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 wiggle x 1' 'wiggle takes a dimension, an amplitude and a period'
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 wiggle x 1 0' 'the period of wiggle must be > 0'
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 wiggle x 1 1 shear y 1' 'either wiggle or shear'
rejects 'include in.sphere
fix w all wall/gran ${law} zplane 0.0 1.0 2.0' 'zplane takes one position, or two'
rejects 'include in.sphere
fix w all wall/gran ${law} zplane low' "found 'low'"
rejects 'include in.sphere
fix w all wall/gran ${law} zcylinder 1 2' 'a radius and the centre'
rejects 'include in.sphere
fix w all wall/gran ${law} zcylinder -1' 'the radius of a cylinder must be > 0'
rejects 'include in.sphere
fix w all wall/gran hooke 1 NULL 1 NULL 0.5 1 hertz/history 1 NULL 1 NULL 0.5 1 zplane 0' 'another law'
rejects 'include in.sphere
fix w all wall/gran hooke 1 NULL 1 NULL 0.5 zplane 0' 'dampflag'
rejects 'include in.sphere
fix w all wall/gran model hooke/stiffness primitive zplane 0' 'which `type`?'
finish
