#!/bin/bash
# Materials from files: values, pairs, units, places of errors; a run with them is the run with the same
# numbers given by fix property/global; and the installed ones can be read.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >oak.material <<'END'
# not measured
density 713.5 kg/m3
youngsModulus 2.385e8 Pa		# about
poissonsRatio 0.231 1
coefficientRestitution 0.41 1
coefficientFriction 0.31 1
coefficientFriction with brass 0.177 1
END
cat >brass.material <<'END'
density 8417 kg/m3
youngsModulus 7.31e8 Pa
poissonsRatio 0.331 1
coefficientRestitution 0.77 1 coefficientFriction 0.23 1
thermalConductivity 109 W/m/K thermalCapacity 377 J/kg/K
END
start='boundary f f f
region b block -1 1 -1 1 -1 1 units box
create_box 3 b
material 1 file oak
material 2 file brass.material
material 3 file oak'

agree 'values, si' "units si
$start
variable a equal 1
print 'is density \$(property(density,1)) 713.5'
print 'is density \$(property(density,2)) 8417'
print 'is own \$(property(coefficientFriction,1,1)) 0.31'
print 'is same \$(property(coefficientFriction,1,3)) 0.31'
print 'is mutual \$(property(coefficientFriction,1,2)) 0.177'
print 'is mutual \$(property(coefficientFriction,2,1)) 0.177'
print 'is mean \$(property(coefficientRestitution,1,2)) 0.59'
print 'is conductivity \$(property(thermalConductivity,2)) 109'
fix m all property/global coefficientFriction scalar 0.5
print 'is given \$(property(coefficientFriction,1,2)) 0.5'
material 1 file brass
print 'is anew \$(property(density,1)) 8417'
if property_density then \"print 'is there 1 1'\""
agree 'values, cgs' "units cgs
$start
print 'is density \$(property(density,1)) 0.7135'
print 'is modulus \$(property(youngsModulus,1)) 2.385e9'
print 'is conductivity \$(property(thermalConductivity,2)) 109e5'
print 'is capacity \$(property(thermalCapacity,2)) 377e4'"
agree 'values, micro' "units micro
$start
print 'is density \$(property(density,1)) 0.7135'
print 'is modulus \$(property(youngsModulus,1)) 2.385e5'"

rejects "units si
$start
print '\$(property(density,4))'" 'expected a particle type from 1 to 3'
rejects "units si
$start
print '\$(property(thermalCapacity,1))'" 'or a line in the files of the materials'
rejects "units lj
$start" 'units lj have no kg/m3'
rejects "units si
$start
material 4 file oak" 'particle type 4 does not exist'
rejects "units si
$start
material 1 file teak" "cannot read coefficient file 'teak'"
# the mean of two materials is no measurement: said once for each pair, whatever the order
mean="units si
$start
print '\$(property(coefficientRestitution,1,2):%.6g) \$(property(coefficientRestitution,2,3):%.6g) \$(property(coefficientFriction,1,2):%.6g)'
print '\$(property(coefficientRestitution,2,1)) \$(property(coefficientRestitution,1,3))'"
prints "$mean" '0.59 0.59 0.177'
[ "$(grep -c 'no file gives coefficientRestitution of brass with oak; the mean of both materials, 0.59, is used' out)" = 1 ] &&
	[ "$(grep -c 'no file gives' out)" = 1 ]
report 'a mean is told' $? out
rejects "units si
$start
print '\$(property(coefficientRollingFriction,1,2))'" 'those of oak and brass have no value for this pair'
rejects "units si
$start
print '\$(property(thermalConductivity,1))'" 'that of oak has no value'
bad() { # WORDS MESSAGE
	printf 'density 1 kg/m3\n%s\n' "$1" >bad.material
	rejects "units si
$start
material 1 file bad" "$2"
}
bad 'youngsModulus 5e6 MPa' "bad:2:19: error: material: unknown unit 'MPa'"
bad 'youngsModulus 5e6' "expected a value and its unit (1: none) after 'youngsModulus'"
bad 'youngsModulus 5f6 Pa' "expected a number, found '5f6'"
bad 'density 2 kg/m3' "'density' is given twice"
printf 'coefficientFriction with oak 0.2 1\n' >teak.material
printf 'coefficientFriction with teak 0.3 1\n' >>oak.material
rejects "units si
$start
material 2 file teak
print '\$(property(coefficientFriction,1,2))'" 'coefficientFriction with teak is 0.3 here, but 0.2 in the other file'

cat >in.run <<'END'
units si
boundary f f f
newton off
region b block -1 1 -1 1 -1 1 units box
create_box 2 b
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0.0123 0.012 0.0117 units box
set group all diameter 0.0207 density 2385
velocity all set 0.13 0.17 0.19
set atom 2 vx -1.3
include in.${how}
pair_style gran model hertz tangential history
pair_coeff * *
fix f all wall/gran model hertz tangential history primitive type 2 zplane -0.01
fix m all nve/sphere
timestep 1e-6
run 2000
print "at $(x[1]) $(vy[1]) $(fz[1]) $(x[2]) $(vy[2]) $(fz[2])" screen no file ${how}.out
END
printf 'material 1 file oak\nmaterial 2 file brass\n' >in.materials
cat >in.properties <<'END'
fix y all property/global youngsModulus peratomtype 2.385e8 7.31e8
fix n all property/global poissonsRatio peratomtype 0.231 0.331
fix e all property/global coefficientRestitution peratomtypepair 2 0.41 0.59 0.59 0.77
fix c all property/global coefficientFriction peratomtypepair 2 0.31 0.177 0.177 0.23
END
for how in materials properties; do
	"$TSIM" -in in.run -var how $how -log none -screen none 2>err
	report "run with $how" $? err
done
same 'materials and properties' materials.out properties.out
sed -i 's/7.31e8 Pa/7.31e9 Pa/' brass.material
refused 'range of a modulus' 'brass:2:1: error: property/global youngsModulus is 7310000000, expected at most 1e+09' \
	-in in.run -var how materials

for file in "$top_srcdir"/potentials/*.material; do
	name=$(basename "$file" .material)
	printf 'units si\nregion b block -1 1 -1 1 -1 1 units box\ncreate_box 1 b\nmaterial 1 file %s\n' "$file" >in.script
	echo "if \"\$(property(density,1)) > 900\" then \"print 'can be read'\"" >>in.script
	"$TSIM" -in in.script -log none 2>err | grep -q 'can be read'
	report "$name" $? err
	grep -vE '^(#|$)' "$file" | grep -v '# ' >unsourced
	[ ! -s unsourced ]
	report "$name: every number has its source" $? unsourced
done
TSIM_POTENTIALS=$top_srcdir/potentials "$TSIM" -in "$top_srcdir/examples/materials/in.rebound" -log none >out 2>err
[ "$(grep -c '^RESULT.* ok$' out)" = 2 ] && ! grep -q '^RESULT.* off$' out
report 'the example judges itself ok' $? out
# Where files are looked for: beside the script, in TSIM_POTENTIALS; what was not found says where.
mkdir -p scripts shelf
cp oak.material scripts/elm.material
cp oak.material shelf/ash.material
cp "$top_srcdir/potentials/glass.material" shelf
printf 'units si\n%s\nmaterial 1 file elm\nmaterial 2 file ash\nmaterial 3 file glass\nprint "is $(property(density,3)) 2500"\nmaterial 3 file nowhere' \
	"$start" | sed '/^material [123] file [ob]/d' >scripts/in.where
TSIM_POTENTIALS=shelf "$TSIM" -in scripts/in.where -log none >out 2>err </dev/null
[ $? = 1 ] && grep -qx 'is 2500 2500' out && grep -q "nowhere' nor with the ending .material" err &&
	grep -q 'looked for here, scripts, shelf, potentials, .*/potentials' err
report 'where materials are' $? err

# Installed pairs, from either side
TSIM_POTENTIALS=$top_srcdir/potentials agree 'pairs of installed materials' "units si
boundary f f f
region b block -1 1 -1 1 -1 1 units box
create_box 4 b
material 1 file glass
material 2 file alumina
material 3 file steel
material 4 file aluminium
variable one equal 1
print 'is glass \$(property(coefficientRestitution,1,1)) 0.97'
print 'is alumina \$(property(coefficientRestitution,2,1)) 0.98'
print 'is alumina \$(property(coefficientFriction,1,2)) 0.092'
print 'is steel \$(property(coefficientFriction,4,3)) 0.47'
print 'is aluminium \$(property(coefficientFriction,4,4)) 1.4'"

# A property that is missing is not one that is given, but a misspelt one.
models='fix m1 all property/global youngsModulus peratomtype 5e6 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3 0.3
fix m4 all property/global coefficientRollingFriction scalar 0.5
pair_style gran model hertz tangential history
pair_coeff * *
run 0'
begin='units si
boundary f f f
region b block -1 1 -1 1 -1 1 units box
create_box 3 b
create_atoms 1 single 0 0 0.5 units box
set group all diameter 0.1 density 2000'
rejects "$begin
fix m3 all property/global coefficientFriction scalar 0.5
$models" 'needs `fix ID all property/global coefficientRestitution peratomtypepair N ...`'
! grep -q 'did you mean' err
report 'no restitution by friction' $? err
rejects "$begin
fix m3 all property/global coefficentRestitution scalar 0.5
$models" "did you mean 'coefficentRestitution'?"

# The type of a wall that is too large: the place is that of the number.
rejects "$begin
fix m3 all property/global coefficientRestitution scalar 0.5
fix m5 all property/global coefficientFriction scalar 0.5
fix w all wall/gran model hertz tangential history primitive type 4 zplane 0
$models" 'fix wall/gran: the wall is of type 4, but create_box made 3'
grep -q '^in.script:[0-9]*:[5-7][0-9]: ' err
report 'the type of the wall' $? err
finish
