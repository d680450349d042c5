#!/bin/bash
# Heat between particles: closed forms of one step, names of the numbers, cuts by restart files, threads,
# warnings, and what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# Two spheres, h = 4 k k'/(k + k') sqrt(A).
cat >in.material <<'END'
fix k all property/global thermalConductivity peratomtype 43 17
fix c all property/global thermalCapacity peratomtype 490 800
END
cat >in.two <<'END'
units si
region box block -1 1 -1 1 -1 1 units box
create_box 2 box
neighbor 0.01 bin
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.19 0.03 0 units box
set type 1 diameter 0.2 density 2470
set type 2 diameter 0.23 density 1830
include in.material
timestep 0.01
variable m1 equal 2470*PI*0.2^3/6
variable m2 equal 1830*PI*0.23^3/6
variable r equal sqrt(0.19^2+0.03^2)
variable lens equal -PI/4*(v_r-0.215)*(v_r-0.015)*(v_r+0.015)*(v_r+0.215)/v_r^2
variable kk equal 4*43*17/60
END
cat >in.measure <<'END'
compute T all reduce max f_Temp
compute t all reduce min f_Temp[0]
END

# area WORDS FORMULA
area() {
	agree "contact_area $1" "include in.two
fix heat all heat/gran initial_temperature 273.15 contact_area $1
include in.measure
set atom 1 property/atom Temp 773.15
set atom 2 property/atom heatSource 11.3
run 1
variable q equal v_kk*sqrt($2)*500
print \"is T \$(c_T:%.17g) \$(773.15-0.01*v_q/v_m1/490:%.17g)\"
print \"is t \$(c_t:%.17g) \$(273.15+0.01*(v_q+11.3)/v_m2/800:%.17g)\"
print \"is heat \$(f_heat/1e5:%.17g) \$((v_m1*490*773.15+v_m2*800*273.15+0.01*11.3)/1e5:%.17g)\"
compute q all reduce sum f_heatFlux f_directionalHeatFlux[1] f_directionalHeatFlux[2] f_heatSource
print \"is q[1] \$(c_q[1]:%.17g) 0\"
print \"is q[2] \$(c_q[2]:%.17g) \$(v_q*0.19:%.17g)\"
print \"is q[3] \$(c_q[3]:%.17g) \$(v_q*0.03:%.17g)\"
print \"is q[4] \$(c_q[4]:%.17g) 11.3\""
}
area overlap v_lens
area 'constant 0.02385' 0.02385
area projection 'PI*0.115^2'
agree 'one inside the other' 'include in.two
set atom 2 x 0.05 y 0 diameter 0.11
fix heat all heat/gran initial_temperature 273.15
include in.measure
set atom 1 property/atom Temp 773.15
run 1
compute q all reduce max f_heatFlux
print "is q $(c_q:%.17g) $(v_kk*sqrt(PI*0.055^2)*500:%.17g)"'
agree 'area_correction: a linear spring where there is no pair style' 'include in.two
fix y all property/global youngsModulus peratomtype 1e7 2e7
fix y0 all property/global youngsModulusOriginal peratomtype 1e9 1e9
fix nu all property/global poissonsRatio peratomtype 0.3 0.2
fix heat all heat/gran initial_temperature 273.15 area_correction yes
include in.measure
set atom 1 property/atom Temp 773.15
variable y equal 1/(0.91/1e7+0.96/2e7)*(0.91+0.96)/1e9
variable r equal 0.215-v_y*(0.215-sqrt(0.19^2+0.03^2))
run 1
compute q all reduce max f_heatFlux
print "is q $(c_q/1e3:%.17g) $(v_kk*sqrt(v_lens)/2:%.17g)"'
for correction in yes no legacy; do
	agree "area_correction $correction at a wall" "legacy $([[ $correction = legacy ]] && echo yes || echo no)"'
include in.two
set atom 2 z 0.5 type 1
fix y all property/global youngsModulus peratomtype 1e7 2e7
fix y0 all property/global youngsModulusOriginal peratomtype 1e9 1e9
fix nu all property/global poissonsRatio peratomtype 0.3 0.2
fix e all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
fix hold all freeze
fix w all wall/gran model hertz primitive type 2 zplane -0.093 temperature 500
fix heat all heat/gran initial_temperature 273.15 area_correction '${correction/legacy/yes}' store_contact_data yes
variable y equal 1/(0.91/1e7+0.96/2e7)*(0.91+0.96)/1e9
variable factor string '"$([[ $correction = yes ]] && echo "(v_y^(2/3))" || echo 1)"'
variable d equal 0.1-${factor}*0.007
run 1
compute q all reduce max f_wallHeatFlux
print "is q $(c_q/1e3:%.17g) $(v_kk*sqrt(PI*(0.01-v_d^2))*(500-273.15)/1e3:%.17g)"'
done
agree 'data of contacts; particles outside the group keep their temperature' 'include in.two
group first id 1
create_atoms 1 single -0.5 0 0 units box
set atom 3 diameter 0.1 density 1000
fix heat first heat/gran/conduction initial_temperature 300 store_contact_data yes
include in.measure
set atom 1 property/atom Temp 400
run 3
compute s all reduce sum f_nContactsConduction f_contactAreaConduction f_wallHeatFlux
print "is s[1] $(c_s[1]) 2"
print "is s[2] $(c_s[2]:%.17g) $(2*v_lens:%.17g)"
print "is s[3] $(c_s[3]) 0"
print "is t $(c_t) 300"
print "is T $(c_T<400) 1"
print "is one $(f_Temp[1]:%.17g) $(c_T:%.17g)"
print "is three $(f_Temp[3]) 300"'
agree 'frozen spheres conduct, late ones start with the initial temperature' 'include in.two
fix hold all freeze
fix heat all heat/gran initial_temperature 300
include in.measure
set atom 1 property/atom Temp 400
run 1
create_atoms 1 single -0.5 0 0 units box
print "is T $(c_T<400) 1"
print "is t $(c_t) 300"'
agree 'the temperature of the user comes first' 'include in.two
fix mine all property/atom Temp scalar yes yes no 333
fix heat all heat/gran initial_temperature 300
include in.measure
print "is T $(c_T) 333"
print "is t $(c_t) 333"'
agree 'the temperatures of an earlier fix stay' 'include in.two
fix heat all heat/gran initial_temperature 300
set atom 1 property/atom Temp 400
unfix heat
fix heat all heat/gran initial_temperature 350
include in.measure
print "is T $(c_T) 400"
print "is t $(c_t) 300"
create_atoms 1 single -0.5 0 0 units box
variable late atom "(id==3)*f_Temp"
compute late all reduce max v_late
print "is late $(c_late) 350"'

# periodic SCHEME FORMULA: of the hot one's part of the difference
periodic() {
	agree "across a periodic face, $1" "units si
boundary p p p
region box block 0 1 0 1 0 1 units box
create_box 1 box
create_atoms 1 single 0.05 0.5 0.5 units box
create_atoms 1 single 0.87 0.5 0.5 units box
set type 1 diameter 0.2 density 2470
include in.material
fix heat all heat/gran initial_temperature 300 scheme $1
include in.measure
set atom 1 property/atom Temp 400
compute q all reduce sum f_directionalHeatFlux[1]
timestep 1
run 1
variable h equal 86*sqrt(PI*(0.1^2-0.09^2))
variable m equal 2470*PI*0.2^3/6
print \"is q \$(c_q:%.17g) \$(-v_h*100*0.18:%.17g)\"
print \"is T \$(c_T:%.17g) \$($2:%.17g)\""
}
periodic euler '400-100*v_h/v_m/490'
periodic exact '350+50*exp(-2*v_h/v_m/490)'

# sum of heats mean, difference d: dd/dt = S/(m c) - (h/c*) d
agree 'exact: a source' 'include in.two
fix heat all heat/gran initial_temperature 300 scheme exact
include in.measure
set atom 1 property/atom heatSource 2385
timestep 1000
run 2
variable c1 equal v_m1*490
variable c2 equal v_m2*800
variable rate equal v_kk*sqrt(v_lens)*(1/v_c1+1/v_c2)
variable d equal 2385/v_c1/v_rate*(1-exp(-v_rate*2000))
variable mean equal 300+2385*2000/(v_c1+v_c2)
print "is T $(c_T:%.17g) $(v_mean+v_d*v_c2/(v_c1+v_c2):%.17g)"
print "is t $(c_t:%.17g) $(v_mean-v_d*v_c1/(v_c1+v_c2):%.17g)"'

# the limit: a warning beyond it before the run or when contacts form, the end where temperatures grow
# without bound
cat >in.limit <<'END'
include in.two
variable limit equal v_m1*490/(v_kk*sqrt(v_lens))
fix heat all heat/gran initial_temperature 300
set atom 1 property/atom Temp 400
timestep $(v_factor*v_limit)
END
prints 'variable factor equal 1.01
include in.limit
run 2' '*the time step' '*exceeds' '*explicit heat conduction, m c / sum h'
prints 'variable factor equal 1.01
include in.limit
neighbor 1e-5 bin
set atom 2 x 0.216 y 0 vx $(-0.001/dt)
fix move all nve
run 30' '*the time step' '*the limit of explicit heat conduction (m c / sum h)'
echo 'variable factor equal 2.1
include in.limit
run 5000' >in.script
refused 'beyond twice the limit' 'use a smaller one, a smaller thermalConductivity or `scheme exact`' \
	-in in.script
echo 'variable factor equal 0.99
include in.limit
run 5' >in.script
"$TSIM" -in in.script -log none >out 2>&1 && ! grep -qE 'larger|exceeds' out
report 'no warning below the limit' $? out

rejects 'include in.two
fix heat all heat/gran initial_temperature 300 contact_area lens' "contact_area is 'lens', expected overlap"
rejects 'include in.two
fix heat all heat/gran initial_temperature 300 contact_area constant' 'constant takes one number'
rejects 'include in.two
fix heat all heat/gran initial_temperature 300 contact_area constant -1' 'expected an area > 0'
rejects 'include in.two
fix heat all heat/gran initial_temperature 300 contact_area projection area_correction yes' \
	'area_correction is for contact_area overlap'
rejects 'include in.two
fix heat all heat/gran initial_temperature 300
fix again all heat/gran initial_temperature 300' 'particles have one temperature'
rejects 'include in.two
unfix k
fix heat all heat/gran initial_temperature 300
run 1' 'fix heat/gran needs `fix ID all property/global thermalConductivity'
rejects 'include in.two
fix c all property/global thermalCapacity peratomtype 490 0
fix heat all heat/gran initial_temperature 300
run 1' 'thermalCapacity must be > 0'
rejects 'include in.two
fix k all property/global thermalConductivity peratomtype 490 -1
fix heat all heat/gran initial_temperature 300
run 1' 'thermalConductivity must be >= 0'
rejects 'include in.two
fix heat all heat/gran initial_temperature 300
print "$(f_Temp)"' 'has a value for each particle'

# cut by a restart file, and threads
cat >in.grains <<'END'
units si
boundary p p p
newton off
communicate single vel yes
region box block 0 1 0 1.2 0 0.9 units box
create_box 2 box
create_atoms 1 random 200 86028157 NULL overlap 0.08
create_atoms 2 random 200 49979687 NULL overlap 0.08
set type 1 diameter 0.1365 density 2470
set type 2 diameter 0.1285 density 1830
velocity all create 1e21 67867967
END
cat >in.rest <<'END'
include in.material
fix k all property/global thermalConductivity peratomtype 43000 17000
pair_style spring/dashpot
pair_coeff * * stiffness 20000 restitution 0.7
group held id 3 7 9
group free subtract all held
fix n free nve/sphere
fix hold held freeze
fix heat free heat/gran initial_temperature 300 scheme ${scheme} store_contact_data yes
timestep 1e-5
package omp ${threads} grain 20
dump d all custom 10 ${out}.dump id x f_Temp f_heatFlux f_directionalHeatFlux[2] nContactsConduction
dump_modify d sort id format float %.17g append yes
END
cat >in.heat <<'END'
set type 1 property/atom Temp 400
set atom 5 property/atom heatSource 2.385
END
# scripted NAME SCHEME THREADS OUT LINES...
scripted() {
	local name=$1 scheme=$2 threads=$3 out=$4
	shift 4
	printf '%s\n' "$@" >in.script
	"$TSIM" -in in.script -log none -var scheme "$scheme" -var threads "$threads" -var out "$out" \
		>out 2>&1
	report "$scheme, $name" $? out
}
for scheme in euler exact; do
	rm -f ./*.dump
	for threads in 1 2; do
		scripted "$threads threads" $scheme $threads whole$threads 'include in.grains' \
			'include in.rest' 'include in.heat' 'run 60' 'write_restart ${out}.restart'
	done
	scripted 'first part' $scheme 1 parts 'include in.grains' 'include in.rest' 'include in.heat' \
		'run 23' 'write_restart cut.restart'
	scripted 'second part' $scheme 1 parts 'read_restart cut.restart' 'include in.rest' 'run 37' \
		'write_restart ${out}.restart'
	same "$scheme: dump, cut" whole1.dump parts.dump
	same "$scheme: state, cut" whole1.restart parts.restart
	same "$scheme: dump, threads" whole1.dump whole2.dump
	awk '$3 > 300 && $3 < 400 { n++ } END { exit n < 100 }' whole1.dump
	report "$scheme: heat has spread" $?
done
# The exponent of area_correction is that of the law of the contact: 1.5 of hertz, 1 of hooke; of the wall, or of the types.
warm='units si
boundary f f f
region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 2 box
neighbor 0.002 bin
fix m1 all property/global youngsModulus peratomtype 5e6 6e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.25
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.6 .5 .5 .7
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 .3 .3 .2
fix m5 all property/global thermalConductivity peratomtype 43 17
fix m6 all property/global thermalCapacity peratomtype 490 800
fix m7 all property/global youngsModulusOriginal peratomtype 5e9 6e9
fix m8 all property/global characteristicVelocity scalar 1
timestep 1e-9'
ratio='1/((1-0.09)/5e6+(1-0.0625)/6e6)*((1-0.09)/5e9+(1-0.0625)/6e9)'
# corrected WALL PAIR EXPONENT
corrected() {
	prints "$warm
create_atoms 1 single 0 0 0.0045 units box
set group all diameter 0.01 density 2500
$2
fix heat all heat/gran initial_temperature 300 area_correction yes
fix w all wall/gran model $1 primitive type 2 zplane 0 temperature 500
fix move all nve/sphere
run 1
variable d equal 0.005-0.0005*($ratio)^(1/$3)
print \"heat \$(f_heatFlux[1]/(4*43*17/60*200*sqrt(PI*(0.005^2-v_d^2))):%.4f)\"" 'heat 1.0000'
}
corrected hooke 'pair_style gran model hertz
pair_coeff * *' 1
corrected hertz 'pair_style gran model hooke
pair_coeff * *' 1.5
corrected hertz '' 1.5
# mixed LAW OTHERS EXPONENT
mixed() {
	prints "$warm
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.0095 0 0 units box
set group all diameter 0.01 density 2500
pair_style granular
pair_coeff 1 1 $2 1e6 1 tangential linear_nohistory 0 0
pair_coeff 2 2 $2 1e6 1 tangential linear_nohistory 0 0
pair_coeff 1 2 $1 1e6 1 tangential linear_nohistory 0 0
fix heat all heat/gran initial_temperature 300 area_correction yes
fix move all nve/sphere
set atom 1 property/atom Temp 400
run 1
variable d equal 0.01-0.0005*($ratio)^(1/$3)
print \"heat \$(f_heatFlux[2]/(4*43*17/60*100*sqrt(PI*(0.005^2-v_d^2/4))):%.4f)\"" 'heat 1.0000'
}
mixed hooke hertz 1
mixed hertz hooke 1.5

# Heat to a fluid is not one to walls.
prints "$warm
create_atoms 1 single 0.012 0.013 0.011 units box
set group all diameter 0.01 density 2500
fix heat all heat/gran initial_temperature 400 store_contact_data yes
flow_style projection cells 8 8 8 viscosity 1.8e-5 density 1.2
fix T all flow/scalar conductivity 0.026 capacity 1005 initial 300 exchange ranz_marshall
fix f all freeze
fix move all nve/sphere
run 2
print \"\$(round(1e4*f_heatFlux[1]/(PI*0.01*2*0.026*100))/1e4) to the fluid, \$(f_wallHeatFlux[1]) to walls\"" '-1 to the fluid, 0 to walls'

# The exchange is explicit in the fluid, too: its limit is rho c V/(pi d k Nu) of the cell of the sphere, with Nu = 2, over `every`.
exchange() { # N, and the step as a fraction of the limit
	echo "$warm
create_atoms 1 single 0.05 0.05 0.05 units box
set group all diameter 0.01 density 1e9
fix heat all heat/gran initial_temperature 400
flow_style projection cells 2 2 2 viscosity 1.8e-5 density 1.2 substeps 1 every $1
fix T all flow/scalar conductivity 0.026 capacity 0.1 initial 300 exchange ranz_marshall
fix move all nve/sphere
timestep \$($2*1.2*0.1*vol/8/(PI*0.01*0.026*2)/$1)
run 0
print \"run\""
}
explicit='recommended limit [0-9.e-]* of explicit heat exchange of fix flow/scalar'
for every in 1 3; do
	prints "$(exchange $every 0.999)" run
	grep -q "$explicit" out
	report "heat exchange below its limit, every $every" $((!$?)) out
	prints "$(exchange $every 1.001)" run
	grep -q "$explicit" out
	report "heat exchange beyond its limit, every $every" $? out
done

# Scheme exact has the flows of the state at the start of a run, too.
prints "$warm
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.0095 0 0 units box
set group all diameter 0.01 density 2500
pair_style gran model hertz tangential history
pair_coeff * *
fix heat all heat/gran initial_temperature 300 scheme exact
fix move all nve/sphere
set atom 1 property/atom Temp 400
compute c all pair/gran/local heatFlux
compute s all reduce sum c_c
thermo_style custom step c_s
run 0
print \"heat \$(abs(c_s)/(4*43*17/60*100*sqrt(PI*(0.005^2-0.00475^2))):%.6f)\"" 'heat 1.000000'
finish
