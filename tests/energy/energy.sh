#!/bin/bash
# Potential energy: closed forms of each law, conservation, fix_modify energy, thermo keywords.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two spheres, R1 = 0.05, R2 = 0.08, overlap 0.003
head='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 2 single 0.627 0.5 0.5 units box
set type 1 diameter 0.1
set type 2 diameter 0.16
set group all density 2385
timestep 1e-5
thermo_modify norm no
variable delta equal 0.05+0.08-(0.627-0.5)
variable reff equal 0.05*0.08/0.13'
materials='fix m1 all property/global youngsModulus peratomtype 5e6 7e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix m5 all property/global characteristicVelocity scalar 2.
fix m6 all property/global cohesionEnergyDensity peratomtypepair 2 2385 2385 2385 2385
variable young equal 1/((1-0.45^2)/5e6+(1-0.3^2)/7e6)'
stored='compute stored all pe pair
compute each all pe/atom
compute half all reduce sum c_each
run 0
print "is stored $(c_stored) $(v_expected)"
print "is halves $(c_half) $(v_expected)"'

agree 'linear spring' "$head
pair_style spring/dashpot
pair_coeff * * stiffness 1234 restitution 0.5
variable expected equal 0.5*1234*v_delta^2
$stored"
agree 'Hertz' "$head
$materials
pair_style gran model hertz tangential history
pair_coeff * *
variable expected equal 8/15*v_young*sqrt(v_reff)*v_delta^2.5
$stored"
agree 'hooke of LIGGGHTS' "$head
$materials
pair_style gran model hooke
pair_coeff * *
variable mass equal 1/(1/mass(one)+1/mass(two))
group one type 1
group two type 2
variable root equal sqrt(v_reff)
variable k equal 16/15*v_root*v_young*(15*v_mass*4/(16*v_root*v_young))^0.2
variable expected equal 0.5*v_k*v_delta^2
$stored"
# The pull integrated over the overlap: of sjkr2 4 pi k R* delta, of sjkr the area of the cut.
agree 'sjkr2' "$head
$materials
pair_style gran model hertz cohesion sjkr2
pair_coeff * *
variable expected equal 8/15*v_young*sqrt(v_reff)*v_delta^2.5-2385*2*PI*v_reff*v_delta^2
$stored"
agree 'sjkr' "$head
$materials
pair_style gran model hertz cohesion sjkr
pair_coeff * *
variable r equal 0.127
variable expected equal 8/15*v_young*sqrt(v_reff)*v_delta^2.5-2385*PI/4*((0.13^2+0.03^2)*v_delta-(0.13^3-v_r^3)/3+0.13^2*0.03^2*(1/0.13-1/v_r))
compute stored all pe
run 0
print 'is stored \$(c_stored) \$(v_expected)'"
agree 'Hertz of LAMMPS' "$head
pair_style gran/hertz/history 1e6 NULL 50 NULL 0.5 0
pair_coeff * *
variable expected equal 0.4*1e6*sqrt(v_reff)*v_delta^2.5
$stored"
agree 'across a face' "units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.02 0.5 0.5 units box
create_atoms 1 single 0.95 0.5 0.5 units box
set group all diameter 0.1 density 2385
timestep 1e-5
thermo_modify norm no
pair_style spring/dashpot
pair_coeff * * stiffness 1234 restitution 0.5
variable expected equal 0.5*1234*0.03^2
$stored
print 'is epair \$(epair) \$(v_expected)'
print 'is evdwl \$(evdwl) \$(v_expected)'
thermo_modify norm yes
print 'is one \$(pe) \$(v_expected/2)'
print 'is enthalpy \$(enthalpy) \$((v_expected+press)/2)'"

# The spring of slip: sticks at constant overlap, F_t = -k_t xi, so its energy is F_t^2/(2 k_t).
agree 'spring of slip' "$head
$materials
pair_style gran model hooke/stiffness tangential history
fix m7 all property/global kn peratomtypepair 2 9000 9000 9000 9000
fix m8 all property/global kt peratomtypepair 2 700 700 700 700
fix m9 all property/global gamman peratomtypepair 2 0 0 0 0
fix m10 all property/global gammat peratomtypepair 2 0 0 0 0
pair_coeff * *
group one type 1
group two type 2
fix hold two move linear 0 0 0
fix pull one move linear 0 0.05 0
run 100
compute f one reduce sum fx
compute g one reduce sum fy
compute stored all pe
variable far equal sqrt((0.127)^2+(100*1e-5*0.05)^2)
compute d all pair/local dist
compute dm all reduce max c_d
variable fn equal 9000*(0.13-c_dm)
variable ft equal sqrt(c_f^2+c_g^2-v_fn^2)
run 0
print 'is slip \$(c_stored) \$(0.5*v_fn^2/9000+0.5*v_ft^2/700)'"

agree 'bonds' "$head
bond_style contact
bond_coeff 1 stiffness 4321 ultimate 1e9
create_bonds single/bond 1 1 2
set atom 2 x 0.6275
compute stored all pe bond
compute none all pe pair
run 0
print 'is bond \$(c_stored) \$(0.5*4321*(0.6275-0.627)^2)'
print 'is emol \$(emol) \$(ebond)'
print 'is nothing \$(c_none) 0'"

# Nothing is lost: Hertz without damping and friction in free fall, velocity Verlet of second order.
cat >in.fall <<END
$head
${materials//0.9/1.0}
pair_style gran model hertz
pair_coeff * *
set type 1 vx 0.3
fix move all nve/sphere
fix fall all gravity 9.81 vector 0.3 0 -1
fix_modify fall energy yes
timestep 1e-6
run 0
variable before equal \$(etotal)
run 20000
print "is kept \$(abs(etotal/v_before-1)<1e-6) 1"
print "is parted \$(epair) 0"
print "is whole \$(etotal) \$(pe+ke)"
print "is fall \$(pe-epair) \$(f_fall)"
print "is height \$(f_fall) \$(-9.81/sqrt(1.09)*(0.3*xcm(all,x)-xcm(all,z))*mass(all))"
fix_modify fall energy no dynamic/dof yes respa 1 virial no
print "is without \$(pe) 0"
END
agree 'energy is conserved' "$(cat in.fall)"
agree 'springs and forces of fixes' "$head
fix tow all spring tether 25 0.5 0.5 0.4 0.0
fix push all addforce 0 0 2.5
fix_modify tow energy yes
fix_modify push energy yes
run 0
print 'is both \$(pe) \$(f_tow+f_push)'"

rejects "$head
$materials
fix m11 all property/global kn2kcMax peratomtypepair 2 0.1 0.1 0.1 0.1
pair_style gran model hooke/hysteresis
fix m7 all property/global coefficientMaxElasticStiffness peratomtypepair 2 2 2 2 2
fix m8 all property/global coefficientAdhesionStiffness peratomtypepair 2 0.1 0.1 0.1 0.1
fix m9 all property/global coefficientPlasticityDepth peratomtypepair 2 0.1 0.1 0.1 0.1
pair_coeff * *
thermo_style custom step pe
run 0" 'models hooke/hysteresis and edinburgh have no potential energy'
prints "$head
fix still all freeze
fix_modify still energy yes" '*`energy yes` has no effect: fix freeze has no potential energy that could be counted'
rejects "$head
fix fall all gravity 9.81 vector 0 0 -1
fix_modify fall virial yes" 'pressures are of contacts, bonds and motion'
rejects "$head
fix fall all gravity 9.81 vector 0 0 -1
fix_modify fall energie yes" "fix gravity has no word 'energie'; did you mean 'energy'?"
rejects "$head
fix fall all gravity 9.81 vector 0 0 -1
fix_modify fall energy maybe" "found 'maybe', expected yes or no"
rejects "$head
fix fall all gravity 9.81 vector 0 0 -1
fix_modify fall energy" 'energy lacks its value'
rejects "$head
group one type 1
compute stored one pe" 'the group must be all'
rejects "$head
compute stored all pe pear" "did you mean 'pair'"

prints "$head
thermo_style custom step cu ecouple econserve timeremain ecoul elong etail eangle edihed eimp angles dihedrals impropers
run 0" '*TimeoutLeft' '*Impros'
# The table of a continuation is appended to that of before.
for name in books.txt books.csv; do
	books="pair_style none
fix move all nve/sphere
fix books all energy/ledger every 2 append $name"
	prints "$head
$books
run 4
write_restart books.restart
clear
units si
boundary f f f
read_restart books.restart
timestep 1e-5
$books
run 4" '*Loop time'
	[ "$(awk '/^[0-9]/ { print $1 + 0 }' "$name" | tr '\n' ' ')" = '0 2 4 6 8 ' ]
	report "a table that is appended to: $name" $? "$name"
done
rejects "$head
fix books all energy/ledger every 2 append a.txt file b.txt" 'found both'
finish
