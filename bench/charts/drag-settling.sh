# Drag: how it is stepped, and how fluid and particles exchange it
title='Drag on spheres: schemes and steps'
error='velocity or slip at the end, by what it ends or begins with'
reference='exact: exponentials'
setting='steps in the time that is simulated, one relaxation time'
also='steps in one relaxation time'
kind=Fluid
budget=20
pick='`scheme exact`: of second order where the fluid is given; ten steps to a relaxation time for 0.1 %. Particles and a fluid that
feels them exchange to first order with every scheme, `exact` with a quarter of the error where the fluid is the heavier one: 20
steps for 1 %. `lagged yes` is a quarter cheaper and as good, as long as its step is stable; take one step of the fluid in several (`every`) only where the fluid
changes that much more slowly than the particles.'

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
	problem 'sinking from rest in a fluid that stays at rest'
	idle -var T 1e-6 -var steps 1
	for scheme in explicit implicit exact; do
		line $scheme "scheme $scheme"
	done
	for M in 0.3 20; do
		problem "slowing down with the fluid; spheres of $M times its mass"
		set -- -var case share -var M $M -var side 16
		idle "$@" -var T 1e-6 -var steps 1
		for scheme in explicit implicit exact; do
			line $scheme "scheme $scheme" "$@"
		done
		line 'exact; lagged yes' 'scheme exact lagged yes' "$@"
		line 'exact; every 5' 'scheme exact' -var every 5 "$@"
	done
}
