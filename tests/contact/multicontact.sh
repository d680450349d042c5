#!/bin/bash
# Contacts of one grain that act on each other: surface multicontact with fix multicontact/halfspace, against the
# formula, itself (planes and meshes, periodic faces, restarts, threads) and LIGGGHTS 3.8; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"

box() { # BOUNDARY: half a box of 0.06
	echo "atom_style sphere
atom_modify map array
boundary $1
newton off
communicate single vel yes
units si
region reg block -0.03 0.03 -0.03 0.03 -0.03 0.03 units box
create_box 2 reg"
}
surface='surface multicontact'
fix='fix mc all multicontact/halfspace geometric_prefactor 1.25'
scene() { # BOUNDARY RESTITUTION PLACE...: grains of radius 5 mm that rest there
	local boundary=$1 e=$2 place
	shift 2
	box "$boundary"
	for place; do echo "create_atoms 1 single $place units box"; done
	echo "set group all density 1000 diameter 0.01
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 $e $e $e $e
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history $surface
pair_coeff * *
$fix
timestep 1e-6"
}
# the force F of a contact whose surface others displace by s(F): F = 4/3 Y* sqrt(R*) (delta + s)^(3/2), R* with s
formula='variable y equal 5e6/(2*(1-0.3^2))
variable c equal 1.25*(1+0.3)/(2*PI*5e6)
variable off equal abs(v_found/v_f-1)<2e-12'
# along one line the other contact is straight below, e.u = 1: s = c F (3 - 2 nu)/d
opposite='-1-(3-4*0.3)+(1-2*0.3)'
# at right angles u = (1, 1)/sqrt(2) from it
square='-0.5+(1-2*0.3)*(1/sqrt(2))/(1+1/sqrt(2))'

for shape in plane mesh; do
	if [ "$shape" = plane ]; then
		walls="fix w1 all wall/gran model hertz tangential history $surface primitive type 2 zplane -0.0048
fix w2 all wall/gran model hertz tangential history $surface primitive type 2 zplane 0.0048"
	else
		plate 2 -0.0048 >below.stl
		plate 2 0.0048 >above.stl
		walls="fix p1 all mesh/surface file $work/below.stl type 2 scale 1.0
fix p2 all mesh/surface file $work/above.stl type 2 scale 1.0
fix w1 all wall/gran model hertz tangential history $surface mesh n_meshes 1 meshes p1
fix w2 all wall/gran model hertz tangential history $surface mesh n_meshes 1 meshes p2"
	fi
	script="$(scene 'f f f' 1 '0 0 0' | sed 's/-0.03 0.03/-0.6 0.6/g')
$walls
run 60
variable found equal f_w2[3]
$formula
variable s equal -v_c*v_f*($opposite)/0.0096
variable f equal 4/3*v_y*sqrt(0.005)*2e-4^1.5
print \"is more \$(v_found/v_f>1.05) 1\"
label again
variable n loop 80
variable f equal \$(4/3*v_y*sqrt(0.005+v_s)*(2e-4+v_s)^1.5)
next n
jump SELF again
print \"is off \${off} 1\""
	agree "a grain between two of $shape" "$script"
done

agree 'three grains at right angles, and in a row' "$(scene 'f f f' 1 '0 0 0' '0.0098 0 0' '0 0.0098 0')
run 60
variable found equal fx[2]
$formula
variable s equal -v_c*v_f*($square)/(0.0049*sqrt(2))
variable f equal 4/3*v_y*sqrt(0.0025)*2e-4^1.5
label again
variable n loop 80
variable f equal \$(4/3*v_y*sqrt(0.005*(0.005+v_s)/(0.01+v_s))*(2e-4+v_s)^1.5)
next n
jump SELF again
print \"is off \${off} 1\"
print \"is alike \$(fy[3]) \$(fx[2])\"
set atom 3 x -0.0098 y 0
run 60
variable m loop 80
variable s equal -v_c*v_f*($opposite)/0.0098
label more
variable f equal \$(4/3*v_y*sqrt(0.005*(0.005+v_s)/(0.01+v_s))*(2e-4+v_s)^1.5)
next m
jump SELF more
print \"is off \${off} 1\"
print \"is alike \$(-fx[3]) \$(fx[2])\""

# the surface that stands out is met where the spheres do not touch
agree 'before the spheres touch' "$(scene 'f f f' 1 '0 0 0' '0.0098 0 0' '-0.0098 0 0' '0 0.010001 0' '0 0 0.01001')
run 60
print \"is met \$(fy[4]>0) 1\"
print \"is apart \$(fz[5]) 0\"
print \"is opposite \$(fy[1]+fy[4]) 0\""

agree 'across a periodic face' "$(scene 'p f f' 1 '0 0 0' '0.0098 0 0' '-0.0098 0 0' '0.0295 0.02 0' '-0.0207 0.02 0' '0.0197 0.02 0')
run 60
print \"is same \$(fx[2]-fx[5]<1e-10&&fx[2]-fx[5]>-1e-10) 1\"
print \"is same \$(fx[3]-fx[6]<1e-10&&fx[3]-fx[6]>-1e-10) 1\""

# two grains alone collide as without it
table='thermo_style custom step ke erotate
thermo_modify format float %.15g
thermo 100
velocity all set 0 0 0
set atom 2 vx -0.3 vy 0.1
fix move all nve/sphere
run 1000'
printf '%s\n' "$(scene 'f f f' 0.7 '0 0 0' '0.01001 0.002 0')" "$table" >in.with
printf '%s\n' "$(surface='' fix='' scene 'f f f' 0.7 '0 0 0' '0.01001 0.002 0')" "$table" >in.without
for which in with without; do
	"$TSIM" -in in.$which -log none >out.$which 2>&1
	rows out.$which >table.$which
done
same 'two grains alone' table.with table.without

# a heap that is pressed between walls: any number of threads, and a restart in the middle
heap="$(scene 'p f f' 0.7 '0 0 0' '0.0098 0.001 0' '-0.0098 0 0.001' '0.001 0.0098 0' '0 0 -0.0097' '0.005 0.003 0.0082' '0.0298 0 0')
fix w1 all wall/gran model hertz tangential history $surface primitive type 2 zplane -0.0146
fix w2 all wall/gran model hertz tangential history $surface primitive type 2 yplane -0.0049"
rest="fix move all nve/sphere
dump d all custom 200 PLACE id x y z vx vy vz fx fy fz omegax omegay omegaz
dump_modify d sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\""
printf '%s\n' "$heap" "${rest/PLACE/whole.dump}" 'run 400' >in.whole
printf '%s\n' "$heap" "${rest/PLACE/half.dump}" 'run 200' 'write_restart half.restart' >in.half
{
	echo 'read_restart half.restart'
	grep -vE '^(atom_|region|create_|set |boundary|units|newton)' <<<"$heap"
	printf '%s\n' "${rest/PLACE/cut.dump}" 'run 200'
} >in.cut
"$TSIM" -threads 1 -in in.whole -log none >out 2>&1
report 'the heap runs' $? out
cp whole.dump one.dump
"$TSIM" -threads 2 -in in.whole -log none >out 2>&1
same 'threads' one.dump whole.dump
"$TSIM" -in in.half -log none >out 2>&1 && "$TSIM" -in in.cut -log none >out 2>&1
report 'a restart' $? out
awk '/TIMESTEP/ { getline step } step == 400' whole.dump >last.whole
awk '/TIMESTEP/ { getline step } step == 400' cut.dump >last.cut
same 'goes on with the same bits' last.whole last.cut

rejects "$(fix='' scene 'f f f' 1 '0 0 0')
run 0" 'surface multicontact needs `fix ID all multicontact/halfspace`'
rejects "$(surface='' scene 'f f f' 1 '0 0 0')
run 0" 'no contacts have'
rejects "$(scene 'f f f' 1 '0 0 0')
fix again all multicontact/halfspace
run 0" 'there is one already'
for law in 'hertz cohesion sjkr surface multicontact' 'jkr surface multicontact' \
	'hertz/stiffness surface multicontact' 'hertz surface multicontact located yes'; do
	rejects "$(scene 'f f f' 1 '0 0 0' | sed "s|model hertz.*|model $law|")
run 0" 'surface multicontact goes with model hertz, hooke or hooke/hysteresis'
done
rejects "$(scene 'f f f' 1 '0 0 0' '0.007 0 0' '-0.007 0 0' '0 0.007 0' '0 -0.007 0' '0 0 0.007' '0 0 -0.007' | sed 's/_prefactor 1.25/_prefactor 4/')
run 60" 'the limit is 0.1'

# the load of a contact that ends moves nothing: 300 single grains that bounce off a plane as without the fix
bounce() { # SURFACE FIX TO
	local surface=$1 fix=$2
	box 'f f f' | sed 's/-0.03 0.03/-0.5 0.5/g'
	awk 'BEGIN { for (k = 0; k < 300; k++) print "create_atoms 1 single", -0.4 + 0.02 * (k % 30), \
		-0.4 + 0.02 * int(k / 30), "0.0051 units box" }'
	scene 'f f f' 0.6 | sed '1,/^create_box/d'
	echo "variable v atom -1-0.01*id
set group all vz v_v vx 0.3
fix w all wall/gran model hertz tangential history $surface primitive type 2 zplane 0
fix move all nve/sphere
timestep 1e-5
run 600
write_dump all custom $3 id vx vz omegay modify sort id format float %.12g"
}
bounce '' '' without >in.without
bounce "$surface" "$fix" with >in.with
{ "$TSIM" -in in.without -log none && "$TSIM" -in in.with -log none; } >out 2>&1
cmp without with >>out 2>&1
report 'grains that bounce off a plane have no other contacts' $? out

# LIGGGHTS 3.8: at walls to round-off; at grains but for R*, which has the part of one of them only
both() { # WHAT WITHIN LINE...: the forces of the last step
	local what=$1 within=$2
	shift 2
	printf '%s\n' "$@" "$fix" 'dump d all custom 10 f.dump id fx fy fz' \
		'dump_modify d sort id format "%d %.15g %.15g %.15g"' 'run 50' >in.theirs
	liggghts -in in.theirs >out 2>&1 && mv f.dump theirs.dump && "$TSIM" -in in.theirs -log none >>out 2>&1 &&
		paste theirs.dump f.dump | awk -v within="$within" '
			NF == 8 && !/[A-Z]/ {
				n++
				for (k = 2; k <= 4; k++) { d = $k - $(k + 4); if (d * d > within * within) { print; bad = 1 } }
			}
			END { exit bad || !n }' >>out
	report "$what" $? out
}
if has liggghts; then
	wall="all wall/gran model hertz tangential history $surface primitive type 2"
	alone=$(fix='' scene 'f f f' 0.5 '0 0 0')
	both 'between walls as LIGGGHTS' 1e-14 "$alone" "fix w1 $wall zplane 0.0048" "fix w2 $wall zplane -0.0049" \
		"fix w3 $wall yplane 0.0047" 'velocity all set 0.01 0.1 0.2'
	some=$(fix='' scene 'f f f' 0.5 '0 0 0' '-0.0098 0 0' '0 -0.0098 0' '0.007 0 0.0068')
	both 'grains as LIGGGHTS' 6e-4 "$some" "fix w $wall zplane -0.0048" 'velocity all set 0 0.1 0' 'group g id 1' \
		'velocity g set 0 0 0'
fi
finish
