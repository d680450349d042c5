#!/bin/bash
# compute mixing: exact values for segregated, ordered and known mixtures; mean and scatter over random ones.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# 1000 grains on a cubic lattice of 10^3, cells of 2^3; LENGTH is the length unit (1: metres)
lattice='units si
region box block 0 $(10*v_u) 0 $(10*v_u) 0 $(10*v_u) units box
create_box 3 box
lattice sc ${u}
create_atoms 1 region box units box
set group all type 1 diameter ${u} density 1000'

# Halves: pure samples, whatever they are weighted by. Columns of alternating types: uniform samples.
for u in 1 1e-6 1000; do
	agree "segregated and ordered, u = $u" "variable u equal $u
$lattice
region half block INF \$(3.5*v_u) INF INF INF INF units box
group half region half
compute l all mixing lacey group half cell \$(2*v_u)
compute k all mixing kramer group half cell \$(2*v_u) weight mass
compute i all mixing intensity group half cell \$(2*v_u) weight volume
variable x2 atom x
compute a all mixing lacey above v_x2 \$(3.5*v_u) cell \$(2*v_u) weight volume
variable odd atom (floor(x/v_u)%2)+1
compute o all mixing lacey above v_odd 1.5 cell \$(2*v_u)
compute ok all mixing kramer above v_odd 1.5 cell \$(2*v_u)
compute oi all mixing intensity above v_odd 1.5 cell \$(2*v_u)
compute or all mixing rsd above v_odd 1.5 cell \$(2*v_u)
print \"is segregated \$(c_l) 0 1\"
print \"is kramer \$(c_k) 0 1\"
print \"is intensity \$(c_i) 1\"
print \"is share \$(c_l[1]) 0.4\"
print \"is s0 \$(c_l[3]) 0.24\"
print \"is random \$(c_l[4]) \$(0.24*124/999)\"
print \"is samples \$(c_l[5]) 125\"
print \"is above \$(c_a) \$(c_l) 1\"
print \"is rest \$(c_a[1]) 0.6\"
print \"is ordered \$(c_o) \$(1/(1-124/999))\"
print \"is ordered \$(c_ok) \$(1/(1-sqrt(124/999)))\"
print \"is ordered \$(c_oi) 0 1\"
print \"is ordered \$(c_or) 0 1\""
done

# A mixture by hand: three slices of 1, 2 and 3 kg grains; samples of unequal size; the random limit from its definition
hand='units si
region box block 0 3 0 4 0 1 units box
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 2 single 0.5 1.5 0.5 units box
create_atoms 2 single 1.5 0.5 0.5 units box
create_atoms 1 single 1.5 1.5 0.5 units box
create_atoms 1 single 1.5 2.5 0.5 units box
create_atoms 2 single 2.5 0.5 0.5 units box
set group all diameter 0.5
variable m atom id
set group all mass v_m
compute slices all chunk/atom bin/1d x 0 1 units box'
agree 'by hand' "$hand
compute n all mixing lacey type 2 chunks slices
compute m all mixing lacey type 2 chunks slices weight mass
compute two all mixing intensity type 2 chunks slices least 2
compute p all mixing poole type 2 cell 1 origin 0 -10 0
compute r all mixing rsd type 2 chunks slices weight mass
variable s2 equal (2*0+3*(1/3-0.5)^2+1*0.25)/6
variable sr equal 2/5*0.25
variable p equal 11/21
variable t2 equal (3*(2/3-v_p)^2+12*(3/12-v_p)^2+6*(1-v_p)^2)/21
variable tr equal 2/5*6*((1-v_p)^2*(4+9+36)+v_p^2*(1+16+25))/21^2
print \"is variance \$(c_n[2]) \$(v_s2)\"
print \"is number \$(c_n) \$((0.25-v_s2)/(0.25-v_sr))\"
print \"is share \$(c_m[1]) \$(v_p)\"
print \"is variance \$(c_m[2]) \$(v_t2)\"
print \"is random \$(c_m[4]) \$(v_tr)\"
print \"is mass \$(c_m) \$((v_p*(1-v_p)-v_t2)/(v_p*(1-v_p)-v_tr))\"
print \"is rsd \$(c_r) \$(sqrt(v_t2)/v_p)\"
print \"is row \$(c_m[2][1]) 0.25\"
print \"is row \$(c_m[2][2]) 3\"
print \"is row \$(c_m[2][3]) 12\"
print \"is least \$(c_two[6]) 5\"
print \"is least \$(c_two[1]) 0.4\"
print \"is least \$(c_two) \$((2*0.01+3*(1/3-0.4)^2)/5/0.24)\"
print \"is empty \$(c_two[3][1]) 1\"
print \"is poole \$(c_p) 0 1\"
print \"is cells \$(c_p[5]) 6\""

# Undefined: no particles, one component, one sample, single particles
agree 'undefined: 0, and the number of samples tells' "$hand
group none empty
compute e none mixing lacey type 2 chunks slices
compute o all mixing lacey type 1*2 chunks slices
compute s all mixing kramer type 2 cell 100
compute l all mixing lacey type 2 cell 0.9 least 7
compute i none mixing intensity type 2 cell 1
compute r none mixing rsd type 2 cell 1
compute p all mixing poole type 1 cell 1
print \"is none \$(c_e) 0\"
print \"is none \$(c_e[5]) 0\"
print \"is one \$(c_o) 0\"
print \"is single \$(c_s) 0\"
print \"is single \$(c_s[5]) 1\"
print \"is least \$(c_l) 0\"
print \"is least \$(c_l[5]) 0\"
print \"is none \$(c_i) 0\"
print \"is none \$(c_r) 0\"
print \"is alone \$(c_p) 0\""

# Random labels: the mean over 400 seeds is 1. The scatter of s^2/s_r^2 is that of chi^2 with K - 1 degrees of
# freedom, reduced by (n - 1)/n for samples of n = 8. Two sizes by mass: 1 to first order in 1/n.
random() {
	local what=$1 extra=$2 weight=$3 tolerance=$4
	printf '%s\n' "variable u equal 1
$lattice
label again
variable s loop 400
set group all type 1
set group all type/fraction 2 0.3 \${s}771
$extra
compute l all mixing lacey type 2 cell 2 weight $weight
print \"M \$(c_l) \$(c_l[3]) \$(c_l[4])\"
uncompute l
next s
jump SELF again" >in.random
	"$TSIM" -in in.random -log none >out 2>&1 && awk -v t="$tolerance" -v weight="$weight" '
		$1 == "M" { n++; s += $2; q += $2 * $2; width += $4 / ($3 - $4) * sqrt(2 / 124 * 7 / 8) }
		END {
			mean = s / n; sd = sqrt(q / n - mean * mean); width /= n
			print "mean", mean, "+-", sd / sqrt(n), "scatter", sd, "expected", width
			exit !(n == 400 && (mean - 1)^2 < (t + 3 * sd / sqrt(n))^2 &&
			       (weight == "mass" || (sd > 0.88 * width && sd < 1.12 * width)))
		}' out >>out
	report "random: $what" $? out
}
random 'by number' '' number 0
random 'one size by mass' '' mass 0
random 'two sizes by mass, diameters 1 and 1.26' 'set type 2 diameter 1.26' mass 0.004
random 'two sizes by volume, diameters 1 and 2' 'set type 2 diameter 2' volume 0.03

# Threads and the order in memory do not matter: a random mixture, sorted in space by a run
printf '%s\n' "variable u equal 1
$lattice
set group all type/fraction 2 0.3 4711
set type 2 diameter 0.7
compute l all mixing lacey type 2 cell 2.5 weight mass
print \"M \$(c_l) \$(c_l[2]) \$(c_l[4])\"
velocity all set 0 0 0
fix move all nve/sphere
neighbor 0.3 bin
pair_style spring/dashpot
pair_coeff * * stiffness 1 damping 0
timestep 1e-3
atom_modify sort 1 1
run 3
print \"M \$(c_l) \$(c_l[2]) \$(c_l[4])\"
write_restart restart" >in.order
for n in 1 3; do
	OMP_NUM_THREADS=$n "$TSIM" -in in.order -log none >out 2>&1
	report "$n threads" $? out
	grep '^M [0-9]' out >order.$n
done
same 'threads' order.1 order.3
[ "$(uniq order.1 | wc -l)" = 1 ]
report 'order in memory' $? order.1

rejects "$hand
compute m all mixing lacey type 2" 'expected either `chunks ID`'
rejects "$hand
compute m all mixing lacey type 2 cell 1 chunks slices" 'expected either `chunks ID`'
rejects "$hand
compute m all mixing lacy type 2 cell 1" "lacey"
rejects "$hand
compute m all mixing lacey type 2 cell -1" 'cell'
rejects "$hand
compute m all mixing lacey type 2 chunks slice" 'slice'
rejects "$hand
compute m all mixing lacey group red cell 1" 'red'
rejects "$hand
compute m all mixing lacey above mass2 1 cell 1" 'mass2'
rejects "$hand
compute m all mixing lacey above mass cell 1" 'limit'
finish
