# Cells across an immersed body: a cylinder in free flow, examples/flow/cylinder
title='Cylinder in a free stream, an immersed body'
error='relative error'
reference='48 cells per diameter; for the Strouhal number 40 cells and averages over 40 D/U'
setting='cells per diameter'
also='cells per diameter'
kind=Fluid
budget=75
pick='12 cells per diameter for errors of a few per cent in the Strouhal number and the bubble length and less than 1 % in the
drag, 16 for 1 %, 24 for 0.5 %. The cost grows with the third power, and faster where viscosity limits the step. Use `convection quick`
for 12 cells or more; with fewer cells `central` gives a better Strouhal number.'

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
		problem 'Re 40: bubble length'
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
