#!/bin/bash
# compute quantile: known distributions by number, mass and volume.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# 1000 grains of diameters d_k = 1 + k/1000 by id k = 1 ... 1000: the part q by number ends at k = 1000 q, by volume where
# the sum of d^3 is q of the whole
cat >in.sizes <<'END'
variable u index 1
units si
region b block 0 $(10*v_u) 0 $(10*v_u) 0 $(10*v_u) units box
create_box 2 b
lattice sc ${u}
create_atoms 1 region b units box
variable d atom v_u*(1+id/1000)
set group all density 2385
set group all diameter v_d
END
volume() { awk -v q="$1" 'BEGIN { for (k = 1; k <= 1000; k++) w += (1 + k/1000)^3
	for (k = 1; k <= 1000; k++) { s += (1 + k/1000)^3; if (s > q*w) { printf "%.17g", 1 + k/1000; exit } } }'; }
for u in 1 1e-6; do
	agree "quantiles, u = $u" "variable u index $u
include in.sizes
compute n all quantile diameter 0 0.1 0.5 0.9 0.99 1 0.0005
compute v all quantile diameter 0.1 0.5 0.9 weight volume
compute m all quantile diameter 0.1 0.5 0.9 weight mass
variable minus atom -v_d
compute r all quantile v_minus 0.1 0.5 0.9 weight mass
print \"is count \$(c_n) 1000\"
print \"is least \$(c_n[1]/v_u) 1.001\"
print \"is d10 \$(c_n[2]/v_u) 1.1005\"
print \"is median \$(c_n[3]/v_u) 1.5005\"
print \"is d90 \$(c_n[4]/v_u) 1.9005\"
print \"is d99 \$(c_n[5]/v_u) 1.9905\"
print \"is most \$(c_n[6]/v_u) 2\"
print \"is first \$(c_n[7]/v_u) 1.001\"
print \"is v10 \$(c_v[1]/v_u) $(volume 0.1)\"
print \"is v50 \$(c_v[2]/v_u) $(volume 0.5)\"
print \"is v90 \$(c_v[3]/v_u) $(volume 0.9)\"
print \"is m10 \$(c_m[1]) \$(c_v[1])\"
print \"is m90 \$(c_m[3]) \$(c_v[3])\"
print \"is mirror \$(c_r[1]) \$(-c_v[3])\"
print \"is mirror \$(c_r[3]) \$(-c_v[1])\""
done
# mass counts density: the half of small ids three times as heavy has 3/4 of it, grains of one size
agree 'quantiles by mass' 'include in.sizes
set group all diameter 0.5
group low id 1:500
set group low density 7155
compute m all quantile id 0.75 0.375 0.5 weight mass
compute v all quantile id 0.5 weight volume
print "is a $(c_m[1]) 500.5"
print "is b $(c_m[2]) 250.5"
print "is c $(c_m[3]) 334"
print "is v $(c_v[1]) 500.5"
group none empty
compute e none quantile id 0.5
print "is none $(c_e[1]) 0"
print "is count $(c_e) 0"
compute o all quantile id 0.25 0.5
group one id 7
compute o1 one quantile id 0 0.3 1
print "is one $(c_o1[1]) 7"
print "is one $(c_o1[2]) 7"
print "is one $(c_o1[3]) 7"'
rejects 'include in.sizes
compute n all quantile diameter 50' 'expected a part from 0 to 1'
rejects 'include in.sizes
compute n all quantile diameter' 'parts'
rejects 'include in.sizes
compute n all quantile step 0.5' 'step'
finish
