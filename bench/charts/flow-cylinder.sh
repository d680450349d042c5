# Cells across an immersed body: a cylinder in free flow, examples/flow/cylinder
title='Cylinder in free flow, an immersed body'
error='relative error'
reference='the same with 48 cells to the diameter, of the Strouhal number with 40 and averages over 40 D/U'
setting='cells to the diameter'
also='cells to the diameter'
kind=Fluid
budget=95
pick='12 cells to the diameter for some per cent of the Strouhal number and the bubble and less than one of the drag, 16 for one, 24
for half a per cent; the cost grows with the third power, and more where viscosity limits the step. `convection quick` from 12 cells
on; the fewest cells shed better with `central`.'

place=$top/examples/flow/cylinder
deck=$place/in.cylinder

# lines METHOD WORDS: both quantities are from the same runs
steady() {
	local method=$1 cells
	shift
	for cells in $(levels 6 8 12 16 24 -- 32); do
		simulate -var Re 40 -var cells $cells -var begin 60 "$@"
		problem 'Re 40: drag'
		record "$method" $cells "$(off Cd 1.52384)"
		problem 'Re 40: length of the bubble'
		record "$method" $cells "$(off L 2.2625)"
	done
}

vortices() {
	local method=$1 cells
	shift
	for cells in $(levels 6 8 12 16 24 -- 32); do
		simulate -var Re 100 -var cells $cells -var begin 70 -var length 30 "$@"
		problem 'Re 100: Strouhal number'
		record "$method" $cells "$(off St 0.1653)"
	done
}

# off NAME REFERENCE: relative error of a RESULT
off() {
	awk -v name="[.]$1\$" -v r="$2" '/^RESULT/ && $2 ~ name { print ($3 > r ? $3 / r - 1 : 1 - $3 / r) }' "$work/output"
}

points() {
	local convection
	for convection in central quick; do
		steady $convection -var convection $convection
	done
	for convection in central quick; do
		vortices $convection -var convection $convection
	done
}
