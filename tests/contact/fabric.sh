#!/bin/bash
# compute fabric: contacts along one axis and crystals, where the tensors are known, and the sums of their definition, made by
# awk from the list of contacts.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Crystals have no anisotropy
agree 'a crystal' 'units si
boundary p p p
region box block 0 4 0 4 0 4 units box
create_box 1 box
lattice sc 1
create_atoms 1 box
set group all diameter 1.001 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0
timestep 1e-4
compute f all fabric radius contact branch force/normal force/tangential force/shear
run 0
print "is contacts $(c_f) $(3*atoms)"
variable most equal "abs(c_f[1])+abs(c_f[7])+abs(c_f[13])+abs(c_f[19])+abs(c_f[25])+abs(c_f[4])+abs(c_f[16])"
print "is most $(v_most + 1) 1"'

# A chain along x: R = (1, 0, 0), a_c = 15/2 (2/3, -1/3, -1/3), in two dimensions 4 (1/2, -1/2)
for u in 1 1e-6 1000; do
	for dimension in 2 3; do
		agree "a chain, u = $u, $dimension dimensions" "variable u equal $u
units si
dimension $dimension
boundary f f $([ $dimension = 2 ] && echo p || echo f)
region box block 0 \$(4*v_u) 0 \$(4*v_u) \$(-0.5*v_u) \$(0.5*v_u) units box
create_box 2 box
create_atoms 1 single \$(0.5*v_u) \$(2*v_u) 0 units box
create_atoms 2 single \$(1.499*v_u) \$(2*v_u) 0 units box
create_atoms 1 single \$(2.498*v_u) \$(2*v_u) 0 units box
set group all diameter \$u density 1000
pair_style spring/dashpot
pair_coeff * * stiffness \$(2385*v_u) damping 0
timestep \$(1e-4*v_u)
group first id 1
group none empty
compute f all fabric radius contact branch force/normal force/tangential
compute t all fabric type contact type/include 1 1
compute u all fabric type contact type/include 2 * type/include 2 2
compute n first fabric radius contact branch
compute o none fabric radius force/normal contact
run 0
variable a equal $((dimension == 3 ? 5 : 2))
print \"is contacts \$(c_f) 2\"
print \"is contact \$(c_f[1]) \$(v_a)\"
print \"is contact \$(c_f[2]) \$(-v_a/($dimension-1))\"
print \"is contact \$(c_f[3]) $((dimension == 3 ? -25 : 0))e-1\"
print \"is branch \$(c_f[7]) \$(v_a) 100\"
print \"is force \$(c_f[13]) \$(v_a) 100\"
print \"is tangential \$(c_f[19]) 0 1\"
print \"is none \$(c_t) 0\"
print \"is both \$(c_u) 2\"
print \"is single \$(c_n + c_n[1] + c_n[7]) 0\"
print \"is empty \$(c_o + c_o[1] + c_o[7]) 0\""
	done
done

# A loose box of rough grains, sheared for a moment
cat >in.grains <<'E2'
units si
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
fix 1 all nve/sphere
compute f all fabric radius contact branch force/normal force/shear force/tangential
compute i all fabric radius contact type/include 1 2
compute p all pair/local dx dy dz fx fy fz
compute q all property/local patom1 patom2 ptype1 ptype2
dump d all local 30 pairs.txt c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6] c_q[3] c_q[4]
dump_modify d format float %.17g
fix out all ave/time 1 1 30 c_f[*] c_i[*] file tensors.txt format " %.17g"
run 30
E2
cat >reference.awk <<'E2'
# pairs.txt, the last frame: the tensors in the order of in.grains, by the formulas of the manual page
/^ITEM/ { if ($2 == "ENTRIES") { n = 0; on = 1 } else on = 0; next }
on { n++; for (k = 1; k <= 8; k++) v[n, k] = $k }
function tensor(t, p, q, w) { for (k = 1; k <= 6; k++) t[k] += w * p[I[k]] * q[J[k]] }
function print_deviator(t, factor, scale) {
	tr = (t[1] + t[2] + t[3]) / 3
	for (k = 1; k <= 6; k++) printf " %.15g", factor * (t[k] - (k <= 3 ? tr : 0)) / scale
}
function direction(c, k) {
	l = sqrt(v[c, 1]^2 + v[c, 2]^2 + v[c, 3]^2)
	f = 0
	for (k = 1; k <= 3; k++) { u[k] = v[c, k] / l; f += u[k] * v[c, 3 + k] }
	size = 0
	for (k = 1; k <= 3; k++) { g[k] = v[c, 3 + k] - f * u[k]; size += g[k]^2 }
	size = sqrt(size)
}
END {
	split("1 2 3 1 1 2", I, " "); split("1 2 3 2 3 3", J, " ")
	for (c = 1; c <= n; c++) {
		direction(c); tensor(R, u, u, 1)
		if (v[c, 7] != v[c, 8]) { m++; tensor(M, u, u, 1) }
	}
	for (k = 1; k <= 6; k++) a[k] = 7.5 * (R[k] / n - (k <= 3 ? 1 / 3 : 0))
	for (c = 1; c <= n; c++) {
		direction(c)
		w = 1
		for (k = 1; k <= 6; k++) w += (k <= 3 ? 1 : 2) * a[k] * u[I[k]] * u[J[k]]
		tensor(D, u, u, l / w); tensor(N, u, u, f / w); tensor(S, u, u, size / w)
		tensor(T, g, u, 0.5 / w); tensor(T, u, g, 0.5 / w)
	}
	normal = N[1] + N[2] + N[3]
	printf "30"
	print_deviator(R, 7.5, n); print_deviator(D, 7.5, D[1] + D[2] + D[3]); print_deviator(N, 7.5, normal)
	print_deviator(T, 5, normal); print_deviator(S, 5, normal); print_deviator(M, 7.5, m)
	print ""
}
E2
"$TSIM" -in in.grains -log none >out 2>&1
report 'a box of grains' $? out
awk -f reference.awk pairs.txt >reference
tail -n 1 tensors.txt | paste -d ' ' - reference | awk '{ n = NF / 2
	for (k = 1; k <= n; k++) if (!(($k - $(k + n))^2 < 1e-24) || $k == 0) { print "column", k, $k, $(k + n); bad = 1 }
	ok = !bad && n == 37 } END { exit !ok }' >off
report 'sums of the definition' $? off
cp tensors.txt one.txt
"$TSIM" -in in.grains -log none -threads 3 >out 2>&1
same 'three threads' one.txt tensors.txt

# Directions for which the expansion is negative: a row of contacts along x and one along y
chain='units si
region box block 0 30 0 4 0 4 units box
create_box 2 box
lattice sc 1
region row block 0.5 29 1.5 2.5 1.5 2.5 units box
create_atoms 1 region row
create_atoms 1 single 5 3 2 units box
set group all diameter 1.001 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 2385 damping 0
timestep 1e-4'
printf '%s\n' "$chain" 'compute f all fabric radius contact force/normal' 'thermo_style custom step c_f[1] c_f[7]' 'run 0' >in.script
"$TSIM" -in in.script -log none >out 2>&1 && awk '/Step/ { getline; ok = ($2 > 0 && $3 ~ /nan/); exit } END { exit !ok }' out
report 'a negative expansion' $? out
rejects "$chain
compute f all fabric radius contact type/include 1" 'needs two lists of types'
rejects "$chain
compute f all fabric radius contact type/include 1 1,x" "found '1,x'"
rejects "$chain
compute f all fabric radius contact type/include 1 2*3" 'types are 1 to 2'
rejects "$chain
compute f all fabric radius contact contact
thermo_style custom step c_f[1]
run 0" 'named twice'
rejects "$chain
compute f all fabric radius force" 'force/normal'
rejects "$chain
compute f all fabric radius contact
print '\$(c_f[1])'" 'only after a run'
finish
