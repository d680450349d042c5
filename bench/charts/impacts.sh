# The two ways to compute impacts on a wall: resolved by time steps, or exact
title='Impacts of a jet on a target: volume removed'
error='relative error of the volume'
reference='groove: closed form; rebound: impact exact with steps of 3 ns (its own tolerance is 1e-10)'
setting='time step (ns)'
kind=Grains
budget=20
pick='`impact exact` of `fix wall/gran`: the volume does not depend on the time step, which follows the flight. Contacts last some
20 ns: resolved, they need steps of 0.4 ns for an error of 2e-5 in the groove, which depends on the contact itself, and of 1e-3 after a
rebound with friction, to which smaller steps converge with order one. The flight is 0.2 mm here; over the 10 mm of a real jet resolved
steps take some 16 times as long, exact ones about the same time.'

points() {
	local problem_of words h exact
	while IFS=: read -r problem_of words; do
		problem "$problem_of"
		idle $words -var runs 0
		if [ "${words#*corner}" = "$words" ]; then
			exact='-var impact exact -var wear zhao/chang'
		else
			exact='-var impact exact'
		fi
		finest $words $exact -var h 3e-9
		for h in $(levels 1.6 0.8 0.4 0.2 0.1 0.05 -- 0.025 0.0125); do
			point resolved $h $words -var h ${h}e-9
		done
		for h in 1000 300 100 30; do
			point exact $h $words $exact -var h ${h}e-9
		done
	done <<-END
		groove that the contact ploughs; elastic:-var scene groove
		second impact after a rebound with friction:-var scene corner -var e 0.6 -var mu 0.3 -var at side -var T 1.4e-5 -var wear oka
	END
}
