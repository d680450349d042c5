#!/bin/bash
# fix lubrication at walls of height fields and meshes: a flat one is a plane, whatever its columns and triangles; edges, grooves,
# motion of the surface, periodic images, limits of the step, refusals, threads.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh" || exit 99

# scene UNITS LENGTH MASS TIME WALL...: a sphere of radius 0.3 near z = 0, in m, kg, s times the factors; L, M, T are the factors
scene() {
	local units=$1 length=$2 mass=$3 time=$4
	shift 4
	cat <<END
units $units
boundary p p f
newton off
communicate single vel yes
variable L equal $length
variable M equal $mass
variable T equal $time
region box block \$(-0.5*v_L) \$(0.5*v_L) \$(-0.5*v_L) \$(0.5*v_L) -\${L} \$(2*v_L) units box
create_box 1 box
create_atoms 1 single \$(0.013*v_L) \$(-0.017*v_L) \$(0.32*v_L) units box
set type 1 diameter \$(0.6*v_L) density \$(2000*v_M/v_L^3)
pair_style gran model hooke tangential off
fix m1 all property/global youngsModulus peratomtype \$(5e6*v_M/v_L/v_T^2)
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m5 all property/global characteristicVelocity scalar \$(v_L/v_T)
pair_coeff * *
neighbor \$(0.05*v_L) bin
END
	printf '%s\n' "$@"
	cat <<END
timestep \$(1e-4*v_T)
variable tqx atom tqx
variable tqy atom tqy
thermo_modify format float %.16g
END
}
walls='wall/gran model hooke tangential off'
layers='fix layers all lubrication viscosity $(7*v_M/v_L/v_T) inner $(1e-3*v_L) outer $(0.2*v_L) walls w'
plane="fix w all $walls primitive type 1 zplane 0"
field="fix s all surface/voxel constant 0 type 1 cells 20 17
fix w all $walls voxels s"
mesh="fix s all mesh/surface file plate.stl type 1 scale \${L}
fix w all $walls mesh n_meshes 1 meshes s"

# ---- a flat surface: a sphere crosses columns and triangles, on their edges, too, as it does a plane

plate 4 0 >plate.stl
slide='fix move all nve/sphere
velocity all set $(2*v_L/v_T) $(-1.5*v_L/v_T) $(-0.3*v_L/v_T) units box
set group all omegax $(3/v_T) omegay $(-2/v_T)
variable fx equal fx[1]*v_T^2/v_M/v_L
variable fy equal fy[1]*v_T^2/v_M/v_L
variable fz equal fz[1]*v_T^2/v_M/v_L
variable tx equal v_tqx[1]*v_T^2/v_M/v_L^2
variable ty equal v_tqy[1]*v_T^2/v_M/v_L^2
variable sx equal x[1]/v_L
variable sz equal z[1]/v_L
thermo_style custom step v_sx v_sz v_fx v_fy v_fz v_tx v_ty
thermo 7
run 3500'

# slides NAME WALL [UNITS LENGTH MASS TIME]: table NAME of the sphere that slides
slides() {
	local name=$1 wall=$2
	shift 2
	{ scene "${@:-si}" "$wall"; echo "$layers"; echo "$slide"; } >"in.$name"
	"$TSIM" -in "in.$name" -log "log.$name" -screen none >out 2>&1
	report "$name" $? out
	rows "log.$name" >"$name"
}

# near WHAT FILE FILE TOLERANCE: the same numbers, relative to the largest of each column; and some force acts
near() {
	paste "$2" "$3" | awk -v most="$4" '{
		n = NF / 2
		for (k = 1; k <= n; k++) {
			d = $k - $(k + n); d = d < 0 ? -d : d; s = $k < 0 ? -$k : $k
			if (d > off[k]) off[k] = d
			if (s > size[k]) size[k] = s
		}
	}
	END {
		for (k = 1; k <= n; k++) if (off[k] > most * size[k]) { print "column", k, off[k], "of", size[k]; bad = 1 }
		exit bad || NR < 100 || !(size[6] > 0)
	}' >difference
	report "$1" $? difference
}
slides plane "$plane" si 1 1 1
slides field "$field" si 1 1 1
slides mesh "$mesh" si 1 1 1
same 'a field of one height is a plane' plane field
near 'a flat mesh is a plane' plane mesh 1e-11
slides field.micro "$field" micro 1e6 1e15 1e6
near 'a field in micro units' plane field.micro 1e-8
slides mesh.micro "$mesh" micro 1e6 1e15 1e6
near 'a mesh in micro units' plane mesh.micro 1e-8

# ---- edges and grooves: a ridge of height 1 on |x| > 0.45 beside a floor

for ((k = 0; k < 20; k++)); do echo $((k == 0 || k == 19)); done | paste -sd' ' >ridge.txt
solid >ridge.stl <<'END'
-0.45 -0.5 0 0.45 -0.5 0 0.45 0.5 0
-0.45 -0.5 0 0.45 0.5 0 -0.45 0.5 0
0.45 -0.5 0 0.45 0.5 1 0.45 0.5 0
0.45 -0.5 0 0.45 -0.5 1 0.45 0.5 1
0.45 -0.5 1 0.5 -0.5 1 0.5 0.5 1
0.45 -0.5 1 0.5 0.5 1 0.45 0.5 1
END
ridge[0]="fix s all surface/voxel file ridge.txt type 1
fix w all $walls voxels s"
ridge[1]="fix s all mesh/surface file ridge.stl type 1
fix w all $walls mesh n_meshes 1 meshes s"
numbers='fix move all nve/sphere
variable k equal 6*PI*7*0.3^2'
for w in "${ridge[@]}"; do
	agree "in a groove: ${w%%[0-9]*}" "$(scene si 1 1 1 "$w")
$layers
$numbers
set atom 1 x 0.13
velocity all set 0.4 0 0.3 units box
run 0
variable A equal 3.2*PI*7*0.3*ln(0.3/0.02)
print 'is x \$(fx[1]) \$(-v_k/0.02*0.4-v_A*0.4) 1e3'
print 'is z \$(fz[1]) \$(-v_k/0.02*0.3-v_A*0.3) 1e3'
print 'is gap \$(f_layers[1]:%.12g) 0.02'"
	agree "at an edge: ${w%%[0-9]*}" "$(scene si 1 1 1 "$w")
$layers
$numbers
set atom 1 x 0.26 z 1.25
velocity all set 0 0 -0.4 units box
run 0
variable d equal sqrt(0.19^2+0.25^2)
variable A equal 3.2*PI*7*0.3*ln(0.3/(v_d-0.3))
variable n equal (v_k/(v_d-0.3)-v_A)*0.4*0.25/v_d
print 'is x \$(fx[1]) \$(-v_n*0.19/v_d) 1e2'
print 'is z \$(fz[1]) \$(v_n*0.25/v_d+v_A*0.4) 1e2'
print 'is y \$(fy[1]) 0 1e2'"
done

# ---- surfaces that move; all at (0.2, 0.1), 0.02 above the surface

moved="$layers
$numbers
set atom 1 x 0.2 y 0.1
variable A equal 3.2*PI*7*0.3*ln(0.3/0.02)"
agree 'a field that slides' "$(scene si 1 1 1 "$field" | sed '/surface.voxel/s/$/ move linear 0.7 0.2 0/')
$moved
run 0
print 'is x \$(fx[1]:%.12g) \$(v_A*0.7:%.12g)'
print 'is y \$(fy[1]:%.12g) \$(v_A*0.2:%.12g)'"
agree 'a field that swings' "$(scene si 1 1 1 "$field" | sed '/surface.voxel/s/$/ move wiggle 0 0 1e-3 0.04/')
$moved
run 0
print 'is z \$(fz[1]:%.11g) \$(v_k/0.02*1e-3*PI/0.02:%.11g)'"
agree 'a mesh that rotates' "$(scene si 1 1 1 "$mesh")
fix turn all move/mesh mesh s rotate origin 0 0 0 axis 0 0 1 period 2
$layers
set atom 1 x 0.2 y 0.1
run 1
variable A equal 3.2*PI*7*0.3*ln(0.3/0.02)
print 'is x \$(fx[1]:%.10g) \$(-v_A*PI*0.1:%.10g)'
print 'is y \$(fy[1]:%.10g) \$(v_A*PI*0.2:%.10g)'"
agree 'a mesh that comes nearer for many rebuilds' "$(scene si 1 1 1 "$mesh")
fix rise all move/mesh mesh s linear 0 0 2
$layers
displace_atoms all move 0 0 0.5 units box
timestep 1e-3
run 250
print 'is z \$(fz[1]:%.9g) \$(6*PI*7*0.3^2/0.02*2:%.9g)'"

# ---- what else may be asked

for w in "$field" "$mesh"; do
	what=${w%% type*}
	agree "two of them add up: $what" "$(scene si 1 1 1 "$w")
$moved
fix more all lubrication viscosity 2 inner 1e-3 outer 0.3 walls w
velocity all set 0 0 0.4 units box
run 0
print 'is z \$(fz[1]:%.11g) \$(-v_k/7*9/0.02*0.4:%.11g)'"
	agree "defined after a run: $what" "$(scene si 1 1 1 "$w")
run 3
$moved
velocity all set 0 0 0.4 units box
run 0
print 'is z \$(fz[1]:%.11g) \$(-v_k/0.02*0.4:%.11g)'
unfix layers
run 0
print 'is z \$(fz[1]) 0'"
	agree "not in the group of the wall: $what" "$(scene si 1 1 1 "${w/fix w all/group none empty
fix w none}")
$moved
velocity all set 0 0 0.4 units box
run 0
print 'is z \$(fz[1]) 0'"
	agree "an overlap has the inner gap: $what" "$(scene si 1 1 1 "$w")
$layers
$numbers
set atom 1 z 0.2999
run 0
variable before equal fz[1]
variable contact equal \${before}
unfix layers
velocity all set 0 0 0.01 units box
run 0
variable contact equal \$(fz[1])
fix layers all lubrication viscosity 7 inner 1e-3 outer 0.2 walls w
run 0
print 'is z \$(fz[1]) \$(v_contact-v_k/1e-3*0.01) 1e3'"
	rejects "$(scene si 1 1 1 "$w")
$moved
set atom 1 z -0.0
velocity all set 0 0 0.4 units box
run 0" 'centre'
	step="$(scene si 1 1 1 "$w")
fix layers all lubrication viscosity 700 inner 1e-3 outer 0.2 walls w
$numbers
velocity all set 0 0 1e-6 units box"
	prints "$step
timestep \$(0.99*2*mass(all)*0.02/v_k/100)
run 1000
print 'decayed \$(abs(vz[1])<1e-13)'" 'decayed 1'
	rejects "$step
timestep \$(1.01*2*mass(all)*0.02/v_k/100)
run 1" 'of fix lubrication, 2/rate of the present layers, smallest gap 0.02'
done
# ---- a contact that a layer damps: a step h is stable for k h^2/4 + gamma h/2 < m; alone the contact and the
# layer would allow 2 sqrt(m/k) and 2 m/gamma

# both FACTOR STEPS: a sphere pressed onto a field, without other damping, and disturbed
both() {
	scene si 1 1 1 "$field" | sed '/coefficientRestitution/s/0.5/1/'
	cat <<END
fix layers all lubrication viscosity 5 inner 1e-3 outer 0.2 walls w
fix move all nve/sphere
set atom 1 z 0.299
run 0
variable m equal \$(mass(all))
variable k equal \$(fz[1]/1e-3)
variable c equal 6*PI*5*0.3^2/1e-3
variable limit equal (sqrt(0.25*v_c^2+v_k*v_m)-0.5*v_c)*2/v_k
print "limit \$(v_limit:%.3g) alone \$(2*sqrt(v_m/v_k):%.3g) \$(2*v_m/v_c:%.3g)"
fix push all addforce 0 0 \$(-v_k*1e-3)
velocity all set 0 0 1e-6 units box
timestep \$($1*v_limit)
run 1
variable before equal \$(abs(vz[1]))
run $2
print "grown \$(abs(vz[1])>20*v_before) decayed \$(abs(vz[1])<0.05*v_before)"
END
}
prints "$(both 0.99 400)" 'grown 0 decayed 1'
prints "$(both 1.02 60)" 'grown 1 decayed 0' \
	'*of contacts together with fix lubrication, about particle 1'

cuboid 0.4 0.4 0.4 >cuboid.stl
rejects "$(scene si 1 1 1 "fix s all mesh/surface/stress file cuboid.stl type 1 move 0 0 -0.4
fix w all $walls mesh n_meshes 1 meshes s")
fix free all move/mesh/free mesh s mass 1
$layers
run 0" 'surface s of the wall w moves under the forces on it'
rejects "$(scene si 1 1 1 "region r sphere 0 0 0 0.9 units box
fix w all wall/gran/region granular hooke 1e5 0 damping velocity tangential linear_nohistory 0 0 region r")
$layers" 'cylinders and regions is not supported'

# ---- threads: a crowd between a rough field that slides and a mesh that turns

for t in 1 3; do
	mkdir "t$t"
	printf '%s\n' "package omp $t grain 1" "include $top_srcdir/tests/decks/in.lubrication_walls" 'run 400' >"t$t/in"
	(cd "t$t" && "$TSIM" -in in -log log -screen none) >out 2>&1
	report "$t threads" $? out
	rows "t$t/log" >"rows.$t"
done
same 'forces on 3 threads' t1/400.txt t3/400.txt
same 'tables on 3 threads' rows.1 rows.3
finish
