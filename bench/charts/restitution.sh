# Integrators on the impact of two spheres
title='Coefficient of restitution: spheres that hit held ones'
error='relative error of e, largest over all phases of entry'
reference='exact: such a sphere leaves with e times its speed (linear: damped oscillator; Hertz: Antypov and Elliott, EPL 94 (2011) 50004)'
setting='steps per contact'
also='steps per contact'
kind=Grains
budget=60
pick='`fix nve` (velocity Verlet); 50 steps per contact where some per cent of e are good enough, 200 for 1 %.
`nve/symplectic` is as good; `nve/euler` needs several times the work for the same error and has no use but to reproduce.'

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
