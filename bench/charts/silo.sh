# Contact laws in a silo that runs out
title='Contact laws: discharge of a silo through a slot'
kind=Grains
error='relative difference from the reference'
reference='Hertz with tangential history and a Young modulus of 1e7 Pa, mean of
four fillings with 1000 grains'
setting='Young modulus in Pa; the time step is a fifth of the Rayleigh time'
spread='standard error of the difference'
budget=75
pick='tangential history, with Hertz or linear springs, and 1e6 Pa: discharge rate and heaps agree with those of stiffer grains to
a few per cent, about the standard deviation between fillings, for a third of the work. Without history a run needs up to a fourth
less time, and the rate and the heaps are wrong by a tenth.'

points() {
	local seeds='86028121 15485863 32452843 49979687' model tangential young name
	problem 'discharge rate'
	ensemble "$seeds" -var young $([ -z "${LONG-}" ] && echo 1e7 || echo 3e7)
	keep_finest
	for model in hertz hooke; do
		for tangential in history no_history; do
			name="$([ $model = hertz ] && echo Hertz || echo linear) ${tangential/_/ }"
			for young in $(levels 1e6 3e6 -- 1e7); do
				ensemble "$seeds" -var model $model -var tangential $tangential -var young $young
				problem 'discharge rate'
				record "$name" $young $(deviation rate)
				problem 'grains left in heaps'
				record "$name" $young $(deviation left)
			done
		done
	done
}
