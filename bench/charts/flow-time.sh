# Schemes in time on decaying vortices, examples/flow/taylor_green
title='Taylor-Green vortices on 128^2 cells: time schemes'
error='largest error at the end / amplitude'
reference='the same cells with rk3 and a step small enough that its error is negligible'
setting='number of steps'
also='number of steps'
kind=Fluid
budget=40
pick='`time rk3` if the step can be near its limit: it allows the largest steps, and the error of the step is already negligible
at the limit. If viscosity limits the step far below what the flow requires, `time ab2 viscous implicit` (Crank-Nicolson) for errors down
to 1e-6; `viscous backward` and `euler` only for steady flows.'

place=$top/examples/flow/taylor_green
deck=$place/in.taylor_green

# the largest difference of the six velocities at three points
difference() {
	awk '$1 != "POINTS" { next }
	     NR == FNR { for (k = 2; k <= NF; k++) exact[k] = $k; next }
	     { for (k = 2; k <= NF; k++) { d = $k - exact[k]; e = d > e ? d : -d > e ? -d : e } }
	     END { print e }' "$work/exact" "$work/output"
}

# exact WORDS: the run that those which follow are held against
exact() {
	simulate "$@"
	cp "$work/output" "$work/exact"
}

# steps METHOD WORDS: one line of steps
steps() {
	local method=$1 n
	shift
	for n in $steps; do
		point "$method" $n -var steps $n "$@"
	done
}

points() {
	local scheme steps
	problem 'convection limits the step'
	set -- -var N 128 -var nu 0.01
	exact "$@" -var time rk3 -var steps 1600
	idle "$@" -var T 1e-6 -var steps 1
	steps=$(levels 25 35 50 70 100 200 400 -- 800)
	for scheme in euler ab2 rk2 rk3; do
		steps $scheme "$@" -var time $scheme
	done
	problem 'viscosity limits the step'
	set -- -var N 128 -var nu 0.5
	exact "$@" -var time rk3 -var steps 3600
	idle "$@" -var T 1e-6 -var steps 1
	steps=$(levels 100 200 400 700 900 1800)
	for scheme in euler ab2 rk2 rk3; do
		steps $scheme "$@" -var time $scheme
	done
	steps 'ab2 + Crank-Nicolson' "$@" -var time ab2 -var viscous implicit
	steps 'ab2 + backward Euler' "$@" -var time ab2 -var viscous backward
}
