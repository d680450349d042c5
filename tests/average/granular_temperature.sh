#!/bin/bash
# Granular temperature of a group, of chunks and in fix ave/chunk: known velocities, a Maxwell distribution, a moving
# frame, a sheared frame, spins, discs, single grains; and fix ave/error.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.four <<'END'
units si
boundary p f f
region b block 0 1 0 1 0 1 units box
create_box 3 b
create_atoms 1 single 0.1 0.2 0.3 units box
create_atoms 1 single 0.15 0.4 0.3 units box
create_atoms 2 single 0.8 0.3 0.3 units box
create_atoms 2 single 0.99 0.9 0.3 units box
set group all diameter 0.01 density 2385
set atom 2 diameter 0.02 density 2385
set atom 1 vx 2.385 vy -1
set atom 2 vx 1.2 vy 3
set atom 3 vx -7 vy 4
set atom 4 vx 0.5 vy 0.25
variable mx equal (2.385+1.2-7+0.5)/4
variable my equal (-1+3+4+0.25)/4
variable xx equal (2.385^2+1.2^2+49+0.25)/4-v_mx^2
variable yy equal (1+9+16+0.0625)/4-v_my^2
variable xy equal (-2.385+3.6-28+0.125)/4-v_mx*v_my
variable pair equal ((2.385-1.2)^2+16)/12
group none type 3
END
agree 'known velocities' 'include in.four
compute T all temp/granular
compute N all temp/granular mean none
compute U all temp/granular unbiased yes
compute M all temp/granular weight mass
compute none none temp/granular unbiased yes
group one id 3
compute one one temp/granular
compute sure one temp/granular unbiased yes
compute free one temp/granular mean none
print "is T $(c_T) $((v_xx+v_yy)/3)"
print "is xx $(c_T[1]) $(v_xx)"
print "is yy $(c_T[2]) $(v_yy)"
print "is zz $(c_T[3]) 0"
print "is xy $(c_T[4]) $(v_xy)"
print "is moments $(c_N) $((v_xx+v_yy+v_mx^2+v_my^2)/3)"
print "is unbiased $(c_U) $((v_xx+v_yy)/3*4/3)"
print "is empty $(c_none) 0"
print "is one $(c_one) 0"
print "is sure $(c_sure) 0"
print "is free $(c_free) $(65/3)"
variable px equal (2.385+8*1.2-7+0.5)/11
variable py equal (-1+24+4+0.25)/11
print "is mass $(c_M) $(((2.385^2+1+8*(1.44+9)+65+0.25+0.0625)/11-v_px^2-v_py^2)/3)"'
agree 'chunks, with empty and single ones' 'include in.four
compute ch all chunk/atom bin/1d x lower 0.25 units box
compute C all temp/granular/chunk ch
compute U all temp/granular/chunk ch unbiased yes
compute whole all chunk/atom bin/1d x lower 1 units box
compute W all temp/granular/chunk whole weight mass mean linear/y
compute L all temp/granular weight mass mean linear/y
fix a all ave/chunk 1 1 1 ch temp/granular
fix s all ave/chunk 1 1 1 ch temp/granular norm sample
group some id 1 3 4
compute S some temp/granular/chunk ch
run 0
print "is pair $(c_C[1][1]) $(v_pair)"
print "is U $(c_U[1][1]) $(2*v_pair)"
print "is xx $(c_C[1][2]) $((2.385-1.2)^2/4)"
print "is xy $(c_C[1][5]) $((2.385-1.2)*(-4)/4)"
print "is two $(c_C[1][8]) 2"
print "is empty $(c_C[2][1]) 0"
print "is none $(c_C[2][8]) 0"
print "is c $(c_C[4][1]) $((7.5^2+3.75^2)/12)"
print "is mean $(c_C) $((v_pair+(7.5^2+3.75^2)/12)/2)"
print "is part $(c_S[1][1]) 0"
print "is count $(c_S[1][8]) 1"
print "is ave $(f_a[1][3]) $(v_pair)"
print "is sample $(f_s[4][3]) $((7.5^2+3.75^2)/12)"
print "is ave0 $(f_a[2][3]) 0"
print "is whole $(c_W[1][1]) $(c_L)"
print "is whole_xy $(c_W[1][5]) $(c_L[4])"'

# A gas with Maxwell-distributed velocities of variance 2.385^2 (standard error of T: sqrt(2/(3 N)) = 0.0058), at rest,
# in a moving frame, and sheared: velocity + 3 + 700 y.
gas='units si
boundary p p p
region b block 0 1 0 1 0 1 units box
create_box 1 b
create_atoms 1 random 20000 86028157 NULL
set group all diameter 0.001 density 2385
variable ux atom normal(0,2.385,4241)
variable uy atom normal(0,2.385,7351)
variable uz atom normal(0,2.385,9533)
velocity all set v_ux v_uy v_uz'
agree 'frames' "$gas
compute T all temp/granular
compute L all temp/granular mean linear/y
variable T0 equal \$(c_T)
variable L0 equal \$(c_L)
print \"is maxwell \$(abs(c_T/2.385^2-1)<3*0.0058) 1\"
print \"is alike \$(abs(c_L/c_T-1)<1e-3) 1\"
velocity all set 30 -20 10 sum yes
print \"is moving \$(c_T) \$(v_T0)\"
variable s atom 3+700*y
velocity all set v_s NULL NULL sum yes
print \"is sheared \$(c_L) \$(v_L0)\"
print \"is heated \$(c_T>1e4) 1\""
grain='fix i all nve/sphere
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
create_atoms 1 single 0.2 0.2 0 units box
create_atoms 1 single 0.7 0.7 0 units box
set group all diameter 0.02 density 2385
set atom 1 omegaz 30
set atom 2 omegaz -10
timestep 1e-6'
agree 'spins' "units si
boundary f f f
atom_style granular
region b block 0 1 0 1 -0.5 0.5 units box
create_box 1 b
$grain
compute R all temp/granular motion rotation
compute E all erotate/sphere
run 0
print \"is zz \$(c_R[3]) \$(0.4*0.01^2*400)\"
print \"is R \$(c_R) \$(0.4*0.01^2*400/3)\"
compute F all temp/granular motion rotation mean none weight mass
print \"is energy \$(c_F*3/2*mass(all)) \$(c_E)\""
agree 'discs' "units si
dimension 2
boundary f f p
atom_style granular
region b block 0 1 0 1 -0.5 0.5 units box
create_box 1 b
$grain
fix p all enforce2d
compute R all temp/granular motion rotation
compute T all temp/granular
set atom 1 vx 2
run 0
print \"is R \$(c_R) \$(0.5*0.01^2*400)\"
print \"is T \$(c_T) 0.5\""
for threads in 1 2 3; do
	{
		printf 'package omp %s grain 1\n%s\n' $threads "$gas"
		cat <<-'END'
			compute ch all chunk/atom bin/1d y lower 0.1 units box
			compute T all temp/granular mean linear/z
			compute C all temp/granular/chunk ch mean linear/x weight mass
			print "T $(c_T:%.17g) $(c_C[3][1]:%.17g) $(c_C[9][6]:%.17g) $(c_C:%.17g)"
		END
	} >in.threads
	"$TSIM" -in in.threads -log none | grep '^T ' >threads.$threads
	same "bit for bit with $threads threads" threads.1 threads.$threads
done
rejects 'include in.four
compute T all temp/granular mean linear' "linear"
rejects 'include in.four
compute T all temp/granular/chunk no' "there is no compute 'no'"

# Of a straight line 0 1 2 ... the mean, and the scatter of block means.
agree 'fix ave/error' 'include in.four
fix i all nve
timestep 1e-6
variable line equal step
variable same equal 0.1
fix e all ave/error 1 v_line v_same blocks 4
compute T all temp/granular
fix v all ave/error 2 c_T mode vector start 4
run 2

run 5
print "is samples $(f_e) 8"
print "is mean $(f_e[1][1]) 3.5"
# two blocks of 4: means 1.5 and 5.5
print "is error $(f_e[1][2]) 2"
print "is constant $(f_e[2][1]) 0.1"
print "is no_error $(f_e[2][2]) 0"
run 5
# 0 1 2 3 | 4 5 6 7 | 8 9 10 11 | 12
print "is mean $(f_e[1][1]) 6"
print "is error $(f_e[1][2]) $(sqrt(32/6))"
print "is vector $(f_v[4][1]) $(c_T[4])"
print "is some $(f_v) 5"'
rejects 'include in.four
fix e all ave/error 1 step blocks 5
run 0' 'blocks is 5, expected an even number'
rejects 'include in.four
compute T all temp/granular
fix e all ave/error 1 c_T c_T mode vector
run 0' 'mode vector takes one vector, found 2 values'
finish
