#!/bin/bash
# Numbers of chunks out of those of particles, and back; neighbours of each particle.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.begin <<'END'
units si
boundary p f f
region b block 0 1 0 1 0 1 units box
create_box 2 b
create_atoms 1 single 0.1 0.2 0.3 units box
create_atoms 1 single 0.15 0.2 0.3 units box
create_atoms 2 single 0.8 0.2 0.3 units box
create_atoms 2 single 0.99 0.2 0.3 units box
set group all diameter 0.01 density 2385
set atom 1 vx 2.385 vy -1
set atom 2 vx 1.2 vy 3
set atom 3 vx -7 vy 4
set atom 4 vx 0.5 vy 0.25
group g id 1 2 4
compute ch all chunk/atom bin/1d x lower 0.25 units box
compute low g reduce/chunk ch min vx vy
compute sum g reduce/chunk ch sum vx
END
cat >in.chunks <<'END'
include in.begin
compute mean all reduce/chunk ch ave vx
variable v atom vx*vx
compute squares all reduce/chunk ch sum v_v vx
compute mine all chunk/spread/atom ch c_sum c_low[2]
variable list vector c_sum
print "is a $(c_low[1][1]) 1.2"
print "is b $(c_low[1][2]) -1"
print "is empty $(c_low[2][1]) 0"
print "is c $(c_low[4][1]) 0.5"
print "is sum $(c_sum[1]) $(2.385+1.2)"
print "is vector $(v_list[4]) 0.5"
print "is mean $(c_mean[4]) $((-7+0.5)/2)"
print "is squares $(c_squares[4][1]) 49.25"
print "is mine $(c_mine[1][1]) 3.585"
print "is mine2 $(c_mine[2][2]) -1"
print "is mine3 $(c_mine[3][1]) 0.5"
print "is mine4 $(c_mine[4][1]) 0.5"
compute some g chunk/spread/atom ch c_sum
print "is none $(c_some[3]) 0"
END
agree 'reduce/chunk, chunk/spread/atom' "$(cat in.chunks)"
rejects 'include in.begin
compute mine all chunk/spread/atom no c_sum' "there is no compute 'no'"
rejects 'include in.begin
compute other all chunk/atom type
compute mine all chunk/spread/atom other c_sum
print "$(c_mine[1])"' "'c_sum' has 4 numbers, but there are 2 chunks in 'other'"
rejects 'include in.begin
compute mine all chunk/spread/atom ch c_low' "'c_low' is an array, expected a vector; choose a column with [k]"

# the 1st and the 4th are 0.11 apart across the face, the 1st and the 2nd 0.05
cat >in.neighbours <<'END'
include in.begin
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
compute n all neighbor/atom
compute nn g neighbor/atom
neighbor 0.105 bin
timestep 1e-6
run 0
print "is a $(c_n[1]) 2"
print "is b $(c_n[2]) 1"
print "is c $(c_n[3]) 0"
print "is d $(c_n[4]) 1"
print "is e $(c_nn[3]) 0"
neighbor 0.045 bin
run 0
print "is f $(c_n[1]) 1"
END
agree 'neighbor/atom' "$(cat in.neighbours)"
rejects 'include in.begin
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
compute n all neighbor/atom
print "$(c_n[1])"' 'contacts are known only after a run'
agree 'molecules' 'include in.begin
fix m all property/atom mol
set atom 1*3 mol 2
set atom 4 mol 1
compute k all chunk/atom molecule
compute c all com/chunk k
compute s all reduce/chunk k sum vx
run 0
print "is one $(c_c[1][1]) 0.99"
print "is two $(c_c[2][1]) 0.35"
print "is vx $(c_s[1]) 0.5"
print "is sum $(c_s[2]) -3.415"'
rejects 'include in.begin
compute k all chunk/atom molecul' "did you mean 'molecule'?"

# Samples of bin 1: two with both particles, m v^2 of 1 + 2, and two with the first alone; in bin 2 the second alone, twice.
agree 'temperatures of norm none are means of those of the samples' 'units lj
atom_style sphere
region b block 0 10 0 10 0 10 units box
create_box 1 b
create_atoms 1 single 4 5 5 units box
create_atoms 1 single 4.75 7 5 units box
set group all diameter 0.5 density 1
set atom 1 vy 1
set atom 2 vx 1 vy 1
fix i all nve/sphere
timestep 0.1
compute ch all chunk/atom bin/1d x lower 5 units box
fix s all ave/chunk 1 4 4 ch temp temp/granular vx norm sample
fix n all ave/chunk 1 4 4 ch temp temp/granular vx norm none
fix a all ave/chunk 1 4 4 ch temp temp/granular vx norm all
run 4
variable m equal PI/6*0.5^3
print "is temp $(f_n[1][3]) $((3/6+1/3)/2*v_m)"
print "is temp2 $(f_n[2][3]) $((2/3)/2*v_m)"
print "is sample $(f_s[1][3]) $(f_n[1][3])"
print "is all $(f_a[1][3]) $((2*3+2)/(3*6)*v_m)"
print "is granular $(f_n[1][4]) $(2*0.25/3/4)"
print "is granular2 $(f_n[2][4]) 0"
print "is sum $(f_n[1][5]) 0.5"'
finish
