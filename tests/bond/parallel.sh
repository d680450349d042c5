#!/bin/bash
# Bonds that transmit moments: refused input, outputs by known answers, local damping.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
# shellcheck source=tests/lib_meshes.sh
. "$top_srcdir/tests/lib_meshes.sh"

cat >in.two <<'END'
units si
boundary f f f
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 0.25 0 0 units box
set atom 1 diameter 0.2 density 2385
set atom 2 diameter 0.3 density 2385
bond_style parallel
thermo_modify norm no
END

# bad WHAT TEXT LINES: refused with this text, also by -check
bad() {
	printf 'include in.two\n%s\n' "$3" >in.bad
	refused "$1" "$2" -in in.bad
	refused "$1, -check" "$2" -check -in in.bad
}
bad 'no stiffness' 'expected either kn' 'bond_coeff 1 ratio 2'
bad 'both stiffnesses' 'expected either kn' 'bond_coeff 1 kn 1 E 2 ratio 2'
bad 'no shear stiffness' 'either ratio' 'bond_coeff 1 kn 1'
bad 'E with ks' 'with E, not ks' 'bond_coeff 1 E 1 ks 1'
bad 'negative stiffness' 'kn is -1, expected' 'bond_coeff 1 kn -1 ks 1'
bad 'negative strength' 'sigma_c is -1, expected' 'bond_coeff 1 kn 1 ks 1 sigma_c -1'
bad 'radius 0' 'lambda is 0, expected' 'bond_coeff 1 kn 1 ks 1 lambda 0'
bad 'beta above 1' 'beta is 1.5, expected' 'bond_coeff 1 kn 1 ks 1 beta 1.5'
bad 'scatter without deviation' "expected \`deviation\`" 'bond_coeff 1 kn 1 ks 1 sigma_c 1 scatter normal'
bad 'deviation without scatter' "belongs to scatter normal" 'bond_coeff 1 kn 1 ks 1 sigma_c 1 deviation 0.1'
bad 'scatter without strength' "to which it applies" 'bond_coeff 1 kn 1 ks 1 scatter weibull shape 2'
bad 'softening 0' 'soften is 0, expected' 'bond_coeff 1 kn 1 ks 1 sigma_c 1 soften 0'
bad 'softening without a strength' 'expected sigma_c' 'bond_coeff 1 kn 1 ks 1 soften 0.1'
bad 'softening by shear of what does not soften' 'soften_by both: expected soften' 'bond_coeff 1 kn 1 ks 1 tau_c 1 soften_by both'
bad 'softening by shear without a shear strength' 'soften_by both: expected tau_c' 'bond_coeff 1 kn 1 ks 1 sigma_c 1 soften 1 soften_by both'
bad 'friction without a shear strength' 'friction_angle: expected tau_c' 'bond_coeff 1 kn 1 ks 1 sigma_c 1 friction_angle 30'
bad 'a friction angle of 90 degrees' 'friction_angle is 90, expected' 'bond_coeff 1 kn 1 ks 1 tau_c 1 friction_angle 90'
bad 'a negative friction angle' 'friction_angle is -1, expected' 'bond_coeff 1 kn 1 ks 1 tau_c 1 friction_angle -1'
bad 'a word of contact bonds' "unknown keyword 'stiffness'" 'bond_coeff 1 stiffness 1'
bad 'a beam without nu or G' 'expected either nu' 'bond_style beam
bond_coeff 1 E 1'
bad 'a beam with both' 'expected either nu' 'bond_style beam
bond_coeff 1 E 1 nu 0.3 G 1'
bad 'yield beyond the modulus' 'is not below' 'bond_style beam
bond_coeff 1 E 1 nu 0.3 yield 1'
bad 'nu above a half' 'nu is 0.6' 'bond_style beam
bond_coeff 1 E 1 nu 0.6'
bad 'gran: ring inside out' 'expected less than the outer radius' 'bond_style gran
bond_coeff 1 0.5 0.6 1 1 0 0 1 1 1'
bad 'gran: nonlinear damping' 'nonlinear damping depends on the time step' 'bond_style gran
bond_coeff 1 1 0 1 1 2 0 0.1 0 1 1 1'
bad 'gran: soft breakage' 'break style 5 is not supported' 'bond_style gran
bond_coeff 1 1 0 1 1 1 0.1 5 1 1'
bad 'gran: a number is missing' 'tau' 'bond_style gran
bond_coeff 1 1 0 1 1 1 0.1 1 1'
bad 'a bond type without coefficients' "no \`bond_coeff 2" 'bond_coeff 1 kn 1 ks 1
bond_coeff 2 kn 1 ks 1
create_bonds single/bond 2 1 2
bond_style parallel
bond_coeff 1 kn 1 ks 1
run 0'
bad 'the same place' "at the same place" 'bond_coeff 1 kn 1 ks 1
set atom 2 x 0
create_bonds single/bond 1 1 2'
bad 'a member of a rigid body' "belongs to a rigid body" 'bond_coeff 1 kn 1 ks 1
create_bonds single/bond 1 1 2
group one id 1
fix body one rigid single
run 0'
bad 'explicit Euler' "fix nve/sphere" 'bond_coeff 1 kn 1 ks 1
create_bonds single/bond 1 1 2
fix move all nve/euler
timestep 1e-3
run 0'
bad 'no rotation' "does not integrate rotation" 'bond_coeff 1 kn 1 ks 1
create_bonds single/bond 1 1 2
fix move all nve
timestep 1e-3
review error
run 10'
bad 'a step above the limit' "exceeds the stability limit" 'bond_coeff 1 kn 1e9 ks 1e9
create_bonds single/bond 1 1 2
fix move all nve/sphere
timestep 1
run 10'
bad 'columns of moments for central springs' "transmit moments" 'bond_style contact
bond_coeff 1 stiffness 1 ultimate 1
create_bonds single/bond 1 1 2
compute b all bond/local sigma
run 0'
printf 'include in.two\nbond_coeff 1 kn 1 ks 1\ncreate_bonds single/bond 1 1 2\nset atom 2 omegax 20\nfix m all nve/sphere\ntimestep 0.1\nrun 100\n' >in.turn
refused 'turned too far' 'relative to each other; bonds' -in in.turn
sed 's/^bond_coeff.*/bond_coeff 1 kn 1 ks 1 sigma_c 1e-6 soften 1e-9/; s/omegax/omegay/; s/timestep.*/timestep 0.01/' in.turn >in.torn
echo 'print "is torn $(brokenbonds) 1"' >>in.torn
agree 'a cracked bond that is turned so far is torn' 'include in.torn'
printf '%s\n' 'units si' 'boundary p p p' 'region box block 0 1 0 1 0 1 units box' 'create_box 1 box' \
	'create_atoms 1 single 0 0 0 units box' 'create_atoms 1 single 0.495 0 0 units box' \
	'set group all diameter 0.2 density 2385' 'bond_style parallel' 'bond_coeff 1 kn 1 ks 1' \
	'create_bonds single/bond 1 1 2' 'run 0' >in.long
refused 'half the periodic box' 'about half the periodic box' -in in.long

# Mohr and Coulomb: compressed by p = kn 1e-4 the shear strength is tau_c + p tan(30 degrees), pulled it is as much smaller;
# one hundredth below it the bond holds, above it breaks
for sign in -1 1; do
	agree "a shear strength that depends on the normal stress ($sign)" "include in.two
bond_coeff 1 kn 2e7 ks 1e7 sigma_c 3e6 tau_c 2e3 friction_angle 30
create_bonds single/bond 1 1 2
compute f all bond/local tau_c mode
compute all all reduce sum c_f[1] c_f[2]
set atom 2 x \$(0.25+1e-4*$sign)
run 0
variable c equal 2e3-$sign*2e3/sqrt(3)
print 'is strength \$(c_all[1]) \$(v_c) \$(v_c*1e12)'
set atom 2 y \$(0.99*v_c/1e7)
run 0
print 'is holding \$(bonds) 1'
print 'is shear \$(c_all[2]) 2'
set atom 2 y \$(1.01*v_c/1e7)
run 0
print 'is broken \$(brokenbonds) 1'"
done

# The section is midway between the surfaces, radius 0.9 min(R); the first particle is moved by a sideways step u, the
# second one turned by u: forces, moments and stresses by Potyondy & Cundall.
agree 'a sheared, bent, twisted bond' 'include in.two
bond_coeff 1 kn 2.385e7 ks 0.9e7 lambda 0.9 sigma_c 3e6 tau_c 2e6 beta 0.6
create_bonds single/bond 1 1 2
compute f all bond/local force fx fy fz shear bending twist tx ty tz sigma tau sigma_c tau_c ratio mode
variable u equal 1e-7
displace_atoms all rotate 0 0 0 1 0 0 0 units box
set atom 1 y ${u}
compute all all reduce sum c_f[1] c_f[3] c_f[5] c_f[6] c_f[7] c_f[10] c_f[11] c_f[12] c_f[13] c_f[14] c_f[15] c_f[16]
run 0
variable A equal PI*0.09^2
print "is shear $(abs(c_all[3]/(0.9e7*v_A*v_u)-1)<1e-10) 1"
print "is fy $(abs(c_all[2]/(-0.9e7*v_A*v_u)-1)<1e-10) 1"
print "is tz $(abs(c_all[6]/(-0.9e7*v_A*v_u*0.1)-1)<1e-10) 1"
print "is tau $(abs(c_all[8]/(0.9e7*v_u)-1)<1e-10) 1"
print "is strength $(c_all[9]+c_all[10]) 5e6"
print "is mode $(c_all[12]) 2"
print "is ratio $(abs(c_all[11]/(0.9e7*v_u/2e6)-1)<1e-10) 1"
print "is straight $(abs(c_all[4])+abs(c_all[5])<1e-9) 1"
print "is energy $(abs(ebond/(0.5*0.9e7*v_A*v_u^2)-1)<1e-10) 1"'

# A ring of radii 0.08 and 0.04: stiffnesses of stretching, shear and twist; through a restart file
gran='include in.two
bond_style gran
bond_coeff 1 0.8 0.4 2.385e6 0.9e6 1 0.1 1 7e3 5e3
create_bonds single/bond 1 1 2
compute f all bond/local shear twist sigma tau sigma_c ratio
compute all all reduce sum c_f[1] c_f[2] c_f[3] c_f[4] c_f[5] c_f[6]
variable u equal 1e-5
set atom 2 y ${u}'
told='variable A equal PI*(0.08^2-0.04^2)
print "is shear $(abs(c_all[1]/(0.9e6*v_A/0.25*v_u)-1)<1e-8) 1"
print "is tau $(abs(c_all[4]/(0.9e6/0.25*v_u)-1)<1e-8) 1"
print "is sigma_c $(c_all[5]) 7e3"
print "is ratio $(abs(c_all[6]/(0.9e6/0.25*v_u/5e3)-1)<1e-8) 1"'
agree 'bond_style gran' "$gran
run 0
$told
write_restart one.restart"
agree 'bond_style gran, restarted' "read_restart one.restart
bond_style gran
compute f all bond/local shear twist sigma tau sigma_c ratio
compute all all reduce sum c_f[1] c_f[2] c_f[3] c_f[4] c_f[5] c_f[6]
variable u equal 1e-5
run 0
$told"
agree 'bond_style gran: by the distance' "include in.two
bond_style gran
bond_coeff 1 1.0 0.0 1e6 1e6 0 0 0 0.126
create_bonds single/bond 1 1 2
set atom 2 x 0.2519
run 0
print 'is whole \$(bonds) 1'
set atom 2 x 0.2521
run 0
print 'is broken \$(bonds) 0'"

# A script of LIGGGHTS with bonds; as many bonds as create_bonds, whichever way, of a crystal across periodic faces
cat >in.crystal <<'END'
atom_style hybrid granular bond/gran n_bondtypes 1 bonds_per_atom 6
atom_modify map array
units si
boundary p p p
newton off
communicate single vel yes
lattice sc 1.0
region box block 0 4 0 3 0 5 units box
create_box 2 box
create_atoms 1 box
set group all diameter 1 density 1000
set group all type/fraction 2 0.3 4711
bond_style gran
bond_coeff 1 1.0 0.0 1e6 4e5 1 0.1 1 1e9 1e9
fix move all nve/sphere
timestep 1e-4
END
agree 'fix bond/create/gran: as many as create_bonds' 'include in.crystal
fix b all bond/create/gran 1 1 1 1.01 1 6
fix c all bond/create/gran 1 1 2 1.01 1 6
fix d all bond/create/gran 1 2 2 1.01 1 6
run 1
fix_modify b every 0
print "is all $(bonds) 180"
print "is sum $(f_b+f_c+f_d) 180"
delete_bonds all
create_bonds many all all 1 0 1.01
print "is same $(bonds) 180"'
# Radii 0.1 and 0.15, the centres 0.25 apart; a third one 0.01 from the second
agree 'create_bonds gap: by the surfaces' 'include in.two
set atom 1 diameter 0.2 density 2385
create_atoms 1 single 0.46 0 0 units box
set atom 3 diameter 0.1 density 2385
bond_coeff 1 kn 1 ks 1
create_bonds gap all all 1 -0.001
print "is overlap $(bonds) 0"
create_bonds gap all all 1 1e-12
print "is touch $(bonds) 1"
create_bonds gap all all 1 0.011
print "is near $(bonds) 2"
create_bonds gap all all 1 -10
print "is none $(bonds) 2"'
bad 'create_bonds gap: no number' 'gap' 'bond_coeff 1 kn 1 ks 1
create_bonds gap all all 1 near'
agree 'fix bond/create/gran: at most newperts' 'include in.crystal
set group all type 1
fix b all bond/create/gran 2 1 1 1.01 1 1
run 1
print "is none $(bonds) 0"
run 1
compute n all bonds
compute most all reduce max c_n
run 0
print "is one $(c_most) 1"
run 30
print "is all $(bonds) 180"
fix_modify b every 0
delete_bonds all
run 4
print "is stopped $(bonds) 0"'
bad 'fix bond/create/gran without bond_coeff' 'it must come before' 'fix b all bond/create/gran 1 1 1 0.3 1 6'
bad 'fix bond/create/gran: no such type' 'particle type 2' 'bond_coeff 1 kn 1 ks 1
fix b all bond/create/gran 1 1 2 0.3 1 6'
printf '%s\n' 'include in.two' 'bond_coeff 1 kn 1 ks 1' 'set atom 2 x 0' 'fix b all bond/create/gran 1 1 1 0.3 1 6' \
	'fix m all nve/sphere' 'timestep 1e-4' 'run 1' >in.same
refused 'fix bond/create/gran: the same place' 'at the same place' -in in.same

# A bond holds across a wall of triangles that neither partner touches, to a frozen and to a moved partner.
plate 2 0 >plate.stl
for held in 'freeze' 'move wiggle 0 0 0.003 0.02' 'move rotate 0 0 0 0 0 1 0.1'; do
	for wall in '' 'fix wall all mesh/surface file plate.stl type 1
fix walls all wall/gran model hooke/modulus tangential history mesh n_meshes 1 meshes wall'; do
		cat >in.across <<END
include in.two
fix e all property/global contactModulus peratomtypepair 1 1e7
fix k all property/global contactStiffnessRatio peratomtypepair 1 2
fix r all property/global coefficientRestitution peratomtypepair 1 1
fix mu all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hooke/modulus tangential history
pair_coeff * *
set atom 1 diameter 0.2 x 0 y 0 z -0.125
set atom 2 diameter 0.2 x 0.02 y 0 z 0.125
bond_coeff 1 kn 1e6 ks 1e6
create_bonds single/bond 1 1 2
$wall
group one id 1
group two id 2
fix held one $held
fix move two nve/sphere
velocity two set 0.03 0.02 0.05
timestep 1e-5
run 2000
variable x equal x[2]
variable z equal z[2]
variable w equal omegay[2]
print "IS \$(v_x) \$(v_z) \$(v_w) bonds \$(bonds)"
END
		"$TSIM" -in in.across -log none 2>&1 | grep ^IS >"across${wall:+.wall}"
	done
	grep -q 'bonds 1' across && cmp across across.wall >out 2>&1
	report "a bond across triangles, fix $held" $? out
done

# scatter none: all bonds break at the same stress; the mode is told
cat >in.break <<'END'
include in.two
bond_coeff 1 kn 1e7 ks 1e7 sigma_c 10
create_bonds single/bond 1 1 2
fix move all nve/sphere
velocity all set 0 0 0
set atom 2 vx 1e-2
fix cracks all bond/breakage file cracks.txt
timestep 1e-6
run 1000
print "is broken $(brokenbonds) 1"
END
agree 'breakage' "$(cat in.break)"
# the spring alone, k = kn pi 0.1^2: energy F^2/2k
awk '/^#/ { names = / force mode energy$/; next }
	{ found = $10 == "tension" && ($9 * $9 / (2 * 1e7 * 4 * atan2(1, 1) * 0.01) / $11 - 1) ^ 2 < 1e-14 }
	END { exit !(names && found) }' cracks.txt
report 'mode and energy in the file' $? cracks.txt
sed -i 's/cracks.txt/cracks.csv/' in.break
"$TSIM" -in in.break -log none >out 2>&1
awk -F, 'NR == 1 { names = $0 == "step,time,i,j,type,x,y,z,force,mode,energy"; next }
	{ printf "%d %.9g %d %d %d %.9g %.9g %.9g %.9g %s %.9g\n", $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11 }
	END { exit !names }' cracks.csv >rows
report 'the file as a table: names' $? cracks.csv
grep -v '^#' cracks.txt >want
same 'the file as a table' want rows

# A beam that yields in bending, torsion and tension: the ledger closes with second order in the time step.
for h in 2e-5 5e-6; do
	cat >in.yields <<END
include in.two
set atom 2 diameter 0.2 density 2385
bond_style beam
bond_coeff 1 E 1e9 nu 0.3 lambda 0.2 yield 1e6
create_bonds single/bond 1 1 2
group one id 1
group two id 2
fix held one freeze
fix move two nve/sphere
velocity two set 0.02 0.3 0.1
set atom 2 omegax 5
fix books all energy/ledger every 1 summary no tolerance 1
timestep $h
run \$(round(0.02/$h))
print "IS \$(f_books[15]) \$(f_books[20]) \$(ke+erotate)"
END
	"$TSIM" -in in.yields -log none 2>&1 | grep ^IS
done >yields
awk '{ lost[NR] = $2; drift[NR] = $3 / ($2 + $4) }
	END { r = drift[1] / drift[2]; exit !(NR == 2 && lost[2] > 0.4 && (lost[1] / lost[2] - 1) ^ 2 < 1e-10 &&
		drift[1] ^ 2 < 4e-12 && r > 10) }' yields
report 'the energy of a beam that yields' $? yields

# Bonds that soften, pulled, sheared and bent, and that break at last: the same
# energy_of WHAT WORDS [ERROR]: the law of the bond, and how much the work lost may depend on the step
energy_of() {
	local h
	for h in 8e-5 5e-6; do
		sed -e "s/^bond_style.*/bond_style parallel/; s/^bond_coeff.*/bond_coeff 1 kn 1e9 ks 4e8 lambda 0.2 $2/" \
			-e "s/^timestep.*/timestep $h/; s/^run.*/run \$(round(0.006\/$h))/" in.yields >in.softens
		"$TSIM" -in in.softens -log none 2>&1 | grep ^IS
	done >softens
	awk -v error="${3-3e-3}" '{ lost[NR] = $2; drift[NR] = $3 / ($2 + $4) }
		END { r = drift[1] / drift[2]; exit !(NR == 2 && lost[2] > 1e-3 && (lost[1] / lost[2] - 1) ^ 2 < error ^ 2 &&
			drift[1] ^ 2 < 1e-8 && r > 100) }' softens
	report "the energy of a bond that softens$1" $? softens
}
energy_of '' 'sigma_c 1e5 soften 0.1'
energy_of ' by shear' 'sigma_c 1e6 tau_c 5e4 soften 0.1 soften_by both'
energy_of ' by shear, with friction' 'sigma_c 1e6 tau_c 5e4 soften 0.1 soften_by both friction_angle 30' 0.03

# Cundall: the force of a spring is (1-g) k x on the way in and (1+g) k x on the way out
agree 'local damping' 'include in.two
bond_coeff 1 kn 2e6 ks 1e6
create_bonds single/bond 1 1 2
group one id 1
group two id 2
fix move two nve/sphere
fix calm two damping/cundall 0.3 0.3
displace_atoms two move 1e-5 0 0 units box
review off integrator
variable w equal sqrt(2e6*PI*0.01/(2385*PI*0.3^3/6))
variable n equal floor(PI/2/v_w*(1/sqrt(0.7)+1/sqrt(1.3))/1e-5+0.5)
timestep 1e-5
run ${n}
variable left equal (xcm(two,x)-0.25)/1e-5
print "is amplitude $(abs(v_left+sqrt(7/13))<1e-4) 1"'
# bond_style gran, break style 2: a bond whose particles have a mean temperature above 330 breaks
cat >in.hot <<'END2'
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 0.25 0 0 units box
set group all diameter 0.2 density 2385
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix ftco all property/global thermalConductivity peratomtype 5.
fix ftca all property/global thermalCapacity peratomtype 10.
pair_style gran model hertz tangential history
pair_coeff * *
bond_style gran
bond_coeff 1 1 0 1e6 4e5 1 0.1 2 1e9 1e9 330
create_bonds single/bond 1 1 2
fix n all nve/sphere
timestep 1e-5
END2
agree 'breakage by temperature' 'include in.hot
fix heat all heat/gran initial_temperature 300
fix c all bond/breakage file broken.txt
set atom 2 property/atom Temp 359.9
run 3
print "is broken $(brokenbonds) 0"
set atom 2 property/atom Temp 360.1
run 3
print "is broken $(brokenbonds) 1"'
grep -q '^4 .* temperature [^ ]*$' broken.txt
report 'mode temperature' $? broken.txt
echo 'include in.hot
run 1' >in.bad
refused 'no temperatures' 'needs the temperatures of `fix ID all heat/gran' -in in.bad
refused 'no temperatures, -check' 'needs the temperatures of `fix ID all heat/gran' -check -in in.bad
echo 'include in.hot
unfix n
bond_style contact
bond_coeff 1 stiffness 1 ultimate 1
fix cut all bond/break 2 1 0.2
fix c all bond/breakage file cut.txt
compute e all pe bond
run 5' >in.cut
"$TSIM" -in in.cut -log none >out 2>&1 && grep -q '^2 ' cut.txt
report 'cut by fix bond/break' $? out
finish
