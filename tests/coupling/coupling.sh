#!/bin/bash
# Particles and fluid: refusals and warnings, limits of the step, known forces.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# ---- refusals
periodic='units si
boundary p p p
newton off
communicate single vel yes'
head="$periodic
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.01 density 2385"
still="$head
flow_style uniform velocity 0.5 0 0 viscosity 1e-3 density 1000"
solved="$head
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000"
rejects "$head
fix d all drag/wen_yu void 0.5" 'fix drag/wen_yu needs a fluid: use flow_style before it'
rejects "$still
fix d all drag/gidaspow" 'needs the void fraction: put a fix void_fraction before it'
rejects "$solved
fix d all drag/beetstra" 'needs the void fraction: put a fix void_fraction before it'
rejects "$still
fix e all void_fraction" 'needs a fluid that is solved for'
rejects "$still
fix p all flow/pressure_gradient" 'needs a fluid that is solved for'
rejects "$still
fix T all flow/scalar" 'needs a fluid that is solved for'
rejects "$solved
fix T all flow/scalar xlo value 3" 'the grid is periodic there, it has no face xlo'
rejects "$solved
fix T all flow/scalar xlo valve 3" "'valve'"
rejects "$solved
fix T all flow/scalar conductivity 1 exchange ranz_marshall" 'exchange needs particles with temperatures'
rejects "$head
flow_style uniform velocity 0 0 0 viscosity 1e-3
fix d all drag/schiller_naumann" 'needs a fluid with a density'
rejects "$head
flow_style uniform velocity 0 0 0 viscosity 0 density 1
fix d all drag/schiller_naumann" 'needs a fluid with a viscosity'
rejects "$still
fix d all drag/koch_hill void 1.3" 'void'
rejects "$solved
fix e all void_fraction reach 0" 'reach'
rejects "$still
fix a all added_mass
fix b all added_mass coefficient 0.1" 'fix a (in.script:10) gives particles of this group an added mass'
rejects "$still
create_atoms 1 single 0.5 0.5 0.505 units box
set group all diameter 0.01 density 2385
fix a all added_mass
fix m all rigid single
timestep 1e-3
run 1" 'belongs to a rigid body'
# what acts when all forces are known
"$TSIM" -explain -in <(printf '%s\n' "$still
fix a all added_mass
fix d all drag/stokes scheme exact
fix x all drag/stokes
fix g all addforce 0 0 1
fix m all nve
timestep 1e-3
run 1") -log none >out 2>&1
grep -q 'POST_FORCE  *added_mass:a drag/stokes:d drag/stokes:x addforce:g then drag/stokes:d then added_mass:a$' out
report 'the plan says who acts last' $? out

# ---- without particles; where the fluid or the void fraction goes
empty='units si
boundary p p f
newton off
communicate single vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 8 8 viscosity 1 density 1000
fix e all void_fraction
fix d all drag/wen_yu scheme exact
fix l all lift/magnus
fix s all lift/saffman
fix a all added_mass
fix p all flow/pressure_gradient
fix T all flow/scalar initial 3 conductivity 1
fix m all nve/sphere
timestep 1e-4
run 3'
agree 'no particles' "$empty
print 'is void \$(f_e[1]) 1'
print 'is drag \$(f_d[1]) 0'
print 'is heat \$(f_T[1]/3000) 1'"
agree 'no void fraction any more' "$empty
unfix d
unfix a
unfix p
unfix e
run 2
print 'is heat \$(f_T[1]/3000) 1'"
agree 'another grid' "$empty
flow_style none
flow_style projection cells 4 4 4 viscosity 1 density 1000
run 2
print 'is void \$(f_e[1]) 1'
print 'is heat \$(f_T[1]/3000) 1'"
rejects "$empty
flow_style none
flow_style projection cells 4 4 4 viscosity 1 density 1000
print \"\$(f_e[1])\"" 'the flow style has been replaced'
rejects "$empty
flow_style none
flow_style projection cells 4 4 4 viscosity 1 density 1000
print \"\$(f_T[1])\"" 'the flow style has been replaced'
# a fluid that has moved, or has got its faces, is not replaced without a word
rejects "$empty
flow_style projection cells 4 4 4 viscosity 1 density 1000" 'has moved in a run; another flow_style would begin at rest'
rejects "$empty
flow_style uniform velocity 0 0 0 viscosity 1 density 1000" 'the fluid of line 7 has moved in a run'
faces="${head/boundary p p p/boundary f p p}
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet"
rejects "$faces
flow_style projection cells 8 8 8 viscosity 2e-3 density 1000" \
	'would drop the flow_boundary of line 10, which belongs to the fluid of line 9'
agree 'a fluid before its faces' "$solved
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000
timestep 1e-3
run 1
print 'is done 1 1'"
for mode in '' -check; do
	printf '%s\n' "$empty
flow_style projection cells 4 4 4 viscosity 1 density 1000" >in.script
	! "$TSIM" $mode -in in.script -log none >out 2>&1 && shows 'has moved in a run' out
	report "a second fluid $mode" $? out
done
# the grid does not follow the box
deforms='fix squeeze all deform 1 x erate -0.1'
rejects "$solved
$deforms" 'the grid of the fluid (flow_style, line 9) does not change with the box'
rejects "$head
$deforms
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000
timestep 1e-3
run 1" 'does not change with the box'
agree 'a box that changes before there is a fluid' "$head
$deforms
timestep 1e-3
run 1
unfix squeeze
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000
run 1
print 'is done 1 1'"
# buoyancy counts once
heavy="${head/boundary p p p/boundary p p f}
fix g all gravity 9.81 vector 0 0 -1
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000"
pressure='fix p all flow/pressure_gradient'
buoyancy='fix b all buoyancy level 1 dim z density 1000'
go='fix m all nve
timestep 1e-4
run 1'
rejects "$heavy body_force 0 0 -9.81
$pressure
$buoyancy
$go" 'acts on the particles by fix flow/pressure_gradient (line 11)'
rejects "$heavy body_force 0 0 -9.81
$buoyancy
$pressure
$go" 'buoyancy would count twice'
rejects "variable g equal -9.81
$heavy body_force 0 0 v_g
$buoyancy
$pressure
$go" 'buoyancy would count twice'
agree 'buoyancy by one of the two' "$heavy body_force 0 0 -9.81
$pressure
fix m all nve
timestep 1e-4
run 4
print 'is pressed \$(f_p[3]) \$(9810*PI/6*1e-6)'
clear
$heavy
$pressure
$buoyancy
$go
print 'is both \$(f_p[3]+f_b[3]) \$(9810*PI/6*1e-6)'
clear
$heavy body_force 0.1 0 0
$pressure
$buoyancy
$go
print 'is lifted \$(f_b[3]) \$(9810*PI/6*1e-6)'
clear
${heavy/boundary p p f/boundary p p p} body_force 0 0 -9.81
$pressure
$buoyancy
$go
print 'is lifted \$(f_b[3]) \$(9810*PI/6*1e-6)'"
# who leaves a grid of a region is told, once in a run
for fluid in 'fix d all drag/stokes scheme exact' 'fix l all lift/saffman'; do
	prints "$head
region low block 0 1 0 1 0 0.5 units box
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000 region low
$fluid
velocity all set 0 0 1
create_atoms 1 single 0.7 0.5 0.1 units box
set group all diameter 0.01 density 2385
fix m all nve
timestep 1e-3
run 3
run 2" '*at step 1 1 of its particles are outside the grid' '*(particle 1 at 0.5 0.5 0.501' \
		'Up to 1 particles were outside the grid of the fluid, in 3 steps'
	[ "$(grep -c 'are outside the grid' out)" = 2 ]
	report 'once in a run' $? out
done
rejects "$empty
unfix e
run 1" 'needs the void fraction'

# ---- light or dense particles, whose acceleration the fluid learns a step later: told at both sides of the density at which
# the amplitudes of |z| = 1 for phi = pi/6, in a fluid of 1000. Without added mass it is 1000 phi/(1 - phi) = 1099.07; with it
# that where the recurrence (m + A) b = -G + A a, f = A (a - b), a' = -r b, G' = -rho a' - r f neither grows nor decays.
crowded="$periodic
region box block 0 8 0 8 0 8 units box
create_box 1 box
lattice sc 1 origin 0.5 0.5 0.5
create_atoms 1 box
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000
timestep 1e-4"
pair='fix e all void_fraction
fix p all flow/pressure_gradient'
# lags WHAT DENSITY REMEDY LINES: a warning with the remedy below the density, none above it
lags() {
	local what=$1 remedy=$3 by ok
	for by in 0.999 1.001; do
		printf '%s\n' "$crowded" "set group all diameter 1 density \$($by*$2)" "$4" 'run 0' >in.script
		"$TSIM" -in in.script -log none >out 2>&1
		ok=$?
		if [ $by = 0.999 ]; then
			grep -q "warning: perhaps no time step is stable with fix .*0.52 of the cell at .*: $remedy\$" out || ok=1
		else
			! grep -q 'no time step is stable' out || ok=1
		fi
		report "$what, $by" $ok out
	done
}
lags 'light particles' 1099.071 'use fix added_mass with `fluid_acceleration no`' "$pair"
lags 'with added mass' 1168.215 'leave out fix added_mass' "$pair
fix a all added_mass"
lags 'in a fluid that is regarded as steady' 599.112 'use heavier particles, or resolved ones (fix immersed/boundary)' "$pair
fix a all added_mass fluid_acceleration no"
lags 'without its reaction' 1148.646 'leave out fix added_mass' "$pair
fix a all added_mass two_way no"
# of two kinds of particles the mean counts, of held ones nothing; where there is room the lightest one is stable
mixed="$crowded
set group all diameter 1 density 1200
group light id <> 1 40
set group light density 500
$pair"
prints "$mixed
run 0" '*perhaps no time step is stable'
for calm in "$mixed
fix hold light freeze" "${mixed/set group light density 500/set atom 1 density 500}" "${mixed/group all diameter 1/group all diameter 0.5}" \
	"${mixed/fix e all void_fraction/}"; do
	printf '%s\n' "$calm" 'run 0' >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && ! grep -q 'no time step is stable' out
	report 'no word about others' $? out
done
# inserted later, with the step
prints "$periodic
region box block 0 8 0 8 0 8 units box
create_box 1 box
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000
$pair
fix m all nve/sphere
fix k all particletemplate/sphere 3571 atom_type 1 density constant 50 radius constant 0.5
fix d all particledistribution/discrete 3571 1 k 1.0
fix i all insert/pack seed 3571 distributiontemplate d insert_every once vel constant 0 0 0 overlapcheck yes volumefraction_region 0.2 region box
timestep 1e-6
run 3" '*perhaps no time step is stable with fix flow/pressure_gradient on particles of density 50'
# the pressure counts once
rejects "$crowded
set group all diameter 0.5 density 1200
$pair
fix q all flow/pressure_gradient" 'the pressure acts on particles of this group by fix p (in.script:13) already'
agree 'the pressure on two groups' "$crowded
set group all diameter 0.5 density 2400
group low id <> 1 40
group high subtract all low
fix p low flow/pressure_gradient
fix q high flow/pressure_gradient
run 0
print 'is done 1 1'"

# ---- limits: explicit drag is stable below 2 tau, tau = rho d^2/(18 mu); also where slip grows in the run
rejects "$still
fix d all drag/stokes
fix m all nve
timestep 26.6
run 1" 'exceeds the stability limit 26.5 of explicit fix drag/stokes, 2 tau'
rejects "$still
create_atoms 1 single 0.5 0.5 0.505 units box
set group all diameter 0.01 density 2385
fix d all drag/stokes scheme exact
fix m all rigid single
timestep 26.6
run 1" 'limit 26.5 of fix drag/stokes on members of rigid bodies, whose drag is explicit, 2 tau'
prints "$still
fix d all drag/stokes
fix m all nve
timestep 26.6
run 0 unsafe yes" '*exceeds the stability limit 26.5 of explicit fix drag/stokes'
rejects "$head
flow_style uniform velocity 0.5 0 0 viscosity 1e-3 density 1e5
fix d all drag/schiller_naumann
fix g all addforce -5 0 0
fix m all nve
timestep 9e-4
run 1000" 'the explicit drag is stable for steps below twice that'
prints "$solved
set group all diameter 0.3
fix d all drag/schiller_naumann
fix m all nve
timestep 1e-4
run 1" '*cells of the fluid are down to 0.125 wide and particles up to 0.3'
prints "$solved
set group all diameter 0.16
fix e all void_fraction method divided least 0.9
fix m all nve
timestep 1e-4
run 3" '*below `least` 0.9, which is used instead (printed once)'
[ "$(grep -c 'below .least' out)" = 1 ]
report 'said once' $? out

# ---- the grid and the size of particles: all of a particle in one cell that is narrower than it; a kernel that lies
# in one cell; the same in micrometres
for unit in 1 1e-6; do
	sized="units si
boundary p p p
newton off
communicate single vel yes
region box block 0 $unit 0 $unit 0 $unit units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
flow_style projection cells 8 8 8 viscosity 1e-3 density 1000
set group all density 2385
timestep 1e-16"
	rejects "$sized
set group all diameter \$(0.1251*$unit)
fix e all void_fraction method centre
run 1" 'fix void_fraction: method centre puts all of a particle into one cell'
	prints "$sized
set group all diameter \$(0.1249*$unit)
fix e all void_fraction method centre
run 1
print went" 'went'
	prints "$sized
set group all diameter \$(0.1*$unit)
fix e all void_fraction method centre
run 1
print 'was \$(f_e[2]:%.2f)'" 'was 0.73'
	prints "$sized
set group all diameter \$(0.0624*$unit)
fix e all void_fraction method kernel
run 1
run 1" '*do not resolve the kernel' '*2 diameters of the largest particle'
	[ "$(grep -c 'do not resolve' out)" = 1 ]
	report "told once, lengths of $unit" $? out
	for method in divided 'kernel reach 2.1'; do
		prints "$sized
set group all diameter \$(0.0624*$unit)
fix e all void_fraction method $method
run 1
print went" 'went'
		! grep -q 'do not resolve' out
		report "no word about $method, lengths of $unit" $? out
	done
done

# ---- momentum of particles and fluid in a periodic box: the figures of doc/coupling.md
crowd='units si
boundary p p p
newton off
communicate single vel yes
region box block 0 0.004 0 0.004 0 0.004 units box
create_box 1 box
create_atoms 1 random 200 2385 box
set group all diameter 0.0003 density 2385
flow_style projection cells 4 4 4 viscosity 1e-3 density 1000
pressure_style cg tolerance 1e-13
velocity all ramp vy 0 0.02 z 0 0.004 units box
velocity all set 0.1 0 0 sum yes'
sums='fix m all nve
timestep 1e-4
compute f0 all flow/flux x 0
compute f1 all flow/flux x 0.001
compute f2 all flow/flux x 0.002
compute f3 all flow/flux x 0.003
compute fx all reduce sum fx
variable P equal mass(all)*vcm(all,x)+0.5*dt*c_fx+c_f0+c_f1+c_f2+c_f3
run 2
variable before equal $(v_P)
run 100'
agree 'momentum by drag alone' "$crowd
fix d all drag/stokes scheme exact
$sums
print 'is kept \$(v_P) \$(v_before)'"
prints "$crowd
fix e all void_fraction
fix p all flow/pressure_gradient
fix d all drag/di_felice scheme exact
$sums
print 'drift \$(v_P/v_before-1:%.2g)'" 'drift -0.0018'

# ---- forces
# what no fix moves holds the fluid as what is frozen does, whatever the scheme: steps of 8 relaxation times
for way in 'scheme explicit|fix hold all freeze' 'scheme exact|fix hold all freeze' 'scheme exact|' 'scheme implicit|' 'scheme explicit|' \
	'scheme exact|fix hold all move linear 0 0 0' 'scheme exact|fix hold all nve/noforce'; do
	printf '%s\n' "$head" 'flow_style projection cells 8 8 8 viscosity 1 density 1000' 'flow_set velocity 0.5 0 0' \
		"fix d all drag/stokes ${way%%|*}" "${way#*|}" 'timestep 0.1' 'run 5' 'print "force $(f_d[1]:%.12g) $(flow_px:%.12g)"' >in.held
	"$TSIM" -in in.held -log none 2>&1 </dev/null | grep '^force [0-9.e-]* 4[0-9.]*$' || echo "$way"
done >held
uniq held | wc -l >lines
[ "$(wc -l <held)" = 7 ] && [ "$(cat lines)" -eq 1 ]
report 'what is held, in any way' $? held

agree 'laws in a uniform flow' "$still
variable w equal 0.5
variable mu equal 1e-3
variable rho equal 1000
variable d equal 0.01
variable v equal PI/6*v_d^3
variable Re equal v_rho*v_w*v_d/v_mu
fix d all drag/stokes
run 0
print 'is stokes \$(f_d[1]) \$(3*PI*v_mu*v_d*v_w)'
fix d all drag/stokes axes yz
run 0
print 'is axes \$(f_d[1]) 0'
unfix d
fix d all drag/schiller_naumann
run 0
print 'is schiller_naumann \$(f_d[1]) \$(PI/8*v_d^2*0.44*v_rho*v_w^2)'
print 'is Re \$(f_d[4]/5000) 1'
unfix d
fix d all drag/ergun void 0.43
run 0
print 'is ergun \$(f_d[1]) \$(v_v*(150*0.57*v_mu/(0.43*v_d^2)+1.75*v_rho*v_w/v_d)*v_w)'
fix d all drag/ergun void 0.43 C1 180 C2 0
run 0
print 'is carman \$(f_d[1]) \$(v_v*180*0.57*v_mu/(0.43*v_d^2)*v_w)'
unfix d
fix d all drag/wen_yu void 0.83
run 0
print 'is wen_yu \$(f_d[1]) \$(0.75*v_v*0.44*0.83*v_rho*v_w/v_d*0.83^(-2.65)*v_w)'
unfix d
fix d all drag/gidaspow void 0.83
run 0
print 'is gidaspow \$(f_d[1]) \$(0.75*v_v*0.44*0.83*v_rho*v_w/v_d*0.83^(-2.65)*v_w)'"
# a disc is a row of 3/(2 d) spheres per depth: forces by volume are those of a sphere, whatever the unit of length
disc="${still/boundary p p p/dimension 2
boundary p p p}"
disc="${disc/0 1 units box/-0.5 0.5 units box}"
disc="${disc/0.5 0.5 0.5 units/0.5 0.5 0 units}"
agree 'laws for a disc' "$disc
variable w equal 0.5
variable mu equal 1e-3
variable d equal 0.01
variable n equal 1.5/v_d
fix d all drag/stokes
run 0
print 'is stokes \$(f_d[1]) \$(v_n*3*PI*v_mu*v_d*v_w)'
print 'is relaxation \$(mass[1]*v_w/f_d[1]) \$(2385*v_d^2/18/v_mu)'
unfix d
fix d all drag/ergun void 0.43
run 0
print 'is ergun \$(f_d[1]) \$(PI/4*v_d^2*(150*0.57*v_mu/(0.43*v_d^2)+1.75*1000*v_w/v_d)*v_w)'
unfix d
set atom 1 omega 0 0 7.3
fix l all lift/magnus law rubinow
fix m all nve/sphere
run 0
print 'is lift \$(f_l[2]) \$(-v_n*PI/8*1000*v_d^3*7.3*v_w)'
variable t atom tqz
compute t all reduce sum v_t
print 'is torque \$(c_t) \$(-v_n*PI*v_mu*v_d^3*7.3)'"
rejects "$disc
fix d all drag/stokes
fix m all nve
timestep 26.6
run 1" 'exceeds the stability limit 26.5 of explicit fix drag/stokes, 2 tau'
# spin: Rubinow and Keller, and Kirchhoff's torque
agree 'spin' "$still
set atom 1 omega 0 0 7.3
fix l all lift/magnus law rubinow
fix m all nve/sphere
run 0
print 'is lift \$(f_l[2]) \$(-PI/8*1000*0.01^3*7.3*0.5)'
variable t atom tqz
compute t all reduce sum v_t
print 'is torque \$(c_t) \$(-PI*1e-3*0.01^3*7.3)'"
# shear: a wall moves past another one; Saffman's lift, and none without shear
agree 'shear' "units si
boundary p p f
newton off
communicate single vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.43 0.57 0.41 units box
set group all diameter 0.01 density 2385
variable zz internal 0
variable u equal 2.385*v_zz
flow_style projection cells 4 4 8 viscosity 1e-3 density 1000
flow_boundary zhi wall velocity 2.385 0 0
flow_set velocity v_u 0 0 set z zz
velocity all set 0.5 0 0
fix l all lift/saffman law saffman two_way no
timestep 1e-6
run 0
print 'is lift \$(f_l[3]) \$(1.615*0.01^2*sqrt(1000*1e-3*2.385)*(2.385*0.41-0.5))'
print 'is across \$(f_l[1]) 0'"
# the fluid's weight is in its pressure: a particle is lifted by what it displaces
agree 'buoyancy' "units si
boundary p p f
newton off
communicate single vel yes
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.43 0.57 0.03 units box
create_atoms 1 single 0.23 0.17 0.73 units box
set group all diameter 0.01 density 2385
flow_style projection cells 4 4 8 viscosity 1e-3 density 731 body_force 0 0 -9.81
fix b all flow/pressure_gradient
timestep 1e-3
run 2
print 'is lift \$(f_b[3]) \$(2*731*9.81*PI/6*0.01^3)'"
# C rho V more of inertia
agree 'added mass' "$still
fix f all addforce 0 0 0.37
fix a all added_mass
fix m all nve
timestep 1e-3
run 1
print 'is acceleration \$(fz[1]/mass[1]) \$(0.37/(PI/6*0.01^3*(2385+500)))'"

# ---- between runs: the void fraction goes with its fix; forces near edges do not depend on how a run is cut
rejects "$solved
fix a all void_fraction
fix b all void_fraction" 'there is one already, fix a'
prints 'units si
atom_style sphere
newton off
communicate single vel yes
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single .3 .4 .5 units box
set group all diameter .2 density 2
velocity all set 1 0 0
flow_style projection cells 8 8 8 viscosity 0.01 density 1
fix e all void_fraction
fix mv all nve/sphere
compute q all flow/probe .3 .4 .5 .7 .4 .5 values void vx
timestep 0.001
run 1
print "there $(c_q[1][1]<0.99)"
unfix e
run 2
print "gone $(c_q[1][1]) $(c_q[2][1])"
fix e all void_fraction method kernel
run 1
print "no burst $(abs(c_q[1][2])+abs(c_q[2][2])<1e-12)"' 'there 1' 'gone 1 1' 'no burst 1'
for runs in 'run 4' 'run 3
run 1'; do
	echo "units si
atom_style sphere
newton off
communicate single vel yes
boundary f f p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.93 0.91 0.5 units box
set group all diameter 0.02 density 1
flow_style projection cells 4 4 4 viscosity 0.01 density 1
flow_boundary xhi wall velocity 0 1 0
fix l all lift/saffman law saffman two_way no
fix m all added_mass two_way no
timestep 0.01
$runs
print 'forces \$(f_l[1]) \$(f_l[2]) \$(f_m[1]) \$(f_m[2])'" >in.script
	"$TSIM" -in in.script -log none 2>&1 | grep '^forces' >"forces.${#runs}"
done
same 'forces in the corner of a cavity, the run whole and in two' forces.5 forces.11
finish
