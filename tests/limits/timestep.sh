#!/bin/bash
# The time step: what the plan of a run says of granular contacts, and fix check/timestep/gran.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.two <<'END'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
neighbor 0.01 bin
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.5 0 0 units box
set type 1 diameter 0.2 density 2470
set type 2 diameter 0.23 density 1830
set atom 2 vx 0.7
fix m1 all property/global youngsModulus peratomtype 5.e6 9e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 1 0.8 0.8 1
fix m4 all property/global coefficientFriction peratomtypepair 2 0.05 0.06 0.06 0.08
fix m5 all property/global characteristicVelocity scalar 1.7
timestep 1e-4
fix n all nve/sphere
variable m1 equal 2470*PI*0.2^3/6
variable m2 equal 1830*PI*0.23^3/6
variable R1 equal 0.1
variable R2 equal 0.115
variable G1 equal 5e6/2/1.45
variable G2 equal 9e6/2/1.3
variable Y1 equal 1/(2*(1-0.45^2)/5e6)
variable Y2 equal 1/(2*(1-0.3^2)/9e6)
variable Y equal 1/((1-0.45^2)/5e6+(1-0.3^2)/9e6)
variable m equal v_m1*v_m2/(v_m1+v_m2)
variable R equal v_R1*v_R2/(v_R1+v_R2)
variable rayleigh1 equal PI*0.1*sqrt(2470/v_G1)/(0.1631*0.45+0.8766)
variable rayleigh2 equal PI*0.115*sqrt(1830/v_G2)/(0.1631*0.3+0.8766)
END
ratios='print "is rayleigh $(f_ts[1]*1e3:%.17g) $(v_rayleigh:%.17g)"
print "is hertz $(f_ts[2]*1e3:%.17g) $(v_hertz:%.17g)"
print "is skin $(f_ts[3]*1e3:%.17g) $(v_skin:%.17g)"'
law='pair_style gran model hertz tangential history
pair_coeff * *'

# the pair of both types is the shortest collision: only it has two partners
agree 'fractions' "include in.two
$law
fix ts all check/timestep/gran 2 0.1 0.1
run 1
print \"is before \$(f_ts[1]+f_ts[2]+f_ts[3]) 0\"
run 1
variable rayleigh equal 0.1/v_rayleigh2
variable t1 equal 2.87*((v_m1/2)^2/(v_R1/2*v_Y1^2*1.4))^0.2
variable t2 equal 2.87*((v_m2/2)^2/(v_R2/2*v_Y2^2*1.4))^0.2
variable t12 equal 2.87*(v_m^2/(v_R*v_Y^2*1.4))^0.2
variable hertz equal 0.1/(v_t1*(v_t1<=v_t2)*(v_t1<=v_t12)+v_t2*(v_t2<v_t1)*(v_t2<=v_t12)+v_t12*(v_t12<v_t1)*(v_t12<v_t2))
variable skin equal 1.4e-4/0.01*1e3
$ratios"
agree 'a group and vmax' "include in.two
$law
group one id 1
fix ts one check/timestep/gran check_every_time 2e-4 0.1 0.1 vmax 3
run 2
variable rayleigh equal 0.1/v_rayleigh1
variable hertz equal 0.1/(2.87*((v_m1/2)^2/(v_R1/2*v_Y1^2*6))^0.2)
variable skin equal 6e-4/0.01*1e3
$ratios"
agree 'legacy' "include in.two
$law
group one id 1
fix ts one check/timestep/gran 1 0.1 0.1 vmax 3 legacy yes
run 1
variable rayleigh equal 0.1/v_rayleigh1
variable hertz equal 0.1/(2.87*(v_m1^2/(v_R1/2*v_Y1^2*6))^0.2)
variable skin equal 6e-4/0.01*1e3
$ratios"
agree 'all at rest' "include in.two
$law
set atom 2 vx 0
fix ts all check/timestep/gran 1 0.1 0.1
fix tl all check/timestep/gran 1 0.1 0.1 legacy yes
run 1
print \"is hertz \$(f_ts[2]) 0\"
print \"is legacy \$(f_tl[2]*1e10:%.17g) 1\""
printf 'solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -0.9\nvertex 0.5 0 -0.9\nvertex 0 0.5 -0.9\nendloop\nendfacet\nendsolid\n' >belt.stl
agree 'a belt: the legacy formula looks at meshes that move only' "include in.two
$law
set atom 2 vx 0
fix belt all mesh/surface file belt.stl type 1 surface_vel 3 0 0
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes belt
fix ts all check/timestep/gran 1 0.1 0.1
fix tl all check/timestep/gran 1 0.1 0.1 legacy yes
run 1
print \"is moving \$(f_ts[2]>1e-6) 1\"
print \"is legacy \$(f_tl[2]*1e10:%.17g) 1\""
prints "include in.two
$law
fix ts all check/timestep/gran 1 0.01 0.003
run 3" "*the time step is 1.114 % of Rayleigh's time at step 1, more than 1 %" \
	'*% of the Hertz time at step 1, more than 0.3 %'
echo "include in.two
$law
fix ts all check/timestep/gran 1 0.01 0.003 warn no
run 3" >in.script
"$TSIM" -in in.script -log none >out 2>&1 && ! grep -q Rayleigh out
report 'warn no' $? out
rejects "include in.two
$law
fix ts all check/timestep/gran 1 0.01 0.003 error yes
run 3" "the time step is 1.114 % of Rayleigh's time at step 1"
rejects "include in.two
fix ts all check/timestep/gran 0 0.01 0.003" "found '0', expected N fraction_r fraction_h"
rejects "include in.two
fix ts all check/timestep/gran 10 0.01" "found '0.01', expected N"
rejects "include in.two
fix ts all check/timestep/gran 10 0.01 -1" "found '-1', expected N"
rejects "include in.two
unfix m1
fix ts all check/timestep/gran 1 0.1 0.1
run 1" 'needs `fix ID all property/global youngsModulus'

# what the plan says: the limits as numbers of LAW WORDS; a line `least step, rest of the text`
# plans SCRIPT NUMBER TEXT
plans() {
	printf '%s\n' 'include in.two' "$1" 'run 1' >in.script
	"$TSIM" -explain -in in.script -log none >out 2>&1
	printf '%s\n' 'include in.two' "$1" "print \"expected \$($2:%.6g)\"" >in.number
	expected=$("$TSIM" -in in.number -log none 2>&1 | sed -n 's/^expected //p')
	awk -v x="$expected" -v text="$3" 'index($0, text) { n = $1 == "->" ? $2 : $1
		ok += n <= x * 1.00001 && n >= x * 0.99999 } END { exit ok != 1 }' out
	report "$3: $2 = $expected" $? out
}
hertz="$law
variable d equal (1.25*v_m*1.4^2/(4/3*v_Y*sqrt(v_R)))^0.4
variable w equal sqrt(2*v_Y*sqrt(v_R*v_d)/v_m)
variable b equal ln(0.8)/sqrt(ln(0.8)^2+PI^2)
variable g equal -sqrt(5/6)*v_b*v_w"
plans "$hertz" '2*(sqrt(v_w^2+v_g^2)-v_g)/v_w^2' 'a contact of types 1 and 2'
plans "$hertz" v_rayleigh2 "Rayleigh's time"
hooke='pair_style gran model hooke tangential history
pair_coeff * *
variable a equal sqrt(v_R)*v_Y
variable k equal 16/15*v_a*(15/16*v_m*1.7^2/v_a)^0.2
variable w equal sqrt(v_k/v_m)
variable g equal v_w/sqrt(1+(PI/ln(0.8))^2)'
plans "$hooke" '2*(sqrt(v_w^2+v_g^2)-v_g)/v_w^2' '  a contact of types 1 and 2'
plans "$hooke
variable w equal v_w0*sqrt(3.5)
variable w0 equal sqrt(v_k/v_m)
variable g equal 3.5*v_w0/sqrt(1+(PI/ln(0.8))^2)" '2*(sqrt(v_w^2+v_g^2)-v_g)/v_w^2' 'the slip of a contact of types 1 and 2'
# at a wall: m* = m, R* = R
plans "pair_style gran model hooke
pair_coeff * *
group two id 2
fix w two wall/gran model hooke primitive type 2 zplane -0.5
variable a equal sqrt(v_R2)*v_Y2
variable k equal 16/15*v_a*(15/16*v_m2*1.7^2/v_a)^0.2" '2*sqrt(v_m2/v_k)' 'a contact of type 2 with wall w'
# partners that touch: the overlap that is
plans "$law
set atom 2 x 0.2 vx 0
variable w equal sqrt(2*v_Y*sqrt(v_R*0.015)/v_m)
variable b equal ln(0.8)/sqrt(ln(0.8)^2+PI^2)
variable g equal -sqrt(5/6)*v_b*v_w" '2*(sqrt(v_w^2+v_g^2)-v_g)/v_w^2' '  a contact of types 1 and 2'
plans "pair_style gran/hooke/history 1e5 NULL 0 NULL 0.5 1
pair_coeff * *" '2*sqrt(v_m/1e5)' '  a contact of types 1 and 2'
rejects 'include in.two
pair_style gran model hooke
pair_coeff * *
timestep 0.1
run 1' 'exceeds the stability limit'
prints 'include in.two
unfix n
pair_style gran model hooke
pair_coeff * *
timestep 0.1
run 1
print "nothing moves"' 'nothing moves'
finish
