#!/bin/bash
# Seams of triangles that are flat to `curvature` but bulge: above them a sphere is beyond the faces of all triangles, and has
# one contact, at the edge or corner that they share. Forces by the distance from the surface, and a ball that rolls over.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
. "$top_srcdir/tests/lib_meshes.sh"

# A roof of two faces, of which each has two triangles, sloping by 0.001; a pyramid of four faces of this slope.
printf '%s\n' '-1 -1 -1e-3 0 -1 0 0 1 0' '-1 -1 -1e-3 0 1 0 -1 1 -1e-3' '0 -1 0 1 -1 -1e-3 1 1 -1e-3' \
	'0 -1 0 1 1 -1e-3 0 1 0' | solid >roof.stl
printf '%s\n' '0 0 0 -1 -1 -1e-3 1 -1 -1e-3' '0 0 0 1 -1 -1e-3 1 1 -1e-3' '0 0 0 1 1 -1e-3 -1 1 -1e-3' \
	'0 0 0 -1 1 -1e-3 -1 -1 -1e-3' | solid >pyramid.stl
scene() { # MESH X Y: the centre 0.1999 above the ridge, R = 0.2: the strip extends to x = 0.0002
	echo "units si
atom_style granular
atom_modify map array
newton off
communicate single vel yes
boundary f f f
region box block -2 2 -2 2 -1 1 units box
create_box 1 box
create_atoms 1 single $2 $3 0.1999 units box
set atom 1 diameter 0.4 density 2500
fix m1 all property/global youngsModulus peratomtype 1e8
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-6
fix cad all mesh/surface file $1.stl type 1
fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad
fix move all nve/sphere
variable E equal 1e8/(2*(1-0.3^2))"
}
# forces OF DISTANCE NX NY: the contact at this distance from the centre in the direction of the centre
forces() {
	echo "run 0
variable f equal 4/3*v_E*sqrt(0.2)*(0.2-($1))^1.5
print \"is fx \$(fx[1]) \$(v_f*($2)) \$(v_f*10)\"
print \"is fy \$(fy[1]) \$(v_f*($3)) \$(v_f*10)\"
print \"is fz \$(fz[1]) \$(v_f*0.1999/($1)) \$(v_f*10)\""
}
for x in 0 1e-5 -1e-5 -1.9e-4 1.9e-4; do
	agree "above the ridge, at $x" "$(scene roof $x 0.3)
$(forces "sqrt(0.1999^2+$x^2)" "$x/sqrt(0.1999^2+$x^2)" 0)"
done
agree 'beside the ridge' "$(scene roof 0.01 0.3)
variable c equal 1/sqrt(1+1e-6)
variable d equal (0.1999+0.01*1e-3)*v_c
run 0
variable f equal 4/3*v_E*sqrt(0.2)*(0.2-v_d)^1.5
print 'is fx \$(fx[1]) \$(v_f*1e-3*v_c) \$(v_f*100)'
print 'is fz \$(fz[1]) \$(v_f*v_c) \$(v_f*100)'"
for at in '0 0' '1e-5 2e-5' '-3e-5 1e-6' '-1e-5 -1e-5'; do
	x=${at% *} y=${at#* }
	agree "above the top, at $at" "$(scene pyramid "$x" "$y")
$(forces "sqrt(0.1999^2+$x^2+$y^2)" "$x/sqrt(0.1999^2+$x^2+$y^2)" "$y/sqrt(0.1999^2+$x^2+$y^2)")"
done
# A ball that is led over the ridge: one contact all the time, whose spring goes from face to edge to face.
scene roof -0.002 0.3 | sed 's/nve\/sphere/nve\/noforce/; s/peratomtypepair 1 0.4/peratomtypepair 1 1e3/; s/peratomtypepair 1 0.9/peratomtypepair 1 1/' >in.led
echo 'set atom 1 vx 0.5
variable x equal fx[1]
variable z equal fz[1]
thermo_style custom step v_x v_z
thermo_modify format float %.12g
thermo 20
run 8000' >>in.led
"$TSIM" -in in.led -log none >out 2>&1
rows out | awk 'NR > 2 { bad = bad || !($2 < x) || !($3 > 0.97 * z && $3 < 1.03 * z) } { x = $2; z = $3 }
	END { exit bad || NR < 400 }' >led
report 'over the ridge' $? out
finish
