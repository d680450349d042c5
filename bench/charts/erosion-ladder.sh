# Models of a jet of dust on a target: formulas, grains, grains in air (examples/erosion/in.ladder)
title='Erosion by a jet of dust: four models of it'
error='relative error of the volume removed per mass of dust'
reference='the coupled model with 6 cells per diameter of the nozzle and 50 micrograms'
setting='grains: mass of dust in micrograms, 23 grains each; coupled: cells per diameter of the nozzle'
spread='standard deviation by the choice of grains; points without one have those of the reference'
kind=Grains
budget=75
place=$top/examples/erosion
deck=in.ladder
pick='the formulas, if 5 % are enough: that is what the air takes off the volume here. Grains in the given stagnation flow are within 1 %
of the coupled model, in a fiftieth of its time. The computed air is for flows that no formula gives; what the grains do to
it changes the volume by 3e-5, so `two_way no` is enough at this rate. With few grains the error is their scatter.'

points() {
	local mass cells all=50 words="-var out $work/post"
	simulate $words -var dust ${all}e-9 -var fine 6 -var model coupled -var every $([ -z "${LONG-}" ] && echo 2 || echo 1) || exit 1
	keep_finest
	simulate $words -var model closed
	scatter=$(sed -n 's|^by chance .* \([0-9.]*\) %/sqrt(N).*|\1|p' "$work/output")
	record 'closed form' 0 $(difference) $(by_chance 1e9)
	idle $words -var model closed
	for mass in 5 20 $all; do
		rung 'jet; no air' jet $mass
	done
	for mass in 5 20 $all; do
		rung 'air given' air $mass
	done
	for cells in $(levels 3 4 -- 5); do
		point 'air coupled' $cells $words -var model coupled -var dust ${all}e-9 -var fine $cells -var every 2
	done
}

rung() { # METHOD MODEL MICROGRAMS
	simulate $words -var model $2 -var dust $3e-9 || exit 1
	record "$1" $3 $(difference) $(by_chance $3)
}

# by_chance MICROGRAMS: the standard deviation between so many grains and those of the reference
by_chance() {
	awk -v s="$scatter" -v a="$1" -v b="$all" 'BEGIN { v = 1 / a - 1 / b; print s / 100 * sqrt((v < 0 ? -v : v) / 23.3) }'
}

# of the volume of the last model
difference() {
	awk '/^(closed|jet|air|coupled) [0-9]/ { e[FILENAME] = $2 }
	     END { d = e[ARGV[2]] / e[ARGV[1]] - 1; printf "%.6g\n", d < 0 ? -d : d }' "$work/finest/output" "$work/output"
}
