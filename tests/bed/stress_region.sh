#!/bin/bash
# compute stress/region: the whole box is compute pressure; cells that fill a box have its stress as their mean; a chain between
# walls, cut at known places; motion.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

gas='units si
boundary p p p
region box block 0 5 0 5 0 5 units box
create_box 2 box
create_atoms 1 random 60 1234 box
create_atoms 2 random 30 4321 box
set type 1 diameter 1.0
set type 2 diameter 1.4
set group all density 1000
velocity all create 0.3 77
pair_style gran/hooke/history 1e5 2e4 10 5 0.5 1
pair_coeff * *
neighbor 0.1 bin
timestep 1e-4
fix 1 all nve/sphere'
agree 'the whole box' "$gas
compute p all pressure NULL virial
compute s all stress/region box pair bond wall
region low block 0 5 0 5 0 1.7 units box
region high block 0 5 0 5 1.7 5 units box
region ball sphere 2.5 2.5 2.5 1.9 units box
region rest sphere 2.5 2.5 2.5 1.9 side out units box
compute l all stress/region low pair
compute h all stress/region high pair
compute b all stress/region ball pair
compute r all stress/region rest pair volume \$(125-4/3*PI*1.9^3)
compute k all stress/region box ke
compute t all stress/region box
run 30
print \"is zz \$(c_s[3]) \$(c_p[3])\"
print \"is xx \$(c_s[1]) \$(c_p[1])\"
print \"is pressure \$(c_s) \$(c_p)\"
print \"is slices \$((1.7*c_l[3]+3.3*c_h[3])/5) \$(c_p[3]) \$(10*c_p)\"
print \"is slices \$((1.7*c_l[4]+3.3*c_h[4])/5) \$(c_s[4]) \$(10*c_p)\"
variable v equal 4/3*PI*1.9^3
print \"is ball \$((v_v*c_b[1]+(125-v_v)*c_r[1])/125) \$(c_p[1]) \$(1e4*c_p)\"
variable vx equal vcm(all,x)
variable flux atom mass*(vx-v_vx)^2
compute flux all reduce sum v_flux
print \"is motion \$(c_k[1]) \$(c_flux/125)\"
print \"is sum \$(c_t[1]) \$(c_s[1]+c_k[1])\""

# Three balls between two planes: a branch of each contact, of the force f over the length l; the region has some of them
for u in 1 1e-6 1000; do
	agree "a chain between walls, u = $u" "variable u equal $u
units si
boundary f f f
neighbor \$(0.1*v_u) bin
region box block 0 \$(3*v_u) 0 \$(3*v_u) 0 \$(3*v_u) units box
create_box 1 box
create_atoms 1 single \$(1.5*v_u) \$(1.5*v_u) \$(0.499*v_u) units box
create_atoms 1 single \$(1.5*v_u) \$(1.5*v_u) \$(1.497*v_u) units box
create_atoms 1 single \$(1.5*v_u) \$(1.5*v_u) \$(2.494*v_u) units box
set group all diameter \$u density 1000
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
pair_style gran model hertz
pair_coeff * *
timestep \$(1e-6*v_u)
fix low all wall/gran model hertz primitive type 1 zplane 0
fix high all wall/gran model hertz primitive type 1 zplane \$(2.99*v_u)
region mid block \$(v_u) \$(2*v_u) \$(v_u) \$(2*v_u) \$(0.2*v_u) \$(1.1*v_u) units box
region all block 0 \$(3*v_u) 0 \$(3*v_u) 0 \$(3*v_u) units box
region beside block 0 \$(v_u) 0 \$(v_u) 0 \$(3*v_u) units box
compute s all stress/region mid
compute a all stress/region all
compute n all stress/region beside
compute p all pair/local force dz
compute w all wall/gran/local force pos primitives yes
compute f all reduce max c_p[1]
compute fl all reduce max c_w[9]
compute fh all reduce min c_w[9]
compute fa all reduce sum c_p[1]
run 0
variable low equal c_fl
variable one equal c_fa-c_f
print \"is few \$(c_s[7]) 2\"
print \"is all \$(c_a[7]) 4\"
print \"is none \$(c_n[3] + c_n[7]) 0\"
print \"is side \$(c_s[1]) 0 \$(c_s[3])\"
print \"is force \$(c_s[3]*0.9*v_u^3*10) \$(10*v_u*(v_low*(0.499-0.2)+v_one*(1.1-0.499))) \$(1e3*v_low*v_u)\"
print \"is total \$(c_a[3]*27*v_u^3) \$(v_u*(v_low*0.499+v_one*0.998+c_f*0.997-c_fh*0.496)) \$(1e2*v_low*v_u)\""
done

rejects "$gas
region out block -1 3 0 5 0 5 units box
compute s all stress/region out
thermo_style custom step c_s
run 0" 'it reaches beyond the box; give it by `volume V`'
rejects "$gas
region low block 0 5 0 5 0 1.7 units box
compute s all stress/region low virial
thermo_style custom step c_s
run 0" "wall"
finish
