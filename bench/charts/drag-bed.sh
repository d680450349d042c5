# Void fraction: its methods and the size of cells, in a packed bed that is held
title='Packed bed of spheres: methods of the void fraction and cell size'
error='relative error of the pressure gradient in the bed'
reference='Ergun equation for the mean void fraction of the measured part, 0.395'
setting='cell width / particle diameter'
also='cell width / particle diameter'
kind=Fluid
budget=10
pick='`method divided` with cells two diameters wide, and with `interpolation cell` if they are wider. Smaller cells resolve the
pores between single spheres, for which drag laws are not valid; wider cells smear the ends of the bed. If cells must be smaller, use
`kernel`. Use `centre` only for cells of many diameters. For a bed that is uniform across use one cell across.'

# widths METHOD WORDS: a line. Cells are cubes, or as wide as the bed where $across is 1.
widths() {
	local method=$1 n
	shift
	for n in $(levels 2 3 4 5 6 8 -- 12); do
		point "$method" "$(awk -v n=$n 'BEGIN { printf "%.3g", 8 / n }')" "$@" -var method "${method%%;*}" \
			-var cells "${across:-$n} ${across:-$n} $((5 * n))"
	done
}

points() {
	local void method across
	simulate -var make "$work/bed.restart"
	simulate -var bed "$work/bed.restart"
	void=$(sed -n 's/^VOID //p' "$work/output")
	set -- -var bed "$work/bed.restart" -var void "$void"
	problem 'cubic cells'
	idle "$@" -var method divided -var steps 0
	for method in centre divided kernel; do
		widths $method "$@"
	done
	widths 'divided; interpolation cell' "$@" -var interpolation cell
	problem 'one column of cells'
	idle "$@" -var method divided -var steps 0
	across=1
	for method in centre divided kernel; do
		widths $method "$@"
	done
	widths 'divided; interpolation cell' "$@" -var interpolation cell
}
