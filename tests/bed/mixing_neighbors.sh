#!/bin/bash
# compute mixing/contact, mixing/neighbor and mixing/gmmi: exact values on lattices, means and scatter of random mixtures.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# 1000 grains on a cubic lattice, in a box with walls (f) or periodic (p)
lattice='units si
boundary ${b} ${b} ${b}
region box block 0 $(10*v_u) 0 $(10*v_u) 0 $(10*v_u) units box
create_box 2 box
lattice sc ${u}
region in block $(0.1*v_u) $(9.9*v_u) $(0.1*v_u) $(9.9*v_u) $(0.1*v_u) $(9.9*v_u) units box
lattice sc ${u} origin 0.5 0.5 0.5
create_atoms 1 region in units box
set group all diameter $(1.01*v_u) density 1000
variable checker atom floor(x/v_u)+floor(y/v_u)+floor(z/v_u)
variable checker2 atom v_checker-2*floor(v_checker/2)'

for u in 1 1e-6 1000; do
	agree "lattice with walls, u = $u" "variable u equal $u
variable b string f
$lattice
region low block INF INF INF INF INF \$(4*v_u) units box
group low region low
group none empty
compute c all mixing/contact group low
compute o all mixing/contact above v_checker2 0.5
compute k all mixing/contact group low random contacts
compute g all mixing/contact group low gap \$(0.45*v_u)
compute e none mixing/contact group low
compute l low mixing/contact group low
compute m all mixing/gmmi group low
compute r all mixing/gmmi group low reference 0 0 \$(-5*v_u)
compute mo all mixing/gmmi above v_checker2 0.5
compute me none mixing/gmmi group low
print \"is contacts \$(c_c[3]) 2700\"
print \"is unlike \$(c_c[5]) 100\"
print \"is like \$(c_c[4]) \$(2*40*9+3*100)\"
print \"is like \$(c_c[4]) 1020\"
print \"is rest \$(c_c[6]) \$(2700-1020-100)\"
print \"is random \$(c_c[2]) \$(2*400*600/(1000*999))\"
print \"is index \$(c_c) \$(100/2700/(2*400*600/(1000*999)))\"
print \"is ordered \$(c_o) \$(1/(2*500*500/(1000*999)))\"
print \"is ends \$(c_k[2]) \$(2*(1020+50)/2700*(1580+50)/2700)\"
print \"is gap \$(c_g[3]) \$(2700+3*10*2*81)\"
print \"is gap \$(c_g[5]) \$(100+2*2*90)\"
print \"is none \$(c_e) 0\"
print \"is none \$(c_e[3]) 0\"
print \"is one \$(c_l) 0\"
print \"is centre \$(c_m[3]) \$(1.5/4.5)\"
print \"is centre \$(c_m[1]) 1\"
print \"is mean \$(c_m) \$((2+1.5/4.5)/3)\"
print \"is distance \$(c_m[6]) \$(-5/sqrt(99/12))\"
print \"is distance \$(c_m[4]) 0 1\"
print \"is reference \$(c_r[3]) \$(7/10)\"
print \"is mixed \$(c_mo) 1\"
print \"is none \$(c_me) 0\""

	agree "periodic lattice, u = $u" "variable u equal $u
variable b string p
$lattice
region low block INF INF INF INF INF \$(4*v_u) units box
group low region low
group few id 1:6
compute n all mixing/neighbor group low neighbors 6
compute o all mixing/neighbor above v_checker2 0.5 neighbors 6
compute c all mixing/contact group low
compute f few mixing/neighbor above v_checker2 0.5 neighbors 6
compute m all mixing/gmmi group low
compute most all reduce max c_n
compute sum all reduce sum c_n
print \"is share \$(c_n[1]) \$(400/6000)\"
print \"is random \$(c_n[2]) \$(2*400*600/(1000*999))\"
print \"is index \$(c_n) \$(400/6000/(2*400*600/(1000*999)))\"
print \"is most \$(c_most) \$(1/6)\"
print \"is sum \$(c_sum) \$(400/6)\"
print \"is ordered \$(c_o) \$(1/(2*500*500/(1000*999)))\"
print \"is contacts \$(c_c[3]) 3000\"
print \"is unlike \$(c_c[5]) 200\"
print \"is few \$(c_f) 0\"
print \"is few \$(c_f[3]) 0\"
print \"is periodic \$(c_m) 0\""
done

# Random labels, half and half: contacts are then unlike independently of each other in pairs, so that the share has the
# scatter of that many independent draws; neighbours are here the contacts.
printf '%s\n' 'variable u equal 1
variable b string p' "$lattice" 'label again
variable s loop 400
set group all type 1
set group all type/fraction 2 0.5 ${s}313
compute c all mixing/contact type 2
compute n all mixing/neighbor type 2 neighbors 6
compute m all mixing/contact type 2 random contacts
print "M $(c_c) $(c_n) $(c_m)"
uncompute c
uncompute n
uncompute m
next s
jump SELF again' >in.random
"$TSIM" -in in.random -log none >out 2>&1 && awk '
	$1 == "M" { n++; s += $2; q += $2 * $2; differs += ($2 - $3)^2 > 1e-24; t += $4 }
	END {
		mean = s / n; sd = sqrt(q / n - mean * mean); width = sqrt(1 / 3000)
		print "mean", mean, t / n, "scatter", sd, "expected", width
		exit !(n == 400 && !differs && (mean - 1)^2 < (3 * sd / sqrt(n))^2 && (t / n - 1)^2 < 0.005^2 &&
		       sd > 0.88 * width && sd < 1.12 * width)
	}' out >>out
report 'random mixtures' $? out

# Threads
printf '%s\n' 'variable u equal 1
variable b string p' "$lattice" 'set group all type/fraction 2 0.3 4711
displace_atoms all random 0.2 0.2 0.2 8123 units box
compute c all mixing/contact type 2
compute n all mixing/neighbor type 2
compute m all mixing/gmmi type 2
print "M $(c_c) $(c_n) $(c_m)"' >in.order
for n in 1 3; do
	OMP_NUM_THREADS=$n "$TSIM" -in in.order -log none >out 2>&1
	report "$n threads" $? out
	grep '^M [0-9]' out >order.$n
done
same 'threads' order.1 order.3

scene='units si
region box block 0 1 0 1 0 1 units box
create_box 2 box'
rejects "$scene
compute m all mixing/neighbor type 2 neighbors 0" 'neighbors'
rejects "$scene
compute m all mixing/contact type 2 gap -1" 'gap'
rejects "$scene
compute m all mixing/gmmi reference 0 0 0" 'reference'
rejects "$scene
compute m all mixing/contact above v_x 3" "unknown variable"
finish
