# Schemes of heat conduction and time steps
title='Heat conduction in 5 x 5 x 5 touching spheres with a hot centre'
kind=Grains
error='largest temperature error / initial difference'
reference='exact: matrix exponential, from the eigenvectors of a chain of 5 along each axis'
setting='number of steps in a time of 2.385 m c/h, where h is the conductance of a contact'
also='steps'
budget=20
pick='`scheme exact` for large steps: its error is round-off for any step, at the cost of about a hundred explicit steps.
`scheme euler` (that of LIGGGHTS) if collisions require a small step anyway. It is of first order, and even near its stability limit
(16 steps here) its error is below a thousandth of the initial difference.'

# T = 273.15 + 500 product over the axes of sum over k of v_k(2) v_k(i) exp(-l_k t/tau), with v_k(i) = cos(pi k (i + 1/2)/5)
# (normalised) and l_k = 2 - 2 cos(pi k/5): the matrix is the sum of those of chains along the axes.
difference() {
	awk 'BEGIN {
		s = 0.9e-3; t = 2.385; n = 5; pi = atan2(0, -1)
		for (i = 0; i < n; i++)
			for (k = 0; k < n; k++)
				u[i] += (k ? 2 : 1) / n * v(k, 2) * v(k, i) * exp(-(2 - 2 * cos(pi * k / n)) * t)
	}
	function v(k, i) { return cos(pi * k * (i + 0.5) / n) }
	function site(x) { return int(x / s + 0.5) % 6 }
	NR > 9 { d = ($4 - 273.15) / 500 - u[site($1)] * u[site($2)] * u[site($3)]; if (d < 0) d = -d; if (d > most) most = d }
	END { print most }' "$work/end"
}

points() {
	local steps
	idle -var runs 0
	for steps in $(levels 16 32 64 128 256 512 1024 -- 2048 4096 8192); do
		point 'explicit Euler' $steps -var scheme euler -var steps $steps
	done
	for steps in $(levels 1 4 16 64 -- 256); do
		point 'exact' $steps -var scheme exact -var steps $steps
	done
}
