#!/bin/bash
# Meshes that move as free bodies: their mass and moments, a free top and its order, fall, momentum in a collision,
# rest, the fluid's force against that on a sphere, restart.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh" || exit 99

# ball N R: a sphere of N slices and N/2 layers about the origin
ball() {
	awk -v n="$1" -v r="$2" 'function p(i, j, t, f) {
		t = 3.14159265358979324 * i / m; f = 2 * 3.14159265358979324 * (j % n) / n
		if (i == 0 || i == m) return sprintf("0 0 %.17g", i ? -r : r)
		return sprintf("%.17g %.17g %.17g", r * sin(t) * cos(f), r * sin(t) * sin(f), r * cos(t))
	}
	BEGIN {
		m = n / 2
		for (i = 0; i < m; i++) for (j = 0; j < n; j++) {
			if (i < m - 1) print p(i, j), p(i + 1, j), p(i + 1, j + 1)
			if (i > 0) print p(i, j), p(i + 1, j + 1), p(i, j + 1)
		}
	}' | solid
}
cuboid 0.3 0.2 0.1 >block.stl
ball 24 0.2 >ball.stl

# ---- mass and moments of a tetrahedron with edges a, b, c along the axes: I_xx = 3 m (b^2 + c^2)/80, I_xy = m a b/80
awk 'BEGIN {
	o = "0 0 0"; a = "0.3 0 0"; b = "0 0.4 0"; c = "0 0 0.5"
	print o, b, a; print o, a, c; print o, c, b; print a, b, c
}' | solid >corner.stl
{
	two_materials
	cat <<'END'
fix block all mesh/surface/stress file corner.stl type 2 move 0.1 -0.2 0.3
fix free all move/mesh/free mesh block density 2385 velocity 0.1 0.2 0.3 omega 2 3 5
pair_style gran model hooke
pair_coeff * *
timestep 1e-4
run 0
variable m equal 2385*0.3*0.4*0.5/6
print "is mass $(f_free[19]:%.17g) $(v_m:%.17g)"
print "is x $(f_free[1]:%.17g) 0.175"
print "is y $(f_free[2]:%.17g) -0.1"
print "is z $(f_free[3]:%.17g) 0.425"
print "is lx $(f_free[10]:%.17g) $(v_m/80*(2*3*0.41+3*0.12+5*0.15):%.17g)"
print "is ly $(f_free[11]:%.17g) $(v_m/80*(2*0.12+3*3*0.34+5*0.2):%.17g)"
print "is lz $(f_free[12]:%.17g) $(v_m/80*(2*0.15+3*0.2+5*3*0.25):%.17g)"
END
} >deck
agree 'mass, centre and moments of a tetrahedron' "$(cat deck)"

# ---- a free top, nearly about the middle axis: L and the path of the centre to round-off (of 40000 steps at most, in a
# box that reaches to 1), energy and orientation to second order; what is fixed to the mesh goes along
top() {
	{
		two_materials
		cat <<END
fix block all mesh/surface/stress file block.stl type 2 reference_point 0.3 0.2 0.1
fix free all move/mesh/free mesh block density 2.385 velocity 0.1 0.02 -0.03 omega 0.3 6 0.1
pair_style gran model hooke
pair_coeff * *
timestep $1
run 0
variable e0 equal \$(f_free[20]:%.17g)
variable l1 equal \$(f_free[10]:%.17g)
variable l2 equal \$(f_free[11]:%.17g)
variable l3 equal \$(f_free[12]:%.17g)
run \$(round(1/dt))
print "is lx \$(f_free[10]/v_l2:%.17g) \$(v_l1/v_l2:%.17g)"
print "is ly \$(f_free[11]/v_l2:%.17g) 1"
print "is lz \$(f_free[12]/v_l2:%.17g) \$(v_l3/v_l2:%.17g)"
print "is x \$(f_free[1]:%.17g) 0.1 1"
print "is z \$(f_free[3]:%.17g) -0.03 1"
variable d equal sqrt((f_block[7]-f_free[1])^2+(f_block[8]-f_free[2])^2+(f_block[9]-f_free[3])^2)
print "is corner \$(v_d:%.17g) \$(sqrt(0.14):%.17g)"
print "TOP \$((f_free[20]-v_e0)/v_e0:%.17g) \$(f_block[7]:%.17g) \$(f_block[8]:%.17g) \$(f_block[9]:%.17g)"
END
	} >deck
	agree "a free top, step $1" "$(cat deck)"
	grep '^TOP' out >"top.$1"
}
for dt in 2e-3 1e-3 5e-4 2.5e-5; do top $dt; done
order() {
	paste -d ' ' top.2e-3 top.1e-3 top.5e-4 top.2.5e-5 | awk '
		function far(k) { return sqrt(($(k + 3) - $18)^2 + ($(k + 4) - $19)^2 + ($(k + 5) - $20)^2) }
		function size(x) { return x < 0 ? -x : x }
		{
			print "corner off by", far(0), far(5), far(10), "energy", $2, $7, $12
			ok = (far(5) < 1e-3 && log(far(0) / far(5)) / log(2) > 1.8 &&
				log(far(5) / far(10)) / log(2) > 1.8 && size($7) < 1e-4 && size($2) > 3 * size($7)); exit
		} END { exit !ok }'
}
order >order
report 'order of the orientation and the energy of a top' $? order

# ---- it falls as everything does
{
	two_materials
	cat <<'END'
fix block all mesh/surface/stress file block.stl type 2 move 0 0 0.5
fix free all move/mesh/free mesh block mass 3 velocity 0.2 0 0
fix g all gravity 9.81 vector 0 0 -1
pair_style gran model hooke
pair_coeff * *
timestep 1e-3
run 300
print "is z $(f_free[3]:%.17g) $(0.5-9.81*0.3^2/2:%.17g)"
print "is x $(f_free[1]:%.17g) 0.06"
print "is vz $(f_free[6]:%.17g) $(-9.81*0.3:%.17g)"
print "is fz $(f_free[15]:%.17g) $(-3*9.81:%.17g)"
END
} >deck
agree 'fall' "$(cat deck)"
sed 's/velocity 0.2 0 0/velocity 0.2 0 0 gravity no/; s/^print.*//' deck >still
echo 'print "is z $(f_free[3]) 0.5"' >>still
agree 'without weight' "$(cat still)"

# ---- a grain without friction hits it off its centre: momentum and angular momentum stay, to round-off
{
	two_materials
	cat <<'END'
create_atoms 1 single 0.17 0.09 0.25 units box
set group all diameter 0.2 density 2385
velocity all set 0.3 0.5 -2.385
fix block all mesh/surface/stress file block.stl type 2 reference_point 0.4 0.3 0.2
fix free all move/mesh/free mesh block density 1000 omega 0.3 -0.4 0.5
pair_style gran model hertz
pair_coeff * *
fix wall all wall/gran model hertz mesh n_meshes 1 meshes block
fix step all nve/sphere
timestep 1e-5
variable m equal mass[1]
variable I equal 0.4*v_m*0.01
variable px equal v_m*vx[1]+f_free[19]*f_free[4]
variable py equal v_m*vy[1]+f_free[19]*f_free[5]
variable pz equal v_m*vz[1]+f_free[19]*f_free[6]
variable ax equal v_m*(y[1]*vz[1]-z[1]*vy[1])+f_free[19]*(f_free[2]*f_free[6]-f_free[3]*f_free[5])
variable ay equal v_m*(z[1]*vx[1]-x[1]*vz[1])+f_free[19]*(f_free[3]*f_free[4]-f_free[1]*f_free[6])
variable az equal v_m*(x[1]*vy[1]-y[1]*vx[1])+f_free[19]*(f_free[1]*f_free[5]-f_free[2]*f_free[4])
compute w all property/atom omegax omegay omegaz
variable lx equal v_ax+v_I*c_w[1][1]+f_free[10]
variable ly equal v_ay+v_I*c_w[1][2]+f_free[11]
variable lz equal v_az+v_I*c_w[1][3]+f_free[12]
run 0
END
	for v in px py pz lx ly lz; do echo "variable ${v}0 equal \$(v_$v:%.17g)"; done
	echo 'run 5000'
	# to round-off of the grain's momentum, and of that by its arm
	for v in px py pz; do echo "print \"is $v \$(v_$v:%.17g) \${${v}0} \$(v_m*2.385)\""; done
	for v in lx ly lz; do echo "print \"is $v \$(v_$v:%.17g) \${${v}0} \$(v_m*2.385*0.25)\""; done
	echo 'print "HIT $(f_free[6] < -0.1 && vz[1] > -1)"'
} >deck
agree 'momentum and angular momentum in a collision' "$(cat deck)"
grep -qx 'HIT 1' out
report 'a grain moves it' $? out

# ---- a block on four grains that are held comes to rest; they bear it
{
	two_materials
	for at in '-0.2 -0.1' '0.2 -0.1' '-0.2 0.1' '0.2 0.1'; do echo "create_atoms 1 single $at -0.25 units box"; done
	cat <<'END'
set group all diameter 0.1 density 2385
fix block all mesh/surface/stress file block.stl type 2 move 0 0 -0.0985
fix free all move/mesh/free mesh block density 1000
fix g all gravity 9.81 vector 0 0 -1
pair_style gran model hertz tangential history
pair_coeff * *
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes block
timestep 1e-4
run 40000
print "REST $(f_free[20]) $(f_block[3]/f_free[19]/9.81) $(f_free[3])"
print "REST $(f_free[20] < 1e-8) $(abs(f_block[3]/f_free[19]/9.81-1) < 1e-3) $(abs(f_free[3]+0.1023) < 3e-4) $(abs(f_free[7])+abs(f_free[8]) < 1e-4)"
END
} >in.rest
"$TSIM" -in in.rest -log none >out 2>&1
grep -qx 'REST 1 1 1 1' out
report 'a block at rest on grains' $? out

# ---- in a fluid a mesh of 288 corners sinks as the sphere in it, of the same mass
cat >in.sink <<'END'
units si
atom_style granular
newton off
communicate single vel yes
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
flow_style projection cells 20 20 20 viscosity 0.05 density 1
variable m equal 4/3*PI*0.2^3*2.385
if "${body} == 0" then "create_atoms 1 single 0.51 0.53 0.57 units box" "set group all diameter 0.4 density 2.385" &
	"fix b all immersed/boundary spheres" "fix step all nve/sphere" "variable v equal vz[1]" &
	else "fix s all mesh/surface/stress file ball.stl type 1 move 0.51 0.53 0.57" &
	"fix b all immersed/boundary mesh s" "fix free all move/mesh/free mesh s mass ${m}" "variable v equal f_free[6]"
fix g all gravity 1 vector 0 0 -1
timestep 5e-3
run 60
print "V $(v_v) $(f_b[3])"
END
for body in 0 1; do
	"$TSIM" -in in.sink -log none -var body $body >out 2>&1
	report "sinks: $body" $? out
	grep '^V ' out
done >sunk
paste -s -d ' ' sunk | awk '{ d = $5 / $2 - 1; f = $6 / $3 - 1; ok = ($2 < -0.02 && d^2 < 0.03^2 && f^2 < 0.03^2); exit } END { exit !ok }'
report 'a mesh sinks as a sphere' $? sunk

# ---- wherever its image is, and its reference point
cuboid 0.207 0.153 0.2511 >slab.stl
cat >in.images <<'END'
units si
atom_style granular
newton off
communicate single vel yes
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
create_atoms 1 single 0.41 0.53 0.85 units box
set group all diameter 0.22 density 2385
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
pair_style gran model hertz
pair_coeff * *
flow_style projection cells 12 12 12 viscosity 0.05 density 1 body_force 1 0.3 0
fix s all mesh/surface/stress file slab.stl type 1 move $(0.5+v_far) 0.5 $(0.5-v_far) reference_point ${far} 0 -1
fix w all wall/gran model hertz mesh n_meshes 1 meshes s
fix b all immersed/boundary mesh s min_cells 0
fix free all move/mesh/free mesh s density 3 omega 0.2 0.7 1
timestep 2e-4
run 20
print "AT $(f_free[1]-v_far:%.8f) $(f_free[2]:%.8f) $(f_free[3]+v_far:%.8f) $(f_free[7]:%.7f) $(f_free[8]:%.7f) $(f_free[9]:%.7f) $(f_b[1]:%.7f) $(f_s[3]:%.6f)"
END
for far in 0 1 3; do
	"$TSIM" -in in.images -log none -var far $far >out 2>&1
	grep '^AT' out >"at.$far"
	same "image $far" at.0 "at.$far"
done

# ---- cut by a run or by a restart file: byte for byte
cut() { # NAME LINES OF RUNS
	{ echo 'variable out index deck'; sed '/^run/d' "$top_srcdir/tests/decks/in.free_mesh"; printf "$2"; } >"in.$1"
	"$TSIM" -in "in.$1" -log none >"$1" 2>&1
	report "restart: $1" $? "$1"
	rows "$1" | tail -n 1 >"rows.$1"
}
cut whole 'run 90\nwrite_restart whole.restart\n'
cut runs 'run 33\nrun 57\nwrite_restart runs.restart\n'
same 'two runs' whole.restart runs.restart
cut first 'run 71\nwrite_restart first.restart\n'
{
	printf 'variable out index deck\nnewton off\ncommunicate single vel yes\nread_restart first.restart\n'
	sed '/^run/d; /^units/d; /^atom_style/d; /^boundary/d; /^newton/d; /^communicate/d; /^create/d; /^region/d; /^set/d; /^velocity/d' \
		"$top_srcdir/tests/decks/in.free_mesh"
	printf 'run 19\nwrite_restart again.restart\n'
} >in.again
OMP_NUM_THREADS=3 "$TSIM" -in in.again -log none >again 2>&1
report 'restart: again' $? again
rows again | tail -n 1 >rows.again
same 'after a restart' rows.whole rows.again
same 'the state after it' whole.restart again.restart

# ---- what is refused
scene=$(two_materials)
plate 2 0 >plate.stl
rejects "$scene
fix block all mesh/surface file block.stl type 2
fix free all move/mesh/free mesh block density 1" 'make it by fix mesh/surface/stress'
rejects "$scene
fix plate all mesh/surface/stress file plate.stl type 2
fix free all move/mesh/free mesh plate density 1" 'is not closed'
rejects "$scene
fix block all mesh/surface/stress file block.stl type 2
fix free all move/mesh/free mesh block" 'either `density` or `mass`'
rejects "$scene
fix block all mesh/surface/stress file block.stl type 2
fix shift all move/mesh mesh block linear 1 0 0
fix free all move/mesh/free mesh block density 1" 'moved by another fix'
awk 'NR > 1 && /outer/ { n++ } n == 3 && /vertex/ { v[++k] = $0; if (k == 3) { print v[1]; print v[3]; print v[2] } next } 1' \
	block.stl >mixed.stl
rejects "$scene
fix block all mesh/surface/stress file mixed.stl type 2
fix free all move/mesh/free mesh block density 1" 'does not enclose a volume'
finish
