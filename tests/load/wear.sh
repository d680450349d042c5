#!/bin/bash
# Depth worn from a triangle by one impact, against the integral of Finnie's law over it.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

# I. Finnie, Wear 3 (1960) 87, as manual and src/law/contact_wear.h have it: dW/dt = 2 k v F f(g)/A while the grain comes nearer,
# f = cos^2 g/3 for tan g > 1/3, else sin 2g - 3 sin^2 g. Without friction the speed t along the surface stays, and that
# towards it, u, goes from its first value to 0 by F dt = -m du, whatever the spring. With s = sqrt(t^2 + u^2),
# sin g = u/s and cos g = t/s the depth is, exactly,
#
#	W = 2 k m/A (int_0^(t/3) (2 t u - 3 u^2)/s du + int_(t/3)^U t^2/(3 s) du),
#
# the second integral, where the grain hits at U > t/3 only, being t^2/3 (arsinh U/t - arsinh 1/3). The factor 1/3 of f
# is 0.33333 in LIGGGHTS and here.
# finnie K A T U: that depth, for the sphere below
finnie() {
	awk -v k="$1" -v area="$2" -v t="$3" -v u="$4" '
		function arsinh(x) { return log(x + sqrt(x * x + 1)) }
		BEGIN {
			m = 2385 * 4 * atan2(1, 1) / 6 * 0.1 ^ 3
			low = u < t / 3 ? u : t / 3
			if (!t) { print 0; exit }
			s = sqrt(t * t + low * low)
			w = 2 * t * (s - t) - 1.5 * (low * s - t * t * arsinh(low / t))
			if (u > low) w += 0.33333 * t * t * (arsinh(u / t) - arsinh(low / t))
			printf "%.12g\n", 2 * k * m / area * w
		}'
}

printf '%s\n' '-0.5 -0.4 0 0.5 -0.4 0 -0.5 0.4 0' '0.5 -0.4 0 0.5 0.4 0 -0.5 0.4 0' | solid >plate.stl # 0.4 each
cat >in.hit <<'END'
units si
region b block -1 1 -1 1 -1 1 units box
create_box 2 b
neighbor 0.01 bin
fix kn all property/global kn peratomtypepair 2 1e6 1e6 1e6 1e6
fix kt all property/global kt peratomtypepair 2 0 0 0 0
fix gn all property/global gamman peratomtypepair 2 0 0 0 0
fix gt all property/global gammat peratomtypepair 2 0 0 0 0
fix mu all property/global coefficientFriction peratomtypepair 2 0 0 0 0
fix k all property/global k_finnie peratomtypepair 2 1.3e-3 2.1e-3 2.1e-3 3.3e-3
pair_style gran model hooke/stiffness
pair_coeff * *
fix cad all mesh/surface/stress file plate.stl type 2 wear finnie
fix w all wall/gran model hooke/stiffness mesh n_meshes 1 meshes cad
create_atoms 1 single -0.2 -0.15 0.0501 units box
set group all diameter 0.1 density 2385
velocity all set ${x} ${y} -${u} units box
fix integrate all nve/sphere
if "${belt} != 0" then "fix belt all move/mesh mesh cad linear -${belt} 0 0"
# half a period is pi sqrt(m/k) = 0.0035
timestep ${h}
run $(ceil((1e-4/v_u+0.0036)/dt))
print "back $(vz[1]/v_u:%.6g)"
dump last all mesh/vtk 1 last.*.vtk wear cad
run 0
END
# hit WHAT X Y U BELT: the depth of the triangle that is hit is that of the formula; the other is not worn. Forces and
# velocities are half a step apart: the depths of two steps give that of a step of 0.
hit() {
	local wanted t h
	for h in 1e-6 5e-7; do
		rm -f ./*.vtk
		"$TSIM" -in in.hit -log none -var x "$2" -var y "$3" -var u "$4" -var belt "$5" -var h $h >out 2>&1 && grep -qx 'back 1' out
		report "$1, step $h: it comes back as fast" $? out
		awk '/^wear/ { n = $3; next } /^LOOKUP/ { next } { for (k = 1; k <= NF && n; k++) { print $k; n-- } }' last.*.vtk >depths.$h
	done
	t=$(awk -v x="$2" -v y="$3" -v belt="$5" 'BEGIN { printf "%.15g", sqrt((x + belt) ^ 2 + y * y) }')
	wanted=$(finnie 2.1e-3 0.4 "$t" "$4")
	paste -d ' ' depths.1e-6 depths.5e-7 | awk -v wanted="$wanted" '
		NR == 1 { w = 2 * $2 - $1; d = w - wanted; print "worn " w ", by the formula " wanted }
		NR == 1 ? !(d * d <= (1e-6 * wanted) ^ 2) : $1 != 0 || $2 != 0 { bad = 1; print "off" }
		END { exit bad || NR != 2 }' OFMT=%.12g CONVFMT=%.12g >depths
	report "$1: depth" $? depths
	echo "$1: $(cat depths)"
}
hit 'at 60 degrees' 0.3 0.4 0.8660254037844386 0
hit 'at 30 degrees' 0.6928203230275509 -0.52 0.5 0
hit 'at 10 degrees' -0.48 0.36 0.10579618842507 0
hit 'straight down on a belt' 0 0 0.8660254037844386 0.5
hit 'beside the belt' -0.5 0 0.8660254037844386 0.5
finish
