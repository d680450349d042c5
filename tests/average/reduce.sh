#!/bin/bash
# Standard deviations, and chunks without particles: against closed forms.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# four grains in two of three chunks; the group has none in the last one. The mean of x is large beside its deviation.
cat >in.begin <<'END'
units si
boundary p f f
variable far index 0
region b block ${far} $(v_far+3) 0 1 0 1 units box
create_box 2 b
create_atoms 1 single $(v_far+0.25) 0.2 0.3 units box
create_atoms 1 single $(v_far+0.5) 0.2 0.3 units box
create_atoms 2 single $(v_far+0.875) 0.2 0.5 units box
create_atoms 2 single $(v_far+2.5) 0.2 0.3 units box
set group all diameter 0.01 density 2385
set atom 1 vx 2
set atom 2 vx 4
set atom 3 vx 9
set atom 4 vx -6
group g id 1 2 3
compute ch all chunk/atom bin/1d x lower 1 units box
compute zero all reduce/chunk ch ave vx
compute skip all reduce/chunk ch ave vx empty skip
compute two g reduce/chunk ch ave z vx empty skip
compute std all reduce/chunk ch std vx
compute s g reduce std x vx
variable zero equal ave(c_zero)
variable skip equal ave(c_skip)
END
agree 'chunks without particles' 'include in.begin
print "is zero $(c_zero[2]) 0"
print "is zero3 $(c_zero[3]) -6"
print "is mean $(v_zero) $((5-6)/3)"
print "is skip $(c_skip[1]) 5"
print "is skip2 $(c_skip[2]) -6"
print "is mean $(v_skip) -0.5"
variable n equal length(c_skip)
print "is rows $(v_n) 2"
print "is group $(c_two[1][2]) 5"
print "is where $(c_two[1][1]) $((0.3+0.3+0.5)/3)"
set atom 4 x 1.5
print "is moved $(c_skip[2]) -6"
group none empty
compute none none reduce/chunk ch ave vx empty skip
variable none equal length(c_none)
print "is none $(v_none) 0"'
prints 'include in.begin
thermo_style custom step v_skip
run 0' '*-0.5'
rejects 'include in.begin
print "$(c_skip[3])"' 'c_skip'
rejects 'include in.begin
compute c all chunk/spread/atom ch c_skip
print "$(c_c[1])"' "'c_skip' has 2 numbers, but there are 3 chunks in 'ch'"
rejects 'include in.begin
compute c all reduce/chunk ch ave vx empty none' 'skip'

# x = 1/4, 1/2, 7/8 on top of 0 and of 2^25: sqrt(<(x - <x>)^2>), to the last bits
for far in 0 33554432; do
	agree "standard deviation at $far" "variable far index $far
include in.begin
print \"is x \$(c_s[1]:%.17g) \$(sqrt(((1/4-13/24)^2+(1/2-13/24)^2+(7/8-13/24)^2)/3):%.17g)\"
print \"is vx \$(c_s[2]:%.17g) \$(sqrt(26/3):%.17g)\"
print \"is one \$(c_std[3]) 0\"
print \"is empty \$(c_std[2]) 0\"
print \"is chunk \$(c_std[1]:%.17g) \$(sqrt(26/3):%.17g)\""
done

# values whose squares are beyond the range of numbers, alone and beside small ones
agree 'standard deviation of large values' 'variable far index 0
include in.begin
set atom 1 vx 1e200
set atom 2 vx 3e200
set atom 3 vx 5e200
print "is large $(c_s[2]/1e200:%.14g) $(sqrt(8/3):%.14g)"
set atom 2 vx 3e20
set atom 3 vx -1e200
print "is mixed $(c_s[2]/1e200:%.14g) $(sqrt(2/3):%.14g)"'

finish
