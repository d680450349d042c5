#!/bin/bash
# Active particles from scripts: the example, numbers by hand, what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99
cp -r "$top_srcdir/examples/polishing" "$top_srcdir/examples/flow" . || exit 99

cd polishing || exit 99
"$TSIM" -in in.active -log none >out 2>&1 && [ "$(grep -c '^RESULT .* ok$' out)" = 5 ] && ! grep -q '^RESULT .* off$' out
report 'the example' $? out
[ "$(wc -l <post/spread.txt)" = 9 ] && [ "$(wc -l <post/modulus.txt)" = 20 ]
report 'its tables' $? post/modulus.txt
cd ..

# A quarter of the columns is 1 high, the others 0; the plane is pressed 0.1 deep into springs of stiffness 8: p = 0.2
cat >in.blocks <<'END'
units si
boundary p p f
region box block 0 4 0 2 -1 2 units box
create_box 1 box
variable cx internal 0
variable h equal v_cx<1
fix pad all surface/voxel formula v_h x cx type 1 cells 8 4
compute press all surface/contact pad winkler 8 pressure 0.2 hardness 4
timestep 1e-6
END
# near NAME FORMULA VALUE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= 1e-11*abs($3)\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.15g), expected \$($3:%.15g)'\""
}
prints "include in.blocks
compute pml all active/pml press radius 0.01 fraction 0.1
compute pi all active/pi press radius 0.01 deviation 0.004 fraction 0.1 hardness 8
variable n equal 0.1/(4/3*PI*0.01^3)
run 0
$(near 'pml all' 'c_pml[1]' 'v_n*6*0.9')
$(near 'pml eligible' 'c_pml[2]' 'v_n^(2/3)*8')
$(near 'pml active' 'c_pml' 'v_n^(2/3)*2')
$(near 'pi all' 'c_pi[1]' 'v_n*6*0.9')
$(near 'pi eligible' 'c_pi[2]' 'v_n*2*0.75*0.9')
$(near 'pi active' 'c_pi[3]/c_pi[2]' '0.00819753592459')" \
	'pml all ok' 'pml eligible ok' 'pml active ok' 'pi all ok' 'pi eligible ok' 'pi active ok'

# no WHAT TEXT LINE: refused
no() {
	printf '%s\n' 'include in.blocks' "$3" 'run 0' >in.script
	refused "$1" "$2" -in in.script
}
no 'no contact' "there is no compute surface/contact 'pres'; did you mean 'press'?" 'compute c all active/pml pres radius 1 fraction 0.1'
no 'another compute' 'expected a compute surface/contact' 'compute ke all ke
compute c all active/pml ke radius 1 fraction 0.1'
no 'more than can be packed' 'fraction' 'compute c all active/pml press radius 1 fraction 0.8'
no 'no radius' 'radius' 'compute c all active/pi press radius 0 deviation 0 fraction 0.1 hardness 1'
finish
