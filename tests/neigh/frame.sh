#!/bin/bash
# Displacements are measured relative to a moving frame where that saves rebuilds: no digit depends on it. Grains fall fast
# beside others at rest, onto a floor and along a wall; some leave the box and are ignored; a floor begins to move late.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.fall <<'EOF'
units		si
boundary	f f f
newton		off
communicate	single vel yes
region		box block 0 0.1 0 0.1 0 0.2 units box
create_box	1 box
region		heap block 0.01 0.09 0.01 0.09 0.005 0.03 units box
region		cloud block 0.01 0.09 0.01 0.09 0.05 0.19 units box
lattice		sc 0.0125
create_atoms	1 region heap
group		heap region heap
create_atoms	1 region cloud
group		cloud subtract all heap
set		type 1 diameter 0.012 density 2385
velocity	cloud set 0.4 0.1 -3
include		in.model
variable	builds equal nbuild
variable	grains equal atoms
run		${first}
print		"BUILDS ${builds} GRAINS ${grains}"
if		"${save} == 1" then "write_restart saved"
include		in.rest
EOF
cat >in.model <<'EOF'
fix		y all property/global youngsModulus peratomtype 5.2e6
fix		n all property/global poissonsRatio peratomtype 0.3
fix		e all property/global coefficientRestitution peratomtypepair 1 0.3
fix		c all property/global coefficientFriction peratomtypepair 1 0.5
pair_style	gran model hertz tangential history
pair_coeff	* *
fix		move all nve/sphere
fix		down all gravity 9.81 vector 0 0 -1
thermo_modify	lost ignore
neighbor	0.002 bin fixed ${fixed}
timestep	2e-5
include		in.${walls}
EOF
cat >in.rest <<'EOF'
run		2000 upto
dump		d all custom 1 ${out}.dump id x y z vx vy vz omegax fx fy fz tqx
dump_modify	d sort id format float %.17g
run		0
EOF
cat >in.again <<'EOF'
read_restart	saved
include		in.model
include		in.rest
EOF
cat >in.planes <<'EOF'
fix		floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix		west all wall/gran model hertz tangential history primitive type 1 xplane 0.0
EOF
cat >in.meshes <<'EOF'
fix		south all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix		plate all mesh/surface primitive box 0.005 0.095 0.005 0.095 0.001 0.004 type 1
fix		floor all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate
variable	pace equal "1.5*(step > 700)"
fix		lift all move/mesh mesh plate linear/variable 0. 0. v_pace
EOF
go() { # NAME WALLS FIXED FIRST WORDS...
	"$TSIM" -in "${in:-in.fall}" -var walls "$2" -var fixed "$3" -var out "$1" -var first "$4" -var save "${save:-0}" \
		-log "log.$1" -screen none "${@:5}" 2>err
	report "$1" $? err
}
builds_of() { sed -n 's/^BUILDS \([0-9]*\).*/\1/p' "log.$1"; }
for walls in planes meshes; do
	save=1 go $walls.no $walls no 1000
	go $walls.yes $walls yes 1000
	same "$walls: the frame changes no digit" $walls.no.dump $walls.yes.dump
	grep -o 'GRAINS.*' log.$walls.no >left
	grep -o 'GRAINS.*' log.$walls.yes >left.yes
	same "$walls: grains are ignored in the same steps" left left.yes
	[ "$(builds_of $walls.no)" -lt "$(($(builds_of $walls.yes) * 2 / 3))" ]
	report "$walls: fewer rebuilds" $? log.$walls.no
	go $walls.cut $walls no 317
	same "$walls: a run cut in two" $walls.no.dump $walls.cut.dump
	in=in.again go $walls.again $walls no 1000
	same "$walls: a restart file" $walls.no.dump $walls.again.dump
	go $walls.two $walls no 1000 -threads 2
	same "$walls: two threads" $walls.no.dump $walls.two.dump
done
finish
