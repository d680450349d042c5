# For shell tests: files of triangles, and the head of scripts that use them.

# solid: lines of nine numbers on standard input become an STL file
solid() {
	awk 'BEGIN { print "solid made" }
		{
			print " facet normal 0 0 0\n  outer loop"
			for (k = 1; k <= 7; k += 3) printf "   vertex %.17g %.17g %.17g\n", $k, $(k + 1), $(k + 2)
			print "  endloop\n endfacet"
		}
		END { print "endsolid made" }'
}

# plate N Z: a square of side 1 about the z axis, of N x N pairs of triangles, cut along either diagonal
plate() {
	awk -v n="$1" -v z="$2" 'function p(i, j) {
		return sprintf("%.17g %.17g %.17g", -0.5 + i / n, -0.5 + j / n, z)
	}
	BEGIN {
		for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
			a = p(i, j); b = p(i + 1, j); c = p(i + 1, j + 1); d = p(i, j + 1)
			if ((5 * i + 3 * j) % 4 < 2) { print a, b, c; print a, c, d } else { print b, c, d; print a, b, d }
		}
	}' | solid
}

# cuboid A B C: of half edges A B C about the origin, normals outwards
cuboid() {
	awk -v a="$1" -v b="$2" -v c="$3" 'function p(k) {
		return (k % 2 ? a : -a) " " (int(k / 2) % 2 ? b : -b) " " (k > 3 ? c : -c)
	}
	BEGIN {
		n = split("0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3 0 4 6 0 6 2 1 3 7 1 7 5", k)
		for (i = 1; i <= n; i += 3) print p(k[i]), p(k[i + 1]), p(k[i + 2])
	}' | solid
}

# funnel N: a square funnel of N segments around, from radius 0.4 at z = 0.8 over 0.4 at 0.3 to 0.1 at -0.2
funnel() {
	awk -v n="$1" 'function p(r, z, k) {
		return sprintf("%.17g %.17g %.17g", r * cos(2 * 3.14159265358979 * k / n), r * sin(2 * 3.14159265358979 * k / n), z)
	}
	BEGIN {
		r[0] = r[1] = 0.4; r[2] = r[3] = 0.1; z[0] = 0.8; z[1] = 0.3; z[2] = -0.2; z[3] = -0.4
		for (j = 0; j < 3; j++) for (k = 0; k < n; k++) {
			print p(r[j], z[j], k), p(r[j + 1], z[j + 1], k), p(r[j + 1], z[j + 1], k + 1)
			print p(r[j], z[j], k), p(r[j + 1], z[j + 1], k + 1), p(r[j], z[j], k + 1)
		}
	}' | solid
}

# springs: frictionless contacts of two types, springs of 1e6 without damping
springs() {
	cat <<'END3'
fix kn all property/global kn peratomtypepair 2 1e6 1e6 1e6 1e6
fix kt all property/global kt peratomtypepair 2 0 0 0 0
fix gn all property/global gamman peratomtypepair 2 0 0 0 0
fix gt all property/global gammat peratomtypepair 2 0 0 0 0
fix mu all property/global coefficientFriction peratomtypepair 2 0 0 0 0
END3
}

# two_materials: a box of side 2 about the origin, for grains of type 1 and meshes of type 2
two_materials() {
	cat <<'END3'
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
region reg block -1 1 -1 1 -1 1 units box
create_box 2 reg
neighbor 0.01 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6 6.3e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.31
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.6 0.6 0.7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.4 0.4 0.3
END3
}
