#!/bin/bash
# compute coordination: crystals, whose coordination is known, and packings with loose grains.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# crystal LATTICE CONTACTS DISTANCE: periodic, all grains touch; DISTANCE of neighbours in lattice constants
crystal() {
	local u
	for u in 1 1e-6 1000; do
		agree "$1, u = $u" "variable u equal $u
units si
boundary p p p
region box block 0 \$(4*v_u) 0 \$(4*v_u) 0 \$(4*v_u) units box
create_box 1 box
lattice $1 \${u}
create_atoms 1 box
set group all diameter \$(1.001*v_u*$3) density 1000
compute z all coordination
compute n all contact/atom
compute mean all reduce ave c_n
print \"is Z \$(c_z) $2\"
print \"is mechanical \$(c_z[2]) $2\"
print \"is most \$(c_z[5]) $2\"
print \"is contacts \$(c_z[6]) \$($2*atoms/2)\"
print \"is each \$(c_mean) $2\""
	done
}
crystal sc 6 1
crystal bcc 8 'sqrt(3)/2'
crystal fcc 12 'sqrt(0.5)'

# A chain of five with a loose end, a grain alone, a wall of the box beside one; a gap closes a contact
agree 'rattlers' 'units si
region box block 0 10 0 10 0 10 units box
create_box 1 box
create_atoms 1 single 0.2 5 5 units box
create_atoms 1 single 1.15 5 5 units box
create_atoms 1 single 2.1 5 5 units box
create_atoms 1 single 1.6 5.8 5 units box
create_atoms 1 single 3.05 5 5 units box
create_atoms 1 single 4.1 5 5 units box
set group all diameter 1
group some id 1:3
group none empty
compute z all coordination
compute g all coordination gap 0.1
compute s some coordination
compute e none coordination
print "is contacts $(c_z[6]) 5"
print "is Z $(c_z) $(10/6)"
print "is none $(c_z[3]) 1"
print "is one $(c_z[4]) 2"
print "is mechanical $(c_z[2]) $((10-2)/3)"
print "is most $(c_z[5]) 3"
print "is gap $(c_g[6]) 6"
print "is gap $(c_g[2]) $((12-2)/4)"
print "is group $(c_s) $(4/3)"
print "is group $(c_s[2]) $((4-2)/1)"
print "is empty $(c_e) 0"
print "is empty $(c_e[2]) 0"'
# A ball in the corner of two planes and a mesh, one on the floor, one on that, one outside the group
box='units si
boundary f f f
region box block 0 4 0 4 0 4 units box
create_box 1 box
create_atoms 1 single 0.499 0.499 0.499 units box
create_atoms 1 single 2 2 0.499 units box
create_atoms 1 single 2 2 1.498 units box
create_atoms 1 single 3.4 3.4 0.499 units box
set group all diameter 1 density 1000
group in id 1:3
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
pair_style gran model hertz
pair_coeff * *
timestep 1e-6
fix move all nve/sphere'
mesh_floor='mesh_primitive floor.stl plate length 3.9 width 3.9 base 2 2 0
fix floor all mesh/surface file floor.stl type 1
fix z all wall/gran model hertz mesh n_meshes 1 meshes floor'
plane_floor='fix z all wall/gran model hertz primitive type 1 zplane 0'
for floor in "$mesh_floor" "$plane_floor"; do
	agree 'walls' "$box
fix x all wall/gran model hertz primitive type 1 xplane 0
fix y all wall/gran model hertz primitive type 1 yplane 0
$floor
compute w in coordination walls yes
compute z in coordination
run 1
print \"is walls \$(c_w[8]) 4\"
print \"is contacts \$(c_w[6]) 1\"
print \"is Z \$(c_w) \$((3+2+1)/3)\"
print \"is one \$(c_w[4]) 1\"
print \"is mechanical \$(c_w[2]) \$(5/2)\"
print \"is without \$(c_z) \$(2/3)\"
print \"is without \$(c_z[8]) 0\""
done
rejects "$box
compute w in coordination walls yes
thermo_style custom step c_w
run 0" 'there is no fix wall/gran'
rejects 'units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
compute z all coordination gap -1' 'gap'
finish
