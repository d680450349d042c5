# Schemes in space on decaying vortices, examples/flow/taylor_green
title='Taylor-Green vortices in a uniform stream: convection schemes'
error='largest error at the end / amplitude'
reference='exact; time rk3 with steps whose error is negligible'
setting='cells per side'
also='cells per side'
kind=Fluid
budget=15
pick='`convection quick`, the default: half as many cells per side as `central` for the same error. Donor cells are of first order.'

place=$top/examples/flow/taylor_green
deck=$place/in.taylor_green

difference() {
	awk '/^RESULT.*velocity/ { print $3 }' "$work/output"
}

points() {
	local scheme form N
	idle -var N 16 -var T 1e-6 -var steps 1
	for scheme in "donor fv" "central fv" "central fd" "cubista fv" "quick fv"; do
		read -r scheme form <<<"$scheme"
		for N in $(levels 16 32 64 128 -- 256); do
			point "$scheme $form" $N -var N $N -var steps $((N * 2)) -var convection $scheme -var form $form
		done
	done
}
