#!/bin/bash
# compute surface/contact: Hertz and springs from a script, columns in dumps, a load curve; what is refused.
# shellcheck source=tests/lib_cases.sh
. "$top_srcdir/tests/lib_cases.sh" || exit 99

cat >in.sphere <<'END'
units si
boundary f f f
region box block 0 1 0 1 -1 1 units box
create_box 1 box
variable cx internal 0
variable cy internal 0
variable h equal -0.5*((v_cx-0.5)^2+(v_cy-0.5)^2)
fix s all surface/voxel formula v_h x cx y cy type 1 cells 64 64
timestep 1e-6
END
# near NAME FORMULA VALUE TOLERANCE: a line of a script that prints whether they agree
near() {
	echo "if \"abs(($2)-($3)) <= $4\" then \"print '$1 ok'\" else \"print '$1: \$($2:%.10g), expected \$($3:%.10g)'\""
}

# Hertz: contact radius 0.3 for the load 4/3 E* 0.3^3; E* = 1 of both solids together
prints "include in.sphere
compute c all surface/contact s halfspace young 1.82 poisson 0.3 counter_young 1.82 counter_poisson 0.3 pressure \$(4/3*0.3^3)
thermo_style custom step c_c c_c[1] c_c[3] c_c[5] c_c[6]
run 0
$(near plane 'c_c[1]' '-0.09' 2e-5)
$(near area 'c_c[3]' 'PI*0.09' 5e-4)
$(near pressure 'c_c[6]' '0.6/PI' 2e-4)" 'plane ok' 'area ok' 'pressure ok'

# The load curve of springs under a sphere: F = pi k d^2; the plane at -d
prints "include in.sphere
variable d equal 0.02
variable p equal PI*v_d^2
compute c all surface/contact s winkler 1 pressure v_p
run 0
$(near plane 'c_c[1]' '-v_d' 2e-4)
variable d equal 0.05
$(near 'second plane' 'c_c[1]' '-v_d' 2e-4)
$(near area 'c_c' '2*PI*v_d' 2e-3)" 'plane ok' 'second plane ok' 'area ok'

# Columns are outputs of the surface: their sum is the load; they are written with the field
prints "include in.sphere
compute c all surface/contact s halfspace young 1 poisson 0 pressure 0.01 hardness 0.1
compute sum all reduce sum c_c[1]
dump d all voxel/vtk 1 top.*.vtk s c_c[1] c_c[2]
run 0
$(near load 'c_sum/4096' 0.01 1e-12)
$(near hardness 'c_c[6]' 0.1 0)
$(near yielding 'c_c[4]' 0.061 0.03)" 'load ok' 'hardness ok' 'yielding ok'
grep -q '^c_c\[1\]\|^c_c_1\|c_c' top.0.vtk
report 'columns in the dump' $? top.0.vtk

# A self-affine surface against another; threads
cat >in.rough <<'END'
units si
boundary p p f
region box block 0 1 0 1 -1 1 units box
create_box 1 box
fix s all surface/voxel selfaffine deviation 0.001 hurst 0.8 roll 0.25 shortest 0.0625 longest 0.25 seed 3 type 1 cells 128 128
fix t all surface/voxel selfaffine deviation 0.001 hurst 0.8 roll 0.25 shortest 0.0625 longest 0.25 seed 4 type 1 cells 128 128
compute c all surface/contact s halfspace young 1 poisson 0 pressure 0.002 counter t
timestep 1e-6
run 0
print "$(c_c[1]:%.17g) $(c_c[3]:%.17g) $(c_c[5]:%.17g)"
END
for threads in 1 3; do
	"$TSIM" -in in.rough -log none -threads $threads >out.$threads 2>&1
	grep -E '^[-0-9.e]+ [0-9.e-]+ [0-9.e-]+$' out.$threads >line.$threads
done
same 'the same on three threads' line.1 line.3

# no WHAT TEXT LINES: a script with these lines is refused
no() {
	printf '%s\n' 'include in.sphere' "$3" >in.script
	refused "$1" "$2" -in in.script
}
no 'the load' 'cannot be carried: where all columns yield it is the hardness 0.1' 'compute c all surface/contact s winkler 1 pressure 0.1 hardness 0.1
run 0
print "$(c_c)"'
no 'the hardness is the load' 'the mean pressure 0.1 cannot be carried' 'compute c all surface/contact s halfspace young 1 poisson 0 pressure 0.1 hardness 0.1
run 0
print "$(c_c)"'
# pressures of any size beside the load
sed 's/cells 64 64/cells 16 16/' in.sphere >in.coarse
for young in 1e-25 1e13; do
	printf '%s\n' 'include in.coarse' "compute c all surface/contact s halfspace young $young poisson 0 pressure 0.1" 'thermo_style custom step c_c[3]' \
		'run 0' >in.script
	timeout 60 "$TSIM" -in in.script -log none >out 2>&1
	report "young $young" $? out
done
sed 's/young 1e13/young 1e30/' in.script >in.stiff
refused 'young 1e30' 'too large or too small for the arithmetic' -in in.stiff
no 'a negative modulus' 'young is -1, expected a number > 0' 'compute c all surface/contact s halfspace young -1 poisson 0 pressure 0.1
run 0'
no 'a negative modulus of the other solid' 'counter_young is -1, expected a number > 0' 'compute c all surface/contact s halfspace young 1 poisson 0 counter_young -1 pressure 0.1
run 0'
no 'a Poisson ratio above 1/2' 'poisson is 0.7, expected a number from -1 to 0.5' 'compute c all surface/contact s halfspace young 1 poisson 0.7 pressure 0.1
run 0'
no 'a negative hardness' 'hardness is -1, expected a number > 0' 'compute c all surface/contact s winkler 1 pressure 0.1 hardness -1
run 0'
no 'displacements that are no numbers' 'too large or too small for the arithmetic: check pressure, young and units' 'compute c all surface/contact s halfspace young 1e-320 poisson 0 pressure 0.1
run 0
print "$(c_c)"'
no 'pressures whose squares underflow' 'too large or too small' 'compute c all surface/contact s halfspace young 1 poisson 0 pressure 1e-200
run 0
print "$(c_c)"'
no 'columns of other widths' 'both need the same number, width and axis' 'fix t all surface/voxel constant 0 type 1 cells 64 64 size 0.5 0.5
compute c all surface/contact s winkler 1 pressure 0.01 counter t
run 0'
echo '1 nan' >nan
no 'heights that are no numbers' "'nan'" 'fix t all surface/voxel file nan type 1
run 0'
no 'no load' 'the mean pressure is 0, must be > 0' 'variable p equal 0
compute c all surface/contact s winkler 1 pressure v_p
run 0
print "$(c_c)"'
no 'a load that pulls' 'pressure is -4e4, expected a number > 0' 'compute c all surface/contact s winkler 1 pressure -4e4
run 0'
refused 'by -check, too' 'pressure is -4e4, expected a number > 0' -check -in in.script
no 'too few iterations' 'give more `iterations`' 'compute c all surface/contact s halfspace young 1 poisson 0 iterations 2 pressure 0.01
run 0
print "$(c_c)"'
no 'other columns' 'both need the same number, width and axis' 'fix t all surface/voxel constant 0 type 1 cells 32 64
compute c all surface/contact s winkler 1 pressure 0.01 counter t
run 0'
no 'no field' "there is no height field 'q'" 'compute c all surface/contact q winkler 1 pressure 0.01
run 0'
no 'waves shorter than columns' 'need columns of at most half this width' 'fix t all surface/voxel selfaffine deviation 1 hurst 0.8 shortest 0.01 seed 1 type 1 cells 64 64
run 0'
no 'waves in the wrong order' 'are not in this order' 'fix t all surface/voxel selfaffine deviation 1 hurst 0.8 roll 0.3 longest 0.2 seed 1 type 1 cells 64 64
run 0'
no 'no wave' 'no wave that is periodic' 'fix t all surface/voxel selfaffine deviation 1 hurst 0.8 roll 0.95 shortest 0.95 longest 0.95 seed 1 type 1 cells 64 64
run 0'
# -check knows that a constant pressure cannot be carried.
cat >in.hard <<'END'
units si
region b block 0 .04 0 .04 -0.005 .04 units box
create_box 1 b
fix S all surface/voxel constant 0 type 1 cells 10 10 base -0.004
compute c all surface/contact S winkler 1e9 pressure 1e3 hardness 1e2
thermo_style custom step c_c
run 1
END
refused 'pressure above the hardness' 'cannot be carried' -in in.hard
refused 'pressure above the hardness, -check' 'cannot be carried' -check -in in.hard
finish
