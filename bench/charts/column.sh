# Integrators and time steps on a wave in a column of spheres
title='Waves in columns of 100 spheres'
kind=Grains
error='relative error'
reference='positions: velocity Verlet with sub-step contact detection and 8 times as many steps as the finest point, relative to the displacement of the spheres
(root mean square); energy: exact, it is conserved for e = 1'
setting='steps per contact of two spheres'
budget=60
pick='velocity Verlet with 25 to 50 steps per contact. Half the time step doubles the cost and divides the error by two to
four. `nve/symplectic` gives the same positions, but its velocities, and therefore the energy, lag behind by half a step. Sub-step
contact detection (`located`) has no advantage for lasting contacts, and costs up to twice as much (Hertz law: up to 1.4 times). Explicit Euler adds energy to an
undamped column until it becomes unstable (missing points).'

difference() {
	awk 'FNR < 10 { file += FNR == 1; next }
	     file == 1 { first[$1] = $2; next }
	     file == 2 { reference[$1] = $2; next }
	     { d += ($2 - reference[$1])^2; r += (reference[$1] - first[$1])^2 }
	     END { print sqrt(d / r) }' "$work/finest/start" "$work/finest/end" "$work/end"
}

points() {
	local law e method steps
	for law in linear Hertz; do
		for e in 1 0.6; do
			problem "$law law with e = $e: positions"
			finest -var law $law -var e $e -var located yes -var steps $([ -z "${LONG-}" ] && echo 1600 || echo 6400)
			for method in nve nve/symplectic nve/euler 'nve located'; do
				for steps in $(levels 12 25 50 100 200 -- 400 800); do
					column "$method" $steps -var law $law -var e $e -var steps $steps \
						-var scheme ${method% *} -var located $(located "$method")
				done
			done
		done
	done
}

# A column that has flown apart is a failed run.
column() { # METHOD SETTING WORDS
	local method=$1 steps=$2 positions
	shift 2
	problem "$law law with e = $e: positions"
	positions=nan seconds=nan
	simulate "$@" && positions=$(difference | awk '{ print ($1 > 1 ? "nan" : $1) }')
	record "$method" "$steps" $positions
	[ "$e" = 1 ] || return 0
	problem "$law law with e = 1: energy"
	record "$method" "$steps" $([ $positions = nan ] && echo nan || sed -n 's/^ENERGY -*//p' "$work/output")
}
