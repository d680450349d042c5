#!/bin/bash
# The skin is chosen by what it costs, and results do not depend on it: a heap that comes to rest, with the skin chosen
# and with it as given.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.heap <<'EOF'
units		si
boundary	f f f
newton		off
communicate	single vel yes
region		box block 0 0.1 0 0.1 0 0.2 units box
create_box	1 box
region		cloud block 0.01 0.09 0.01 0.09 0.01 0.15 units box
lattice		sc 0.0125
create_atoms	1 region cloud
set		type 1 diameter 0.012 density 2385
fix		y all property/global youngsModulus peratomtype 5.2e6
fix		n all property/global poissonsRatio peratomtype 0.3
fix		e all property/global coefficientRestitution peratomtypepair 1 0.3
fix		c all property/global coefficientFriction peratomtypepair 1 0.5
pair_style	gran model hertz tangential history
pair_coeff	* *
fix		floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix		west all wall/gran model hertz tangential history primitive type 1 xplane 0.0 0.1
fix		south all wall/gran model hertz tangential history primitive type 1 yplane 0.0 0.1
fix		move all nve/sphere
fix		down all gravity 9.81 vector 0.1 0.03 -1
fix		calm all viscous 1e-3
neighbor	0.006 bin ${fixed}
timestep	2e-5
run		${first}
run		$(7000-v_first)
dump		d all custom 1 ${out}.dump id x y z vx vy vz omegax fx fy fz tqx
dump_modify	d sort id format float %.17g
run		0
EOF
for fixed in no yes; do
	"$TSIM" -in in.heap -var fixed "fixed $fixed" -var out "$fixed" -var first 7000 -log "log.$fixed" -screen none 2>err
	report "skin fixed $fixed" $? err
done
same 'the skin changes no digit' no.dump yes.dump
rows_of() { sed -n 's/^Neighs: //p' "$1" | tail -n 1; }
rows_of log.no >fewer
rows_of log.yes >more
[ "$(cat fewer)" -lt "$(($(cat more) * 4 / 5))" ]
report 'a heap at rest has fewer rows' $? fewer
"$TSIM" -in in.heap -var fixed 'fixed no' -var out cut -var first 3217 -log log.cut -screen none 2>err
same 'a run cut in two' no.dump cut.dump

# Fast spheres in a box of fixed faces: 0.0025 diameters a step, so s = 1.6 d 0.0025^(1/4), 72 steps.
cat >in.fast <<'EOF'
units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.2 0.2 0.2 units box
create_atoms 1 single 0.7 0.7 0.7 units box
set type 1 diameter 0.04 density 1000
set atom 1 vx 1
set atom 2 vx -1
pair_style spring/dashpot
pair_coeff 1 1 stiffness 2e3 restitution 0.9
fix move all nve/sphere
neighbor 0.04 bin
timestep 1e-4
thermo 800
thermo_style custom step nbuild
run 800
EOF
"$TSIM" -in in.fast -log none >out 2>err
awk '$1 == 800 && NF == 2 { builds = $2 } END { exit !(builds == 12) }' out
report 'fast spheres: builds as far apart as they pay' $? out

# without particles there is no skin yet to tell
printf '%s\n' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' 'pair_style gran/hooke 1 NULL 1 NULL 0.5 0' \
	'pair_coeff * *' '${skin}' 'run 0' >in.empty
for case in 'print none:no pairs yet' 'neighbor 0.02 bin:0 pairs within the skin 0.02'; do
	"$TSIM" -explain -in in.empty -log none -var skin "${case%:*}" >out 2>&1 && shows "${case#*:}" out
	report "no particles, ${case%:*}" $? out
done
finish
