#!/bin/bash
# Columns that are springs under particles (winkler): load and deflection in balance on a top and at an edge, against
# closed forms; energy without damping; rigid columns as the limit; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

# A step of height 1 at x = 0, columns 0.5 x 0.4; one sphere with R = 0.25
cat >in.step <<'END'
units si
boundary f f f
atom_style granular
region box block -1 1 -1 1 -1 3 units box
create_box 2 box
soft_particles yes
fix m1 all property/global youngsModulus peratomtype 1e6 2e6
fix m2 all property/global poissonsRatio peratomtype 0.25 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 ${e} ${e} ${e} ${e}
fix m4 all property/global coefficientFriction peratomtypepair 2 0 0 0 0
pair_style gran model hertz tangential history
pair_coeff * *
variable cx internal 0
variable h equal v_cx<0
fix pad all surface/voxel formula v_h x cx type 2 cells 4 5 ${springs}
fix w all wall/gran ${law} voxels pad
create_atoms 1 single ${x} 0.1 ${z} units box
set group all diameter 0.5 density 2385
fix go all nve/sphere
thermo_style custom step ke f_w[1] f_w[2] f_w[3]
END
# step LAW SPRINGS X Z LINES: the script with these lines at its end
step() {
	echo "variable e index 1
variable law index '$1'
variable springs index '$2'
variable x index $3
variable z index $4
include in.step
timestep 1e-5
$5"
}
hertz='model hertz tangential history'
constants='variable E equal 1/((1-0.25^2)/1e6+(1-0.3^2)/2e6)
variable c equal 4/3*v_E*sqrt(0.25)'

# on a top F/(K A) + (F/c)^(2/3) is the overlap
for K in 3e3 3e6 3e9; do
	agree "top, $K" "$(step "$hertz" "winkler $K" -0.6 1.2 "run 0
$constants
variable F equal -f_w[3]
print \"is overlap \$(v_F/($K*0.2)+(v_F/v_c)^(2/3):%.17g) \$(1.25-1.2:%.17g)\"
print \"is across \$(f_w[1]:%.17g) 0 1\"")"
done
# springs in series
agree linear "$(step 'hooke 2e5 NULL 0 NULL 0 0' 'winkler 1e6' -0.6 1.2 "run 0
print \"is force \$(-f_w[3]:%.17g) \$((1.25-1.2)/(1/2e5+1/(1e6*0.2)):%.17g)\"")"
agree hooke "$(step 'model hooke tangential history' 'winkler 1e6' -0.6 1.2 "fix v all property/global characteristicVelocity scalar 2
run 0
$constants
variable a equal 0.5*v_E
variable m equal 2385*4/3*PI*0.25^3
variable k equal 16/15*v_a*(15/16*v_m*4/v_a)^0.2
print \"is force \$(-f_w[3]:%.17g) \$((1.25-1.2)/(1/v_k+1/(1e6*0.2)):%.17g)\"")"
# at an edge the column goes down, and the normal turns; with 3e4 it leaves the sphere by most of its overlap
for K in 3e4 3e7; do
	agree "edge, $K" "$(step "$hertz" "winkler $K" 0.1 1.12 "run 0
$constants
variable u equal -f_w[3]/($K*0.2)
variable d equal sqrt(0.1^2+(0.12+v_u)^2)
print \"is force \$(sqrt(f_w[1]^2+f_w[3]^2):%.17g) \$(v_c*(0.25-v_d)^1.5:%.17g) 1e4\"
print \"is direction \$(f_w[3]/f_w[1]:%.17g) \$((0.12+v_u)/0.1:%.17g) 10\"")"
done
# a side is rigid
agree side "$(step "$hertz" 'winkler 3e4' 0.2 0.9 "run 0
$constants
print \"is force \$(-f_w[1]:%.17g) \$(v_c*(0.25-0.2)^1.5:%.17g)\"
print \"is along \$(f_w[3]:%.17g) 0 1\"")"

# bounces off the edge and the top: no energy is lost but that of the time step
# bounce X E SPRINGS STEP: the relative change of the energy in `change`, the motion in `bounced`
bounce() {
	step "$hertz" "$3" "$1" 1.3 "velocity all set 0 0 -3 units box
timestep $4
run 0
variable e0 equal \$(ke)
dump d all custom 100 bounced id x y z vx vy vz fx fy fz
dump_modify d format float %.17g
run \$(ceil(0.2/dt))
print \"change \$(abs(ke/v_e0-1)) \$(f_w[3])\"" >in.bounce
	"$TSIM" -in in.bounce -log none -var e "$2" >out 2>&1
	awk '$1 == "change" && $3 == 0 { print $2 }' out >change
}
for x in 0.12 -0.55; do
	for dt in 4e-4 2e-4 1e-4; do
		bounce $x 1 'winkler 1e6' $dt
		cat change
	done >changes
	awk '{ at[NR] = $1 } END { exit !(NR == 3 && at[1] < 1e-4 && at[3] < at[1] / 12) }' changes
	report "energy, $x" $? changes
	# rigid columns, bit for bit
	bounce $x 0.7 'winkler 1e30' 1e-5
	mv bounced limit
	bounce $x 0.7 '' 1e-5
	same "rigid, $x" limit bounced
done
# a contact with damping loses less energy the softer the column is
for springs in 'winkler 1e6' 'winkler 1e7' 'winkler 1e8' ''; do
	bounce -0.55 0.7 "$springs" 1e-5
	cat change
done >changes
awk '{ if ($1 <= last) bad = 1; last = $1 } END { exit bad || NR != 4 || last < 0.509 || last > 0.511 }' changes
report damping $? changes

# heights along another axis
agree 'along x' "$(step "$hertz" 'winkler 3e6' -0.6 1.2 "unfix w
unfix pad
fix pad all surface/voxel constant -0.8 type 2 cells 5 10 normal x winkler 3e6
fix w all wall/gran $hertz voxels pad
run 0
$constants
variable F equal -f_w[1]
print \"is overlap \$(v_F/(3e6*0.4*0.4)+(v_F/v_c)^(2/3):%.17g) \$(-0.8+0.25+0.6:%.17g)\"")"

# no LAW LINES TEXT: refused by the run and by -check
no() {
	step "${1% located*}" 'winkler 3e6' -0.6 1.5 "unfix w
$2
fix w all wall/gran $1 voxels pad
$4
run 1" >in.no
	refused "refused: $3" "$3" -in in.no
	refused "checked: $3" "$3" -check -in in.no
}
springs='need a contact law with the normal force'
no 'model hooke/hysteresis tangential history' 'fix h1 all property/global coefficientMaxElasticStiffness peratomtypepair 2 5 5 5 5
fix h2 all property/global coefficientAdhesionStiffness peratomtypepair 2 0.1 0.1 0.1 0.1
fix h3 all property/global coefficientPlasticityDepth peratomtypepair 2 0.1 0.1 0.1 0.1
fix h4 all property/global characteristicVelocity scalar 1' "$springs"
no "$hertz cohesion sjkr" 'fix c all property/global cohesionEnergyDensity peratomtypepair 2 1 1 1 1' "$springs"
no 'model jkr tangential history' 'fix c all property/global workOfAdhesion peratomtypepair 2 1 1 1 1' "$springs"
no "$hertz located yes" '' "$springs"
no "$hertz impact exact" '' 'the columns are springs'
no "$hertz" '' 'is a spring under particles' 'fix l all energy/ledger'
rejects "$(step "$hertz" 'winkler -1' -0.6 1.5 'run 0')" winkler
finish
