#!/bin/bash
# compute repose/angle and bed/height: heaps and beds of known shape, in micrometres and kilometres, in any direction.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# near WHAT SCRIPT: in every line `near WHAT value reference tolerance` of its output both agree to the tolerance
near() {
	printf '%s\n' "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && awk '
		$1 == "near" { n++; d = $3 - $4; if (NF != 5 || !(d <= $5 && -d <= $5)) { print "differs: " $0; bad = 1 } }
		END { exit bad || !n }' out >>out 2>&1
	report "$1" $? out
}

box='units si
region box block $(-40*v_u) $(40*v_u) $(-40*v_u) $(40*v_u) $(-40*v_u) $(40*v_u) units box
create_box 1 box
lattice sc ${u}'

# A cone of a cubic lattice, with the radius 30 at its foot; grains on its tip, in the air and beside it change nothing
for case in '1 20' '1 33' '1e-6 33' '1000 33' '1 45'; do
	set -- $case
	near "cone of $2 degrees, u = $1" "variable u equal $1
$box
region heap cone z 0 0 \$(30*v_u) 0 0 \$(30*v_u*tan($2*PI/180)) units box
create_atoms 1 region heap units box
group heap region heap
create_atoms 1 single 0 0 \$(30*v_u*tan($2*PI/180)+v_u) units box
create_atoms 1 single \$(5.5*v_u) \$(8.5*v_u) \$(38*v_u) units box
create_atoms 1 single \$(38*v_u) \$(8.5*v_u) 0 units box
create_atoms 1 single \$(-35*v_u) \$(12.5*v_u) 0 units box
set group all diameter \${u} density 1000
compute h heap repose/angle cone
compute a all repose/angle cone
compute c all repose/angle cone center 0 0 \$(5*v_u) base \$(-0.5*v_u)
print \"near heap \$(c_h) $2 0.4\"
print \"near all \$(c_a) \$(c_h) 0.05\"
print \"near centre \$(c_c) $2 0.4\"
print \"near error \$(c_h[2]) 0.06 0.05\"
print \"near rms \$(c_h[3]/v_u) 0.25 0.07\"
print \"near tip \$(c_h[4]/v_u) \$(30*tan($2*PI/180)) 1.2\"
print \"near radius \$(c_h[5]/v_u) 31 1.5\"
print \"near axis \$(c_h[8]/v_u) 0 1e-9\"
print \"near many \$(c_h[10]) 550 100\""
done

# The same cone upwards along x, and a heap with its axis along (0, -3, 4)
near 'other directions' "variable u equal 1
$box
region along cone x 0 0 30 0 0 \$(30*tan(PI/6)) units box
create_atoms 1 region box units box
set group all diameter 1 density 1000
group along region along
variable up atom (-3*y+4*z)/5
variable aside atom sqrt(x^2+(4*y+3*z)^2/25)
variable in atom (v_up>=0)*(v_up<=(25-v_aside)*tan(PI*32/180))
group tilted variable in
compute x along repose/angle cone up 2 0 0
compute t tilted repose/angle cone up 0 -3 4
compute z tilted repose/angle cone
compute xh along bed/height up 1 0 0
compute th tilted bed/height up 0 -0.3 0.4
print \"near x \$(c_x) 30 0.4\"
print \"near tilted \$(c_t) 32 0.6\"
print \"near height \$(c_xh[2]) 18 1e-9\"
print \"near height \$(c_th[2]) \$(25*tan(PI*32/180)) 1\"
print \"near other \$(abs(c_z-32)<5) 0 0\""

# Two dimensions: a triangle of hexagonally packed discs has exactly 60 degrees on both sides
near 'hexagonal triangle' 'units si
dimension 2
region box block -100 100 -10 150 -0.1 0.1 units box
create_box 1 box
lattice hex 1
variable out atom (abs(x)>40.01-y/sqrt(3))+(y<0)
create_atoms 1 region box units box
set group all diameter 1 density 1000
variable in atom (abs(x-0.2)<=40.01-y/sqrt(3))*(y>=0)
group heap variable in
compute a heap repose/angle ridge
compute b heap repose/angle ridge column 1.7
compute h heap bed/height
compute c heap repose/angle ridge center 0.2 0 0
print "near angle $(c_a) 60 1e-6"
print "near left $(c_a[6]) 60 1e-6"
print "near right $(c_a[7]) 60 1e-6"
print "near column $(c_b) 60 1e-6"
print "near centre $(c_c) 60 1e-6"
print "near error $(c_a[2]) 0 1e-6"
print "near axis $(c_a[8]) 0.2 1"'

# Unequal flanks: 20 degrees left, 35 right; a flat bed and one at 25 degrees between walls
near 'ridge and planes' "variable u equal 1
$box
create_atoms 1 region box units box
set group all diameter 1 density 1000
variable l equal tan(PI*20/180)
variable r equal tan(PI*35/180)
variable ridge atom (z>=-30)*(z<=-30+12-v_l*(1-x)*(x<1)-v_r*(x-1)*(x>=1))
group ridge variable ridge
variable slope atom (z<=x*tan(PI*25/180)+0.1)*(sqrt(x^2+z^2)<35)
group drum variable slope
variable flat atom z<=4.5
group flat variable flat
compute a ridge repose/angle ridge
compute d drum repose/angle plane
compute f flat repose/angle plane
compute h flat bed/height base -40 column 2
compute hq flat bed/height base -40 column 2 quantile 0.5 area 6400
print \"near left \$(c_a[6]) 20 0.6\"
print \"near right \$(c_a[7]) 35 0.4\"
print \"near axis \$(c_a[8]) 1 0.4\"
print \"near drum \$(c_d) 25 0.3\"
print \"near flat \$(c_f) 0 1e-9\"
print \"near flat \$(c_h) 44.5 1e-9\"
print \"near scatter \$(c_h[4]) 0 1e-9\"
print \"near median \$(c_hq) 22.5 0.01\"" # layers at -40 .. 4: the median one, -18, has its top at 22.5

# Porosity of a simple cubic lattice is 1 - pi/6
for u in 1 1e-6 1000; do
	agree "porosity, u = $u" "variable u equal $u
units si
region box block 0 \$(6*v_u) 0 \$(8*v_u) 0 \$(9*v_u) units box
create_box 1 box
lattice sc \${u} origin 0.5 0.5 0.5
region in block \$(0.1*v_u) \$(5.9*v_u) \$(0.1*v_u) \$(7.9*v_u) \$(0.1*v_u) \$(3.9*v_u) units box
create_atoms 1 region in units box
set group all diameter \${u} density 1000
compute h all bed/height base 0
compute a all bed/height base 0 column \$(3.1*v_u) area \$(48*v_u^2)
print \"is height \$(c_h) \$(4*v_u)\"
print \"is max \$(c_h[2]) \$(4*v_u)\"
print \"is min \$(c_h[3]) \$(4*v_u)\"
print \"is porosity \$(c_h[5]) \$(1-PI/6)\"
print \"is area \$(c_a[5]) \$(1-PI/6)\"
print \"is columns \$(c_h[6]) 12\"
print \"is row \$(c_h[2][2]) \$(3*v_u)\"
print \"is row \$(c_h[2][3]) \$(4*v_u)\""
done

# Nothing, one grain, a row of grains: 0, and the numbers of columns tell
agree 'too little' 'units si
region box block 0 10 0 10 0 10 units box
create_box 1 box
create_atoms 1 single 5.5 5.5 1 units box
set group all diameter 1 density 1000
group one id 1
group none empty
compute e none repose/angle cone
compute o one repose/angle cone
compute r one repose/angle ridge
compute p one repose/angle plane
compute pe none repose/angle plane
compute he none bed/height
compute h one bed/height base 0
print "is none $(c_e) 0"
print "is none $(c_e[10]) 0"
print "is one $(c_o) 0"
print "is one $(c_r) 0"
print "is one $(c_p) 0"
print "is none $(c_pe) 0"
print "is none $(c_he) 0"
print "is none $(c_he[5]) 0"
print "is none $(c_he[6]) 0"
print "is one $(c_h) 1.5"
print "is one $(c_h[6]) 1"
print "is porosity $(c_h[5]) $(1-PI/6/6)"'

scene='units si
region box block 0 1 0 1 0 1 units box
create_box 1 box'
rejects "$scene
compute a all repose/angle cone up 0 0 0" 'expected an upward direction'
rejects "$scene
compute a all repose/angle cone lower 0.9 upper 0.2" 'expected `lower` less than `upper`'
rejects "$scene
compute a all repose/angle kone" 'cone'
rejects "$scene
compute a all bed/height column 0" 'column'
rejects "dimension 2
${scene/0 1 units/-0.1 0.1 units}
compute a all repose/angle cone" 'ridge'
rejects "dimension 2
${scene/0 1 units/-0.1 0.1 units}
compute a all bed/height up 0 1 1" 'z = 0'
finish
