# Void fraction: its methods and the size of cells, in a packed bed that is held
title='Packed bed of spheres: methods of the void fraction and the size of cells'
error='relative error of the pressure gradient inside'
reference="Ergun's equation for the mean void fraction of the part that is measured, 0.395"
setting='width of cells in diameters'
also='width of cells in diameters'
kind=Fluid
budget=10
pick='`method divided` with cells two diameters wide, with `interpolation cell` if they are wider: smaller ones resolve the pores between single spheres, for which the laws
of drag are not made, wider ones smear the ends of the bed. Where cells must be smaller, `kernel`; `centre` only for
cells of many diameters. A bed that is even across wants one cell across.'

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
	problem 'cubes'
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
