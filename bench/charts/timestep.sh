# Time steps in a packing that falls together
title='Time step: collapse of 2940 grains with friction in a box'
kind=Grains
error='relative error'
reference='a quarter of the finest step (half of it for the centre of mass, in four packings), relative to the displacement of the grains'
setting='time step / Rayleigh time'
spread='standard error of the mean over four packings'
budget=40
deck=$here/collapse.in
pick='0.2 of the Rayleigh time. The error of trajectories is 0.1 % as long as each grain has had only a few collisions. Later the
trajectory of a single grain does not converge for any step, because the motion is chaotic; averages over many grains, such as the
fall of the centre of mass, have errors of about 1 % with 0.3 and less.'

difference() {
	awk 'FNR < 10 { file += FNR == 1; next }
	     file == 1 { x[$1] = $2; y[$1] = $3; z[$1] = $4; next }
	     file == 2 { rx[$1] = $2; ry[$1] = $3; rz[$1] = $4; next }
	     { d += ($2 - rx[$1])^2 + ($3 - ry[$1])^2 + ($4 - rz[$1])^2
	       r += (rx[$1] - x[$1])^2 + (ry[$1] - y[$1])^2 + (rz[$1] - z[$1])^2 }
	     END { print sqrt(d / r) }' "$work/finest/start" "$work/finest/end" "$work/end"
}

points() {
	local duration rayleigh seeds='86028121 15485863 32452843 49979687'
	for duration in 0.03 0.045; do
		problem "positions after $duration s"
		finest -var seconds $duration -var rayleigh 0.0125
		for rayleigh in $(levels 0.4 0.3 0.2 0.1 0.05); do
			point nve/sphere $rayleigh -var seconds $duration -var rayleigh $rayleigh
		done
	done
	problem 'displacement of the centre of mass in 0.12 s (mean of 4)'
	ensemble "$seeds" -var rayleigh $([ -z "${LONG-}" ] && echo 0.1 || echo 0.0125)
	keep_finest
	for rayleigh in $(levels 0.4 0.3 0.2 -- 0.1 0.05); do
		ensemble "$seeds" -var rayleigh $rayleigh
		record nve/sphere $rayleigh $(deviation fall)
	done
}
