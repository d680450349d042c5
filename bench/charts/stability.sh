# Limits of stability, a figure without costs: from the table that tests/stability/check_limits writes
title='Largest stable time step, measured by bisection'
budget=5

figure() {
	awk '$1 == "bond" || $1 == "contact" { print $1, $2, $3, $4 }' "$top/doc/stability.txt" >"$work/stability.dat"
	gnuplot -e "format='$1'; data='$work/stability.dat'; file='$2'" "$here/stability.gp"
}
