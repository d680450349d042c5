# Integrators on the impact of two spheres
title='Coefficient of restitution: collision with a fixed sphere'
error='relative error of e, maximum over all phases of begin'
reference='exact: e times the velocity before the collision (linear: damped oscillator; Hertz: Antypov and Elliott, EPL 94 (2011) 50004)'
setting='steps per contact'
also='steps per contact'
kind=Grains
budget=60
pick='with damping, sub-step contact detection (`pair_style ... located yes`): with 10 to 25 steps per contact the error is 1e-5
or less for the linear law and 1 % for Hertz, for which plain velocity Verlet needs 100 to 800 steps. Without damping, or to reproduce
LIGGGHTS, plain `fix nve`: 50 steps for a few per cent, 200 for 1 %. `nve/symplectic` is equivalent; `nve/euler` needs several times
the work for the same error.'

points() {
	local law e method steps
	for law in linear Hertz; do
		for e in 1 0.6 0.2; do
			problem "$law law with e = $e"
			idle -var law $law -var e $e -var runs 0
			for method in nve nve/symplectic nve/euler 'nve located'; do
				for steps in $(levels 10 16 25 50 100 200 400 800 -- 1600 3200 6400 12800); do
					point "$method" $steps -var law $law -var e $e -var steps $steps \
						-var scheme ${method% *} -var located $(located "$method")
				done
			done
		done
	done
}
