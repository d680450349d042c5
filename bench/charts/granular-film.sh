# Models of a film of grains between two plates: automaton, theory, grains (examples/film/in.film)
title='A film of grains between sliding plates: three models of it'
error='velocity profile: root mean square of u - u(reference), by the speed of the plate'
reference='grains, 10 x 10 diameters, averaged over 40 shear times: the numbers are in bench/charts/granular-film.profile'
setting='automaton: steps of all runs; theory: points of the profile; grains: length and depth in diameters - shear times averaged'
spread='root mean square of the standard errors of the profile and the reference: smaller errors say nothing'
kind=Grains
budget=30
place=$top/examples/film
deck=in.film
pick='the theory: it takes less time than the automaton with its default number of runs, and its error is a quarter of the
automaton'\''s, which more steps do not make smaller, as it is that of the rules. The error of the theory here, at 0.85 of closest packing,
is that of its slip, which in films less dense agrees better (doc/granular-film.md). For velocities within 1 %, for
slip in dense films, grains; those of a film of only 4 diameters of length and depth differ from more of them.'

points() {
	local runs steps seeds theory size times
	for runs in $(levels 2/200 8/200 8/2000 -- 8/10000); do
		IFS=/ read -r seeds steps <<<"$runs"
		rung automaton $((seeds * steps)) automaton -var seeds "$seeds" -var steps "$steps"
	done
	for theory in lun garzo/dufty; do
		rung "theory of $theory" 41 kinetic -var theory $theory
	done
	for size in $(levels 4/4 6/4 8/4 10/4 -- 10/20); do
		IFS=/ read -r size times <<<"$size"
		rung grains "$size - $times" dem -var L "$size" -var depth "$size" -var relax "$times" -var average "$times"
	done
}

rung() { # METHOD SETTING MODEL WORDS
	if simulate -var out "$work/post" -var model "${@:3}"; then
		record "$1" "$2" $(profile_error "$work/post/profile_$3.txt")
	else
		seconds=nan
		record "$1" "$2" nan
	fi
}

# profile_error FILE: the error and its spread at the rows of the reference; between rows profiles are lines
profile_error() {
	awk '/^#/ { next }
	     NR == FNR { y[++n] = $1; u[n] = $2; e[n] = $5; next }
	     { Y[++m] = $1; V[m] = $2; E[m] = $5 }
	     END { for (k = 1; k <= m; k++) {
			for (j = 1; j < n - 1 && y[j + 1] < Y[k]; j++)
				;
			f = (Y[k] - y[j]) / (y[j + 1] - y[j])
			d += (u[j] + f * (u[j + 1] - u[j]) - V[k])^2
			s += ((1 - f) * e[j])^2 + (f * e[j + 1])^2 + E[k]^2
		   }
		   print sqrt(d / m), sqrt(s / m) }' "$1" "$folder/granular-film.profile"
}
