#!/bin/bash
# Granular pair styles with their constants on the line: known answers, defaults, restart, threads, errors.
# The trajectories themselves: tests/crosscheck/lammps_granular.sh.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two free spheres of 0.0123 and 0.0231 meet head on. gran/hooke: half a period of a damped oscillator,
# e = exp(-pi c / sqrt(k/m* - c^2)), c = gamma_n / 2.
head_on() { # STYLE LINE, EXPECTED: a formula
	cat <<-END
		units si
		boundary f f f
		region box block -1 1 -1 1 -1 1 units box
		create_box 1 box
		create_atoms 1 single -0.0124 0 0 units box
		create_atoms 1 single 0.0232 0 0 units box
		set atom 1 diameter 0.0246 density 2385
		set atom 2 diameter 0.0462 density 1931
		group one id 1
		velocity one set 0.731 0 0
		pair_style $1
		pair_coeff * *
		fix move all nve/sphere
		timestep 1e-7
		run 30000
		variable pi equal 3.14159265358979323846
		variable ma equal 2385*4/3*v_pi*0.0123^3
		variable mb equal 1931*4/3*v_pi*0.0231^3
		variable mstar equal v_ma*v_mb/(v_ma+v_mb)
		variable got equal (vx[2]-vx[1])/0.731
		variable off equal abs(v_got-($2))
		if "\${off} < 2e-4" then "print 'as expected'" else "print '\${got} is off by \${off}'"
	END
}
w='exp(-v_pi*61.5/sqrt(2.3e5/v_mstar-61.5^2))'
prints "$(head_on 'gran/hooke 2.3e5 NULL 123 NULL 0.5 1' "$w")" 'as expected'
prints "$(head_on 'gran/hooke/history 2.3e5 1.7e5 123 31.5 0.5 0' "$w")" 'as expected'
prints "$(head_on 'gran/hertz/history 2.385e7 NULL 0 NULL 0.5 0' 1)" 'as expected'

# Many overlap at the start and fly apart.
cat >in.shower <<'END'
units		si
boundary	p p p
newton		off
comm_modify	vel yes
region		box block 0 0.2 0 0.2 0 0.2 units box
if "${from} == none" then "create_box 2 box" &
	"create_atoms 1 random 90 20233 box" &
	"set group all diameter 0.031 density 2385" &
	"set group all type/fraction 2 0.4 20233" &
	"velocity all set 0.3 0.1 -0.2" &
else "read_restart ${from}"
pair_style	${style}
pair_coeff	* *
fix		slow all viscous 0.01
fix		move all nve/sphere
timestep	2e-5
thermo_style	custom step atoms ke erotate fmax
thermo_modify	format float %.17g
thermo		100
run		${last} upto
write_restart	${out}.restart
END
shower() { # NAME LAST FROM STYLE [THREADS]
	"$TSIM" -in in.shower -log "$1.log" -screen none -threads "${5:-1}" -var out "$1" -var last "$2" \
		-var from "$3" -var style "$4" 2>err
	report "$1: $4" $? err
}
for style in 'gran/hooke 2.3e5 NULL 53 NULL 0.5 1' 'gran/hooke/history 2.3e5 NULL 53 NULL 0.5 1' \
	'gran/hertz/history 2.3e7 NULL 5300 NULL 0.5 1'; do
	shower whole 400 none "$style"
	shower a 137 none "$style"
	shower c 400 a.restart "$style"
	same "$style: cut in two" whole.restart c.restart
	shower generic 400 none "$style generic"
	rows whole.log >whole.rows
	rows generic.log >generic.rows
	same "$style: specialised loop and the loop for any law" whole.rows generic.rows
	shower two 400 none "$style" 2
	same "$style: two threads" whole.restart two.restart
done

start='region b block 0 1 0 1 0 1
create_box 1 b
'
rejects "${start}pair_style gran/hooke 1e5 NULL -1 NULL 0.5 1" 'gamma_n is -1, expected a number >= 0'
rejects "${start}pair_style gran/hooke 1e5 -2 1 NULL 0.5 1" 'kt is -2, expected a number >= 0'
rejects "${start}pair_style gran/hooke/history 1e5 NULL 1 NULL 0.5 2" 'dampflag is 2, expected a number from 0 to 1'
rejects "${start}pair_style gran/hooke/history 1e5 NULL 1 NULL 0.5" 'dampflag is missing'
rejects "${start}pair_style gran/hertz/history 1e5 NULL 1 NULL 0.5 1 limit_damp" "did you mean 'limit_damping'"
rejects "${start}create_atoms 1 single 0.5 0.5 0.5
pair_style gran/hooke 1e5 NULL 1 NULL 0.5 1
fix m all nve/sphere
run 1" 'there is no `pair_coeff 1 1'

# Immersed particles that touch at rest: restitution 0, and the elastic force alone.
agree 'viscous at rest' 'units si
atom_style granular
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.509 0.5 0.5 units box
set group all diameter 0.01 density 2500
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.7
fix m4 all property/global coefficientFriction peratomtypepair 1 0.3
fix m5 all property/global characteristicVelocity scalar 1
fix m6 all property/global FluidViscosity peratomtypepair 1 1
fix m7 all property/global CriticalStokes peratomtypepair 1 10
fix m8 all property/global MaximumRestitution peratomtypepair 1 0.9
fix go all nve/sphere
timestep 1e-6
pair_style gran model hooke tangential history viscous on
pair_coeff * *
run 0
variable f equal fx[2]
variable wet equal ${f}
pair_style gran model hooke tangential history
pair_coeff * *
run 0
print "is force ${wet} $(fx[2])"
pair_style gran model hooke tangential history viscous on
pair_coeff * *
run 20
print "is finite $(ke>0) 1"'
finish
