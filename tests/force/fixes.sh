#!/bin/bash
# Fixes that are no physics of grains: closed forms, outputs, ends of runs; each cut by a restart file is
# the run in one, and threads change nothing.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.box <<'END'
units si
boundary p p p
newton off
communicate single vel yes
region box block 0 1 0 1.2 0 0.9 units box
END
cat >in.grains <<'END'
include in.box
create_box 2 box
create_atoms 1 random 60 86028157 NULL overlap 0.08
create_atoms 2 random 60 49979687 NULL overlap 0.08
set type 1 diameter 0.0865 density 2470
set type 2 diameter 0.0785 density 1830
velocity all create 1e21 67867967
END
cat >in.rest <<'END'
group light type 2
region left block INF 0.4 INF INF INF INF units box
pair_style spring/dashpot
pair_coeff * * stiffness 20000 restitution 0.7
timestep 1e-4
variable up equal 0.05*sin(40*time)
variable less equal 0.8-step/1000
END

# run_script NAME THREADS: standard input after the grains
run_script() {
	cat >"in.$1"
	OMP_NUM_THREADS=$2 "$TSIM" -in "in.$1" -log none >"$1.out" 2>err
	report "$1 runs" $? err
}

# exact WHAT LINES...: whole, cut by a restart file, on two threads
exact() {
	local what=$1
	shift
	{
		printf '%s\n' "$@"
		echo 'package omp 2 grain 20'
		echo 'dump d all custom 10 ${out}.dump id type x y z vx vy vz fx fy fz omegax radius mass'
		echo 'dump_modify d sort id format float %.17g'
		echo 'dump_modify d append yes'
	} >in.fixes
	rm -f ./*.dump
	for threads in 1 2; do
		run_script whole $threads <<-END
			variable out string whole$threads
			include in.grains
			include in.rest
			include in.fixes
			package omp $threads grain 20
			run 120
			write_restart whole$threads.restart
		END
	done
	run_script first 1 <<-END
		variable out string parts
		include in.grains
		include in.rest
		include in.fixes
		run 53
		write_restart cut.restart
	END
	run_script second 1 <<-END
		variable out string parts
		read_restart cut.restart
		include in.rest
		include in.fixes
		run 67
		write_restart parts.restart
	END
	same "$what: dump, cut" whole1.dump parts.dump
	same "$what: state, cut" whole1.restart parts.restart
	same "$what: dump, threads" whole1.dump whole2.dump
}

# says WHAT LINE: in the output of the last script
says() {
	says_line "$2" script.out
	report "$1" $? script.out
}

script() {
	{
		echo 'include in.box'
		cat
	} | run_script script 1
}

exact move 'fix n all nve/sphere' 'group few id <= 20' 'group rest subtract all few' 'unfix n' \
	'fix n rest nve/sphere' 'fix a few move wiggle 0.01 NULL 0.02 0.031 units box'
exact 'move rotate' 'group few id <= 20' 'group rest subtract all few' 'fix n rest nve/sphere' \
	'fix a few move rotate 0.5 0.6 0 0 0 1 0.31 units box'
exact momentum 'fix n all nve/sphere' 'fix a light momentum 7 linear 1 1 1 angular rescale'
exact forces 'fix n all nve/sphere' 'variable w atom 0.01*y' 'fix g all gravity 9.81 vector 0 0 -1' \
	'fix a light addforce 0.1 0 v_w every 4 region left' 'fix b light setforce NULL v_w 0 region left' \
	'fix c light aveforce 0 NULL 0 region left' \
	'fix d light lineforce 1 1 0' 'fix e light planeforce 0 1 1' \
	'thermo_style custom step f_a f_a[*] f_b[*] f_c[*]'

exact property/atom 'fix n all nve/sphere' 'fix age all property/atom age scalar yes yes no 2.385' \
	'fix marks all property/atom i_mark d2_spot 2 d_w' 'variable w atom 0.01*f_age*x+d_w' \
	'fix a light addforce 0.1 0 v_w'
exact store/state 'fix n all nve/sphere' 'fix s light store/state 7 xu vx fy com yes' \
	'fix s0 light store/state 0 z' 'variable w atom 0.01*f_s[2]+f_s0' 'fix a light addforce 0.1 0 v_w'
exact 'adapt' 'fix n all nve/sphere' 'variable size equal 0.078+step*1e-5' \
	'variable k atom 1.1+0.05*sin(step)' 'variable soft equal 1-step/300' \
	'fix a light adapt 5 atom diameter v_size' 'fix b all adapt 3 atom density v_k scale yes' \
	'fix c all adapt 4 pair spring/dashpot stiffness 1 1* v_soft scale yes'
exact 'remove, whole particles' 'fix n all nve/sphere' \
	'fix a light remove nevery 7 massrate 60 style delete seed 5143 region left' \
	'variable q equal 20*step' 'fix b all remove nevery 11 massratevariable q style delete seed 7 integrated_error no'
exact 'remove, by shrinking' 'fix n all nve/sphere' 'variable q equal 500*(step/60)' \
	'fix a all remove nevery 7 massrate v_q style shrink delete_below 0.037 seed 5143'
exact 'scale/diameter' 'fix n all nve/sphere' 'region core sphere 0.5 0.6 0.4 0.35 units box move NULL NULL v_up' \
	'fix a all scale/diameter 3 region core scale v_less scale_width 0.4'

# fast enough that images move by more than the skin between two rebuilds
exact 'deform, positions follow' 'fix n all nve/sphere' \
	'fix a all deform 2 x erate -5 y wiggle 0.1 0.01 z volume units box' \
	'thermo_style custom step lx ly lz vol'
exact 'deform, velocities change' 'fix n all nve/sphere' 'variable l equal 0.3*sin(step/40)' \
	'variable r equal 0.3*cos(step/40)/40/dt' \
	'fix a light deform 3 z variable v_l v_r x trate -5 remap v units box' 'neighbor 0.003 bin'

# a quarter turn and three quarters of a period
script <<'END'
create_box 1 box
create_atoms 1 single 0.7 0.6 0.3 units box
create_atoms 1 single 0.1 0.1 0.1 units box
set group all diameter 0.2 density 2385
group a id 1
group b id 2
fix a a move rotate 0.5 0.6 0 0 0 2 0.8 units box
fix b b move wiggle 0.05 0 NULL 0.8 units box
fix g b gravity 2.385 vector 0 0 -1
timestep 0.002
run 100
print "a $(x[1]:%.12g) $(y[1]:%.12g) $(vx[1]:%.12g) $(abs(vy[1])<1e-12) $(omegaz[1]:%.12g)"
run 200
print "b $(x[2]:%.12g) $(abs(vx[2])<1e-12) $(z[2]+2.385*0.6^2/2:%.12g)"
END
says 'rotate: a quarter' 'a 0.5 0.8 -1.57079632679 1 7.85398163397'
says 'wiggle: three quarters, z falls freely through the face' 'b 0.05 1 1'

# numbers of the user: first values, also of particles that come later
script <<'END'
fix age all property/atom age scalar yes no no 2.5
fix uf all property/atom uf vector yes yes no 1 -2 3
fix m all property/atom i_mark d2_spot 2 d_w
create_box 1 box
create_atoms 1 single 0.7 0.6 0.3 units box
set group all diameter 0.2 density 2385
compute p all property/atom x vx
fix s all store/state 0 xu yu c_p[*]
velocity all set 0.1 0 0
create_atoms 1 single 0.1 0.1 0.1 units box
set group all diameter 0.2 density 2385
fix n all nve
variable w atom d_w+f_uf[2]*f_m[3]
fix t all store/state 2 x vx com yes
fix f all store/state 2 x vx com yes
compute a all reduce sum f_age f_uf[*] d_w d2_spot[2] v_w f_s[*]
timestep 0.01
run 5
print "numbers $(c_a[1]) $(c_a[2]) $(c_a[3]) $(c_a[4]) $(c_a[5]) $(c_a[6]) $(c_a[7])"
print "stored $(c_a[8]:%g) $(c_a[9]:%g) $(c_a[10]:%g) $(c_a[11]:%g)"
compute b all reduce max f_t[*]
print "later $(c_b[1]:%.6g) $(c_b[2]:%g)"
END
says 'first values' 'numbers 5 2 -4 6 0 0 0'
says 'stored when made' 'stored 0.7 0.6 0.7 0'
says 'stored at intervals' 'later 0.704 0.1'

# sizes that change: density, mass and contacts go with them; 2.385 -> 2.585 twice the overlap
script <<'END'
create_box 1 box
create_atoms 1 single 0.3 0.6 0.3 units box
create_atoms 1 single 0.5 0.6 0.3 units box
set group all diameter 0.1 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 1
fix n all nve
variable size equal 0.1+0.11*(step>3)
fix a all adapt 2 atom diameter v_size
timestep 1e-6
run 6
print "grown $(fx[2]/2385:%.6g) $(mass[1]/(PI/6*0.21^3):%.9g)"
variable soft equal 0.5
fix b all adapt 1 pair spring/dashpot stiffness 1 1 v_soft scale yes reset yes
run 1
print "softer $(fx[2]/2385:%.6f)"
run 2
print "softer again $(fx[2]/2385:%.6f)"
unfix b
run 0
print "hard again $(fx[2]/2385:%.6f)"
END
says 'new contacts are found' 'grown 0.01 2385'
says 'pair, scaled' 'softer 0.005000'
says 'always of the first value' 'softer again 0.005000'
says 'reset' 'hard again 0.010000'

# the same with the fix before the coefficients: factors are those of the values given later
script <<'END'
create_box 1 box
create_atoms 1 single 0.3 0.6 0.3 units box
create_atoms 1 single 0.5 0.6 0.3 units box
set group all diameter 0.21 density 2385
pair_style spring/dashpot
fix n all nve
timestep 1e-6
variable soft equal 0.5
fix b all adapt 1 pair spring/dashpot stiffness 1 1 v_soft scale yes reset yes
pair_coeff * * stiffness 2385 restitution 1
run 1
print "softer $(fx[2]/2385:%.6f)"
unfix b
run 0
print "hard again $(fx[2]/2385:%.6f)"
END
says 'coefficients after the fix' 'softer 0.005000'
says 'coefficients after the fix, reset' 'hard again 0.010000'

# a number that is not the first one of its coefficients: the dashpot, where the spring is too soft to matter
script <<'END'
create_box 1 box
create_atoms 1 single 0.3 0.6 0.3 units box
create_atoms 1 single 0.4999999 0.6 0.3 units box
set group all diameter 0.2 density 2385
group second id 2
velocity second set -3 0 0
pair_style spring/dashpot
pair_coeff * * stiffness 1e-6 damping 7
fix n all nve
timestep 1e-9
variable more equal 2
fix b all adapt 1 pair spring/dashpot damping * * v_more scale yes
run 1
print "dashpot $(fx[2]:%.5f)"
END
says 'the dashpot, scaled' 'dashpot 42.00000'
cat >in.wrong <<'END'
region box block 0 1 0 1 0 1
create_box 2 box
create_atoms 1 single 0.3 0.6 0.3 units box
pair_style spring/dashpot
pair_coeff 1 1 stiffness 1 restitution 1
variable soft equal 0.5
fix n all nve
fix a all adapt 1 pair spring/dashpot stiffness 1 2 v_soft
run 0
END
refused 'coefficients never given' 'types that no pair_coeff has given' -in in.wrong

# the box: lengths of each style, one goal over two runs, and what flies through its faces
script <<'END'
create_box 1 box
create_atoms 1 single 0.75 0.6 0.3 units box
set group all diameter 0.1 density 2385
velocity all set 2.5 0 0
fix n all nve
fix a all deform 10 x trate 0.5 y scale 0.7 z volume units box
timestep 0.002
run 50 stop 100
print "half $(lx:%.12g) $(ly:%.12g) $(vol/1.08:%.12g)"
run 50 start 0
print "whole $(lx:%.12g) $(ly:%.12g) $(vol/1.08:%.12g)"
unfix a
fix a all deform 1 y final 0 1.2 x delta 0 -0.1 remap v units box
run 30
print "goals $(ly:%.12g) $(vx[1]:%.12g) $(vy[1]:%g)"
END
says 'half way' 'half 1.05127109638 1.02 1'
says 'at the end' 'whole 1.10517091808 0.84 1'

# two periodic images of one contact: a box that closes on a sphere squeezes it from both sides
script <<'END'
create_box 1 box
create_atoms 1 single 0.02 0.6 0.45 units box
create_atoms 1 single 0.97 0.6 0.45 units box
set group all diameter 0.1 density 2385
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 1
fix f all move linear 0 0 0 units box
fix a all deform 1 x delta 0 -0.02 remap none units box
neighbor 0.002 bin
timestep 1e-5
run 40
print "squeezed $(fx[1]/2385:%.9f) $(fx[2]/2385:%.9f)"
END
says 'contacts across faces that come nearer' 'squeezed 0.069500000 -0.069500000'

# springs: after one period back at the start; two grains on a rope swing with the reduced mass
script <<'END'
create_box 1 box
create_atoms 1 single 0.6 0.6 0.3 units box
create_atoms 1 single 0.2 0.2 0.3 units box
create_atoms 1 single 0.2 0.5 0.3 units box
set group all diameter 0.1
set group all mass 2.385
group a id 1
group b id 2
group c id 3
group bc id 2 3
fix n all nve
fix s a spring/self 17.0
displace_atoms a move 0.03 -0.02 0.01 units box
fix r b spring couple c 11.0 0 0 0 0.28
variable own equal 2*PI*sqrt(2.385/17)
variable both equal 2*PI*sqrt(2.385/2/11)
timestep $(v_own/2000)
run 1000
print "half $(x[1]:%.4f) $(y[1]:%.4f) $(z[1]:%.4f) $(f_s+2.385/2*(vx[1]^2+vy[1]^2+vz[1]^2):%.6g)"
run 1000
print "whole $(x[1]:%.4f) $(y[1]:%.4f) $(z[1]:%.4f)"
timestep $(v_both/2000)
reset_timestep 0
velocity bc set 0 0 0
variable gap equal y[3]-y[2]
variable first equal $(v_gap)
run 2000
print "rope $(v_gap/v_first:%.4f) $(xcm(bc,y):%.6f)"
END
says 'half a period' 'half 0.5700 0.6200 0.2900 0.0119'
says 'a period' 'whole 0.6300 0.5800 0.3100'
says 'reduced mass, the middle stays' 'rope 1.0000 0.350000'

# a heat bath: 3 N/2 k T within three standard deviations, and no net push
script <<'END'
lattice sc 0.1
create_box 1 box
create_atoms 1 box
set group all diameter 0.05
set group all mass 2e-3
fix n all nve
fix b all langevin 1e20 1e20 0.02 86028157 zero yes
timestep 5e-4
run 400
variable t equal ke(all)/(1.5*count(all)*1.380649e-23*1e20)
print "temperature $(abs(v_t-1)<3*sqrt(2/3/count(all))) $(abs(vcm(all,x))<1e-12)"
END
says 'temperature of a bath' 'temperature 1 1'

# a fall at the speed that is asked for: the brake grows until it carries the weight
script <<'END'
create_box 1 box
create_atoms 1 single 0.6 0.6 0.3 units box
set group all diameter 0.1
set group all mass 2.385
variable brake internal 0
variable up equal v_brake
variable fall equal vcm(all,z)
fix n all nve
fix g all gravity 9.81 vector 0 0 -1
fix b all addforce 0 0 v_up
fix c all controller 1 50.0 1.5 0.5 1.0 v_fall -0.25 brake
timestep 1e-3
run 20000
print "brake $(f_c/(2.385*9.81):%.3f) $(v_fall:%.3f) $(abs(f_c-v_up)<1e-12)"
END
says 'controller' 'brake 1.000 -0.250 1'

# gravity that turns: the velocity of a free particle is the integral of g (sin, -cos), to second order in the step; a
# direction of constant variables is that of the numbers, bit for bit
script <<'END'
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 0.1 density 2385
variable angle equal 30*step*dt
variable x equal sin(30*step*dt*PI/180)
variable z equal -cos(30*step*dt*PI/180)
variable w equal PI/6
variable vx equal vcm(all,x)
variable vz equal vcm(all,z)
fix n all nve/sphere
fix g all gravity 0.1 chute v_angle
timestep 1e-3
run 2000
variable one equal $(v_vx)
print "turns $((v_vx*v_w/0.1-0.5)/1e-3^2*12:%.2f) $(abs(v_vz*v_w/0.1+sin(2*v_w))<1e-6)"
velocity all set 0 0 0
reset_timestep 0
unfix g
fix g all gravity 0.1 vector v_x 0 v_z
run 2000
print "the same $(abs(v_vx-v_one)<1e-15)"
END
says 'gravity that turns' "turns $(awk 'BEGIN { w = atan2(0, -1) / 6; printf "%.2f", -0.5 * w * w }') 1" 'the same 1'

# particles that vanish: so many each time, of the right ones, until none is left
script <<'END'
create_box 2 box
create_atoms 1 random 30 86028157 NULL units box
create_atoms 2 random 30 49979687 NULL units box
set group all diameter 0.01 density 2385
group light type 2
region left block INF 0.5 INF INF INF INF units box
variable there equal count(light,left)
variable first equal $(v_there)
fix n all nve
fix e light evaporate 5 4 left 49892
timestep 1e-3
run 14
print "gone $(f_e) $(count(all)) $(v_first-v_there)"
run 100
print "all $(f_e-v_first) $(v_there)"
END
says 'so many each time' 'gone 8 52 8'
says 'until none is left' 'all 0 0'

# mass that is removed at a rate: whole particles, to within one of them; or a part of each
removal='create_box 2 box
create_atoms 1 random 60 86028157 NULL units box
create_atoms 2 random 30 49979687 NULL units box
set type 1 diameter 0.01 density 2385
set type 2 diameter 0.02 density 1310
region left block INF 0.5 INF INF INF INF units box
fix n all nve
timestep 1e-3
variable m1 equal 2385*PI/6*0.01^3
variable m2 equal 1310*PI/6*0.02^3
variable before equal mass(all)
variable m0 equal $(v_before)
variable others equal $(count(all)-count(all,left))'
script <<END
$removal
fix r all remove nevery 7 massrate \$(3.3*v_m1/0.007) style delete seed 5143 region left atomtype 1
run 35
print "one kind \$(count(all)) \$(f_r[2]) \$((v_m0-mass(all))/v_m1:%.9g) \$(f_r[1]/v_m1:%.9g) \$(f_r[3]/v_m1:%.6f)"
unfix r
region right block 0.5 INF INF INF INF INF units box
variable rate equal v_m1/0.007*(time>0.05)
fix r all remove nevery 5 massratevariable rate style delete seed 5143 region left
run 5000
print "all there were \$(count(all,left)) \$(count(all)-v_others) \$(f_r[3]>0)"
END
says 'removed to within a particle' 'one kind 73 17 17 17 -0.500000'
says 'until nothing is left' 'all there were 0 0 1'
script <<END
$removal
fix r all remove nevery 10 massrate \$(0.25*v_m0/0.02) style shrink delete_below 0.0045 seed 7 verbose yes
run 10
print "part \$(mass(all)/v_m0:%.9g) \$(count(all)) \$((2*radius[1]/0.01)^3:%.9g) \$(mass[1]/v_m1:%.9g) \$(f_r[1]/v_m0:%.9g)"
run 20
print "the small ones go \$(count(all)) \$(f_r[2]) \$(f_r[3]<0)"
END
says 'shrunk' 'part 0.875 90 0.875 0.875 0.125'
says 'deleted below a radius' 'the small ones go 30 60 1'
grep -q '^fix remove r: step 10, mass 0.0.* removed, 0 particles deleted, 90 chosen from' script.out
report 'told' $? script.out
# without the balance the mean is right; what is left is that of the last step, in which no lot fell
script <<END
$removal
fix r all remove nevery 1 massrate \$(0.05*v_m1/0.001) style delete seed 5143 atomtype 1 integrated_error no
run 600
print "by lot \$(f_r[2]>=22 && f_r[2]<=38) \$(f_r[3]/v_m1:%.6f)"
END
says 'the mean is right' 'by lot 1 0.050000'

# diameters by the distance from a centre or an axis
script <<'END'
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.65 units box
create_atoms 1 single 0.5 0.5 0.78 units box
create_atoms 1 single 0.1 0.5 0.5 units box
set group all diameter 0.02 density 2385
region core sphere 0.5 0.5 0.5 0.2 units box
region tube cylinder z 0.5 0.5 0.1 0.4 0.79 units box
fix n all nve
timestep 1e-4
variable m0 equal $(mass[1])
fix s all scale/diameter 0 region core scale 0.5
run 0
print "linear $(radius[1]) $(radius[2]:%.6g) $(radius[3]:%.6g) $(radius[4]) $(mass[2]/v_m0:%.9g) $(mass[4]/v_m0)"
velocity all set 0 0 2
run 500
print "once $(radius[1]:%.6g)"
unfix s
set group all diameter 0.02 density 2385
fix s all scale/diameter 5 region tube scale 3 scale_width 0.25
run 5
print "axis $(radius[1]:%.6g) $(radius[2]:%.6g) $(radius[3]:%.6g) $(radius[4]:%.6g)"
region back block -1 2 -1 2 -1 2 units box
displace_atoms all move 0.08 0 0 units box
run 5
print "side $(radius[1]:%.6g)"
END
says 'linear to the centre' '*linear 0.0050000000000000001041 0.00875 0.01 '
says 'the mass follows' '* 0.669921875 1'
says 'once only' 'once 0.005'
says 'a cylinder ends' 'axis 0.03 0.03 0.01 0.01'
says 'the outer part' 'side 0.026'

# what ends a run early
script <<'END'
create_box 1 box
create_atoms 1 single 0.5 0.6 0.3 units box
set group all diameter 0.2 density 2385
velocity all set 0.25 0 0
fix n all nve
variable x equal x[1]
timestep 0.01
thermo 1000
fix h all halt 2 v_x > 0.6 error continue
run 100
print "continued at $(step)"
unfix h
fix h all halt 5 v_x > 0.701 error soft message no
run 100
print "soft at $(step)"
run 100
print "skipped at $(step)"
timer timeout reset
unfix h
run 3
print "again at $(step)"
fix h all halt 1 tlimit > 1e-9
run 100
print "time at $(step)"
timer timeout reset
fix h all halt 1 diskfree < 0 path .
run 1
print "disk at $(step)"
END
says 'halt continue' 'continued at 42'
says 'its message' 'Fix halt condition for fix-id h met on step 42 with value 0.605'
says 'the table has the last step' '*      42 '
says 'halt soft' 'soft at 85'
says 'later runs are skipped' 'skipped at 85'
says 'until the timer is reset' 'again at 88'
says 'time limit' 'time at 89'
says 'room on the disk' 'disk at 90'
cat >in.bad <<'END'
include in.grains
include in.rest
fix n all nve
END
bad() { # TEXT LINE...
	{
		cat in.bad
		printf '%s\n' "${@:2}"
	} >in.wrong
	refused "$2" "$1" -in in.wrong
}
bad 'Fix halt condition for fix-id h met on step 7 with value 7' 'variable s equal step' \
	'fix h all halt 7 v_s > 1 error hard' 'run 20'
bad "did you mean 'bondmax'" 'fix h all halt 7 bondmx > 1'
bad "unknown variable 'sped'" 'variable speed equal 1' 'fix h all halt 7 v_sped > 1'
bad 'expected one of <, <=' 'fix h all halt 7 tlimit => 1'
bad 'no disk at' 'fix h all halt 1 diskfree < 0 path /no/where' 'run 1'
bad 'requires two dimensions' 'fix e all enforce2d'
bad 'no wall can be at xlo' 'fix w all wall/reflect xlo EDGE'
bad 'expected at least one of' 'fix w all wall/reflect'
bad 'linear, angular or both' 'fix m all momentum 10'
bad 'three numbers that are 0 or 1' 'fix m all momentum 10 linear 1 0.5 1'
bad 'the axis has no length' 'fix m all move rotate 0 0 0 0 0 0 1'
bad 'variables are only possible with the style `variable`' 'variable s equal step' 'fix m all move linear v_s 0 0'
bad 'the direction has no length' 'fix l all lineforce 0 0 0'
bad 'energy takes a variable' 'fix l all addforce 0 0 0 energy 3'
bad 'expected yes or no' 'fix p all property/atom age scalar maybe no no 1'
bad 'and one value' 'fix p all property/atom age scalar yes no no 1 2'
bad "'radius' has a meaning already" 'fix p all property/atom radius scalar yes no no 1'
bad 'expected mol, q, rmass' 'fix p all property/atom age'
bad 'number of its columns' 'fix p all property/atom d2_age'
bad "unknown quantity 'xx'" 'fix s all store/state 0 xx'
bad "'c_c' is a vector or a single number" 'compute c all reduce max x' 'fix s all store/state 0 c_c'
bad 'expected diameter, density or mass' 'variable s equal 1' 'fix a all adapt 1 atom charge v_s'
bad "has no number 'stif'; known: stiffness" 'variable s equal 1' \
	'fix a all adapt 1 pair spring/dashpot stif 1 1 v_s'
bad 'it is spring/dashpot' 'variable s equal 1' 'fix a all adapt 1 pair gran stif 1 1 v_s'
bad 'one or more of atom' 'variable s equal 1' 'fix a all adapt 1 kspace v_s'
bad 'is -1 for particle' 'variable s equal -1' 'fix a all adapt 1 atom diameter v_s' 'run 1'
bad "'3' is not a type" 'fix v all viscous 0.2 scale 3 1'
bad 'is followed by a number > 0' 'fix v all viscous 0.2 scale 2'
bad 'expected a number, INIT or NULL' 'fix r all recenter INIT NUL 0'
# what another program has and tsim lacks: the line to write instead; such lines are taken
bad 'region W plane PX PY PZ NX NY NZ' 'fix w all wall/gran model hertz primitive type 1 general_plane 0 0 0 0 0 1'
bad 'for other directions use a region' 'fix w all wall/gran model hertz primitive type 1 general_cylinder 1 0 0 0 0 0 1'
bad 'fix ID GROUP pour N TYPE SEED' 'fix p all pour/legacy 100 1 29494 region left'
bad 'massflow/mesh mesh MESH vec_side' 'fix m all massflow/mesh/face mesh m'
bad 'fix ID all move/mesh/free mesh M density D' 'fix m all mesh/surface/stress/6dof file x.stl type 1'
bad 'ave/euler nevery N cell_size_relative C' 'fix m all ave/euler/region nevery 10 region left'
bad 'particles are spheres' 'set group all shape 1 1 1'
bad 'coupling of coarse and fine grains' 'fix m all forcecontrol/region ctrlPV stress'
script <<'END'
units si
boundary f f f
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.59 0.5 0.5 units box
set group all diameter 0.09 density 1000
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
bond_style contact
compute n all bonds
compute l all bond/local dist force fx fy fz
compute w all property/local batom1 batom2 btype
region R block 0.2 0.8 0.2 0.8 0.2 0.8 units box
compute g all reduce/region R ave vx vy vz
region W plane 0.1 0 0.1 1 0 1 units box
fix wall all wall/gran/region model hertz tangential history type 1 region W
fix cells all ave/euler nevery 10 cell_size_relative 4 parallel no
fix grav all gravity 9.81 vector 0 0 -1
fix rain all pour 100 1 29494 region R vol 0.2 50 diam range 0.01 0.012 dens 2500 2500 vel 0 0 0 0 -1
fix i all nve/sphere
timestep 1e-5
run 1
print "lines $(c_n) $(count(all)>2)"
END
says 'the lines to write instead' 'lines 0 1'
bad 'expected one of massrate, massratevariable, found none' 'fix r all remove nevery 5 style delete seed 3'
bad 'found both' 'variable q equal 1' 'fix r all remove nevery 5 massrate 1 massratevariable q style delete seed 3'
bad 'needs delete_below' 'fix r all remove nevery 5 massrate 1 style shrink seed 3'
bad 'with style shrink only' 'fix r all remove nevery 5 massrate 1 style delete delete_below 0.1 seed 3'
bad "unknown variable 'rat'" 'variable rate equal 1' 'fix r all remove nevery 5 massratevariable rat style delete seed 3'
bad 'the rate v_q is -1' 'variable q equal -1' 'fix r all remove nevery 5 massratevariable q style delete seed 3' 'run 5'
bad 'atomtype is 9' 'fix r all remove nevery 5 massrate 1 style delete seed 3 atomtype 9'
bad "there is no region 'nowhere'" 'fix r all remove nevery 5 massrate 1 style delete seed 3 region nowhere'
bad 'has no centre and radius' 'fix s all scale/diameter 5 region left scale 0.5'
bad 'has no centre and radius' 'region o sphere 0 0 0 0.5 side out units box' 'fix s all scale/diameter 5 region o scale 0.5'
bad 'the factor v_q is 0' 'variable q equal 0' 'region o sphere 0 0 0 0.5 units box' 'fix s all scale/diameter 5 region o scale v_q' 'run 1'
bad 'scale_width is 1.5' 'region o sphere 0 0 0 0.5 units box' 'fix s all scale/diameter 5 region o scale 2 scale_width 1.5'
bad 'there are no molecules' 'fix e all evaporate 5 4 left 49892 molecule yes'
bad 'expected c_ID' 'variable c internal 1' 'fix c all controller 5 1 1 1 1 ke 1 c'
bad 'a constant fix gravity' 'variable a equal step' 'fix g all gravity 9.81 chute v_a' 'region R block 0.2 0.8 0.2 0.8 0.2 0.8 units box' \
	'fix rain all pour 100 1 29494 region R vol 0.2 50 diam range 0.01 0.012 dens 2500 2500 vel 0 0 0 0 -1'
bad 'the direction of gravity is a variable' 'variable a equal step*0' 'fix g all gravity 9.81 chute v_a' \
	'fix b all buoyancy level 0 dim z density 1000' 'run 1'
bad 'the direction has no length' 'variable a equal 0' 'fix g all gravity 9.81 vector v_a v_a v_a'
bad "unknown variable 'b'" 'variable a equal 0' 'fix g all gravity 9.81 chute v_b'
bad 'expected a length > 0' 'fix l all nve/limit radius 0.1'
bad 'say `remap v`' 'fix d all deform 1 xy erate 0.1'
bad 'expected x, y, z, xy, xz or yz' 'fix d all deform 1 remap v'
bad 'there is one already, d' 'fix d all deform 1 x vel 1' 'fix e all deform 1 y vel 1'
bad 'the box would reach' 'fix d all deform 1 x delta 3 0' 'run 1'
bad "did you mean 'erate'" 'fix d all deform 1 x erat 1'
bad 'must not be after' 'run 10 start 5'
sed -i 's/boundary p p p/boundary p p m/' in.box
bad 'faces of z follow' 'fix d all deform 1 z vel 1'

# variables that have no value before the forces of the first step
cat >in.two <<'END'
units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.5 0.5 0.592 units box
set group all diameter 0.1 density 1000
pair_style spring/dashpot
pair_coeff * * stiffness 50 damping 0
fix n all nve
timestep 1e-3
END
agree 'ramp() in a force: over each run' 'include in.two
neigh_modify exclude type 1 1
variable r equal ramp(0,0.3)
fix a all addforce v_r 0 0
run 10
run 6
print "is v $(vx[1]:%.17g) $(1e-3*0.3*(10+6)/2/mass[1]:%.17g)"'
agree 'a force by the pressure of contacts' 'include in.two
compute p all pressure NULL pair
variable q equal c_p[3]
fix a all addforce 0 0 v_q
run 0
print "is q $(fz[1]+fz[2]:%.17g) $(2*v_q:%.17g)"
print "is p $(c_p[3]:%.17g) $(50*0.008*0.092:%.17g) 1"'
# fix adapt: the mass, which is a keyword, too. 0.1 s of a force of 3 on a mass of 2.
prints 'units si
boundary f f f
region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
set group all diameter 0.1 density 2500
variable m equal 2
fix a all adapt 1 atom mass v_m mass no
fix f all addforce 3 0 0
fix m all nve
timestep 1e-3
run 100
print "mass $(mass(all)), v $(vx[1]:%.3f)"' 'mass 2, v 0.150'

# fix drill/bit: the box is not periodic along z; dashpots alone have a limit of the time step, 2 m/c.
bit='region box block -1 1 -1 1 -1 1 units box
create_box 1 box
create_atoms 1 single 0.3 0 -0.80 units box
create_atoms 1 single 0 0.3 -0.81 units box
create_atoms 1 single -0.3 0 -0.82 units box
create_atoms 1 single 0 -0.3 -0.83 units box
set group all diameter 0.1 density 1000
timestep 1e-3'
rejects "units si
boundary f f p
$bit
fix bit all drill/bit 0 0 diameter 0.6 omega 5 wob 4 spring 20 damping 0.1
run 1" 'the box is periodic along z'
rejects "units si
boundary f f f
$bit
fix bit all drill/bit 0 0 diameter 0.6 omega 5 wob 4 spring 0 damping 2000
run 1" 'the time step 0.001 exceeds the stability limit 0.000523599'
finish
