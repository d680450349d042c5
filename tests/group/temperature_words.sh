#!/bin/bash
# compute_modify extra and thermo_modify temp and press, with the numbers of LAMMPS' rules.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

gas='units lj
boundary p p p
region box block 0 10 0 10 0 10 units box
create_box 1 box
create_atoms 1 random 40 86028157 NULL
set group all diameter 0.1 mass 2.385
group low id 1:10
velocity all create 1.5 86028157
velocity all set 0.7 NULL NULL sum yes
thermo_modify norm no
compute all all temp
compute low low temp
compute drift all temp/com
compute pall all pressure thermo_temp
compute pnone all pressure NULL virial
run 0'
agree 'degrees of freedom' "$gas
variable two equal 2*ke
print 'is before \$(c_all) \$(v_two/(3*39))'
compute_modify all extra 0 dynamic yes
compute_modify drift extra/dof 7.5
compute_modify thermo_temp extra 5 dynamic/dof no
print 'is all \$(c_all) \$(v_two/(3*40))'
print 'is drift \$(c_drift) \$((v_two-mass(all)*(vcm(all,x)^2+vcm(all,y)^2+vcm(all,z)^2))/(3*40-7.5))'
print 'is temp \$(temp) \$(v_two/(3*40-5))'"
agree 'rotation' "$gas
set group low omega 0.3 0 0.7
compute spin all temp/sphere
compute turn all temp/sphere dof rotate
compute still all temp/sphere dof rotate
compute e all erotate/sphere
compute_modify turn extra 7.5
print 'is spin \$(c_spin) \$(2*(ke+c_e)/(6*40-3))'
print 'is turn \$(c_turn) \$(2*c_e/(3*40-7.5))'
print 'is still \$(c_still) \$(2*c_e/(3*40))'
print 'is xz \$(c_spin[5]-c_turn[5]) \$(c_all[5])'
print 'is rotation \$(c_turn[5]) \$(10*0.4*2.385*0.05^2*0.3*0.7)'"
agree 'some axes, and a region' "$gas
region half block 0 5 INF INF INF INF
group half region half
compute across low temp/partial 0 1 1
compute none all temp/partial 0 0 0
compute half all temp/region half
compute same half temp
compute both low temp/region half
variable yy atom mass*vy^2
variable zz atom mass*vz^2
compute sum low reduce sum v_yy v_zz
run 0
print 'is across \$(c_across) \$((c_sum[1]+c_sum[2])/(2*9))'
print 'is yy \$(c_across[2]) \$(c_sum[1])'
print 'is xx \$(c_across[1]+c_across[4]+c_none) 0'
print 'is half \$(c_half) \$(c_same)'
print 'is xz \$(c_half[5]) \$(c_same[5])'
compute_modify across extra 6
compute_modify half extra 0
print 'is extra \$(c_across) \$((c_sum[1]+c_sum[2])/(20-4))'
print 'is all \$(c_half) \$((c_half[1]+c_half[2]+c_half[3])/(3*count(half)))'
print 'is fewer \$(c_both[1]<c_half[1]) 1'"
rejects "dimension 2
boundary p p p
region b block 0 1 0 1 -0.5 0.5
create_box 1 b
compute c all temp/partial 1 0 1" 'in two dimensions there is no motion along z'
agree 'relative to a flow' "$gas
velocity all ramp vx 0.5 2 z 2 8 sum yes units box
compute ramp low temp/ramp vx 0.5 2 z 2 8 units box
compute bins low chunk/atom bin/1d z lower 2 units box
compute vcm low vcm/chunk bins
compute mean low chunk/spread/atom bins c_vcm[1] c_vcm[3]
compute layers low temp/profile 1 0 1 z 5
compute cells all temp/profile 1 1 1 xyz 1 1 1
compute still all temp/profile 0 0 0 xy 3 2
compute alone all temp/profile 1 1 1 xyz 1000 1000 1000
group nobody empty
compute none nobody temp/profile 1 1 1 x 3
variable ux atom vx-0.5-1.5*((z>2)*(z<8)*(z-2)/6+(z>=8))
variable wx atom vx-c_mean[1]
variable wz atom vz-c_mean[2]
variable er atom mass*(v_ux^2+vy^2+vz^2)
variable ew atom mass*(v_wx^2+vy^2+v_wz^2)
variable xz atom mass*v_wx*v_wz
variable filled atom c_mean[1]!=0
compute sum low reduce sum v_er v_ew v_xz
compute count low property/chunk bins count
compute full all reduce sum v_filled
run 0
variable b vector c_count>0
print 'is ramp \$(c_ramp) \$(c_sum[1]/(3*9))'
print 'is tensor \$(c_ramp[1]+c_ramp[2]+c_ramp[3]) \$(c_sum[1])'
print 'is layers \$(c_layers) \$(c_sum[2]/(3*10-2*sum(v_b)))'
print 'is xz \$(c_layers[5]) \$(c_sum[3])'
print 'is cells \$(c_cells) \$(c_drift)'
print 'is still \$(c_still) \$(c_all*39/40)'
print 'is none \$(c_alone+c_none) 0'
compute_modify ramp extra 6
compute_modify layers extra 6
print 'is extra \$(c_ramp) \$(c_sum[1]/24)'
print 'is more \$(c_layers) \$(c_sum[2]/(24-2*sum(v_b)))'
legacy lammps
print 'is lammps \$(c_layers) \$(c_sum[2]/(24-15))'"
rejects "$gas
compute c all temp/ramp vx 0 1 z 2 2" 'expected lo < hi'
rejects "$gas
compute c all temp/profile 1 0 0 z 0" 'Nz is 0, expected a number > 0'
rejects "$gas
compute c all temp/profile 1 0 0 z 4 out bin" 'compute temp/chunk gives the temperature of each bin'
rejects "$gas
compute c all temp/profile 1 0 0 xy 100000 100000" '1e+10 bins, expected at most'
rejects "dimension 2
boundary p p p
region b block 0 1 0 1 -0.5 0.5
create_box 1 b
compute c all temp/profile 1 1 0 yz 2 2" 'in two dimensions there is one bin along z'
agree 'the standard pressure as a vector' "$gas
fix p all ave/time 1 1 1 c_thermo_press c_pall mode vector
variable w vector c_thermo_press
variable e equal f_p[6][1]
run 0
print 'is sum \$(sum(v_w)) \$(pxx+pyy+pzz+pxy+pxz+pyz)'
print 'is xx \$(f_p[1][1]) \$(pxx)'
print 'is yz \$(v_e) \$(f_p[6][2])'
print 'is number \$(c_thermo_press) \$(press)'"
agree 'keywords by computes' "$gas
variable before equal \$(temp)
print 'is press \$(press) \$(c_pall)'
thermo_modify temp low press pnone
print 'is temp \$(temp) \$(c_low)'
print 'is press \$(press) \$(c_pnone)'
print 'is pxx \$(pxx) \$(c_pnone[1])'
thermo_modify temp thermo_temp press thermo_press
print 'is temp \$(temp) \$(v_before)'
print 'is press \$(press) \$(c_pall)'
thermo_modify temp low
thermo_style custom step temp
print 'is temp \$(temp) \$(v_before)'"
rejects "$gas
compute spin all temp/sphere dof none" "dof"
rejects "$gas
compute spin all temp/sphere bias drift" "bias"
rejects "$gas
thermo_modify temp pall" 'compute pall gives no temperature'
rejects "$gas
thermo_modify press low" 'compute low gives no pressure'
rejects "$gas
thermo_modify temp lwo" "there is no compute 'lwo'"
rejects "$gas
compute_modify all extra many" 'takes the number of degrees of freedom'
rejects "$gas
compute_modify all dynamic" 'dynamic takes yes or no'
rejects "$gas
compute_modify pall extra 0" "the compute has no word 'extra'"
rejects "$gas
compute_modify all extre 0" "did you mean 'extra'?"
finish
