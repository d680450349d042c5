#!/bin/bash
# Fixes that are no physics of grains, by LAMMPS, an independent program: the same script, positions,
# velocities and outputs of the fix frame by frame.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
needs lmp lammps
needs /usr/bin/python3 python3

cat >in.scene <<'END'
units si
atom_style sphere
atom_modify map array
boundary ${faces}
newton off
comm_modify mode single vel yes cutoff 0.1
region box block -0.5 0.5 -0.6 0.6 -0.4 0.7 units box
create_box 2 box
create_atoms 1 single 0.1385 0.22 -0.13 units box
create_atoms 1 single -0.247 0.31 0.24 units box
create_atoms 2 single 0.411 -0.53 0.05 units box
create_atoms 2 single -0.32 -0.11 0.6 units box
create_atoms 1 single 0.02 0.03 -0.35 units box
set type 1 diameter 0.0865 density 2470
set type 2 diameter 0.0785 density 1830
group one id 1
group two id 2
group three id 3
group four id 4
group some id 1 3 4
velocity one set 0.2 -0.13 0.41
velocity two set -0.7 0.33 -0.2
velocity three set 0.5 -0.6 0.11
velocity four set 0.13 0.17 0.9
timestep 0.005
neighbor 1e-6 bin
neigh_modify delay 0 every 1 check no
END

second='run 31'
# Both programs wrap into the box in every step, as the skin is tiny; LAMMPS prints at the start of a
# run, too.
# agrees WHAT FACES TOLERANCE OUTPUT LINES...: OUTPUT is what a line is printed of in each step
agrees() {
	rm -f ./lmp.* ./tsim.*
	local what=$1 faces=$2 tolerance=$3 output=$4
	shift 4
	{
		echo 'include in.scene'
		printf '%s\n' "$@"
		echo 'dump d all custom 7 ${out}.dump id type x y z vx vy vz fx fy fz omegax omegay omegaz'
		echo 'dump_modify d sort id format float %.17g'
		[ -n "$output" ] && echo "fix show all print 1 '\$(step) $output' file \${out}.out screen no"
		echo 'thermo 1000'
		echo 'run 100'
		echo "$second"
	} >in.case
	set -- -in in.case -var faces "$faces" -log none -screen none
	lmp "$@" -var out lmp >err 2>&1
	report "$what: LAMMPS" $? err
	"$TSIM" "$@" -var out tsim 2>err
	report "$what: tsim" $? err
	sed -i '/BOX BOUNDS/,+3d' lmp.dump tsim.dump # of other precision
	for file in lmp.out tsim.out; do
		[ -e $file ] && sed -i '/^0 /d' $file && uniq $file >kept && mv kept $file
	done
	for file in dump ${output:+out}; do
		/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.$file tsim.$file \
			"$tolerance" >deviation 2>&1
		report "$what: $file" $? deviation
		echo "$what: $file $(cat deviation)"
	done
}
vector='$(f_a[1]:%.15g) $(f_a[2]:%.15g) $(f_a[3]:%.15g)'
scalar='$(f_a:%.15g)'

agrees 'move linear' 'p p p' 1e-12 '' 'fix a all move linear 0.3 NULL -0.7 units box' \
	'fix b all addforce 0 0.001 0'
agrees 'move wiggle' 'p p p' 1e-12 '' 'fix a all move wiggle 0.3 0.1 NULL 1.77 units box'
agrees 'move rotate' 'p p p' 1e-12 '' 'fix n two nve' \
	'fix a some move rotate 0.1 0.2 -0.1 1 2 -0.5 1.3 units box'
agrees 'move variable' 'p p p' 1e-12 '' 'variable d equal 0.2*(cos(step*dt*3)-1)' \
	'variable v equal -0.6*sin(step*dt*3)' 'variable w atom 0.1*x' \
	'fix a all move variable v_d NULL NULL v_v v_w NULL units box'
agrees 'momentum linear' 'p p p' 1e-12 '' 'fix n all nve' 'fix a some momentum 10 linear 1 0 1'
agrees 'momentum angular' 'p p p' 1e-12 '' 'fix n all nve' \
	'fix a some momentum 7 linear 1 1 1 angular'
agrees 'momentum rescale' 'p p p' 1e-12 '' 'fix n all nve' \
	'fix a all momentum 30 linear 1 1 1 angular rescale'
agrees setforce 'p p p' 1e-12 "$vector" 'fix n all nve' 'fix g all gravity 0.1 vector 1 2 3' \
	'region left block INF 0 INF INF INF INF units box' \
	'variable w atom 0.001*y' 'fix a some setforce 0.001 NULL v_w region left'
agrees addforce 'p p p' 1e-12 "$vector $scalar" 'fix n all nve' \
	'fix g all gravity 0.1 vector 1 2 3' 'fix a some addforce 0.001 0.0003 0 every 3'
agrees aveforce 'p p p' 1e-12 "$vector" 'fix n all nve' 'fix g all gravity 0.1 vector 1 2 3' \
	'fix a some aveforce NULL 0.0003 0'
agrees freeze 'p p p' 1e-12 "$vector" 'fix n all nve' 'fix g all gravity 0.1 vector 1 2 3' \
	'velocity some set 0 0 0' 'fix a some freeze' 
agrees lineforce 'p p p' 1e-12 '' 'fix n all nve' 'fix g all gravity 0.1 vector 1 2 3' \
	'fix a some lineforce 1 1 -0.5'
agrees planeforce 'p p p' 1e-12 '' 'fix n all nve' 'fix g all gravity 0.1 vector 1 2 3' \
	'fix a some planeforce 1 1 -0.5'
agrees nve/noforce 'p p p' 1e-12 '' 'fix g all gravity 0.1 vector 1 2 3' 'fix a all nve/noforce'
agrees store/state 'p p p' 1e-12 '$(c_r[1]:%.15g) $(c_r[2]:%.15g) $(c_r[3]:%.15g)' 'fix n all nve' \
	'fix s some store/state 5 xu vy com yes' 'fix s0 all store/state 0 z' \
	'compute r all reduce sum f_s[1] f_s[2] f_s0' 'thermo_style custom step c_r[1]'
agrees spring/self 'p p p' 1e-12 "$scalar" 'fix n all nve' 'fix a some spring/self 0.3 xz'
agrees 'spring tether' 'p p p' 1e-12 "$vector \$(f_a[4]:%.15g) $scalar" 'fix n all nve' \
	'fix a some spring tether 0.7 0.1 NULL 0.3 0.2'
agrees 'spring couple' 'p p p' 1e-12 "$vector \$(f_a[4]:%.15g) $scalar" 'fix n all nve' \
	'fix a some spring couple two 0.7 0.1 NULL 0.3 0.2'
agrees recenter 'p p p' 1e-12 "$vector $scalar" 'fix n all nve' \
	'fix a some recenter INIT 0.1 NULL shift all units box'
agrees 'recenter fraction' 'p p p' 1e-12 "$vector $scalar" 'fix n all nve' \
	'fix a some recenter 0.2 NULL 0.7 units fraction'
one() { # fix deform: LAMMPS counts from the start of each run, so there is one only
	agrees "deform $1" 'p p p' 1e-12 '$(lx:%.15g) $(ly:%.15g) $(lz:%.15g)' 'fix n all nve' \
		"fix a ${3:-all} deform 1 $1 remap $2 units box" 'thermo_style custom step lx ly lz'
}
second=
one 'x erate -0.3 z vel 0.1' x
one 'y trate 0.4 x final -0.3 0.6' x
one 'x wiggle 0.1 0.35 y volume' x
one 'z erate 0.2 x volume y volume' x some
one 'x delta 0.1 -0.05 y scale 0.7 z volume' x
one 'x erate -0.3 y wiggle 0.1 0.35' v some
one 'z vel 0.1' none
agrees viscous 'p p p' 1e-12 '' 'fix n all nve' 'fix a some viscous 0.4 scale 2 2.385 scale 1 0.7'
for ave in one running; do
	agrees "ave/correlate $ave" 'p p p' 1e-12 '' 'fix n all nve' 'fix g some spring/self 3 xyz' \
		'compute c some com' 'variable v equal vcm(some,x)+0.1' \
		"fix c all ave/correlate 2 5 20 c_c[*] v_v type auto/upper ave $ave prefactor 2.5 file \${out}.acf"
	/usr/bin/python3 "$top_srcdir/tests/crosscheck/columns.py" lmp.acf tsim.acf 2e-5 >deviation 2>&1
	report "ave/correlate $ave" $? deviation
	echo "ave/correlate $ave $(cat deviation)"
done
agrees nve/limit 'p p p' 1e-12 "$scalar" 'fix g all gravity 3 vector 1 2 3' 'fix a all nve/limit 0.004'
second='run 31'
agrees wall/reflect 'f f f' 1e-12 '' 'fix n all nve' 'variable top equal 0.7-0.1*step*dt' \
	'fix a all wall/reflect xlo EDGE xhi 0.45 ylo -0.55 yhi EDGE zlo EDGE zhi v_top units box'
finish
