# Solvers of the pressure and their tolerances
title='Pressure solvers'
error='rms error of velocities at four points / rms'
reference='direct solver, whose error is round-off; for the bed cg with a tolerance of 1e-13'
setting='tolerance'
kind=Fluid
budget=50
pick='`direct` if all faces have equal weights (no void fraction): it has the lowest cost, and its error is round-off. With a void
fraction `cg` with its default preconditioner, the direct solver (`multigrid` for very strong drag): a tolerance of 1e-4 is sufficient
for velocities to 1e-5, and each further digit costs a few per cent. `sor` is available for comparison.'

# tolerances METHOD SOLVER WORDS: a line over tolerances
tolerances() {
	local method=$1 solver=$2 t
	shift 2
	for t in $(levels 1e-3 1e-4 1e-6 1e-8 -- 1e-5 1e-7 1e-9 1e-10); do
		point "$method" $t "$@" -var solver "${solver%% *} tolerance $t ${solver#"${solver%% *}"}"
	done
}

iterative() {
	tolerances 'cg + direct' 'cg preconditioner direct' "$@"
	tolerances 'cg + multigrid' 'cg preconditioner multigrid' "$@"
	tolerances 'cg + diagonal' 'cg preconditioner diagonal' "$@"
	tolerances multigrid multigrid "$@"
	tolerances sor sor "$@"
}

points() {
	problem 'cavity of 64^2 cells; 200 steps'
	set -- -var case cavity -var N 64
	idle "$@" -var steps 0
	set -- "$@" -var steps 200
	finest "$@" -var solver direct
	point direct direct "$@" -var solver direct
	iterative "$@"
	problem 'cavity of 32^3 cells; 50 steps'
	set -- -var case cube -var N 32
	idle "$@" -var steps 0
	set -- "$@" -var steps 50
	finest "$@" -var solver direct
	point direct direct "$@" -var solver direct
	iterative "$@"
	problem 'bed of spheres in 24^3 cells; 20 steps'
	set -- -var case bed -var N 24
	idle "$@" -var steps 0
	set -- "$@" -var steps 20
	finest "$@" -var solver 'cg tolerance 1e-13'
	iterative "$@"
}
