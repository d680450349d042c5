# Integrators and time steps in rotary drilling
title='Rotary drilling: rate of penetration'
kind=Grains
error='relative error of the rate of penetration'
reference='velocity Verlet with a quarter of the finest step and the same eight random rock samples (700 grains, 29 revolutions in all)'
setting='time step x velocity of the fluid / grain diameter; in.drilling has 0.01, the stability limit is 0.1'
spread='standard error of the difference over the samples'
budget=75
pick='0.04, four times the step of the example, and several rock samples. The rate of penetration differs more between samples
than between these steps, so another sample reduces the error more than a smaller step. A step near the stability limit breaks bonds
that should not break (0.08: more than three times the rate). Explicit Euler does so at any affordable step.'

points() {
	local seeds='1 2 3 4 5 6 7 8' seed scheme step words='-var T 150 -var WOB 0.283 -var vtk no'
	cp "$top"/examples/drilling/in.* "$here/drilling.in" "$work"
	deck=$work/in.drilling
	for seed in $seeds; do
		simulate -var depth 700 -var T 0 -var seed $seed -var out rocks
	done
	deck=$work/drilling.in
	ensemble "$seeds" $words -var dt $([ -z "${LONG-}" ] && echo 0.005 || echo 0.0025)
	keep_finest
	for scheme in nve nve/symplectic nve/euler; do
		for step in $(levels 0.08 0.06 0.04 0.02 -- 0.01 0.005); do
			if ensemble "$seeds" $words -var scheme $scheme -var dt $step; then
				record $scheme $step $(deviation ROP)
			else
				seconds=nan
				record $scheme $step nan
			fi
		done
	done
}
