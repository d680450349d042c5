#!/bin/bash
# Height fields as bodies in a fluid: a flat one against a plane bit for bit, ribs and a block against regions, a pad
# that slides against a lid that slides the other way, restart and threads, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# near WHAT VALUE REFERENCE TOLERANCE: relative
near() {
	awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { d = a / b - 1; exit !(d <= t && -d <= t) }'
	report "$1: $2, expected $3" $?
}

# numbers FILE: the lines of the table
numbers() {
	awk '$1 == "Step" { on = 1; next } $1 == "Loop" { on = 0 } on && NF > 5' "$1"
}

# ---- one height: a plane, also where it slides
cat >in.flat <<'END2'
units si
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 6 12 viscosity 1 density 1.385 body_force 1 0.3 0
flow_boundary zlo slip
flow_boundary zhi wall velocity 0.2 0 0
fix top all surface/voxel constant 0.3127 type 1 cells 7 5 move linear ${slides}
fix still all surface/voxel constant 0.3127 type 1 cells 1 1
region top plane 0 0 0.3127 0 0 -1 units box
fix body all immersed/boundary ${body}
timestep 2e-3
thermo 5
thermo_style custom step f_body[1] f_body[2] f_body[3] f_body[4] f_body[5] f_body[6] f_body[7]
thermo_modify format float %.17g
run 20
END2
flat() {
	"$TSIM" -in in.flat -log none -var slides '0.4 0.1 0' -var body "$1" >out 2>&1 && ! grep -q warning out
	report "flat: $1" $? out
	numbers out
}
flat 'region top velocity 0.4 0.1 0' >rows.region
flat 'surface top' >rows.surface
flat 'surface still velocity 0.4 0.1 0' >rows.still
same 'a field of one height is a plane' rows.region rows.surface
same 'one that slides in itself' rows.region rows.still

# ---- in a box that is not periodic it ends at the faces of the grid, which is no surface: a piston
cat >in.piston <<'END2'
units si
boundary f p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 10 6 10 viscosity 1 density 1
timestep 1e-3
flow_boundary all slip
flow_boundary zhi outlet
variable z equal time
variable nil equal 0
region plane plane 0 0 0.4 0 0 -1 units box move v_nil v_nil v_z
fix field all surface/voxel constant 0.4 type 1 cells 5 5 move linear 0 0 1
fix based all surface/voxel constant 0.4 type 1 cells 1 1 base -0.4 move linear 0 0 1
fix body all immersed/boundary ${body}
thermo 50
thermo_style custom step f_body[1] f_body[2] f_body[3] f_body[4] f_body[7] flow_ke
thermo_modify format float %.7f
run 400
END2
for body in 'region plane' 'surface field' 'surface based'; do
	"$TSIM" -in in.piston -log none -var body "$body" >out 2>&1 && ! grep -q warning out
	report "piston: $body" $? out
	numbers out | sed '1,2d; s,-0\.0000000 ,0.0000000 ,g' >"piston.${body##* }"
done
same 'a piston' piston.plane piston.field
same 'a piston whose base comes to the bottom of the grid' piston.plane piston.based

# ---- ribs in a channel: the union of a floor and blocks; what flows in flows out
cat >in.ribs <<'END2'
units si
dimension 2
boundary p f p
region box block 0 $(2*v_unit) 0 ${unit} $(-0.5*v_unit) $(0.5*v_unit) units box
create_box 1 box
flow_style projection cells 40 20 1 viscosity 1 density $(1.385/v_unit) body_force $(1/v_unit) 0 0
flow_boundary yhi wall velocity 0.3 0 0
variable xx internal 0
variable h equal (0.2+0.25*((v_xx/v_unit%1)<0.5))*v_unit
fix ribs all surface/voxel formula v_h x xx type 1 cells 1 4 normal y
region floor plane 0 $(0.2*v_unit) 0 0 -1 0 units box
region rib1 block 0 $(0.5*v_unit) -1 $(0.45*v_unit) INF INF units box
region rib2 block ${unit} $(1.5*v_unit) -1 $(0.45*v_unit) INF INF units box
region ribs union 3 floor rib1 rib2
fix body all immersed/boundary ${body}
compute in all flow/flux x $(0.25*v_unit)
compute mid all flow/flux x $(0.77*v_unit)
timestep $(2.5e-4*v_unit)
run 1000
print "F $(f_body[1]/v_unit:%.12g) $(c_in[1]/v_unit^2:%.12g) $(abs(c_in[1]/c_mid[1]-1) < 1e-12)"
END2
ribs() {
	"$TSIM" -in in.ribs -log none -var unit "$1" -var body "$2" >out 2>&1
	report "ribs: $2, $1" $? out
	grep '^F ' out
}
read -r _ force flux same < <(ribs 1 'surface ribs')
read -r _ union union_flux _ < <(ribs 1 'region ribs')
near 'drag of ribs' "$force" "$union" 3e-4
near 'flow over ribs' "$flux" "$union_flux" 1e-3
[ "$same" = 1 ]
report 'the same flow above and between ribs' $?
read -r _ force_um flux_um _ < <(ribs 1e-6 'surface ribs')
near 'drag in micrometres' "$force_um" "$force" 1e-9
near 'flow in micrometres' "$flux_um" "$flux" 1e-9

# ---- a pad of ribs that slides to the right below a lid at rest, and at rest below a lid that slides to the left
cat >in.slide <<'END2'
units si
dimension 2
boundary p f p
region box block 0 2 0 1 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 40 20 1 viscosity 1 density 1.385
flow_boundary ylo slip
flow_boundary yhi wall velocity $(v_slides-1) 0 0
flow_set velocity ${slides} 0 0
variable xx internal 0
variable h equal 0.2+0.25*((v_xx%1)<0.5)
fix ribs all surface/voxel formula v_h x xx type 1 cells 1 4 normal y move linear ${slides} 0 0
fix body all immersed/boundary surface ribs
compute in all flow/flux x 0.25
compute top all flow/force yhi
variable force equal f_body[1]
variable lid equal c_top[1]
timestep 2.5e-4
fix mean all ave/time 1 2000 2000 v_force v_lid c_in[1]
run 4000
print "F $(f_mean[1]) $(f_mean[2]) $(f_mean[3])"
END2
for slides in 0 1; do
	"$TSIM" -in in.slide -log none -var slides $slides >out 2>&1 && ! grep -q warning out
	report "pad sliding at $slides" $? out
	grep '^F ' out >slide.$slides
done
read -r _ force0 lid0 flux0 <slide.0
read -r _ force1 lid1 flux1 <slide.1
near 'force on the lid' "$lid1" "$lid0" 1e-3
near 'force on a pad that slides' "$force1" "$force0" 5e-3
# the pad carries along what is between the ribs and in the part of the grid inside it: the whole height of 1
near 'flow over a pad that slides' "$(awk -v q="$flux1" 'BEGIN { print q - 1 }')" "$flux0" 1e-3

# ---- one column with ends and a base is a block
cat >in.block <<'END2'
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 12 12 12 viscosity 1 density 1.385 body_force 1 0.2 0
fix column all surface/voxel constant 0.66 base 0.35 type 1 cells ${cells} origin 0.26 0.3 size 0.5 0.4 move linear ${slides} 0 0
variable x equal ${slides}*time
variable nil equal 0
region sliding block 0.26 0.76 0.3 0.7 0.35 0.66 units box move v_x v_nil v_nil
fix body all immersed/boundary ${body} min_cells 3.6
timestep 5e-4
run 40
print "F $(f_body[1]:%.12g) $(f_body[2]:%.12g)"
END2
block() {
	"$TSIM" -in in.block -log none -var slides "$1" -var cells "$2" -var body "$3" >out 2>&1
	report "block: $3, sliding at $1" $? out
	grep '^F ' out
}
for slides in 0 0.4 -7; do
	read -r _ fx fy < <(block $slides '1 1' 'surface column')
	read -r _ gx gy < <(block $slides '1 1' "region sliding velocity $slides 0 0")
	near "a column is a block, sliding at $slides" "$fx" "$gx" 1e-3
	near "across, sliding at $slides" "$fy" "$gy" 1e-3
	block $slides '1 1' 'surface column' >one
	block $slides '7 5' 'surface column' >many
	same "35 columns of one height are one, sliding at $slides" one many
done

# ---- a body that stops stops the fluid inside
cat >in.stop <<'END2'
units si
dimension 2
boundary p p p
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 16 16 1 viscosity 0.05 density 1
variable x equal 0.2*((time<0.05)*time+(time>=0.05)*0.05)
variable nil equal 0
region rod cylinder z 0.5 0.5 0.2 INF INF units box move v_x v_nil v_nil
fix rod all immersed/boundary region rod
compute inside all flow/probe 0.51 0.5 0
timestep 0.01
run 40
print "STOPS $(abs(c_inside[1]) < 1e-3)"
END2
"$TSIM" -in in.stop -log none >out 2>&1
grep -qx 'STOPS 1' out
report 'a body that stops' $? out

# ---- restart in between, and threads: bit for bit
cat >in.part <<'END2'
flow_style projection cells 12 10 12 viscosity 1 density 1.385 time rk2
flow_boundary zlo slip
flow_boundary zhi wall velocity 1 0 0
fix rough all surface/voxel gaussian mean 0.3 deviation 0.1 correlation 0.3 seed 3 type 1 cells 6 5 move wiggle 0.1 0.03 0 0.02
fix body all immersed/boundary surface rough
timestep 5e-4
thermo 4
thermo_style custom step flow_ke f_body[1] f_body[2] f_body[3] f_body[4] f_body[7]
thermo_modify format float %.17g
END2
cat >in.head <<'END2'
units si
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
END2
{ cat in.head in.part; echo 'run 12'; echo 'write_restart restart'; echo 'run 8'; } >in.whole
{ echo 'read_restart restart'; cat in.part; echo 'run 8'; } >in.again
resumes 'a rough pad that swings' numbers 2

# ---- faults
scene='units si
boundary f p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 10 10 10 viscosity 1 density 1
timestep 1e-4'
rejects "$scene
fix rough all surface/voxel constant 0.4 type 1 cells 5 5
fix b all immersed/boundary surface rouhg" "did you mean 'rough'"
rejects "$scene
fix b all immersed/boundary surface all" "no height field 'all'"
rejects "$scene
region r block 0 1 0 1 0 0.3 units box
fix r all immersed/boundary region r
fix b all immersed/boundary surface r" 'is no height field, but of style immersed/boundary'
rejects "$scene
fix rough all surface/voxel constant 1.2 type 1 cells 5 5
fix b all immersed/boundary surface rough
run 1" 'the body fills the whole grid: no fluid is left'
rejects "$scene
fix rough all surface/voxel constant 0.4 type 1 cells 5 5 move linear 1 0 0
fix b all immersed/boundary surface rough
run 3" 'has moved away from an end of the grid: it reaches from 0.0001 to 1.0001 along x'
prints "$scene
fix rough all surface/voxel constant 0.4 type 1 cells 5 5 origin -0.1 0 size 1.2 1 move linear 1 0 0
fix b all immersed/boundary surface rough
run 3
print went" went
plane='units si
dimension 2
boundary p f p
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 10 10 1 viscosity 1 density 1
timestep 1e-4'
rejects "$plane
fix rough all surface/voxel constant 0.4 base -0.4 type 1 cells 5 5
fix b all immersed/boundary surface rough
run 1" 'the heights of rough cannot be along z; use `normal y`'
rejects "$plane
fix rough all surface/voxel constant 0.4 type 1 cells 2 5 normal y
fix b all immersed/boundary surface rough
run 1" 'must have one column along z, as long as the box; use `cells 1 N`'
rejects "$plane
fix rough all surface/voxel constant 0.4 type 1 cells 5 2 normal x base 0.1
fix b all immersed/boundary surface rough
run 1" 'use `cells N 1`'

# warns WHAT SCRIPT TEXT: a warning, or none where TEXT is empty
warns() {
	printf '%s\nrun 1\n' "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && if [ "$3" ]; then shows "$3" out; else ! grep -q warning out; fi
	report "$1" $? out
	"$TSIM" -check -in in.script >out 2>&1
	report "-check: $1" $? out
}
steps='variable xx internal 0
variable h equal 0.3+0.3*(v_xx%0.1<0.05)'
warns 'columns thinner than cells' "$scene
$steps
fix rough all surface/voxel formula v_h x xx type 1 cells 20 1
fix b all immersed/boundary surface rough" 'columns of rough are 0.5 cells wide along x'
warns 'columns as wide as cells' "$scene
$steps
fix rough all surface/voxel formula v_h x xx type 1 cells 10 1
fix b all immersed/boundary surface rough" ''
warns 'thin columns of a smooth surface' "$scene
variable xx internal 0
variable h equal 0.3+0.3*v_xx
fix rough all surface/voxel formula v_h x xx type 1 cells 40 1
fix b all immersed/boundary surface rough" ''
# Gaps of cells 0.1 wide
gap() { # WHAT WIDTH WORDS: a block and a plate above it
	warns "$1" "$scene
region low block INF INF INF INF INF 0.31 units box
region high block INF INF INF INF $(awk "BEGIN { print 0.31 + $2 }") INF units box
$3" "$4"
}
two='fix b all immersed/boundary region low
fix c all immersed/boundary region high'
narrow='opposite each other with fewer than three cells'
gap 'a gap of 2.8 cells' 0.28 "$two" "the body and that of fix b are $narrow"
gap 'a gap of one cell' 0.1 "$two" "the body and that of fix b are $narrow"
gap 'a gap of 3.2 cells' 0.32 "$two" ''
gap 'a gap in a body' 0.28 'region both union 2 low high
fix b all immersed/boundary region both' "surfaces of the body are $narrow"
wafer='region wafer plane 0 0 0.7 0 0 1 units box'
warns 'bodies that overlap' "$scene
$wafer
flow_boundary zhi slip
fix rough all surface/voxel constant 0.8 type 1 cells 2 1 origin 0 0 size 0.45 1
fix pad all immersed/boundary surface rough
fix wafer all immersed/boundary region wafer velocity 1 0 0" 'overlap with different velocities'
warns 'bodies that touch' "$scene
$wafer
flow_boundary zhi slip
fix rough all surface/voxel constant 0.7 type 1 cells 2 1 origin 0 0 size 0.45 1
fix pad all immersed/boundary surface rough
fix wafer all immersed/boundary region wafer velocity 1 0 0" ''
warns 'bodies that overlap at rest' "$scene
$wafer
fix rough all surface/voxel constant 0.8 type 1 cells 2 1 origin 0 0 size 0.45 1
fix pad all immersed/boundary surface rough
fix wafer all immersed/boundary region wafer" ''
warns 'a wall inside' "$scene
$wafer
fix wafer all immersed/boundary region wafer velocity 1 0 0" 'covers a part of the wall zhi'
finish
