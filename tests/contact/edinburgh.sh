#!/bin/bash
# Model edinburgh, elasto-plastic contacts with adhesion, by exact numbers: loading, unloading, adhesion, loading again, walls,
# units, a run cut while contacts adhere, and what is refused. The numbers of LIGGGHTS: tests/crosscheck/edinburgh.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

law='model edinburgh tangential history'
materials() { # N CHI KAPPA W F0
	echo "fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
fix e1 all property/global overlapExponent scalar $1
fix e2 all property/global adhesionExponent scalar $2
fix e3 all property/global UnloadingStiffness peratomtypepair 2 $3 $3 $3 $3
fix e4 all property/global surfaceEnergy peratomtypepair 2 $4 $4 $4 $4
fix e5 all property/global pullOffForce peratomtypepair 2 $5 $5 $5 $5"
}
start='units si
atom_style granular
atom_modify map array
newton off
communicate single vel yes
boundary f f f
region box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box
create_box 2 box
neighbor 0.002 bin'
# Two spheres of R = 5 and 3 mm; the second one is led: `overlap D` puts it there.
pair() {
	echo "$start
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.008 0 0 units box
set atom 1 diameter 0.01 density 2500
set atom 2 diameter 0.006 density 2500
$(materials "$@")
pair_style gran $law
pair_coeff * *
fix move all nve/noforce
timestep 1e-6
thermo 100000
variable Y equal 5e6/(2*(1-0.3^2))
variable R equal 0.005*0.003/0.008
variable n equal $1
variable c equal $2
variable k equal $3
variable w equal $4
variable o equal $5
variable k1 equal $([ "$1" = 1 ] && echo '2*v_R*v_Y' || echo '4/3*v_Y*sqrt(v_R)')
variable k2 equal v_k*v_k1"
}
overlap() { printf 'set atom 2 x %s vx 0\nrun 1\n' "\$(0.008-($1))"; } # of which `run` computes the force
# d_p of the largest overlap v_m, the circle at d_p, the pull-off force, k_a
exact='variable p equal (1-1/v_k)*v_m^v_n
variable dp equal v_p^(1/v_n)
variable s equal 0.008-v_dp
variable a equal sqrt(4*v_s^2*0.005^2-(v_s^2-0.003^2+0.005^2)^2)/(2*v_s)
variable f equal 1.5*PI*v_w*v_a
variable ka equal v_f/(v_p-v_f/v_k2)^(v_c/v_n)'
for set in '1.5 1.5 3 1 0' '1 1 5 1 0' '2 1.3 1.5 0.001 1e-6'; do
	# shellcheck disable=SC2086
	agree "the branches, $set" "$(pair $set)
variable m equal 1.5e-5
$exact
$(overlap 1e-5)
print 'is loading \$(fx[1]) \$(-v_o-v_k1*1e-5^v_n) \$(1e4*v_k2*v_p)'
$(overlap 1.5e-5)
print 'is loading \$(fx[1]) \$(-v_o-v_k1*1.5e-5^v_n) \$(1e4*v_k2*v_p)'
$(overlap 1.45e-5)
print 'is unloading \$(fx[1]) \$(-v_o-v_k2*(1.45e-5^v_n-v_p)) \$(1e4*v_k2*v_p)'
$(overlap 4e-6)
print 'is adhesion \$(fx[1]) \$(-v_o+v_ka*4e-6^v_c) \$(1e4*v_k2*v_p)'
$(overlap -1e-6)
print 'is apart \$(fx[1]) 0'"
done
agree 'the limit of adhesion, and loading again' "$(pair 1.5 1.5 3 1e3 0)
variable m equal 1.5e-5
$exact
variable ka equal 0.5*v_k2*v_p/(0.5*v_dp)^1.5
$(overlap 1.5e-5)
$(overlap 4e-6)
print 'is adhesion \$(fx[1]) \$(v_ka*4e-6^1.5) \$(1e4*v_k2*v_p)'
variable q equal 4e-6^1.5*(1+v_ka/v_k2)
$(overlap 4.5e-6)
print 'is again \$(fx[1]) \$(-v_k2*(4.5e-6^1.5-v_q)) \$(1e4*v_k2*v_p)'
$(overlap 1.2e-5)
print 'is loaded \$(fx[1]) \$(-v_k1*1.2e-5^1.5) \$(1e4*v_k2*v_p)'"

# A wall: adhesion by the circle in which the plane cuts the sphere.
agree 'a wall' "$start
create_atoms 1 single 0 0 0.005 units box
set atom 1 diameter 0.01 density 2500
$(materials 1.5 1 3 1 0)
pair_style gran $law
pair_coeff * *
fix floor all wall/gran $law primitive type 2 zplane 0
fix move all nve/noforce
timestep 1e-6
variable k1 equal 4/3*5e6/(2*(1-0.3^2))*sqrt(0.005)
variable p equal 2/3*1.5e-5^1.5
variable dp equal v_p^(2/3)
variable f equal 1.5*PI*sqrt(0.005^2-(0.005-v_dp)^2)
variable ka equal v_f/(v_p-v_f/(3*v_k1))^(2/3)
set atom 1 z \$(0.005-1.5e-5)
run 1
print 'is loading \$(fz[1]) \$(v_k1*1.5e-5^1.5) \$(1e4*v_k1*v_p)'
set atom 1 z \$(0.005-4e-6)
run 1
print 'is adhesion \$(fz[1]) \$(-v_ka*4e-6) \$(1e4*v_k1*v_p)'"

# A heap of cohesive grains that collide, stick and part: any number of threads, a run cut by a restart file, other units.
heap() { # UNITS LENGTH MASS TIME
	echo "variable l equal $2
variable g equal $3
variable t equal $4
units $1
atom_style granular
atom_modify map array
newton off
communicate single vel yes
boundary p p f"
}
made='region box block 0 $(0.012*v_l) 0 $(0.012*v_l) 0 $(0.03*v_l) units box
create_box 2 box
lattice sc $(0.002*v_l)
region fill block 0 $(0.0119*v_l) 0 $(0.0119*v_l) $(0.0009*v_l) $(0.0069*v_l) units box
create_atoms 1 region fill
set group all diameter $(0.0019*v_l) density $(2500*v_g/v_l^3)
displace_atoms all random $(3e-5*v_l) $(3e-5*v_l) $(3e-5*v_l) 87723 units box
variable u atom 1.5*sin(1000*x/v_l+777000*y*z/v_l^2)*v_l/v_t
variable v atom 1.5*sin(1300*y/v_l+977000*x*z/v_l^2+1)*v_l/v_t
velocity all set v_u v_v v_u units box'
rest='variable pa equal v_g/v_l/v_t^2
fix m1 all property/global youngsModulus peratomtype $(5e6*v_pa) $(5e6*v_pa)
fix m2 all property/global poissonsRatio peratomtype 0.3 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
fix e1 all property/global overlapExponent scalar 1.5
fix e2 all property/global adhesionExponent scalar 1.5
fix e3 all property/global UnloadingStiffness peratomtypepair 2 3 3 3 3
fix e4 all property/global surfaceEnergy peratomtypepair 2 $(2*v_pa*v_l) $(2*v_pa*v_l) $(2*v_pa*v_l) $(2*v_pa*v_l)
fix e5 all property/global pullOffForce peratomtypepair 2 0 0 0 0
pair_style gran model edinburgh tangential history rolling_friction epsd2
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
pair_coeff * *
neighbor $(0.0005*v_l) bin
fix g all gravity $(9.81*v_l/v_t^2) vector 0 0 -1
fix floor all wall/gran model edinburgh tangential history rolling_friction epsd2 primitive type 2 zplane 0
fix move all nve/sphere
timestep $(2e-6*v_t)
compute c all contact/atom
compute s all reduce sum c_c
variable e equal ke/v_g/v_l^2*v_t^2
thermo_modify format float %.15g
thermo_style custom step v_e c_s
thermo 200'
{ heap si 1 1 1; echo "$made"; echo "$rest"; printf '%s\n' 'run 700' 'write_restart half.restart' 'run 900'; } >in.whole
{ printf '%s\n' 'variable l equal 1' 'variable g equal 1' 'variable t equal 1' 'read_restart half.restart'; echo "$rest"; echo 'run 900'; } >in.again
resumes 'heap' rows 4
rows whole | awk '$3 > 60 { n++ } END { exit n < 3 }'
report 'contacts' $? whole
{ heap micro 1e6 1e15 1e6; echo "$made"; echo "$rest"; echo 'run 400'; } >in.micro
"$TSIM" -in in.micro -log none >micro 2>&1
report 'micro units' $? micro
paste <(rows whole | head -3) <(rows micro | head -3) | awk '{ d = $2 / $5 - 1; bad = bad || !(d * d < 1e-14) || $3 != $6 } END { exit bad || NR < 3 }'
report 'the same in micro units' $?

base="$(pair 1.5 1.5 3 1 0)"
rejects "${base/$law/$law limitForce on}
run 0" "'limitForce' does not go with model edinburgh, which attracts"
rejects "${base/$law/$law located yes}
run 0" "'located' belongs to"
rejects "${base/$law/model edinburgh surface multicontact}
run 0" 'surface multicontact goes with'
rejects "$base
fix books all energy/ledger
run 0" 'contacts of model edinburgh have no potential energy'
rejects "$base
compute e all pe
run 0
print \\\$(c_e)" 'edinburgh have no potential energy'
rejects "$(pair 1.5 1.5 0.5 1 0)
run 0" 'UnloadingStiffness is 0.5, expected a number >= 1'
rejects "$(pair 0 1.5 3 1 0)
run 0" 'overlapExponent is 0, expected a number > 0'
rejects "$(pair 1.5 1.5 3 -1 0)
run 0" 'surfaceEnergy is -1, expected a number >= 0'
rejects "${base/model edinburgh/model edinburgh\/stiffness}
run 0" 'use model edinburgh'
finish
