#!/bin/bash
# Particles in the gap between pad and wafer: how many are placed, where, the same with any number of threads; those that
# are squeezed, and their forces; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# near NAME FORMULA VALUE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= 1e-11*abs($3)\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.15g), expected \$($3:%.15g)'\""
}

# ---- two plates, spheres of known radii: those higher than the gap are squeezed ----
cat >in.plates <<'END'
units si
boundary p p f
atom_style granular
region box block 0 8 0 8 -1 2 units box
create_box 2 box
soft_particles yes
fix m1 all property/global youngsModulus peratomtype 1e6 1e6
fix m2 all property/global poissonsRatio peratomtype 0.25 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history
pair_coeff * *
fix pad all surface/voxel constant 0 type 2 cells 8 8
fix low all wall/gran model hertz tangential history voxels pad
fix top all wall/gran model hertz tangential history primitive type 2 zplane 1
variable k loop 5
label more
create_atoms 1 single $(v_k) 4 0.5 units box
next k
jump SELF more
set group all density 2500
set atom 1 diameter 0.9
set atom 2 diameter 1.0
set atom 3 diameter 1.01
set atom 4 diameter 1.03
set atom 5 diameter 1.06
group most id 1 2 3 4
timestep 1e-7
fix go all nve/sphere
compute paml all active/paml low top
compute most most active/paml top low
compute hard all active/paml low top threshold 200
compute nip all squeeze/atom low top
compute sum all reduce sum c_nip[1] c_nip[2] c_nip[3]
variable Es equal 1e6/2/(1-0.25^2)
variable f3 equal 4/3*v_Es*sqrt(0.505)*0.005^1.5
variable f4 equal 4/3*v_Es*sqrt(0.515)*0.015^1.5
variable f5 equal 4/3*v_Es*sqrt(0.53)*0.03^1.5
END
prints "include in.plates
thermo_style custom step c_paml c_paml[4] c_most c_hard c_sum[1] c_sum[2] c_sum[3]
run 0
$(near active c_paml 3)
$(near all 'c_paml[1]' 5)
$(near eligible 'c_paml[2]' 5)
$(near again 'c_paml[3]' 3)
$(near mean 'c_paml[4]' '(v_f3+v_f4+v_f5)/3')
$(near sum 'c_paml[5]' 'v_f3+v_f4+v_f5')
$(near largest 'c_paml[6]' v_f5)
$(near group c_most 2)
$(near 'of the group' 'c_most[1]' 4)
$(near 'above the threshold' c_hard 2)
$(near 'by particle' 'c_sum[1]' 'v_f3+v_f4+v_f5')
$(near 'of the pad' 'c_sum[2]' 'c_sum[1]')
$(near 'of the wafer' 'c_sum[3]' 'c_sum[1]')" \
	'active ok' 'all ok' 'eligible ok' 'again ok' 'mean ok' 'sum ok' 'largest ok' 'group ok' 'of the group ok' \
	'above the threshold ok' 'by particle ok' 'of the pad ok' 'of the wafer ok'
# one that rests on the pad alone is not squeezed, whatever its force
prints "include in.plates
set atom 4 z 0.4
thermo_style custom step c_paml
run 0
$(near active c_paml 2)" 'active ok'

# between plates of which one slides a squeezed particle rolls with half its speed, under the same force
prints "include in.plates
delete_atoms group all
unfix top
fix top all wall/gran model hertz tangential history primitive type 2 zplane 1 shear x 0.5
create_atoms 1 single 1 4 0.5 units box
set group all diameter 1.03 density 2500
timestep 1e-3
variable speed equal vcm(all,x)
fix mean all ave/time 1 100 100 c_paml[5] v_speed
thermo_style custom step c_paml
run 10000
if \"abs(f_mean[2]-0.25) < 1e-6\" then \"print rolls\"
$(near force 'f_mean[1]' v_f4)" rolls 'force ok'
rejects "include in.plates
thermo_style custom step c_paml
run 0
unfix top
print \"\$(c_paml)\"" "there is no fix 'top'"

# ---- the gap: a quarter of the columns is 1 high, the others 0; the face at 3 ----
cat >in.gap <<'END'
units si
boundary p p f
atom_style granular
region box block 0 4 0 2 -1 4 units box
create_box 2 box
soft_particles yes
fix m1 all property/global youngsModulus peratomtype 1e6 1e6
fix m2 all property/global poissonsRatio peratomtype 0.25 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history
pair_coeff * *
neighbor 0.05 bin
variable cx internal 0
variable h equal v_cx<1
fix pad all surface/voxel formula v_h x cx type 2 cells 8 4
fix low all wall/gran model hertz tangential history voxels pad
fix grains all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.15
fix sand all particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius gaussian number 0.12 0.01
fix mix all particledistribution/discrete 32452843 1 grains 1.0
fix mixed all particledistribution/discrete 32452847 1 sand 1.0
timestep 1e-7
fix go all nve/sphere
END
cat >in.free <<'END'
include in.gap
fix top all wall/gran model hertz tangential history primitive type 2 zplane 3
compute n all contact/atom
compute nip all squeeze/atom low top
compute most all reduce max c_n c_nip[2] c_nip[3]
compute lowest all reduce min z
END
none="if \"c_most[1] + c_most[2] + c_most[3] == 0\" then \"print 'no overlap'\""
prints "include in.free
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top fraction 0.1
thermo_style custom step atoms c_most[1] c_most[2] c_most[3] f_seed[1]
run 1
$(near stacked 'f_seed[3]' '8*6+24*10')
$(near number 'f_seed[1]' 29)
$(near mass 'f_seed[2]' '29*2500*4/3*PI*0.15^3')
$(near volume 'f_seed[4]' '8*0.25*2+24*0.25*3')
$(near filled 'f_seed[5]' '29*4/3*PI*0.15^3/22')
$none" 'stacked ok' 'number ok' 'mass ok' 'volume ok' 'filled ok' 'no overlap'
prints "include in.free
fix seed all insert/gap seed 32452867 distributiontemplate mixed lower pad upper top fraction 0.25 count volume maxattempt 1000
thermo_style custom step atoms c_most[1] c_most[2] c_most[3] c_lowest f_seed[1]
run 1
variable v equal 4/3*PI*(0.12^3+3*0.12*0.01^2*0.97335)
$(near stacked 'f_seed[3]' '8*6+24*10')
if \"abs(f_seed[1]-0.25*22/v_v) < 2\" then \"print 'number ok'\"
if \"abs(f_seed[5]-0.25) < 0.003\" then \"print 'filled ok'\"
if \"(c_lowest > 0.09) && (c_lowest < 0.2)\" then \"print 'to the bottom'\"
$none" 'stacked ok' 'number ok' 'filled ok' 'to the bottom' 'no overlap'
# the underside of a second field; both have moved when the particles come
prints "include in.gap
unfix low
unfix pad
fix pad all surface/voxel formula v_h x cx type 2 cells 8 4 move linear 3e4 0 1e4
fix low all wall/gran model hertz tangential history voxels pad
fix slab all surface/voxel constant 4 base 3 type 2 cells 2 2 move linear 0 0 1e4
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper slab fraction 0.1 start 100 verbose no
run 100
$(near stacked 'f_seed[3]' '8*6+24*10')
if \"(bound(all,zmin) > 0.1+0.149) && (bound(all,zmax) < 3.1-0.149)\" then \"print 'between both'\"" 'stacked ok' 'between both'

# a second insertion sees the particles of the first one
prints "include in.free
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top fraction 0.2
fix more all insert/gap seed 32452877 distributiontemplate mixed lower pad upper top fraction 0.2 maxattempt 1000
thermo_style custom step atoms c_most[1] c_most[2] c_most[3] f_seed[1] f_more[1]
run 2
$(near both 'count(all)' '2*round(0.2*288)')
$none" 'both ok' 'no overlap'

# positions: a function of the seed
place() { # SEED THREADS FILE
	printf 'package omp %s grain 1\ninclude in.free\nfix seed all insert/gap seed %s distributiontemplate mixed lower pad upper top fraction 0.4 contact no\ndump d all custom 1 %s id radius x y z\ndump_modify d sort id format float %%.17g\nrun 1\n' "$2" "$1" "$3" >in.place
	"$TSIM" -in in.place -log none >out 2>&1
	report "placed: seed $1, $2 threads" $? out
}
place 32452867 1 one
place 32452867 2 two
place 32452869 1 other
same 'any number of threads' one two
[ -s one ] && [ -s other ] && ! cmp -s one other
report 'another seed' $?

# continued after the insertion, when the wafer has come down to the pad
cat >in.first <<'END'
include in.free
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top fraction 0.01
run 1
write_restart gap.restart
END
"$TSIM" -in in.first -log none >out 2>&1
report 'until the insertion' $? out
{ echo 'read_restart gap.restart'; sed -n '/^soft/,$p' in.gap; } >in.again
prints "include in.again
fix top all wall/gran model hertz tangential history primitive type 2 zplane 0.9
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top fraction 0.01
thermo_style custom step f_seed[1]
run 0
$(near number 'f_seed[1]' 3)
$(near there 'count(all)' 3)" 'number ok' 'there ok'

# ---- the example, over a micrometre ----
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99
cd polishing || exit 99
"$TSIM" -in in.paml -log none -var pads 2 -var settle 0.5e-6 -var block 0.25e-6 -var blocks 2 >out 2>&1 &&
	[ "$(grep -c '^RESULT .* ok$' out)" = 4 ] && ! grep -q '^RESULT .* off$' out
report 'the example' $? out
# particles: those that can be stacked, 0.04 of them; the closed forms: PML eligible n^(2/3) A
awk '!/^#/ { n++; if (NF != 19 || $3 < 200 || $3 > 350 || ($11/380.239 - 1)^2 > 1e-10 || !($10 == $14)) bad = 1 }
	END { exit bad || n != 2 }' post/paml.txt
report 'its table' $? post/paml.txt
for at in yes both; do
	"$TSIM" -in in.paml -log none -var pads 1 -var settle 1e-7 -var block 1e-7 -var blocks 1 -var lubrication $at \
		-var spread 0 >out 2>&1 && shows 'in the gap' out
	report "with lubrication ($at), equal particles" $? out
done
"$TSIM" -in in.paml -log none -var pads 1 -var settle 1e-7 -var block 1e-7 -var blocks 1 -var stiffer 1 >out 2>&1 &&
	shows 'in the gap' out
report 'columns as springs' $? out
cd ..

# ---- refused ----
seed='fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper top'
plane='fix top all wall/gran model hertz tangential history primitive type 2 zplane'
# no TEXT LINES: after the gap these lines are refused with this text
no() {
	rejects "include in.gap
$2" "$1"
}
no 'the surfaces interpenetrate: 8 of 32 columns of pad reach up to 0.75 into top' "$plane 0.25
$seed fraction 0.1"
no 'no particle: the fraction 0.001 gives 0.096 of them' "$plane 1.25
$seed fraction 0.001"
no 'the largest particle has the diameter 0.3, and the gap is at most 0.25 high' "$plane 0.25
$seed fraction 0.1 contact yes"
no 'there is no gap: all columns of pad reach top' "$plane -0.1
$seed fraction 0.1 contact yes"
no fraction "$plane 3
$seed fraction 0"
no 'fraction is 0.61, expected at most 0.6' "$plane 3
$seed fraction 0.61"
no 'found a place between pad and top without overlap' "$plane 3
$seed fraction 0.6 count volume
run 1"
no "did you mean 'pad'" "$plane 3
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pads upper top fraction 0.1"
no "'tap'" "$plane 3
fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper tap fraction 0.1"
no 'are the same surface pad' \
	'fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper pad fraction 0.1'
slab='fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper slab fraction 0.1'
no 'give the upper surface a `base`' "fix slab all surface/voxel constant 4 type 2 cells 2 2
$slab"
no 'does not lie on the same rectangle' "fix slab all surface/voxel constant 4 base 3 type 2 cells 2 2 origin 0 0 size 2 2
$slab"
no 'is empty' "fix slab all surface/voxel formula v_h x cx base 0.5 type 2 cells 8 4
$slab"
no 'the lower surface is empty' "unfix low
unfix pad
fix pad all surface/voxel formula v_h x cx base 0.5 type 2 cells 8 4
$plane 3
$seed fraction 0.1"
no 'with one zplane' "$plane -1 3
$seed fraction 0.1"
no 'with one zplane' "fix top all wall/gran model hertz tangential history primitive type 2 xplane 3
$seed fraction 0.1"
no 'is no surface' 'fix seed all insert/gap seed 32452867 distributiontemplate mix lower pad upper mix fraction 0.1'
for style in active/paml squeeze/atom; do
	rejects "include in.plates
compute c all $style low low" 'both walls are low'
	rejects "include in.plates
compute c all $style low tup" "did you mean 'top'?"
	rejects "include in.plates
compute c all $style pad top" 'fix pad is of style surface/voxel, expected a fix wall/gran'
done
rejects "include in.plates
fix hard all wall/gran model hertz tangential history primitive type 2 zplane 1.5 impact exact
compute c all active/paml low hard" 'impact exact'
finish
