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
rejects 'units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
compute z all coordination gap -1' 'gap'
finish
