#!/bin/bash
# Each keyword of dump_modify changes the frames of a dump, or a warning says that it does not: dumps without and with the
# keyword, of one run.
. "$top_srcdir/tests/lib_cases.sh" || exit 99

printf 'solid\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0.1 0.12\nvertex 0.9 0.1 0.12\nvertex 0.1 0.9 0.12\nendloop\nendfacet\nendsolid\n' >wall.stl
scene='atom_style granular
region b block 0 1 0 1 0 1 units box
create_box 2 b
create_atoms 2 single 0.75 0.52 0.5 units box
create_atoms 1 single 0.25 0.51 0.5 units box
create_atoms 1 single 0.44 0.51 0.52 units box
create_atoms 2 single 0.5 0.35 0.3 units box
set group all diameter 0.2 density 1000
velocity all set 0.12345678901 -0.01 0.003
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix wall all mesh/surface file wall.stl type 1
fix near all wall/gran model hertz mesh n_meshes 1 meshes wall
pair_style gran model hertz
pair_coeff * *
fix move all nve/sphere
fix cells all ave/euler nevery 1 cell_size_relative 2 parallel no
compute chain all pair/gran/local pos id force
compute ends all property/local patom1 patom2
region left block 0 0.6 0 1 0 1 units box
timestep 1e-4'
keywords='sort:sort 2|thresh:thresh x > 0.3|region:region left|format:format float %.15g|label:label rows|time:time yes|units:units yes|element:element Aa Aa|scale:scale no|image:image yes|header:header no|binary:binary yes'

# judges STYLE FILE WORDS...: a dump with each keyword; `element` is given to those that need it
judges() {
	local style=$1 file=$2 name words effect warned sort=2
	shift 2
	case $style in
	local/gran/vtk | euler/vtk | mesh/* | image) sort=off ;; # they have no columns
	esac
	sed "s/sort 2/sort $sort/" <<<"${keywords//|/$'\n'}" >list
	{
		echo "$scene"
		echo 'plain:every 1' | cat - list | while IFS=: read -r name words; do
			echo "dump $name all $style 1 $name/$file $*"
			[[ " $* " != *' element '* ]] || echo "dump_modify $name element X Y"
			echo "dump_modify $name $words"
		done
		echo 'run 2'
	} >in.keywords
	rm -rf plain && mkdir plain
	while IFS=: read -r name words; do
		rm -rf "$name" && mkdir "$name"
	done <list
	"$TSIM" -in in.keywords -log none >out 2>&1
	report "dump $style: runs" $? out
	while IFS=: read -r name words; do
		diff -r plain "$name" >difference
		effect=$?
		grep -qE "dump_modify: $name has no effect on (dump $style|comma-separated values)\$" out
		warned=$((1 - $?))
		[ $((effect + warned)) = 1 ]
		report "dump $style: $name: frames differ: $effect, warning: $warned" $? out
	done <list
}
judges atom f.dump
judges custom f.dump id element x
judges custom f.csv id element x
judges xyz f.xyz
judges local f.dump index 'c_chain[1]' 'c_chain[7]'
judges local f.csv index 'c_chain[1]' 'c_chain[7]'
judges custom/vtk 'f*.vtk' id x y z
judges local/vtk 'f*.vtk' 'c_ends[1]' 'c_ends[2]' 'c_chain[10]'
judges local/gran/vtk 'f*.vtk' chain
judges euler/vtk 'f*.vtk' cells
judges mesh/vtk 'f*.vtk' id area
judges mesh/stl 'f*.stl'
judges image 'f*.ppm' element diameter
# ---- commands do not replace files that a dump or fix is writing
open_files='units si
boundary f f f
region b block 0 1 0 1 0 1
create_box 1 b
create_atoms 1 single 0.5 0.5 0.5
pair_style none
timestep 1e-3
fix n all nve
dump a all custom 10 s.dump id x
dump b all custom 10 s.*.dump id x
fix p all print 10 "$(step)" file s.txt screen no
fix t all ave/time 10 1 10 ke file t.txt
run 20'
rejects "$open_files
write_dump all custom ./s.dump id x
run 20" 'to which dump a'
rejects "$open_files
print 'note' file s.txt" 'to which fix p'
rejects "$open_files
write_data t.txt" 'to which fix t'
prints "$open_files
write_dump all custom s.*.dump id x
write_data other.txt
print 'note' append s.txt
undump a
write_dump all custom s.dump id x
print ready" ready
finish
