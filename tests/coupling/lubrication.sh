#!/bin/bash
# fix lubrication: the squeeze solution, forces against their formulas, conservation, limits of the step, refusals, periodic
# faces, units, threads, restart. The law itself: tests/law/check_lubrication.c.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# ---- squeeze: m (v - v0) + F t + 6 pi mu R^2 ln(h/h0) = 0, and with little inertia h = h0 exp(-F t/(6 pi mu R^2))

# fall UNITS LENGTH MASS TIME: a grain of 0.27 um pushed by 0.01 nN onto a plane in water, in um, pg, us times the factors
fall() {
	cat <<END
units $1
boundary f f f
newton off
communicate single vel yes
variable L equal $2
variable M equal $3
variable T equal $4
region box block \$(-2*v_L) \$(2*v_L) \$(-2*v_L) \$(2*v_L) 0 \$(4*v_L) units box
create_box 1 box
create_atoms 1 single 0 0 \$(0.29*v_L) units box
set type 1 diameter \$(0.54*v_L) density \$(2.5*v_M/v_L^3)
fix m1 all property/global youngsModulus peratomtype \$(5e3*v_M/v_L/v_T^2)
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix layer all lubrication viscosity \$(v_M/v_L/v_T) inner \$(0.005*v_L) outer \$(0.1*v_L) walls floor
fix move all nve/sphere
variable F equal \$(0.01*v_M*v_L/v_T^2)
fix push all addforce 0 0 -\${F}
variable k equal 6*PI*v_M/v_L/v_T*(0.27*v_L)^2
variable h equal z[1]-0.27*v_L
velocity all set 0 0 \$(-0.02*v_L*v_F/v_k) units box
variable m equal mass(all)
timestep \$(1e-3*v_T)
thermo 1000000
run 80000
variable t equal step*dt
variable expected equal 0.02*v_L*exp(-v_F*v_t/v_k)
variable integral equal v_m*(vz[1]+0.02*v_L*v_F/v_k)+v_F*v_t+v_k*ln(v_h/0.02/v_L)
print "gap \$(v_h/v_L:%.9g)"
print "exponential \$(abs(v_h/v_expected-1)<2e-5) integral \$(abs(v_integral)<1e-5*v_F*v_t) fell \$(v_h<0.7*0.02*v_L)"
END
}
prints "$(fall micro 1 1 1)" 'exponential 1 integral 1 fell 1'
grep ^gap out >gap.micro
prints "$(fall si 1e-6 1e-15 1e-6)" 'exponential 1 integral 1 fell 1'
grep ^gap out >gap.si
prints "$(fall cgs 1e-4 1e-12 1e-6)" 'exponential 1 integral 1 fell 1'
grep ^gap out >gap.cgs
same 'micro and si' gap.micro gap.si
same 'cgs and si' gap.cgs gap.si

# ---- two spheres, without a pair style

# spheres GAP BOUNDARY: radii 0.3 and 0.5 at the ends of a gap along x
spheres() {
	cat <<END
units si
boundary $2
newton off
communicate single vel yes
region box block -3 3 -3 3 -3 3 units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single \$(0.8+$1) 0 0 units box
set type 1 diameter 0.6 density 2000
set type 2 diameter 1.0 density 3000
group one id 1
group two id 2
variable a equal 0.3
variable b equal 0.5
variable g equal $1
variable r equal v_a*v_b/(v_a+v_b)
variable mu equal 7.0
variable m1 equal mass(one)
variable m2 equal mass(two)
variable h equal sqrt((x[2]-x[1])^2+(y[2]-y[1])^2)-0.8
timestep 1e-5
thermo 100000
END
}
layers='fix layers all lubrication viscosity 7 inner 1e-3 outer 0.2
fix move all nve/sphere'
formulas='variable l equal ln(v_a/v_g)
variable A equal 1.6*PI*v_mu*v_r*v_l*(2-3*v_a*v_b/(v_a+v_b)^2)
variable B equal 2.4*PI*v_mu*v_r^2*v_l*(v_a-v_b)/(v_a+v_b)
variable C equal 4.8*PI*v_mu*v_r^3*v_l
variable tqz atom tqz'
agree 'squeeze and slip' "$(spheres 0.01 'f f f')
$layers
velocity one set 0.4 0.3 0 units box
run 0
$formulas
print 'is squeeze \$(fx[1]/1:%.13g) \$(-6*PI*v_mu*v_r^2/v_g*0.4:%.13g)'
print 'is slip \$(fy[1]:%.13g) \$(-v_A*0.3:%.13g)'
print 'is torque \$(v_tqz[1]:%.13g) \$(-((v_a+v_g/2)*v_A+v_B)*0.3:%.13g)'
print 'is other \$(v_tqz[2]:%.13g) \$(-((v_b+v_g/2)*v_A-v_B)*0.3:%.13g)'
print 'is opposite \$(fx[2]) \$(-fx[1])'
print 'is opposite \$(fy[2]) \$(-fy[1])'
print 'is gap \$(f_layers[1]) 0.01'
print 'is step \$(f_layers[2]:%.13g) \$(2/(6*PI*v_mu*v_r^2/v_g*(1/v_m1+1/v_m2)):%.13g)'"
agree 'below the inner gap' "$(spheres 1e-5 'f f f')
$layers
velocity one set 0.4 0 0 units box
run 0
print 'is squeeze \$(fx[1]:%.13g) \$(-6*PI*v_mu*v_r^2/1e-3*0.4:%.13g)'"
agree 'beyond the outer gap' "$(spheres 0.2001 'f f f')
$layers
velocity one set 0.4 0.3 0 units box
run 0
print 'is squeeze \$(fx[1]) 0'
print 'is gap \$(f_layers[1]>1e300) 1'"
agree 'one of them is not in the group' "$(spheres 0.01 'f f f')
fix layers one lubrication viscosity 7 inner 1e-3 outer 0.2
velocity one set 0.4 0.3 0 units box
run 0
print 'is squeeze \$(fx[1]) 0'"
agree 'a pair that is excluded' "$(spheres 0.01 'f f f')
neigh_modify exclude type 1 2
$layers
velocity one set 0.4 0.3 0 units box
run 0
print 'is squeeze \$(fx[1]) 0'"
agree 'two of them add up' "$(spheres 0.01 'f f f')
$layers
fix more all lubrication viscosity 2 inner 1e-3 outer 0.3
velocity one set 0.4 0 0 units box
run 0
print 'is squeeze \$(fx[1]:%.13g) \$(-6*PI*9*v_r^2/v_g*0.4:%.13g)'"
# the gap is larger than the skin and reaches across a periodic face
agree 'a periodic face' "$(spheres 0.15 'p p p')
$layers
neighbor 0.02 bin
displace_atoms all move 2.6 0 0 units box
velocity one set 0.4 0 0 units box
run 0
print 'is squeeze \$(fx[1]:%.10g) \$(-6*PI*v_mu*v_r^2/v_g*0.4:%.10g)'
print 'is wrapped \$(x[2]<0) 1'"
# free motion: nothing is lost, and m* (v - v0) + 6 pi mu R^2 ln(h/h0) = 0 without rotation
free="fix layers all lubrication viscosity 7 inner 1e-3 outer 0.2
fix move all nve/sphere"
prints "$(spheres 0.02 'f f f')
$free
velocity one set 0.3 0.2 0 units box
velocity two set 0 -0.7 0 units box
set group one omegaz 2.3
set group two omegaz -1.1
variable w atom omegaz
variable i1 equal 0.4*v_m1*v_a^2
variable i2 equal 0.4*v_m2*v_b^2
variable px equal v_m1*vx[1]+v_m2*vx[2]
variable py equal v_m1*vy[1]+v_m2*vy[2]
variable lz equal v_m1*(x[1]*vy[1]-y[1]*vx[1])+v_m2*(x[2]*vy[2]-y[2]*vx[2])+v_i1*v_w[1]+v_i2*v_w[2]
variable px0 equal \${px}
variable py0 equal \${py}
variable lz0 equal \${lz}
run 5000
variable off equal abs(v_px-v_px0)+abs(v_py-v_py0)
print 'momentum \$(v_off<1e-10*abs(v_py0)) angular \$(abs(v_lz-v_lz0)<1e-10*abs(v_lz0)) turned \$(abs(v_w[1]-2.3)>0.01)'" \
	'momentum 1 angular 1 turned 1'
prints "$(spheres 0.02 'f f f')
$free
velocity one set 0.3 0 0 units box
run 5000
variable i equal v_m1*v_m2/(v_m1+v_m2)*(vx[2]-vx[1]+0.3)+6*PI*v_mu*v_r^2*ln(v_h/0.02)
print 'integral \$(abs(v_i)<1e-4*6*PI*v_mu*v_r^2) nearer \$(v_h<0.0199)'" 'integral 1 nearer 1'

# ---- planes that move
wall() { # WORDS
	spheres 0.3 'f f f'
	echo "displace_atoms two move 0 1 1 units box
pair_style gran model hooke tangential off
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix m5 all property/global characteristicVelocity scalar 1
pair_coeff * *
fix w all wall/gran model hooke tangential off primitive type 1 $1"
}
plane='fix layers all lubrication viscosity 7 inner 1e-3 outer 0.2 walls w
fix move all nve/sphere'
agree 'a plane that slides' "$(wall 'zplane -0.32 shear x 0.7')
$plane
run 0
variable tqy atom tqy
print 'is slip \$(fx[1]:%.12g) \$(3.2*PI*7*0.3*ln(0.3/0.02)*0.7:%.12g)'
print 'is torque \$(v_tqy[1]:%.12g) \$((-0.31*3.2*0.3+2.4*0.3^2)*PI*7*ln(0.3/0.02)*0.7:%.12g)'"
agree 'between two planes, on either side' "$(wall 'yplane -0.32 0.34 velocity 0 0 0.7')
$plane
velocity one set 0 0.4 0 units box
run 0
print 'is squeeze \$(fy[1]:%.12g) \$(-6*PI*7*0.3^2*(1/0.02+1/0.04)*0.4:%.12g)'
print 'is slip \$(fz[1]:%.12g) \$(3.2*PI*7*0.3*ln(0.3/0.02*0.3/0.04)*0.7:%.12g)'"
agree 'a plane that swings' "$(wall 'zplane -0.32 wiggle z 0.001 0.04')
fix layers all lubrication viscosity 7 inner 1e-3 outer 0.2 walls w
run 1000
print 'is squeeze \$(fz[1]:%.9g) \$(6*PI*7*0.3^2/(0.02-0.001)*0.001*PI/0.02:%.9g)'"

# ---- the step: 2 m h/(6 pi mu R^2) is the limit
thick=${plane/viscosity 7/viscosity 700}
step() { # FACTOR STEPS
	wall 'zplane -0.32'
	echo "$thick
velocity one set 0 0 1e-6 units box
timestep \$($1*2*v_m1*0.02/(6*PI*700*0.3^2))
run $2"
}
prints "$(step 0.99 1000)
print 'decayed \$(abs(vz[1])<1e-13)'" 'decayed 1'
rejects "$(step 1.01 1)" 'of fix lubrication, 2/rate of the present layers, smallest gap 0.02'
prints "$(step 0.3 1)" '*exceeds the recommended limit' '*of fix lubrication, 2/rate of a layer with the gap inner, 0.001'
rejects "$(wall 'zplane -0.32')
$thick
velocity one set 0 0 -0.5 units box
fix push one addforce 0 0 -50000
timestep 0.003
run 100" 'exceeds the stability limit'
shows 'fix lubrication: at step' err
report 'it is the layer that stops the run' $? err

# ---- refusals
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 1 inner 0.2 outer 0.1" 'outer is 0.1, expected more than inner, 0.2'
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 0 inner 0.01 outer 0.1" 'viscosity'
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 1 outer 0.1" 'inner'
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 1 inner 0.01 outer 0.1 walls v" "there is no fix 'v'"
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 1 inner 0.01 outer 0.1 walls m1" 'fix m1 is no wall'
rejects "$(wall 'zplane -0.32')
fix f all lubrication viscosity 1 inner 0.01 outer 0.1 walls w w" 'the wall w is given twice'
rejects "$(wall 'zcylinder 2 0 0')
fix f all lubrication viscosity 1 inner 0.01 outer 0.1 walls w" 'the wall w is not made of planes'
rejects "$(wall 'zplane -0.32 impact exact')
fix f all lubrication viscosity 1 inner 0.01 outer 0.1 walls w" 'the wall w has `impact exact`'
rejects "$(spheres 0.01 'f f f')
$layers
unfix move
fix r all rigid single
run 1" 'belongs to a rigid body'

# ---- threads and restart of a crowd
cat >in.crowd <<END
package omp \${threads} grain 1
include $top_srcdir/tests/decks/in.lubrication
END
for t in 1 2 3; do
	mkdir "t$t"
	{ cat in.crowd; echo 'run 600'; } >"t$t/in"
	(cd "t$t" && "$TSIM" -in in -log log -screen none -var threads $t) >out 2>&1
	report "$t threads" $? out
done
for t in 2 3; do
	same "forces on $t threads" t1/600.txt t$t/600.txt
	rows "t$t/log" >"rows.$t"
	rows t1/log >rows.1
	same "tables on $t threads" rows.1 "rows.$t"
done
mkdir again
{ cat in.crowd; echo 'run 330'; echo 'write_restart saved'; } >again/in
{
	echo 'read_restart saved'
	grep -E '^(fix|pair_|timestep|neighbor|thermo|dump|newton|communicate)' "$top_srcdir/tests/decks/in.lubrication"
	echo 'run 270'
} >again/in.on
(cd again && "$TSIM" -in in -log none -screen none -var threads 1 && "$TSIM" -in in.on -log none -screen none) >out 2>&1
report 'restart' $? out
same 'restart' t1/600.txt again/600.txt
finish
