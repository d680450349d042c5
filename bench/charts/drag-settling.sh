# Drag: how it is stepped, and how fluid and particles exchange it
title='Drag on spheres: schemes and time steps'
error='error of velocity or slip / its final or initial value'
reference='exact exponential solutions'
setting='steps per simulated time of one relaxation time'
also='steps per relaxation time'
kind=Fluid
budget=20
pick='`scheme exact`. It is of second order if the velocity of the fluid is given: ten steps per relaxation time for 0.1 %. The
exchange between particles and a computed fluid is of first order with every scheme; if the fluid is heavier the error of `exact` is a
quarter of that of the others: 20 steps for 1 %. `lagged yes` costs a quarter less and is equally accurate, as long as its step is
stable. Use one step of the fluid in several (`every`) only if the fluid changes correspondingly more slowly than the particles.'

# line METHOD DRAG WORDS
line() {
	local method=$1 drag=$2 n
	shift 2
	for n in $(levels 5 10 20 40 80 -- 160 320); do
		point "$method" $n -var steps $n -var drag "$drag" "$@"
	done
}

points() {
	local M scheme
	problem 'settling in a fluid at rest'
	idle -var T 1e-6 -var steps 1
	for scheme in explicit implicit exact; do
		line $scheme "scheme $scheme"
	done
	for M in 0.3 20; do
		problem "relaxation with the fluid; mass ratio $M"
		set -- -var case share -var M $M -var side 16
		idle "$@" -var T 1e-6 -var steps 1
		for scheme in explicit implicit exact; do
			line $scheme "scheme $scheme" "$@"
		done
		line 'exact; lagged yes' 'scheme exact lagged yes' "$@"
		line 'exact; every 5' 'scheme exact' -var every 5 "$@"
	done
}
