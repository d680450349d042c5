# Models of a thin gap: closed form, film, full equations (examples/polishing/in.gap)
title='A gap that converges: three models of its pressure'
error='larger relative error of load and largest pressure'
reference='the full equations with 12 and 24 cells across the outlet, extrapolated by the second order (to 0.1 %)'
setting='film: cells along the gap; full equations: cells across the outlet'
kind=Fluid
budget=60
place=$top/examples/polishing
deck=$place/in.gap
pick='the closed form of a plane slider, or the film with 12 cells along the gap, where the error of their theory is small enough:
14 % at a length of 5 gaps, 4.6 % at 10, 1.4 % at 20, in 4 ms. The full equations pay for less: at a length of 5 gaps 6 cells across
the outlet have 1 % in 0.1 s; at 20 gaps it takes 12 cells and 1.6 s to be better than the film. More than 12 cells of the film only
approach its theory.'

# values: load and largest pressure of the last run
values() {
	awk '$1 == "RESULT" && $2 ~ /load|pressure/ { print $3 }' "$work/output"
}

# off FILE: the larger error of the load and pressure in it
off() {
	paste "$1" "$work/exact" | awk '{ d = $1 / $2 - 1; d = d < 0 ? -d : d; e = d > e ? d : e } END { printf "%.6g\n", e }'
}

points() {
	local aspect N M
	for aspect in $(levels 5 10 20 -- 40); do
		problem "length / gap $aspect"
		for N in 6 8 12 16 24; do
			simulate -var model cfd -var aspect $aspect -var N $N -var within 1 || exit 1
			values >"$work/cfd.$N"
			echo "$seconds" >"$work/price.$N"
		done
		paste "$work/cfd.12" "$work/cfd.24" | awk '{ print $2 + ($2 - $1) / 3 }' >"$work/exact"
		simulate -var model analytic -var aspect $aspect || exit 1
		values >"$work/rung"
		record 'closed form' 0 "$(off "$work/rung")"
		for M in 6 12 25 200; do
			simulate -var model film -var aspect $aspect -var M $M -var within 1 || exit 1
			values >"$work/rung"
			record film $M "$(off "$work/rung")"
		done
		for N in 6 8 12 16 24; do
			seconds=$(cat "$work/price.$N")
			record 'full equations' $N "$(off "$work/cfd.$N")"
		done
	done
}
