# Contact laws in a silo that runs out
title='Contact laws: a silo with a slot runs out, and heaps stay behind'
kind=Grains
error='relative difference from the fullest model'
reference='Hertzian contacts with tangential history and a Young modulus of 1e7 Pa, means
over four fillings with 1000 grains'
setting='Young modulus (Pa); the step is a fifth of the time of Rayleigh and follows it'
spread='standard error of the difference'
budget=100
pick='history, with Hertz or linear springs, and 1e6 Pa: rate and heaps agree with the stiffer grains to some per cent, about the
scatter between fillings, for a third of the work. Leaving history out saves a fourth of the time at most
and is off by a tenth, in the flow and in the heaps.'

points() {
	local seeds='86028121 15485863 32452843 49979687' model tangential young name
	problem 'rate of discharge'
	ensemble "$seeds" -var young $([ -z "${LONG-}" ] && echo 1e7 || echo 3e7)
	keep_finest
	for model in hertz hooke; do
		for tangential in history no_history; do
			name="$([ $model = hertz ] && echo Hertz || echo linear) ${tangential/_/ }"
			for young in $(levels 1e6 3e6 -- 1e7); do
				ensemble "$seeds" -var model $model -var tangential $tangential -var young $young
				problem 'rate of discharge'
				record "$name" $young $(deviation rate)
				problem 'grains that stay: heaps at their angle of repose'
				record "$name" $young $(deviation left)
			done
		done
	done
}
