#!/bin/sh
# The silo: sh run.sh [large|small [DIAMETER [-var NAME VALUE ...]]], an orifice of 60 or of 40 mm. With the grains
# of 4 mm filling takes minutes and a second of discharge twenty; with 0.012 both take seconds. TSIM is the program.
# The grains above the lip over time go to large.txt or small.txt, which plot.gp draws.
tsim=${TSIM:-tsim}
here=$(cd "$(dirname "$0")" && pwd)
size=${1:-large}
case $size in
large) orifice=0.06 lip=-0.0554222 height=0.07 ;;
small) orifice=0.04 lip=-0.0593008 height=0.08 ;;
*) echo "run.sh: large or small, not $size" >&2; exit 2 ;;
esac
d=${2:-0.004}
shift $(($# < 2 ? $# : 2))
# the cone as 64 pairs of triangles
awk -v bottom="$orifice" -v lip="$lip" -v height="$height" 'BEGIN {
	bottom /= 2
	top = lip + height
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
set -- -log none -var here "$here" -var d "$d" -var lip "$lip" "$@"
"$tsim" -in "$here/in.fill" "$@" && "$tsim" -in "$here/in.discharge" -var orifice "$orifice" -var path "$size.txt" "$@"
