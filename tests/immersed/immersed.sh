#!/bin/bash
# Bodies in a fluid by fix immersed/boundary: drag against exact values and its order, bodies that move against
# bodies at rest, meshes against regions, restart and threads, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh" || exit 99

# near WHAT VALUE REFERENCE TOLERANCE: relative
near() {
	awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN { d = a / b - 1; exit !(d <= t && -d <= t) }'
	report "$1: $2, expected $3" $?
}

# ---- drag of rods in a square array, a fifth of the area: 51.53 mu U (Sangani & Acrivos, Int. J. Multiphase
# Flow 8 (1982) 193), and its order
cat >in.array <<'END2'
units si
dimension 2
boundary p p p
region box block 0 1 0 1 -0.5 0.5 units box
create_box 1 box
variable mu equal 2.385
flow_style projection cells ${N} ${N} 1 viscosity ${mu} density 1 body_force 1 0 0 ${scheme}
region rod cylinder z 0.51 0.493 $(sqrt(0.2/PI)) INF INF units box
fix rod all immersed/boundary region rod
compute flux all flow/flux x 0.5
timestep $(0.1/v_N^2/v_mu)
run $(round(0.4/v_mu/dt))
print "K $(f_rod[1]/v_mu/c_flux[3]) F $(f_rod[1])"
END2
drag() {
	"$TSIM" -in in.array -log none -var N "$1" -var scheme "$2" >out 2>&1
	awk '$1 == "K" { print $2 }' out
}
coarse=$(drag 16 'time euler')
fine=$(drag 32 'time euler')
near 'rods in an array, 8 cells across' "$coarse" 51.53 0.035
near 'rods in an array, 16 cells across' "$fine" 51.53 0.008
near 'all the force on the fluid is on the rods' "$(awk '$1 == "K" { print $4 }' out)" 1 2e-5
awk -v a="$coarse" -v b="$fine" 'BEGIN { exit !(log((a - 51.53) / (b - 51.53)) / log(2) > 1.8) }'
report "order of the drag: $coarse $fine" $?
for time in ab2 rk2 rk3; do
	near "drag with time $time" "$(drag 16 "time $time")" "$coarse" 0.02
done
near 'drag with substeps' "$(drag 16 'substeps 3')" "$coarse" 0.02
near 'drag with viscosity implicit, first order in the step' "$(drag 16 'viscous implicit')" "$coarse" 0.05

# ---- spheres in a simple cubic array, an eighth and a third (0.343) of the volume: 4.292 and 15.4 times Stokes' drag (A. A. Zick
# & G. M. Homsy, J. Fluid Mech. 115 (1982) 13); in the second one two cells are left between them
cat >in.spheres <<'END2'
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
variable D equal (6*v_c/PI)^(1/3)
flow_style projection cells 16 16 16 viscosity 2.385 density 1 body_force 1 0 0
region ball sphere 0.51 0.47 0.53 $(v_D/2) units box
fix ball all immersed/boundary region ball
compute flux all flow/flux x 0.5
timestep $(0.15/16^2/2.385)
run 260
print "K $(f_ball[1]/3/PI/2.385/v_D/c_flux[3])"
END2
"$TSIM" -in in.spheres -log none -var c 0.125 >out 2>&1
near 'spheres in an array, 10 cells across' "$(awk '$1 == "K" { print $2 }' out)" 4.292 0.05
"$TSIM" -in in.spheres -log none -var c 0.343 >out 2>&1
near 'spheres in a dense array, 14 cells across' "$(awk '$1 == "K" { print $2 }' out)" 15.4 0.03

# ---- between a cylinder that turns and one at rest: the torque 4 pi mu omega r^2 R^2/(R^2 - r^2) on both
cat >in.couette <<'END2'
units si
dimension 2
boundary f f p
region box block -1.2 1.2 -1.2 1.2 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 32 32 1 viscosity 1.385 density 1
region inner cylinder z 0.021 0.013 0.45 INF INF units box
region outer cylinder z 0.021 0.013 1 INF INF side out units box
variable omega equal 0.7
fix in all immersed/boundary region inner omega 0 0 v_omega
fix out all immersed/boundary region outer
timestep $(0.2*(2.4/32)^2/1.385)
run 500
print "T $(f_in[6]) $(f_out[6]) $(4*PI*1.385*0.7*0.45^2/(1-0.45^2))"
print "FORCE $(f_in[1]+f_out[1]) $(f_in[2]+f_out[2])"
END2
"$TSIM" -in in.couette -log none >out 2>&1
read -r _ inner outer exact < <(grep '^T ' out)
near 'torque on the cylinder that turns' "$inner" "-$exact" 0.015
near 'what one loses the other gets' "$outer" "${inner#-}" 1e-3

# ---- a body that moves through fluid at rest feels what it feels at rest in fluid that moves
cat >in.moving <<'END2'
units si
dimension 2
boundary p f p
region box block -2 2 -1.5 1.5 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 48 36 1 viscosity 0.05 density 1
flow_boundary ylo slip
flow_boundary yhi slip
variable x equal time*${moves}
variable nil equal 0
region rod cylinder z 0.013 0.0057 0.5 INF INF units box move v_x v_nil v_nil
if "${moves} == 0" then "flow_set velocity -1 0 0"
fix rod all immersed/boundary ${body}
variable fx equal f_rod[1]
variable fy equal f_rod[2]
fix mean all ave/time 1 60 60 v_fx v_fy
timestep 0.02
run 60
print "F $(f_mean[1]) $(f_mean[2])"
END2
for moves in 0 1; do
	"$TSIM" -in in.moving -log none -var moves $moves -var body 'region rod' >out 2>&1
	awk '$1 == "F" { print $2 }' out >force.$moves
done
near 'force on a body that moves' "$(cat force.1)" "$(cat force.0)" 0.02

# ---- one that swings a little feels -rho pi a^2 (Re C du/dt - Im C omega u), C = 1 + 4 K_1(k)/(k K_0(k)),
# k^2 = i omega a^2/nu = 20 i: 1.6354 - 0.7287 i (G. G. Stokes 1851; here in a box of 6 diameters), and no mean force
cat >in.swing <<'END2'
units si
dimension 2
boundary p p p
region box block -3 3 -3 3 -0.5 0.5 units box
create_box 1 box
flow_style projection cells 72 72 1 viscosity $(PI/40) density 1 time rk2
variable x equal 0.02*sin(2*PI*time)
variable nil equal 0
variable v equal 0.04*PI*cos(2*PI*time)
region rod cylinder z 0.013 0.007 0.5 INF INF units box move v_x v_nil v_nil
fix rod all immersed/boundary region rod velocity v_v 0 0
variable unit equal PI*0.25*0.02*(2*PI)^2
variable inertia equal 2*f_rod[1]*sin(2*PI*time)/v_unit
variable drag equal -2*f_rod[1]*cos(2*PI*time)/v_unit
variable fx equal f_rod[1]/v_unit
variable fy equal f_rod[2]/v_unit
timestep 0.0125
run 240
fix mean all ave/time 1 80 80 v_inertia v_drag v_fx v_fy
run 80
print "C $(f_mean[1]) $(f_mean[2]) $(abs(f_mean[3]) < 2e-3 && abs(f_mean[4]) < 2e-3)"
END2
"$TSIM" -in in.swing -log none >out 2>&1
read -r _ inertia drag still < <(grep '^C ' out)
near 'inertia of a body that swings' "$inertia" 1.6354 0.03
near 'drag of a body that swings' "$drag" 0.7287 0.03
[ "$still" = 1 ]
report 'mean force on a body that swings' $? out

# ---- one that is carried along in a uniform flow feels nothing
cat >in.carried <<'END2'
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 12 12 12 viscosity 0.05 density 1.385
flow_set velocity 1 0.5 -0.3
variable x equal time
variable y equal 0.5*time
variable z equal -0.3*time
region ball sphere 0.5 0.52 0.47 0.3 units box move v_x v_y v_z
fix ball all immersed/boundary region ball velocity 1 0.5 -0.3
timestep 0.02
run 40
print "NOTHING $(abs(f_ball[1])+abs(f_ball[2])+abs(f_ball[3])+abs(f_ball[4])+abs(f_ball[5])+abs(f_ball[6]) < 1e-10)"
END2
"$TSIM" -in in.carried -log none >out 2>&1
grep -qx 'NOTHING 1' out
report 'a body that goes with the flow feels nothing' $? out

# ---- a mesh is the block that it is the surface of
cuboid 0.25 0.2 0.15 >block.stl
cat >in.block <<'END2'
units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 12 12 12 viscosity 1 density 1.385 body_force 1 0.2 0
region block block 0.26 0.76 0.3 0.7 0.35 0.65 units box
fix surface all mesh/surface file block.stl type 1 move 0.51 0.5 0.5
fix move all move/mesh mesh surface linear 0.4 0 0
variable x equal 0.4*time
variable nil equal 0
region sliding block 0.26 0.76 0.3 0.7 0.35 0.65 units box move v_x v_nil v_nil
fix body all immersed/boundary ${body} min_cells 3.6
timestep 5e-4
thermo 10
thermo_style custom step f_body[1] f_body[2] f_body[3] f_body[7]
thermo_modify format float %.9g
run 40
END2
for body in 'region sliding velocity 0.4 0 0' 'mesh surface'; do
	"$TSIM" -in in.block -log none -var body "$body" >out 2>&1
	report "$body runs" $? out
	rows out | awk '{ printf "%d %.5f %.5f\n", $1, $2, $3 }' >"rows.${body%% *}"
done
same 'a mesh and a region' rows.region rows.mesh
# normals inwards: the same body; of one triangle only: no body
awk '/vertex/ { v[n++] = $0; next } /endloop/ { print v[0]; print v[2]; print v[1]; n = 0 } { print }' block.stl >inwards.stl
awk '/vertex/ && seen < 3 { v[seen++] = $0; if (seen == 3) { print v[0]; print v[2]; print v[1] } next } { print }' block.stl >mixed.stl
sed 's/block.stl/inwards.stl/' in.block >in.inwards
"$TSIM" -in in.inwards -log none -var body 'mesh surface' >out 2>&1
rows out | awk '{ printf "%d %.5f %.5f\n", $1, $2, $3 }' >rows.inwards
same 'a mesh whose normals point inwards' rows.mesh rows.inwards
sed 's/block.stl/mixed.stl/' in.block >in.mixed
refused 'normals inwards and outwards' 'encloses no volume' -in in.mixed -var body 'mesh surface'
# a second, smaller block beside it, or a hollow in it: with normals to the same side of the body
for where in 'beside 0.4 0.05 yes' 'beside 0.4 -0.05 no' 'hollow 0 -0.05 yes' 'hollow 0 0.05 no'; do
	read -r name shift half runs <<<"$where"
	{ sed '$d' block.stl; cuboid 0.05 0.05 "$half" | awk -v s="$shift" '/vertex/ { $2 += s } { print }' | sed 1d; } >two.stl
	sed 's/block.stl/two.stl/; s/min_cells 3.6/min_cells 0/; s/^run 40/run 1/' in.block >in.two
	if [ $runs = yes ]; then
		"$TSIM" -in in.two -log none -var body 'mesh surface' >out 2>&1
		report "two shells, $name" $? out
	else
		refused "two shells, $name, turned" 'has several closed surfaces' -in in.two -var body 'mesh surface'
	fi
done

# ---- a grain comes to rest on a block that the fluid flows around: seen from outside the region is a wall
cat >in.wall <<'END2'
units si
atom_style granular
newton off
communicate single vel yes
boundary p p f
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
create_atoms 1 single 0.5 0.5 0.53
set group all diameter 0.2 density 1000
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix m5 all property/global characteristicVelocity scalar 2
flow_style projection cells 10 10 10 viscosity 0.1 density 1
flow_boundary zhi wall velocity 0.1 0 0
pair_style gran model hooke tangential history
pair_coeff * *
region block block 0.2 0.8 0.2 0.8 0.05 0.4 units box
region around block 0.2 0.8 0.2 0.8 0.05 0.4 side out units box
fix body all immersed/boundary region block min_cells 3
fix wall all wall/gran/region model hooke tangential history type 1 region around
fix ball all immersed/boundary spheres min_cells 2
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 5e-4
run 600
print "REST $(abs(z[1]-0.5) < 0.002) $(abs(vz[1]) < 0.05) $(f_body[1] > 0)"
END2
"$TSIM" -in in.wall -log none >out 2>&1
grep -qx 'REST 1 1 1' out
report 'a grain on a block' $? out

# ---- restart, and threads: byte for byte
cat >in.free <<'END2'
timestep 1e-3
flow_style projection cells 16 12 12 viscosity 0.01 density 1 time rk2
flow_boundary xlo wall velocity 0 1 0
pair_style gran model hooke tangential history
pair_coeff * *
variable x equal 0.1*sin(5*time)
variable nil equal 0
region wagging block 1.05 1.35 0.3 0.7 0.3 0.7 units box move v_x v_nil v_nil rotate v_x 1.2 0.5 0.5 0 0 1
fix bodies all immersed/boundary spheres relax 0.8 min_cells 3
fix wagging all immersed/boundary region wagging min_cells 3
fix step all nve/sphere
thermo 4
compute forces all reduce sum f_bodies[1] f_bodies[6]
thermo_style custom step flow_ke f_bodies[1] f_bodies[2] f_bodies[6] f_wagging[1] f_wagging[6] ke c_forces[1] c_forces[2]
thermo_modify format float %.17g
END2
cat >in.materials <<'END2'
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix m5 all property/global characteristicVelocity scalar 2
END2
cat >in.head <<'END2'
units si
atom_style granular
newton off
communicate single vel yes
boundary f p p
region box block 0 1.6 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
create_atoms 1 single 0.31 0.45 0.5
create_atoms 1 single 0.7 0.52 0.98
set group all diameter 0.38 density 1.6
velocity all set 0.5 0 0
END2
{ cat in.head in.materials in.free; echo 'run 12'; echo 'write_restart restart'; echo 'run 8'; } >in.whole
{ echo 'newton off'; echo 'communicate single vel yes'; echo 'read_restart restart'; cat in.materials in.free; echo 'run 8'; } >in.again
resumes 'bodies that are free' rows 3
# while the fluid waits: the velocity of a region goes over all steps since the last one of the fluid
sed -i 's/time rk2$/& every 3/' in.free
{ cat in.head in.materials in.free; echo 'run 20'; } >in.through
for cut in 10 11; do
	{ cat in.head in.materials in.free; echo "run $cut"; echo 'write_restart restart'; echo "run $((20 - cut))"; } >in.whole
	{ echo 'newton off'; echo 'communicate single vel yes'; echo 'read_restart restart'; cat in.materials in.free; echo "run $((20 - cut))"; } >in.again
	resumes "the fluid waits at step $cut" rows 3
	"$TSIM" -in in.through -log none >through 2>&1
	rows through | tail -n 3 >rows.through
	same "the fluid waits at step $cut: in one run" rows.whole rows.through
done

# ---- faults
scene='units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 8 8 8 viscosity 1 density 1'
rejects "units si
region box block 0 1 0 1 0 1 units box
create_box 1 box
fix b all immersed/boundary region box" 'fluid'
rejects "$scene
region e ellipsoid 0.5 0.5 0.5 0.2 0.2 0.2 units box
fix b all immersed/boundary region e" 'the distance from the surface is not available'
plate 2 0.5 >plate.stl # of side 1 about the z axis
rejects "$scene
fix m all mesh/surface file plate.stl type 1 move 0.5 0.5 0
fix b all immersed/boundary mesh m" 'is not closed'
# ---- bodies of few cells: refused, unless min_cells says otherwise; by -check too, in any unit
# few UNIT: a scene with cells of UNIT/8
few() {
	echo "units si
boundary f p f
newton off
communicate single vel yes
region box block 0 $1 0 $1 0 $1 units box
create_box 1 box
flow_style projection cells 8 8 8 viscosity 1 density 1
flow_boundary all slip
timestep \$(1e-4*$1^2)"
}
for unit in 1 1e-6 1e3; do
	rejects "$(few $unit)
region b block \$(0.2*$unit) \$(0.8*$unit) INF INF \$(0.25*$unit) \$(0.74*$unit) units box
fix b all immersed/boundary region b
run 1" '3.92 cells across along z, fewer than 4'
	"$TSIM" -check -in in.script >out 2>&1
	[ $? = 1 ] && shows 'say `min_cells 3.9`' out
	report "-check refuses a body of few cells, lengths of $unit" $? out
	prints "$(few $unit)
region b block \$(0.2*$unit) \$(0.8*$unit) INF INF \$(0.25*$unit) \$(0.74*$unit) units box
fix b all immersed/boundary region b min_cells 3.9
run 1
print went" went
	prints "$(few $unit)
region b block \$(0.2*$unit) \$(0.8*$unit) INF INF \$(0.25*$unit) \$(0.75*$unit) units box
fix b all immersed/boundary region b
run 1
print went" went
	rejects "$(few $unit)
create_atoms 1 single \$(0.4*$unit) \$(0.5*$unit) \$(0.99*$unit) units box
create_atoms 1 single \$(0.6*$unit) \$(0.5*$unit) \$(0.01*$unit) units box
set group all diameter \$(0.6*$unit) density 1
set atom 2 diameter \$(0.4*$unit)
fix b all immersed/boundary spheres
run 1" 'particle 2 of diameter'
done
rejects "$(few 1)
flow_grid x tanh 1
region c cylinder y 0.5 0.5 0.25 INF INF units box
fix c all immersed/boundary region c
run 1" 'cells across along x'
cuboid 0.3 0.3 0.2 >small.stl
rejects "$(few 1)
fix m all mesh/surface file small.stl type 1 move 0.5 0.5 0.5
fix b all immersed/boundary mesh m
run 1" '3.2 cells across along z'
# a clump is as thick as its largest sphere
clump="$(few 1)
create_atoms 1 single 0.4 0.5 0.5 units box
create_atoms 1 single 0.6 0.5 0.5 units box
set group all diameter 0.3 density 2
fix clump all rigid single
fix b all immersed/boundary spheres"
rejects "$clump
run 1" 'particle 1 of diameter 0.3 is 2.4 cells'
prints "$clump
set atom 2 diameter 0.6
run 1
print went" went

# Rounding of the coordinates does not choose the side of points on the surface: the flow about a block whose faces are faces of
# cells is symmetric. Without an end the block ends with the box: its torque refers to the centre there.
agree 'a block on faces of cells' 'units si
boundary f f p
region box block 0 3 0 1.4 0.3 0.5 units box
create_box 1 box
flow_style projection cells 30 14 2 viscosity 0.01 density 1
flow_boundary xlo inlet velocity 1 0 0
flow_boundary xhi outlet
flow_boundary ylo slip
flow_boundary yhi slip
region endless block 1 1.6 0.4 1 INF INF units box
compute p all flow/probe 2 0.45 0.4 2 0.95 0.4 values vx vy
timestep 0.02
fix b all immersed/boundary region endless
run 20
print "is cross $(f_b[2]) 0 $(f_b[1])"
print "is vx $(c_p[1][1]) $(c_p[2][1])"
print "is vy $(c_p[1][2]) $(-c_p[2][2]) 1"
print "is torque_y $(f_b[5]) 0 $(f_b[1])"'

# ---- a body that nearly fills a period: one in a cube, eight in the doubled cube, spheres and a region
cat >in.period <<'END'
units si
atom_style sphere
boundary p p p
region box block 0 ${m} 0 ${m} 0 ${m} units box
create_box 1 box
flow_style projection cells $(8*v_m) $(8*v_m) $(8*v_m) viscosity 1.3 density 100 body_force 0.3 0.1 0.2
pressure_style direct
lattice sc 1 origin 0.45 0.47 0.51
create_atoms 1 box
set group all diameter 0.8 density 2385
region one sphere 0.45 0.47 0.51 0.4 units box
fix b all immersed/boundary ${body}
timestep 1e-3
run 20
print "of one $(f_b[1]/atoms:%.10g) $(f_b[2]/atoms:%.10g) $(f_b[3]/atoms:%.10g) $(flow_ke/atoms:%.10g)"
END
period() { # M BODY
	"$TSIM" -in in.period -log none -var m "$1" -var body "$2" 2>&1 </dev/null | grep '^of one'
}
period 1 spheres >one
for run in '2 spheres' '1 region one'; do
	period "${run%% *}" "${run#* }" >other
	[ -s one ] && cmp one other
	report "a sphere in a period of 8 cells: $run" $? one
done

# ---- buoyancy by body_force in a closed box: the fluid stays at rest, the body gets the weight of the fluid in its place, and
# what is left of it rests on the walls; along a periodic axis the body force drives the flow
cat >in.weight <<'END'
units si
boundary p f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 16 16 16 viscosity 0.05 density 2.385 body_force 0 0.5 -9.81 ${scheme}
region ball sphere 0.5 0.5 0.5 0.25 units box
fix ball all immersed/boundary region ball centre 0.5 0.1 0.3
compute zlo all flow/force zlo
compute zhi all flow/force zhi
timestep 5e-3
run 100
variable w equal 2.385*4/3*PI*0.25^3
print "F $(f_ball[3]) $(f_ball[2]) $(9.81*v_w) $(-0.5*v_w)"
print "T $(f_ball[4]) $(0.4*f_ball[3]-0.2*f_ball[2])"
print "WALLS $(c_zlo[3]+c_zhi[3]) $(-9.81*2.385)"
print "REST $(flow_ke/2.385<1e-9)"
END
for scheme in 'time rk3' 'viscous implicit'; do
	"$TSIM" -in in.weight -log none -var scheme "$scheme" >out 2>&1
	read -r _ z y exact_z exact_y < <(grep '^F ' out)
	near "buoyancy, $scheme" "$z" "$exact_z" 0.035
	near "buoyancy aslant, $scheme" "$y" "$exact_y" 0.035
	read -r _ torque exact < <(grep '^T ' out)
	near "its torque about a point beside the centre, $scheme" "$torque" "$exact" 1e-5
	read -r _ walls exact < <(grep '^WALLS ' out)
	near "the weight on the walls, $scheme" "$walls" "$exact" 1e-5
	grep -q '^REST 1$' out
	report "the fluid stays at rest, $scheme" $? out
done

# ---- the torque on a body that is accelerated is that of its force: (c - x) x F about a point x beside the centre c
agree 'torque about a point beside the centre' 'units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
flow_style projection cells 10 10 10 viscosity 0.02 density 1
variable v equal 10*time
region ball sphere 0.5 0.5 0.5 0.3 units box
fix ball all immersed/boundary region ball velocity v_v 0 0 centre 0.5 0.2 0.6
timestep 1e-3
run 5
print "is about_y $(f_ball[5]) $(-0.1*f_ball[1])"
print "is about_z $(f_ball[6]) $(-0.3*f_ball[1])"'

# ---- implicit viscosity: the pressure in bodies does not grow from step to step
cat >in.kept <<'END'
include in.couette
timestep $(dt/2)
run 1500
print "T $(f_in[6]) $(f_out[6]) $(4*PI*1.385*0.7*0.45^2/(1-0.45^2))"
END
sed -i 's/density 1$/density 1 viscous implicit time ab2/; s/^run 500/run 1/; /^print/d' in.couette
"$TSIM" -in in.kept -log none >out 2>&1
read -r _ inner outer exact < <(grep '^T ' out)
near 'torque on the cylinder that turns, viscous implicit' "$inner" "-$exact" 0.03
near 'what one loses the other gets, viscous implicit' "$outer" "${inner#-}" 2e-3

rejects 'units si
atom_style sphere
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.4 density 2
flow_style projection cells 16 16 1 viscosity 0.1 density 1
fix b all immersed/boundary spheres
timestep 1e-3
run 1' 'in a grid of one cell along z would be cylinders'

# warns WHAT REGION TEXT
warns() {
	printf '%s\nregion b %s units box\nfix b all immersed/boundary region b min_cells 0\ntimestep 1e-4\nrun 1\n' "$scene" "$2" >in.script
	"$TSIM" -in in.script -log none >out 2>&1 && shows "$3" out
	report "$1" $? out
}
warns 'outside' 'sphere 3 3 3 0.5' 'outside the grid'
warns 'thin' 'block 0.2 0.8 0.2 0.8 0.45 0.57' 'cells; the fluid leaks'
finish
