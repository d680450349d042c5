# Schemes and grids on the lid-driven cavity, examples/flow/cavity
title='Lid-driven cavity, Re = 1000, steady state'
error='largest error on the two centre lines / lid speed'
reference='the converged profiles of tests/data/cavity_profiles_129.csv, error 1e-5'
setting='cells per side'
also='cells per side'
kind=Fluid
budget=90
pick='`convection quick`, the default, on cells graded towards the walls (`flow_grid ... tanh 1.2`): two thirds of the error of
uniform cells at the same cost, with a third of the cells. The second choice is `central`; use `cubista` if values must not
overshoot. Donor cells and `form fd` have errors several times as large: use them only if no other scheme is stable.'

place=$top/examples/flow/cavity
deck=$place/in.cavity

# the larger one of the deviations on both lines
difference() {
	awk '/^RESULT/ { e = $3 > e ? $3 : e } END { print e }' "$work/output"
}

# cavity METHOD "CELLS ..." WORDS
cavity() {
	local method=$1 sizes=$2 N
	shift 2
	for N in $sizes; do
		point "$method" $N -var Re 1000 -var N $N -var time rk3 "$@"
	done
}

points() {
	local sizes fine form
	sizes=$(levels 16 32 64 -- 128)
	fine=$(levels 16 32 64 128 -- 192)
	problem 'uniform cells'
	for form in fd fv; do
		cavity "donor $form" "$sizes" -var convection donor -var form $form
		cavity "central $form" "$sizes" -var convection central -var form $form
	done
	cavity cubista "$sizes" -var convection cubista
	cavity quick "$fine" -var convection quick
	problem 'graded cells (tanh 1.2)'
	cavity 'donor fv' "$sizes" -var convection donor -var tanh 1.2
	cavity 'central fv' "$sizes" -var convection central -var tanh 1.2
	cavity cubista "$sizes" -var convection cubista -var tanh 1.2
	cavity quick "$fine" -var convection quick -var tanh 1.2
}
