#!/bin/bash
# Volumes that one impact removes, by each law of erosion, against its formula; and input that makes no sense.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A sphere of 1 mm without gravity, damping and friction falls on a plane; volumes are those of src/law/erosion_*.h.
cat >in.hit <<'END'
units ${units}
variable L equal 0.01*v_length
region b block -$L $L -$L $L -$L $L units box
create_box 2 b
neighbor $(0.001*v_length) bin
fix y all property/global youngsModulus peratomtype $(7e10*v_pressure) $(2e11*v_pressure)
fix n all property/global poissonsRatio peratomtype 0.2 0.3
fix e all property/global coefficientRestitution peratomtypepair 2 1 1 1 1
fix f all property/global coefficientFriction peratomtypepair 2 0 0 0 0
pair_style gran model hertz tangential off
pair_coeff * *
hard_particles yes
fix floor all wall/gran model hertz tangential off primitive type 2 zplane 0
create_atoms 1 single 0 0 $(0.000501*v_length) units box
set group all diameter $(0.001*v_length) density $(2500*v_mass/v_length^3)
velocity all set $(v_t*v_velocity) 0 $(-v_n*v_velocity) units box
fix move all nve/sphere
timestep $(2e-9*v_time)
include in.wear
run 2000
print "back $(vz[1]/v_velocity:%.9g)"
print "volume $(f_scar/v_length^3:%.12g)"
END
m=$(awk 'BEGIN { printf "%.17g", 2500 * 4 * atan2(1, 1) / 6 * 1e-9 }')

# hit N T [UNITS]: sets `volume` to what this impact removes by the lines of in.wear
hit() {
	local unit=('' si -var length 1 -var mass 1 -var time 1 -var pressure 1 -var velocity 1)

	[ "${3-si}" = cgs ] && unit=('' cgs -var length 100 -var mass 1000 -var time 1 -var pressure 10 -var velocity 100)
	[ "${3-si}" = micro ] && unit=('' micro -var length 1e6 -var mass 1e15 -var time 1e6 -var pressure 1e-3 -var velocity 1)
	"$TSIM" -in in.hit -log none -var n "$1" -var t "$2" -var units "${unit[@]:1}" >out 2>&1
	grep -q '^back [0-9]' out || report "$1 $2: comes back" 1 out
	volume=$(sed -n 's/^volume //p' out)
}

# law WHAT N T FORMULA [UNITS]: the impact at the normal and tangential speed N and T removes the volume of the formula in m, n, t
law() {
	hit "$2" "$3" "${5-si}"
	awk -v v="$volume" -v m="$m" -v n="$2" -v t="$3" -v law="$4" "
		function asin(x) { return atan2(x, sqrt(1 - x * x)) }
		function max(x, y) { return x > y ? x : y }
		BEGIN { pi = 4 * atan2(1, 1); s = n / sqrt(n * n + t * t); w = $4
			printf \"removed %.12g, by the formula %.12g\\n\", v, w
			d = v - w; exit !(v > 0 && d * d <= (1e-9 * w) ^ 2) }" >compared
	report "$1, n = $2, t = $3 ${5-}" $? compared
}

# Oka: E90 in mm^3/kg, hardness in GPa; the impact at 104 m/s would need a shorter step, 20 m/s is as good
oka() { # K k1 k2 k3 n1 n2 V D HV
	echo "1e-9 * m * $1 * $9 ^ $2 * (sqrt(n * n + t * t) / $7) ^ $3 * (1000 / $8) ^ $4 * s ^ $5 * (1 + $9 * (1 - s)) ^ $6"
}
for unit in si cgs micro; do
	echo 'fix scar all wear/oka surface floor particles sio2 hardness $(1.12e9*v_pressure)' >in.wear
	law 'oka, sio2' 20 20 "$(oka 65 -0.12 '(2.3 * 1.12 ^ 0.038)' 0.19 '(0.71 * 1.12 ^ 0.14)' '(2.4 * 1.12 ^ -0.94)' 104 326 1.12)" $unit
done
echo 'fix scar all wear/oka surface floor particles sic hardness 2.7e9' >in.wear
law 'oka, sic' 20 0 "$(oka 45 -0.05 '(3 * 2.7 ^ 0.085)' 0.19 1 1 99 326 2.7)"
echo 'fix scar all wear/oka surface floor particles glass hardness 2.7e9 factor 0.25' >in.wear
law 'oka, glass' 20 35 "0.25 * $(oka 27 -0.16 2.1 0.19 '(2.8 * 2.7 ^ 0.41)' '(2.6 * 2.7 ^ -1.46)' 100 200 2.7)"
echo 'fix scar all wear/oka surface floor particles sio2 hardness 1e9 relaxation 1000' >in.wear
law 'oka, relaxation' 20 0 '1e-9 * m * 65 * 1000 ^ 0.12 * (20 / 104) ^ 2.3 * (1000 / 326) ^ 0.19'
printf '%s\n' 'fix h all property/global hardness peratomtype 9e9 1e9' 'fix scar all wear/oka surface floor particles sio2' >in.wear
law 'oka, property' 20 0 '1e-9 * m * 65 * (20 / 104) ^ 2.3 * (1000 / 326) ^ 0.19'

echo 'fix scar all wear/bitter surface floor deformation 3.1e10 cutting 1.3e10 threshold 0.65 cutting_constant 2.3e-11 elastic_constant 0.013' >in.wear
x='(2.3e-11 * (n - 0.65) ^ 2 / sqrt(n))'
law 'bitter, leaves' 20 60 "m * (n - 0.65) ^ 2 / (2 * 3.1e10) + 2 * m * $x * (t - $x * 1.3e10)"
law 'bitter, stops' 20 20 'm * (n - 0.65) ^ 2 / (2 * 3.1e10) + m * (t * t - 0.013 * (n - 0.65) ^ 1.5) / (2 * 1.3e10)'
law 'bitter, normal' 20 0 'm * (n - 0.65) ^ 2 / (2 * 3.1e10)'
modulus=$(awk 'BEGIN { printf "%.17g", 1 / ((1 - 0.04) / 7e10 + (1 - 0.09) / 2e11) }')
echo 'fix scar all wear/bitter surface floor deformation 3.1e10 cutting 1.3e10 yield 1.2e9' >in.wear
k="(pi * pi / (2 * sqrt(10)) * 1.2e9 ^ 2.5 / (sqrt(2500) * $modulus ^ 2))"
x="(0.288 / 1.2e9 * (2500 / 1.2e9) ^ 0.25 * (n - $k) ^ 2 / sqrt(n))"
law 'bitter, yield' 20 90 "m * (n - $k) ^ 2 / (2 * 3.1e10) + 2 * m * $x * (t - $x * 1.3e10)"

echo 'fix scar all wear/neilson/gilchrist surface floor cutting 1.3e10 deformation 3.1e10 threshold 4.7 transition 24' >in.wear
law 'neilson, grazing' 5 30 'm * t * t * sin(90 / 24 * asin(s)) / (2 * 1.3e10) + m * (n - 4.7) ^ 2 / (2 * 3.1e10)'
law 'neilson, steep' 20 20 'm * t * t / (2 * 1.3e10) + m * (n - 4.7) ^ 2 / (2 * 3.1e10)'
law 'neilson, slow' 4 4 'm * t * t / (2 * 1.3e10)'

echo 'fix scar all wear/zhao/chang surface floor hardness 1e12 crater 0' >in.wear
groove="2 * sqrt(2) * m * n * t / $modulus"
law 'zhao/chang, elastic' 20 35 "$groove"
echo 'fix scar all wear/zhao/chang surface floor hardness 1e12 modulus 3e10 crater 0.3 factor 2' >in.wear
law 'zhao/chang, crater' 20 35 '2 * (2 * sqrt(2) * m * n * t / 3e10 + 0.3 * m * n * n / 2e12)'
law 'zhao/chang, normal' 20 0 '2 * 0.3 * m * n * n / 2e12'
echo 'fix scar all wear/zhao/chang surface floor hardness 2.7e9 crater 0.3 yield 1.2e9' >in.wear
law 'zhao/chang, yield' 20 0 "0.3 * m * (n * n - $k ^ 2) / 5.4e9"
echo 'fix scar all wear/zhao/chang surface floor hardness 2.7e9 crater 0 force plastic' >in.wear
law 'zhao/chang, plastic' 20 35 \
	'0.87401918476403993682 * 4 / 3 * sqrt(0.001) * (n * sqrt(m / (pi * 0.001 * 2.7e9))) ^ 1.5 * t * sqrt(m / (pi * 0.001 * 2.7e9))'

cat >in.wear <<'END'
variable v internal 0
variable a internal 0
variable d internal 0
variable m internal 0
variable p internal 0
variable q internal 0
variable h internal 0
variable lost equal 1e-12*v_m/v_d*v_v^2.4*sin(v_a*PI/180)+1e-15*v_p*v_q^2/v_h
fix scar all wear/formula surface floor volume v_lost hardness 3 set speed v set angle a set mass m set diameter d &
	set normal p set tangential q set hardness h
END
law 'formula' 20 35 '1e-12 * m / 0.001 * (n * n + t * t) ^ 1.2 * s + 1e-15 * n * t * t / 3'
echo 'fix scar all wear/formula surface floor volume 3.5e-12' >in.wear
law 'formula, number' 20 35 '3.5e-12'

# the groove of the resolved contact goes to that of the impact as the step goes to 0
for section in limit segment; do
	echo "fix scar all wear/zhao/chang surface floor hardness 2.7e9 crater 0 section $section" >in.wear
	hit 20 35
	impact=$volume
	echo "fix scar all wear/zhao/chang/contact surface floor hardness 2.7e9 crater 0 section $section" >in.wear
	hit 20 35
	awk -v a="$volume" -v b="$impact" 'BEGIN { print a, b; d = a / b - 1; exit !(d * d < 1e-4 ^ 2) }' >compared
	report "zhao/chang, resolved contact, $section" $? compared
done
echo 'fix scar all wear/zhao/chang/contact surface floor hardness 2.7e9 crater 0.3' >in.wear
law 'zhao/chang, resolved normal contact: the crater' 20 0 '0.3 * m * n * n / 5.4e9'

# wrong WHAT MESSAGE LINE...: the lines of wear are refused
wrong() {
	local what=$1 text=$2
	shift 2
	printf '%s\n' "$@" >in.wear
	refused "$what" "$text" -in in.hit -var n 20 -var t 20 -var units "${units-si}" -var length 1 -var mass 1 -var time 1 \
		-var pressure 1 -var velocity 1
}
wrong 'no hardness' 'needs `fix ID all property/global hardness peratomtype' 'fix scar all wear/oka surface floor particles sio2'
wrong 'hardness of 0' 'hardness' 'fix scar all wear/oka surface floor particles sio2 hardness 0'
wrong 'negative hardness' 'the hardness of the surface is -1' 'fix h all property/global hardness peratomtype 1 -1' \
	'fix scar all wear/zhao/chang surface floor'
wrong 'unknown particles' "sio2, sic, glass" 'fix scar all wear/oka surface floor particles sand hardness 1e9'
wrong 'no cutting constant' 'the cutting constant is missing' 'fix scar all wear/bitter surface floor deformation 1 cutting 1'
wrong 'angle of 0' 'the transition angle is 0' \
	'fix scar all wear/neilson/gilchrist surface floor deformation 1 cutting 1 transition 0'
wrong 'negative angle' 'transition' \
	'fix scar all wear/neilson/gilchrist surface floor deformation 1 cutting 1 transition -3'
wrong 'negative volume' 'the volume is -1' 'variable w equal -1' 'fix scar all wear/formula surface floor volume v_w'
wrong 'volume not finite' 'is too large for a number' 'variable a internal 0' 'variable w equal 1e300*v_a*1e300' \
	'fix scar all wear/formula surface floor volume v_w set angle a'
wrong 'unknown quantity' 'speed' 'variable a internal 0' 'fix scar all wear/formula surface floor volume 1 set sped a'
wrong 'no variable' 'nothing' 'fix scar all wear/formula surface floor volume 1 set speed nothing'
wrong 'a variable that is not internal' "'a' is of style equal; one of style internal" 'variable a equal 1' \
	'fix scar all wear/formula surface floor volume 1 set speed a'
wrong 'a quantity twice' "variable 'a' gets this quantity already" 'variable a internal 0' 'variable b internal 0' \
	'fix scar all wear/formula surface floor volume 1 set speed a set angle b set speed b'
# before the first impact, as -check does
printf '%s\n' 'fix scar all wear/formula surface floor volume 1 set speed nothing' >in.wear
refused 'no variable, -check' "unknown variable 'nothing'" -check -in in.hit -var n 20 -var t 20 -var units si -var length 1 \
	-var mass 1 -var time 1 -var pressure 1 -var velocity 1
units=lj wrong 'no SI units' 'units lj have no equivalent' 'fix scar all wear/oka surface floor particles sio2 hardness 1'
finish
