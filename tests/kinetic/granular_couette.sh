#!/bin/bash
# compute granular/couette: numbers of the reference case from a script, unknown speed, load, gap and solid fraction, profiles
# in files, sweeps; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

grains='diameter 0.787e-3 density 2550 restitution 0.85'
walls='wall_restitution 0.65 roughness 0.65'
film="compute c all granular/couette gap 4e-3 solid_fraction 0.4 speed 2"

# near NAME FORMULA VALUE TOLERANCE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= $4\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.10g), expected \$($3:%.10g)'\""
}

# tests/data/granular_couette.csv, nu 0.40, R 0.65: no box is needed
prints "$film $grains $walls
$(near load 'c_c[2]/(2550*4)' 0.036510 6e-7)
$(near shear 'c_c[3]/(2550*4)' 0.011519 6e-7)
$(near traction 'c_c[4]-c_c[3]/c_c[2]' 0 1e-15)
$(near slip 'c_c[7]/2' 0.18416 6e-6)
$(near 'upper slip' 'c_c[8]/c_c[7]' 1 1e-9)
$(near centre 'c_c[9]' 0.40906 6e-6)
$(near temperature 'c_c[10]/4' 0.010388 6e-7)
$(near densest 'c_c[11]' 'c_c[9]' 1e-12)
$(near energy '(c_c[12]+c_c[13]+c_c[14])/(2*c_c[3])' 1 1e-12)
$(near balance 'c_c[15]' 0 1e-13)
$(near solutions 'c_c[16]' 1 0)
$(near error 'c_c[17]' 0 1e-8)
$(near wall 'c_c[1][3]' 0.38244 6e-6)
$(near 'speed at the wall' 'c_c[1][2]/2' '1-0.18416' 6e-6)
$(near middle 'c_c[21][2]' 1 1e-9)
$(near width 'c_c[41][1]' 4e-3 1e-15)" 'load ok' 'shear ok' 'traction ok' 'slip ok' 'upper slip ok' 'centre ok' \
	'temperature ok' 'densest ok' 'energy ok' 'balance ok' 'solutions ok' 'error ok' 'wall ok' \
	'speed at the wall ok' 'middle ok' 'width ok'

# through freezing, where the slope of torquato's g0 has a step, to the default tolerance
prints "compute c all granular/couette gap 5 solid_fraction 0.485 speed 1 diameter 1 density 1 restitution 0.85 wall_restitution 0.65 roughness 0.65 radial torquato
compute f all granular/couette gap 5 solid_fraction 0.485 speed 1 diameter 1 density 1 restitution 0.85 wall_restitution 0.65 roughness 0.65 radial torquato tolerance 1e-11
$(near load 'c_c[2]/c_f[2]' 1 2e-8)
$(near balance 'c_c[15]' 0 1e-13)
$(near middle 'c_c[21][2]' 0.5 1e-9)
$(near width 'c_c[41][1]' 5 1e-15)
$(near freezing '(c_c[1][3]<0.49)+(c_c[21][3]>0.49)' 2 0)" 'load ok' 'balance ok' 'middle ok' 'width ok' 'freezing ok'

# The bumpiness is the half angle; other units; walls of their own; a check runs nothing else
prints "units micro
compute c all granular/couette gap 4e3 solid_fraction 0.4 speed 2 diameter 787 density 2.55e-3 restitution 0.85 wall_restitution 0.65 bumpiness 40.5416018730 count no
$(near load 'c_c[2]/(2.55e-3*4)' 0.036510 6e-7)
$(near solutions 'c_c[16]' 0 0)
compute w all granular/couette gap 4e3 solid_fraction 0.4 speed 2 diameter 787 density 2.55e-3 restitution 0.85 wall_restitution 0.9 roughness 0.3 upper_wall_restitution 0.65 upper_roughness 0.65
compute v all granular/couette gap 4e3 solid_fraction 0.4 speed 2 diameter 787 density 2.55e-3 restitution 0.85 wall_restitution 0.65 roughness 0.65 upper_wall_restitution 0.9 upper_roughness 0.3
$(near swapped 'c_w[7]/c_v[8]' 1 1e-9)
$(near rougher 'c_w[8]<c_w[7]' 1 0)" 'load ok' 'solutions ok' 'swapped ok' 'rougher ok'
"$TSIM" -check -log none -in in.script >out 2>&1
report 'check' $? out
"$TSIM" -explain -log none -in in.script >out 2>&1
report 'explain' $? out

# Variables: a sweep in one script; the load of the first film gives the others
prints "variable H equal 4e-3
variable U equal 2
compute c all granular/couette gap v_H solid_fraction 0.4 speed v_U $grains $walls
variable N equal \$(c_c[2]:%.15g)
variable U equal 6
$(near square 'c_c[2]' '9*v_N' '1e-9*v_N')
variable H equal 8e-3
$(near wider 'c_c[2]<9*v_N' 1 0)
compute s all granular/couette gap 4e-3 solid_fraction 0.4 load v_N $grains $walls
compute g all granular/couette solid_fraction 0.4 speed 2 load v_N $grains $walls
compute a all granular/couette amount 1.6e-3 speed 2 load v_N $grains $walls
compute n all granular/couette gap 4e-3 speed 2 load v_N $grains $walls
$(near speed 'c_s[1]' 2 1e-8)
$(near gap 'c_g[5]' 4e-3 1e-11)
$(near amount 'c_a[5]' 4e-3 1e-11)
$(near fraction 'c_n[6]' 0.4 1e-8)
variable N equal \$(2*v_N:%.15g)
$(near 'more load' 'c_g[5]<4e-3&&c_n[6]>0.4&&c_s[1]>2' 1 0)" 'square ok' 'wider ok' 'speed ok' 'gap ok' 'amount ok' \
	'fraction ok' 'more load ok'

# Three solid fractions carry this load
prints "compute c all granular/couette gap 15.74e-3 speed 2 load 10.404 $grains $walls branch dilute
compute d all granular/couette gap 15.74e-3 speed 2 load 10.404 $grains $walls
$(near number 'c_c[16]+c_d[16]' 6 0)
$(near branches 'c_c[6]<0.04&&c_d[6]>0.15' 1 0)" 'number ok' 'branches ok'

# Friction of the grains: as a lower restitution; other theories change the result by some per cent only
prints "$film $grains $walls
compute f all granular/couette gap 4e-3 solid_fraction 0.4 speed 2 $grains $walls friction 0.01
compute e all granular/couette gap 4e-3 solid_fraction 0.4 speed 2 diameter 0.787e-3 density 2550 restitution \$(0.85-PI/2*0.01+4.5*0.0001) $walls
compute t all granular/couette gap 4e-3 solid_fraction 0.4 speed 2 $grains $walls theory garzo/dufty
compute r all granular/couette gap 4e-3 solid_fraction 0.4 speed 2 $grains $walls radial carnahan/starling
$(near friction 'c_f[2]/c_e[2]' 1 1e-3)
$(near less 'c_f[2]<0.97*c_c[2]' 1 0)
$(near theory 'c_t[2]/c_c[2]' 1 0.2)
$(near radial 'c_r[2]/c_c[2]' 1 0.3)
$(near differ '(c_t[2]<c_c[2])+(c_t[2]>c_c[2])+(c_r[2]<c_c[2])+(c_r[2]>c_c[2])' 2 0)" 'friction ok' 'less ok' 'theory ok' \
	'radial ok' 'differ ok'

# The profile in a file
prints "units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
$film $grains $walls points 5
fix out all ave/time 1 1 1 c_c[*] mode vector file profile
run 0
print 'done'" 'done'
[ "$(grep -vc '^#' profile)" = 6 ] && awk '$1 == 3 && NF == 5 { ok = $2 > 1.999e-3 && $2 < 2.001e-3 && $3 > 0.999999 && $3 < 1.000001 && $4 > 0.409 && $4 < 0.4091 } END { exit !ok }' profile
report 'profile in a file' $? profile

# Grains at rest in the middle of a wide gap
prints "compute c all granular/couette gap 40e-3 solid_fraction 0.5 speed 2 diameter 0.787e-3 density 2550 restitution 0.6 $walls count no
print \"\$(c_c[11] > 0.6499)\"" 1 '*the grains there are at rest, packed to the solid fraction 0.65'

# ---- what is refused

rejects "compute c all granular/couette gap 4e-3 solid_fraction 0.65 speed 2 $grains $walls" \
	'mean solid fraction 0.65, expected less than that at closest packing, 0.65'
rejects "compute c all granular/couette gap 4e-3 amount 3e-3 speed 2 $grains $walls" 'mean solid fraction 0.75, expected less'
rejects "compute c all granular/couette gap 4e-3 solid_fraction 0 speed 2 $grains $walls" 'solid fraction 0, expected > 0'
rejects "compute c all granular/couette gap 1.5e-3 solid_fraction 0.4 speed 2 $grains $walls" 'gap 0.0015, expected at least 2 diameters'
rejects "compute c all granular/couette gap 4e-3 solid_fraction 0.4 load -3 $grains $walls" 'load -3, expected > 0'
rejects "compute c all granular/couette gap 4e-3 solid_fraction 0.4 speed 0 $grains $walls" 'speed 0, expected > 0'
rejects "$film diameter 0.787e-3 density 2550 restitution 1.2 $walls" "restitution"
rejects "$film $grains wall_restitution -0.1 roughness 0.65" "wall_restitution"
rejects "$film $grains wall_restitution 0.65 roughness 1.5" "roughness"
rejects "$film $grains wall_restitution 0.65 roughness 0" 'a smooth wall (0) does not shear the grains'
rejects "$film $grains wall_restitution 0.65" 'none of roughness and bumpiness'
rejects "$film $grains $walls bumpiness 30" 'both of roughness and bumpiness'
rejects "$film diameter 0.787e-3 density 2550 restitution 1 wall_restitution 1 roughness 0.65" 'there is no steady state'
rejects "$film load 3 $grains $walls" '4 are given, expected 3'
rejects "compute c all granular/couette gap 4e-3 speed 2 $grains $walls" '2 are given, expected 3'
rejects "$film amount 1e-3 $grains $walls" 'both the solid fraction and the amount'
rejects "$film diameter 0.787e-3 density 2550 restitution 0.1 $walls friction 0.3" 'the theory is for small friction'
rejects "$film $grains $walls packing 0.3" 'expected less than that at closest packing, 0.3'
rejects "compute c all granular/couette gap 20e-3 solid_fraction 0.6 speed 2 $grains $walls radial carnahan/starling" \
	'above that at closest packing'
rejects "compute c all granular/couette gap 78.7e-3 solid_fraction 0.63 speed 2 diameter 0.787e-3 density 2550 restitution 0.3 wall_restitution 0.65 roughness 1 tolerance 1e-5" \
	'no solution was found at a gap of 100 diameters and the solid fraction 0.63: that of narrow gaps was followed'
rejects "compute c all granular/couette solid_fraction 0.4 speed 2 load 1e9 $grains $walls" \
	'the load 1e+09 is too large: at the speed 2 the narrowest gap for which there is a solution, 2 diameters, carries'
rejects "compute c all granular/couette amount 1e-9 speed 2 load 1e-8 $grains $walls tolerance 1e-3" 'the load 1e-08 is too small'
rejects "compute c all granular/couette amount 3 speed 2 load 1 $grains $walls" 'expected less than fills a gap of 2000 diameters'
rejects "compute c all granular/couette gap 4e-3 speed 2 load 1e30 $grains $walls" 'no solid fraction between'
rejects "compute c all granular/couette gap 4 solid_fraction 0.4 speed 2 $grains $walls" 'expected at most 2000 diameters'
rejects "compute c all granular/couette gap 4e-3 solid_fraction 0.4 speed 1e200 $grains $walls" 'out of the range of numbers'
rejects "variable nu equal 0.7
compute c all granular/couette gap 4e-3 solid_fraction v_nu speed 2 $grains $walls
print \"\$(c_c[2])\"" 'mean solid fraction 0.7, expected less'
rejects "$film $grains $walls tolerance 1e-15" 'tolerance'

finish
