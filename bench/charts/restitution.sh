# Integrators on the impact of two spheres
title='Coefficient of restitution: spheres that hit held ones'
error='relative error of e, largest over all phases of entry'
reference='exact: such a sphere leaves with e times its speed (linear: damped oscillator; Hertz: Antypov and Elliott, EPL 94 (2011) 50004)'
setting='steps per contact'
also='steps per contact'
kind=Grains
budget=60
pick='With damping contacts located within the step (`pair_style ... located yes`): 10 to 25 steps per contact give the linear
law to 1e-5 or better and the Hertzian one to 1 %, for which plain velocity Verlet needs 100 to 800 steps. Without damping, or where
the numbers of LIGGGHTS are wanted, plain `fix nve`: 50 steps for some per cent, 200 for 1 %. `nve/symplectic` is as good;
`nve/euler` needs several times the work for the same error.'

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
