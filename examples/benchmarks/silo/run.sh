#!/bin/sh
# The silo: sh run.sh [-var NAME VALUE ...] as in in.silo. TSIM is the program; discharge.txt has N(t).
tsim=${TSIM:-tsim}
here=$(cd "$(dirname "$0")" && pwd)
small=
case " $* " in *' orifice 0.04 '*) small=1 ;; esac
# the cone as 64 pairs of triangles
awk -v small="$small" 'BEGIN {
	lip = small ? -0.0593008 : -0.0554222
	top = lip + (small ? 0.08 : 0.07)
	bottom = small ? 0.02 : 0.03
	n = 64
	print "solid cone"
	for (k = 0; k < n; k++) {
		a = 2 * atan2(0, -1) * k / n
		b = 2 * atan2(0, -1) * (k + 1) / n
		triangle(bottom, a, lip, bottom, b, lip, 0.1, b, top)
		triangle(bottom, a, lip, 0.1, b, top, 0.1, a, top)
	}
	print "endsolid cone"
}
function vertex(r, angle, z) { printf "      vertex %.9g %.9g %.9g\n", r * cos(angle), r * sin(angle), z }
function triangle(r1, a1, z1, r2, a2, z2, r3, a3, z3) {
	print "  facet normal 0 0 1\n    outer loop"
	vertex(r1, a1, z1)
	vertex(r2, a2, z2)
	vertex(r3, a3, z3)
	print "    endloop\n  endfacet"
}' >cone.stl
"$tsim" -in "$here/in.silo" -log none "$@"
